"""The lines of a worked solution, in LaTeX or as text: for each step and answer the equation with
symbols, with the numbers of a sheet, and the value.
"""

import random
import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any

from exercises.catalogue import Problem
from exercises.catalogue.steps import Step, is_sum, steps
from exercises.catalogue.variants import flat, symbol_values
from newton_euler.algebra.late import sympy
from newton_euler.algebra.ledger import latex_text
from newton_euler.algebra.scalars import is_numeric, to_plain
from newton_euler.algebra.vectors import Vector
from newton_euler.answers.notation import (  # fmt: skip
    is_word,
    list_symbol,
    number_symbol,
    six_digits,
    symbol,
    unit_symbol,
)
from newton_euler.answers.tolerance import NOISE

from .cells import Values
from .derivations import SHEETS, Derivation, derivations
from .formulas import coherent, formula_text, numerals
from .layout import as_drawn, in_reading_order
from .tidy import integrated, is_atom, simplest

LONGEST = 400  # characters of a formula with numbers
SAME_OPERATIONS = 4  # more than those of a result do not show how it was found


@dataclass(frozen=True)
class Line:
    """A step or answer of a worked solution, in LaTeX or as text.

    together, with_numbers : equations to be solved first, with symbols and with numbers
    above : True if it is an unknown of equations solved before
    name : of the quantity, or ""
    equal : right-hand sides: formula, formula with numbers, value with unit
    too_long : True if its formula is left out for its length
    """

    step: Step
    together: tuple[str, ...]
    with_numbers: tuple[str, ...]
    above: bool
    name: str
    equal: tuple[str, ...]
    too_long: bool = False


def lines(p: Problem, values: Values, latex: bool = True, formulas: bool = True) -> Iterator[Line]:
    """The lines of a worked solution: the steps, and then the answers, for ``values`` in the units
    of the text, with SymPy symbols for quantities without a number; without ``formulas``, values
    only.
    """
    answers = p.solve(values)
    asked = [Step(a.key, answers[a.key], a.unit, a.means, kind=a.kind) for a in p.answers]
    found = steps(p, values, with_all_terms=True)
    writer = _Writer(p, values, [*found, *asked], latex, formulas)
    of_answers = [s for s in found if s.of in answers]
    in_order = [s for s in found if s.of not in answers]
    for a in asked:
        in_order += [*(s for s in of_answers if s.of == a.key), a]
    done = dict[str, Step]()
    for s in in_order:
        earlier = writer.after(s.key)
        first = [x for x in (*of_answers, *asked) if x.of in earlier or x.key in earlier]
        done |= {x.key: x for x in (*first, s)}
    yield from map(writer.line, done.values())


