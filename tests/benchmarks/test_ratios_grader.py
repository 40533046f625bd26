"""How many times faster than nbgrader's own autograde do we grade? In one run, on the same
submissions, with the same scores: a class of 200 with all 43 problems of chapter 4.

The times are printed; only ratios are asserted.
"""

import json
import logging
import resource
import time

import pytest

from exercises.catalogue import problems
from grader.grading import grade, one
from tests.benchmarks.plain_course import plain_course, plain_points
from tests.grader.courses import copy_of

pytestmark = [pytest.mark.benchmark, pytest.mark.slow, pytest.mark.filterwarnings("ignore")]
CLASS, FEW, THEIRS, INSIDE = 200, 20, 4, 24
ROUNDS = 2
STUDENTS = [f"s{n:03d}" for n in range(CLASS)]
CH04 = problems("ch04")
found: dict = {}  # what was measured


@pytest.fixture(scope="module", autouse=True)
def table():
    yield
    print("\n" + json.dumps(found, indent=1))


@pytest.fixture(scope="module")
def values():
    """Everyone has the book's numbers: nbgrader has one test for all."""
    return {p.id: p.book_values for p in CH04}


@pytest.fixture(scope="module")
def course(tmp_path_factory, values):
    """Every other student is right, the others make a known mistake wherever there is one."""
    from grader.assignment import build_assignment
    from grader.course import read_json, write_json
    from grader.demo import sample_students as sample
    from grader.demo.run import nbgrader_api, require_success

    logging.getLogger("traitlets").setLevel(logging.CRITICAL)
    course = build_assignment(tmp_path_factory.mktemp("ratios") / "c", "ch04").course
    course.enrol(STUDENTS)
    require_success(nbgrader_api(course).generate_assignment("ch04"))
    released = read_json(course.released_path("ch04"))
    answers = [
        {p.id: sample.right_answers(p, values[p.id]) for p in CH04},
        {p.id: sample.answers_with_a_mistake(p, values[p.id])[0] for p in CH04},
    ]
    done = [
        sample.fill_in(released, {p.id: sample.cell_text(p, a[p.id]) for p in CH04})
        for a in answers
    ]
    kept = {p.id: {n: [x, p.givens[n].unit] for n, x in values[p.id].items()} for p in CH04}
    for n, s in enumerate(STUDENTS):
        write_json(course.path / "numbers/ch04" / f"{s}.json", kept)
        write_json(course.personal_path("ch04", s), released, indent=None)
        write_json(course.path / "submitted" / s / "ch04/ch04.ipynb", done[n % 2])
    return course


def timed(work, rounds=ROUNDS):
    """(wall time in s, CPU time in s, what it returns), the least of some rounds."""
    best = []
    for _ in range(rounds):
        wall, cpu = time.perf_counter(), processors()
        result = work()
        best.append((time.perf_counter() - wall, processors() - cpu))
    return min(w for w, _ in best), min(c for _, c in best), result


def processors():
    used = [resource.getrusage(who) for who in (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN)]
    return sum(u.ru_utime + u.ru_stime for u in used)


@pytest.fixture(scope="module")
def theirs(course, values, tmp_path_factory):
    """(seconds, CPU seconds) of nbgrader's default autograde for a notebook."""
    folder = tmp_path_factory.mktemp("plain")
    api = plain_course(course, STUDENTS[:THEIRS], values, folder)
    api.autograde("ch04", STUDENTS[0], force=True)  # imports
    wall, cpu, _ = timed(lambda: [api.autograde("ch04", s, force=True) for s in STUDENTS[:THEIRS]])
    given = {s: plain_points(folder, s) for s in STUDENTS[:THEIRS]}
    for result in grade(course, "ch04", STUDENTS[:THEIRS], force=True):
        assert {p.name: result.scores[p.id].points for p in CH04} == given[result.student]
    found["nbgrader, s a notebook"] = round(wall / THEIRS, 3)
    return wall / THEIRS, cpu / THEIRS


