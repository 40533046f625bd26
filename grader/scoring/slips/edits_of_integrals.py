"""Slips in integrals: what is integrated taken as constant or not integrated, wrong limits, and a
slip in what is integrated.
"""

from collections.abc import Iterator, Sequence
from typing import Any

from newton_euler.algebra.language import Words
from newton_euler.algebra.trace import Inner, Step, Trace
from newton_euler.answers.near import LEAST, LESS

from .facts import Facts
from .formulas import SUM, Edit, edit, steps_needed
from .typed import described, is_given

TWINS = {"sin": "cos", "cos": "sin"}
NOUNS = {"+": "the term", "-": "the term", "*": "the factor", "/": "the factor"}
STEP = 1e-3  # relative step of a difference quotient
FEW = 4  # integrals: of more, no slip inside is tried
INSIDE = {
    "twin": Words("takes {twin} for {own} in the integrand: check what it stands for"),
    "all twins": Words("exchanges sine and cosine in the integrand: check the angle"),
    "factor": Words("leaves out {what} in the integral over {x}: each part of it has one"),
    "square": Words("does not square {what} in the integral over {x}: it stands there twice"),
    "term": Words("leaves out {what} in the integral over {x}: it is part of the integrand"),
    "sign": Words("has {what} with the wrong sign in the integral over {x}: check how it comes in"),
}


def of_integrals(f: Facts) -> Iterator[Edit]:
    """What is integrated taken as constant, or not integrated, and wrong limits; also of the
    difference of two integrals, which is one between other limits.
    """
    wholes: dict[tuple[int, ...], list[tuple[Step, int]]] = {}
    for s in f.steps:
        if s.op == "item" and s.args[0].op == "integral":
            wholes.setdefault((s.args[0].number,), []).append((s, s.args[1]))
        one, other = s.args if s.op == "-" else (s, s)
        if _are_of_one_integrand(one, other):
            both = (one.args[0].number, other.args[0].number)
            wholes.setdefault(both, []).append((s, one.args[1]))
    few = len(wholes) <= FEW
    for key, items in wholes.items():
        s, _ = items[0]
        inner, start, end, *outer = (s if len(key) == 1 else s.args[0]).args[0].args
        start = start if len(key) == 1 else s.args[1].args[0].args[2]
        for k, (rank, words, slip) in enumerate(_of_integral(inner, start, end, outer)):
            instead = {s.number: slip(n) for s, n in items}
            yield edit(rank, f"integral {key} {k}", words, instead)
        inside = _of_integrand(inner, outer) if few and len(key) == 1 else ()
        for k, (words, other, is_twin) in enumerate(inside):
            ways = [_between(other, start, end, outer)]
            if is_twin:  # the other one gives zero over equal halves
                ways.append(_doubled(other, start, end, outer))
            for m, way in enumerate(ways):
                instead = {s.number: way(n) for s, n in items}
                yield edit(LEAST, f"integrand {key} {k} {m}", words, instead)


def _are_of_one_integrand(x, y):
    """True of two integrals of one function from one place to two others."""
    if x is y or not all(
        isinstance(s, Step) and s.op == "item" and s.args[0].op == "integral" for s in (x, y)
    ):
        return False
    (f, a, _, *more), (g, b, _, *others) = x.args[0].args, y.args[0].args
    alike = f.key() == g.key() and [*map(_identity, (a, *more))] == [*map(_identity, (b, *others))]
    return alike and x.args[1] == y.args[1]


def _identity(x):
    return ("#", x.number) if isinstance(x, Step) else x


