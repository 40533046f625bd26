"""4/16: the rod CD, hinged at C to an arm BC that turns about the vertical."""

from exercises.answering import in_frame
from exercises.proofs import angular_acceleration, plus, rate, rot, second_rate, times
from newton_euler import Frame, at, cos, sin
from newton_euler.drawing import Sketch

def arm_and_rod(g):
    """Ground with Z up; the arm turns about Z; the rod about the arm's -x axis, which is how beta grows."""
    ground = Frame("ground")
    arm = ground.rotate("arm", "z", rate=g.omega)
    C = arm.point("C", 0, g.b, 0)
    rod = arm.rotate("rod", "-x", angle=g.beta_1, rate=g.b_dot, origin=C)
    return ground, arm, rod, rod.point("D", 0, -g.L, 0)  # at beta = 0 the rod lies on CB


def solve(g):
    ground, arm, rod, D = arm_and_rod(g)
    return in_frame(ground, {
        "alpha_CD": rod.angular_acceleration(ground),
        "v_D": D.velocity(ground, via=arm),
        "a_D": D.acceleration(ground, via=arm),
    })  # fmt: skip


def prove(g):
    def turned(t):
        return rot("z", g.omega * t)

    def rod(t):
        return times(turned(t), rot("x", -(g.beta_1 + g.b_dot * t)))

    def D(t):
        return plus(times(turned(t), [0, g.b, 0]), times(rod(t), [0, -g.L, 0]))

    return {"alpha_CD": angular_acceleration(rod), "v_D": rate(D), "a_D": second_rate(D)}


def mistakes(g):
    ground, arm, rod, D = arm_and_rod(g)
    C = rod.origin
    v, a = D.velocity(ground), D.acceleration(ground, via=arm)
    reversed_rate = solve(g.but(b_dot=-g.b_dot))
    along, up = at(lambda t: g.L * sin(g.beta_1 + g.b_dot * t), 0), at(lambda t: g.L * cos(g.beta_1 + g.b_dot * t), 0)
    from_vertical = arm.point("D", 0, g.b + along, up)
    wrong = {
        "no_cross_product": {"alpha_CD": ground.vector(0, 0, 0)},
        "no_coriolis": {"a_D": a.without("coriolis")},
        "beta_the_other_way": reversed_rate,
        "C_at_rest": {"v_D": v - C.velocity(ground), "a_D": a - C.acceleration(ground)},
        "beta_from_the_vertical": {"v_D": from_vertical.velocity(ground), "a_D": from_vertical.acceleration(ground)},
    }
    return in_frame(ground, wrong)


def draw(g, ax):
    ground, arm, rod, D = arm_and_rod(g)
    B, C = arm.point("B", 0, 0, 0), arm.point("C", 0, g.b, 0)
    A = arm.point("A", 0, 0, -g.b)
    s = Sketch(ax, ground, azimuth=25, elevation=20)
    s.shaft(A, B)
    s.rod(B, C)
    s.rod(C, D)
    s.ground(A, normal=ground.k)
    s.axes(B, ground, labels="XYZ")
    s.turn(A, ground.k, label=r"$\omega$")
    s.arc(C, B, D, label=r"$\beta$")
    s.dimension(B, C, label="b")
    s.dimension(C, D, label="L")
    for P in (A, B, C, D):
        s.label(P, P.name)
