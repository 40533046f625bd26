"""The steps on the way to the answers of a problem: intermediate quantities in their order, each
with its unit and the sentence that introduces it.

The code of a problem computes them in ``steps(g)``, {key: value in base units}; their texts, units
and equations stand under ``steps:`` in its YAML. With terms of a sum among them, or a :class:`Step`
that brings its own text, it yields them:

    def steps(g):
        ground, arm, rod, D = arm_and_rod(g)
        yield "omega_CD", rod.angular_velocity(ground)
        yield from terms(D.acceleration(ground, via=arm), "a_D", "mm/s^2")

A problem without ``steps`` has the terms of its answers that are named sums. ``prove`` may return
steps too, by their keys, found by its own way.
"""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from typing import Any

from newton_euler.algebra.scalars import Scalar, is_numeric, to_plain
from newton_euler.algebra.units import Dimension, DimensionError, System, unit
from newton_euler.algebra.vectors import Vector

from .model import CatalogueError, Givens, Problem
from .variants import flat
from .wording import term_text
from .words import word


@dataclass(frozen=True)
class Step:
    """An intermediate quantity.

    key : its name, as in a student's notebook: "omega_CD"
    value : a scalar of any kind, a Vector, a matrix as rows; a word or count, or a function for it
    unit : in which it is stated
    means : what it is, as "angular velocity of CD in the ground"
    section, equation : of the book, where it is found and by which equation; "" where there is none
    term : (name, equation of the engine) of a term of a sum
    of : the key of this sum
    """

    key: str
    value: object
    unit: str
    means: str
    section: str = ""
    equation: str = ""
    term: tuple = ()
    of: str = ""

    @property
    def is_vector(self) -> bool:
        """True if it has components."""
        return isinstance(self.value, Vector)


def terms(
    vector: Vector, key: str, stated_in: str, section: str = "", number: str = ""
) -> Iterator[Step]:
    """The named terms of a velocity, an acceleration or another sum as steps: of ``a_D`` the steps
    ``a_D_coriolis`` and so on. Terms that are zero are left out. ``number``: of the equation, where
    the chapter numbers it differently from the engine, as (2.25) for (4.18).
    """
    equation = vector.equation
    if equation is None:
        return
    for name, term in vector.terms.items():
        if is_zero(term):
            continue
        yield Step(
            f"{key}_{_identifier(name, equation)}",
            term.expressed_in(vector.frame),
            stated_in,
            "",
            section,
            number or equation.number,
            (name, equation),
            key,
        )


def is_zero(vector: Vector) -> bool:
    """True if all components are the number zero, and not only for some values."""
    return all(is_numeric(x) and x == 0 for x in map(to_plain, vector.c))


def _identifier(name, equation):
    """The name of a term as part of a Python name: "coriolis"; "of_rod", after a frame."""
    plain = "".join(c if c.isalnum() else "_" for c in name).strip("_")
    return plain if name in equation.terms else f"of_{plain}"


def steps(p, values, one=1.0):
    """The steps of problem ``p`` for ``values`` in the units of the text, each in its own unit; a
    vector stays one, with its frame. ``one`` as for :meth:`Problem.base`.
    """
    g = p.base(values, one)
    found = listed_steps(p, g)
    _check_names(p, found)
    return [_stated(s, p) for s in found]


def listed_steps(p: Problem, g: Givens) -> list[Step]:
    """The steps of ``p`` for givens ``g`` of any kind, in base units: those that its code lists, or
    the terms of its answers.
    """
    own = getattr(p.code, "steps", None)
    found = own(g) if own else _from_answers(p, g)
    computed = found.items() if isinstance(found, dict) else found
    return [s if isinstance(s, Step) else _with_text(p, *s) for s in computed]


def _with_text(p, key, value):
    if key not in p.steps:
        raise CatalogueError(f"{p.id}: the step {key!r} is computed but not in {p.name}.yaml")
    return Step(key, value, **p.steps[key])


def _stated(step, p):
    """A step in its unit, a term of a sum in the words of the problem."""
    value = in_unit(step.value, step.unit, p.system)
    if not step.term:
        return replace(step, value=value)
    return replace(step, value=value, means=f"{term_text(*step.term, p)}, in {step.of}")


def in_unit(value: Any, stated_in: str, system: System) -> Any:
    """The value of a step in its unit; a whole number, a word, or what a function gives that waits
    for numbers, is itself.
    """
    if isinstance(value, (str, int)) or callable(value):
        return word(value)
    if isinstance(value, (tuple, list)):
        return tuple(in_unit(x, stated_in, system) for x in value)
    return unit(stated_in).from_base(value, system)


def _from_answers(p, g):
    for key, value in p.code.solve(g).items():
        if isinstance(value, Vector) and value.terms:
            yield from terms(value, key, p.answer(key).unit, p.section)


def _check_names(p, found):
    taken = {a.key for a in p.answers} | set(p.units)
    for s in found:
        if not s.key.isidentifier() or s.key in taken:
            raise CatalogueError(
                f"{p.id}: the step {s.key!r} must have a name of its own, of letters, digits "
                "and _; givens, answers and other steps have other names"
            )
        taken.add(s.key)


def faults(p: Problem, values: Mapping[str, Scalar]) -> list[str]:
    """What is wrong with the steps of ``p``, as sentences: their names, and their dimensions."""
    try:
        computed = {s.key for s in steps(p, values)}
    except CatalogueError as error:
        return [str(error)]
    wrong = [
        f"the step {key} is in {p.name}.yaml but not computed"
        for key in p.steps
        if key not in computed
    ]
    if not hasattr(p.code, "steps"):
        return wrong
    try:
        found = listed_steps(p, p.dimensions())
    except DimensionError as error:
        return [f"steps adds unlike quantities: {error}"]
    for s in found:
        asked = unit(s.unit).dimension
        for x in () if isinstance(s.value, str) or callable(s.value) else flat(s.value):
            if x != asked if isinstance(x, Dimension) else x and any(asked.powers):
                wrong.append(
                    f"the step {s.key} is stated in {s.unit}, that is {asked}, and has {x}"
                )
    return wrong
