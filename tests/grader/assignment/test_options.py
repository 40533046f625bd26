"""Tolerance and help level of a sheet, from its file to receipt, grade, feedback and practice."""

import json
from pathlib import Path

import pytest

import grader
from exercises.catalogue import problem
from grader.assignment.options import OPTIONS, read_option
from grader.assignment.spec import read_spec
from grader.assignment.written import spec_of_course
from grader.course import Course
from grader.demo import sample_students as sample
from newton_euler.answers.kinds import KINDS
from newton_euler.answers.seals import is_known, opens, seal
from newton_euler.classroom import practice
from tests.grader.courses import command, nbgrader, points, ran, read, refused, submit
from tests.grader.submissions import work


def test_the_examples_of_the_help_are_files_that_are_read(tmp_path):
    out = " ".join(command("build", "--help")[1].split())
    templates = Path(grader.__file__).parent / "commands" / "templates"
    for name in ("hw3", "midterm"):
        text = (templates / f"{name}.yaml").read_text(encoding="utf-8")
        path = tmp_path / "hw3.yaml"
        path.write_text(text)
        spec = read_spec(path)
        assert " ".join(text.split()) in out
        path.write_text(spec.as_yaml)
        assert read_spec(path) == spec


@pytest.mark.parametrize(("name", "value", "found"), [
    ("tolerance", "2%", 0.02), ("tolerance", 0.001, 0.001), ("follow_through", "50 %", 0.5),
    ("points", 2.0, 2), ("help", "none", "none"), ("weights", {"v_D": 0}, {"v_D": 0}),
])  # fmt: skip
def test_an_option_is_read(name, value, found):
    assert read_option(name, value, problem("4/16")) == found


@pytest.mark.parametrize(("name", "value", "words"), [
    ("tolerance", 0, "0 is not a tolerance"), ("tolerance", "50%", "not a tolerance"),
    ("tolerance", True, "True is not a tolerance"), ("help", "hint", "did you mean hints?"),
    ("follow_through", 2, "not a share"), ("points", float("nan"), "not a number of points"),
    ("weights", {"a": 1}, "'a' is not a part of 4/16"), ("weights", {"v_D": -1}, "not a weight"),
    ("weights", {"v_D": 0, "a_D": 0, "alpha_CD": 0}, "worth nothing"), ("weights", 3, "not a set of weights"),
])  # fmt: skip
def test_an_option_that_means_nothing_is_refused_in_words(name, value, words):
    assert name in OPTIONS
    with pytest.raises(ValueError, match=words.replace("?", r"\?")):
        read_option(name, value, problem("4/16"))


@pytest.mark.parametrize("rtol", [1e-4, 0.005, 0.05])
def test_a_seal_opens_within_its_own_tolerance(rtol):
    kind, right = KINDS["vector"], (3.0, -4.0, 0.5)
    sealed = json.loads(json.dumps(seal(kind, right, rtol=rtol)))
    assert is_known(sealed)
    for share, is_right in ((0.0, True), (0.9, True), (3.0, False)):
        given = [3.0 + share * rtol * 5.025, -4.0, 0.5]
        assert opens(sealed, kind, given) is is_right
        assert kind.is_right((tuple(given),), (right,), 0.0, rtol) is is_right


FILE = """\
title: Homework 3
due: 2026-01-31 23:59 UTC
tolerance: 3%
problems:
- 4/1: {help: none, points: 4}
- text: Friction is neglected.
- 4/16: {help: check, tolerance: 0.1%}
- 7/5: {help: solution}
"""


def off(p, values, share):
    """Right answers, each component off by this share."""
    right = sample.right_answers(p, values)
    return sample.cell_text(p, {k: f"{1 + share} * np.array({x})" for k, x in right.items()})


