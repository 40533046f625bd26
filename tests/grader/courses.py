"""Helps for the tests of the grader: command lines, gradebooks, submissions."""

import atexit
import json
import multiprocessing
import os
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

REPOSITORY = Path(__file__).parents[2]


def environment(**more):
    """The environment for a command line: this Python's nbgrader, this repository's grader,
    nobody's configuration.
    """
    own = {
        "PATH": f"{Path(sys.executable).parent}{os.pathsep}{os.environ['PATH']}",
        "PYTHONPATH": str(REPOSITORY),
    }
    return {**os.environ, **own, "JUPYTER_NO_CONFIG": "", "COLUMNS": "200", **more}


def run(*command, cwd=None, timeout=180, **more):
    """A command line: (exit code, everything it said)."""
    done = subprocess.run(
        command,
        cwd=cwd,
        env=environment(**more),
        text=True,
        capture_output=True,
        timeout=timeout,
        check=False,
    )
    return done.returncode, done.stdout + done.stderr


def grader(*arguments, **options):
    """``python -m grader`` with these arguments."""
    return run(sys.executable, "-m", "grader", *map(str, arguments), **options)


def nbgrader(*arguments, cwd, timeout=180, **more):
    """nbgrader's command line in a folder: (exit code, everything it said).

    It runs in a fork of a process that has imported nbgrader, which takes two seconds of every
    command.
    """
    context = multiprocessing.get_context("forkserver")
    context.set_forkserver_preload(["nbgrader.apps.nbgraderapp"])
    with tempfile.NamedTemporaryFile() as output:
        process = context.Process(
            target=_nbgrader,
            args=(list(map(str, arguments)), str(cwd), environment(**more), output.name),
        )
        process.start()
        process.join(timeout)
        process.kill()
        process.join()
        return process.exitcode, output.read().decode()


def _nbgrader(arguments, cwd, variables, output):
    """In the fork: become what a new process of nbgrader's command line would be."""
    with open(output, "wb", buffering=0) as f:
        os.dup2(f.fileno(), 1)
        os.dup2(f.fileno(), 2)
    os.environ.clear()
    os.environ.update(variables)
    os.chdir(cwd)
    path = [p for p in variables["PYTHONPATH"].split(os.pathsep) if p]
    sys.path[:] = path + [p for p in sys.path if p and Path(p) != REPOSITORY]
    sys.argv = ["nbgrader", *arguments]
    from nbgrader.apps.nbgraderapp import main

    try:
        main()
    finally:
        atexit._run_exitfuncs()  # which a process of multiprocessing leaves out


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
    path.write_text(
        notebook if isinstance(notebook, str) else json.dumps(notebook), encoding="utf-8"
    )
    return path


def copy_of(course, folder):
    """An independent copy of a course, with the same secret, to do something to."""
    from grader.course import Course

    shutil.copytree(
        course.path,
        folder,
        ignore=shutil.ignore_patterns("exchange", "homes", "autograded", "feedback", "scores"),
    )
    config = Path(folder) / "nbgrader_config.py"
    config.write_text(config.read_text().replace(str(course.path), str(folder)))
    return Course(folder)


def command(*arguments):
    """``python -m grader`` with these arguments, in this process: (exit code, output)."""
    from click.testing import CliRunner

    from grader.__main__ import main

    result = CliRunner().invoke(main, list(map(str, arguments)), prog_name="python -m grader")
    if result.exception and not isinstance(result.exception, SystemExit):
        raise result.exception
    return result.exit_code, result.output
