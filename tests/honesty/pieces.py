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
    switches = []  # pairs: a step of the formula, the argument that is its sign

    def sign(g):
        if g.op == "neg":
            return -sign(g.args[0])
        mirrored = g.args[1] - g.args[0] if g.op == "-" else None
        for switch, known in switches:
            if switch is g or switch is mirrored:
                return known if switch is g else -known
        switches.append((g, trace.new("argument", f"sign{len(switches)}")))
        return switches[-1][1]

    def linear(x, table, place):
        """A table at the step x, whose place in the pieces is ``place``."""
        if table.kind != "linear":
            raise ValueError(f"no pieces of a table that is {table.kind}")
        points = list(zip(table.places, table.values, strict=True))
        slopes = [(f - e) / (b - a) for (a, e), (b, f) in pairwise(points)]
        ends = (0.0,) if table.hold else ()
        value, bends = table.values[0], table.places
        if not table.hold:
            value, bends = value + slopes[0] * (place - bends[0]), bends[1:-1]
        for at, (before, after) in zip(bends, pairwise([*ends, *slopes, *ends]), strict=True):
            value += (1 + sign(x - at)) / 2 * (after - before) * (place - at)
        return value

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
            new = linear(*s.args, args[0])
        else:
            new = s if s.op == "argument" else trace.step(s.op, *args)
        made[s.number] = new
    names = [sign.args[0] for _, sign in switches]
    rates = Compiled("pieces", [*rhs.parameters, *names], trace, list(map(taken, leaves)))
    return rates, [Compiled("switch", rhs.parameters, trace, [g], "r[0]") for g, _ in switches]
