"""Slips in an equation whose root is found by numbers: in one of its steps, which is then solved; a
small angle; another root of the same equation.
"""

import math
from collections.abc import Callable, Iterator
from typing import Any

from newton_euler.algebra.compile import Compiled
from newton_euler.algebra.language import Words
from newton_euler.algebra.trace import Inner, Step, Trace
from newton_euler.answers.causes import Cause
from newton_euler.answers.near import LESS

from .edits_of_givens import NOT_ONE, Slip
from .edits_of_operations import of_coefficient, of_factor, of_operation
from .facts import Facts
from .formulas import PRODUCT, Edit, edit, steps_in, steps_needed, users_of
from .typed import Product, described

STEPS, ROUND_OFF, NEXT = 100, 1e-12, 1e-9
PLACES = 40  # points at which the sign of an equation is tested for another root
REACH = 2  # range of these points, in lengths of the interval around the root
IN_EQUATION = Words("in the equation for {unknown} {cause}")
SMALL = Words("takes the angle {unknown} as small in its equation: it is not")
OTHERS = {
    -1: Words("takes a smaller root of the equation for {unknown}: check which one is asked for"),
    1: Words("takes a larger root of the equation for {unknown}: check which one is asked for"),
}
SMALL_ANGLE: dict[str, Callable[[Step], Any]] = {
    "sin": lambda s: s.args[0], "tan": lambda s: s.args[0], "cos": lambda s: 1.0,
}  # fmt: skip


def of_roots(f: Facts) -> Iterator[Edit]:
    """The slips in the equation of each root."""
    for s in f.steps:
        if s.op == "item" and s.args[0].op == "root":
            for n, (rank, words, *does, found) in enumerate(_of_root(_Equation(s))):
                yield edit(rank, f"root {s.number} {n}", words, {s.number: found}, *does)


class _Equation:
    """The equation of a root, with all that it is computed from: its steps in a trace of their own,
    in which what is passed to it is spelled out.

    unknown : its name, or what it is in words; "" if that is unknown
    solved : the steps that depend on the unknown, which is the first; ``products``: of these the
        products with all their factors
    """

    def __init__(self, item: Step):
        self.inner, self.low, self.high, *self.outer = item.args[0].args
        called, meant = (getattr(item.trace, x).get(item.number, "") for x in ("called", "meant"))
        self.unknown = called or meant
        self._trace, self._places = Trace(), dict[int, Any]()
        self._outside: dict[int, Step] = {}
        names = self.inner.parameters
        x = self._trace.new("argument" if called else "unnamed", called)
        self._trace.meant[x.number] = meant
        passed = dict(zip(names, (x, *map(self._copied, self.outer)), strict=True))
        self.x, now = x, dict[int, Any]()
        for s in steps_needed(self.inner.leaves):
            args = (now[a.number] if isinstance(a, Step) else a for a in s.args)
            now[s.number] = (
                passed[s.args[0]] if s.op == "argument" else self._trace.new(s.op, *args)
            )
        (leaf,) = self.inner.leaves
        self.leaf = now[leaf.number]
        self.solved = {x: None}
        users = users_of(steps_needed([self.leaf]))
        for s in users:
            if any(a in self.solved for a in steps_in(s)):
                self.solved[s] = None
        products = (s for s in self.solved if s.op in PRODUCT)
        self.products = {s for s in products if [u.op in PRODUCT for u in users[s]] != [True]}

    def _copied(self, x):
        """The arguments of the equation, as steps of its trace, with their words."""
        for s in steps_needed([x]):
            args = (self._places[a.number] if isinstance(a, Step) else a for a in s.args)
            own = self._places[s.number] = self._trace.new(s.op, *args)
            self._outside.setdefault(own.number, s)
            for words in ("called", "meant"):
                if known := getattr(s.trace, words).get(s.number):
                    getattr(self._trace, words).setdefault(own.number, known)
        return self._places[x.number] if isinstance(x, Step) else x

    def of_product(self, s: Step) -> Iterator[Slip]:
        """The slips in a product: in its number and in the factors that depend on the unknown;
        other factors are edited where they are computed.
        """
        for factor, power in Product(s).powers.items():
            if factor in self.solved and described(factor):
                yield from of_factor(s, factor, power, factor, NOT_ONE)
        yield from of_coefficient(s)

    def changed(self, instead: dict[int, Any]) -> Any:
        """The root with other expressions in place of some steps of the equation."""
        trace, now = Trace(), dict[int, Any]()
        own, outer = trace.new("argument", "x"), list[Step]()

        def found(x):
            if isinstance(x, tuple):
                return trace.new(x[0], *map(found, x[1:]))
            if isinstance(x, Step) and x.number not in now:
                around = self._outside.get(x.number)
                if around is not None:
                    outer.append(around)
                args = x.args if around is None else (f"p{len(outer)}",)
                op = x.op if around is None else "argument"
                now[x.number] = trace.new(op, *map(found, args))
            return now[x.number] if isinstance(x, Step) else x

        now[self.x.number] = own
        for s in [*self.solved][1:]:
            now[s.number] = trace.new(s.op, *map(found, s.args))
            if s.number in instead:
                now[s.number] = found(instead[s.number])
        inner = Inner(["x", *(f"p{n + 1}" for n in range(len(outer)))], trace, [found(self.leaf)])
        return ("rooted", inner, self.low, self.high, *outer)


