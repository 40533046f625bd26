"""The arguments of those operations of a formula that have a scale of their own: ``where``,
``abs``, ``exp``, ``tanh``, a high power, a quotient whose denominator comes close to zero, and a
table. Far from one place of its argument each of them but a table is as good as constant.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from math import inf

from ..algebra.compile import Compiled
from ..algebra.late import np
from ..algebra.source import uses
from ..algebra.tables import Table
from ..algebra.trace import COMPARISONS, Step
from .analytic import absolutes, clocked, factors, is_high_power, varying
from .methods.base import TracedRates

GROWING, STEEP, PERIODIC = {"exp", "pow"}, {"tanh", "sinh", "cosh", "atan"}, {"sin", "cos", "tan"}
# The change of an argument in a step, or the ratio of its values, from which a structure can lie
# between the stages of a method; and the same in a part of a step
CHANGE, RATIO = (4.0, 0.5), (0.1, 0.5)
TURNED = 1.0  # radians in a step from which a sine is not known by its ends
LIMITS = dict.fromkeys(("largest", "steep"), (2 * CHANGE[0], 2 * CHANGE[1]))
LIMITS |= {"phase": (TURNED, TURNED), "table": (inf, inf), "jump": (0, 0), "ratio": (0, 0)}


@dataclass(eq=False, repr=False)
class Arguments:
    """The ``kinds`` of operations with scales of their own, "largest", "jump", "steep", "ratio" or
    "table", and the ``formula`` of their arguments, each as two numbers to be subtracted; also
    "phase", for that of a sine in one of them.

    tables : the places of each table, by the number of its argument
    powers : the numbers of the arguments that are not to be subtracted, but are base and exponent
    """

    kinds: tuple[str, ...]
    formula: Compiled
    tables: Mapping[int, Table]
    powers: Sequence[int]

    @cached_property
    def names(self) -> "np.ndarray":
        """The kinds as an array."""
        return np.array(self.kinds)

    @cached_property
    def jumps(self) -> "np.ndarray":
        """For each argument whether the rates jump where it changes its sign, a column."""
        return (self.names == "jump")[:, None]

    @cached_property
    def phases(self) -> "np.ndarray":
        """For each argument whether it is that of a sine, a column."""
        return (self.names == "phase")[:, None]

    @cached_property
    def limits(self) -> "np.ndarray":
        """By what each may change in a step, and in a part of one; 0 where its ratio counts."""
        return np.array([LIMITS[kind] for kind in self.kinds])


def narrow_arguments(traced: TracedRates, of_event: bool = False) -> Arguments | None:
    """The :class:`Arguments` in the rates, or in the function of an event; None without any."""
    steps, rhs = varying(traced), traced.rhs
    found = list(dict.fromkeys(pair for s in steps for pair in _scaled(s, traced)))
    known = {s.number for s in clocked(traced)}
    read = (s for s in steps if s.op == "table" and s.number not in known)
    found += [("table", tuple(s.args)) for s in read]
    for leaf in rhs.leaves if of_event else ():  # the factors of its function count too
        found += [("jump", (x, 0.0)) for x in _places_of_sign(leaf, 0.0, traced)]
    if not found:
        return None
    inside = uses(rhs.trace, [x for _, pair in found for x in pair])
    periodic = [s for s in steps if s.op in PERIODIC and s.number in inside]
    found += [("phase", (s.args[0], 0.0)) for s in periodic]
    inner = ((a, 0.0 if kind == "table" else b) for kind, (a, b) in found)
    leaves = [x for pair in inner for x in pair]
    formula = Compiled("arguments", rhs.parameters, rhs.trace, leaves)
    tables = {n: pair[1] for n, (kind, pair) in enumerate(found) if kind == "table"}
    powers = [n for n, (kind, _) in enumerate(found) if kind == "power"]
    kinds = ("largest" if kind == "power" else kind for kind, _ in found)
    return Arguments(tuple(kinds), formula, tables, powers)


def _scaled(s, traced):
    """The arguments of one step, pairs (kind, (a, b)) for the argument a - b."""
    pairs = [tuple(s.args)] if s.op in COMPARISONS else [(x, 0.0) for x in absolutes(s)]
    for a, b in pairs:
        yield "jump", (a, b)
        for factor in _places_of_sign(a, b, traced):
            yield "jump", (factor, 0.0)
    if s.op in STEEP:
        yield "steep", (s.args[0], 0.0)
    elif s.op in GROWING:
        yield "largest", (s.args[-1], 0.0)
    elif s.op in ("/", "sqrt", "**"):
        if is_high_power(s, unknown=True):
            yield "power", tuple(s.args)
        for factor in factors(s.args[s.op == "/"]):
            if _with_squares(factor, traced.depends):
                yield "ratio", (factor, 0.0)


def _places_of_sign(a, b, traced):
    """The known places where a - b changes sign: steps that are factors or denominators."""
    trace, found = traced.rhs.trace, set()
    below = uses(trace, (a, b))
    for s in trace.steps:
        if s.op == "/" and s.number in below:
            found |= factors(s.args[1])
    for one, other in ((a, b), (b, a)):
        if not isinstance(other, Step) and other == 0:
            found |= factors(one.args[0] if isinstance(one, Step) and one.op == "/" else one)
    moving = [x for x in found - {a, b} if traced.depends[x.number]]
    return sorted(moving, key=lambda x: x.number)


def _with_squares(s, depends):
    """True for a sum with a constant that may be about zero without being zero, as 1 + x*x."""

    def varies(x):
        return isinstance(x, Step) and bool(depends[x.number])

    def below(x):
        return [x, *(y for a in x.args for y in below(a))] if varies(x) else []

    def constant(x):
        return not varies(x) or (x.op in ("+", "-") and any(map(constant, x.args)))

    def square(x):
        return x.op in ("**", "exp", "pow") or (x.op == "*" and all(map(varies, x.args)))

    steps = below(s)
    periodic = any(x.op in ("sin", "cos") for x in steps)
    return s.op in ("+", "-") and constant(s) and any(map(square, steps)) and not periodic
