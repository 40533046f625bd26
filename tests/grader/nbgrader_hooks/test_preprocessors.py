"""Two routes to the same grades; plain nbgrader gives none; what a human wrote stays; only what changed runs again."""

import json
import shutil

import pytest

from grader.demo import sample_students as sample
from grader.grading import grade
from tests.grader.courses import nbgrader, points, read, submit, total


def work(course, student, **changed):
    """A right notebook of this student; ``changed`` replaces the text of answer cells, as p4_16="...")."""
    own = read(course.personal_path("ch04", student))
    from grader.assignment import notebook as nb

    problems = nb.problems_of(own)
    values = course.values("ch04", student, problems)
    texts = {p.id: sample.cell_text(p, sample.right_answers(p, values[p.id])) for p in problems}
    return sample.fill_in(own, {**texts, **{k[1:].replace("_", "/"): v for k, v in changed.items()}})


def said(course):
    return {s: {c: comment for c, (_, _, comment) in cells.items()} for s, cells in points(course).items()}


def scores(course):
    return {s: {c: automatic for c, (automatic, _, _) in cells.items()} for s, cells in points(course).items()}


def test_nbgrader_autograde_under_our_configuration_gives_the_same_scores_and_comments(course, fresh):
    with fresh.gradebook() as book:
        for s in fresh.roster():
            book.remove_submission("ch04", s)
    code, out = nbgrader("autograde", "ch04", cwd=fresh.path)
    assert code == 0, out
    assert scores(fresh) == scores(course)
    assert said(fresh) == said(course)
    for s in fresh.roster():
        ours, theirs = (read(c.path / "autograded" / s / "ch04/ch04.ipynb") for c in (course, fresh))
        assert [c["source"] for c in ours["cells"]] == [c["source"] for c in theirs["cells"]]
        tables = [["".join(o["data"]["text/html"]) for c in n["cells"] for o in c.get("outputs", [])] for n in (ours, theirs)]
        assert tables[0] == tables[1]


def test_plain_nbgrader_gives_nobody_anything(fresh):
    """Without our steps: the cells with points have no outputs or fail; also with the tag skip-execution and an edited receipt cell."""
    (fresh.path / "nbgrader_config.py").write_text("c = get_config()\nc.CourseDirectory.course_id = 'mechanics'\n")
    for s in ("ben", "cleo", "dan"):
        shutil.rmtree(fresh.path / "submitted" / s)
    edited = work(fresh, "eve")
    for c in edited["cells"]:
        if c["metadata"].get("newton_euler", {}).get("role") == "receipt":
            c["source"] = "1.0"
            c["metadata"]["tags"] = ["skip-execution"]
            c["outputs"] = [{"output_type": "execute_result", "execution_count": 1, "metadata": {}, "data": {"text/plain": "9.0"}}]
    submit(fresh, "eve", edited)
    with fresh.gradebook() as book:
        for s in fresh.roster():
            book.remove_submission("ch04", s)
    nbgrader("autograde", "ch04", cwd=fresh.path)
    for s, cells in scores(fresh).items():
        assert sum(p or 0 for p in cells.values()) == 0, (s, cells)


def test_what_a_human_grader_gave_and_wrote_survives_grading_again(fresh):
    grade(fresh, "ch04", ["ben"])
    with fresh.gradebook() as book:
        given = book.find_grade("answer-4-16", "ch04", "ch04", "ben")
        given.manual_score, given.needs_manual_grade = 2.5, False
        book.find_comment("answer-4-16", "ch04", "ch04", "ben").manual_comment = "a good attempt"
        book.db.commit()
    submit(fresh, "ben", work(fresh, "ben", p4_1="speed = 1.0\nacc_mag = 2.0"))
    (result,) = grade(fresh, "ch04", ["ben"])
    assert not result.unchanged
    with fresh.gradebook() as book:
        given = book.find_grade("answer-4-16", "ch04", "ch04", "ben")
        assert (given.auto_score, given.manual_score, given.score) == (3, 2.5, 2.5)
        assert book.find_comment("answer-4-16", "ch04", "ch04", "ben").manual_comment == "a good attempt"


