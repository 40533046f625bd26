"""The steps on the way to the answers of a problem: intermediate quantities in order, each with its
unit and meaning.

The code of a problem computes them in ``steps(g)``, {key: value in base units}; texts, units and
equations are under ``steps:`` in its YAML. If they include terms of a sum, or a :class:`Step` with
its own text, it yields them:

    def steps(g):
        ground, arm, rod, D = arm_and_rod(g)
        yield "omega_CD", rod.angular_velocity(ground)
        yield from terms(D.acceleration(ground, via=arm), "a_D", "mm/s^2")

Without ``steps``, they are the terms of those answers that are named sums. ``prove`` may return
steps too, by their keys.
"""

import random
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, replace
from functools import cache
from typing import Any, TypeAlias

from newton_euler.algebra import scalars
from newton_euler.algebra.language import Words
from newton_euler.algebra.ledger import Equation
from newton_euler.algebra.scalars import Scalar
from newton_euler.algebra.units import Dimension, DimensionError, System, unit
from newton_euler.algebra.vectors import Vector
from newton_euler.answers.forms import kind_named
from newton_euler.answers.kinds import KINDS, Kind

from .book_equations import own_number
from .errors import meant
from .model import CatalogueError, Draw, Givens, Problem, Solve
from .variants import drawn_value, flat, symbol_values
from .wording import term_text
from .words import word

SETS = 3  # sets of numbers, to find repeated terms
SAME = 1e-9  # relative


@dataclass(frozen=True)
class Step:
    """An intermediate quantity.

    key : its name, as in a student's notebook: "omega_CD"
    value : a scalar of any kind, a Vector, a matrix as rows; a word or count, or a function for it
    unit : of the stated value; kind : a Kind or its name, needless for a Vector
    means : what it is, as "angular velocity of CD in the ground"
    section, equation : their numbers in the book, or ""
    term : (name, equation of the engine) of a term of a sum
    of : the key of the sum
    of_givens : True if the worked solution finds it from the givens alone, since an earlier
        quantity is equal to it, or to a part of it, by chance
    """

    key: str
    value: object
    unit: str
    means: str
    section: str = ""
    equation: str = ""
    term: tuple[str, Equation] | tuple[()] = ()
    of: str = ""
    kind: Kind = KINDS["number"]
    of_givens: bool = False

    def __post_init__(self) -> None:
        kind = "vector" if isinstance(self.value, Vector) else self.kind
        if isinstance(kind, str):
            object.__setattr__(self, "kind", kind_named(kind))

    @property
    def is_vector(self) -> bool:
        """True if it has components along axes."""
        return isinstance(self.value, Vector)

    @property
    def is_of_its_kind(self) -> bool:
        """True if the value fits the kind."""
        if self.kind.is_word:
            return isinstance(self.value, (str, int)) or callable(self.value)
        return len(flat(self.value)) == self.kind.length and not isinstance(self.value, str)


Steps: TypeAlias = Iterable[Step]  # in the order of the solution
StepsOf: TypeAlias = Callable[[Givens], Steps]
Functions: TypeAlias = tuple[Solve, StepsOf, Solve, Draw]  # solve, steps, prove and draw


def terms(vector: Vector, key: str, stated_in: str, section: str = "", number: str = "") -> Steps:
    """The nonzero named terms of a velocity, an acceleration or another sum as steps
    ``a_D_coriolis`` and so on. ``number``: of the equation, where the chapter's differs from the
    engine's, as (2.25) for (4.18).
    """
    equation = vector.equation
    if equation is None:
        return
    for name, term in vector.terms.items():
        if is_zero(term):
            continue
        plain = "".join(c if c.isalnum() else "_" for c in name).strip("_")
        yield Step(
            f"{key}_{plain if name in equation.terms else f'of_{plain}'}",  # "of_rod", of a frame
            term.expressed_in(vector.frame),
            stated_in,
            "",
            section,
            number or equation.number,
            (name, equation),
            key,
        )


def is_zero(vector: Vector) -> bool:
    """True if all components are the number zero, hence zero for all values."""
    return all(map(scalars.is_zero, vector.c))


def steps(
    p: Problem, values: Mapping[str, Any], one: Any = 1.0, with_all_terms: bool = False
) -> list[Step]:
    """The steps of problem ``p`` for ``values`` in the units of the text, each in its own unit,
    vectors with their frames. ``one`` as for :meth:`Problem.base`; ``with_all_terms`` adds the
    terms of the answers.
    """
    g = p.base(values, one)
    found = listed_steps(p, g)
    if with_all_terms:
        found += further_terms(p, found, p.code.solve(g))
    _check_names(p, found)
    return [_stated(s, p) for s in found]


def listed_steps(p: Problem, g: Givens) -> list[Step]:
    """The steps of ``p`` in base units: those of its code, or the terms of its answers."""
    own = getattr(p.code, "steps", None)
    found = own(g) if own else _terms_of(p, p.code.solve(g))
    computed = found.items() if isinstance(found, dict) else found
    listed = list[Step]()
    for s in (s if isinstance(s, Step) else _with_text(p, *s) for s in computed):
        # the terms of a sum come before it
        listed.insert(next((n for n, x in enumerate(listed) if x.key == s.of), len(listed)), s)
    texts = p.step_texts
    return [replace(s, means=texts.get(s.key, s.means)) for s in listed] if texts else listed


