"""One small course, built once: five problems, six students who work as the demo's students
do, and their submissions.
"""

import contextlib
import copy
import functools
from pathlib import Path

import pytest

from tests.grader.courses import change_source, copy_of, emptied, grader
from tests.grader.instructors_cells import OWN
from tests.once import once

PROBLEMS = ("4/1", "4/2", "4/10", "4/16", "4/31")
NBGRADER = (  # harmless warnings of nbgrader 0.9 on SQLAlchemy 2.1 and of nbconvert
    "ignore::sqlalchemy.exc.SAWarning",
    "ignore::DeprecationWarning:nbgrader",
    "ignore::DeprecationWarning:nbconvert",
    "ignore::DeprecationWarning:traitlets",
    "ignore::DeprecationWarning:jupyter_server",
    "ignore:unclosed database:ResourceWarning",
)


def pytest_collection_modifyitems(items):
    for item in items:
        if item.path.is_relative_to(Path(__file__).parent):
            item.add_marker(pytest.mark.filterwarnings(*NBGRADER))
            if "demo_course" in item.fixturenames:
                item.add_marker(pytest.mark.integration)


@pytest.fixture(scope="session")
def demo_course(tmp_path_factory):
    """The demo on five problems, graded; {"course", "output", "code"}."""
    only = [x for p in PROBLEMS for x in ("--problem", p)]
    folder, (code, output) = once(
        tmp_path_factory, "demo", lambda f: grader("demo", "--course", f / "mechanics", *only)
    )
    from grader.course import Course

    with contextlib.suppress(Exception):
        return {"course": Course(folder / "mechanics"), "code": code, "output": output}
    pytest.fail(output)


@pytest.fixture(scope="session")
def course(demo_course):
    """The demo's course, which tests only read."""
    return demo_course["course"]


@pytest.fixture
def fresh(course, tmp_path):
    """A copy of the course, with all submissions and the gradebook, that a test may change."""
    return copy_of(course, tmp_path / course.path.name)


@pytest.fixture
def ungraded(fresh):
    """A copy of the course before anybody has handed in."""
    return emptied(fresh)


@pytest.fixture(scope="session")
def mixed_course(course, tmp_path_factory):
    """The course before anybody has handed in, with an instructor's cells of every kind."""

    def make(folder):
        mixed = emptied(copy_of(course, folder / course.path.name))
        change_source(mixed, lambda cells: cells.extend(copy.deepcopy(OWN)))

    return type(course)(once(tmp_path_factory, "mixed", make)[0] / course.path.name)


@pytest.fixture
def mixed(mixed_course, tmp_path):
    """A copy of that course."""
    return copy_of(mixed_course, tmp_path / mixed_course.path.name)


@pytest.fixture(scope="session")
def harvester():
    """One sandboxed worker."""
    from grader.sandbox import Harvester

    with Harvester(1) as h:
        yield h


class _Shared(contextlib.nullcontext):
    """One harvester for the session, so that no call of grade has to start its own."""

    def __init__(self, harvester):
        super().__init__(self)
        self.harvester, self.count, self.run = harvester, 1, harvester.run
        self.sandbox = True


@pytest.fixture
def one_harvester_for_all(monkeypatch, harvester):
    """grade(…) uses the session's worker, unless it is to run without a sandbox."""
    from grader.grading import run as grading
    from grader.sandbox import Harvester

    shared = _Shared(harvester)
    chosen = lambda workers=None, sandbox=True: shared if sandbox else Harvester(1, sandbox)
    monkeypatch.setattr(grading, "Harvester", chosen)


class _Here(contextlib.nullcontext):
    """Stands in for a pool of processes: does the work in this one."""

    def __init__(self, *_):
        super().__init__(self)

    @staticmethod
    def map(function, items, **_):
        return map(function, items)


@pytest.fixture(scope="session")
def drawn_once():
    """Draws each figure once in a session: copies of a course share its numbers."""
    from grader.assignment import personal

    return functools.cache(personal._draw)


@pytest.fixture(autouse=True)
def quick_courses(request, monkeypatch):
    """Tests with a course of their own use the session's worker and its figures."""
    if {"fresh", "ungraded", "mixed"} & set(request.fixturenames):
        from grader.assignment import personal

        request.getfixturevalue("one_harvester_for_all")
        monkeypatch.setattr(personal, "_draw", request.getfixturevalue("drawn_once"))
        monkeypatch.setattr(personal, "process_pool", _Here)
