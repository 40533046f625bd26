"""2/24: the pin of a crank in a slotted arm, in polar coordinates."""

from exercises.devices.slotted_arm import crank, in_arm, sketch, turning
from exercises.proofs import rate, second_rate, size
from exercises.steps import Step, terms
from newton_euler import Frame, polar


def answers(v, a):
    return {"v_P": v, "a_P": a, "v_mag": v.norm(), "a_mag": a.norm()}


def motion(g, r):
    """Velocity and acceleration of P for this moving r."""
    ground = Frame("ground")
    P = polar(ground, "P", r, turning(g)[0])
    return P.velocity(ground), P.acceleration(ground)


def solve(g):
    return answers(*motion(g, turning(g)[1]))


def steps(g):
    r = turning(g)[1]
    yield Step("r_dot", r.rate, "m/s", "rate of OP", "2.6")
    yield Step("r_ddot", r.acceleration, "m/s^2", "second rate of OP", "2.6")
    v, a = motion(g, r)
    yield from terms(v, "v_P", "m/s", "2.6")
    yield from terms(a, "a_P", "m/s^2", "2.6")


follows = {"v_mag": lambda g, v_P: v_P.norm(), "a_mag": lambda g, a_P: a_P.norm()}


def prove(g):
    P = crank(g)
    v, a = rate(P), second_rate(P)

    def r(t):
        return in_arm(g, P(t), t)[0]

    answers = {"v_P": in_arm(g, v), "a_P": in_arm(g, a), "v_mag": size(v), "a_mag": size(a)}
    return answers | {"r_dot": rate(r), "r_ddot": second_rate(r)}


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
