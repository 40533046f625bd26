"""A course written by an earlier version is graded by this one, and nbgrader finds every class that
the configuration names.

tests/grader/course_before/ holds an assignment as commit adcba41 wrote it, before grader/ had
folders: the source notebook, and what ada fetched. Cell ids, grade ids and the numbers that follow
    from the secret are in notebooks that are handed out; they must not change while a course
    runs.
"""

import json
import shutil
from pathlib import Path

import pytest
from traitlets.config import Config
from traitlets.utils.importstring import import_item

from grader.assignment import notebook as nb
from grader.assignment import problems_of
from grader.course import Course
from grader.demo import sample_students as sample
from grader.nbgrader_config import configure
from grader.nbgrader_hooks.config import PINNED
from tests.grader.courses import REPOSITORY, command, nbgrader, points, ran, read, run, submit

BEFORE = Path(__file__).parents[1] / "course_before"
SECRET = "0123456789abcdef" * 4
NUMBERS = {"4/1": {"lead": 2.7, "n": 7.5, "a": 11.0}, "4/2": {}}
CONFIG = f'''\
"""nbgrader, set up for this course; written by python -m grader build. Add your own settings below."""

import sys

sys.path.insert(0, {str(REPOSITORY)!r})  # where grader/ and exercises/ are

from grader.nbgrader_config import configure
from grader.nbgrader_hooks.config import PINNED

c = get_config()  # noqa: F821
configure(c, course=__file__)
c.CourseDirectory.course_id = 'mechanics'
'''
WORK = {
    "4/1": "speed = 518.7581732557644\nacc_mag = 1000",
    "4/2": "from sympy import sin, sqrt\nspeed = sqrt(d**2*omega**2*sin(tilt)**2 + nu**2)\n"
    "acc_mag = sqrt(d**2*omega**4*sin(tilt)**2 + 4*nu**2*omega**2*sin(tilt)**2)",
}


@pytest.fixture(scope="module")
def written(tmp_path_factory):
    """The course of an earlier version, in which ada has handed in."""
    folder = tmp_path_factory.mktemp("before") / "mechanics"
    folder.mkdir()
    (folder / ".course_secret").write_text(SECRET)
    (folder / "nbgrader_config.py").write_text(CONFIG)
    course = Course(folder)
    places = {"source": course.source("ch04"), "personal": course.personal_path("ch04", "ada")}
    for name, path in places.items():
        path.parent.mkdir(parents=True)
        shutil.copy(BEFORE / f"{name}.ipynb", path)
    course.enrol(["ada"])
    ran(nbgrader("generate_assignment", "ch04", cwd=folder, PYTHONPATH=""))
    submit(course, "ada", sample.fill_in(read(BEFORE / "personal.ipynb"), WORK))
    return course


@pytest.fixture
def before(written, tmp_path):
    """A copy of that course."""
    return Course(shutil.copytree(written.path, tmp_path / "mechanics"))


@pytest.mark.one_in(2)
@pytest.mark.integration
@pytest.mark.parametrize("route", ["nbgrader autograde", "python -m grader grade"])
def test_a_course_of_an_earlier_version_is_graded(before, route):
    # by its own process, which finds the grader through the course's configuration alone
    if route == "nbgrader autograde":
        code, out = run("nbgrader", "autograde", "ch04", cwd=before.path, PYTHONPATH="")
    else:
        code, out = command("grade", "ch04", "--course", before.path)
    assert code == 0, out
    given = {cell: automatic for cell, (automatic, _, _) in points(before)["ada"].items()}
    assert given == {"answer-4-1": 1, "receipt-4-1": 0, "answer-4-2": 2, "receipt-4-2": 0}


@pytest.mark.integration
def test_the_numbers_and_ids_of_a_course_of_an_earlier_version_are_those_of_today(written):
    own = read(BEFORE / "personal.ipynb")
    problems = problems_of(own)
    assert written.values("ch04", "ada", problems) == NUMBERS
    today, then = nb.build_notebook(problems, "", 10, 60), read(BEFORE / "source.ipynb")

    def ids(notebook):
        found = []
        for c in notebook["cells"]:
            own = {k: v for k, v in c["metadata"]["newton_euler"].items() if k != "asked"}
            found.append((c["id"], own, c["metadata"].get("nbgrader", {}).get("grade_id")))
        return found

    assert ids(today) == ids(then) == ids(own)
    first, *others = (nb.MASTER_COPY in c["source"] for c in then["cells"])
    assert first
    assert not any(others)


def test_every_class_that_the_configuration_names_can_be_imported(tmp_path):
    c = Config()
    configure(c, course=str(tmp_path / "nbgrader_config.py"))
    pinned = json.loads(PINNED.read_text())
    names = [
        c.ExchangeFactory.fetch_assignment, *c.HTMLExporter.preprocessors,
        *c.Autograde.sanitize_preprocessors, *c.Autograde.autograde_preprocessors,
        *c.GenerateFeedback.preprocessors,
        *(name for names in pinned.values() for name in names.values()),
    ]  # fmt: skip
    assert dict(c.ExchangeFactory).items() >= pinned["ExchangeFactory"].items()
    assert all(isinstance(import_item(name), type) for name in names)
    assert all(Path(folder).is_dir() for folder in c.HTMLExporter.extra_template_basedirs)
