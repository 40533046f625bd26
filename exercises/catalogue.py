"""The catalogue: every problem's text, data and code, checked when it is read.

``problem("4/16")`` is a :class:`Problem`. Its numbers go in and out in the units of its text; the code of ``p16.py`` sees them in kg, m, s and rad.
"""

import importlib
from dataclasses import dataclass, field
from functools import cache, cached_property
from pathlib import Path

import yaml

from newton_euler.scalars import ZERO, scalar
from newton_euler.units import unit
from newton_euler.vectors import Vector

HERE = Path(__file__).parent
KINDS = {
    "number", "vector", "matrix", "expression", "vector_expression", "matrix_expression", "interval", "count", "choice",
}  # fmt: skip
SYMBOLIC = {"expression", "vector_expression", "matrix_expression"}


class CatalogueError(ValueError):
    """A problem that does not exist, or whose text, data and code do not fit together."""


@dataclass(frozen=True)
class Given:
    """A number that a problem gives: its value in the book, its unit, and the range that it may be drawn from."""

    name: str
    value: float
    unit: str
    means: str
    vary: tuple | None = None
    figure: bool = False


@dataclass(frozen=True)
class Symbol:
    """A quantity that a problem names without a number; ``vary`` is where formulas are compared, ``unit`` its unit."""

    name: str
    unit: str
    vary: tuple


@dataclass(frozen=True)
class Answer:
    """What a problem asks for. ``atol`` is the absolute tolerance, in ``unit``, for a key that is zero."""

    key: str
    kind: str
    unit: str
    means: str
    of: tuple = ()
    atol: float = 1e-6


class Givens:
    """The numbers of a problem as attributes, in kg, m, s and rad, scalars of any kind: ``g.omega``."""

    def __init__(self, values, units):
        self.__dict__.update(values)
        self._values, self._units = values, units

    def __repr__(self):
        return f"Givens({self._values!r})"

    def but(self, **changes):
        """The same with some quantities changed (in base units): what a wrong reading of the problem uses."""
        unknown = set(changes) - set(self._values)
        if unknown:
            raise CatalogueError(f"no given {sorted(unknown)[0]!r}; there are {', '.join(self._values)}")
        return Givens({**self._values, **changes}, self._units)

    def stated(self, name):
        """The bare number of the text, in its own unit: what a student uses who forgets to convert."""
        return unit(self._units[name]).from_base(self._values[name])


@dataclass(frozen=True, eq=False)
class Problem:
    """One problem of the book: its text, its data, and through ``code`` what it computes."""

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

    @property
    def chapter(self):
        """The folder and name of its chapter: "ch04"."""
        return folder(self.id)

    @cached_property
    def code(self):
        """The module ``pNN`` with ``solve``, ``prove``, ``mistakes`` and ``draw``."""
        name = f"exercises.{self.chapter}.p{int(self.id.partition('/')[2]):02d}"
        try:
            module = importlib.import_module(name)
        except ModuleNotFoundError as error:
            if error.name not in (name, name.rpartition(".")[0]):
                raise
            raise CatalogueError(f"problem {self.id} has a text but no code: write {name.replace('.', '/')}.py") from None
        missing = [f for f in ("solve", "prove", "mistakes", "draw") if not callable(getattr(module, f, None))]
        if missing:
            raise CatalogueError(f"{name.replace('.', '/')}.py does not define {', '.join(missing)}")
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
        raise CatalogueError(f"problem {self.id} asks for {', '.join(a.key for a in self.answers)}, not for {key!r}")

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
        """Givens for the code, from ``values`` in the units of the text; it must name every given and symbol."""
        units = self.units
        missing = [n for n in units if n not in values]
        unknown = [n for n in values if n not in units]
        if missing or unknown:
            what = f"lacks {', '.join(missing)}" if missing else f"has no {', '.join(unknown)}; it has {', '.join(units) or 'no numbers'}"
            raise CatalogueError(f"problem {self.id} {what}")
        return Givens({n: unit(u).to_base(scalar(values[n])) for n, u in units.items()}, units)

    def in_units(self, results):
        """Results of the code (in base units) in the units of the answers; a Vector stays a Vector with its terms."""
        return {key: _in_unit(value, self.answer(key)) for key, value in results.items()}

    def solve(self, values):
        """The answers, by the engine, for ``values`` in the units of the text: {key: number, Vector, matrix, pair or word}."""
        results = self.code.solve(self.base(values))
        asked = [a.key for a in self.answers]
        if list(results) != asked:
            raise CatalogueError(f"solve of {self.id} returns {', '.join(results)}; the problem asks for {', '.join(asked)}")
        return self.in_units(results)

    def formulas(self):
        """The answers with every symbol as a SymPy symbol and the givens of the book as numbers."""
        return self.solve({**self.book_values, **self.sympy_symbols()})

    def sympy_symbols(self):
        """A real SymPy symbol for each symbol of the text."""
        import sympy

        return {n: sympy.Symbol(n, real=True) for n in self.symbols}