def _of_integral(inner, start, end, outer):
    """(rank, words, {component: expression}) of the slips in one integral."""
    way = ("-", end, start)
    constant = Words("takes the integrand as constant: it varies between the limits")
    mean = Words("takes the mean of the integrand at the two limits: it does not vary linearly")
    rate = Words("differentiates the integrand: its integral is asked for")
    itself = Words("gives the integrand: its integral is asked for")

    def at(x, n):
        return ("inside", inner, n, x, *outer)

    def slope(x, n):
        """From two central differences, exact for powers up to the fourth."""
        one, two = (
            ("/", ("-", at(("*", x, 1 + h), n), at(("*", x, 1 - h), n)), ("*", 2 * h, x))
            for h in (STEP, 2 * STEP)
        )
        return ("/", ("-", ("*", 4.0, one), two), 3.0)

    def between(low, high):
        return _between(inner, low, high, outer)

    yield LESS, constant, lambda n: ("*", way, at(end, n))
    yield LESS, constant, lambda n: ("*", way, at(start, n))
    yield LESS, mean, lambda n: ("*", ("*", way, 0.5), ("+", at(start, n), at(end, n)))
    yield LEAST, rate, lambda n: slope(end, n)
    yield LESS, itself, lambda n: at(end, n)
    yield LESS, itself, lambda n: ("-", at(end, n), at(start, n))
    words = Words("integrates over one half and doubles it: the other half is not alike")
    yield LEAST, words, _doubled(inner, start, end, outer)
    if isinstance(start, Step) or start != 0:
        words = Words("integrates from zero: the integral starts elsewhere")
        yield LESS, words, between(0.0, end)
        words = Words("integrates from zero to the difference of the limits: put in each limit")
        yield LESS, words, between(0.0, way)


def _between(inner, low, high, outer):
    return lambda n: ("item", ("between", inner, low, high, *outer), n)


def _doubled(inner, start, end, outer):
    """Twice the integral over the second half of the way."""
    half = _between(inner, ("*", 0.5, ("+", start, end)), end, outer)
    return lambda n: ("*", 2.0, half(n))


def _of_integrand(inner: Inner, outer: Sequence[Any]) -> Iterator[tuple[Words, Inner, bool]]:
    """(words, other formula, is it a sine for a cosine) of the slips in an integrand."""
    steps = steps_needed(inner.leaves)
    spoken_of = _in_words(inner, outer)
    twins = [s for s in steps if s.op in TWINS and is_given(s)]
    for s in twins:
        words = Words(INSIDE["twin"], own=f"{s.op}(...)", twin=f"{TWINS[s.op]}(...)")
        yield words, _changed(inner, {s.number: (TWINS[s.op], *s.args)}), True
    if len(twins) > 1:
        every = {s.number: (TWINS[s.op], *s.args) for s in twins}
        yield INSIDE["all twins"], _changed(inner, every), False
    for s in steps:
        for kind, x, expression in _of_operation(s) if s.op in NOUNS else ():
            if what := spoken_of(x, NOUNS[s.op]):
                words = Words(INSIDE[kind], what=what, x=inner.variable)
                yield words, _changed(inner, {s.number: expression}), False


def _of_operation(s):
    """(kind of slip, the factor or term that it changes, expression) of the slips in one step."""
    a, b = s.args
    if s.op in SUM:
        yield "term", b, a
        yield "term", a, b
        yield "sign", b, ("+-"[s.op == "+"], a, b)
    else:
        yield "square" if a is b else "factor", b, a
        if s.op == "*" and a is not b:
            yield "factor", a, b


def _in_words(inner, outer):
    """A function that describes a step of a formula by the names of the formula's arguments; "" if
    they have none: the variable as a term may have another name in a student's work.
    """
    passed = zip(inner.parameters, (None, *outer), strict=True)
    called = {p: x.args[0] for p, x in passed if isinstance(x, Step) and x.op == "argument"}
    called[inner.parameters[0]] = inner.variable
    trace, found = Trace(), dict[int, Any]()
    for s in steps_needed(inner.leaves):
        if s.op == "argument":
            name = called.get(s.args[0])
            found[s.number] = trace.new("argument" if name else "unnamed", name or s.number)
        else:
            args = (found[x.number] if isinstance(x, Step) else x for x in s.args)
            found[s.number] = trace.new(s.op, *args)

    def words(x, noun):
        x = found[x.number] if isinstance(x, Step) else x
        names = {s.args[0] for s in steps_needed([x]) if s.op == "argument"}
        is_named = inner.variable and (noun == "the factor" or names - {inner.variable})
        return described(x, noun) if is_named else ""

    return words


def _changed(inner, instead):
    """The formula with other expressions, of its own steps, in place of some steps."""
    trace, found = Trace(), dict[int, Any]()

    def now(x):
        if isinstance(x, tuple):
            return trace.new(x[0], *map(now, x[1:]))
        return found[x.number] if isinstance(x, Step) else x

    for s in steps_needed(inner.leaves):
        other = instead.get(s.number)
        found[s.number] = trace.new(s.op, *map(now, s.args)) if other is None else now(other)
    return Inner(inner.parameters, trace, [*map(now, inner.leaves)], inner.variable)
