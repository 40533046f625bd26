"""A problem: what it gives, what it asks for, and the code that computes it.

Its numbers go in and out in the units of its text; the code of ``p16.py`` sees them in kg, m, s and
rad.
"""

import importlib
import re
from dataclasses import dataclass, field
from functools import cached_property

from newton_euler.algebra.scalars import scalar
from newton_euler.algebra.units import unit

from .units import in_unit

KINDS = {
    "number", "vector", "matrix", "expression", "vector_expression", "matrix_expression",
    "interval", "count", "choice",
}  # fmt: skip
SYMBOLIC = {"expression", "vector_expression", "matrix_expression"}


class CatalogueError(ValueError):
    """A problem that does not exist, or whose text, data and code do not fit together."""


def place(problem_id):
    """The folder of a problem number and the name of its files there: "4/16" is ("ch04", "p16"),
    "A/3" is ("appA", "p03").
    """
    found = re.fullmatch(r"([1-9][0-9]*|[AB])/([1-9][0-9]*)", str(problem_id))
    if not found:
        raise CatalogueError(
            f"{problem_id!r} is not a problem number; write chapter and problem, as in 4/16"
        )
    chapter, number = found.groups()
    return f"app{chapter}" if chapter.isalpha() else f"ch{int(chapter):02d}", f"p{int(number):02d}"


@dataclass(frozen=True)
class Chapter:
    """A chapter: the name of its folder, its title, and what holds for all its problems."""

    name: str
    title: str
    preamble: str = ""


@dataclass(frozen=True)
class Given:
    """A number that a problem gives: its value in the book, its unit, and the range that it may be
    drawn from.
    """

    name: str
    value: float
    unit: str
    means: str
    vary: tuple | None = None
    figure: bool = False


@dataclass(frozen=True)
class Symbol:
    """A quantity that a problem names without a number; ``vary`` is where formulas are compared,
    ``unit`` its unit.
    """

    name: str
    unit: str
    vary: tuple


@dataclass(frozen=True)
class Answer:
    """What a problem asks for. ``atol`` is the absolute tolerance, in ``unit``, for a key that is
    zero.
    """

    key: str
    kind: str
    unit: str
    means: str
    of: tuple = ()
    atol: float = 1e-6


class Givens:
    """The numbers of a problem as attributes, in kg, m, s and rad, scalars of any kind:
    ``g.omega``.
    """

    def __init__(self, values, units):
        self.__dict__.update(values)
        self._values, self._units = values, units

    def __repr__(self):
        return f"Givens({self._values!r})"

    def but(self, **changes):
        """The same with some quantities changed (in base units): what a wrong reading of the
        problem uses.
        """
        unknown = set(changes) - set(self._values)
        if unknown:
            raise CatalogueError(
                f"no given {sorted(unknown)[0]!r}; there are {', '.join(self._values)}"
            )
        return Givens({**self._values, **changes}, self._units)

    def stated(self, name):
        """The number of the text in its own unit: what a student uses who forgets to convert."""
        return unit(self._units[name]).from_base(self._values[name])


@dataclass(frozen=True, eq=False)
class Problem:
    """One problem of the book: its text, its data, and through ``code`` what it computes.

    ``checked`` is what was found by hand for the numbers of the book: {key: number, formula as a
    text, or list of them}.
    """

    id: str
    title: str
    section: str
    text: str
    figure: str
    givens: dict
    symbols: dict
    frame: str
    answers: tuple
    mistakes: dict = field(default_factory=dict)
    struck: dict = field(default_factory=dict)
    checked: dict = field(default_factory=dict)

    @property
    def chapter(self):
        """The folder and name of its chapter: "ch04"."""
        return place(self.id)[0]

    @property
    def name(self):
        """The name of its files in that folder: "p16"."""
        return place(self.id)[1]

    @cached_property
    def code(self):
        """The module ``pNN`` with ``solve``, ``prove``, ``mistakes`` and ``draw``."""
        name = f"exercises.{self.chapter}.{self.name}"
        try:
            module = importlib.import_module(name)
        except ModuleNotFoundError as error:
            if error.name not in (name, name.rpartition(".")[0]):
                raise
            raise CatalogueError(
                f"problem {self.id} has a text but no code: write {name.replace('.', '/')}.py"
            ) from None
        missing = [
            f
            for f in ("solve", "prove", "mistakes", "draw")
            if not callable(getattr(module, f, None))
        ]
        if missing:
            raise CatalogueError(
                f"{name.replace('.', '/')}.py does not define {', '.join(missing)}"
            )
        return module

    @property
    def symbolic(self):
        """True if any answer is a formula in the problem's symbols."""
        return any(a.kind in SYMBOLIC for a in self.answers)

    def answer(self, key):
        """The answer asked for under this key."""
        for a in self.answers:
            if a.key == key:
                return a
        raise CatalogueError(
            f"problem {self.id} asks for {', '.join(a.key for a in self.answers)}, not for {key!r}"
        )

    # -- numbers

    @property
    def units(self):
        """Unit of each given and symbol."""
        return {n: q.unit for n, q in (*self.givens.items(), *self.symbols.items())}

    @property
    def book_values(self):
        """The givens of the book, in their units."""
        return {n: g.value for n, g in self.givens.items()}

    def base(self, values):
        """Givens for the code, from ``values`` in the units of the text; it must name every given
        and symbol.
        """
        units = self.units
        missing = [n for n in units if n not in values]
        unknown = [n for n in values if n not in units]
        if missing or unknown:
            what = (
                f"lacks {', '.join(missing)}"
                if missing
                else f"has no {', '.join(unknown)}; it has {', '.join(units) or 'no numbers'}"
            )
            raise CatalogueError(f"problem {self.id} {what}")
        return Givens({n: unit(u).to_base(scalar(values[n])) for n, u in units.items()}, units)

    def in_units(self, results):
        """Results of the code (in base units) in the units of the answers; a Vector stays a Vector
        with its terms.
        """
        return {key: in_unit(value, self.answer(key)) for key, value in results.items()}

    def solve(self, values):
        """The answers, by the engine, for ``values`` in the units of the text: {key: number,
        Vector, matrix, pair or word}.
        """
        results = self.code.solve(self.base(values))
        asked = [a.key for a in self.answers]
        if list(results) != asked:
            raise CatalogueError(
                f"solve of {self.id} returns {', '.join(results)}; the problem asks for "
                f"{', '.join(asked)}"
            )
        return self.in_units(results)

    def formulas(self):
        """The answers with every symbol as a SymPy symbol and the givens of the book as numbers."""
        return self.solve({**self.book_values, **self.sympy_symbols()})

    def sympy_symbols(self):
        """A real SymPy symbol for each symbol of the text."""
        import sympy

        return {n: sympy.Symbol(n, real=True) for n in self.symbols}
