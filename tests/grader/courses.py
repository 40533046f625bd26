"""Helpers for the tests of the grader: command lines, gradebooks, submissions."""

import atexit
import contextlib
import json
import multiprocessing
import os
import resource
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

REPOSITORY = Path(__file__).parents[2]


def environment(**more):
    """An environment with this Python's nbgrader, this grader and no user's configuration."""
    path = f"{Path(sys.executable).parent}{os.pathsep}{os.environ['PATH']}"
    own = {"PATH": path, "PYTHONPATH": str(REPOSITORY), "JUPYTER_NO_CONFIG": "", "COLUMNS": "200"}
    return {**os.environ, **own, **more}


def run(*command, cwd=None, timeout=180, **more):
    """Run a command line: (exit code, everything it printed)."""
    done = subprocess.run(
        command, cwd=cwd, env=environment(**more), text=True, capture_output=True, timeout=timeout,
        check=False,
    )  # fmt: skip
    return done.returncode, done.stdout + done.stderr


def grader(*arguments, **options):
    """``python -m grader`` with these arguments."""
    return run(sys.executable, "-m", "grader", *map(str, arguments), **options)


def ran(done):
    """The output of a command line that must succeed."""
    code, out = done
    assert code == 0, out
    return out


def refused(done, expected=2):
    """The output, on one line, of a command line that ends with this exit code; None: any but 0."""
    code, out = done
    assert code == expected if expected else code not in (0, None), out
    assert not expected or "Traceback" not in out
    return " ".join(out.replace("│", " ").split())


def nbgrader(*arguments, cwd, timeout=180, memory=None, **more):
    """(exit code, output) of its command line in a fork that has imported it; ``memory`` in bytes."""
    context = multiprocessing.get_context("forkserver")
    context.set_forkserver_preload(["nbgrader.apps.nbgraderapp"])
    with tempfile.NamedTemporaryFile() as output:
        given = list(map(str, arguments)), str(cwd), environment(**more), output.name, memory
        process = context.Process(target=_nbgrader, args=given)
        process.start()
        process.join(timeout)
        process.kill()
        process.join()
        return process.exitcode, output.read().decode()


def _nbgrader(arguments, cwd, variables, output, memory):
    """In the fork: reset the state to that of a new process of nbgrader's command line."""
    if memory:
        resource.setrlimit(resource.RLIMIT_AS, (memory, memory))
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
                printed = {c.name: c.auto_comment for c in notebook.comments}
                for g in notebook.grades:
                    cells[g.name] = (g.auto_score, g.manual_score, printed.get(g.name))
    return found


def total(cells):
    """The automatic points of one student."""
    return sum(automatic or 0 for automatic, _, _ in cells.values())


def read(path):
    """A notebook as a dict, each cell's source as one text."""
    from grader.course import read_json

    return read_json(path)


def released_sheet(course, assignment="ch04"):
    """The notebook that nbgrader generated for release."""
    return read(course.released_path(assignment))


def submit(course, student, notebook, assignment="ch04", name=None):
    """Put a notebook (a dict, or its raw text) where nbgrader collect would."""
    folder = course.path / "submitted" / student / assignment
    folder.mkdir(parents=True, exist_ok=True)
    path = folder / f"{name or assignment}.ipynb"
    path.write_text(notebook if isinstance(notebook, str) else json.dumps(notebook), "utf-8")
    return path


def change_source(course, change, assignment="ch04", copies=True):
    """Apply ``change(cells)`` to the source notebook and generate the personal copies again."""
    from grader.assignment import make_personal_copies

    path = course.source(assignment)
    notebook = read(path)
    change(notebook["cells"])
    path.write_text(json.dumps(notebook), "utf-8")
    ran(nbgrader("generate_assignment", assignment, "--force", cwd=course.path))
    if copies:
        make_personal_copies(course, assignment, workers=1)


def append_config(course, text):
    """Add the instructor's own settings to the configuration of a course."""
    with open(course.path / "nbgrader_config.py", "a") as f:
        f.write(f"\n{text}\n")


def late_policy(course, penalty):
    """Install a late-submission plugin; ``penalty``: Python in score and total_seconds_late."""
    path = course.path / "my_policy.py"
    if not path.exists():
        append_config(
            course,
            "import sys\nsys.path.insert(0, c.CourseDirectory.root)\n"
            "c.AssignLatePenalties.plugin_class = 'my_policy.Policy'",
        )
    path.write_text(
        "from nbgrader.plugins import LateSubmissionPlugin\n\n\n"
        "class Policy(LateSubmissionPlugin):\n"
        "    def late_submission_penalty(self, student_id, score, total_seconds_late):\n"
        f"        return {penalty}\n"
    )


def gradebook_rows(course, assignment="ch04"):
    """Everything in the gradebook on an assignment's submissions, in a fixed order."""
    rows = []
    with course.gradebook() as book:
        for s in book.assignment_submissions(assignment):
            for n in s.notebooks:
                rows.append((s.student.id, s.timestamp, n.name, n.late_submission_penalty, n.score))
                rows += [
                    (s.student.id, g.name, g.auto_score, g.manual_score, g.extra_credit,
                     g.needs_manual_grade)
                    for g in n.grades
                ]  # fmt: skip
                texts = [(c.name, c.auto_comment, c.manual_comment) for c in n.comments]
                rows += [(s.student.id, "comment", *c) for c in texts]
    return sorted(rows, key=repr)


def give(course, student, cell, points, extra, comment, assignment="ch04"):
    """Give points, extra credit and a comment for a cell, as a person does in the formgrader."""
    place = cell, assignment, assignment, student
    with course.gradebook() as book:
        row = book.find_grade(*place)
        row.manual_score, row.extra_credit, row.needs_manual_grade = points, extra, False
        book.find_comment(*place).manual_comment = comment
        book.db.commit()


def copy_of(course, folder):
    """An independent copy of a course, with the same secret, that a test may change."""
    from grader.course import Course

    left_out = shutil.ignore_patterns("exchange", "homes", "autograded", "feedback", "scores")
    shutil.copytree(course.path, folder, ignore=left_out)
    config = Path(folder) / "nbgrader_config.py"
    config.write_text(config.read_text().replace(str(course.path), str(folder)))
    return Course(folder)


def forget(course, *students):
    """Remove the grades of these students, or of all, from the gradebook."""
    from nbgrader.api import MissingEntry

    with course.gradebook() as book:
        for student in students or course.roster():
            with contextlib.suppress(MissingEntry):
                book.remove_submission("ch04", student)


def emptied(course):
    """The course with all submissions removed."""
    shutil.rmtree(course.path / "submitted")
    forget(course)
    return course


def command(*arguments):
    """``python -m grader`` with these arguments, in this process: (exit code, output)."""
    from click.testing import CliRunner

    from grader.__main__ import main  # a fork of nbgrader() imports this file, but no grader

    result = CliRunner().invoke(main, list(map(str, arguments)), prog_name="python -m grader")
    if result.exception and not isinstance(result.exception, SystemExit):
        raise result.exception
    return result.exit_code, result.output
