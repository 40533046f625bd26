"""The wrong models of a problem, computed: its listed mistakes, and those that can be made in any
problem (a term left out or turned, degrees for radians, axes of another frame).
"""

import warnings
from collections.abc import Callable, Mapping
from dataclasses import replace
from typing import Any

from exercises.catalogue.model import Givens, Problem
from exercises.catalogue.steps import listed_steps
from exercises.catalogue.variants import flat
from exercises.catalogue.wording import body_text, named_in_text, term_text
from newton_euler.algebra.language import Words
from newton_euler.algebra.trace import Step
from newton_euler.algebra.units import unit
from newton_euler.algebra.vectors import Vector
from newton_euler.answers import causes
from newton_euler.answers.causes import Cause
from newton_euler.kinematics import AngleWarning

from .computation import section, sizes_of


def wrong_models(problem: Problem, values: Mapping[str, Any]) -> list[tuple[str, Cause, Any]]:
    """[(answer, cause, numbers)] of every wrong model, for ``values`` in the units of the text.
    Those of words and counts are not traced; they are found separately.
    """
    g = problem.base(values)
    right = problem.in_units(problem.code.solve(g))
    found = []
    for name, answers in problem.code.mistakes(g).items():
        for key, x in problem.in_units(answers).items():
            found.append((key, causes.listed(name, problem.mistakes[name]), flat(x)))
    found += general_models(problem, g, right, lambda g: problem.in_units(problem.code.solve(g)))
    return _matched([model for model in found if not problem.answer(model[0]).kind.is_word])


def _matched(models):
    """The models. A general one that is traced to the very steps of a listed mistake is this
    mistake in other words: it gets its name as subject, and gives it its place in the book.
    """
    by_steps = {(key, cause.group == "listed", _steps(x)): cause for key, cause, x in models}
    found = []
    for key, cause, x in models:
        is_listed, steps = cause.group == "listed", _steps(x)
        if steps and (twin := by_steps.get((key, not is_listed, steps))):
            cause = _placed(cause, twin) if is_listed else replace(cause, subject=twin.name)
        found.append((key, cause, x))
    return found


def _placed(cause, twin):
    """The cause with its twin's place in the book, if the twin is not named beside it and there is
    room.
    """
    there = cause.at(twin.where)
    has_room = cause.why in (causes.sentence([there]) or "")
    return there if has_room and twin.does != causes.REVERSED else cause


def _steps(components):
    """A key for traced numbers; () for others."""
    is_traced = any(isinstance(x, Step) for x in components)
    return tuple(getattr(x, "number", x) for x in components) if is_traced else ()


def _of_sizes(problem, g, right):
    """The mistakes in the terms of a vector, of which the size is asked for."""
    sizes = {key: step for key, step in sizes_of(problem).items() if key in right}
    steps = {s.key: s.value for s in listed_steps(problem, g)} if sizes else {}
    for key, step in sizes.items():
        for cause, wrong in _terms(steps[step], problem):
            yield key, cause, flat(problem.in_units({key: wrong.norm()})[key])


def general_models(
    problem: Problem,
    g: Givens,
    right: Mapping[str, Any],
    compute: Callable[[Givens], Mapping[str, Any]],
) -> list[tuple[str, Cause, tuple[Any, ...]]]:
    """The wrong models that need no list, as in :func:`wrong_models`, of the quantities ``right``,
    which are ``compute(g)``, {key: value in its unit}.
    """
    found = []
    for key, x in right.items():
        if isinstance(x, Vector):
            models = (*_terms(x, problem), *_rates(x), *_frames(x, problem))
            found += [(key, cause, flat(wrong)) for cause, wrong in models]
    found += _of_sizes(problem, g, right)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", AngleWarning)  # degrees for radians are intended here
        for cause, changes in _units(problem, g):
            found += [(key, cause, flat(x)) for key, x in compute(g.but(**changes)).items()]
    return found


def _terms(right, problem):
    """A named term of the key left out or reversed; the Coriolis term without its factor 2."""
    where = _where(right, problem)
    for name in right.terms or ():
        term = term_text(name, right.equation, problem)
        yield causes.term_left_out(name, term).at(where), right.reweighted(**{name: 0})
        yield causes.term_reversed(name, term).at(where), right.reweighted(**{name: -1})
    # spherical components have three Coriolis terms
    known = right.terms.keys() & right.equation.terms if right.terms else ()
    halved = {name: 0.5 for name in known if name.startswith("coriolis")}
    if halved:
        yield causes.CORIOLIS_HALVED.at(where), right.reweighted(**halved)


def _where(right, problem):
    """The equation of a sum, if it is one of the chapter of the problem."""
    number, own = right.equation.number if right.equation else "", problem.section
    in_chapter = number.partition(".")[0] == own.partition(".")[0]
    if not (number and in_chapter):
        return ""
    return Words("{section}, ({equation})", section=section(own), equation=number)


def _rates(right):
    """The rates of turning whose sum is an angular velocity."""
    if right.terms and right.equation.kind == "angular velocity":
        for name, term in right.terms.items():
            yield causes.rate(name), term.expressed_in(right.frame)


def _units(problem, g):
    """Givens used with their number in degrees or revolutions, without conversion."""
    for name, quantity in problem.givens.items():
        if unit(quantity.unit).is_of_turning:
            yield causes.unconverted(name, quantity.unit), {name: g.stated(name)}


def _frames(right, problem):
    """Components along the axes of other frames, and those turned the wrong way."""
    for place, frame in enumerate(right.frame.tree):
        if frame is right.frame:
            continue
        known = named_in_text(frame.name, problem) and not frame.name.startswith("about ")
        name = body_text(frame.name) if known else Words("another frame")
        yield causes.other_axes(place, name), right.components(frame)
        turned = Vector(right.c, frame).components(right.frame)
        yield causes.turned_the_wrong_way(place, name), turned
