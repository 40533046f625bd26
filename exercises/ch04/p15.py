"""4/15: a rod that rises in its hinge on a turning vertical shaft."""

from exercises.devices.moving_frame import seen_in, turning_of
from exercises.tools import Sketch, in_frame, rate, rot, second_rate, terms, times
from newton_euler import Frame, cos


def shaft_and_rod(g):
    """Ground with y up; the shaft, about y; the rod, along its x, about the shaft's z at B."""
    ground = Frame("ground")
    shaft = ground.rotate("shaft", "y", rate=g.omega_1)
    rod = shaft.rotate("rod", "z", angle=g.beta_1, rate=g.omega_2, acceleration=g.omega_2_dot)
    return ground, shaft, rod, rod.point("C", g.L, 0, 0)


def solve(g):
    ground, shaft, _, C = shaft_and_rod(g)
    v, a = C.velocity(ground, via=shaft), C.acceleration(ground, via=shaft)
    return in_frame(ground, {"v_C": v, "a_C": a})


def steps(g):
    ground, shaft, _, C = shaft_and_rod(g)
    yield from turning_of(shaft, ground, ground, "shaft", "the moving frame, fixed in the shaft,")
    yield from seen_in(shaft, C, ground, "mm", "the shaft", "B")
    v, a = solve(g).values()
    yield from terms(v, "v_C", "mm/s", "4.8")
    yield from terms(a, "a_C", "mm/s^2", "4.8")


def prove(g):
    beta = lambda t: g.beta_1 + g.omega_2 * t + g.omega_2_dot * t**2 / 2
    seen = lambda t: times(rot("z", beta(t)), [g.L, 0, 0])
    C = lambda t: times(rot("y", g.omega_1 * t), seen(t))
    found = {"r": seen(0), "v_r": rate(seen), "a_r": second_rate(seen)}
    return {"v_C": rate(C), "a_C": second_rate(C)} | found


def mistakes(g):
    ground, shaft, rod, C = shaft_and_rod(g)
    v, a = C.velocity(ground, via=shaft), C.acceleration(ground, via=shaft)
    inward = shaft.i * (-(g.omega_1**2) * g.L) - rod.i * (g.omega_2**2 * g.L)
    gyroscopic = rod.angular_acceleration(ground).terms["shaft x rod"]
    wrong = {
        "no_cross_in_alpha": {"a_C": a - gyroscopic.cross(C.position(rod))},
        "no_coriolis": {"a_C": a.without("coriolis")},
        "no_omega_2_dot": {"a_C": solve(g.but(omega_2_dot=0))["a_C"]},
        "L_from_the_shaft": {
            "v_C": v.reweighted(rotation=1 / cos(g.beta_1)),
            "a_C": a.reweighted(centripetal=1 / cos(g.beta_1)),
        },
        "two_centripetal_only": {"a_C": inward},
    }
    return in_frame(ground, wrong)


def draw(g, ax):
    ground, shaft, _, C = shaft_and_rod(g)
    A = ground.point("A", 0, -0.8 * g.L, 0)
    B = ground.point("B", 0, 0, 0)
    level = ground.point("", 0.8 * g.L, 0, 0)
    s = Sketch(ax, ground, azimuth=25, elevation=15, up="y")
    s.ground(A, normal=ground.j)
    s.shaft(A, B)
    s.rod(B, C)
    s.hinge(B, axis=shaft.k)
    s.line(B, level)
    s.axes(B, ground, length=0.45 * g.L)
    s.turn((A - B) * 0.6, ground.j, label=r"$\omega_1$")
    s.swing(B, C, shaft.k, label=r"$\omega_2,\ \dot\omega_2$")
    s.arc(B, level, C, label=r"$\beta_1$")
    s.dimension(B, C, label="L")
    for P in (A, B, C):
        s.label(P, P.name)
