"""COURSE/scores: the outcome of the run of each submission, and its grade. With the outcome kept, a
corrected key is graded without running anything again.
"""

import hashlib
import json
import re
from collections.abc import Mapping
from functools import cache
from pathlib import Path
from typing import Any, TypedDict

from exercises.catalogue.places import changes, files_of

from ..course import write_json
from ..sandbox import CAGED
from ..scoring import Part, Score
from ..submission import NotebookGrade

VERSION = 3


class Record(TypedDict):
    """The file of a submission: {notebook: outcome of its run, and grade}."""

    version: int
    notebooks: dict[str, dict[str, Any]]


ROOT = Path(__file__).parents[2]
_OF_A_PROBLEM = re.compile(r"p\d+\.(py|yaml)")


def fingerprint(*contents: Any) -> str:
    """A short hash of texts, bytes or JSON values, to detect changes."""
    digest = hashlib.sha256()
    for content in contents:
        if not isinstance(content, bytes):
            text = content if isinstance(content, str) else json.dumps(content, sort_keys=True)
            content = text.encode()
        digest.update(content)
        digest.update(b"\0")
    return digest.hexdigest()[:20]


@cache
def run_state() -> str:
    """A hash of the code that a run depends on: the engine and the cage."""
    return _hash_of("newton_euler", "grader/sandbox", "grader/submission", "grader/assignment")


@cache
def score_state() -> str:
    """A hash of the code that every score depends on: the scoring, the shared exercises."""
    return _hash_of("exercises", "grader/scoring", but=_OF_A_PROBLEM)


def problem_state(problem_id: str) -> str:
    """A hash of the files of a problem, which only its scores depend on."""
    return _hash_of_files(changes(files_of(problem_id)))


@cache
def _hash_of_files(changed: tuple[tuple[str, int], ...]) -> str:
    return fingerprint(*(Path(f).read_bytes() for f, _ in changed))


def _hash_of(*folders, but=None):
    """A hash of the files in these folders of the checkout, except names that match ``but``."""
    files = [
        f
        for folder in folders
        for kind in ("*.py", "*.yaml", "*.j2")
        for f in sorted((ROOT / folder).rglob(kind))
        if not (but and but.fullmatch(f.name))
    ]
    return fingerprint(*(part for f in files for part in (f.name, f.read_bytes())))


# now, since the code that runs in this process is that of now: a grade by the code of before an
# edit must not be kept as one of the code after it
run_state()
score_state()


def read_record(path: Path) -> Record:
    """The record of a submission; an empty one if it is missing or unreadable."""
    try:
        record = json.loads(path.read_bytes())
        if record["version"] == VERSION and isinstance(record["notebooks"], dict):
            return record
    except (OSError, ValueError, LookupError, TypeError):
        pass
    return {"version": VERSION, "notebooks": {}}


def write_record(path: Path, record: Record) -> None:
    """Write a record, adding the scores of all notebooks together for readers."""
    notebooks = record["notebooks"].values()
    write_json(
        path,
        {
            **record,
            "scores": [s for n in notebooks for s in n["scores"]],
            "sandbox": next((n["sandbox"] for n in notebooks if n["sandbox"] != CAGED), CAGED),
            "note": "; ".join(n["note"] for n in notebooks if n["note"]),
        },
        indent=None,
    )


def graded_as_json(graded: NotebookGrade) -> dict[str, Any]:
    """A grade as a dict for JSON."""
    return {
        "scores": [s.as_dict() for s in graded.scores.values()],
        "points": graded.points,
        "comments": graded.comments,
        "note": graded.note,
        "sandbox": graded.sandbox,
    }


def graded_from_json(entry: Mapping[str, Any]) -> NotebookGrade:
    """The grade in an entry of a record."""
    scores = {
        s["problem"]: Score(s["problem"], tuple(map(Part.from_dict, s["parts"])), s["note"])
        for s in entry["scores"]
    }
    return NotebookGrade(
        scores, entry["points"], entry["comments"], entry["note"], entry["sandbox"]
    )
