"""A course with problems of its own: from a folder to a grade, and into the next year."""

import json
import shutil
import subprocess
import sys
from pathlib import Path

import pytest
import yaml

from exercises.catalogue import CatalogueError, places, problem, select
from exercises.catalogue.errors import error_sentence
from grader.assignment import make_personal_copies, problems_of
from grader.course import Course
from grader.demo import sample_students as sample
from tests.exercises.test_slips_of_authors import GOOD, place
from tests.grader.courses import command, grader, nbgrader, points, ran, read, refused, run, submit


@pytest.fixture
def course(tmp_path):
    """A course with the problem bead/1 in its folder "problems", and 4/3."""
    mine, roster = tmp_path / "mine", tmp_path / "roster.csv"
    shutil.copytree(GOOD, mine, ignore=shutil.ignore_patterns("__pycache__"))
    roster.write_text("Username\nada\n")
    build = "build", "hw1", "bead/1", "4/3", "--course", tmp_path / "m26", "--students", roster
    ran(grader(*build, "--problems-from", mine))
    return tmp_path / "m26"


def answered(path, numbers):
    """The copy at ``path``, with the right answers to these numbers."""
    notebook = read(path)
    right = lambda p: sample.cell_text(p, sample.right_answers(p, numbers[p.id]))
    texts = {p.id: right(p) for p in problems_of(notebook)}
    return sample.fill_in(notebook, texts)


@pytest.mark.integration
def test_an_own_problem_is_built_graded_and_taken_into_the_next_year(course, tmp_path):
    assert json.loads((course / "course.json").read_text())["problems_from"] == [
        str(tmp_path / "mine")
    ]
    ran(nbgrader("generate_assignment", "hw1", cwd=course))
    with place(tmp_path / "mine"):
        c = Course(course)
        (path,) = make_personal_copies(c, "hw1", workers=1).values()
        numbers = c.values("hw1", "ada", [problem("bead/1"), problem("4/3")])
        submit(c, "ada", answered(path, numbers), "hw1")
    ran(grader("grade", "hw1", "--course", course))  # a process that knows only course.json
    cells = points(c, "hw1")["ada"]
    assert cells["answer-bead-1"][0] == 4
    assert cells["answer-4-3"][0] == len(problem("4/3").answers)

    edited = read(course / "source/hw1/hw1.ipynb")
    edited["cells"][0]["source"] += "\nMine."
    (course / "source/hw1/hw1.ipynb").write_text(json.dumps(edited))
    with place(tmp_path / "mine"):
        out = ran(command("next-year", course, "--course", tmp_path / "m27"))
        assert "The course m27" in out
        assert "hw1" in out
        assert read(tmp_path / "m27/source/hw1/hw1.ipynb")["cells"][0]["source"].endswith("Mine.")
        new = Course(tmp_path / "m27")
        assert new.roster() == []
        assert new.secret != c.secret
        assert new.values("hw1", "ada", [problem("bead/1")])["bead/1"] != numbers["bead/1"]
        again = command("next-year", course, "--course", tmp_path / "x", "--name", "m26")
        assert "another --name" in again[1]
    kept = {p.name for p in (tmp_path / "m27").iterdir()}
    assert kept.isdisjoint({"submitted", "scores", "personal", "numbers", "autograded", "backup"})
    assert not (tmp_path / "x").exists()
    ran(nbgrader("generate_assignment", "hw1", cwd=tmp_path / "m27"))


@pytest.mark.parametrize(("name", "message"), [
    ("ch04", "the name ch04 is taken by the book"),
    ("devices", "the name devices is taken by the book"),
    ("tools", "the name tools is taken by the book"),
    ("all", "the name all is taken"),
    ("Bridge", "small letters, digits and _, as in bridge"),
])  # fmt: skip
def test_a_name_that_is_taken_is_refused_in_words(tmp_path, name, message):
    shutil.copytree(GOOD / "bead", tmp_path / name)
    before = select(["ch04"])
    with pytest.raises(CatalogueError, match=message):
        places.use(tmp_path)
    assert select(["ch04"]) == before


def test_two_chapters_of_one_name_are_refused_and_a_folder_without_problems(tmp_path):
    shutil.copytree(GOOD / "bead", tmp_path / "bead")
    with place(GOOD), pytest.raises(CatalogueError, match="there are two chapters bead"):
        places.use(tmp_path)
    with pytest.raises(CatalogueError, match="has no problems: put them in chapters"):
        places.use(tmp_path / "bead")


