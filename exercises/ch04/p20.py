"""4/20: a rod sliding out of a cylinder that turns about two axes."""

from exercises.devices.moving_frame import seen_in, turning_of
from exercises.tools import Sketch, in_frame, proofs, rate, rot, second_rate, terms, times
from newton_euler import Frame, moving


def arm_bracket_tip(g):
    """Ground with y up; DEG, about x; the bracket about y with origin D; A on its z axis."""
    ground = Frame("ground")
    arm = ground.rotate("DEG", "x", rate=g.omega_1)
    bracket = arm.rotate("bracket", "y", rate=g.omega_2, origin=arm.point("D", 0, g.h, 0))
    return ground, arm, bracket, bracket.point("A", 0, 0, moving(g.s, rate=g.u))


def solve(g):
    ground, _, _, A = arm_bracket_tip(g)
    return in_frame(ground, {"v_A": A.velocity(ground), "a_A": A.acceleration(ground)})


def steps(g):
    ground, _, bracket, A = arm_bracket_tip(g)
    phrase = "the moving frame, fixed in the bracket,"
    yield from turning_of(bracket, ground, ground, "bracket", phrase)
    start = "D, the origin of the moving frame"
    yield from seen_in(bracket, A, ground, "mm", "the bracket", start)
    v, a = solve(g).values()
    yield from terms(v, "v_A", "mm/s", "4.8")
    yield from terms(a, "a_A", "mm/s^2", "4.8")


def prove(g):
    """The cylinder turns about ED from z to x, and ED about x from y to z."""
    DA = lambda t: times(rot("y", g.omega_2 * t), [0, 0, g.s + g.u * t])
    A = lambda t: times(rot("x", g.omega_1 * t), proofs.plus([0, g.h, 0], DA(t)))
    bracket = lambda t: times(rot("x", g.omega_1 * t), rot("y", g.omega_2 * t))
    omega, alpha = proofs.angular_velocity(bracket), proofs.angular_acceleration(bracket)
    found = {"omega_bracket": omega, "alpha_bracket": alpha}
    return {"v_A": rate(A), "a_A": second_rate(A)} | found


def mistakes(g):
    ground, arm, _, A = arm_bracket_tip(g)
    v, a = A.velocity(ground), A.acceleration(ground)
    of_the_arm = 2 * arm.angular_velocity(ground).cross(v.terms["relative"])
    return in_frame(ground, {
        "no_coriolis": {"a_A": a.without("coriolis")},
        "coriolis_of_omega_2_only": {"a_A": a - of_the_arm},
        "coriolis_without_2": {"a_A": a.reweighted(coriolis=0.5)},
        "D_at_rest": {"v_A": v.without("origin"), "a_A": a.without("origin")},
        "no_sliding": {"v_A": v.without("relative")},
    })  # fmt: skip


def draw(g, ax):
    ground, arm, bracket, A = arm_bracket_tip(g)
    E, G, D = arm.point("E", 0, 0, 0), arm.point("G", 0.9 * g.h, 0, 0), bracket.point("D", 0, 0, 0)
    B, C = bracket.point("B", 0, 0, 0.6 * g.s), bracket.point("C", 0, 0, -0.6 * g.s)
    s = Sketch(ax, ground, azimuth=35, elevation=20, up="y")
    s.shaft(E, G)
    s.shaft(E, D)
    s.cylinder(C, B, 0.09 * g.h)
    s.rod(B, A)
    s.axes(E, ground)
    s.turn(G, ground.i, label=r"$\omega_1$")
    s.turn(arm.point("", 0, 0.5 * g.h, 0), ground.j, label=r"$\omega_2$")
    s.vector(A, ground.k, "u", kind="velocity")
    s.dimension(E, D, label="h")
    s.dimension(D, A, label="s")
    s.dot(D)
    for P in (A, C, D, E, G):
        s.label(P, P.name)
    s.label(bracket.point("", 0, -0.09 * g.h, 0.6 * g.s), "B")
