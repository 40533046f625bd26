"""The joint of 4/21 and 4/29: a shaft spinning in a block that tilts in a turning fork."""

from exercises.annotations import AnyAxes, Givens, Orientation
from exercises.tools import Sketch, Step, in_frame, mp, rot, spun, times
from newton_euler import Frame, Vector


def fork_and_shaft(g: Givens) -> tuple[Frame, Frame, Frame]:
    """Ground, z up; the fork, about z; the block, about its -x; the shaft, about e."""
    ground = Frame("ground")
    fork = ground.rotate("fork", "z", rate=g.Omega)
    block = fork.rotate("block", "-x", angle=g.gamma_1, rate=-g.gamma_rate)
    return ground, fork, block.rotate("shaft", "z", rate=g.omega)


def angular_velocity(g: Givens) -> Vector:
    """The shaft's angular velocity in the ground, along the axes of the fork."""
    ground, fork, shaft = fork_and_shaft(g)
    return in_frame(fork, shaft.angular_velocity(ground))


def angular_acceleration(g: Givens) -> Vector:
    """The shaft's angular acceleration in the ground, along the axes of the fork."""
    ground, fork, shaft = fork_and_shaft(g)
    return in_frame(fork, shaft.angular_acceleration(ground))


def direction(g: Givens) -> Step:
    """The direction of the shaft along the axes of the fork, as a step."""
    _, fork, shaft = fork_and_shaft(g)
    means = "direction of the shaft, $\\sin\\gamma$ along y and $\\cos\\gamma$ along z"
    return Step("e", shaft.k.expressed_in(fork), "1", means)


def orientation(g: Givens) -> Orientation:
    """Proof, over time: rotation about e, starting at the pin, then rotation with the fork."""

    def shaft(t):
        gamma, pin = g.gamma_1 - g.gamma_rate * t, [1, 0, 0]
        e = [0, mp.sin(gamma), mp.cos(gamma)]
        return times(rot("z", g.Omega * t), spun(e, pin, g.omega * t))

    return shaft


def draw(g: Givens, ax: AnyAxes) -> None:
    ground, fork, shaft = fork_and_shaft(g)
    centre, up = fork.point("centre", 0, 0, 0), fork.point("up", 0, 0, 1)
    foot, middle = fork.point("foot", 0, 0, -1.3), fork.point("middle", 0, 0, -0.7)
    start, A = shaft.point("start", 0, 0, 0.13), shaft.point("A", 0, 0, 1.3)
    s = Sketch(ax, ground, azimuth=28, elevation=18)
    s.ground(foot, normal=ground.k)
    s.shaft(foot, middle)
    for x in (-0.6, 0.6):
        top, corner = fork.point("top", x, 0, 0), fork.point("corner", x, 0, -0.7)
        s.rod(middle, corner, top)
        s.rod(fork.point("side", x / 0.6 * 0.13, 0, 0), top)
    s.box(centre, shaft, (0.26, 0.26, 0.26))
    s.shaft(start, A)
    s.axes(centre, fork, length=0.95)
    s.turn(foot, ground.k, label=r"$\Omega$")
    s.turn(fork.point("", 0.6, 0, 0), fork.i, label=r"$|\dot\gamma|$")  # towards z
    s.turn(shaft.point("", 0, 0, 1), shaft.k, label=r"$\omega$")
    s.vector(A, shaft.k, "e", kind="plain")
    s.arc(centre, up, A, label=r"$\gamma$")
    s.label(A, "A")