@cache
def repeated(p: Problem) -> frozenset[str]:
    """Steps not asked for in practice: always equal to an answer or, as terms, to another step."""
    rng, always = random.Random(f"steps of {p.id}"), None
    for _ in range(SETS):
        numbers = {n: drawn_value(q, rng) for n, q in p.givens.items()} | symbol_values(p, rng)
        try:
            found = _repeated_at(p, p.base(numbers))
        except (ArithmeticError, ValueError):  # these numbers admit no motion
            continue
        always = found if always is None else always & found
    return always or frozenset()


def _repeated_at(p, g):
    answers = [x for x in p.code.solve(g).values() if isinstance(x, Vector)]
    vectors = [s for s in listed_steps(p, g) if isinstance(s.value, Vector)]
    known, found = [*answers, *(s.value for s in vectors if not s.term)], set()
    for s in vectors:
        if any(_is_same(s.value, x) for x in (known if s.term else answers)):
            found.add(s.key)
        elif s.term:
            known.append(s.value)
    return frozenset(found)


def _is_same(a, b):
    """Whether two vectors have the same components, not all zero."""
    pairs = list(zip(map(float, a.c), map(float, b.c), strict=True))
    size = max(abs(x) for pair in pairs for x in pair)
    return size > 0 and all(abs(x - y) <= SAME * size for x, y in pairs)


def _with_text(p, key, value):
    if key not in p.steps:
        where = f"is computed but not in {p.name}.yaml{meant(key, p.steps)}"
        raise CatalogueError(f"{p.id}: the step {key!r} {where}")
    return Step(key, value, **p.steps[key])


def _stated(step, p):
    """A step in its unit; for a term of a sum, in the words of the problem."""
    value = in_unit(step.value, step.unit, p.system)
    if not step.term:
        return replace(step, value=value)
    means = Words("{term}, in {sum}", term=term_text(*step.term, p), sum=step.of)
    return replace(step, value=value, means=means)


def in_unit(value: Any, stated_in: str, system: System) -> Any:
    """The value of a step in its unit; words and whole numbers have none; functions are called."""
    if isinstance(value, (str, int)) or callable(value):
        return word(value)
    if isinstance(value, (tuple, list)):
        return tuple(in_unit(x, stated_in, system) for x in value)
    return unit(stated_in).from_base(value, system)


def further_terms(p: Problem, listed: Iterable[Step], answers: Mapping[str, Any]) -> list[Step]:
    """The terms of those answers that are sums and have no terms listed yet."""
    shown = {s.of for s in listed}
    sums = {k: x for k, x in answers.items() if is_sum(x, p)}
    return [s for s in _terms_of(p, sums) if s.of not in shown]


def is_sum(answer: Any, p: Problem) -> bool:
    """True if an answer is shown with a table of its terms, by an equation known in its chapter."""
    if not isinstance(answer, Vector) or len(answer.terms) < 2 or answer.equation is None:
        return False
    by_equation = answer.terms.keys() & answer.equation.terms.keys()
    return not by_equation or bool(own_number(answer.equation.number, p))


def _terms_of(p, answers):
    for key, value in answers.items():
        if isinstance(value, Vector) and value.terms:
            yield from terms(value, key, p.answer(key).unit, p.section)


def _check_names(p, found):
    taken = {a.key for a in p.answers} | set(p.units)
    for s in found:
        if not s.key.isidentifier() or s.key in taken:
            raise CatalogueError(
                f"{p.id}: the step {s.key!r} needs a name of its own, of letters, digits "
                "and _, unlike those of givens, answers and other steps"
            )
        taken.add(s.key)


def faults(p: Problem, values: Mapping[str, Scalar]) -> list[str]:
    """The faults of the steps of ``p``, as sentences: in names and dimensions."""
    try:
        computed = {s.key for s in steps(p, values)}
    except CatalogueError as error:
        return [str(error)]
    there = f"is in {p.name}.yaml but not computed"
    wrong = [f"the step {key} {there}" for key in p.steps if key not in computed]
    wrong += [f"the step {key} is an answer" for key in p.steps if key in repeated(p)]
    if not hasattr(p.code, "steps"):
        return wrong
    try:
        found = listed_steps(p, p.dimensions())
    except DimensionError as error:
        return [f"steps adds unlike quantities: {error}"]
    for s in found:
        if not s.is_of_its_kind:
            wrong.append(f"the step {s.key} is not a {s.kind}: name its kind")
        asked = unit(s.unit).dimension
        for x in () if isinstance(s.value, str) or callable(s.value) else flat(s.value):
            if x != asked if isinstance(x, Dimension) else x and any(asked.powers):
                wrong.append(f"the step {s.key} is stated in {s.unit} ({asked}), but has {x}")
    return wrong
