"""4/25: the drum of a spacecraft simulator, in three turning frames."""

from exercises.devices.disk_in_two_brackets import prove_turning
from exercises.tools import Sketch, in_frame, terms
from newton_euler import Frame


def drums(g):
    """Ground with z up; A turns about z, B in A about x, C in B about y."""
    ground = Frame("ground")
    A = ground.rotate("A", "z", rate=g.Omega)
    B = A.rotate("B", "x", rate=g.omega)
    return ground, A, B, B.rotate("C", "y", rate=g.P)


def solve(g):
    ground, _, _, C = drums(g)
    omega, alpha = C.angular_velocity(ground), C.angular_acceleration(ground)
    return in_frame(ground, {"omega_C": omega, "alpha_C": alpha})


def steps(g):
    omega, alpha = solve(g).values()
    yield from terms(omega, "omega_C", "rad/s", "4.9")
    yield from terms(alpha, "alpha_C", "rad/s^2", "4.9", "4.26")


def prove(g):
    omega, alpha = prove_turning(g.Omega, g.omega, g.P)
    return {"omega_C": omega, "alpha_C": alpha}


def mistakes(g):
    alpha = solve(g)["alpha_C"]
    return {
        "zero": {"alpha_C": 0 * alpha},
        "no_Omega_x_omega": {"alpha_C": alpha.without("A x B")},
        "no_omega_x_P": {"alpha_C": alpha.without("B x C")},
        "reversed": {"alpha_C": -alpha},
    }


def draw(g, ax):
    """B is drawn as a ring between the uprights of A, carrying the axle of C."""
    ground, A, B, C = drums(g)
    s = Sketch(ax, ground, azimuth=32, elevation=22)
    s.ground((0, 0, -2.3), normal=ground.k)
    s.shaft((0, 0, -2.3), (0, 0, -1.1))
    s.disk((0, 0, -1.1), A.k, 1.1)
    for side in (-1, 1):
        s.rod(A.point("", 1.1 * side, 0, -1.1), A.point("", 1.1 * side, 0, 0))
        s.rod(A.point("", 1.3 * side, 0, 0), B.point("", 0.9 * side, 0, 0))
        s.rod(B.point("", 0, 1.1 * side, 0), C.point("", 0, 0.5 * side, 0))
    s.wire(s.around((0, 0, 0), B.point("", 0.9, 0, 0), B.k))
    s.cylinder(C.point("", 0, -0.5, 0), C.point("", 0, 0.5, 0), 0.3)
    s.axes((0, -2.1, -1.8), ground, length=0.6)
    s.turn((0, 0, -1.9), A.k, label=r"$\Omega$")
    s.turn(A.point("", 1.5, 0, 0), B.i, label=r"$\omega$")
    s.turn(B.point("", 0, 1.3, 0), C.j, label="P")
    s.label(A.point("", 1.1, 0, -0.5), "A", offset=(-12, 0))
    s.label(B.point("", -0.636, 0.636, 0), "B")
    s.label(C.point("", 0, -0.5, 0.3), "C")
