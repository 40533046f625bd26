"""A problem: its givens, its answers, and the code that computes them.

Numbers go in and out in the units of the text; the code of ``p16.py`` sees kg, m, s and rad.
"""

import importlib
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from functools import cached_property
from typing import TYPE_CHECKING, Any, Protocol, TypeAlias, cast

from newton_euler.algebra.late import sympy
from newton_euler.algebra.scalars import Scalar, integer_like, is_numeric, scalar
from newton_euler.algebra.units import SI, System, unit
from newton_euler.answers.forms import Form, kind_named
from newton_euler.answers.kinds import Kind
from newton_euler.answers.notation import symbol
from newton_euler.answers.tolerance import RTOL

from .places import CatalogueError, folder_and_file, home
from .units import in_unit, system_of
from .words import word, words_at

if TYPE_CHECKING:
    from newton_euler.drawing import AnyAxes


@dataclass(frozen=True)
class Chapter:
    """A chapter: the name of its folder, its title, and the text common to its problems."""

    name: str
    title: str
    preamble: str = ""


@dataclass(frozen=True)
class Given:
    """A number that a problem gives; ``vary``: range of its variants, ``latex``: its own symbol."""

    name: str
    value: float
    unit: str
    means: str
    vary: tuple[float, float] | None = None
    figure: bool = False
    latex: str = ""


@dataclass(frozen=True)
class Symbol:
    """A quantity without a number; formulas are compared within ``vary``; ``latex``: its own."""

    name: str
    unit: str
    vary: tuple[float, float]
    latex: str = ""


@dataclass(frozen=True)
class Answer:
    """An answer that a problem asks for.

    kind : a Kind or its name. atol : absolute tolerance, in ``unit``, for a key of zero. weight :
    its share of the points, relative to the other answers. follow_through : the part of its points
    for a wrong answer that follows from the student's own earlier ones. latex : its symbol, where
    that does not follow from the key. rtol : relative tolerance, which a sheet may change. because
    : the reason for a choice, for the worked solution: a sentence that holds for all numbers.
    quantity : "magnitude" or "kinetic energy", which are never negative.
    """

    key: str
    kind: Kind
    unit: str
    means: str
    of: tuple[str, ...] = ()
    atol: float = 1e-6
    weight: float = 1.0
    follow_through: float = 0.0
    latex: str = ""
    rtol: float = RTOL
    because: str = ""
    quantity: str = ""

    def __post_init__(self) -> None:
        if isinstance(self.kind, str):
            object.__setattr__(self, "kind", kind_named(self.kind))

    @cached_property
    def form(self) -> Form:
        """The kind, unit and options of the answer."""
        return Form(self.kind, self.unit, self.of)


class Givens:
    """The numbers of a problem as attributes, in kg, m, s and rad, scalars of any kind:
    ``g.omega``. In a problem with formulas in feet and pounds, in slug, ft, s and rad.
    """

    def __init__(
        self,
        values: dict[str, Scalar],
        units: dict[str, str],
        one: Scalar = 1.0,
        system: System = SI,
    ) -> None:
        self.__dict__.update(values)
        self._values, self._units, self._one, self._system = values, units, one, system

    if TYPE_CHECKING:

        def __getattr__(self, name: str) -> Scalar: ...

    def __repr__(self):
        return f"Givens({self._values!r})"

    @property
    def names(self) -> list[str]:
        """The names of its numbers."""
        return list(self._values)

    def but(self, **changes: Scalar) -> "Givens":
        """A copy with some quantities changed (in base units), for mistakes."""
        unknown = set(changes) - set(self._values)
        if unknown:
            raise CatalogueError(
                f"no given {sorted(unknown)[0]!r}; there are {', '.join(self._values)}"
            )
        return Givens({**self._values, **changes}, self._units, self._one, self._system)

    @property
    def one(self) -> Scalar:
        """The number 1 of the same type as the givens: ``sqrt(3 * g.one)`` has all their digits."""
        kinds = (integer_like(1, x) for x in self._values.values())
        return next((x for x in kinds if type(x) is not int), self._one)

    def stated(self, name: str) -> Scalar:
        """The number as printed, in its own unit: that of a student who forgets to convert."""
        return unit(self._units[name]).from_base(self._values[name], self._system)


