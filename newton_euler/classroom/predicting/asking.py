"""``predict``, ``tally`` and ``predict_again``: what a notebook calls."""

import contextlib
import json
import os
import re
from collections import Counter
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from ...algebra.errors import ArgumentError, checked
from ...algebra.language import Words, _, spoken
from ...answers.givens import in_notebook, running_cell
from .page import STATIC, opened, plain
from .question import LETTERS, Judgement, Question, question

FILE = "predictions.json"  # beside the notebook: the state of widgets is lost when that is closed
ID = re.compile(r"[a-zA-Z0-9_-]{1,64}")  # a cell's, by the format of notebooks
# {(question, cell, how many equal ones that run of the cell asked before): prediction}, in the
# order of asking
_asked: dict[tuple[str, str, int], "Prediction"] = {}
_of_this_run: tuple[str, Counter[str]] = "", Counter()  # the run of a cell, what it has asked


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
    the folder of the notebook, for this question in this cell: the cell opens with it again, and an
    equal question in another cell is another one. Formulas are written as in Markdown.

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
    Judgement(right=False, words='Only the velocity is zero there.')
    """
    asked = question(text, choices, answer, unit, within, why)
    place = _place(asked.key)
    _asked[place] = Prediction(asked, _keys(place))
    return _asked[place]


def _place(key):
    """Question, cell, and how many equal questions this run of the cell asked before. Outside a
    notebook there are no cells, and a question that is asked again is the same.
    """
    global _of_this_run
    cell, run = running_cell()
    if not cell:
        return key, "", 0
    if run != _of_this_run[0]:
        _of_this_run = run, Counter()
    before = _of_this_run[1]
    before[key] += 1
    return key, cell, before[key] - 1


def _keys(place):
    """Where a prediction is kept, then where an earlier version kept it. A cell is known in the
    next session if its id is that in the file of the notebook; else equal questions are numbered,
    on a line of its own: a question may end in "(2)".
    """
    key, cell, before = place
    equal = [other for other in _asked if other[0] == key]
    number = equal.index(place) if place in equal else len(equal)
    numbered = f"{key}\n@ ({number + 1})" if number else key
    if not ID.fullmatch(cell):
        return (numbered,)
    own = f"{key}\n@ {cell}" + f" {before + 1}" * bool(before)
    return (own,) if number else (own, key)


@checked
def tally() -> "Tally":
    """How many predictions of this notebook were right."""
    return Tally()


@checked
def predict_again(*predictions: "Prediction") -> "Again":
    """Ask these once more, or by default those that were wrong."""
    return Again(predictions)


class Prediction:
    """A question and, once it is given, the reader's first prediction, which is kept under the
    first of the ``keys``.
    """

    @checked
    def __init__(self, asked: Question, keys: Sequence[str]):
        self.question, self.keys, self._note = asked, keys, ""

    @property
    def given(self) -> str | None:
        """What was predicted, None if nothing was yet."""
        kept = _read()
        return next((kept[key] for key in self.keys if key in kept), None)

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
            self._note = _keep(self.keys[0], self._choice(prediction))
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
        some = Words("{made} of {all} predictions made: {right} right, {wrong} wrong.")
        return _(some if first else Words("{made} of {all} predictions made."), **counts)

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
        return [Prediction(p.question, [f"{key}\n@ (again)" for key in p.keys]) for p in chosen]

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


# -- the first prediction of each question, in a file


def _keep(key, prediction):
    """Keep a prediction; returns why it could not be written, or nothing."""
    kept = {**_read(), key: prediction}
    partial = Path(f"{FILE}.{os.getpid()}")
    try:
        partial.write_text(json.dumps(kept, ensure_ascii=False, indent=1), encoding="utf-8")
        os.replace(partial, FILE)
    except OSError as error:
        _unwritten[key] = prediction
        return _("It is kept only while this notebook runs: {error}", error=error)
    return ""


_unwritten: dict[str, str] = {}


def _read():
    kept = dict(_unwritten)
    with contextlib.suppress(OSError, ValueError):
        found = json.loads(Path(FILE).read_text(encoding="utf-8"))
        kept |= {q: p for q, p in dict(found).items() if isinstance(p, str)}
    return kept
