"""``predict``, ``tally`` and ``predict_again``: what a notebook calls."""

from collections.abc import Mapping
from typing import Any

from ...algebra.errors import ArgumentError, checked
from ...algebra.language import Words, _, spoken
from ...answers.givens import in_notebook
from . import kept
from .page import STATIC, opened, plain
from .question import LETTERS, Judgement, Question, question

_asked: dict[str, "Prediction"] = {}  # predictions by key, in the order of asking


@checked
def predict(
    text: str,
    choices: Mapping[Any, str] | None = None,
    answer: Any = None,
    unit: str = "",
    within: float | None = None,
    why: str = "",
) -> "Prediction":
    """A question that is answered before its answer is seen. In a notebook it shows buttons or a
    field; elsewhere ``.choose("b")`` answers. The first prediction is kept in predictions.json in
    the folder of the notebook. Formulas are written as in Markdown.

    choices : {choice: what it means}: mistakes with their reasons, and the right one
    answer : the right choice, or a computed number, for which its nearest choice stands; True and
        False stand for "yes" and "no"
    unit : of the numbers
    within : the tolerance of a number that is typed; ``choices`` are then its mistakes, by value
    why : the reason of the right answer

    Without ``choices`` and ``answer`` the prediction is a sentence. Raises
    :class:`~newton_euler.algebra.ArgumentError` where no choice is right, or one has no meaning.

    >>> fall = {9.8: "", 0.0: "Only the velocity is zero there."}
    >>> fall[9.8] = "Gravity also acts where the ball stands still."
    >>> top = predict("How large is the acceleration at the top?", fall, 9.81, "m/s²")
    >>> print(top)
    Predict. How large is the acceleration at the top?
    - 9.8 m/s²
    - 0 m/s²
    >>> top.judge("b")
    Judged(right=False, words='Only the velocity is zero there.')
    """
    asked = Prediction(question(text, choices, answer, unit, within, why))
    _asked[asked.question.key] = asked
    return asked


@checked
def tally() -> "Tally":
    """How many predictions of this notebook were right."""
    return Tally()


@checked
def predict_again(*predictions: "Prediction") -> "Again":
    """Ask these once more, or by default those that were wrong."""
    return Again(predictions)


class Prediction:
    """A question and, once it is given, the reader's first prediction."""

    @checked
    def __init__(self, asked: Question, again: bool = False):
        self.question, self._note = asked, ""
        self._key = asked.key + " (again)" * again

    @property
    def given(self) -> str | None:
        """What was predicted, None if nothing was yet."""
        return kept.given(self._key)

    @property
    def right(self) -> bool | None:
        """Whether it was right; None before, and for a sentence."""
        return None if self.given is None else self.question.judge(self.given).right

    @checked
    def judge(self, prediction: str) -> Judgement:
        """What a prediction would mean: the letter or text of a choice, a number, a sentence."""
        return self.question.judge(self._choice(prediction))

    @checked
    def choose(self, prediction: str) -> "Prediction":
        """Predict, by the letter of a choice, its text, a number or a sentence; only the first
        prediction is kept.
        """
        if self.given is None:
            self._note = kept.keep(self._key, self._choice(prediction))
        return self

    def _choice(self, prediction):
        choices = list(self.question.choices or ())
        letters = list(LETTERS[: len(choices)])
        if prediction in choices or not choices:
            return prediction
        if prediction not in letters:
            raise ArgumentError(f"a choice is one of {', '.join(letters)}; got {prediction!r}")
        return choices[letters.index(prediction)]

    def html(self) -> str:
        """What a notebook shows beside the buttons."""
        return opened(self.question, self.given, self._note)

    def __repr__(self) -> str:
        return plain(self.html())

    def _ipython_display_(self) -> None:
        if not in_notebook():
            print(self)
            return
        from .panel import show_prediction

        show_prediction(self)


class Tally:
    """Counts of the predictions asked so far."""

    def __str__(self) -> str:
        first = [p for p in _asked.values() if p.given is not None]
        right, wrong = (sum(p.right is x for p in first) for x in (True, False))
        counts = {"made": len(first), "all": len(_asked), "right": right, "wrong": wrong}
        return (
            _("{made} of {all} predictions made: {right} right, {wrong} wrong.", **counts)
            if first
            else _("{made} of {all} predictions made.", **counts)
        )

    __repr__ = __str__

    def _repr_mimebundle_(self, **formats: Any) -> dict[str, str]:
        static = '<p class="prediction-tally" hidden></p>'
        return {"text/plain": str(self), "text/html": f"<p>{self}</p>", STATIC: static}


class Again:
    """Predictions that are asked once more."""

    def __init__(self, predictions: tuple[Prediction, ...]):
        self._named = predictions

    @property
    def predictions(self) -> list[Prediction]:
        """The questions to ask, without the earlier predictions."""
        chosen = self._named or [p for p in _asked.values() if p.right is False]
        return [Prediction(p.question, again=True) for p in chosen]

    def __repr__(self) -> str:
        return "\n\n".join(map(repr, self.predictions)) or spoken(NOTHING)

    def _ipython_display_(self) -> None:
        from IPython.display import display

        for p in self.predictions if in_notebook() else ():
            display(p)
        if not self._named:
            static = '<div class="predictions-again" hidden></div>'
            text = "" if self.predictions and in_notebook() else repr(self)
            display({"text/plain": text, "text/html": f"<p>{text}</p>", STATIC: static}, raw=True)


NOTHING = Words("No prediction was wrong so far, so none is asked again.")
