"""The numbers of one student's problem: the key, and the answers that wrong models give.

What a problem computes is traced once into straight-line text, so that the numbers of a student
cost microseconds. Answers are tuples of points, as in :mod:`newton_euler.answers`.
"""

import contextlib
from collections.abc import Mapping, Sequence
from functools import cache, cached_property
from itertools import islice
from typing import Any

import numpy as np

from exercises.catalogue import Problem
from exercises.catalogue.following import earlier_answers, follow
from exercises.catalogue.model import Answer
from exercises.catalogue.variants import POINTS, as_points, flat, symbol_points, traced
from newton_euler.algebra.language import cached_by_language
from newton_euler.answers.causes import Cause, listed
from newton_euler.answers.near import NO_SLIPS, Slips
from newton_euler.answers.tolerance import Points
from newton_euler.answers.verdicts import Way
from newton_euler.dynamics.constraints import Freedom

from . import computation
from .miscounts import miscounts, misjudged
from .sheet import ScoreError
from .wrong_models import wrong_models


class Numbers:
    """Key and wrong answers of ``problem`` for a student's ``values``, as the
    :class:`~newton_euler.answers.verdicts.Numbers` that scoring uses. ``earlier_sheets``: the
    values of the student's earlier sheets.
    """

    def __init__(
        self,
        problem: Problem,
        values: Mapping[str, float],
        earlier_sheets: Sequence[Mapping[str, float]] = (),
    ):
        self.problem, self.sample = problem, _sample(problem, values)
        self._earlier_sheets = earlier_sheets
        self._wrong: dict[str, list[tuple[Cause, Points]]] = {}

    @property
    def answers(self) -> Sequence[Answer]:
        """What the problem asks for."""
        return self.problem.answers

    @property
    def earlier(self) -> Mapping[str, Sequence[str]]:
        """{later answer: names of the earlier ones from which it follows}."""
        return computation.earlier_of(self.problem)

    @property
    def symbols(self) -> Mapping[str, Any]:
        """The points of each symbol, as arrays."""
        return {n: self.sample[n] for n in self.problem.symbols}

    @cached_property
    def key(self) -> dict[str, Points]:
        """{answer: points} of the right answers; of a word or count, ((word,),)."""
        found = _run_key(self.problem, self.sample)
        answers = self.problem.answers
        return {
            a.key: ((_one_word(a, x),),) if a.kind.is_word else points_of(a, x)
            for a, x in zip(answers, found, strict=True)
        }

    def wrong(self, key: str) -> list[tuple[Cause, Points]]:
        """[(cause, points)] of every wrong model of the answer ``key``."""
        answer = self.problem.answer(key)
        if key not in self._wrong and answer.kind.is_word:
            self._wrong[key] = self._wrong_words(answer)
        elif key not in self._wrong:
            labels, found = self._models
            self._wrong[key] = [
                (cause, points_of(answer, x))
                for (other, cause), x in zip(labels, found, strict=True)
                if other == key
            ]
        return self._wrong[key]

    def _wrong_words(self, answer):
        """As :meth:`wrong`, for a word or count: also degrees of freedom counted wrongly."""
        given = {m: x[answer.key] for m, x in self._wrong_answers.items() if answer.key in x}
        found = [
            (listed(m, self.problem.mistakes[m]), ((_one_word(answer, (x,)),),))
            for m, x in given.items()
        ]
        right = self.problem.code.solve(self.problem.base(self.sample))[answer.key]
        if isinstance(right, Freedom):
            counts = {n for _, ((n,),) in found}
            found += [(cause, ((n,),)) for cause, n in miscounts(right, counts)]
        right = self.key[answer.key][0][0]
        found += [(cause, ((w,),)) for cause, w in misjudged(answer.key, answer.of, right)]
        return found

    @cached_property
    def _wrong_answers(self):
        with np.errstate(all="ignore"):
            return self.problem.wrong(self.sample)

    @cached_property
    def _models(self):
        return _run_wrong(self.problem, self.sample)

    @cached_property
    def book(self) -> Mapping[str, Points]:
        """{answer: points} for the book's numbers; {} if the student has these."""
        same = all(self.sample[n] == value for n, value in self.problem.book_values.items())
        return {} if same else _of_book(self.problem)

    @cached_property
    def sheets(self) -> list[dict[str, Points]]:
        """[{answer: points}] for the numbers of earlier sheets."""
        return [Numbers(self.problem, values).key for values in self._earlier_sheets]

    @property
    def where(self) -> str:
        """The section that the problem practises."""
        return computation.section(self.problem.section)

    @cached_property
    def slips(self) -> Slips:
        """The slips in the computation of the answers."""
        return computation.perturbed(self.problem, self.sample)

    def sequel(self, key: str, earlier: Mapping[str, Points]) -> Slips:
        """The slips in computing ``key`` from a student's ``earlier`` answers, {answer: points}."""
        if not earlier or any(self.problem.answer(n).kind.is_word for n in (key, *earlier)):
            return NO_SLIPS
        written = key in earlier_answers(self.problem)
        if not written and all(self._is_right(*x) for x in earlier.items()):
            return NO_SLIPS  # the same as from the givens
        return computation.perturbed_sequel(self.problem, key, self.sample, earlier)

    def _is_right(self, key, points):
        a = self.problem.answer(key)
        return a.kind.is_right(points, self.key[key], a.atol, a.rtol)

    def following(self, key: str, earlier: Mapping[str, Points]) -> Points | None:
        """The points of the answer ``key`` that follows from a student's ``earlier`` answers,
        {answer: points}; None if there is no such answer.
        """
        written = key in earlier_answers(self.problem)
        return self._points(key, self._as_written if written else self._as_computed, earlier)

    def other_ways(self, key: str) -> Sequence[Way]:
        """The way of the computation, where the problem's own ``follows`` takes another."""
        names = computation.computed_from(self.problem).get(key)
        if names is None or key not in earlier_answers(self.problem):
            return ()
        return ((names, lambda earlier: self._points(key, self._as_computed, earlier)),)

    def _points(self, key, way, earlier):
        try:
            with np.errstate(all="ignore"):
                return points_of(self.problem.answer(key), way(key, earlier))
        except (ArithmeticError, ValueError):  # the student's number may give no value
            return None

    def _as_computed(self, key, earlier):
        run = computation.sequel_of(self.problem, key)
        return run({**self.sample, **computation.columns(self.problem, earlier)})

    def _as_written(self, key, earlier):
        numbers = [x for name in self.earlier[key] for x in _columns(earlier[name])]
        follow = _traced_following(self.problem, key)
        if self.problem.answer(key).kind.is_word:  # code that branches is called at every point
            rows = np.broadcast_arrays(*self.sample.values(), *numbers)
            at_points = zip(*(np.ravel(x).tolist() for x in rows), strict=True)
            (word,) = {follow(*point) for point in at_points}  # ValueError if there are several
            return word
        return follow(*self.sample.values(), *numbers)


