"""Shortening the formula of a quantity by means of earlier ones."""

from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass, field
from fractions import Fraction
from typing import Any

from exercises.catalogue import Givens
from newton_euler.algebra.late import sympy

from .names import unsigned
from .tidy import is_atom, is_forced, is_itself_shorter, is_root, readable

SHORT = 1  # operations of a formula as easy to read as the name of a vector's component


@dataclass
class KnownFormulas:
    """Formulas of the quantities shown so far.

    givens : their names
    units : of the givens and symbols
    drawn : sheets of numbers, to see what is positive for everybody
    shorter : pairs of a formula and the name that replaces it
    short : {component of a vector: formula as short as its name}
    products : {name: formula} of products of givens
    constants : {number: name} of quantities that are the same for all givens
    opposite : {component: the component of another vector with the opposite sign}
    entries : {entry of a matrix: its formula}
    rates : {name of an angular rate: 0, of a velocity: 1}
    velocities : {name of one: its formula}
    apart : the names that are not used now
    entry : the end of the name that is written, where it is an entry of a matrix: "_xx"
    """

    givens: Collection[str]
    units: Mapping[str, str]
    drawn: Sequence[Givens]
    shorter: list[tuple[Any, Any]] = field(default_factory=list)
    short: dict[Any, Any] = field(default_factory=dict)
    products: dict[Any, Any] = field(default_factory=dict)
    constants: dict[float, Any] = field(default_factory=dict)
    opposite: dict[Any, Any] = field(default_factory=dict)
    entries: dict[Any, Any] = field(default_factory=dict)
    rates: Mapping[str, Fraction] = field(default_factory=dict)
    velocities: dict[Any, Any] = field(default_factory=dict)
    apart: set[str] = field(default_factory=set)
    entry: str = ""
    _placed: dict[tuple[int, int, int], Any] = field(default_factory=dict)

    def add(
        self,
        parts: Sequence[Any],
        symbols: Sequence[Any],
        formulas: Sequence[Any],
        is_matrix: bool,
    ) -> None:
        """Add a quantity: its traced components, their names, and their formulas or None."""
        for n, (part, symbol) in enumerate(zip(parts, symbols, strict=True)):
            x, sign = unsigned(part)
            if number := getattr(x, "number", None):
                self._placed[number, n, sign] = symbol
                if (other := self._placed.get((number, n, -sign))) is not None:
                    self.opposite |= {symbol: other, other: symbol}
        named = [(f, x) for f, x in zip(formulas, symbols, strict=True) if f is not None]
        self.velocities |= {x: f for f, x in named if f.is_Mul and self.rates.get(x.name) == 1}
        self.entries |= {x: f for f, x in named if is_matrix}
        self.constants |= {float(f): x for f, x in named if f.is_Float}
        self.products |= {
            x: f for f, x in named if f.is_Mul and self.is_of_givens(f)
            and not f.has(sympy.Add, sympy.Function)
        }  # fmt: skip
        if len(parts) == 1 or any(f.count_ops() > SHORT for f, _ in named):
            # a vector's w/2 may belong to several bodies
            shared = {f for f, _ in named if len(parts) > 1 and f.as_coeff_Mul()[1].is_Symbol}
            longer = [(f, x) for f, x in named if f not in shared]
            self.shorter += [(f, x) for f, x in longer if not is_atom(f) and not f.is_number]
            self.shorter += [(f.base, x**2) for f, x in longer if is_root(f) and f.base.is_Add]
        else:
            self.short |= {x: f for f, x in named}

    def is_of_givens(self, formula: Any) -> bool:
        """True if a formula contains only givens."""
        return self._names(formula) <= {*self.givens}

    def of_one_body(self, formulas: Sequence[Any]) -> Sequence[Any]:
        """The formulas of the entries of a matrix: if it is a sum of matrices, by the latest matrix
        of each body; if not, names of other entries, equal by chance, are written out.
        """
        if len(formulas) != 9 or None in formulas:
            return formulas
        sums = [f for f in formulas if f.is_Add and f.free_symbols & self.entries.keys()]
        if sums:
            moved = {f: x for x, f in self.entries.items() if f.is_Symbol and f in self.entries}
            return tuple(f.xreplace(moved) for f in formulas)
        return tuple(f.xreplace(self.entries) if is_atom(f) else f for f in formulas)

    def shortened(self, formula: Any, met: Collection[str] = ()) -> Any:
        """The formula in terms of earlier quantities; ``met`` are those that the computation itself
        uses.
        """
        formula = self._without_ones(self.named(self._without_bars(readable(formula))))
        if is_atom(formula):
            formula = formula.xreplace(self.short)
        formula = self._with_squares(self._without_multiples(formula, met))
        return self._without_doubles(self._written_out(formula))

    def _with_squares(self, formula):
        """The formula with r omega^2 for omega v, if v is r omega; but 2 omega r' stays."""

        def squared(term):
            number, product = term.as_coeff_Mul()
            factors = {*sympy.Mul.make_args(product)}
            plain = abs(number) == 1 and not sympy.fraction(product)[1].has(sympy.Add)
            for name in factors & self.velocities.keys() if plain else ():
                shared = factors & {*sympy.Mul.make_args(self.velocities[name])}
                if any(str(x) in self.rates for x in shared):
                    return term.subs(name, self.velocities[name])
            return term

        return sympy.Add(*map(squared, sympy.Add.make_args(formula)))

    def named(self, formula: Any) -> Any:
        """The formula with the formulas of earlier quantities replaced by their names; in an entry
        of a matrix, those of the same entry first.
        """
        pairs = [x for x in reversed(self.shorter) if not self._names(x[1]) & self.apart]
        pairs.sort(key=lambda x: not (self.entry and str(x[1]).endswith(self.entry)))
        shorter = self._named_once(formula, pairs)
        return shorter if shorter == formula else self._named_once(shorter, pairs)

    @staticmethod
    def _names(formula):
        return {x.name for x in formula.free_symbols}

    def _named_once(self, formula, pairs):
        for other, name in pairs:
            shorter = formula.subs(other, name)
            if shorter == formula and not other.is_Add:
                shorter = formula.subs(1 / other, 1 / name)
            if shorter == formula and other.is_Mul:
                shorter = formula.subs(-other, -name)
            if shorter.count_ops() < formula.count_ops() and not is_forced(name, other, shorter):
                formula = shorter
        return formula

    def _written_out(self, formula):
        """The formula with short components written out, if that makes it shorter."""
        if not formula.free_symbols & self.short.keys():
            return formula
        plain = readable(formula.xreplace(self.short).expand())
        return plain if is_itself_shorter(plain, formula) else formula

    def _without_doubles(self, formula):
        """The formula with both names for a sum of opposite components: v_B - v_A, not 2 v_B."""

        def both(c, x):
            other = self.opposite.get(x)
            apart = abs(c) == 2 and other is not None and not formula.has(other)
            return c / 2 * (x - other) if apart else c * x

        terms = [x.as_coeff_Mul() for x in sympy.Add.make_args(formula)]
        return sympy.Add(*(both(c, x) for c, x in terms)) if len(terms) > 1 else formula

    def _without_bars(self, formula):
        """The formula without bars around what has one sign for all drawn numbers."""
        for bars in formula.atoms(sympy.Abs):
            inside = bars.args[0]
            if self.drawn and self.is_of_givens(inside):
                draws = ({x: getattr(g, x.name) for x in inside.free_symbols} for g in self.drawn)
                signs = {inside.subs(values).is_positive for values in draws}
                if signs in ({True}, {False}):
                    formula = formula.xreplace({bars: inside if True in signs else -inside})
        return formula

    def _without_multiples(self, formula, met):
        """The formula with names written out that equal a product of givens by chance: those with a
        factor, as 4*I_1/3, and those in a sum with a product that differs by a given of the same
        unit, as m_1*d^2 and m_2*d^2.
        """
        terms = [x.as_coeff_Mul() for x in sympy.Add.make_args(formula)]
        own = self.products.keys() - met
        products = [x for _, x in terms if {s.name for s in x.free_symbols} <= {*self.units}]

        def written_out(c, x):
            whole = self.products.get(x, x)
            alike = any(self._differ_by_one(whole, y) for y in products)
            return c * (whole if alike or (abs(c) != 1 and x in own) else x)

        return sympy.Add(*(written_out(c, x) for c, x in terms))

    def _differ_by_one(self, one, other):
        """Whether two products differ in one given, by another of the same unit."""
        ratio = [str(x) for x in (one / other).as_numer_denom()]
        return ratio[0] != ratio[1] and len({self.units.get(x, x) for x in ratio}) == 1

    def _without_ones(self, formula):
        """The formula simplified by sin^2 + cos^2 = 1 for components of a unit vector."""
        squared = {self.short.get(x.base) for x in formula.atoms(sympy.Pow) if x.exp == 2} - {None}
        if len([x for x in squared if x.has(sympy.sin, sympy.cos)]) < 2:
            return formula
        shorter = sympy.trigsimp(formula.xreplace(self.short))
        return shorter if shorter.count_ops() < formula.count_ops() else formula
