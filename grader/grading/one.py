"""Grading one notebook of one submission: from its record if nothing has changed, from the kept
outcome of its run if only the key or the points have, else by running it.
"""

import os
import shutil
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path

from exercises.catalogue.reading import read_once

from ..assignment.attempts import earlier_attempts, is_work_of_earlier
from ..assignment.cells import Notebook, Sources, kind, nbgrader_metadata
from ..assignment.released import personal_path
from ..course import Course, load_json, write_notebook
from ..sandbox import Harvester
from ..submission import (
    NotebookGrade,
    RunResults,
    UnreadableError,
    Work,
    annotate,
    execute,
    grade_notebook,
    parse_notebook,
    read_notebook,
    rebuild,
    student_sheet,
)
from ..submission.files import BESIDE
from .records import (
    fingerprint,
    graded_as_json,
    graded_from_json,
    problem_state,
    read_record,
    run_state,
    score_state,
    write_record,
)


@dataclass
class GradingResult:
    """The grade of a notebook; whether the work is new, the record was reused unchanged, and this
    is the first grade of another attempt.
    """

    graded: NotebookGrade
    changed: bool
    reused: bool
    again: bool = False


def grade_one(
    course: Course,
    assignment: str,
    student: str,
    name: str,
    sources: Sources,
    harvester: Harvester,
    force: bool = False,
    remark: str = "",
) -> GradingResult:
    """Grade one submitted notebook; writes the record and the annotated notebook, with a ``remark``
    in its note.
    """
    submitted = course.path / "submitted" / student / assignment / f"{name}.ipynb"
    content = read_notebook(submitted)
    if number := is_work_of_earlier(course, assignment, student, name, content):
        raise UnreadableError(
            f"{submitted.name} is that of attempt {number}, whose grade stays; the new sheet has "
            "not been handed in"
        )
    path = course.record_path(assignment, student)
    record = read_record(path)
    before = record["notebooks"].get(name, {})
    sheet = student_sheet(course, assignment, student, name, sources)
    state = _state(sheet, content, harvester.sandbox, remark)
    changed = before.get("content") != state["content"]
    entry = {} if force else before
    annotated = autograded_path(course, assignment, student, name)
    as_built = entry.get("built") == state["built"] and annotated.exists()
    if as_built and entry["scored"] == state["scored"]:
        return GradingResult(graded_from_json(entry), changed, True)
    ran = entry.get("ran") == state["ran"]
    notebook: Notebook | None = None
    with read_once():  # after the hashes: what is edited meanwhile is graded again the next time
        if ran and as_built:
            work = Work(**entry["work"])
        else:
            notebook, work = rebuild(
                sheet.master, parse_notebook(submitted.name, content), sheet.places
            )
        if ran:
            executed = RunResults(**entry["executed"])
        else:
            assert notebook  # rebuilt above, since no run is kept
            executed = execute(harvester, sheet, notebook)
        scores = graded_from_json(entry).scores if ran else {}
        kept = {i: s for i, s in scores.items() if entry["scored"].get(i) == state["scored"].get(i)}
        graded = grade_notebook(sheet, work, executed, kept)
        graded.note = "; ".join(filter(None, [remark, graded.note]))
        now = graded_as_json(graded)
        if notebook is None and any(entry[key] != now[key] for key in now):
            notebook = load_json(annotated.read_bytes())
        if notebook is not None:
            earlier = entry["note"] if as_built else ""
            write_notebook(annotated, annotate(notebook, graded, sources, earlier))
            _copy_nbgraders_files(submitted.parent, annotated.parent)
    parts = {"executed": vars(executed), "work": vars(work)}
    record["notebooks"][name] = {**state, **parts, **now}
    write_record(path, record)
    again = not before and bool(earlier_attempts(course, assignment, student))
    return GradingResult(graded, changed, False, again)


def _state(sheet, content, sandbox, remark):
    """Hashes of the inputs of each part of a record's entry: "ran", the run in the sandbox;
    "built", the annotated notebook; "scored", the score of each problem; "content", the submission.
    """
    released, what_runs = sheet.released.hashes
    submitted, common = fingerprint(content), score_state()
    cells = sheet.released.notebook["cells"]
    tests = [nbgrader_metadata(c)["grade_id"] for c in cells if kind(c) == "test"]
    hidden = [sheet.sources[name][0] for name in tests if name in sheet.sources]
    ran = fingerprint(
        run_state(), sheet.course.secret, submitted, what_runs, hidden, sheet.values, sandbox
    )
    return {
        "content": submitted,
        "ran": ran,
        "built": fingerprint(ran, released, sheet.sources, _stamp(sheet), *filter(None, [remark])),
        "scored": {
            i: _hash_of_texts(common, problem_state(i), t.as_json) for i, t in sheet.tasks.items()
        },
    }


_hash_of_texts = lru_cache(maxsize=10_000)(fingerprint)  # the same for all students


def _stamp(sheet):
    """The time of the last change of the student's copy, which has the figures."""
    path = personal_path(sheet.course, sheet.assignment, sheet.student, sheet.name)
    return path.stat().st_mtime_ns if path.exists() else 0


def autograded_path(course: Course, assignment: str, student: str, name: str) -> Path:
    """The path of the annotated notebook, nbgrader's own."""
    return course.path / "autograded" / student / assignment / f"{name}.ipynb"


def _copy_nbgraders_files(source, target):
    """Copy the small files of nbgrader's submit that it expects in autograded/."""
    for name in BESIDE:
        path = source / name
        if path.is_file() and not path.is_symlink() and path.stat().st_size < 10_000:
            shutil.copyfile(path, target / name)
            os.chmod(target / name, 0o644)
