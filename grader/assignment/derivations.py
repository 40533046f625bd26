"""Formulas (SymPy) for each quantity of a problem in terms of givens and earlier quantities, read
off the traced computation.
"""

import random
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from functools import lru_cache
from typing import Any

from exercises.catalogue import Givens, Problem
from exercises.catalogue.tracing import TracedProblem, before, numbers_of, traced_quantities
from exercises.catalogue.variants import draw, symbol_values
from newton_euler.algebra.trace import Step
from newton_euler.algebra.units import unit

from .known import KnownFormulas
from .names import Names, unsigned, value_of
from .roles import Roles
from .tidy import constant, factored, readable, simplest
from .traced_formulas import Writer

LONGEST_LIST = 60  # operations, in all components, that a reader can follow
SHEETS = 4  # sets of numbers on which sums are compared


@dataclass(frozen=True)
class Derivation:
    """The derivation of a quantity.

    formulas : of its components, None for those without a readable formula
    together : equations to be solved first, as pairs of sides
    unknowns : the names of their unknowns
    solved : True if it is an unknown of these or of earlier equations
    varies : True if it depends on the givens
    after : the answers that it is found from, and that must be shown before it
    """

    formulas: tuple = ()
    together: tuple = ()
    unknowns: frozenset = frozenset()
    solved: bool = False
    varies: bool = False
    after: tuple[str, ...] = ()


def derivations(p: Problem, values: Mapping[str, Any]) -> Mapping[str, Derivation]:
    """{key: :class:`Derivation`} of the steps and answers of ``p``; empty if it cannot be traced.
    ``values`` decide between cases.
    """
    found = _traced(p)
    if found is None:
        return {}
    g = p.base({**p.sympy_symbols(), **values})
    memo: dict[int, float | None] = {}
    cases = [value_of(c, g, memo) for c in _choices(found)]
    scalars = {key: parts[0] for key, parts in found.components.items() if len(parts) == 1}
    positive = {key for key, x in scalars.items() if (value_of(x, g, memo) or 0.0) > 0}
    usual = all(low <= values[n] <= high for n, (low, high) in _ranges(p).items())
    return _derivations(p, tuple(c and c > 0 for c in cases), frozenset(positive), usual)


def _unrelated(p, n):
    """Random numbers for givens and symbols, including givens that do not vary."""
    rng, drawn = random.Random(n), draw(p, bytes([n]))
    shared = {
        k: (q.value or 1.0) * rng.uniform(0.97, 1.03) for k, q in p.givens.items() if not q.vary
    }
    return symbol_values(p, rng) | drawn | shared


def _ranges(p):
    """The lowest and highest number of each given."""
    return {n: q.vary or (q.value, q.value) for n, q in p.givens.items()}


def _choices(found):
    """The quantities that decide between cases in a traced computation: conditions, and arguments
    of absolute values.
    """
    return [s.args[0] for s in found.trace.steps if s.op in ("where", "abs")]


def _is_along_axis(name, equation):
    """Whether a term is a number times unit vectors, or has rates of components only."""
    is_rate = (equation.kind, name) == ("rate", "relative")
    return is_rate or r"\hat" in "".join(equation.terms.get(name, ()))


@lru_cache(maxsize=400)
def _traced(p):
    try:
        return traced_quantities(p, to_be_read=True)
    except (TypeError, ValueError, ArithmeticError, AttributeError):
        return None


@lru_cache(maxsize=400)
def _derivations(p, cases, positive, usual):
    """The derivations for these ``cases`` of the choices in the computation and these ``positive``
    quantities; ``usual``: the givens are within their ranges.
    """
    found = _traced(p)
    numbers = [c.number if isinstance(c, Step) else None for c in _choices(found)]
    lowest = {n: low for n, (low, _) in _ranges(p).items() if usual}
    lowest |= {n: q.vary[0] for n, q in p.symbols.items()}
    positive |= {n for n, low in lowest.items() if low > 0}
    drawn = [p.base({**p.sympy_symbols(), **draw(p, bytes([n]))}) for n in range(8 * usual)]
    sheets = [(p.base(_unrelated(p, n)), {}) for n in range(SHEETS * usual)]
    if p.symbols and not p.givens:
        positive |= {
            name for key, parts in found.components.items()
            for name, x in zip(found.kinds[key].names(key), parts, strict=True)
            if all((value_of(x, *s) or 0.0) > 0 for s in sheets)
        }  # fmt: skip
    holds = dict(zip(numbers, cases, strict=True))
    deriver = _Deriver(
        found, holds, {*positive}, [a.key for a in p.answers], p.units, drawn, sheets
    )
    for key in deriver.order():
        deriver.derive(key)
    return deriver.found


