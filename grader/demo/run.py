"""``python -m grader demo``: the whole way on an example."""

import sys
import time

from ..assignment import notebook as nb
from ..assignment.build import build_assignment, course_config
from ..assignment.personal import into_exchange, make_personal
from ..course import read_json, write_json
from ..grading.run import grade
from ..table import diagnoses, gradebook_table
from . import sample_students as students

CHAPTER = "ch04"
PEOPLE = {
    "ada": "all right",
    "ben": "leaves a term out throughout",
    "cleo": "half done",
    "dan": "blank",
    "eve": "a syntax error in one cell",
    "mallory": "hostile: tags, forged output, patched checker",
}


def run(folder, only, console, bar):
    """Make a course in ``folder``, play six students, grade them, and say what came out and where to look."""
    start = time.perf_counter()
    console.print(f"[bold]A course in {folder}[/]")
    with bar() as progress:
        course, _ = build_assignment(folder, CHAPTER, None, only, False, progress)
    course.enrol([{"id": s, "first_name": s.capitalize(), "last_name": what} for s, what in PEOPLE.items()])
    exchange = course.path / "exchange"
    exchange.mkdir(mode=0o777)
    with open(course.path / "nbgrader_config.py", "a", encoding="utf-8") as f:
        f.write("\nfrom pathlib import Path\n\nc.Exchange.root = str(Path(__file__).resolve().parent / 'exchange')  # the demo's own\n")
    console.print("[bold]Release:[/] nbgrader generate_assignment and release_assignment; everyone's own numbers and figures")
    api = _quiet_api(course)
    _done(api.generate_assignment(CHAPTER))
    with bar() as progress:
        task = progress.add_task("personal copies", total=1.0)
        paths = make_personal(course, CHAPTER, progress=lambda share: progress.advance(task, share))
    _exchange(course, "release_assignment")  # without the personal copies, which it would draw again
    into_exchange(course, CHAPTER, exchange / course.name / "outbound" / CHAPTER, paths)
    console.print("[bold]Fetch, work, submit:[/] six students")
    expected = _play(course, console)
    _exchange(course, "collect")
    console.print("[bold]Grade:[/] rebuilt from source, run in a cage, scored by a process that runs no student code")
    with bar() as progress:
        task = progress.add_task("grading", total=len(PEOPLE))
        results = grade(course, CHAPTER, progress=lambda r: progress.advance(task))
    console.print("[bold]Feedback:[/] nbgrader generate_feedback")
    with bar() as progress:
        task = progress.add_task("feedback pages", total=len(PEOPLE))
        for s in PEOPLE:
            _done(api.generate_feedback(CHAPTER, s))
            progress.advance(task)
    console.print(gradebook_table(results))
    console.print(diagnoses([r for r in results if r.student == "ben"], most=8))
    surprises = [
        f"{r.student}: expected {expected[r.student]}, got {r.points:g}. {r.problem}"
        for r in results
        if r.problem or r.points not in expected[r.student]
    ]
    for sentence in surprises:
        console.print(f"[red]{sentence}[/]")
    _say_where(course, console, time.perf_counter() - start)
    if surprises or len(results) != len(PEOPLE):
        sys.exit(1)


def _play(course, console):
    """Fetch, fill in and submit for everyone; returns {student: the points that are right for them}."""
    expected = {}
    for student, what in PEOPLE.items():
        home = course.path / "homes" / student
        home.mkdir(parents=True)
        _exchange(course, "fetch_assignment", student, home)
        path = home / CHAPTER / f"{CHAPTER}.ipynb"
        fetched = read_json(path)
        problems = nb.problems_of(fetched)
        values = course.values(CHAPTER, student, problems)  # the demo knows; the students read them off their notebooks
        notebook, points = _work(student, fetched, problems, values)
        path.chmod(0o644)
        write_json(path, notebook)
        expected[student] = points
        _exchange(course, "submit", student, home)
        console.print(f"  {student:8} {what}")
    return expected


def _work(student, fetched, problems, values):
    total = sum(len(p.answers) for p in problems)
    own = {p.id: students.cell(p, students.right(p, values[p.id])) for p in problems}
    if student == "ada":
        return students.filled(fetched, own), {total}
    if student == "ben":
        spoiled = 0
        for p in problems:
            answers, keys = students.leaves_out(p, values[p.id])
            own[p.id] = students.cell(p, answers)
            spoiled += len(keys)
        return students.filled(fetched, own), {total - spoiled}
    if student == "cleo":
        half = problems[: len(problems) // 2]
        return students.filled(fetched, {p.id: own[p.id] for p in half}), {sum(len(p.answers) for p in half)}
    if student == "dan":
        return fetched, {0}
    if student == "eve":
        own[problems[0].id] += "\nand the rest = (1"
        return students.filled(fetched, own), {total - len(problems[0].answers)}
    return students.hostile(fetched, problems), {0}


def _quiet_api(course):
    import logging

    from nbgrader.apps import NbGraderAPI
    from nbgrader.coursedir import CourseDirectory

    config = course_config(course)
    logging.getLogger("traitlets").setLevel(logging.ERROR)
    return NbGraderAPI(CourseDirectory(config=config), config=config)


def _exchange(course, step, student="*", home=None):
    """One step of nbgrader's exchange, in process: its command line takes 2.4 s to start."""
    import contextlib
    import importlib
    import logging
    import os

    from nbgrader.auth import Authenticator
    from nbgrader.coursedir import CourseDirectory
    from nbgrader.exchange import default

    config = course_config(course)
    config.CourseDirectory.assignment_id = CHAPTER
    config.CourseDirectory.student_id = student
    kinds = {
        "release_assignment": lambda: default.ExchangeReleaseAssignment,
        "fetch_assignment": lambda: importlib.import_module("grader.assignment.fetch").PersonalFetch,
        "submit": lambda: default.ExchangeSubmit,
        "collect": lambda: default.ExchangeCollect,
    }
    logging.getLogger("traitlets").setLevel(logging.ERROR)
    if home:
        config.CourseDirectory.root = str(home)
        config.Exchange.assignment_dir = str(home)
    before = {k: os.environ.get(k) for k in ("USER", "LOGNAME", "JUPYTERHUB_USER")}
    with contextlib.chdir(home or course.path):
        os.environ.update(dict.fromkeys(before, student) if home else {})
        try:
            coursedir = CourseDirectory(config=config)
            kinds[step]()(coursedir=coursedir, authenticator=Authenticator(config=config), config=config).start()
        finally:
            for k, v in before.items():
                os.environ.pop(k, None) if v is None else os.environ.__setitem__(k, v)


def _done(result):
    if not result["success"]:
        raise RuntimeError(f"nbgrader failed: {result.get('error') or result.get('log')}")


def _say_where(course, console, seconds):
    console.print(f"\nDone in {seconds:.0f} s. Look at")
    console.print(f"  what a student fetches   {course.path / 'homes/dan' / CHAPTER / (CHAPTER + '.ipynb')}", soft_wrap=True)
    console.print(f"  a feedback page          {course.path / 'feedback/ben' / CHAPTER / (CHAPTER + '.html')}", soft_wrap=True)
    console.print(
        f"  the gradebook            {course.path / 'gradebook.db'}: cd {course.path} && jupyter lab, then Nbgrader > Formgrader", soft_wrap=True
    )
    console.print("Next: python -m grader build --help makes a course of your own.")
