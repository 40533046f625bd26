"""Plain nbgrader gives no grades; the feedback page holds no key. That nbgrader autograde with our
steps gives those of the grader: tests/grader/grading/test_histories.py.
"""

import re
import shutil

import pytest

from tests.grader.courses import forget, nbgrader, points, ran, read, submit, total
from tests.grader.keys import keys
from tests.grader.submissions import DAMAGED, work


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