class _Writer:
    """Writes the derivations of a problem with its symbols and numbers."""

    def __init__(self, p, values, quantities, latex, formulas):
        self.p, self.latex = p, latex
        self.sheets = [symbol_values(p, random.Random(n)) for n in range(SHEETS)]
        self.steps = [s for s in quantities if s.key not in {a.key for a in p.answers}]
        self.quantities = {s.key: s for s in quantities}
        self.derivations = derivations(p, values) if formulas else {}
        self.sums = {}  # {sum: keys of its terms}
        for s in quantities:
            if s.of and formulas:
                self.sums.setdefault(s.of, []).append(s.key)
        formulas = [f for x in self.derivations.values() for f in x.formulas if f is not None]
        used = {x.name for f in formulas for x in f.free_symbols}
        self.used = {s.key for s in quantities if used & {*_names_of(s)}}
        self.names, self.units, self.numbers, self.sizes = {}, {}, {}, {}
        for name, stated in p.units.items():
            self._know(name, p.notation[name], values[name], stated)
        for s in quantities:
            parts = _parts(s)
            axes = _axes(s.value)
            for n, (x, key) in enumerate(zip(parts, _names_of(s), strict=True)):
                index = f"{n // 3 + 1}{n % 3 + 1}" if s.kind.is_matrix and s.unit == "1" else ""
                index = axes[n] if axes else index  # index of a turned component
                named = symbol(f"{s.key}_{index}" if index else key)
                self._know(key, p.notation.get(key) or named, x, s.unit)
        self.names = {n: self.names[n] for n in in_reading_order(self.units)}
        self.numbers = {n: self.numbers[n] for n in self.names if n in self.numbers}

    def _know(self, name, named, x, stated):
        self.names[name], self.units[name] = named if self.latex else name, stated
        if is_numeric(x) or not x.free_symbols:
            self.numbers[name] = x, stated
            self.sizes[stated] = max(self.sizes.get(stated, 0.0), abs(float(x)))

    def after(self, key):
        """The answers that must be shown before a step or answer."""
        found = self.derivations.get(key, Derivation()).after
        return {*found, *(x for other in found for x in self.after(other))}

    def _count(self, s):
        """A count as the difference of the counts in the steps, or ""."""
        counts = [x.value for x in self.steps if isinstance(x.value, int)]
        for n in range(2, len(counts) + 1):
            if isinstance(s.value, int) and counts[0] - sum(counts[1:n]) == s.value:
                return " - ".join(map(str, counts[:n]))
        return ""

    def line(self, s):
        """The line of a step or answer."""
        found = self.derivations.get(s.key, Derivation())
        if terms := self.sums.get(s.key):
            names = zip(*(self.quantities[key].kind.names(key) for key in terms), strict=True)
            found = replace(found, formulas=tuple(sympy.Add(*sympy.symbols(x)) for x in names))
        formula, numbers = self._formula(found.formulas, s)
        value = self._value(s)
        formula = formula or ("" if s in self.steps else self._count(s))
        if self._is_same(found.formulas, s):
            formula = ""
        chain = [x for x in (formula, numbers) if x]
        last = (value, value.removesuffix(self._unit(s)))
        chain = [x for n, x in enumerate(chain) if x not in (*chain[:n], *last)]
        above = found.solved and not found.together and s.key not in self.sums
        too_long = not (chain or above or found.together) and self._has_formula(s, found)
        rows, with_numbers = self._together(found)
        with_numbers = () if formula else with_numbers
        name = self._name(s) or (symbol(s.key) if rows else "")  # as in the equations
        return Line(s, rows, with_numbers, above, name, (*chain, value), too_long)

    def _is_same(self, formulas, s):
        """True if the formulas of a result only repeat it in another form."""
        pairs = [*zip(formulas, map(to_plain, flat(s.value)), strict=False)] if formulas else []
        return any(not is_numeric(x) and x.free_symbols for _, x in pairs) and all(
            f is not None
            and not f.has(sympy.Integral)
            and {x.name for x in f.free_symbols} <= {*self.p.symbols}
            and (is_numeric(x) or f.count_ops() <= simplest(x).count_ops() + SAME_OPERATIONS)
            for f, x in pairs
        )

    def _has_formula(self, s, found):
        """True if a quantity without a readable formula has one: it varies with the givens, and is
        neither a word, nor counted, nor a sum whose terms stand above, nor a formula itself.
        """
        if isinstance(s.value, (str, int)) or callable(s.value):
            return False
        is_shown = s.key in self.sums or is_sum(s.value, self.p)
        known = found.formulas and None not in found.formulas
        numeric = all(map(is_numeric, map(to_plain, flat(s.value))))
        return numeric and found.varies and not (is_shown or known)

    def _together(self, found):
        """The equations to be solved first, with symbols and with numbers."""
        rows = self._rows(found.together, self._called)
        free = {x.name for pair in found.together for f in pair for x in f.free_symbols}
        used = {n: x for n, x in self.numbers.items() if n in free - found.unknowns}
        if len(used) < len(free - found.unknowns) or not used:
            return rows, ()
        bare = coherent([self.numbers[n][1] for n in free if n in self.numbers])
        names = numerals(used, bare, self.latex)
        with_numbers = self._rows(found.together, lambda f: self._called(f) | names, True)
        plain = {_without_dots(row) for row in rows}
        with_numbers = tuple(row for row in with_numbers if _without_dots(row) not in plain)
        return rows, with_numbers if sum(map(len, with_numbers)) <= LONGEST else ()

    def _rows(self, pairs, named, numbers=False):
        return tuple(
            " = ".join(formula_text(f, named(f), self.latex, numbers) for f in pair)
            for pair in pairs
        )

    def _name(self, s):
        a = next((a for a in self.p.answers if a.key == s.key), None)
        if a and is_word(a.key) and not a.latex and s.key not in self.used:
            return "" if self.latex else s.key
        if not self.latex:
            return s.key
        is_named = a and (a.latex or not is_word(a.key))
        return self.p.notation[s.key] if is_named else symbol(s.key, s.is_vector)

    def _called(self, formula):
        """The names of the symbols of a formula; unknowns have their names in the code."""
        free = {s.name for s in formula.free_symbols}
        unknown = {n: symbol(n) if self.latex else n for n in sorted(free - {*self.names})}
        return {n: text for n, text in self.names.items() if n in free} | unknown

    def _formula(self, formulas, s):
        """The formula of a quantity, with symbols and with numbers, each perhaps ""."""
        if not formulas or None in formulas or all(isinstance(f, sympy.Float) for f in formulas):
            return "", ""
        free = {x.name for f in formulas for x in f.free_symbols}
        degrees = "deg" in (s.unit, *(self.units.get(n) for n in free))
        plain = self._whole(formulas, s.key) or self._joined(
            [formula_text(f, self._called(f), self.latex, degrees=degrees) for f in formulas],
            s.kind,
        )
        if s.key in self.sums:  # the terms are shown above
            plain = ""
        if any(n not in self.numbers for n in free):
            return plain, ""
        stated = {self.numbers[n][1] for n in free}
        if all(f.is_number or is_atom(f) for f in formulas) and stated == {s.unit}:
            return plain, ""
        bare = not (degrees and any(map(self._mixes, formulas))) and coherent([s.unit, *stated])
        names = numerals({n: self.numbers[n] for n in self.names if n in free}, bare, self.latex)
        formulas = [integrated(sympy.sympify(f.xreplace(self._nothing(f)))) for f in formulas]
        text = self._joined(
            [formula_text(f, names, self.latex, True, degrees) for f in formulas], s.kind
        )
        return plain, text if len(text) <= LONGEST else ""

    def _mixes(self, formula):
        """True if angles in degrees and in other units are added."""

        def in_degrees(x):
            of = x.as_coeff_Mul()[1]
            return of == sympy.pi or (of.is_Symbol and self.units.get(of.name) == "deg")

        return any(len(set(map(in_degrees, x.args))) == 2 for x in formula.atoms(sympy.Add))

    def _nothing(self, formula):
        """{symbol: 0} for symbols that are zero up to round-off, as cos(60 deg) - 1/2."""
        known = {
            x: self.numbers[x.name] for x in formula.free_symbols if x.name not in self.p.units
        }
        return {x: 0 for x, (number, of) in known.items() if abs(number) <= self._noise(of)}

    def _noise(self, stated_in):
        return 1e-12 * self.sizes.get(stated_in, 0.0)

    def _whole(self, formulas, own_key):
        """The name of another vector with these components, or ""."""
        keys = {f.name.rpartition("_")[0] for f in formulas if f.is_Symbol}
        key = keys.pop() if len(keys) == 1 else ""
        if key == own_key or key not in self.quantities or len(formulas) < 2:
            return ""
        kind = self.quantities[key].kind
        if kind.length != len(formulas) or not all(
            (f.is_Symbol and f.name == name) or (f == 0 and self.numbers.get(name, (1,))[0] == 0)
            for f, name in zip(formulas, kind.names(key), strict=True)
        ):
            return ""
        return symbol(key, kind.is_vector) if self.latex else key

    def _joined(self, parts, kind):
        return kind.typeset(parts) if self.latex else in_brackets(kind.nested(parts))

    def _value(self, s):
        value = s.value
        if isinstance(value, Vector):
            value = value.rounded(self._noise(s.unit))
        elif is_numeric(value) and abs(value) <= self._noise(s.unit):
            value = 0
        if not self.latex:
            return formatted(value, self.names, self.sheets) + self._unit(s)
        parts = [latex_of(x, self.names, self.sheets) for x in flat(value)]
        return s.kind.typeset(parts) + self._unit(s)

    def _unit(self, s):
        if self.latex:
            return unit_symbol(s.unit)
        return "" if s.unit == "1" else f" {s.unit}"


