"""9/1: two small masses on a shaft."""

from exercises.devices import rotor
from newton_euler import particle


def two_bodies(g):
    _, shaft = rotor.turning_shaft(g)
    first = particle(g.m, shaft.point("P", g.d, g.r, 0), "first body")
    second = particle(g.m, shaft.point("Q", -g.d, -g.r, 0), "second body")
    return rotor.in_bearings(shaft, [first, second], -g.c, g.c)


solve, steps, follows = rotor.problem_of(two_bodies, particles=True)


def prove(g):
    return rotor.prove(g, [(g.m, [g.d, g.r, 0]), (g.m, [-g.d, -g.r, 0])], -g.c, g.c)


def mistakes(g):
    r = two_bodies(g)
    right = rotor.answers(r)
    none = rotor.with_inertia(r, product=0)
    return {
        "static_is_enough": {**rotor.only(none, "F_A", "F_B"), "balance": "both"},
        "wrong_sign": rotor.with_inertia(r, product=-1),
        "no_rotation": {**{k: x for k, x in none.items() if k != "H_O"}, "balance": "both"},
        "on_the_bearings": {key: -force for key, force in rotor.only(right, "F_A", "F_B").items()},
    }


def draw(g, ax):
    r = two_bodies(g)
    s = rotor.sketch(ax, r)
    for n, part in (1, r.body.parts[0]), (-1, r.body.parts[1]):
        foot = (n * g.d, 0, 0)
        s.rod(foot, part.centre)
        s.sphere(part.centre, 0.07 * g.c)
        s.dimension(foot, part.centre, label="r", offset=-n * 0.12 * g.c)
        s.label(part.centre, "m", offset=(-20, 0), bold=False)
    s.axes(r.O, r.shaft, length=0.35 * g.c)
    s.label(r.O, "O")
    s.dimension(r.O, (g.d, 0, 0), label="d")
    s.dimension(r.A, r.O, label="c")