def _of_root(equation):
    """(rank, words, what it does and to what, the root) of the slips in one equation."""
    unknown = equation.unknown
    for s in equation.solved:
        slips = [*of_operation(s, lambda s: s)]  # slips in base units
        slips += equation.of_product(s) if s in equation.products else ()
        for rank, _, words, expression, *does in (x for x in slips if x[0] <= LESS):
            text = words.text if isinstance(words, Cause) else words
            named = Words(IN_EQUATION, unknown=unknown, cause=text) if unknown else text
            yield rank, named, *does, equation.changed({s.number: expression})
    angles = [s for s in equation.solved if s.op in SMALL_ANGLE]
    if angles and unknown:
        small = {s.number: SMALL_ANGLE[s.op](s) for s in angles}
        yield LESS, Words(SMALL, unknown=unknown), equation.changed(small)
    for side, words in OTHERS.items() if unknown else ():
        where = ("beside", float(side), equation.inner, equation.low, equation.high)
        yield LESS, Words(words, unknown=unknown), (*where, *equation.outer)


def rooted(formula: Compiled, low: float, high: float, *outer: float) -> float:
    """The root between these places, or else the one nearest to them; or nan."""
    f = _on_floats(formula, outer)
    a, b = _end(f, low, high), _end(f, high, low)
    if f(a) * f(b) <= 0:
        return _root(f, a, b)
    found = [_next(f, low, low - high), _next(f, high, high - low)]
    gaps = {abs(x - end): x for x, end in zip(found, (low, high), strict=True) if not math.isnan(x)}
    return gaps[min(gaps)] if gaps else math.nan


def beside(side: float, formula: Compiled, low: float, high: float, *outer: float) -> float:
    """The next root on this side of the one between these places; or nan."""
    f = _on_floats(formula, outer)
    own = _root(f, low, high) if f(low) * f(high) <= 0 else math.nan
    return _next(f, own, side * (high - low))


def _end(f, x, other):
    """An end of an interval, or a point beside it if the function has no value there."""
    return x + NEXT * (other - x) if math.isnan(f(x)) else x


def _next(f, start, way):
    """The next root from a place on, within :data:`REACH`; or nan."""
    places = [start + REACH * way * (n / PLACES) ** 2 for n in range(1, PLACES + 1)]
    a, fa = places[0], f(places[0])
    for b in places[1:]:
        fb = f(b)
        if fa * fb <= 0:
            return _root(f, a, b)
        a, fa = b, fb
    return math.nan


def _on_floats(formula, outer):
    """The formula as a function of the unknown alone; nan where it has no value."""
    numbers = [*map(float, outer)]

    def f(x):
        try:
            return formula.on_floats(x, *numbers)[0]
        except (ArithmeticError, ValueError):
            return math.nan

    return f


def _root(f, low, high):
    """The root between two places, by false position (Illinois); nan at a pole."""
    a, b, fa, fb = low, high, f(low), f(high)
    first = abs(fa) + abs(fb)
    for _ in range(STEPS):
        if fb == 0 or abs(b - a) <= ROUND_OFF * abs(b):
            break
        x = b - fb * (b - a) / (fb - fa)
        fx = f(x)
        if math.isnan(fx):
            return fx
        a, fa = (b, fb) if fx * fb < 0 else (a, fa / 2)
        b, fb = x, fx
    return b if abs(fb) <= ROUND_OFF * first else math.nan