def in_brackets(parts: Any) -> str:
    """Texts in nested lists as one text."""
    return f"[{', '.join(map(in_brackets, parts))}]" if isinstance(parts, list) else parts


def _parts(s):
    """The numbers of a quantity."""
    return [] if isinstance(s.value, str) or callable(s.value) else list(flat(s.value))


def _names_of(s):
    return s.kind.names(s.key) if _parts(s) else []


def _axes(value):
    """The indices of the unit vectors along which a vector's components are, or none for x, y, z:
    of frames that the engine calls "spherical axes of P" or "e_r, e_theta, k".
    """
    frame = value.frame.name if isinstance(value, Vector) else ""
    listed = re.findall(r"\be_(\w+)", frame)
    return _AXES.get(frame.partition(" axes of")[0]) or (*listed, "z") * bool(listed)


_AXES = {
    "polar": ("r", "theta", "z"),
    "cylindrical": ("r", "theta", "z"),
    "spherical": ("R", "theta", "phi"),
}


def _without_dots(row):
    return row.replace(r" \cdot ", " ").replace("*", "")


def latex_of(value: Any, notation: Mapping[str, str], sheets: Sequence[Any] = ()) -> str:
    """An answer in LaTeX, numbers with six significant digits, and names in the order of
    ``notation``, which is {name: LaTeX}; ``sheets`` as for :func:`as_drawn`.
    """
    if isinstance(value, Vector):
        inside = list_symbol(latex_of(v, notation, sheets) for v in value)
        return rf"\left[{inside}\right]"
    if isinstance(value, str):
        return latex_text(value)
    if is_numeric(value) or not value.free_symbols:
        return number_symbol(value if isinstance(value, int) else float(value))
    others = sorted({x.name for x in value.free_symbols} - {*notation})
    names = {**notation, **{n: symbol(n) for n in others}}
    return formula_text(as_drawn(simplest(value), sheets), names, latex=True)


def formatted(
    value: Any, names: Iterable[str] = (), sheets: Iterable[Mapping[str, float]] = ()
) -> str:
    """An answer as text, numbers with six significant digits, round-off cleared; a formula with its
    symbols in the order of ``names``; ``sheets`` as for :func:`as_drawn`.
    """
    if isinstance(value, (Vector, tuple, list)):
        size = NOISE * max((abs(float(x)) for x in flat(value) if is_numeric(x)), default=0.0)
        shown = (0 if is_numeric(v) and abs(float(v)) < size else v for v in value)
        return "[" + ", ".join(formatted(v, names, sheets) for v in shown) + "]"
    if isinstance(value, (int, str)):
        return str(value)
    if is_numeric(value) or not value.free_symbols:
        return six_digits(float(value))
    return formula_text(as_drawn(simplest(value), sheets), {n: n for n in names}, latex=False)
