"""Runs the demo: builds and releases an assignment, plays six students, grades them, and writes
their feedback pages.
"""

import contextlib
import logging
import os
import shutil
import sys
import time
from pathlib import Path

from ..assignment import build_assignment, copy_to_exchange, make_personal_copies, problems_of
from ..course import read_json, write_json
from ..grading import grade
from ..reports import diagnosis_table, gradebook_table
from . import sample_students as sample

MARK = ".newton_euler_demo"  # a folder with this file in it may be made anew
STUDENTS = {
    "ada": "all right",
    "ben": "leaves out one term in every problem",
    "cleo": "answers half of the problems",
    "dan": "answers nothing",
    "eve": "has a syntax error in one cell",
    "mallory": "hostile: cell tags, forged outputs, a patched checker",
}
DEMO_CONFIG = (
    "\nfrom pathlib import Path\n\nc.Exchange.root = str(Path(__file__).resolve().parent / "
    "'exchange')  # an exchange of the demo's own\n"
)


def run_demo(folder, chapter, only, console, bar):
    """Make a course in ``folder`` and take it through all steps; exits with 1 if a student's points
    are not as expected.

    chapter : whose problems are handed out
    only : numbers of the problems to include; default: all
    bar : makes a ``rich`` progress bar
    """
    start = time.perf_counter()
    console.print(f"[bold]A course in {folder}[/]")
    _clear_earlier(Path(folder), console)
    exchange = Path(folder).resolve() / "exchange"
    with bar() as progress:
        course = build_assignment(folder, chapter, only=only, bar=progress).course
    _use_exchange_within(course)
    course.enrol(
        [{"id": s, "first_name": s.capitalize(), "last_name": what} for s, what in STUDENTS.items()]
    )
    console.print(
        "[bold]Release:[/] nbgrader generate_assignment and release_assignment, and each "
        "student's own numbers and figures"
    )
    api = nbgrader_api(course)
    require_success(api.generate_assignment(chapter))
    with bar() as progress:
        task = progress.add_task("personal copies", total=1.0)
        paths = make_personal_copies(
            course, chapter, progress=lambda share: progress.advance(task, share)
        )
    # nbgrader's own step, which does not draw the personal copies again
    _exchange_step(course, chapter, "release_assignment")
    copy_to_exchange(course, chapter, exchange / course.name / "outbound" / chapter, paths)
    console.print("[bold]Fetch, work, submit:[/] six students")
    expected = _fetch_and_submit(course, chapter, console)
    _exchange_step(course, chapter, "collect")
    console.print(
        "[bold]Grade:[/] rebuild each notebook, run its answers in the sandbox, score them in "
        "a process that runs no student code"
    )
    with bar() as progress:
        task = progress.add_task("grading", total=len(STUDENTS))
        results = grade(course, chapter, progress=lambda r: progress.advance(task))
    console.print("[bold]Feedback:[/] nbgrader generate_feedback")
    with bar() as progress:
        task = progress.add_task("feedback pages", total=len(STUDENTS))
        for s in STUDENTS:
            require_success(api.generate_feedback(chapter, s))
            progress.advance(task)
    console.print(gradebook_table(results))
    console.print(diagnosis_table([r for r in results if r.student == "ben"], most=8))
    unexpected = [r for r in results if r.problem or r.points != expected[r.student]]
    for r in unexpected:
        console.print(
            f"[red]{r.student}: expected {expected[r.student]:g} points, got {r.points:g}. "
            f"{r.problem}[/]"
        )
    _print_paths(course, chapter, console, time.perf_counter() - start)
    if unexpected or len(results) != len(STUDENTS):
        sys.exit(1)


def _clear_earlier(folder, console):
    """Remove what an earlier demo made; another folder is left to the build, which refuses it."""
    if (folder / MARK).exists():
        console.print(f"Removing the earlier demo in {folder}")
        shutil.rmtree(folder)


