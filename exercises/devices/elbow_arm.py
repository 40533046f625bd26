"""The elbow arm of 4/16, 4/17: rod CD, hinged at C to an arm BC turning about the vertical."""

from exercises.annotations import Answers, AnyAxes, Givens, Mistakes, Steps
from exercises.tools import Sketch, Step, in_frame, mp, proofs, rate, rot, terms, times, transposed
from newton_euler import Frame, Point, Vector, cos, sin


def arm_and_rod(g: Givens) -> tuple[Frame, Frame, Frame, Point]:
    """Ground with Z up; the arm turns about Z; the rod about the arm's -x axis, as beta grows."""
    ground = Frame("ground")
    arm = ground.rotate("BC", "z", rate=g.omega)
    C = arm.point("C", 0, g.b, 0)
    rod = arm.rotate("CD", "-x", angle=g.beta_1, rate=g.b_dot, origin=C)
    return ground, arm, rod, rod.point("D", 0, -g.L, 0)  # at beta = 0 the rod lies on CB


def motion(D: Point, ground: Frame, **via: Frame) -> Answers:
    return {"v_D": D.velocity(ground, **via), "a_D": D.acceleration(ground, **via)}


def solve(g: Givens) -> Answers:
    ground, arm, rod, D = arm_and_rod(g)
    alpha = rod.angular_acceleration(ground)
    return in_frame(ground, {"alpha_CD": alpha, **motion(D, ground, via=arm)})


def steps(g: Givens) -> Steps:
    """The rod's angular velocity, D's velocity relative to the arm, the terms of the answers."""
    ground, arm, rod, D = arm_and_rod(g)
    omega, v_r = rod.angular_velocity(ground).expressed_in(ground), D.velocity(arm)
    yield Step("omega_CD", omega, "rad/s", "angular velocity of CD in the ground", "4.9", "4.22")
    phrase = "velocity of D relative to the moving frame, fixed in BC"
    yield Step("v_r", v_r.expressed_in(ground), "mm/s", phrase, "4.8", "4.17")
    for key, value in solve(g).items():
        yield from terms(value, key, {"alpha_CD": "rad/s^2", "v_D": "mm/s"}.get(key, "mm/s^2"))


def a_D(g: Givens, alpha_CD: Vector) -> Vector:
    """The acceleration of D from the rod's angular acceleration."""
    right, vector = solve(g), alpha_CD.frame.vector
    CD = vector(0, -g.L * cos(g.beta_1), g.L * sin(g.beta_1))
    return vector(*right["a_D"]) + (alpha_CD - vector(*right["alpha_CD"])).cross(CD)


follows = {"a_D": a_D}


def prove(g: Givens) -> Answers:
    """The direction of CD in the turning vertical plane, raised by beta from CB."""
    beta = lambda t: g.beta_1 + g.b_dot * t

    def rod(t):
        c, s = mp.cos(beta(t)), mp.sin(beta(t))
        # columns: x, the direction of CD, their cross product
        return times(rot("z", g.omega * t), transposed([[1, 0, 0], [0, -c, s], [0, -s, -c]]))

    in_arm = lambda t: [0, g.b - g.L * mp.cos(beta(t)), g.L * mp.sin(beta(t))]
    D = lambda t: times(rot("z", g.omega * t), in_arm(t))
    alpha = proofs.angular_acceleration(rod)
    answers = {"alpha_CD": alpha, "v_D": rate(D), "a_D": proofs.second_rate(D)}
    return answers | {"omega_CD": proofs.angular_velocity(rod), "v_r": rate(in_arm)}


def common_mistakes(g: Givens) -> Mistakes:
    ground, arm, rod, D = arm_and_rod(g)
    return in_frame(ground, {
        "no_cross_product": {"alpha_CD": rod.angular_acceleration(ground).without("BC x CD")},
        "no_coriolis": {"a_D": D.acceleration(ground, via=arm).without("coriolis")},
        "beta_the_other_way": solve(g.but(b_dot=-g.b_dot)),
    })  # fmt: skip


def draw(g: Givens, ax: AnyAxes) -> None:
    ground, arm, _, D = arm_and_rod(g)
    B, C = arm.point("B", 0, 0, 0), arm.point("C", 0, g.b, 0)
    A = arm.point("A", 0, 0, -g.b)
    s = Sketch(ax, ground, azimuth=25, elevation=20)
    s.shaft(A, B)
    s.rod(B, C, D)
    s.ground(A, normal=ground.k)
    s.axes(B, ground, length=1.4 * g.b, labels="XYZ")
    s.turn(A, ground.k, label=r"$\omega$")
    s.arc(C, B, D, label=r"$\beta$")
    s.swing(C, D, -ground.i, label=r"$\dot\beta$")
    s.dimension(B, C, label="b", offset=-0.1 * (g.b + g.L))
    s.dimension(C, D, label="L")
    for P in (A, B, C, D):
        s.label(P, P.name)