# {answer: a scalar, Vector, matrix, pair or word, or a function that returns a word}
Answers: TypeAlias = dict[str, Any]
Mistakes: TypeAlias = dict[str, Answers]  # {mistake: the wrong answers that it gives}
Follows: TypeAlias = dict[str, Callable[..., Any]]  # {later answer: function of g, earlier answers}
Solve: TypeAlias = Callable[[Givens], Answers]  # or prove
Draw: TypeAlias = Callable[[Givens, "AnyAxes"], None]


class Code(Protocol):
    """A problem's code, over scalars of any kind; ``steps(g)`` and ``follows`` are optional."""

    follows: Follows

    def solve(self, g: Givens) -> Answers:
        """The answers, by the engine."""

    def prove(self, g: Givens) -> Answers:
        """The answers, and perhaps steps, in another way."""

    def mistakes(self, g: Givens) -> Mistakes:
        """The wrong answers, by mistake."""

    def draw(self, g: Givens, ax: "AnyAxes") -> None:
        """The figure, if the problem has one."""


@dataclass(frozen=True, eq=False)
class Problem:
    """One problem of the book: its text, its data, and through ``code`` what it computes.

    ``steps`` has unit, means, section and equation of each step, by key. ``checked`` has results by
    hand for the numbers of the book: {key: number, formula as a text, or list of them}.
    ``same_in_book`` names the mistakes that give the right answer for the numbers of the book.
    ``figure`` is empty without a figure. ``step_texts`` has the texts of steps in another language.
    """

    id: str
    title: str
    section: str
    text: str
    figure: str
    givens: dict[str, Given]
    symbols: dict[str, Symbol]
    frame: str
    answers: tuple[Answer, ...]
    mistakes: dict[str, str] = field(default_factory=dict)
    struck: dict[str, str] = field(default_factory=dict)
    steps: dict[str, dict[str, str]] = field(default_factory=dict)
    checked: dict[str, Any] = field(default_factory=dict)
    same_in_book: frozenset[str] = frozenset()
    step_texts: dict[str, str] = field(default_factory=dict)

    @property
    def chapter(self) -> str:
        """The folder and name of its chapter: "ch04"."""
        return folder_and_file(self.id)[0]

    @property
    def name(self) -> str:
        """The name of its files in that folder: "p16"."""
        return folder_and_file(self.id)[1]

    @cached_property
    def code(self) -> Code:
        """The module ``pNN``: ``solve``, ``prove``, ``mistakes``, and ``draw`` for a figure."""
        name = f"exercises.{self.chapter}.{self.name}"
        file = "/".join((home(self.chapter) / f"{self.name}.py").parts[-3:])
        try:
            module = importlib.import_module(name)
        except ModuleNotFoundError as error:
            if error.name not in (name, name.rpartition(".")[0]):
                raise
            raise CatalogueError(
                f"problem {self.id} has a text but no code: write {file}"
            ) from None
        needed = ("solve", "prove", "mistakes", *(("draw",) if self.figure else ()))
        missing = [f for f in needed if not callable(getattr(module, f, None))]
        if missing:
            raise CatalogueError(f"{file} does not define {', '.join(missing)}")
        return cast(Code, module)

    @property
    def symbolic(self) -> bool:
        """True if any answer is a formula in the problem's symbols."""
        return any(a.kind.is_formula for a in self.answers)

    @property
    def has_words(self) -> bool:
        """True if any answer is a word or a count."""
        return any(a.kind.is_word for a in self.answers)

    def answer(self, key: str) -> Answer:
        """The answer asked for under this key."""
        for a in self.answers:
            if a.key == key:
                return a
        raise CatalogueError(
            f"problem {self.id} asks for {', '.join(a.key for a in self.answers)}, not for {key!r}"
        )

    # -- numbers

    @property
    def quantities(self) -> dict[str, Given | Symbol]:
        """What its text states: the givens and the symbols, by name."""
        return {**self.givens, **self.symbols}

    @property
    def units(self) -> dict[str, str]:
        """{given or symbol: its unit}."""
        return {n: q.unit for n, q in self.quantities.items()}

    @cached_property
    def system(self) -> System:
        """The coherent system of units in which the code sees its numbers."""
        return system_of(self.symbols, [*self.units.values(), *(a.unit for a in self.answers)])

    @cached_property
    def notation(self) -> dict[str, str]:
        """{given, symbol or answer: its LaTeX}."""
        asked = {a.key: a.latex or symbol(a.key, a.kind.is_vector) for a in self.answers}
        return asked | {n: q.latex or symbol(n) for n, q in self.quantities.items()}

    @property
    def book_values(self) -> dict[str, float]:
        """The givens of the book, in their units."""
        return {n: g.value for n, g in self.givens.items()}

    def base(self, values: Mapping[str, Scalar], one: Scalar = 1.0) -> Givens:
        """Givens for the code, from ``values`` in the units of the text, which must name every
        given and symbol. ``one`` sets the type of numbers where there are none.
        """
        units = self.units
        missing = [n for n in units if n not in values]
        unknown = [n for n in values if n not in units]
        if missing or unknown:
            what = (
                f"needs {', '.join(missing)}"
                if missing
                else f"has no {', '.join(unknown)}; it has {', '.join(units) or 'no numbers'}"
            )
            raise CatalogueError(f"problem {self.id} {what}")
        given = {n: unit(u).to_base(scalar(values[n]), self.system) for n, u in units.items()}
        return Givens(given, units, one, self.system)

    def dimensions(self) -> Givens:
        """Givens whose values are their dimensions."""
        pure = self.base(dict.fromkeys(self.units, 1.0))
        return pure.but(**{n: unit(u).dimension for n, u in self.units.items()})

    def in_units(self, results: Mapping[str, Any]) -> Answers:
        """Results of the code in the units of the answers; Vectors keep terms, functions stay."""
        form = lambda key: self.answer(key).form
        return {key: in_unit(x, form(key), self.system) for key, x in results.items()}

    def solve(self, values: Mapping[str, Scalar], one: Scalar = 1.0) -> Answers:
        """The answers, by the engine, for ``values`` in the units of the text: {key: number,
        Vector, matrix, pair or word}; ``one`` as for :meth:`base`.
        """
        results = self.code.solve(self.base(values, one))
        asked = [a.key for a in self.answers]
        if not isinstance(results, dict) or list(results) != asked:
            got = ", ".join(results) if isinstance(results, dict) else type(results).__name__
            raise CatalogueError(
                f"solve of {self.id} returns {got}; the problem asks for {', '.join(asked)}"
            )
        (found,) = self._with_words(lambda g: [self.code.solve(g)], [results], values, one)
        return found

    def wrong(self, values: Mapping[str, Scalar], one: Scalar = 1.0) -> Mistakes:
        """The answers by each listed mistake: {mistake: {key: as from :meth:`solve`}}."""
        results = self.code.mistakes(self.base(values, one))
        compute = lambda g: self.code.mistakes(g).values()
        found = self._with_words(compute, results.values(), values, one)
        return dict(zip(results, found, strict=True))

    def _with_words(self, compute, results, values, one):
        """The ``results`` of ``compute(g)``, [{key: answer}], in their units, words evaluated."""
        found = [self.in_units(answers) for answers in results]
        if not self.has_words:
            return found
        if all(is_numeric(x) and not getattr(x, "shape", ()) for x in values.values()):
            return [
                {k: word(x) if self.answer(k).kind.is_word else x for k, x in answers.items()}
                for answers in found
            ]
        words = words_at(self, lambda g: self._words_of(compute(g)), values, one)
        return [
            {k: words.get((n, k), x) for k, x in answers.items()} for n, answers in enumerate(found)
        ]

    def _words_of(self, results):
        return {
            (n, k): x
            for n, answers in enumerate(results)
            for k, x in answers.items()
            if self.answer(k).kind.is_word
        }

    def formulas(self) -> Answers:
        """The answers with SymPy symbols and the book's givens, exact (3/2) for a formula."""
        given = self.book_values
        if self.symbolic:
            given = {n: sympy.Rational(str(x)) for n, x in given.items()}
        return self.solve({**given, **self.sympy_symbols()}, sympy.Integer(1))

    def sympy_symbols(self) -> dict[str, Any]:
        """{symbol: SymPy symbol}, real, or positive if its range is."""

        def ranged(name, low):
            return sympy.Symbol(name, **({"positive": True} if low > 0 else {"real": True}))

        return {n: ranged(n, s.vary[0]) for n, s in self.symbols.items()}