def _use_exchange_within(course):
    """Give the demo an exchange of its own, inside the course folder."""
    (course.path / MARK).touch()
    (course.path / "exchange").mkdir(mode=0o777)
    with open(course.path / "nbgrader_config.py", "a", encoding="utf-8") as f:
        f.write(DEMO_CONFIG)


def _fetch_and_submit(course, chapter, console):
    """Fetch, fill in and submit the assignment for every student; returns {student: the expected
    points}.
    """
    expected = {}
    for student, what in STUDENTS.items():
        home = course.path / "homes" / student
        home.mkdir(parents=True)
        _exchange_step(course, chapter, "fetch_assignment", student, home)
        path = home / chapter / f"{chapter}.ipynb"
        fetched = read_json(path)
        problems = problems_of(fetched)
        # a real student reads them in the notebook
        values = course.values(chapter, student, problems)
        notebook, expected[student] = _filled_in(student, fetched, problems, values)
        path.chmod(0o644)
        write_json(path, notebook)
        _exchange_step(course, chapter, "submit", student, home)
        console.print(f"  {student:8} {what}")
    return expected


def _filled_in(student, fetched, problems, values):
    """(notebook as the student submits it, expected points)."""
    total = sum(len(p.answers) for p in problems)
    texts = {p.id: sample.cell_text(p, sample.right_answers(p, values[p.id])) for p in problems}
    if student == "ada":
        return sample.fill_in(fetched, texts), total
    if student == "ben":
        wrong = 0
        for p in problems:
            answers, keys = sample.answers_without_a_term(p, values[p.id])
            texts[p.id] = sample.cell_text(p, answers)
            wrong += len(keys)
        return sample.fill_in(fetched, texts), total - wrong
    if student == "cleo":
        half = problems[: len(problems) // 2]
        return sample.fill_in(fetched, {p.id: texts[p.id] for p in half}), sum(
            len(p.answers) for p in half
        )
    if student == "dan":
        return fetched, 0
    if student == "eve":
        texts[problems[0].id] += "\nand the rest = (1"
        return sample.fill_in(fetched, texts), total - len(problems[0].answers)
    return sample.hostile(fetched, problems), 0


def nbgrader_api(course):
    """nbgrader's API for a course, without its log."""
    from nbgrader.apps import NbGraderAPI
    from nbgrader.coursedir import CourseDirectory

    config = course.config()
    logging.getLogger("traitlets").setLevel(logging.ERROR)
    return NbGraderAPI(CourseDirectory(config=config), config=config)


def require_success(result):
    """Raise RuntimeError if a call of nbgrader's API failed."""
    if not result["success"]:
        raise RuntimeError(f"nbgrader failed: {result.get('error') or result.get('log')}")


def _exchange_step(course, chapter, step, student="*", home=None):
    """Run one step of nbgrader's exchange in this process, since its command line takes 2.4 s to
    start.
    """
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
    before = {k: os.environ.get(k) for k in ("USER", "LOGNAME", "JUPYTERHUB_USER")}
    with contextlib.chdir(home or course.path):
        os.environ.update(dict.fromkeys(before, student) if home else {})
        try:
            coursedir = CourseDirectory(config=config)
            steps[step](
                coursedir=coursedir, authenticator=Authenticator(config=config), config=config
            ).start()
        finally:
            for k, v in before.items():
                os.environ.pop(k, None) if v is None else os.environ.__setitem__(k, v)


def _print_paths(course, chapter, console, seconds):
    console.print(f"\nDone in {seconds:.0f} s. Look at")
    console.print(
        f"  what a student fetches   {course.path / 'homes/dan' / chapter / (chapter + '.ipynb')}",
        soft_wrap=True,
    )
    console.print(
        "  a feedback page          "
        f"{course.path / 'feedback/ben' / chapter / (chapter + '.html')}",
        soft_wrap=True,
    )
    console.print(
        f"  the gradebook            {course.path / 'gradebook.db'}: cd {course.path} && "
        "jupyter lab, then Nbgrader > Formgrader",
        soft_wrap=True,
    )
    console.print("Next: python -m grader build --help says how to make a course of your own.")
