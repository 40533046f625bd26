"""How often an answer was checked against its seal, and how long the next check waits.

The first wrong answers cost nothing, nor does repeating one, as when all cells run; from then on
the time until the next check doubles. Counts are kept beside the notebook and shown in it,
where the grader reads them. This is for those who guess by hand: a program of one's own needs no
receipt to try a seal, and files can be deleted.
"""

import contextlib
import hashlib
import json
import math
import os
import time
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from ..algebra.language import Words, _, spoken
from .givens import in_notebook
from .kinds import Kind
from .seals import is_known, opens

FREE = 6  # wrong answers before checks have to wait
LONGEST = 600.0  # s, the longest wait
FOUND = {
    True: Words("is right"), False: Words("is not right"), None: Words("is not checked yet"),
}  # fmt: skip
FILE = Path(".answers_checked.json")  # beside the notebook, so that a restarted kernel continues

_DAMAGED = (
    ArithmeticError, AttributeError, LookupError, OSError, RecursionError, TypeError, ValueError,
)  # fmt: skip
_kept: dict[str, Any] = {}  # {salt of a seal: {"wrong": [hashes of answers], "next": time}}


@dataclass(frozen=True)
class Check:
    """The result of a check: ``right`` is None where it must wait, for ``wait`` seconds; ``wrong``
    counts the wrong answers so far. Components in several frames are several answers.
    """

    right: bool | None
    wrong: int
    wait: float

    def __str__(self) -> str:
        """The end of a sentence that begins with the name of the answer."""
        found = spoken(FOUND[self.right])
        if not self.wait:
            return found
        text = Words("{found} (after {wrong} wrong answers, the next check is in {seconds} s)")
        return _(text, found=found, wrong=self.wrong, seconds=math.ceil(self.wait))


def check(sealed: Mapping[str, Any], kind: Kind, tree: Any) -> Check | None:
    """The :class:`Check` of an answer, as it was read; None for a seal of another version."""
    if not is_known(sealed):
        return None
    salt = sealed["salt"]
    entry = _read().setdefault(salt, {"wrong": [], "next": 0.0})
    texts = [json.dumps(x) for x in (tree.values() if isinstance(tree, dict) else [tree])]
    guesses = {hashlib.sha256(f"{salt} {x}".encode()).hexdigest()[:12] for x in texts}
    now = time.time()
    if entry["next"] > now + LONGEST:  # the clock was set back
        entry["next"] = now + LONGEST
        _write()
    wait = max(entry["next"] - now, 0.0)
    new = sorted(guesses - set(entry["wrong"]))
    if new and wait:
        return Check(None, len(entry["wrong"]), wait)
    if new and opens(sealed, kind, tree):
        return Check(True, len(entry["wrong"]), 0.0)
    if new:
        entry = _read()[salt]  # another kernel may have counted while this one computed
        entry["wrong"] += new
        beyond = len(entry["wrong"]) - FREE
        wait = min(2.0 ** min(beyond, 20), LONGEST) if beyond >= 0 else 0.0
        entry["next"] = now + wait
        _write()
    return Check(False, len(entry["wrong"]), wait)


def _read():
    """The counts of this kernel joined with those in the file; damaged entries count nothing."""
    with contextlib.suppress(*_DAMAGED):
        found = json.loads(FILE.read_bytes()) if in_notebook() else {}
        for salt, entry in found.items():
            own = _kept.get(salt, {"wrong": [], "next": 0.0})
            with contextlib.suppress(*_DAMAGED):
                wrong = list(dict.fromkeys([*own["wrong"], *map(str, entry["wrong"])]))
                _kept[salt] = {"wrong": wrong, "next": max(own["next"], float(entry["next"]))}
    return _kept


def _write():
    if not in_notebook():
        return
    beside = FILE.with_name(f"{FILE.name}.{os.getpid()}")
    with contextlib.suppress(OSError):  # the folder cannot be written: this kernel alone counts
        beside.write_text(json.dumps(_kept), "utf-8")
        os.replace(beside, FILE)
