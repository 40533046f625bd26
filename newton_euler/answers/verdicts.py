"""What an answer is: right, wrong and why, unreadable or blank. Pure functions over data; nothing
that a student wrote is run, evaluated as code or simplified here.

The ``numbers`` of a problem are any object that has

answers : what is asked, each with ``key``, ``kind``, ``unit`` and ``atol``
symbols : {name: array of the points at which formulas are compared}
key : {answer: points} of the right answers
wrong(key) : [(group, text, points)] of the wrong models of an answer
book : {answer: points} for the book's numbers, {} where these are asked
earlier : {later answer: names of the earlier ones from which it follows}
following(key, earlier) : the points that follow from {earlier answer: points}, or None
"""

import math
import reprlib
from dataclasses import dataclass

from .diagnosis import BOOK, Elsewhere, causes, diagnose, observe
from .forms import WORDS
from .reading import read
from .slips import factors
from .tolerance import FORMULA_RTOL, RTOL, is_right
from .trees import TreeError, in_words

NO_ANSWER = "no answer"


@dataclass(frozen=True)
class Judged:
    """What an answer is: its verdict (right, wrong, unreadable or blank), what to say, and what was
    read, in the unit of the key.
    """

    verdict: str
    message: str
    given: tuple | None = None


def judge(asked, form, tree, fault, numbers, budget, factor=1.0):
    """What the answer ``tree`` is, read in the ``form`` that the student had.

    fault : why it cannot be read, or None; budget : as for :func:`~.reading.read`
    factor : from the unit of the form to that of the key
    """
    key = numbers.key[asked.key]
    if fault is not None:
        return Judged("unreadable", clipped(fault))
    if tree is None:
        return Judged("blank", NO_ANSWER)
    if asked.kind in WORDS:
        ((word,),) = key
        given = ((tree,),) if type(tree) is type(word) else None
        return Judged(*(("right", "right") if given == key else ("wrong", "not right")), given)
    try:
        readings = read(form, tree, numbers.symbols, budget)
    except TreeError as error:
        return Judged("unreadable", f"cannot be read: {clipped(str(error))}")
    if factor != 1:
        readings = [tuple(tuple(factor * x for x in point) for point in r) for r in readings]
    for given in readings:
        if is_right(asked.kind, given, key, asked.atol):
            return Judged("right", "right", given)
    return Judged("wrong", "not right", readings[0])


def explain(asked, found, numbers):
    """(message, diagnosis, earlier answers from which it follows) of a wrong answer; ``found`` has
    the :class:`Judged` of each answer of the problem.
    """
    given, key = found[asked.key].given, numbers.key[asked.key]
    message, cause = _diagnosed(asked, found, numbers)
    earlier = _followed(asked, found, numbers) if cause != BOOK else ()
    if earlier:
        message += f"; it follows from your {' and '.join(earlier)}"
        return message, cause or f"follows from a wrong {' and '.join(earlier)}", earlier
    if cause is None and (seen := observe(given, key, asked.kind)):
        return f"not right; {seen}", seen, ()
    return message, cause, ()


def _diagnosed(asked, found, numbers):
    given, key = found[asked.key].given, numbers.key[asked.key]
    cause = diagnose(
        given,
        key,
        _models(asked, numbers),
        _rtol(asked.kind),
        asked.kind,
        factors(asked.kind, asked.unit),
        Elsewhere(lambda: _elsewhere(asked, found, numbers)),
    )
    if BOOK in causes(cause):
        return "not right: this is the answer for the book's numbers; yours are others", BOOK
    if cause is None:
        return "not right", None
    return f"not right; it fits a solution that {cause}", cause


def _rtol(kind):
    return FORMULA_RTOL if kind.endswith("expression") else RTOL


def _models(asked, numbers):
    """The wrong models of an answer, and its key for the book's numbers."""
    book = numbers.book.get(asked.key)
    return [*numbers.wrong(asked.key), *([("book", BOOK, book)] if book else [])]


def _elsewhere(asked, found, numbers):
    """The other parts that a student answered, for :class:`~.diagnosis.Elsewhere`."""
    parts = []
    for other in numbers.answers:
        judged = found.get(other.key)
        if other.key != asked.key and judged and judged.given is not None:
            key, wrong = numbers.key[other.key], _models(other, numbers)
            right = judged.verdict == "right"
            parts.append((right, judged.given, key, wrong, _rtol(other.kind)))
    return parts


def _followed(asked, found, numbers):
    """The student's own wrong answers from which this one follows rightly; () if it does not."""
    names = numbers.earlier.get(asked.key, ())
    wrong = [n for n in names if n in found and found[n].verdict == "wrong"]
    # an earlier part that the sheet does not ask for is not the student's
    earlier = {n: found[n].given if n in found else numbers.key[n] for n in names}
    if not wrong or None in earlier.values():
        return ()
    expected = numbers.following(asked.key, earlier)
    if asked.kind in WORDS:
        return wrong if expected == found[asked.key].given else ()
    if expected is None or max(math.hypot(*point) for point in expected) <= asked.atol:
        return ()  # zero follows from zero: nothing was computed
    return wrong if is_right(asked.kind, found[asked.key].given, expected, asked.atol) else ()


def shown(form, tree, verdict):
    """The value that was read, with its unit, as a line for the student; "" if none was."""
    if verdict not in ("right", "wrong"):
        return ""
    if form.kind in WORDS:  # any JSON
        return clipped(tree)[:200]
    between = ", " if type(tree) is dict else " "  # components in several frames
    text = in_words(tree)[:200] + (between + form.unit if form.unit != "1" else "")
    return clipped(text) if type(tree) is dict else text  # the student named the frames


_bounded = reprlib.Repr()
_bounded.maxstring = _bounded.maxother = 400


def clipped(value):
    """Any value as one printable line: students control the text of error messages, which are
    written to files, tables and pages.
    """
    text = value[:4000] if isinstance(value, str) else _bounded.repr(value)
    line = " ".join(text.split())[:400]
    return "".join(c if c.isprintable() else "\ufffd" for c in line)
