"""11/13: when a force field has a potential: the linear field."""

from itertools import pairwise

from exercises.tools import box, freedom, gradient, mean, mpf, on_ground, plus, rate, scaled, times
from newton_euler import Frame, integral, work_along
from newton_euler.dynamics import conservative_force, curl, degrees_of_freedom

NAMES = [f"g_{n}{m}" for n in "xyz" for m in "xyz"]


def linear(coefficients):
    """The field with these nine coefficients, row by row."""

    def force(*place):
        rows = (coefficients[n : n + 3] for n in (0, 3, 6))
        return tuple(sum(c * q for c, q in zip(row, place, strict=True)) for row in rows)

    return force


def field(g):
    return linear([getattr(g, name) for name in NAMES])


def corners(g):
    none = 0 * g.a
    return [(none, none, none), (g.a, none, none), (g.a, g.b, none), (none, g.b, none)]


def round_trip(g, places):
    """The works along the sides, back to the first place."""
    side = lambda P, Q: lambda s: tuple(p + s * (q - p) for p, q in zip(P, Q, strict=True))
    sides = [side(P, Q) for P, Q in pairwise([*places, places[0]])]
    return [work_along(field(g), segment, 0, 1).value for segment in sides]


def candidate(g):
    """Minus the work along the segment, as a function of the place."""
    F = field(g)

    def V(*place):
        along = lambda s: sum(f * q for f, q in zip(F(*(s * q for q in place)), place, strict=True))
        return -integral(along, 0, 1)

    return V


def answers(g, V):
    """V, and the difference of its slope and -F_x."""
    slope = -conservative_force(V, Frame("axes").point("P", g.x, g.y, g.z)).x
    return {"V": V(g.x, g.y, g.z), "mismatch_x": slope + field(g)(g.x, g.y, g.z)[0]}


def conditions(vanishing):
    """The number of independent conditions among these, functions of the nine coefficients."""
    return degrees_of_freedom({"field": len(NAMES)}, {"all": vanishing}).rank


def cross_derivatives(field):
    """The curl, as a sum of those of the nine fields with one coefficient each."""
    units = ([float(n == m) for m in range(9)] for n in range(9))
    curls = [curl(linear(unit), (1.0, 2.0, 3.0)) for unit in units]
    columns = zip(*curls, strict=True)
    return tuple(sum(c * x for c, x in zip(field, col, strict=True)) for col in columns)


def solve(g):
    return {
        "W_loop": sum(round_trip(g, corners(g))),
        **answers(g, candidate(g)),
        "conditions": lambda: conditions(cross_derivatives),
    }


def steps(g):
    P = Frame("axes").point("P", g.x, g.y, g.z)
    sides = {f"W_{n}": U for n, U in enumerate(round_trip(g, corners(g)), 1)}
    return {**sides, "V_x": -conservative_force(candidate(g), P).x}


def prove(g):
    """Mean circulation, mean work, slopes along slanted lines; fields with a potential, counted."""
    coefficients = [getattr(g, name) for name in NAMES]
    F = lambda r: times([coefficients[n : n + 3] for n in (0, 3, 6)], r)

    def circulation(r):
        """The circulation around a place, per unit area."""
        to_y = rate(lambda t: F(plus(r, [t, 0, 0])))[1]
        return to_y - rate(lambda t: F(plus(r, [0, t, 0])))[0]

    middle = [g.a / 2, g.b / 2, 0]
    inside = box(g.a, g.b, 0, order=2)

    def V(*r):
        # along the segment, q[0] from -1/2 to 1/2
        push = lambda q: sum(f * x for f, x in zip(F(scaled(q[0] + mpf("0.5"), r)), r, strict=True))
        return -mean(push, box(1, 0, 0, order=2))

    place = [g.x, g.y, g.z]
    slope = gradient(V, place)[0]

    def forces(*c):
        """The forces of the potential with these coefficients, at three places."""

        def quadratic(x, y, z):
            terms = (x * x, y * y, z * z, x * y, y * z, z * x)
            return sum(a * b for a, b in zip(c, terms, strict=True))

        places = ([1, 0, 0], [0, 1, 0], [0, 0, 1])
        return [x for at in places for x in gradient(quadratic, at)]

    return {
        "W_loop": g.a * g.b * mean(lambda r: circulation(plus(r, middle)), inside),
        "V": V(*place),
        "mismatch_x": slope + F(place)[0],
        "conditions": len(NAMES) - freedom(forces, *map(mpf, (3, 1, 4, 1, 5, 9))),
        "V_x": slope,
    }


def mistakes(g):
    F, none = field(g), 0 * g.x

    def in_three_legs(x, y, z, x_0, y_0):
        """Minus the work along x, then y at ``x_0``, then z at ``x_0`` and ``y_0``."""
        ways = (
            lambda s: F(s * x, none, none)[0] * x,
            lambda s: F(x_0, s * y, none)[1] * y,
            lambda s: F(x_0, y_0, s * z)[2] * z,
        )
        return -sum(integral(way, 0, 1) for way in ways)

    V = candidate(g)
    pairs = (0, 4), (4, 8), (8, 0)
    direct = conditions(lambda field: tuple(field[n] - field[m] for n, m in pairs))
    return {
        "axes_alone": answers(g, lambda x, y, z: in_three_legs(x, y, z, none, none)),
        "edges": answers(g, lambda x, y, z: in_three_legs(x, y, z, x, y)),
        "opposite_sense": {"W_loop": sum(round_trip(g, corners(g)[::-1]))},
        "plus_work": answers(g, lambda *place: -V(*place)),
        "pairs_twice": {"conditions": 2 * conditions(cross_derivatives)},
        "direct_derivatives": {"conditions": direct},
    }


def draw(g, ax):
    ground, s = on_ground(ax, azimuth=30, elevation=22)
    O, P, foot = (0, 0, 0), (g.x, g.y, g.z), (g.x, g.y, 0)
    s.axes(O, ground, length=1.35 * g.a)
    places = corners(g)
    for start, end in pairwise([*places, places[0]]):
        s.arrow(start, tuple((p + q) / 2 for p, q in zip(start, end, strict=True)))
        s.line(start, end, style="solid")
    s.line(O, P, style="solid")
    s.dot(P)
    s.dot(O)
    s.line(O, foot)
    s.line(foot, P)
    s.dimension(places[0], places[1], label="a", offset=-0.25 * g.b)
    s.dimension(places[1], places[2], label="b", offset=-0.2 * g.b)
    s.label(P, "(x, y, z)", offset=(14, 8), bold=False)
