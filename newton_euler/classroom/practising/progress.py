"""What a student tried, in a file of the student's own, which is never sent anywhere."""

import contextlib
import json
import os
from pathlib import Path
from typing import Any

FORMAT = 1
MASTERED = 0.8  # of the quantities of a section that were tried, right at first go without help
ENOUGH = 5  # quantities, before a section can be called mastered


class Progress:
    """Tries by problem, set of numbers and quantity: {"tries", "right", "help"}; ``right`` is the
    try that was right first, or 0; ``help`` what was shown before: 0 nothing, 1 where to look, 2
    the equation, 3 the value.
    """

    def __init__(self, path: str | Path | None):
        self.path = Path(path) if path else None
        self.note = ""
        self._kept: dict[str, Any] = self._read()

    def _read(self) -> dict[str, Any]:
        if self.path is None:
            return {}
        try:
            kept = json.loads(self.path.read_text(encoding="utf-8"))
            if kept["format"] != FORMAT:
                raise ValueError(f"format {kept['format']!r}")
            return dict(kept["problems"])
        except FileNotFoundError:
            return {}
        except (ValueError, KeyError, TypeError, OSError) as error:
            aside = self.path.with_name(self.path.name + ".damaged")
            with contextlib.suppress(OSError):
                os.replace(self.path, aside)
            self.note = f"{self.path} could not be read ({error}); it is kept as {aside.name}"
            return {}

    def entry(self, problem: str, variant: int, key: str) -> dict[str, int]:
        """What is kept of a quantity; a copy."""
        kept = self._kept.get(problem, {}).get(str(variant), {}).get(key, {})
        return {"tries": 0, "right": 0, "help": 0, **kept}

    def tried(self, problem: str, variant: int, key: str, right: bool) -> None:
        """Keep one more try; none is counted after the right one."""
        entry = self.entry(problem, variant, key)
        if not entry["right"]:
            entry["tries"] += 1
            entry["right"] = entry["tries"] if right else 0
            self._keep(problem, variant, key, entry)

    def helped(self, problem: str, variant: int, key: str, level: int) -> None:
        """Keep how much was shown of a quantity that is not right yet."""
        entry = self.entry(problem, variant, key)
        if not entry["right"] and level > entry["help"]:
            self._keep(problem, variant, key, {**entry, "help": level})

    def _keep(self, problem, variant, key, entry):
        if self.path is not None and self.path.exists():
            # another notebook may have written meanwhile
            self._kept = {**self._kept, **self._read()}
        self._kept.setdefault(problem, {}).setdefault(str(variant), {})[key] = entry
        if self.path is None:
            return
        beside = self.path.with_name(f"{self.path.name}.{os.getpid()}")
        try:
            beside.write_text(json.dumps({"format": FORMAT, "problems": self._kept}), "utf-8")
            os.replace(beside, self.path)
        except OSError as error:
            self.note = f"your progress is kept only while this kernel runs: {error}"

    def counts(self, problem: str) -> dict[str, int]:
        """How many quantities were tried, right, right at first go without help, and helped."""
        entries = [
            {"tries": 0, "right": 0, "help": 0, **e}
            for of_variant in self._kept.get(problem, {}).values()
            for e in of_variant.values()
        ]
        return {
            "tried": sum(e["tries"] > 0 for e in entries),
            "right": sum(e["right"] > 0 for e in entries),
            "at first go": sum(e["right"] == 1 and not e["help"] for e in entries),
            "with help": sum(e["help"] > 0 for e in entries),
        }


def mastery(counts: dict[str, int]) -> str:
    """How well a section is known, in words, from its counts.

    >>> mastery({"tried": 10, "right": 10, "at first go": 9, "with help": 0})
    'mastered'
    """
    if not counts["tried"]:
        return "not tried"
    share = counts["at first go"] / counts["tried"]
    if counts["tried"] >= ENOUGH and share >= MASTERED:
        return "mastered"
    return "nearly there" if share >= MASTERED / 2 else "needs practice"
