"""What a released sheet asked for, and the points of each part."""

from collections.abc import Mapping
from dataclasses import dataclass
from functools import lru_cache

from exercises.catalogue import Answer, Problem
from newton_euler.algebra.units import unit
from newton_euler.answers.forms import AnswerError, Form


class ScoreError(ValueError):
    """What a course has kept does not fit the exercise: points, weights, or a sheet that asks for
    something else. The message says what to do; no student's answer ever raises it.
    """


@dataclass(frozen=True)
class AskedPart:
    """One answer that a sheet asks for: today's :class:`~exercises.catalogue.Answer`, the form on
    the sheet, what it is worth, the factor from the sheet's unit to today's, and what it is worth
    where it is wrong but follows from the student's own earlier answers.
    """

    answer: Answer
    form: Form
    out_of: float
    factor: float
    following: float = 0.0


def asked_parts(
    problem: Problem,
    points: float | None = None,
    weights: Mapping[str, float] | None = None,
    asked: Mapping[str, str] | None = None,
    follow_through: float | None = None,
) -> list[AskedPart]:
    """The :class:`AskedPart` of each answer to ``problem``, in order.

    points : what all parts are worth together (default: the number of parts)
    weights : {key: weight} where an instructor sets other weights than the exercise
    asked : {key: form} of every part of the released sheet, as "vector, mm/s" (default: as the
        exercise asks today)
    follow_through : the share, from 0 to 1, of what a part is worth that it earns where it is wrong
        but follows from earlier answers (default: as the exercise says for each answer)
    """
    answers, forms = _asked(problem, asked)
    chosen = _weights(problem, answers, weights or {})
    points = len(answers) if points is None else _checked(points, f"the points of {problem.id}")
    whole = sum(chosen.values())
    if follow_through is not None and _checked(follow_through, "follow_through") > 1:
        raise ScoreError(f"follow_through must be a share from 0 to 1, not {follow_through!r}")
    parts = []
    for a in answers:
        out_of = points * chosen[a.key] / whole if whole else 0.0
        share = a.follow_through if follow_through is None else follow_through
        factor = _factor(problem, a, forms[a.key])
        parts.append(AskedPart(a, forms[a.key], out_of, factor, share * out_of))
    return parts


_read = lru_cache(1000)(Form.read)  # the same for all students


def _asked(problem, asked):
    if asked is None:
        return problem.answers, {a.key: a.form for a in problem.answers}
    today = {a.key: a for a in problem.answers}
    for key in asked:
        if key not in today:
            raise ScoreError(
                f"the sheet asks for {key} in {problem.id}; today's exercise asks for "
                f"{', '.join(today)}. Put {key} back into {problem.name}.yaml and {problem.name}.py"
                ", or grade with the version of the exercises that the sheet was made with"
            )
    forms = {key: _form(problem, key, text) for key, text in asked.items()}
    return [today[key] for key in forms], forms


def _form(problem, key, text):
    try:
        return _read(text)
    except AnswerError as error:
        raise ScoreError(f"the form of {key} on the sheet of {problem.id}: {error}") from error


@lru_cache(10_000)
def _factor(problem, answer, form):
    """The factor from the unit on the sheet to that of today's exercise."""
    if (form.kind, form.unit) == (answer.kind, answer.unit):
        return 1.0
    change = f"{problem.id} asks for {answer.key} as {answer.form!s}"
    if form.kind != answer.kind:
        raise ScoreError(
            f"the sheet asks for {answer.key} as {form!s}, today's {change}: the kinds of answer "
            "cannot be compared. Grade with the version of the exercises that the sheet was made "
            "with"
        )
    there, here = unit(form.unit), unit(answer.unit)
    if there.dimension != here.dimension:
        raise ScoreError(
            f"the sheet asks for {answer.key} in {form.unit}, today's {change}: these units differ "
            "in dimension. Grade with the version of the exercises that the sheet was made with"
        )
    return here.from_base(there.to_base(1.0))


def _weights(problem, answers, weights):
    keys = [a.key for a in answers]
    for key in weights:
        if key not in keys:
            raise ScoreError(
                f"there is a weight for {key} in {problem.id}, which does not ask for it; it asks "
                f"for {', '.join(keys)}"
            )
    return {
        a.key: _checked(weights.get(a.key, a.weight), f"the weight of {a.key} in {problem.id}")
        for a in answers
    }


def _checked(x, what):
    good = isinstance(x, (int, float)) and not isinstance(x, bool)
    if not good or not 0 <= x < 1e300:
        raise ScoreError(f"{what} must be a number, 0 or more, not {x!r}")
    return x
