"""The demo: build, release, six students' work, grading, feedback pages."""

import contextlib
import logging
import os
import shutil
import sys
import time
from collections.abc import Callable, Collection, Mapping
from pathlib import Path
from typing import Any
from unittest import mock

from rich.console import Console
from rich.progress import Progress

from ..assignment import (
    build_assignment,
    copy_to_exchange,
    exchange_outbound,
    make_personal_copies,
    problems_of,
)
from ..course import Course, read_json, write_json
from ..grading import grade
from ..reports import diagnosis_table, gradebook_table
from .sample_students import STUDENTS, submission

EXCHANGE_WITHIN = "c.Exchange.root = str(Path(__file__).resolve().parent / 'exchange')\n"
MARK = ".newton_euler_demo"  # a folder with this file may be replaced


def run_demo(
    folder: Path,
    chapter: str,
    only: Collection[str],
    console: Console,
    bar: Callable[[], contextlib.AbstractContextManager[Progress]],
    counted: Callable[[str, float], contextlib.AbstractContextManager[Callable[..., None]]],
) -> None:
    """Make a course in ``folder`` and run all steps; exit with 1 if a student's points are not as
    expected.

    chapter : whose problems are handed out
    only : numbers of the problems to include; default: all
    bar : makes a ``rich`` progress bar
    counted : shows progress; gives a function to call after each step
    """
    start = time.perf_counter()
    console.print(f"[bold]A course in {folder}[/]")
    if (folder / MARK).exists():  # any other existing folder is refused by the build
        console.print(f"Removing the earlier demo in {folder}")
        shutil.rmtree(folder)
    with bar() as progress:
        course = build_assignment(folder, chapter, only=only, bar=progress).course
    _use_exchange_within(course)
    course.enrol(
        {"id": s, "first_name": s.capitalize(), "last_name": what} for s, what in STUDENTS.items()
    )
    console.print(
        "[bold]Release:[/] nbgrader generate_assignment and release_assignment, and each "
        "student's own numbers and figures"
    )
    api = nbgrader_api(course)
    require_success(api.generate_assignment(chapter))
    with counted("personal copies", 1.0) as advance:
        paths = make_personal_copies(course, chapter, progress=advance)
    # nbgrader's own step: ours would make the personal copies again
    _exchange_step(course, chapter, "release_assignment")
    copy_to_exchange(course, chapter, exchange_outbound(course, chapter), paths)
    console.print("[bold]Fetch, work, submit:[/] six students")
    expected = _fetch_and_submit(course, chapter, console)
    _exchange_step(course, chapter, "collect")
    console.print(
        "[bold]Grade:[/] rebuild each notebook, run its answers in the sandbox, score them in "
        "a process that runs no student code"
    )
    with counted("grading", len(STUDENTS)) as advance:
        results = grade(course, chapter, progress=lambda result: advance())
    console.print("[bold]Feedback:[/] nbgrader generate_feedback")
    with counted("feedback pages", len(STUDENTS)) as advance:
        for s in STUDENTS:
            require_success(api.generate_feedback(chapter, s))
            advance()
    console.print(gradebook_table(results))
    console.print(diagnosis_table([r for r in results if r.student == "ben"], most=8))
    unexpected = [r for r in results if r.problem or r.points != expected[r.student]]
    for r in unexpected:
        wanted = f"expected {expected[r.student]:g} points, got {r.points:g}"
        console.print(f"[red]{r.student}: {wanted}. {r.problem}[/]")
    _print_paths(course, chapter, console, time.perf_counter() - start)
    if unexpected or len(results) != len(STUDENTS):
        sys.exit(1)


def _use_exchange_within(course):
    """Give the demo an exchange in its own folder, wherever that is moved."""
    (course.path / MARK).touch()
    (course.path / "exchange").mkdir(mode=0o777)
    with open(course.path / "nbgrader_config.py", "a", encoding="utf-8") as f:
        f.write(EXCHANGE_WITHIN)


def _fetch_and_submit(course, chapter, console):
    """Fetch, fill in and submit for every student; returns {student: the expected points}."""
    expected = {}
    for student, what in STUDENTS.items():
        home = course.path / "homes" / student
        home.mkdir(parents=True)
        _exchange_step(course, chapter, "fetch_assignment", student, home)
        path = home / chapter / f"{chapter}.ipynb"
        fetched = read_json(path)
        problems = problems_of(fetched)
        # which a real student reads in the notebook
        values = course.values(chapter, student, problems)
        notebook, expected[student] = submission(student, fetched, problems, values)
        path.chmod(0o644)
        write_json(path, notebook)
        _exchange_step(course, chapter, "submit", student, home)
        console.print(f"  {student:8} {what}")
    return expected


def nbgrader_api(course: Course) -> Any:
    """nbgrader's API for a course, without its log."""
    from nbgrader.apps import NbGraderAPI
    from nbgrader.coursedir import CourseDirectory

    config = course.config()
    logging.getLogger("traitlets").setLevel(logging.ERROR)
    return NbGraderAPI(CourseDirectory(config=config), config=config)


def require_success(result: Mapping[str, Any]) -> None:
    """Raise RuntimeError if a call of nbgrader's API failed."""
    if not result["success"]:
        raise RuntimeError(f"nbgrader failed: {result.get('error') or result.get('log')}")


def _exchange_step(course, chapter, step, student="*", home=None):
    """A step of nbgrader's exchange, in this process: its command line takes 2.4 s to start."""
    from nbgrader.auth import Authenticator
    from nbgrader.coursedir import CourseDirectory
    from nbgrader.exchange import default

    from ..assignment.fetch import PersonalFetch
    from ..nbgrader_hooks.collect import CollectRegularFiles

    steps = {
        "release_assignment": default.ExchangeReleaseAssignment,
        "fetch_assignment": PersonalFetch,
        "submit": default.ExchangeSubmit,
        "collect": CollectRegularFiles,
    }
    config = course.config()
    config.CourseDirectory.assignment_id = chapter
    config.CourseDirectory.student_id = student
    logging.getLogger("traitlets").setLevel(logging.ERROR)
    if home:
        config.CourseDirectory.root = str(home)
        config.Exchange.assignment_dir = str(home)
    names = ("USER", "LOGNAME", "JUPYTERHUB_USER") if home else ()
    user = mock.patch.dict(os.environ, dict.fromkeys(names, student))
    with contextlib.chdir(home or course.path), user:
        given = {"coursedir": CourseDirectory(config=config), "config": config}
        steps[step](**given, authenticator=Authenticator(config=config)).start()


def _print_paths(course, chapter, console, seconds):
    console.print(f"\nDone in {seconds:.0f} s. Look at")
    for what, path in {
        "what a student fetches   ": course.path / f"homes/dan/{chapter}/{chapter}.ipynb",
        "a feedback page          ": course.path / f"feedback/ben/{chapter}/{chapter}.html",
        "the gradebook            ": f"{course.path / 'gradebook.db'}: cd {course.path} && "
        "jupyter lab, then Nbgrader > Formgrader",
    }.items():
        console.print(f"  {what}{path}", soft_wrap=True)
    console.print("Next: python -m grader build --help says how to make a course of your own.")
