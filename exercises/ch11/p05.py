"""11/5: a collar sliding down a quarter hoop, pulled by a spring from the other side."""

from exercises.devices.quarter_hoop import hoop, sketch, slides, work_of_weight
from exercises.devices.spring_to_pin import pull
from exercises.tools import minus, size
from newton_euler.algebra.ledger import summed
from newton_euler.dynamics import speed_after, spring_between, spring_potential


def pin(g, ground):
    return ground.point("P", g.R, 0, 0)


def stretches(g):
    ground, _, *ends = hoop(g)
    return [(end - pin(g, ground)).norm() - g.l_0 for end in ends]


def work(g):
    ground, _, A, B = hoop(g)
    at_A, at_B = (spring_between(g.k, g.l_0, pin(g, ground), end) for end in (A, B))
    return summed({"weight": work_of_weight(g), "spring": at_A - at_B})


def speed(g, U):
    return {"v_B": speed_after(0, U, g.m)}


def solve(g):
    return speed(g, work(g))


def steps(g):
    (x_A, x_B), U = stretches(g), work(g).terms
    return {"x_A": x_A, "x_B": x_B, "U_w": U["weight"], "U_s": U["spring"]}


def prove(g):
    """The motion over time, from the forces along the hoop."""
    P = [g.R, 0]
    _, v = slides(g, pull(g.k, g.l_0, P))
    x_A, x_B = (size(minus(end, P)) - g.l_0 for end in ([-g.R, 0], [0, -g.R]))
    return {"v_B": v, "x_A": x_A, "x_B": x_B}


def mistakes(g):
    (x_A, x_B), right = stretches(g), work(g)
    with_spring = lambda U: speed(g, summed({**right.terms, "spring": U}))
    return {
        "lengths_for_stretches": solve(g.but(l_0=0 * g.l_0)),
        "difference_squared": with_spring(spring_potential(g.k, x_A - x_B)),
        "unstretched_at_B": with_spring(spring_potential(g.k, x_A)),
        "no_weight": speed(g, right.reweighted(weight=0)),
    }


def draw(g, ax):
    s, (ground, O, A, B) = sketch(g, ax)
    P = pin(g, ground)
    s.spring(P, A)
    s.ground((g.R, 0, 0), -ground.i)
    s.dot(O)
    s.dimension(O, B, label="R", offset=0)
    s.dimension(O, P, label="R", offset=0.2 * g.R)
    s.dot(P, "P", offset=(-8, -16))
    s.label((0.55 * g.R, 0, 0), "k", offset=(0, -16), bold=False)
