"""After any history of changes, ``python -m grader grade`` and ``nbgrader autograde`` leave the same
gradebook and the same notebooks.
"""

import random
import shutil
from datetime import datetime, timedelta

import nbformat
import pytest

from grader.grading import grade
from tests.grader import courses
from tests.grader.instructors_cells import with_texts
from tests.grader.submissions import work

STUDENTS = ("ada", "ben", "dan")
CELLS = {
    "right": {},
    "a wrong part": {"p4_16": "v_D = [1, 2, 3]"},
    "an error": {"p4_1": "1/0"},
    "blank": {"p4_1": "", "p4_31": ""},
}


def resubmit(course, rng):
    student = rng.choice(STUDENTS)
    notebook = work(course, student, **CELLS[rng.choice(list(CELLS))])
    essay, square = rng.choice(["", "Why not."]), rng.choice(["", "def square(x): return x*x"])
    courses.submit(course, student, with_texts(notebook, essay=essay, square=square))
    day = rng.randint(1, 28)
    text = rng.choice([f"2026-10-{day:02d} 10:00:00.000000 UTC", "no time", ""])
    (course.path / "submitted" / student / "ch04" / "timestamp.txt").write_text(text)


def by_hand(course, rng):
    with course.gradebook() as book:
        for name in rng.sample(["essay", "at_home", "answer-4-16"], 2):
            try:
                row = book.find_grade(name, "ch04", "ch04", rng.choice(STUDENTS))
            except Exception:  # nothing was handed in, or the cell is not there
                continue
            row.manual_score, row.extra_credit = rng.choice([None, 1.5]), rng.choice([None, 0.5])
            row.needs_manual_grade = row.auto_score is None and row.manual_score is None
        book.db.commit()


def other_due_date(course, rng):
    with course.gradebook() as book:
        due = datetime(2026, 10, 1) + timedelta(days=rng.randint(0, 27))
        book.find_assignment("ch04").duedate = rng.choice([None, due])
        book.db.commit()


def other_policy(course, rng):
    courses.late_policy(course, rng.choice(["None", "score / 4", "2.0", "-1", "1e9"]))


def other_points(course, rng):
    def change(cells):
        for c in cells:
            marks = c["metadata"].get("nbgrader", {})
            if marks.get("grade") and marks.get("points") and rng.random() < 0.3:
                marks["points"] = rng.randint(1, 9)

    courses.change_source(course, change)


def forgotten(course, rng):
    for folder in rng.sample(["scores", "autograded"], rng.randint(1, 2)):
        shutil.rmtree(course.path / folder, ignore_errors=True)


def graded_once(course, rng):
    grade(course, "ch04", force=rng.random() < 0.3)


CHANGES = (resubmit, resubmit, by_hand, other_due_date, other_policy, other_points, forgotten,
           graded_once, graded_once)  # fmt: skip


def notebooks(course):
    found = {}
    for path in sorted((course.path / "autograded").glob("*/ch04/*")):
        name = str(path.relative_to(course.path))
        found[name] = nbformat.read(path, 4).cells if path.suffix == ".ipynb" else path.read_text()
    return found


@pytest.mark.parametrize(
    "seed", [0, *(pytest.param(s, marks=pytest.mark.slow) for s in range(1, 20))]
)
def test_both_routes_agree_after_a_random_history(mixed, tmp_path, seed):
    rng = random.Random(f"history {seed}")
    resubmit(mixed, rng)
    history = [rng.choice(CHANGES) for _ in range(10)]
    for change in history:
        change(mixed, rng)
    other = courses.copy_of(mixed, tmp_path / "other" / mixed.path.name)
    for name in ("scores", "autograded"):
        if (mixed.path / name).exists():
            shutil.copytree(mixed.path / name, other.path / name, dirs_exist_ok=True)
    grade(mixed, "ch04")
    courses.ran(courses.nbgrader("autograde", "ch04", cwd=other.path))
    names = [change.__name__ for change in history]
    assert courses.gradebook_rows(mixed) == courses.gradebook_rows(other), names
    assert notebooks(mixed) == notebooks(other), names
    before = courses.gradebook_rows(mixed), notebooks(mixed)
    grade(mixed, "ch04")
    assert (courses.gradebook_rows(mixed), notebooks(mixed)) == before, (
        "grading twice changes something"
    )
