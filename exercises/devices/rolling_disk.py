"""The disk of 4/22, 4/23, 4/30 rolls upright round a circle, its axle to the vertical y axis."""

from exercises.annotations import Answers, AnyAxes, Givens, Orientation, Path, Scalar, Steps
from exercises.tools import Sketch, Step, minus, mp, plus, proofs, rate, rot, scaled, times
from newton_euler import Frame, Point, pi, solve_rates


def turning(g: Givens) -> Scalar:
    """Rate of the axle about y."""
    return 2 * pi(g.T) / g.T


def axle_and_disk(g: Givens, spin: Scalar | None = None) -> tuple[Frame, Frame, Frame, Point]:
    """Ground; axes turning about y with the axle, z outward; the disk, rolling by default; A."""
    spin = rolling_spin(g) if spin is None else spin
    ground = Frame("ground")
    arm = ground.rotate("axle", "y", rate=turning(g))
    axle = arm.translate("axes at C", arm.point("C", 0, 0, g.R))
    disk = axle.rotate("disk", "z", rate=spin)
    return ground, axle, disk, disk.point("A", g.r, 0, 0)


def rolling_spin(g: Givens) -> Scalar:
    """The rate of the disk on its axle that keeps its point of contact at rest."""

    def slip(spin):
        ground, _, disk, _ = axle_and_disk(g, spin)
        # in the direction of motion of the centre
        return disk.point("contact", 0, -g.r, 0).velocity(ground).x

    return solve_rates(slip, 1)[0]


def rolling_steps(g: Givens) -> Steps:
    """The rotation of the axle and the condition of rolling."""
    ground, axle, disk, _ = axle_and_disk(g)
    omega = axle.angular_velocity(ground).expressed_in(axle)
    means = "angular velocity of the axle, once round in T"
    yield Step("omega_axle", omega, "rad/s", means, "4.4", "4.9")
    v = axle.origin.velocity(ground).expressed_in(axle)
    means = "velocity of the disk's centre C, which goes round the circle of radius R"
    yield Step("v_C", v, "m/s", means, "4.4", "4.11")
    spin = disk.angular_velocity(axle).expressed_in(axle)
    means = "rate of the disk on the axle: it rolls, so that r times this rate is the speed of C"
    yield Step("omega_spin", spin, "rad/s", means, "4.4", "4.11")


def proved_steps(g: Givens) -> Answers:
    """Proof: two of these steps, from the motion."""
    outward = lambda t: times(rot("y", 2 * mp.pi * t / g.T), [0, 0, g.R])
    spin = minus(proofs.angular_velocity(orientation(g)), [0, 2 * mp.pi / g.T, 0])
    return {"v_C": rate(outward), "omega_spin": spin}


def orientation(g: Givens) -> Orientation:
    """Proof, over time: centre and rim both cover the arc R theta; A starts at the bottom."""
    theta = lambda t: 2 * mp.pi * t / g.T
    return lambda t: times(rot("y", theta(t)), rot([0, 0, -1], g.R * theta(t) / g.r))


def rim_point(g: Givens) -> Path:
    """Proof: position of A over time, from the directions of travel and of the vertical."""

    def A(t):
        theta = 2 * mp.pi * t / g.T
        unrolled = g.R * theta / g.r
        outward, forward = [mp.sin(theta), 0, mp.cos(theta)], [mp.cos(theta), 0, -mp.sin(theta)]
        ahead = scaled(g.r * mp.cos(unrolled), forward)
        return plus(scaled(g.R, outward), ahead, [0, -g.r * mp.sin(unrolled), 0])

    return A


def sketch(g: Givens, ax: AnyAxes, with_A: bool = True) -> None:
    ground, axle, _, A = axle_and_disk(g)
    C = axle.point("C", 0, 0, 0)
    origin = ground.point("origin", 0, 0, 0)
    foot = ground.point("foot", 0, -g.r, 0)
    top, contact = ground.point("top", 0, 1.2 * g.r, 0), axle.point("contact", 0, -g.r, 0)
    s = Sketch(ax, ground, azimuth=-125, elevation=20, up="y")
    s.ground(foot, normal=ground.j)
    s.ring(foot, ground.j, g.R)
    s.shaft(foot, origin)
    s.rod(origin, C)
    s.disk(C, axle.k, g.r, spoke=A if with_A else None)
    s.dot(C)
    s.axes(origin, axle, length=0.6 * g.R)
    s.turn(top, ground.j, label="once in $T$")
    s.dimension(foot, contact, label="R")
    s.dimension(contact, C, label="r", offset=0)
    if with_A:
        s.dot(A, "A")
