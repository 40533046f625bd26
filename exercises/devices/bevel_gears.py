"""Bevel gears of 4/32 and 4/33: B on a turning arm, in mesh with C below, fixed or turning.

The functions are those of both problems; C turns at n_C if it is given.
"""

from exercises.annotations import Answers, AnyAxes, Givens, Steps
from exercises.tools import Step, in_frame, minus, on_ground, proofs, rot, terms, times
from newton_euler import Frame, atan, cos, sin, solve_rates

# omega_B is constant along the axes of the arm, which turn about z
follows = {"alpha_B": lambda g, omega_B: (g.n * omega_B.frame.k).cross(omega_B)}


def gears(g: Givens) -> tuple[Frame, Frame, Frame]:
    """Ground, the arm turning about z with OA along its y, and gear B, which does not slip on C."""
    ground = Frame("ground")
    arm = ground.rotate("OA", "z", rate=g.n)
    C = ground.rotate("C", "z", rate=getattr(g, "n_C", 0))
    # along the common line of the pitch cones, any distance from O
    contact = (0, g.tan_gamma, -1)

    def slip(spin):
        tooth = arm.rotate("B", "y", rate=spin).point("tooth", *contact)
        gap = C.point("gap", *contact)
        return (tooth.velocity(ground) - gap.velocity(ground)).x  # normal to the plane of DE and OA

    (spin,) = solve_rates(slip, 1)
    return ground, arm, arm.rotate("B", "y", rate=spin)


def solve(g: Givens) -> Answers:
    """The answers, along the axes of the arm."""
    ground, arm, B = gears(g)
    omega, alpha = B.angular_velocity(ground), B.angular_acceleration(ground)
    return in_frame(arm, {"omega_B": omega, "alpha_B": alpha})


def steps(g: Givens) -> Steps:
    """The rotation of B on its arm without slip on C."""
    ground, arm, B = gears(g)
    rolling = r"(n_C - n) \tan\gamma" if hasattr(g, "n_C") else r"-n \tan\gamma"
    omega = arm.angular_velocity(ground)
    yield Step("omega_OA", omega, "rad/s", "angular velocity of DE and OA in the ground", "4.9")
    omega = B.angular_velocity(arm).expressed_in(arm)
    means = f"angular velocity of B relative to OA, ${rolling}$ about y, as it does not slide on C"
    yield Step("omega_rel", omega, "rad/s", means, "4.9")
    omega, alpha = solve(g).values()
    yield from terms(omega, "omega_B", "rad/s", "4.9")
    yield from terms(alpha, "alpha_B", "rad/s^2", "4.9")


def prove(g: Givens) -> Answers:
    """Equal arcs on the pitch circles of B and C, whose radii are as 1 to tan(gamma)."""

    def gear_B(t):
        overtaken = (g.n - getattr(g, "n_C", 0)) * t  # angle of the arm relative to C
        # rolling toward -x: the top of B leads
        return times(rot("z", g.n * t), rot("y", -overtaken * g.tan_gamma))

    omega = proofs.angular_velocity(gear_B)
    found = {"omega_rel": minus(omega, [0, 0, g.n])}
    return {"omega_B": omega, "alpha_B": proofs.angular_acceleration(gear_B)} | found


def draw(g: Givens, ax: AnyAxes) -> None:
    """The gears, with a line of contact of length 1, viewed almost normal to their plane."""
    gamma = atan(g.tan_gamma)
    ground, s = on_ground(ax, azimuth=20, elevation=15)
    places = ("O", 0, 0, 0), ("A", 0, sin(gamma) + 0.4, 0), ("D", 0, 0, -2), ("E", 0, 0, 0.8)
    O, A, D, E = (ground.point(*place) for place in places)
    B = ground.j * sin(gamma)
    C = ground.k * -cos(gamma)
    contact = ground.vector(0, sin(gamma), -cos(gamma))
    foot = C - ground.k * 0.65
    s.shaft(D, E)
    s.shaft(O, A)
    s.cylinder(foot, C, 0.12)
    s.gear(C, ground.k, sin(gamma), cone_apex=O)
    s.gear(B, ground.j, cos(gamma), cone_apex=O)
    s.line(O, contact, style="solid")
    s.axes(O, ground, length=0.35)
    s.turn(E, ground.k, label="n")
    if hasattr(g, "n_C"):
        s.turn(C - ground.k * 0.5, ground.k, label="$n_C$")
    else:
        s.ground(foot, normal=ground.k)
    s.arc(O, D, contact, label=r"$\gamma$")
    for P in (O, A, D, E):
        s.label(P, P.name)
    s.label(B, "B")
    s.label(C - ground.j * (0.7 * sin(gamma)), "C", offset=(0, 0))