@pytest.mark.slow
@pytest.mark.integration
def test_a_sheet_follows_its_file_all_the_way(tmp_path, monkeypatch):
    """Two sheets of the same problems, one of which sets a tolerance and a level of help."""
    monkeypatch.chdir(tmp_path)
    place, roster, file = tmp_path / "mechanics", tmp_path / "roster.csv", tmp_path / "hw3.yaml"
    roster.write_text("id\nada\n")
    file.write_text(FILE)
    ran(command("build", file, "--students", roster, "--course", place, "--chapters",
                "https://dynamics.example/"))  # fmt: skip
    chosen = "--problems", "4/1", "4/16", "7/5"
    ran(command("build", "hw4", *chosen, "--course", place, "--update"))
    out = refused(command("build", "HW3", "--problems", "4/1", "--course", place, "--update"))
    assert "differ only by upper and lower case" in " ".join(out.split())
    course, asked = Course(place), [problem(n) for n in chosen[1:]]
    assert spec_of_course(course, "hw3") == read_spec(file)
    for name in ("hw3", "hw4"):
        ran(nbgrader("generate_assignment", name, cwd=place))
        ran(command("personal", name, "--course", place))
    sheets = {name: read(course.personal_path(name, "ada")) for name in ("hw3", "hw4")}
    text = {name: "\n".join(c["source"] for c in sheet["cells"]) for name, sheet in sheets.items()}
    assert all(text["hw3"].count(f"*Tolerance:* {x} %") == n for x, n in (("3", 2), ("0.1", 1)))
    assert "Tolerance" not in text["hw4"]
    assert [f'given("{p.id}", sealed=' in text["hw3"] for p in asked] == [False, True, True]
    assert "sealed=" not in text["hw4"]
    assert "https://dynamics.example/chapters/ch04_relative_motion.html#section-4-" in text["hw3"]
    assert "https://dynamics.example/chapters/ch07" in text["hw3"]
    numbers = {name: course.values(name, "ada", asked) for name in sheets}
    assert all(numbers["hw3"][p.id] != numbers["hw4"][p.id] for p in asked if p.givens)
    for name, mine in numbers.items():
        cells = {"p4_1": off(asked[0], mine["4/1"], 0.02)}
        cells["p4_16"] = off(asked[1], mine["4/16"], 0.003)
        submit(course, "ada", work(course, "ada", assignment=name, **cells), name)
        ran(command("grade", name, "--course", place))
        ran(nbgrader("generate_feedback", name, cwd=place))
    found = {name: points(course, name)["ada"] for name in sheets}
    assert [found["hw3"][f"answer-4-{n}"][0] for n in (1, 16)] == [4, 0]
    assert [found["hw4"][f"answer-4-{n}"][0] for n in (1, 16)] == [0, 3]
    pages = {n: (place / f"feedback/ada/{n}/{n}.html").read_text() for n in sheets}
    assert [page.count("Worked solution") for page in pages.values()] == [1, 0]
    # without help nobody is told why an answer is wrong; an instructor may change that
    wrong = {"p4_1": off(asked[0], numbers["hw3"]["4/1"], 0.05)}
    submit(course, "ada", work(course, "ada", assignment="hw3", **wrong), "hw3")
    ran(command("grade", "hw3", "--course", place))
    comment = points(course, "hw3")["ada"]["answer-4-1"][2]
    assert {line.partition(": ")[2] for line in comment.splitlines()} == {"not right"}
    out = ran(command("practice", "4/1", "4/16", "7/5", "--course", place, "-o", "own.practice",
                      "--variants", "2"))  # fmt: skip
    assert "4/1 left out: its sheet gives no help" in out
    both = practice("own.practice")["4/16"]
    assert (both.help, "no hints" in str(both.next_step())) == ("check", True)
    ran(command("practice", file, "-o", "own.practice", "--variants", "2"))
    own = practice("own.practice")["4/16"]
    for file_of, verdict in ((own, "wrong"), (both, "right")):  # as it is on one of the sheets
        right = {k: 1.003 * x for k, x in asked[1].solve(file_of.givens).items()}
        assert set(file_of.check(**right).verdicts.values()) == {verdict}
    out = ran(command("spec", "hw3", "--course", place))
    file.write_text(out)
    assert read_spec(file) == spec_of_course(course, "hw3")
