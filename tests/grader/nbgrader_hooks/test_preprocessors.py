"""nbgrader autograde gives the same grades; plain nbgrader gives none; the feedback page holds no
key.
"""

import re
import shutil

import pytest

from grader.assignment import master_notebook
from grader.course import write_json
from grader.grading import grade
from tests.grader.courses import forget, nbgrader, points, ran, read, submit, total
from tests.grader.keys import keys
from tests.grader.submissions import DAMAGED, NOTEBOOKS, Named, work


def test_nbgrader_autograde_with_our_settings_gives_the_same_scores_and_comments(course, fresh):
    forget(fresh)
    ran(nbgrader("autograde", "ch04", cwd=fresh.path))
    assert points(fresh) == points(course)
    for s in fresh.roster():
        ours, theirs = (read(c.path / f"autograded/{s}/ch04/ch04.ipynb") for c in (course, fresh))
        assert [c["source"] for c in ours["cells"]] == [c["source"] for c in theirs["cells"]]
        tables = [
            ["".join(o["data"]["text/html"]) for c in n["cells"] for o in c.get("outputs", [])]
            for n in (ours, theirs)
        ]
        assert tables[0] == tables[1]


def test_nbgrader_autograde_again_runs_nothing_again(course, fresh):
    shutil.copytree(course.path / "scores", fresh.path / "scores", dirs_exist_ok=True)
    record = fresh.path / "scores/ch04/ada.json"  # whatever is not run again is taken from here
    record.write_text(record.read_text().replace('"error": null', '"error": "from the record"'))
    ran(nbgrader("autograde", "ch04", "--student=ada", cwd=fresh.path))
    assert "from the record" in record.read_text()


def test_plain_nbgrader_gives_nobody_anything(fresh):
    """Even with the tag skip-execution and an edited receipt cell."""
    (fresh.path / "nbgrader_config.py").write_text(
        "c = get_config()\nc.CourseDirectory.course_id = 'mechanics'\n"
    )
    (fresh.path / "nbgrader_config.json").unlink()
    for s in ("ben", "cleo", "dan"):
        shutil.rmtree(fresh.path / "submitted" / s)
    edited = work(fresh, "eve")
    for c in edited["cells"]:
        if c["metadata"].get("newton_euler", {}).get("role") == "receipt":
            c["source"] = "1.0"
            c["metadata"]["tags"] = ["skip-execution"]
            c["outputs"] = [
                {"output_type": "execute_result", "execution_count": 1, "metadata": {},
                 "data": {"text/plain": "9.0"}}
            ]  # fmt: skip
    submit(fresh, "eve", edited)
    forget(fresh)
    nbgrader("autograde", "ch04", cwd=fresh.path)
    assert not any(map(total, points(fresh).values()))


@pytest.mark.slow
def test_the_same_notebooks_get_the_same_points_from_nbgrader(fresh):
    for name in ("personal/ch04", "submitted"):
        shutil.rmtree(fresh.path / name)
    with fresh.gradebook() as book:
        for n in range(len(NOTEBOOKS)):
            book.add_student(f"dan{n}")
    expected = {}
    for n, (change, right, *_) in enumerate(NOTEBOOKS.values()):
        student = f"dan{n}"
        write_json(fresh.personal_path("ch04", student), master_notebook(fresh, "ch04", student))
        submit(fresh, student, change(Named(fresh, student)))
        expected[student] = right
    assert {r.student: r.points for r in grade(fresh, "ch04")} == expected
    ours = points(fresh)
    ran(nbgrader("autograde", "ch04", "--force", cwd=fresh.path))
    theirs = points(fresh)
    assert {s: theirs[s] for s in expected} == {s: ours[s] for s in expected}


@pytest.mark.slow
def test_nbgrader_reports_a_damaged_notebook_and_a_stranger_and_grades_the_rest(fresh):
    submit(fresh, "nobody", work(fresh, "dan"))
    submit(fresh, "ben", DAMAGED["truncated"][0])
    forget(fresh, "ada", "eve")
    code, out = nbgrader("autograde", "ch04", cwd=fresh.path)
    assert code != 0
    assert "error processing assignment 'ch04' for student 'ben'" in out
    assert "No student with ID 'nobody' exists" in out
    everybody = {s: total(c) for s, c in points(fresh).items()}
    assert (everybody["ada"], everybody["eve"]) == (11, 9)
    assert everybody["ben"] == 6  # as before
    assert "nobody" not in everybody


@pytest.mark.parametrize("student", ["ada", "ben", "mallory"])
def test_the_feedback_page_holds_no_key_that_the_student_did_not_write(course, student):
    page = (course.path / "feedback" / student / "ch04/ch04.html").read_text()
    written = "".join(
        c["source"] for c in read(course.path / "submitted" / student / "ch04/ch04.ipynb")["cells"]
    )
    rounded = re.sub(r"\d+\.\d{8,}", lambda m: f"{float(m[0]):.6g}", written)
    secret = {n for n in keys(course, student) if n not in written and n not in rounded}
    plain_page = re.sub(r"[A-Za-z0-9+/=]{200,}", "", page)
    assert not [n for n in secret if n in plain_page]
    for words in ("def solve", "prove(", course.secret.hex(), "<script", "http://", "https://"):
        assert words not in plain_page