def test_own_chapters_come_after_those_of_the_book_by_name_and_number(tmp_path):
    for week in (10, 2):
        folder = shutil.copytree(GOOD / "bead", tmp_path / f"week{week}")
        text = (folder / "p01.yaml").read_text().replace("bead/1", f"week{week}/1")
        (folder / "p01.yaml").write_text(text)
    with place(tmp_path) as names:
        assert names == ["week2", "week10"]
        assert [p.id for p in select(["all"])][-2:] == ["week2/1", "week10/1"]
    assert len(select(["all"])) == 289


@pytest.mark.parametrize(("line", "words"), [
    ("v = grond", "bead/p01.py, line 14: NameError: name 'grond' is not defined"),
    ("return None", "solve of bead/1 returns NoneType; the problem asks for v_B"),
    ("1 / 0", "bead/p01.py, line 14: ZeroDivisionError"),
    ("def", "bead/p01.py, line 14: invalid syntax"),
], ids=["a name", "nothing", "a number", "Python"])  # fmt: skip
def test_an_error_in_an_own_problem_is_a_sentence_in_every_process(tmp_path, line, words):
    shutil.copytree(GOOD, tmp_path, dirs_exist_ok=True)
    code = tmp_path / "bead/p01.py"
    code.write_text(code.read_text().replace("def solve(g):\n", f"def solve(g):\n    {line}\n"))
    with place(tmp_path):
        for asked in (("preview", "--text"), ("practice", "-o", tmp_path / "b.practice")):
            assert words in refused(command(asked[0], "bead/1", *asked[1:]))


def test_an_error_of_python_that_lost_its_attributes_on_the_way_still_has_its_line():
    """As Dask does, which pickles errors in its own way once it is imported."""
    error = SyntaxError("invalid syntax", ("/course/bead/p01.py", 14, 8, "def", 14, 9))
    error.msg = error.filename = error.lineno = None
    assert error_sentence("bead/1", error) == "bead/p01.py, line 14: invalid syntax"


@pytest.mark.parametrize(
    ("where", "message"), [("own", "1 passed, 0 failed"), ("site-packages", "install -e")]
)
def test_a_package_of_problems_is_known_by_its_entry_point(tmp_path, where, message):
    """It is refused among the libraries, which students' code may read."""
    home = tmp_path / where
    shutil.copytree(GOOD, home / "our_problems")
    (home / "our_problems/__init__.py").touch()
    (home / "our_problems-1.dist-info").mkdir()
    (home / "our_problems-1.dist-info/METADATA").write_text("Name: our-problems\nVersion: 1\n")
    (home / "our_problems-1.dist-info/entry_points.txt").write_text(
        "[newton_euler.problems]\nours = our_problems\n"
    )
    root = Path(__file__).parents[2]
    done = subprocess.run(
        [sys.executable, "-m", "grader", "prove", "bead", "--seeds", "1", "--workers", "1"],
        env={"PYTHONPATH": f"{home}:{root}", "PATH": "/usr/bin"}, cwd=tmp_path,
        capture_output=True, text=True,
    )  # fmt: skip
    assert message in done.stdout + done.stderr


def commands(workflow):
    """The lines that a workflow of either forge runs."""
    jobs = workflow.get("jobs", workflow)
    steps = jobs["prove"].get("script") or jobs["prove"]["steps"]
    return [
        s if isinstance(s, str) else s["run"] for s in steps if isinstance(s, str) or "run" in s
    ]


@pytest.mark.integration
@pytest.mark.parametrize("forge", ["github", pytest.param("gitlab", marks=pytest.mark.slow)])
def test_the_workflow_passes_good_problems_and_stops_at_a_slip(tmp_path, forge):
    shutil.copytree(GOOD, tmp_path / "problems", ignore=shutil.ignore_patterns("__pycache__"))
    path = ran(command("ci", forge, "--to", tmp_path)).strip()
    lines = commands(yaml.safe_load(Path(path).read_text()))
    assert [line for line in lines if "grader" not in line] == lines[:2]
    for line in lines[2:]:
        ran(run("bash", "-c", line, cwd=tmp_path))
    text = tmp_path / "problems/bead/p01.yaml"
    text.write_text(text.read_text().replace("rate {omega}", "rate {gamma}"))
    assert "{gamma} is not a given" in refused(run("bash", "-c", lines[2], cwd=tmp_path), 1)
    assert "exists; delete it" in command("ci", forge, "--to", tmp_path)[1]


def test_without_names_prove_takes_only_the_own_problems():
    with place(GOOD):
        out = ran(command("prove", "--problems-from", GOOD, "--seeds", "1", "--workers", "1"))
    assert "1 passed, 0 failed" in out
