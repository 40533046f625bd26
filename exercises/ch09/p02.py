"""9/2: a slanting bar on a shaft."""

from exercises.devices import rotor
from exercises.tools import box, mp
from newton_euler import Body, cos, sin
from newton_euler.bodies import Inertia, rod


def on_bar(g, shaft, name, distance):
    """The point of the bar at this distance from O."""
    return shaft.point(name, distance * cos(g.theta), distance * sin(g.theta), 0)


def welded_bar(g):
    """The bar, with its inertia about G along the axes of the shaft, for short formulas."""
    _, shaft = rotor.turning_shaft(g)
    G = on_bar(g, shaft, "G", g.l / 2)
    along = shaft.rotate("bar", "z", angle=g.theta)
    own = rod(g.l, along, "x", mass=g.m).inertia.expressed_in(shaft)
    bar = Body("bar", g.m, G, Inertia(G, own.moments, own.products))
    return rotor.in_bearings(shaft, [bar], -g.a, g.b)


solve, steps, follows = rotor.problem_of(welded_bar, off_axis=True)


def prove(g):
    c, s = mp.cos(g.theta), mp.sin(g.theta)
    along = [(share * g.m, x + g.l / 2) for share, (x, _, _) in box(g.l, 0, 0)]
    points = [(m, [u * c, u * s, 0]) for m, u in along]
    return rotor.prove(g, points, -g.a, g.b, ("I_xx", "I_xy", "a_G"))


def mistakes(g):
    r = welded_bar(g)
    quarter = 1 * g.one / 4
    return {
        "pure_couple": rotor.pure_couple(r),
        "all_at_G": rotor.with_inertia(r, product=3 * quarter),
        "about_G": rotor.with_inertia(r, moment=quarter, product=quarter),
        "wrong_sign": rotor.with_inertia(r, product=-1),
    }


def draw(g, ax):
    r = welded_bar(g)
    s = rotor.sketch(ax, r, elevation=14)
    end = on_bar(g, r.shaft, "end", g.l)
    s.rod(r.O, end)
    s.axes(r.O, r.shaft, length=0.4 * g.l)
    s.label(r.O, "O")
    s.arc(r.O, r.B, end, label=r"$\theta$", radius=0.55 * g.l)
    s.dimension(r.O, end, label="l")
    s.dimension(r.A, r.O, label="a", offset=-0.3 * g.l)
    s.dimension(r.O, r.B, label="b", offset=-0.3 * g.l)