def _in_unit(value, answer):
    if answer.kind in ("count", "choice"):
        return value
    if isinstance(value, (tuple, list)):
        return tuple(_in_unit(v, answer) for v in value)
    if isinstance(value, Vector):
        return unit(answer.unit).from_base(value)
    value = scalar(value)
    return 0 if value is ZERO else unit(answer.unit).from_base(value)


# -- reading


def folder(problem_id):
    """The chapter folder of a problem number: "4/16" is in "ch04", "A/3" in "appA"."""
    chapter, _, number = str(problem_id).partition("/")
    if number.isdigit() and chapter.isdigit():
        return f"ch{int(chapter):02d}"
    if number.isdigit() and chapter in ("A", "B"):
        return f"app{chapter}"
    raise CatalogueError(f"{problem_id!r} is not a problem number; write chapter and problem, as in 4/16")


@cache
def chapters():
    """The names of the chapters that have problems here."""
    return tuple(sorted(p.parent.name for p in HERE.glob("*/problems.yaml")))


@cache
def problems(chapter):
    """All problems of a chapter, in the order of the book: ``problems("ch04")``."""
    path = HERE / chapter / "problems.yaml"
    if not path.exists():
        raise CatalogueError(f"there is no chapter {chapter!r}; there are {', '.join(chapters())}")
    loader = getattr(yaml, "CSafeLoader", yaml.SafeLoader)  # the C parser reads a chapter 10 times faster
    try:
        entries = yaml.load(path.read_text(encoding="utf-8"), loader)
    except yaml.YAMLError as error:
        raise CatalogueError(f"{chapter}/problems.yaml is not YAML: {error}") from error
    found = [_read(entry, path) for entry in entries]
    numbers = [p.id for p in found]
    if len(set(numbers)) != len(numbers):
        raise CatalogueError(f"{path.parent.name}/problems.yaml has the same problem twice: {sorted(n for n in numbers if numbers.count(n) > 1)[0]}")
    return tuple(found)


def problem(problem_id):
    """The problem with this number: ``problem("4/16")``."""
    chapter = folder(problem_id)
    if chapter in chapters():
        for p in problems(chapter):
            if p.id == problem_id:
                return p
        last = problems(chapter)[-1].id
        raise CatalogueError(f"there is no problem {problem_id}; {chapter} has {problems(chapter)[0].id} to {last}")
    raise CatalogueError(f"there is no problem {problem_id}: the chapters with problems are {', '.join(chapters())}")


def select(names):
    """The problems that ``names`` stand for: problem numbers, chapter names, or "all"."""
    chosen = []
    for name in names:
        if name == "all":
            chosen += [p for c in chapters() for p in problems(c)]
        elif "/" in name:
            chosen.append(problem(name))
        else:
            chosen += problems(name)
    return list(dict.fromkeys(chosen))


_ANGLES = {"rad": (0.25, 1.1), "deg": (15, 65)}


def _read(entry, path):
    where = f"{path.parent.name}/problems.yaml, problem {entry.get('id', '?')}"
    try:
        return Problem(
            id=entry["id"],
            title=entry["title"],
            section=str(entry["section"]),
            text=" ".join(entry["text"].split()),
            figure=" ".join(entry["figure"].split()),
            givens={n: _read_given(n, g) for n, g in (entry.get("givens") or {}).items()},
            symbols={n: _read_symbol(n, s) for n, s in (entry.get("symbols") or {}).items()},
            frame=" ".join(entry.get("frame", "").split()),
            answers=tuple(_read_answer(a) for a in entry["answers"]),
            mistakes=entry.get("mistakes") or {},
            struck=entry.get("struck") or {},
        )
    except (KeyError, TypeError, ValueError, AttributeError) as error:
        raise CatalogueError(f"{where}: {error!r}") from error


def _read_given(name, g):
    vary = tuple(g["vary"]) if "vary" in g else None
    unit(g["unit"])
    if vary and not vary[0] < vary[1]:
        raise ValueError(f"{name}: vary must be [low, high], got {vary}")
    return Given(name, g["value"], g["unit"], g["means"], vary, g.get("figure", False))


def _read_symbol(name, s):
    s = s if isinstance(s, dict) else {"unit": s}
    unit(s["unit"])
    return Symbol(name, s["unit"], tuple(s.get("vary", _ANGLES.get(s["unit"], (0.6, 1.9)))))


def _read_answer(a):
    if a["kind"] not in KINDS:
        raise ValueError(f"kind {a['kind']!r} is none of {', '.join(sorted(KINDS))}")
    unit(a.get("unit", "1"))
    return Answer(a["key"], a["kind"], a.get("unit", "1"), a["means"], tuple(a.get("of", ())), float(a.get("atol", 1e-6)))
