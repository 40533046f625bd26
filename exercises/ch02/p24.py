"""2/24: the pin of a crank in a slotted arm, in polar coordinates."""

from exercises.devices.slotted_arm import crank, in_arm, sketch, turning
from exercises.tools import mp, rate, rot, second_rate, size, terms, times
from newton_euler import Frame, polar

follows = {"v_mag": lambda g, v_P: v_P.norm(), "a_mag": lambda g, a_P: a_P.norm()}


def answers(v, a):
    return {"v_P": v, "a_P": a, "v_mag": v.norm(), "a_mag": a.norm()}


def motion(g, r):
    """Velocity and acceleration of P for this moving r."""
    ground = Frame("ground")
    P = polar(ground, "P", r, turning(g)[0])
    return P.velocity(ground), P.acceleration(ground)


def solve(g):
    """The magnitudes by the motion in the crank, at 2 theta: they do not depend on theta."""
    ground = Frame("ground")
    crank = ground.rotate("crank", "z", 2 * turning(g)[0], origin=ground.point("C", g.b, 0, 0))
    P = crank.point("P", g.b, 0, 0)
    v, a = (x.expressed_in(crank) for x in (P.velocity(ground), P.acceleration(ground)))
    return answers(*motion(g, turning(g)[1])) | {"v_mag": v.norm(), "a_mag": a.norm()}


def steps(g):
    r = turning(g)[1]
    yield "r_dot", r.rate
    yield "r_ddot", r.acceleration
    v, a = motion(g, r)
    yield from terms(v, "v_P", "m/s", "2.6")
    yield from terms(a, "a_P", "m/s^2", "2.6")
    yield "omega_CP", 2 * turning(g)[0].rate * v.frame.k


def prove(g):
    """The components from P on the crank, the magnitudes from P on the arm."""
    P = crank(g)
    r = lambda t: in_arm(g, P(t), t)[0]
    angle = lambda t: g.theta + g.omega * t
    in_slot = lambda t: times(rot("z", angle(t)), [2 * g.b * mp.cos(angle(t)), 0, 0])
    return {
        "v_P": in_arm(g, rate(P)),
        "a_P": in_arm(g, second_rate(P)),
        "v_mag": size(rate(in_slot)),
        "a_mag": size(second_rate(in_slot)),
        "r_dot": rate(r),
        "r_ddot": second_rate(r),
        "omega_CP": [0, 0, rate(lambda t: mp.atan2(P(t)[1], P(t)[0] - g.b))],
    }


def mistakes(g):
    a = solve(g)["a_P"]
    others = {"no_coriolis": a.without("coriolis"), "no_r_ddot": a.without("radial")}
    return {
        "P_fixed_in_arm": answers(*motion(g, g.b)),
        **{name: {"a_P": wrong, "a_mag": wrong.norm()} for name, wrong in others.items()},
        "omega_of_the_crank": solve(g.but(omega=g.omega / 2)),
    }


def draw(g, ax):
    sketch(g, ax, ["$e_r$", r"$e_\theta$"])
