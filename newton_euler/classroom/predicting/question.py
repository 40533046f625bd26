"""A question to predict, and what a prediction means."""

import math
from collections.abc import Mapping
from dataclasses import dataclass

from ...algebra.errors import ArgumentError
from ...algebra.language import _
from ...answers.forms import AnswerError
from ..practising.typed import typed

LETTERS = "abcdefghijklmnopqrstuvwxyz"  # labels of the choices
NEAR = 0.02  # relative distance of a choice from the computed number that it stands for


@dataclass(frozen=True)
class Judgement:
    """What a prediction means in words; ``right`` is None where words cannot be judged."""

    right: bool | None
    words: str


@dataclass(frozen=True)
class Question:
    """A question with one kind of answer: a choice, a number, or words of the reader's own.

    choices : {choice: what it means}, mistakes and the right one
    right : the right choice, as the reader reads it; "" where none are offered
    number : the number that is typed, None where none is
    mistakes : {number: what it means}
    """

    text: str
    why: str = ""
    choices: Mapping[str, str] | None = None
    right: str = ""
    number: float | None = None
    within: float = 0.0
    unit: str = ""
    mistakes: Mapping[float, str] | None = None

    @property
    def key(self) -> str:
        """What distinguishes it from questions of other words, choices or units."""
        return "\n- ".join((self.text, *(self.choices or ()), *[self.unit] * bool(self.unit)))

    @property
    def answer(self) -> str:
        """The right answer, as it is printed."""
        return self.right or ("" if self.number is None else with_unit(self.number, self.unit))

    def judge(self, given: str) -> Judgement:
        """What the prediction means."""
        if self.choices:
            return Judgement(given == self.right, self.choices.get(given, ""))
        return self._typed(given) if self.number is not None else Judgement(None, "")

    def _typed(self, given):
        bare = given.strip().removesuffix(self.unit).replace("\N{MINUS SIGN}", "-")
        try:
            x = typed(bare, {})
        except AnswerError:
            x = None
        if not isinstance(x, float) or not math.isfinite(x):
            return Judgement(None, "")
        if abs(x - self.number) <= self.within:
            return Judgement(True, "")
        near = (words for m, words in self.mistakes.items() if abs(x - m) <= self.within)
        return Judgement(False, next(near, ""))


def with_unit(x: float, unit: str) -> str:
    """A number with its unit."""
    return f"{x + 0.0:.4g}{'' if unit[:1] in ('', '°', '%') else ' '}{unit}"


def question(
    text: str,
    choices: Mapping[object, str] | None,
    answer: object,
    unit: str,
    within: float | None,
    why: str,
) -> Question:
    """The question that :func:`~.asking.predict` asks, in the reader's language."""
    text, why, answer = _translated(text), _translated(why), _translated(answer)
    given = {_translated(c): _translated(means) for c, means in (choices or {}).items()}
    if answer is None and not given:
        return Question(text, why)
    if within is not None:
        return _of_number(text, given, answer, unit, within, why)
    words = {_in_words(c, unit): means for c, means in given.items()}
    if len(words) < len(choices or ()):
        raise ArgumentError(f"two choices read alike; got {', '.join(map(str, choices or ()))}")
    right = _right(given, answer, unit)
    if right not in words or not all(map(str.strip, words.values())):
        raise ArgumentError(
            f"the answer is one of the choices, {', '.join(words) or 'none'}; got {answer!r}"
        )
    return Question(text, why, words, right)


def _translated(x):
    return _(x) if isinstance(x, str) else x


def _of_number(text, mistakes, answer, unit, within, why):
    numbers = [answer, within, *mistakes]
    if not all(_is_number(x) for x in numbers) or not within > 0:
        raise ArgumentError(f"a number to type, its mistakes and within are numbers; got {numbers}")
    known = {float(m): words for m, words in mistakes.items()}
    for m in known:
        if abs(m - answer) <= 2 * within:
            raise ArgumentError(f"the mistake {m:g} cannot be told from the answer {answer:g}")
    return Question(text, why, None, "", float(answer), float(within), unit, known)


def _right(choices, answer, unit):
    """The choice that the answer stands for: itself, or the number nearest to it."""
    numbers = [c for c in choices if _is_number(c)]
    if not _is_number(answer) or not numbers:
        return _in_words(answer, "")
    nearest = min(numbers, key=lambda c: abs(c - answer))
    spread = min((abs(c - nearest) for c in numbers if c != nearest), default=0.0)
    near = abs(nearest - answer) <= max(NEAR * abs(answer), NEAR * spread)
    return _in_words(nearest if near else answer, unit)


def _in_words(choice, unit):
    if isinstance(choice, bool):
        return _("yes") if choice else _("no")
    return with_unit(float(choice), unit) if _is_number(choice) else str(choice)


def _is_number(x):
    try:
        return not isinstance(x, (bool, str)) and math.isfinite(x)
    except TypeError:
        return False
