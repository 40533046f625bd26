"""What a student tried, in a file of the student's own, which is never sent anywhere."""

import contextlib
import json
import os
from collections.abc import Callable
from datetime import date
from pathlib import Path
from typing import Any

from ...algebra.language import Words, _
from ...answers.causes import Cause

FORMAT = 1
MASTERED = 0.8  # share of the quantities tried in a section that were right at once, without help
ENOUGH = 5  # quantities, before a section can be called mastered
NOTHING = {"tries": 0, "right": 0, "help": 0}


class Progress:
    """Tries by problem, set of numbers and quantity: {"tries", "right", "help"}; ``right`` is the
    try that was right first, or 0; ``help`` what was shown before: 0 nothing, 1 where to look, 2
    the equation, 3 the value. Also, if known, the last ``day`` ("2026-11-23") and the ``cause`` of
    the last wrong try, [group, name, words].
    """

    def __init__(self, path: str | Path | None, today: Callable[[], date] = date.today):
        self.path = Path(path) if path else None
        self.today = today
        self.note = ""
        self._kept: dict[str, Any] = self._read()

    def _read(self) -> dict[str, Any]:
        if self.path is None:
            return {}
        try:
            return _problems(self.path.read_text(encoding="utf-8"))
        except FileNotFoundError:
            return {}
        except (ValueError, OSError) as error:
            aside = self.path.with_name(self.path.name + ".damaged")
            with contextlib.suppress(OSError):
                os.replace(self.path, aside)
            text = Words("{path} could not be read ({error}); it is kept as {name}")
            self.note = _(text, path=self.path, error=error, name=aside.name)
            return {}

    def __str__(self) -> str:
        return json.dumps({"format": FORMAT, "problems": self._kept})

    def take_in(self, text: str) -> None:
        """Add the progress in another such file; of two records of a quantity, the one with more
        tries counts. Raises :class:`ValueError` for another text.
        """
        weight = lambda e: (e.get("tries", 0), e.get("help", 0), e.get("day", ""))  # noqa: E731
        for problem, variants in _problems(text).items():
            for variant, entries in variants.items():
                own = self._kept.setdefault(problem, {}).setdefault(variant, {})
                for key, entry in entries.items():
                    own[key] = max(own.get(key, NOTHING), entry, key=weight)
        self._write()

    def entry(self, problem: str, variant: int, key: str) -> dict[str, int]:
        """The tries of a quantity, as numbers; a copy."""
        kept = self._kept.get(problem, {}).get(str(variant), {}).get(key, {})
        return {name: kept.get(name, 0) for name in NOTHING}

    def entries(self, problem: str) -> dict[str, dict[str, dict[str, Any]]]:
        """The record of a problem: {set of numbers: {quantity: entry}}."""
        return {
            variant: {key: {**NOTHING, **e} for key, e in entries.items()}
            for variant, entries in self._kept.get(problem, {}).items()
        }

    def tried(
        self, problem: str, variant: int, key: str, right: bool, cause: Cause | None = None
    ) -> None:
        """Record one more try, with the ``cause`` of a wrong one; tries after the right one do not
        count.
        """
        entry = self.entry(problem, variant, key)
        if not entry["right"]:
            entry["tries"] += 1
            entry["right"] = entry["tries"] if right else 0
            why = {"cause": [cause.group, cause.name, cause.what]} if cause else {}
            self._keep(problem, variant, key, {**entry, **why})

    def helped(self, problem: str, variant: int, key: str, level: int) -> None:
        """Record how much was shown of a quantity that is not right yet."""
        entry = self.entry(problem, variant, key)
        if not entry["right"] and level > entry["help"]:
            self._keep(problem, variant, key, {**entry, "help": level})

    def _keep(self, problem, variant, key, entry):
        if self.path is not None and self.path.exists():
            # another notebook may have written meanwhile
            self._kept = {**self._kept, **self._read()}
        kept = self._kept.setdefault(problem, {}).setdefault(str(variant), {})
        kept[key] = {**kept.get(key, {}), **entry, "day": self.today().isoformat()}
        self._write()

    def _write(self):
        if self.path is None:
            return
        partial = self.path.with_name(f"{self.path.name}.{os.getpid()}")
        try:
            partial.write_text(str(self), "utf-8")
            os.replace(partial, self.path)
        except OSError as error:
            self.note = _("your progress is kept only while this kernel runs: {error}", error=error)

    def counts(self, problem: str) -> dict[str, int]:
        """How many quantities were tried, right, right at first go without help, and helped."""
        entries = [e for variant in self.entries(problem).values() for e in variant.values()]
        return {
            "tried": sum(e["tries"] > 0 for e in entries),
            "right": sum(e["right"] > 0 for e in entries),
            "at first go": sum(map(at_first_go, entries)),
            "with help": sum(e["help"] > 0 for e in entries),
        }


def at_first_go(entry: dict[str, Any]) -> bool:
    """True if a quantity was right at once, without help."""
    return entry["right"] == 1 and not entry["help"]


def _problems(text):
    """The progress in the text of a file; raises ValueError for any other text."""
    try:
        found = json.loads(text)
        if found["format"] != FORMAT:
            raise ValueError(_("format {format}", format=repr(found["format"])))
        problems = dict(found["problems"])
        sound = all(
            _is_entry(entry)
            for variants in problems.values()
            for number, entries in variants.items()
            for entry in (*entries.values(), *([{}] if number.isdecimal() else [None]))
        )
    except (KeyError, TypeError, AttributeError, RecursionError, json.JSONDecodeError) as error:
        raise ValueError(_("it holds no progress")) from error
    if not sound:
        raise ValueError(_("an entry of it cannot be read"))
    return problems


def _is_entry(x):
    if not isinstance(x, dict) or set(x) - {*NOTHING, "day", "cause"}:
        return False
    with contextlib.suppress(ValueError, TypeError):
        date.fromisoformat(x.get("day", "2000-01-01"))
        cause = x.get("cause", ["", "", ""])
        counts = [x.get(name, 0) for name in NOTHING]
        return (
            all(type(n) is int and 0 <= n < 10**9 for n in counts)
            and isinstance(cause, list) and len(cause) == 3
            and all(isinstance(part, str) and part.isprintable() for part in cause)
        )  # fmt: skip
    return False


def mastery(counts: dict[str, int]) -> str:
    """How well a section is known, in words, from its counts.

    >>> mastery({"tried": 10, "right": 10, "at first go": 9, "with help": 0})
    'mastered'
    """
    if not counts["tried"]:
        return _("not tried")
    share = counts["at first go"] / counts["tried"]
    if counts["tried"] >= ENOUGH and share >= MASTERED:
        return _("mastered")
    return _("nearly there") if share >= MASTERED / 2 else _("needs practice")
