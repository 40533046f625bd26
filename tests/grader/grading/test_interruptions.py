"""Runs that are killed or stopped by Ctrl-C, and two at once: the gradebook is right after the next
run, which goes on where the last one stopped.
"""

import contextlib
import os
import random
import re
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest

from grader.course import CourseError
from grader.grading import grade
from grader.grading.lock import alone
from tests.grader.courses import (
    command,
    environment,
    forget,
    gradebook_rows,
    nbgrader,
    ran,
    refused,
)

GRADER = (sys.executable, "-m", "grader")
ROUTES = {
    "grade": (*GRADER, "grade", "ch04", "--course", "."),
    "nbgrader autograde": ("nbgrader", "autograde", "ch04"),
}


def started(course, *arguments, output=subprocess.DEVNULL):
    """The process of a command line, in a group of its own as in a terminal."""
    # where these tests run in the background, they and what they start ignore Ctrl-C
    kept = signal.signal(signal.SIGINT, signal.default_int_handler)
    try:
        return subprocess.Popen(
            arguments, cwd=course.path, env=environment(), stdout=output, stderr=subprocess.STDOUT,
            text=True, process_group=0,
        )  # fmt: skip
    finally:
        signal.signal(signal.SIGINT, kept)


def wait_until(reached):
    """Until the process is in the midst of its work, past the imports."""
    until = time.monotonic() + 600
    while not reached():
        assert time.monotonic() < until, "it has not begun"
        time.sleep(0.01)


def wait_for(course, pattern, count=1):
    """Wait until the course has this many such files."""
    wait_until(lambda: len(list(course.path.glob(pattern))) >= count)


def stopped(process):
    """What a process prints when Ctrl-C reaches it and all it has started, as in a terminal."""
    for _ in range(5):  # a person presses again where Python has ignored it, as in a weak reference
        os.killpg(process.pid, signal.SIGINT)
        with contextlib.suppress(subprocess.TimeoutExpired):
            out, _ = process.communicate(timeout=60)
            break
    assert process.returncode == 130, out
    assert "Traceback" not in out or "Exception ignored" in out, out
    return " ".join(out.split())


@pytest.mark.one_in(2)
@pytest.mark.parametrize("route", ROUTES)
@pytest.mark.parametrize(
    "moment", [0, *(pytest.param(n, marks=pytest.mark.slow) for n in range(1, 6))]
)
def test_a_killed_run_is_completed_by_the_next(fresh, course, route, moment):
    forget(fresh)
    process = started(fresh, *ROUTES[route])
    rng = random.Random(f"{route} {moment}")
    wait_for(fresh, "autograded/*/ch04/*.ipynb")
    time.sleep(rng.uniform(0, 0.5))
    process.send_signal(signal.SIGKILL)
    process.wait()
    if route == "grade":
        ran(command("grade", "ch04", "--course", fresh.path))
    else:
        ran(nbgrader("autograde", "ch04", cwd=fresh.path))
    assert gradebook_rows(fresh) == gradebook_rows(course)


def test_ctrl_c_says_how_far_the_grading_came_and_the_next_run_goes_on(fresh, course):
    forget(fresh)
    before = gradebook_rows(fresh)
    process = started(fresh, *ROUTES["grade"], "--workers", "1", output=subprocess.PIPE)
    wait_for(fresh, "scores/ch04/*.json", 2)
    output = stopped(process)
    words = r"Stopped by Ctrl-C. grading: (\d) of 6. These are kept; the next run continues"
    far = re.search(words, output)
    assert far, output
    assert gradebook_rows(fresh) == before
    assert not list(fresh.path.rglob("*.partial"))
    results = grade(fresh, "ch04")
    assert int(far[1]) <= sum(r.unchanged for r in results) < 6
    assert gradebook_rows(fresh) == gradebook_rows(course)


@pytest.mark.slow
@pytest.mark.integration
def test_ctrl_c_in_a_build_leaves_nothing_and_in_feedback_what_is_done(fresh, tmp_path):
    new = tmp_path / "new"
    build = started(fresh, *GRADER, "build", "ch04", "--course", str(new), output=subprocess.PIPE)
    wait_until(lambda: "_backend_agg" in Path(f"/proc/{build.pid}/maps").read_text())
    time.sleep(0.5)
    assert "Stopped by Ctrl-C. drawing figures: " in stopped(build)
    assert not new.exists()

    grade(fresh, "ch04")
    route = ("nbgrader", "generate_feedback", "ch04")
    process = started(fresh, *route, output=subprocess.PIPE)
    wait_for(fresh, "feedback/*/ch04/*.html", 2)
    output = stopped(process)
    far = re.search(r"Stopped by Ctrl-C: (\d) of 6 are done and kept; the same comm", output)
    done = list(fresh.path.glob("feedback/*/ch04/*.html"))
    assert 1 <= int(far[1]) <= len(done) < 6
    times = {path: path.stat().st_mtime_ns for path in done}
    ran(nbgrader("generate_feedback", "ch04", cwd=fresh.path))
    assert len(list(fresh.path.glob("feedback/*/ch04/*.html"))) == 6
    assert {path: path.stat().st_mtime_ns for path in done} == times


@pytest.mark.integration
@pytest.mark.slow
def test_ctrl_c_in_a_release_releases_nothing_and_the_next_one_all(ungraded):
    outbound = "exchange/*/outbound"
    for path in ungraded.path.glob(f"{outbound}/*"):
        path.rename(ungraded.path / path.name)
    for path in ungraded.path.glob("personal/*/*/*.ipynb"):
        path.unlink()
    route = ("nbgrader", "release_assignment", "ch04")
    process = started(ungraded, *route, output=subprocess.PIPE)
    for line in process.stdout:
        if "personal copies" in line:
            time.sleep(0.2)
            break
    assert "Stopped by Ctrl-C: nothing is released; running the command again" in stopped(process)
    assert not list(ungraded.path.glob(f"{outbound}/ch04"))
    ran(nbgrader("release_assignment", "ch04", cwd=ungraded.path))
    assert list(ungraded.path.glob(f"{outbound}/ch04/ch04.ipynb"))
    assert len(list(ungraded.path.glob("personal/ch04/*/*.ipynb"))) == 6


def test_a_second_grader_at_the_same_time_is_reported(fresh):
    with alone(fresh):
        with pytest.raises(CourseError, match=r"another run is grading .* wait for its end"):
            grade(fresh, "ch04")
        done = nbgrader("autograde", "ch04", "--student=ada", cwd=fresh.path)
        assert "another run is grading" in refused(done, None)
    grade(fresh, "ch04")