def numbers_of(
    problem: Problem,
    values: Mapping[str, float],
    earlier_sheets: Sequence[Mapping[str, float]] = (),
) -> Numbers:
    """The :class:`Numbers` of a problem; those of a problem without givens are the same for all."""
    if not problem.givens:
        return _without_givens(problem)
    return Numbers(problem, values, earlier_sheets)


@cached_by_language
def _without_givens(problem):
    return Numbers(problem, {})


@cached_by_language
def _of_book(problem):
    return Numbers(problem, problem.book_values).key


def _sample(problem, values):
    """The values of givens, and of symbols the seeded points, the same for all students."""
    missing = [n for n in problem.givens if n not in values]
    if missing:
        raise ScoreError(
            f"the sheet has no number for {', '.join(missing)}, which problem {problem.id} gives "
            "today. Grade with the version of the exercises that the sheet was made with"
        )
    return {**{n: float(values[n]) for n in problem.givens}, **symbol_points(problem)}


def points_of(answer: Answer, components: Sequence[Any]) -> Points:
    """The points of an answer: one for a number, even in a problem with symbols."""
    if not answer.kind.is_formula:
        return as_points(components)[:1]
    points = as_points(components)
    return points * POINTS if len(points) == 1 else points  # a formula without symbols, as 0


def _one_word(answer, found):
    """The word or count, which is the same at all points."""
    words = {x for part in found for x in np.atleast_1d(part).tolist()}
    if len(words) != 1:
        raise ScoreError(
            f"the {answer.kind} {answer.key} depends on the symbols: {', '.join(map(str, words))}; "
            "give the symbols ranges in which it is the same everywhere"
        )
    return words.pop()


def _key_formula(problem, values):
    answers = problem.solve(values)
    return tuple(flat(answers[a.key]) for a in problem.answers)


@cache
def _traced_key(problem):
    return traced(problem, _key_formula)


def _run_key(problem, sample):
    run = _traced_key(problem)
    with np.errstate(all="ignore"):
        return run(**sample) if run else _key_formula(problem, sample)


@cached_by_language
def _traced_wrong(p):
    """(labels, formula) of the wrong models; the labels are filled when the formula is traced."""
    labels = []

    def formula(problem, values):
        models = wrong_models(problem, values)
        labels[:] = [model[:2] for model in models]
        return tuple(numbers for *_, numbers in models)

    return labels, traced(p, formula)


def _run_wrong(problem, sample):
    # arrays have nan where floats raise, as at the root of a negative number
    for values in (sample, {n: np.atleast_1d(x) for n, x in sample.items()}):
        with contextlib.suppress(ArithmeticError, ValueError), np.errstate(all="ignore"):
            return _wrong_at(problem, values)
    return [], []  # a wrong model has no value, not even nan, so none is compared


def _wrong_at(problem, values):
    labels, run = _traced_wrong(problem)
    if run:
        return labels, run(**values)
    models = wrong_models(problem, values)
    return [model[:2] for model in models], [numbers for *_, numbers in models]


@cache
def _traced_following(p, key):
    """``follows`` of one answer, called with the values and the components of earlier answers."""
    counts = {name: p.answer(name).kind.length for name in earlier_answers(p)[key]}
    names = [f"{name}_{n}_" for name, count in counts.items() for n in range(count)]

    def formula(problem, values):
        numbers = iter([values[name] for name in names])
        earlier = {name: tuple(islice(numbers, count)) for name, count in counts.items()}
        return follow(problem, key, {n: values[n] for n in problem.units}, earlier)

    def untraced(*numbers):
        return formula(p, dict(zip((*p.units, *names), numbers, strict=True)))

    return traced(p, formula, names) or untraced


def _columns(points):
    """The components of an answer from its points: floats, or arrays of several points."""
    return points[0] if len(points) == 1 else tuple(np.array(points).T)
