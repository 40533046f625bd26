"""A body of mass points that tumbles, with its momentum by differences: oracle of tests in
dynamics/ and scenes/.
"""

import mpmath as mp
import sympy

from newton_euler import Frame, at, composite, cos, moving, particle, sin
from tests import kinds
from tests.kinds import numbers

MASSES = [(2, (1, "1/2", 0)), (1, (-1, 0, "1/3")), (3, (0, "-2/3", 1))]
MASSES += [("1/2", ("1/4", 1, -1)), (1, ("1/5", "1/5", "1/7"))]


def close(a, b, tolerance):
    """SymPy's numbers are evaluated from the inside out: evalf takes forever on nested sums."""
    if hasattr(a, "frame") and hasattr(b, "frame"):
        b = b.expressed_in(a.frame)
    return kinds.close(valued(a), valued(b), tolerance)


def valued(x):
    if hasattr(x, "frame") or isinstance(x, (tuple, list)):
        return tuple(valued(part) for part in x)
    return mp.mpf(sympy.Float(inside_out(x, {}), 40)._mpf_) if isinstance(x, sympy.Basic) else x


def inside_out(x, known):
    if x not in known:
        value = x.func(*(inside_out(a, known) for a in x.args)) if x.args else x
        known[x] = value if value.is_Integer or value.is_Rational else value.evalf(60)
    return known[x]


def turns(a, b, c):
    """The three angles of the body as functions of time."""
    return lambda t: a + b * t, lambda t: c + a * t * t, lambda t: b + c * t + t * t


def path(a, b, c):
    """Where the body's origin is: with an acceleration in all three components."""
    return lambda t: a * t * t + sin(b * t), lambda t: c * t + cos(a * t), lambda t: b * t * t * t


def free_body(kind):
    """ground, body, named points to take moments about, and the numbers (a, b, c, t)."""
    a, b, c, t = q = numbers(kind, "0.4", "-0.7", "1.1", "0.5")
    ground = Frame("ground")
    O = ground.point("O", *(at(f, t) for f in path(a, b, c)))
    frame = ground.rotate("1", "z", at(turns(a, b, c)[0], t), origin=O)
    frame = frame.rotate("2", "x", at(turns(a, b, c)[1], t))
    carrier = frame
    frame = frame.rotate("body", (0, 3 + 0 * t, 4 + 0 * t), at(turns(a, b, c)[2], t))
    parts = [
        particle(numbers(kind, m), frame.point(f"P{n}", *numbers(kind, *x)), f"P{n}")
        for n, (m, x) in enumerate(MASSES)
    ]
    body = composite("body", parts, frame=frame)
    points = {
        "body": frame.point("B", *numbers(kind, "1/2", -1, "1/3")),
        "rest": ground.point("C", *numbers(kind, 1, 2, -1)),
        "drift": ground.point("D", *(moving(x, x) for x in numbers(kind, 2, "1/3", -1))),
        "any": carrier.point(
            "E",
            at(lambda s: b + s * s, t),
            at(lambda s: c * s * s * s, t),
            at(lambda s: sin(a * s), t),
        ),
    }
    return ground, carrier, body, points, q
