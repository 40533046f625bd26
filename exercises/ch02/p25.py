"""2/25: the pin of a crank in a slotted arm, seen from the arm."""

from exercises.devices.slotted_arm import crank, in_arm, sketch, turning
from exercises.tools import minus, rate, rot, second_rate, terms, times
from newton_euler import Frame, moving


def arm_and_pin(g, r):
    """Ground, arm and pin for this moving OP."""
    ground = Frame("ground")
    arm = ground.rotate("arm", "z", turning(g)[0])
    return ground, arm, arm.point("P", r, 0, 0)


def motion(ground, arm, P):
    a = P.acceleration(ground, via=arm).expressed_in(arm)
    return {
        "v_rel": P.velocity(arm),
        "a_rel": P.acceleration(arm),
        "a_cor": a.terms["coriolis"],
        "v_P": P.velocity(ground, via=arm).expressed_in(arm),
        "a_P": a,
    }


def solve(g):
    return motion(*arm_and_pin(g, turning(g)[1]))


def steps(g):
    r = turning(g)[1]
    ground, arm, P = arm_and_pin(g, r)
    yield "omega_arm", arm.angular_velocity(ground).expressed_in(arm)
    yield "r_P", P.position(arm)
    yield "r_dot", r.rate
    yield "r_ddot", r.acceleration
    right = motion(ground, arm, P)
    yield from terms(right["v_P"], "v_P", "m/s", "2.10", "2.24")
    yield from terms(right["a_P"], "a_P", "m/s^2", "2.10", "2.25")


def a_cor(g, v_rel):
    return 2 * v_rel.frame.vector(0, 0, g.omega).cross(v_rel)


def v_P(g, v_rel):
    """v_P from v_rel and the velocity of the point of the arm at P."""
    right, vector = solve(g), v_rel.frame.vector
    return v_rel + vector(*right["v_P"].terms["rotation"].components())


def a_P(g, a_rel, a_cor):
    right, vector = solve(g), a_rel.frame.vector
    return a_rel + a_cor + vector(*right["a_P"].terms["centripetal"].components())


follows = {"a_cor": a_cor, "v_P": v_P, "a_P": a_P}


def prove(g):
    """The pin on its crank, seen from the arm; the Coriolis term is the rest."""
    P = crank(g)
    seen = lambda t: in_arm(g, P(t), t)
    place = lambda t: times(rot("z", g.omega * t), P(0))
    a_rel, a = second_rate(seen), in_arm(g, second_rate(P))
    return {
        "v_rel": rate(seen),
        "a_rel": a_rel,
        "a_cor": minus(minus(a, a_rel), in_arm(g, second_rate(place))),
        "v_P": in_arm(g, rate(P)),
        "a_P": a,
        "r_P": seen(0),
    }


def mistakes(g):
    (_, a_rel, a_cor, _, a_P), r = solve(g).values(), turning(g)[1]
    out = motion(*arm_and_pin(g, moving(r.value, rate=-r.rate, acceleration=r.acceleration)))
    return {
        "no_coriolis": {"a_P": a_P.without("coriolis")},
        "no_a_rel": {"a_rel": 0 * a_rel, "a_P": a_P.without("relative")},
        "slides_outward": {key: out[key] for key in ("v_rel", "a_cor", "v_P", "a_P")},
        "half_coriolis": {"a_cor": a_cor / 2, "a_P": a_P.reweighted(coriolis=0.5)},
    }


def draw(g, ax):
    sketch(g, ax, ["i", "j"])
