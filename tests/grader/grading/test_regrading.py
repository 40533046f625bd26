"""What was run is kept: after a new key, tolerance, range, weight or number of points, grading runs
nothing again and gives what grading from the beginning gives.
"""

import shutil
from dataclasses import replace

import pytest

from exercises.catalogue import problem, reading
from grader.grading import grade, one
from grader.scoring.numbers import Numbers
from tests.grader.courses import change_source, gradebook_rows
from tests.grader.grading.test_histories import notebooks


def answer_cell(cells):
    return next(c for c in cells if c.get("id") == "answer-4-16")["metadata"]


def other_weights(course, _):
    weights = {"v_D": 5}
    change_source(course, lambda cells: answer_cell(cells)["newton_euler"].update(weights=weights))


def other_points(course, _):
    change_source(course, lambda cells: answer_cell(cells)["nbgrader"].update(points=9))


def other_exercise(monkeypatch, **changed):
    """The exercise 4/16 as it would be if its files were changed in this way."""
    new, find, state = replace(problem("4/16"), **changed), reading.problem, one.problem_state
    monkeypatch.setattr(one, "problem_state", lambda i: "changed" if i == "4/16" else state(i))
    for room in ("sheet", "notebook"):
        place = f"grader.assignment.{room}.find_problem"
        monkeypatch.setattr(place, lambda i: new if i == "4/16" else find(i))


def other_key(_, monkeypatch):
    right = Numbers.key.func

    def key(self):
        found = right(self)
        return dict.fromkeys(found, found["a_D"]) if self.problem.id == "4/16" else found

    monkeypatch.setattr(Numbers, "key", property(key))
    other_exercise(monkeypatch)


def other_tolerance(_, monkeypatch):
    answers = tuple(replace(a, atol=1e9) for a in problem("4/16").answers)
    other_exercise(monkeypatch, answers=answers)


def other_range(_, monkeypatch):
    givens = problem("4/16").givens
    narrow = {**givens, "omega": replace(givens["omega"], vary=(0.59, 0.61))}
    other_exercise(monkeypatch, givens=narrow)


def no_notebooks(course, _):
    shutil.rmtree(course.path / "autograded")


STUDENTS = ("ada", "ben")
CHANGES = (other_weights, other_points, other_key, other_tolerance, other_range, no_notebooks)
CHANGES_POINTS = (other_weights, other_points, other_key, other_tolerance)


@pytest.mark.one_in(2)
@pytest.mark.parametrize("change", CHANGES)
def test_what_does_not_change_the_run_runs_nothing_again(fresh, monkeypatch, change):
    before = {r.student: r.points for r in grade(fresh, "ch04", STUDENTS)}
    change(fresh, monkeypatch)
    run = one.execute
    monkeypatch.setattr(one, "execute", lambda *_: pytest.fail("it was run again"))
    results = grade(fresh, "ch04", STUDENTS)
    assert not [r.problem for r in results if r.problem]
    assert ({r.student: r.points for r in results} != before) == (change in CHANGES_POINTS)
    kept = gradebook_rows(fresh), notebooks(fresh)
    monkeypatch.setattr(one, "execute", run)
    grade(fresh, "ch04", STUDENTS, force=True)
    assert (gradebook_rows(fresh), notebooks(fresh)) == kept


def test_only_the_changed_problem_is_scored_again(fresh, monkeypatch):
    from grader.submission import pipeline

    grade(fresh, "ch04", STUDENTS)
    scored, original = [], pipeline.score_receipt
    noted = lambda p, *rest: scored.append(p.id) or original(p, *rest)
    monkeypatch.setattr(pipeline, "score_receipt", noted)
    other_range(fresh, monkeypatch)
    grade(fresh, "ch04", STUDENTS)
    assert set(scored) == {"4/16"}
    grade(fresh, "ch04", STUDENTS, force=True)
    assert set(scored) > {"4/16"}


def test_a_changed_engine_runs_everyone_again(fresh, monkeypatch):
    """The counterpart: what changes the run does run."""
    grade(fresh, "ch04", STUDENTS)
    ran, run = [], one.execute
    monkeypatch.setattr(one, "execute", lambda *a: ran.append(1) or run(*a))
    monkeypatch.setattr(one, "run_state", lambda: "another engine")
    grade(fresh, "ch04", STUDENTS)
    assert len(ran) == len(STUDENTS)