@pytest.mark.parametrize(("workers", "asked"), [(1, 40), (2, 70)])
def test_grade_against_nbgraders_default(course, theirs, workers, asked):
    few, _, _ = timed(lambda: grade(course, "ch04", STUDENTS[:FEW], True, workers))
    all_of_them, cpu, results = timed(lambda: grade(course, "ch04", None, True, workers))
    assert not [r.problem for r in results if r.problem]
    found[f"{workers} workers"] = {
        "a class of 200, s": round(all_of_them, 2),
        "times faster, with start-up": round(theirs[0] * CLASS / all_of_them, 1),
        "without": round(theirs[0] * (CLASS - FEW) / (all_of_them - few), 1),
        "by time of the processors": round(theirs[1] * CLASS / cpu, 1),
    }
    assert theirs[0] * CLASS / all_of_them > asked
    if workers == 2:
        assert theirs[0] * CLASS / all_of_them > 30  # a class, end to end


def test_our_configuration_inside_nbgrader_autograde(course, theirs, tmp_path):
    from grader.demo.run import nbgrader_api

    inside = copy_of(course, tmp_path / "inside")
    api = nbgrader_api(inside)
    api.autograde("ch04", STUDENTS[0])  # imports, and the start of the worker
    group = STUDENTS[1 : INSIDE + 1]
    wall, cpu, _ = timed(lambda: [api.autograde("ch04", s) for s in group], rounds=1)
    found["inside nbgrader autograde, times faster"] = round(theirs[0] * INSIDE / wall, 1)
    found["inside, by time of the processors"] = round(theirs[1] * INSIDE / cpu, 1)
    assert theirs[0] * INSIDE / wall > 15


CORRECTED = {"one problem": lambda i: i == "4/16", "all problems": lambda i: True}


@pytest.mark.parametrize("what", CORRECTED)
def test_a_corrected_key_grades_a_class_again_and_runs_nothing(course, theirs, monkeypatch, what):
    grade(course, "ch04")
    state, times = one.problem_state, iter(range(100))
    monkeypatch.setattr(one, "execute", lambda *_: pytest.fail("it was run again"))

    def again():
        now = next(times)
        corrected = lambda i: f"{state(i)} {now if CORRECTED[what](i) else ''}"
        monkeypatch.setattr(one, "problem_state", corrected)
        return grade(course, "ch04")

    again()  # the part shared by all problems has changed too
    wall, cpu, results = timed(again, rounds=4)
    assert not [r for r in results if r.problem or r.unchanged]
    found[f"corrected, {what}: a class of 200, s"] = round(wall, 2)
    found[f"corrected, {what}: of the processors, s"] = round(cpu, 2)
    if what == "one problem":  # two seconds, where nbgrader takes 2.3 for a notebook
        assert theirs[0] * CLASS / wall > 230


SUBMISSIONS, CORES = 100_000, (2, 16, 64, 256)


def test_a_plan_for_100_000_submissions(course, theirs, monkeypatch):
    """Computed from what a submission costs here; the gradebook is written by one process."""
    from grader.grading import run

    writing, save = [], run.save

    def timed_save(*args):
        start = time.process_time()
        totals = save(*args)
        writing.append(time.process_time() - start)
        return totals

    monkeypatch.setattr(run, "save", timed_save)
    _, few, _ = timed(lambda: grade(course, "ch04", STUDENTS[:FEW], True, 1))
    _, all_of_them, _ = timed(lambda: grade(course, "ch04", None, True, 1))
    each, gradebook = (all_of_them - few) / (CLASS - FEW), min(writing[ROUNDS:]) / CLASS
    stored = sum(
        f.stat().st_size
        for name in ("autograded", "scores")
        for f in (course.path / name).rglob("*.*")
    )
    hours = {n: (SUBMISSIONS * (each / n + gradebook)) / 3600 for n in CORES}
    found["a plan for 100 000 submissions"] = {
        "of the processors, ms a submission": round(1e3 * each, 1),
        "of which the gradebook": round(1e3 * gradebook, 2),
        "GB on disk besides the submissions": round(stored / CLASS * SUBMISSIONS / 1e9),
        "hours on so many processors": {n: round(h, 2) for n, h in hours.items()},
        "with nbgrader alone": {n: round(SUBMISSIONS * theirs[1] / n / 3600, 1) for n in CORES},
    }
    assert hours[64] < SUBMISSIONS * theirs[1] / 64 / 3600 / 15
