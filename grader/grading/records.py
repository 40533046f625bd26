"""COURSE/scores: of each submission what came out of the sandbox, and what was given for it. What
was executed is kept, so that a corrected key grades again without running anything.
"""

import hashlib
import json
import re
from functools import cache
from pathlib import Path

from exercises.catalogue.model import place

from ..course import write_json
from ..scoring import Part, Score
from ..submission import Graded

VERSION = 3
ROOT = Path(__file__).parents[2]
_OF_A_PROBLEM = re.compile(r"p\d+\.(py|yaml)")


def fingerprint(*contents):
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
def run_state():
    """What the outcome of a run depends on, besides the notebook: the engine, which students call,
    and the cage.
    """
    return _hash_of("newton_euler", "grader/sandbox", "grader/submission", "grader/assignment")


@cache
def score_state():
    """What all scores depend on besides: the scoring, and what the exercises share."""
    return _hash_of("exercises", "grader/scoring", but=_OF_A_PROBLEM)


@cache
def problem_state(problem_id):
    """What the scores of one problem depend on besides: its two files."""
    chapter, name = place(problem_id)
    files = [ROOT / "exercises" / chapter / f"{name}.{kind}" for kind in ("py", "yaml")]
    return fingerprint(*(f.read_bytes() for f in files))


def _hash_of(*folders, but=None):
    """A hash of the Python and YAML files in these folders of the checkout, except for those with
    such names.
    """
    files = [
        f
        for folder in folders
        for kind in ("*.py", "*.yaml")
        for f in sorted((ROOT / folder).rglob(kind))
        if not (but and but.fullmatch(f.name))
    ]
    return fingerprint(*(part for f in files for part in (f.name, f.read_bytes())))


def read_record(path):
    """The record of a submission; one without notebooks if there is none that can be read."""
    try:
        record = json.loads(path.read_bytes())
        if record["version"] == VERSION and isinstance(record["notebooks"], dict):
            return record
    except (OSError, ValueError, LookupError, TypeError):
        pass
    return {"version": VERSION, "notebooks": {}}


def write_record(path, record):
    """Write a record, with the scores of all notebooks together for those who read it."""
    notebooks = record["notebooks"].values()
    write_json(
        path,
        {
            **record,
            "scores": [s for n in notebooks for s in n["scores"]],
            "sandbox": next(
                (n["sandbox"] for n in notebooks if n["sandbox"] != "namespaces"), "namespaces"
            ),
            "note": "; ".join(n["note"] for n in notebooks if n["note"]),
        },
        indent=None,
    )


def graded_as_json(graded):
    """A :class:`~grader.submission.pipeline.Graded` as a dict for JSON."""
    return {
        "scores": [s.as_dict() for s in graded.scores.values()],
        "points": graded.points,
        "comments": graded.comments,
        "note": graded.note,
        "sandbox": graded.sandbox,
    }


def graded_from_json(entry):
    """The :class:`~grader.submission.pipeline.Graded` of a record's entry."""
    scores = {s["problem"]: _score(s) for s in entry["scores"]}
    return Graded(scores, entry["points"], entry["comments"], entry["note"], entry["sandbox"])


def scores_of(entry, wanted):
    """{problem id: :class:`~grader.scoring.Score`} of a record's entry, of these problems only."""
    return {s["problem"]: _score(s) for s in entry["scores"] if s["problem"] in wanted}


def _score(s):
    return Score(s["problem"], tuple(map(Part.from_dict, s["parts"])), s["note"])
