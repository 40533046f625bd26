"""The analytic pieces of rates that have kinks or jumps, from the formula that a model traces."""

from itertools import pairwise

from newton_euler.algebra.compile import Compiled
from newton_euler.algebra.trace import COMPARISONS, Step, packed, unpacked


def pieces(model):
    """The rates of a model, ``f(t, *states, *parameters, *signs)``, and its switches, a list of
    functions ``g(t, *states, *parameters)``: the signs of these, 1 or -1, take the place of what
    ``where``, ``abs``, the root of a square and tables that are linear choose by.

    >>> from newton_euler import Model
    >>> rates, (v,) = pieces(Model("drag", {}, ("v",), lambda s, p, t: (-abs(s.v) * s.v,)))
    >>> v(0.0, -3.0), rates(0.0, -3.0, -1), rates(0.0, -3.0, 1)
    (-3.0, (9.0,), (-9.0,))
    """
    rhs = model.compiled_rhs(*model.parameters)
    trace, leaves = unpacked(*packed(rhs.trace, rhs.leaves))
    signs = {}  # by the number of the step that is a switch

    def sign(g):
        """The argument that is the sign of a step."""
        if g.op == "neg":
            return -sign(g.args[0])
        if g.number not in signs:
            signs[g.number] = trace.new("argument", f"sign{len(signs)}")
        return signs[g.number]

    made = {}  # by the number of a step the one that takes its place
    taken = lambda x: made[x.number] if isinstance(x, Step) else x
    for s in list(trace.steps):
        args = list(map(taken, s.args))
        if s.op in COMPARISONS:
            up = sign(s.args[0] - s.args[1])
            new = (1 + (up if s.op in ("gt", "ge") else -up)) / 2
        elif s.op == "where":
            holds, x, y = args
            new = holds * x + (1 - holds) * y
        elif s.op == "abs":
            new = sign(s.args[0]) * args[0]
        elif s.op == "sqrt" and s.args[0].op == "*" and s.args[0].args[0] is s.args[0].args[1]:
            root = s.args[0].args[0]
            new = sign(root) * taken(root)
        elif s.op == "table":
            new = _linear(*s.args, args[0], sign)
        else:
            new = s if s.op == "argument" else trace.step(s.op, *args)
        made[s.number] = new
    names = [*rhs.parameters, *(s.args[0] for s in signs.values())]
    rates = Compiled("pieces", names, trace, list(map(taken, leaves)))
    switch = lambda n: Compiled("switch", rhs.parameters, trace, [trace.steps[n]], "r[0]")
    return rates, list(map(switch, signs))


def _linear(x, table, place, sign):
    """A table at the step x, whose place in the pieces is ``place``."""
    if table.kind != "linear":
        raise ValueError(f"no pieces of a table that is {table.kind}")
    points = list(zip(table.places, table.values, strict=True))
    slopes = [(f - e) / (b - a) for (a, e), (b, f) in pairwise(points)]
    if table.hold:
        value, bends, slopes = table.values[0], table.places, [0.0, *slopes, 0.0]
    else:
        value, bends = table.values[0] + slopes[0] * (place - table.places[0]), table.places[1:-1]
    for at, (before, after) in zip(bends, pairwise(slopes), strict=True):
        value += (1 + sign(x - at)) / 2 * (after - before) * (place - at)
    return value
