"""Runs that are killed, and two at once: the gradebook is right after the next one."""

import random
import signal
import subprocess
import sys
import time

import pytest

from grader.course import CourseError
from grader.grading import grade
from grader.grading.lock import alone
from tests.grader.courses import command, environment, forget, gradebook_rows, nbgrader, ran

ROUTES = {
    "grade": (sys.executable, "-m", "grader", "grade", "ch04", "--course", "."),
    "nbgrader autograde": ("nbgrader", "autograde", "ch04"),
}


@pytest.mark.parametrize("route", ROUTES)
@pytest.mark.parametrize(
    "moment", [0, *(pytest.param(n, marks=pytest.mark.slow) for n in range(1, 6))]
)
def test_a_killed_run_is_completed_by_the_next(fresh, course, route, moment):
    forget(fresh)
    process = subprocess.Popen(
        ROUTES[route], cwd=fresh.path, env=environment(), stdout=-3, stderr=-3
    )
    rng = random.Random(f"{route} {moment}")
    until = time.monotonic() + 30
    graded = fresh.path / "autograded"
    while not list(graded.glob("*/ch04/*.ipynb")) and time.monotonic() < until:
        time.sleep(0.02)  # in the midst of it, not in the imports
    time.sleep(rng.uniform(0, 0.5))
    process.send_signal(signal.SIGKILL)
    process.wait()
    if route == "grade":
        ran(command("grade", "ch04", "--course", fresh.path))
    else:
        ran(nbgrader("autograde", "ch04", cwd=fresh.path))
    assert gradebook_rows(fresh) == gradebook_rows(course)


def test_a_second_grader_at_the_same_time_is_reported(fresh):
    with alone(fresh):
        with pytest.raises(CourseError, match=r"another run is grading .* wait for its end"):
            grade(fresh, "ch04")
        code, out = nbgrader("autograde", "ch04", "--student=ada", cwd=fresh.path)
        assert code != 0
        assert "another run is grading" in out
    grade(fresh, "ch04")