def test_unchanged_submissions_are_not_run_again_and_changed_ones_are(fresh, monkeypatch):
    from grader.submission import pipeline

    ran = []
    original = pipeline.run_answers
    monkeypatch.setattr(pipeline, "run_answers", lambda h, own, answers: ran.append(own.student) or original(h, own, answers))
    everyone = sorted(fresh.roster())
    first = {r.student: r.points for r in grade(fresh, "ch04")}
    assert sorted(ran) == everyone
    ran.clear()
    again = grade(fresh, "ch04")
    assert ran == []
    assert all(r.unchanged for r in again)
    assert {r.student: r.points for r in again} == first
    submit(fresh, "dan", work(fresh, "dan"))
    assert {r.student: r.unchanged for r in grade(fresh, "ch04")} == {s: s != "dan" for s in everyone}
    assert ran == ["dan"]
    ran.clear()
    grade(fresh, "ch04", ["ada"], force=True)
    assert ran == ["ada"]


def test_a_change_of_the_exercises_grades_everything_again(fresh, monkeypatch):
    from grader.grading import run as grading

    grade(fresh, "ch04", ["ada"])
    monkeypatch.setattr(grading, "_code_state", lambda: "another key")
    (result,) = grade(fresh, "ch04", ["ada"])
    assert not result.unchanged


def test_an_interrupted_run_leaves_the_gradebook_and_the_next_one_fills_it(fresh, monkeypatch):
    from nbgrader.api import Gradebook

    before = points(fresh)
    submit(fresh, "dan", work(fresh, "dan"))
    submit(fresh, "ben", work(fresh, "ben"))

    class Broken(RuntimeError):
        pass

    original = Gradebook.__init__

    def breaks(self, *args, **kwargs):
        original(self, *args, **kwargs)

        def commit():
            raise Broken

        self.db.commit = commit

    from grader.grading import run as grading

    save = grading.save_results

    def interrupted(*args):
        with monkeypatch.context() as m:
            m.setattr(Gradebook, "__init__", breaks)
            save(*args)

    monkeypatch.setattr(grading, "save_results", interrupted)
    with pytest.raises(Broken):
        grade(fresh, "ch04")
    assert points(fresh) == before
    monkeypatch.setattr(grading, "save_results", save)
    results = grade(fresh, "ch04")
    assert all(r.unchanged for r in results)  # nothing ran twice
    now = points(fresh)
    assert (total(now["dan"]), total(now["ben"])) == (11, 11)


def test_scores_that_another_grader_overwrote_are_put_right(fresh):
    grade(fresh, "ch04", ["ada"])
    with fresh.gradebook() as book:
        for g in book.find_submission_notebook("ch04", "ch04", "ada").grades:
            g.auto_score = 0
        book.db.commit()
    grade(fresh, "ch04", ["ada"])
    assert total(points(fresh)["ada"]) == 11


def test_late_penalties_of_the_course_are_applied_by_both_routes(fresh):
    with open(fresh.path / "nbgrader_config.py", "a") as f:
        f.write("\nc.LateSubmissionPlugin.penalty_method = 'zero'\n")
    for s in ("ben", "cleo", "dan", "eve", "mallory"):
        shutil.rmtree(fresh.path / "submitted" / s)
    (fresh.path / "submitted/ada/ch04/timestamp.txt").write_text("2026-11-20 12:00:00.0 UTC")
    with fresh.gradebook() as book:
        book.update_or_create_assignment("ch04", duedate="2026-11-19 12:00:00.0 UTC")
        book.remove_submission("ch04", "ada")
    grade(fresh, "ch04")
    with fresh.gradebook() as book:
        own = book.find_submission_notebook("ch04", "ch04", "ada")
        assert (own.score, own.late_submission_penalty) == (11, 11)
        book.remove_submission("ch04", "ada")
    code, out = nbgrader("autograde", "ch04", "--force", cwd=fresh.path)
    assert code == 0, out
    with fresh.gradebook() as book:
        own = book.find_submission_notebook("ch04", "ch04", "ada")
        assert (own.score, own.late_submission_penalty) == (11, 11)


def test_the_record_of_scores_tells_every_part(course):
    record = json.loads((course.path / "scores/ch04/ben.json").read_text())
    assert [s["problem"] for s in record["scores"]] == ["4/1", "4/2", "4/10", "4/16", "4/31"]
    assert any(p["diagnosis"] for s in record["scores"] for p in s["parts"])
    assert course.secret.hex() not in json.dumps(record)


def test_unsandboxed_grading_says_so_in_the_notebook(fresh):
    (result,) = grade(fresh, "ch04", ["ada"], sandbox=False)
    assert result.note == "unsandboxed: this machine refused the cage (unsandboxed: asked for)" or "unsandboxed" in result.note
    assert "unsandboxed" in read(fresh.path / "autograded/ada/ch04/ch04.ipynb")["cells"][0]["source"]
