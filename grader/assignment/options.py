"""Options of a problem in an assignment, from its file or the metadata of the answer cell."""

from collections.abc import Iterable, Mapping
from typing import Any

from exercises.catalogue import Problem
from exercises.catalogue.errors import meant
from newton_euler.classroom.practising.files import HELP as PRACTICE_HELP

# the most that a student is shown: points and verdicts after grading; also the mistake behind an
# answer, and verdicts at once; also steps with hints in practice; also the worked solution after
# the due date
HELP = ("none", *PRACTICE_HELP)
LARGEST = 0.1  # relative tolerance


OPTIONS = ("points", "weights", "follow_through", "tolerance", "help")
BY_SHEET = ("follow_through", "tolerance", "help")  # options that a sheet may set for all problems


def read_option(name: str, value: Any, p: Problem | None = None) -> Any:
    """The value of an option of problem ``p``, or of a sheet; raises ValueError in words."""
    if name == "points":
        return _checked(value, 0, 1e6, "not a number of points: expected 0 or more")
    if name == "follow_through":
        return _checked(_percent(value), 0, 1, "not a share: expected 0 to 1, as 0.5 or 50%")
    if name == "tolerance":
        words = f"not a tolerance: expected 0.001% to {LARGEST:.0%}, as 0.02 or 2%"
        return _checked(_percent(value), 1e-5, LARGEST, words)
    if name == "weights":
        return _weights(value, p)
    if value not in HELP:
        raise ValueError(unknown(value, HELP, "is not a help level; the levels are"))
    return value


def unknown(word: object, known: Iterable[str], what: str = "is not one of") -> str:
    """A sentence that a word is not a known one, with the likeliest of those."""
    names = sorted(known)
    return f"{word!r} {what} {', '.join(names)}{meant(word, names)}"


def _checked(value, least, most, words):
    good = isinstance(value, int | float) and not isinstance(value, bool)
    if not good or not least <= value <= most:
        raise ValueError(f"{value!r} is {words}")
    return int(value) if float(value).is_integer() else float(value)


def _percent(value):
    """A text with a percent sign as a number; anything else unchanged."""
    text = str(value).strip()
    try:
        return float(text.removesuffix("%")) / 100 if text.endswith("%") else value
    except ValueError:
        return value


def _weights(value, p):
    if not isinstance(value, Mapping) or not value:
        raise ValueError(f"{value!r} is not a set of weights, such as {{{p.answers[0].key}: 2}}")
    keys = [a.key for a in p.answers]
    for key in value:
        if key not in keys:
            raise ValueError(unknown(key, keys, f"is not a part of {p.id}; its parts are"))
    found = {
        k: _checked(x, 0, 1e6, f"not a weight of {k}: expected 0 or more") for k, x in value.items()
    }
    if not any(found.get(key, 1) for key in keys):
        raise ValueError("all weights are 0, so the problem is worth nothing")
    return found
