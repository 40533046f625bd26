"""The same assignment as an instructor would write it for plain nbgrader: for each problem a test
cell that compares the answers with the key and gives a point for each right one.
"""

import copy
import shutil

from grader.assignment.sheet import nbgrader_metadata, own_metadata, tasks
from grader.course import read_json, write_json
from grader.demo import sample_students as sample
from grader.demo.run import require_success

COMPARE = """
import itertools
import numpy as np
import sympy

def flat(x):
    return [y for part in x for y in flat(part)] if np.ndim(x) or isinstance(x, sympy.MatrixBase) else [x]

def value(x, at):
    return x if isinstance(x, str) else complex(sympy.sympify(x).subs(at))

def close(x, y, at):
    a, b = value(x, at), value(y, at)
    return a == b if isinstance(b, str) else abs(a - b) <= 1e-3 * abs(b) + 1e-9

def right(x, key, names):
    try:
        places = [{sympy.Symbol(n, real=True): 0.3 + 0.1 * i + 0.2 * k for i, n in enumerate(names)} for k in range(2)]
        x, key = flat(x), flat(key)
        size = max((abs(value(y, places[0])) for y in key if not isinstance(y, str)), default=0)
        return len(x) == len(key) and all(
            close(a, b, at) or (not isinstance(b, str) and abs(value(a, at) - value(b, at)) <= 1e-3 * size)
            for at in places for a, b in zip(x, key))
    except Exception:
        return False
"""  # the text of a cell


def cell_with_test(task, values):
    """The cell that gives the points of a problem."""
    p = task.exercise
    answers = sample.right_answers(p, values)
    names = list(p.symbols) if any(a.kind.is_formula for a in p.answers) else []
    head = "from sympy import Abs, atan2, cos, pi, sin, sqrt, tan\n" if names else ""
    head += (
        f'{", ".join(names)}, = sympy.symbols("{" ".join(names)}", real=True)\n' if names else ""
    )
    checks = [f"right({key}, {text}, {names})" for key, text in answers.items()]
    marks = {
        "schema_version": 3, "cell_type": "code", "grade": True, "solution": False, "locked": True,
        "task": False, "points": len(checks), "grade_id": f"test-{p.name}",
    }  # fmt: skip
    return {
        "cell_type": "code", "id": f"test-{p.name}", "metadata": {"nbgrader": marks}, "outputs": [],
        "execution_count": None, "source": f"{COMPARE.strip()}\n{head}float({' + '.join(checks)})",
    }  # fmt: skip


def with_tests(notebook, values):
    """The notebook with a test cell behind each receipt, and answers without points."""
    notebook, asked, cells = copy.deepcopy(notebook), tasks(notebook), []
    for cell in notebook["cells"]:
        own = own_metadata(cell)
        if own.get("role") == "answer":
            nbgrader_metadata(cell).update(grade=False)
            nbgrader_metadata(cell).pop("points", None)
        cells.append(cell)
        if own.get("role") == "receipt":
            cells.append(cell_with_test(asked[own["problem"]], values[own["problem"]]))
    return {**notebook, "cells": cells}


def plain_course(course, students, values, folder):
    """nbgrader's API, unmodified, for a course in ``folder`` with the work of these students."""
    from nbgrader.api import Gradebook
    from nbgrader.apps import NbGraderAPI
    from nbgrader.coursedir import CourseDirectory
    from traitlets.config import Config

    config = Config()
    url = f"sqlite:///{folder / 'gradebook.db'}"
    config.CourseDirectory.root, config.CourseDirectory.db_url = str(folder), url
    config.Execute.timeout = 120
    write_json(
        folder / "source/ch04/ch04.ipynb", with_tests(read_json(course.source("ch04")), values)
    )
    with Gradebook(url) as book:
        for s in students:
            book.add_student(s)
    api = NbGraderAPI(CourseDirectory(config=config), config=config)
    require_success(api.generate_assignment("ch04"))
    for s in students:
        submitted = course.path / "submitted" / s / "ch04/ch04.ipynb"
        notebook = with_tests(read_json(submitted), values)
        write_json(folder / "submitted" / s / "ch04/ch04.ipynb", notebook)
    shutil.rmtree(folder / "autograded", ignore_errors=True)
    return api


def plain_points(folder, student):
    """{problem's file name: points} that nbgrader has given."""
    from nbgrader.api import Gradebook

    with Gradebook(f"sqlite:///{folder / 'gradebook.db'}") as book:
        notebook = book.find_submission_notebook("ch04", "ch04", student)
        scores = {g.name: g.auto_score for g in notebook.grades}
    return {n.removeprefix("test-"): x for n, x in scores.items() if n.startswith("test-")}