class _Deriver:
    """Derives the quantities in order of display, each from earlier ones.

    found : the derivations
    """

    def __init__(
        self,
        traced: TracedProblem,
        cases: Mapping[Any, Any],
        positive: set[str],
        asked: Sequence[str],
        units: Mapping[str, str],
        drawn: Sequence[Givens],
        sheets: Sequence[tuple[Givens, dict]],
    ) -> None:
        self.found = dict[str, Derivation]()
        self.traced, self.asked, self.units = traced, asked, units
        self.components = traced.components
        self.given_by = {x.number: name for name, x in traced.givens.items()}
        self.sum_of = {s.key: s.of for s in traced.steps if s.of}
        self.sums = {*self.sum_of.values()}
        # {sum: vectors that are one of its terms, and no other one}
        self.whole_terms = dict[str, set[str]]()
        self.of_givens = {s.key for s in traced.steps if s.of_givens}
        # terms as -r theta_dot^2 e_r, in which no vector is a factor
        self.along_axes = {s.key for s in traced.steps if s.term and _is_along_axis(*s.term)}
        self.terms = {key: of for key, of in self.sum_of.items() if of in asked}
        # {number: (name, sign)} of components
        self.called = dict[int, tuple[str, int]]()
        first = {}  # {number: the quantity that names it}
        for key in sorted(self.components, key=lambda k: k in self.terms):
            for x, name in zip(self.components[key], self._names(key), strict=True):
                x, sign = unsigned(x)
                if isinstance(x, Step) and x.number not in self.called:
                    self.called[x.number] = name, sign
                    first[x.number] = key
        # {answer: its numbers}, unless a step has them; not of matrices
        self.answers_by = {}
        for key in {a for a in asked if len(self.components.get(a, ())) in range(1, 9)}:
            numbers = numbers_of(self.components[key]) - {*self.given_by}
            if numbers and all(first[n] == key for n in numbers):
                self.answers_by[key] = numbers
        self.known = KnownFormulas({*traced.givens}, units, drawn)
        stated = {name: traced.units[key] for key in self.components for name in self._names(key)}
        powers = {name: unit(of).dimension.powers for name, of in (stated | {**units}).items()}
        rates = (0, 0, -1), (0, 1, -1)
        self.known.rates = {name: x[1] for name, x in powers.items() if x in rates}
        self.names, self.roles = Names({}, sheets), Roles()
        taken = {*traced.givens}.union(*map(self._names, self.components))
        self.writer = Writer(traced, cases, self.names, self.known, self.called, taken, positive)
        ones = {x.number: constant(1) for x in traced.trace.steps
                if x.op == "argument" and x.args[0] == "one"}  # fmt: skip
        self.names.fixed |= ones
        positive |= {
            name
            for key, parts in self.components.items()
            if traced.kinds[key].is_vector
            for x, name in zip(parts, self._names(key), strict=True)
            if isinstance(x, Step) and self.given_by.get(x.number, "") in positive
        }
        for name, x in traced.givens.items():
            self.names.give(x, self.writer.symbol(name))
            self.roles.give(x, self.writer.symbol(name))

    def _names(self, key):
        """The names of the components of a quantity."""
        return self.traced.kinds[key].names(key)

    def _changing(self, key):
        """The names of the components of a quantity that are not zero for everybody."""
        pairs = zip(self._names(key), self.components[key], strict=True)
        return {name for name, x in pairs if isinstance(x, Step)}

    def order(self):
        """The quantities in order of display: the terms of an answer just before it."""
        keys = list(self.components)
        steps = [k for k in keys if k not in self.asked and k not in self.terms]
        answers = [k for k in keys if k in self.asked]
        return steps + [
            x for a in answers for x in (*(t for t in self.terms if self.terms[t] == a), a)
        ]

    def derive(self, key):
        """Derive a quantity, after the answers that it is found from."""
        after = self._found_before(key)
        for other in after:
            self.derive(other)
        if key not in self.found:
            self.found[key] = replace(self._derived(key), after=after)

    def _found_before(self, key):
        """The answers that a step or a number is found from and that have not been shown yet."""
        if key in self.terms or (key in self.asked and len(self.components[key]) > 1):
            return ()
        parts = self.components[key]
        found = before(parts) - numbers_of(parts)
        answers = [a for a in self.components if a in self.answers_by]
        return tuple(a for a in answers if a not in self.found and self.answers_by[a] <= found)

    def _derived(self, key):
        """The derivation of a quantity, which later ones may use."""
        parts, names, writer = self.components[key], self._names(key), self.writer
        self._keep_apart(key)
        writer.start(key, parts)
        formulas = tuple(map(writer.formula, range(len(parts)), parts, names))
        formulas = self.known.of_one_body(self._explicit(formulas, names))
        formulas = tuple(self.roles.placed(formulas, self.traced.kinds[key], self.names.apart))
        solved = any(getattr(unsigned(x)[0], "number", None) in writer.solved for x in parts)
        if of := self.sum_of.get(key):
            shown = {f.name for f in formulas if getattr(f, "is_Symbol", False)}
            self.whole_terms.setdefault(of, set()).update(
                k for k, x in self.components.items()
                if (len(x) == 1 or self.traced.kinds[k].is_vector)
                and shown and shown == self._changing(k)
            )  # fmt: skip
        if key not in self.terms:  # terms of an answer are not used by name
            self._remember(key, parts, names, formulas)
        formulas = tuple(None if f is None else factored(f) for f in formulas)
        if sum(f.count_ops() for f in {*formulas} - {None}) > LONGEST_LIST:
            formulas = ()
        varies = any(isinstance(x, Step) for x in parts)
        unknowns = frozenset(writer.wanted)
        return Derivation(formulas, tuple(writer.together), unknowns, solved, varies)

    def _keep_apart(self, key):
        """Keep out of the formula of a quantity those that equal a part of it by chance: of a term,
        the components of a sum whose other terms are zero, and of :meth:`_unlike` answers; all, if
        the problem asks for that.
        """
        of = self.sum_of.get(key)
        apart = self.sums | self.whole_terms.get(of, set()) | self._unlike(of) if of else set()
        if key in self.along_axes:
            vectors = {other for other, kind in self.traced.kinds.items() if kind.is_vector}
            apart |= {other for other in vectors - {key} if self.traced.units[other] != "1"}
        apart = {*self.components} - {key} if key in self.of_givens else apart
        self.known.apart = {name for other in apart for name in self._names(other)}
        self.names.apart = apart | self.known.apart

    def _unlike(self, of):
        """The vectors among the answers that are in another unit than a sum, as H_O beside M_O."""
        units, kinds = self.traced.units, self.traced.kinds
        vectors = (k for k in self.asked if k in units)
        return {k for k in vectors if kinds[k].is_vector and units[k] != units[of]}

    def _explicit(self, formulas, names):
        """The formulas after solving a single linear equation, if there is one: its solution
        replaces a missing formula, or an unknown that is not a quantity of the problem.
        """
        together, wanted = self.writer.together, self.writer.wanted
        if len(together) != 1 or len(wanted) != 1:
            return formulas
        unknown = self.writer.symbol(*wanted)
        difference = together[0][0] - together[0][1]
        slope = difference.diff(unknown)
        if slope.has(unknown) or slope == 0:
            return formulas
        solution = simplest(readable(-difference.subs(unknown, 0) / slope))
        if unknown.name not in self.writer.taken:
            fixed = self.names.fixed
            fixed |= {n: f.subs(unknown, solution) for n, f in fixed.items() if f.has(unknown)}
            return tuple(
                None if f is None else readable(f.subs(unknown, solution)) for f in formulas
            )
        pairs = zip(formulas, names, strict=True)
        return tuple(solution if f is None and n == unknown.name else f for f, n in pairs)

    def _remember(self, key, parts, names, formulas):
        """Let later quantities use this one."""
        if len(parts) == 1 and formulas[0] is not None and formulas[0].is_positive:
            self.writer.positive.add(key)
        symbols = list(map(self.writer.symbol, names))
        for x, f in zip(map(unsigned, parts), formulas, strict=True):
            if f == 0 and len(parts) > 1 and isinstance(x[0], Step):
                self.names.fixed[x[0].number] = f
        kind = self.traced.kinds[key]
        self.names.add(key, kind, parts, symbols)
        self.known.add(parts, symbols, formulas, kind.is_matrix)
        if kind.is_vector:
            self.roles.add(key, parts, symbols, formulas)
        if len(parts) == 1:
            self._rename(key, parts[0])

    def _rename(self, key, x):
        """Give a given the name of a step that states it with the other sign or in another unit."""
        x, sign = unsigned(x)
        given = self.given_by.get(getattr(x, "number", None))
        if given and (sign < 0 or self.units[given] != self.traced.units[key]):
            self.names.fixed[x.number] = sign * self.writer.symbol(key)
