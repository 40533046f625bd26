"""Whether a Taylor series sees all that the rates do: past a kink it keeps the old formula."""

from collections import Counter

from ..algebra.scalars import Scalar
from ..algebra.source import WITHIN, uses
from ..algebra.trace import COMPARISONS, Step
from .methods.base import TracedRates

KINKS = {"where", "abs", "table", *COMPARISONS}
# sqrt(v*v) is v to a series but abs(v) to every other method; a motion can pass the branch point
BRANCHES = {"sqrt", "asin", "acos", "atan2", "**"}
# exp(-1000*h) is below round-off in the series of a ball above the floor, yet large on the floor
HIDDEN = {"exp", "tanh", "sinh", "cosh", "pow"}
HIGH_POWER = 8  # as is a higher one, whose first terms are zero where its base is


def kinks(traced: TracedRates) -> list[str]:
    """The operations of the rates that choose between formulas, as where and abs: a sorted list."""
    return sorted({s.op for s in varying(traced) if s.op in KINKS} - set(COMPARISONS))


def inner(traced: TracedRates) -> list[str]:
    """The integrals and roots in the rates, which no series has: a sorted list."""
    return sorted({s.op for s in traced.folded[0].trace.steps}.intersection(WITHIN))


def surprises(traced: TracedRates) -> bool:
    """True if the rates choose between formulas at times that are not known in advance."""
    known = {s.number for s in clocked(traced)}
    chosen = [s.args[0] if s.op == "where" else s for s in varying(traced) if s.op in KINKS]
    return any(not isinstance(s, Step) or s.number not in known for s in chosen)


def clocked(traced: TracedRates) -> list[Step]:
    """The comparisons, absolute values and tables of linear functions of the time, a list."""
    linear, found = set(), []
    for s in varying(traced):
        moving = [a for a in s.args if isinstance(a, Step) and traced.depends[a.number]]
        if s.op == "argument":
            straight = s.args[0] == traced.rhs.parameters[0]
        else:
            straight = all(a.number in linear for a in moving)
        if straight and s.op in KINKS - {"where"}:
            found.append(s)
        elif straight and _is_linear(s, moving):
            linear.add(s.number)
    return found


def _is_linear(step, moving):
    """True if a step is a linear function of those of its arguments that are ``moving``."""
    if step.op == "*" or (step.op == "/" and moving[0] is step.args[0]):
        return len(moving) == 1
    return step.op in ("argument", "+", "-", "neg")


def hazards(traced: TracedRates) -> list[str]:
    """The operations of the rates that a series may not notice, a sorted list: those with a branch
    point that a motion could pass, as a root that is not in a denominator, or below round-off.
    """
    steps = varying(traced)
    poles = {f.number for s in steps if s.op == "/" for f in factors(s.args[1])}
    powers = [s for s in steps if s.op == "**" and type(s.args[1]) in (int, float)]
    # a negative power is a denominator
    poles |= {f.number for s in powers if s.args[1] < 0 for f in factors(s.args[0])}
    branches = {s.op for s in steps if s.op in BRANCHES and not _harmless(s, poles)}
    return sorted(branches | {s.op for s in steps if s.op in HIDDEN or is_high_power(s)})


def is_high_power(s: Step, unknown: bool = False) -> bool:
    """True for x**n with a large n, small but where x is largest; ``unknown`` for a parameter n."""
    if s.op != "**":
        return False
    return unknown if isinstance(s.args[1], Step) else s.args[1] > HIGH_POWER


def depends(traced: TracedRates) -> dict[int, set[str]]:
    """For each step of the trace, by number, the set of states, and time, on which it depends."""
    changing = set(traced.rhs.parameters[: traced.arguments])
    found: dict[int, set[str]] = {}
    for s in traced.rhs.trace.steps:
        below = [found[a.number] for a in s.args if isinstance(a, Step)]
        found[s.number] = {s.args[0]} & changing if s.op == "argument" else set().union(*below)
    return found


def varying(traced: TracedRates) -> list[Step]:
    """The steps of the trace that the rates need and that change during a motion."""
    needed = uses(traced.rhs.trace, traced.rhs.leaves)
    steps = traced.rhs.trace.steps
    return [s for s in steps if s.number in needed and traced.depends[s.number]]


def factors(x: Scalar) -> set[Step]:
    """The steps of the trace whose zeros are zeros of x."""
    if not isinstance(x, Step):
        return set()
    below = x.args if x.op == "*" else x.args[:1] if x.op in ("**", "neg", "sqrt") else ()
    return {x}.union(*map(factors, below))


def absolutes(s: Step) -> list[Scalar]:
    """The steps x whose absolute value a step is made of: abs(x), sqrt(4*x*x) = 2*abs(x)."""
    if s.op == "abs":
        return [s.args[0]]
    if s.op == "sqrt" or (s.op == "**" and not isinstance(s.args[1], int)):
        times = Counter(_multiplied(s.args[0]))
        return [x for x, count in times.items() if isinstance(x, Step) and count > 1]
    return []


def _multiplied(x):
    """The factors of a product, each as often as it occurs."""
    if isinstance(x, Step) and x.op == "*":
        return [*_multiplied(x.args[0]), *_multiplied(x.args[1])]
    return [x]


def _harmless(step, poles):
    x = step.args[0]
    if step.op == "**" and isinstance(step.args[1], int):
        return True
    pole = step.number in poles or (isinstance(x, Step) and x.number in poles)
    return step.op in ("sqrt", "**") and (pole or _positive(x))


def _positive(x):
    """True if x is certainly greater than zero."""
    if not isinstance(x, Step):
        return x > 0
    if x.op == "+":
        a, b = x.args
        return (_positive(a) and _not_negative(b)) or (_positive(b) and _not_negative(a))
    if x.op in ("*", "/"):
        return all(map(_positive, x.args))
    return x.op in ("exp", "cosh", "pi") or (x.op == "sqrt" and _positive(x.args[0]))


def _not_negative(x):
    if not isinstance(x, Step):
        return x >= 0
    if x.op == "*":
        return x.args[0] is x.args[1] or all(map(_not_negative, x.args))
    if x.op in ("+", "/"):
        return all(map(_not_negative, x.args))
    return x.op in ("sqrt", "abs") or _positive(x)
