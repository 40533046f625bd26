"""Submissions for the tests: right ones, changed ones, damaged ones."""

import json

from grader.assignment import problems_of
from grader.demo import sample_students as sample
from tests.grader.courses import read

# points of the course's students but dan, whose notebook the tests change
RIGHT = {"ada": 11, "ben": 6, "cleo": 4, "eve": 9, "mallory": 0}


def work(course, student, assignment="ch04", **changed):
    """A right notebook of this student; ``changed`` replaces answer cells, as p4_16="...")."""
    own = read(course.personal_path(assignment, student))
    problems = problems_of(own)
    values = course.values(assignment, student, problems)
    texts = {p.id: sample.cell_text(p, sample.right_answers(p, values[p.id])) for p in problems}
    return sample.fill_in(own, texts | {k[1:].replace("_", "/"): v for k, v in changed.items()})


def without(notebook, *cell_ids):
    return {**notebook, "cells": [c for c in notebook["cells"] if c["id"] not in cell_ids]}


def copied(notebook, cell_id, text):
    cell = next(c for c in notebook["cells"] if c["id"] == cell_id)
    return {**notebook, "cells": [*notebook["cells"], {**cell, "id": "copied", "source": text}]}


def untouched(course, student):
    return read(course.personal_path("ch04", student))


def with_json(course, before, after):
    """dan's notebook with a change of its JSON."""
    return json.loads(json.dumps(work(course, "dan")).replace(before, after))


def with_cells(course, change):
    notebook = work(course, "dan")
    return {**notebook, "cells": change(notebook["cells"])}


def worked_in_the_copy(course):
    cells = work(course, "dan")["cells"]
    text = next(c["source"] for c in cells if c["id"] == "answer-4-16")
    return copied(untouched(course, "dan"), "answer-4-16", text)


def as_lines(cells):
    return [{**c, "source": c["source"].splitlines(True)} for c in cells]


def bare(cells):
    """The notebook as saved by an editor that keeps only the text of cells."""
    return [{"cell_type": c["cell_type"], "metadata": {}, "source": c["source"]} for c in cells]


def bare_with_a_copy(cells):
    """The whole notebook after a student's bare cell that begins like the answer cell."""
    own = next(c for c in cells if c["id"] == "answer-4-16")
    (copy,) = bare([own])
    return [{**copy, "source": copy["source"] + "\na_D = 1"}, *cells]


AS_RIGHT = {  # changes that cost nothing
    "no receipt cell": lambda c: without(work(c, "dan"), "receipt-4-16"),
    "no statement and no numbers": lambda c: without(work(c, "dan"), "statement-4-16", "givens-4-16", "setup"),
    "a copied receipt cell": lambda c: copied(work(c, "dan"), "receipt-4-16", "receipt('4/16')"),
    "cells in another order": lambda c: with_cells(c, lambda cells: cells[::-1]),
    "no metadata of ours": lambda c: {**work(c, "dan"), "metadata": {}},
    "no nbgrader metadata": lambda c: with_json(c, '"nbgrader"', '"gone"'),
    "metadata of an old schema": lambda c: with_json(c, '"schema_version": 3', '"schema_version": 1'),
    "no metadata and ids of cells": lambda c: with_cells(c, bare),
    "no metadata and ids, in another order": lambda c: with_cells(c, lambda x: bare(x)[::-1]),
    "an own cell that begins as the answer cell": lambda c: with_cells(c, bare_with_a_copy),
    "text as a list of lines": lambda c: with_cells(c, as_lines),
}  # fmt: skip
COPIES = "2 copies of the answer cell; the first one that was filled in was graded"
NOTEBOOKS = {  # how it was changed: (points of dan, problem, words of its note)
    **{how: (change, 11, None, "") for how, change in AS_RIGHT.items()},
    "no answer cell": (
        lambda c: without(work(c, "dan"), "answer-4-16"),
        8,
        "4/16",
        "the answer cell of 4/16 is missing from the notebook; fetch the assignment again",
    ),
    "a copied answer cell": (lambda c: copied(work(c, "dan"), "answer-4-16", "v_D = 1"), 11, "4/16", COPIES),
    "worked in the copy": (worked_in_the_copy, 3, "4/16", COPIES),
    "half a character": (lambda c: work(c, "dan", p4_1="speed = '\ud800'"), 9, None, ""),
    "markup in an error": (
        lambda c: work(
            c, "dan", p4_1="raise ValueError('[/red] [bold] <script>alert(1)</script> ' + chr(27))"
        ),
        9,
        "4/1",
        "[/red] [bold] <script>",
    ),
    "a magic and a shell command": (lambda c: work(c, "dan", p4_1="%matplotlib inline\n!ls\nspeed = 1"), 9, None, ""),
    "ends the process": (
        lambda c: work(c, "dan", p4_31="import os; os._exit(0)"),
        9,
        "4/31",
        "the end of its process: the cell ended Python, crashed it",
    ),
}  # fmt: skip


DAMAGED = {
    "truncated": ('{"cells": [{"cell_type": "co', "is damaged and cannot be read as a notebook"),
    "empty": ("", "ch04.ipynb is empty"),
    "not json": ("# my homework\n", "is damaged and cannot be read as a notebook"),
    "a list": ("[1, 2, 3]", "is not a notebook of format 4: it has no list of cells"),
    "no cells": ('{"nbformat": 4}', "it has no list of cells"),
    "cells of another kind": ('{"cells": 3, "nbformat": 4, "nbformat_minor": 5, "metadata": {}}', "it has no list of cells"),
    "format 3": ('{"worksheets": [], "nbformat": 3, "nbformat_minor": 0, "metadata": {}}', "it has no list of cells"),
    "nested deep": ("[" * 100_000, "is damaged and cannot be read as a notebook"),
}  # fmt: skip
