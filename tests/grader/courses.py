"""Helps for the tests of the grader: command lines, gradebooks, submissions."""

import json
import os
import shutil
import subprocess
import sys
from pathlib import Path

REPOSITORY = Path(__file__).parents[2]


def environment(**more):
    """The environment for a command line: this Python's nbgrader, this repository's grader, nobody's configuration."""
    own = {"PATH": f"{Path(sys.executable).parent}{os.pathsep}{os.environ['PATH']}", "PYTHONPATH": str(REPOSITORY)}
    return {**os.environ, **own, "JUPYTER_NO_CONFIG": "", "COLUMNS": "200", **more}


def run(*command, cwd=None, timeout=180, **more):
    """A command line: (exit code, everything it said)."""
    done = subprocess.run(command, cwd=cwd, env=environment(**more), text=True, capture_output=True, timeout=timeout, check=False)
    return done.returncode, done.stdout + done.stderr


def grader(*arguments, **options):
    """``python -m grader`` with these arguments."""
    return run(sys.executable, "-m", "grader", *map(str, arguments), **options)


def nbgrader(*arguments, cwd, **options):
    """nbgrader's command line, in a course folder."""
    return run("nbgrader", *map(str, arguments), cwd=cwd, **options)


def points(course, assignment="ch04"):
    """{student: {cell: (automatic points, manual points, comment)}} from the gradebook."""
    found = {}
    with course.gradebook() as book:
        for submission in book.assignment_submissions(assignment):
            cells = found.setdefault(submission.student.id, {})
            for notebook in submission.notebooks:
                said = {c.name: c.auto_comment for c in notebook.comments}
                for g in notebook.grades:
                    cells[g.name] = (g.auto_score, g.manual_score, said.get(g.name))
    return found


def total(cells):
    """The automatic points of one student."""
    return sum(automatic or 0 for automatic, _, _ in cells.values())


def read(path):
    """A notebook as a dict, each cell's source as one text."""
    from grader.course import read_json

    return read_json(path)


def submit(course, student, notebook, assignment="ch04", name=None):
    """Put a notebook (dict, or text as it is) where nbgrader collect would."""
    folder = course.path / "submitted" / student / assignment
    folder.mkdir(parents=True, exist_ok=True)
    path = folder / f"{name or assignment}.ipynb"
    path.write_text(notebook if isinstance(notebook, str) else json.dumps(notebook), encoding="utf-8")
    return path


def copy_of(course, folder):
    """An independent copy of a course, with the same secret, to do something to."""
    from grader.course import Course

    shutil.copytree(course.path, folder, ignore=shutil.ignore_patterns("exchange", "homes", "autograded", "feedback", "scores"))
    config = Path(folder) / "nbgrader_config.py"
    config.write_text(config.read_text().replace(str(course.path), str(folder)))
    return Course(folder)
