"""An assignment of any problems: by a command, or by a file."""

import pytest

from exercises.catalogue import CatalogueError, select
from grader.assignment import make_personal_copies
from grader.assignment.spec import read_spec, spec_of
from grader.course import Course, CourseError
from grader.grading import grade
from tests.grader.courses import command, nbgrader, points, ran, read, submit
from tests.grader.submissions import work

FILE = """\
title: Homework 3
due: 2027-01-31 23:59 Europe/Berlin
problems:
  - 4/3: {points: 10, weights: {a: 2}, follow_through: 0.5}
  - text: Friction is neglected from here on.
  - 7/5: 4
  - 11/1-2
"""


def numbers(spec):
    return [p.id for p in spec.problems]


def written(folder, text, name="hw3.yaml"):
    (folder / name).write_text(text)
    return folder / name


@pytest.mark.parametrize(
    ("text", "found"),
    [("4/16", ["4/16"]), ("11/1-11/3", ["11/1", "11/2", "11/3"]), ("11/2-3", ["11/2", "11/3"]),
     ("A/1-A/2", ["A/1", "A/2"]), ("4/3-4/3", ["4/3"]), (" 11/2 – 3 ", ["11/2", "11/3"])],
)  # fmt: skip
def test_a_text_stands_for_a_problem_or_a_range(text, found):
    assert [p.id for p in select([text])] == found


@pytest.mark.parametrize("text", ["11/6-11/1", "4/3-5/1", "4/3-", "4/999", "ch99", "4/1-4/999"])
def test_an_invalid_range_is_refused(text):
    with pytest.raises((CourseError, CatalogueError)):
        select([text])


def test_a_file_is_the_assignment_and_is_written_as_it_was_read(tmp_path):
    spec = read_spec(written(tmp_path, FILE))
    head = spec.name, spec.title, spec.due
    assert head == ("hw3", "Homework 3", "2027-01-31 23:59 Europe/Berlin")
    assert numbers(spec) == ["4/3", "7/5", "11/1", "11/2"]
    assert [dict(i.options) for i in spec.items[:3]] == [
        {"points": 10, "weights": {"a": 2}, "follow_through": 0.5}, {}, {"points": 4},
    ]  # fmt: skip
    assert read_spec(written(tmp_path, spec.as_yaml)) == spec


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("- 4/3", "expected title, due and a list of problems"),
        ("problems: [4/3, 4/3]", "4/3 occurs twice"),
        ("problems: [4/3]\npoints: 3", "'points' is not one of"),
        (
            "problems: [{4/3: {point: 3}}]",
            "'point' is not one of follow_through, help, points, tolerance, weights; did you mean points",
        ),
        ("problems: [{4/3: {points: many}}]", "'many' is not a number of points"),
        ("problems: [{4/3: -1}]", "-1 is not a number of points"),
        ("problems: [3]", "3 is neither a problem nor a text"),
        ("problems: [", "is not YAML"),
        ("[" * 5000, "cannot be read"),
        ("due: 2027-13-45", "cannot be read"),
        (f"problems: [4/3: {{points: 1{'0' * 400}}}]", "is not a number of points"),
    ],
)
def test_a_file_that_does_not_fit_is_refused_in_words(tmp_path, text, words):
    with pytest.raises(CourseError, match=words):
        read_spec(written(tmp_path, text))


def test_a_name_and_points_that_do_not_fit_are_refused_in_words():
    for name in ("h w", "../x", "", "-a", "a+b"):
        with pytest.raises(CourseError, match="a name has letters"):
            spec_of(name, ["4/3"])
    with pytest.raises(CourseError, match="no problems are named"):
        spec_of("hw3")
    for text, words in (("4/3=x", "expected a problem and its points"), ("4/1=3", "not among")):
        with pytest.raises(CourseError, match=words):
            spec_of("hw3", ["4/3"], [text])


@pytest.mark.integration
def test_problems_of_any_chapters_are_built_handed_out_graded_and_updated(tmp_path):
    """The round trip from a command line, and a second assignment from a file."""
    place, roster = tmp_path / "mechanics", tmp_path / "roster.csv"
    roster.write_text("id\nada\n")
    chosen = "--problems", "4/3", "4/16", "7/5", "11/1-11/2", "--points", "4/3=10"
    out = ran(command("build", "hw3", *chosen, "--students", roster, "--course", place))
    assert "nbgrader generate_assignment hw3" in out
    course = Course(place)
    out = ran(command("build", written(tmp_path, FILE, "hw4.yaml"), "--course", place, "--update"))
    assert "Due 2027-01-31 22:59 UTC" in out
    for name, most in (("hw3", 10 + 3), ("hw4", 10 + 4)):
        ran(nbgrader("generate_assignment", name, cwd=place))
        make_personal_copies(course, name, workers=1)
        sheet = read(course.personal_path(name, "ada"))
        submit(course, "ada", work(course, "ada", assignment=name), name)
        (result,) = grade(course, name)
        assert result.points == result.out_of >= most
        assert points(course, name)["ada"]["answer-4-3"][0] == 10
        texts = [c["source"] for c in sheet["cells"]]
        assert ("Friction is neglected from here on." in texts) == (name == "hw4")
    values = [course.values(name, "ada", spec_of("x", ["4/3"]).problems) for name in ("hw3", "hw4")]
    assert values[0] != values[1]
    ran(command("build", "hw3", "--course", place, "--update"))
    cells = read(course.source("hw3"))["cells"]
    answers = [c["metadata"] for c in cells if c["metadata"]["newton_euler"]["role"] == "answer"]
    assert [m["newton_euler"]["problem"] for m in answers] == ["4/3", "4/16", "7/5", "11/1", "11/2"]
    assert answers[0]["nbgrader"]["points"] == 10
