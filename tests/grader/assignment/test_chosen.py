"""The assignment that a command names."""

import pytest

from exercises import problem
from grader.assignment import build_assignment
from grader.assignment.chosen import as_asked, chosen
from grader.assignment.spec import spec_of
from grader.course import Course, CourseError, read_json, write_json


def ids(spec):
    return [p.id for p in spec.problems]


def test_problems_a_chapter_or_a_file(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    assert ids(chosen("hw3", ["4/3", "11/1-11/2"])) == ["4/3", "11/1", "11/2"]
    assert len(chosen("ch09").problems) == 9
    (tmp_path / "hw3.yaml").write_text("title: T\nproblems:\n - 4/16: {points: 7}\n - text: Go on.")
    for name in ("hw3", "hw3.yaml"):
        spec = chosen(name)
        assert (spec.name, spec.title, ids(spec)) == ("hw3", "T", ["4/16"])
        assert [i.options.get("points") for i in spec.items] == [7, None]
    with pytest.raises(CourseError, match=r"hw9\.yaml cannot be read"):
        chosen("hw9.yaml")


def test_what_a_course_has_comes_first_as_the_instructor_changed_it(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    course = build_assignment(tmp_path / "c", spec_of("hw3", ["4/3", "4/16"], ["4/3=5"])).course
    assert [i.text for i in chosen("hw3", course=course).items] == ["", ""]
    path = course.source("hw3")
    notebook = read_json(path)
    cells = notebook["cells"]
    mine = next(c for c in cells if c["metadata"]["newton_euler"]["role"] == "statement")
    mine["source"] = mine["source"].replace("robot", "crane")
    answer = next(c for c in cells if c["metadata"]["newton_euler"]["role"] == "answer")
    answer["metadata"]["newton_euler"] |= {"weights": {"a": 3}, "tolerance": 0.02}
    cells.insert(4, {"cell_type": "markdown", "id": "x", "metadata": {}, "source": "No friction."})
    write_json(path, notebook)
    items = chosen("hw3", course=Course(tmp_path / "c")).items
    assert [i.text for i in items if not i.problem] == ["No friction."]
    first = next(i for i in items if i.problem)
    assert "crane" in first.text
    assert "attachment" not in first.text
    assert (first.options["points"], first.options["weights"]) == (5, {"a": 3})
    asked = as_asked(problem("4/3"), first.options)
    assert [(a.weight, a.rtol) for a in asked.answers] == [(3, 0.02), (1.0, 0.02)]
    assert ids(chosen("hw3", ["4/1"], course=course)) == ["4/1"]
    with pytest.raises(CourseError, match="has no assignment hw4; it has hw3"):
        chosen("hw4", course=course)


@pytest.mark.parametrize("other", ["HW3", "h\uff573"])  # a w of full width
def test_a_name_that_is_taken_for_that_of_another_assignment_is_refused(tmp_path, other):
    course = build_assignment(tmp_path / "c", spec_of("hw3", ["4/3"])).course
    with pytest.raises(CourseError, match=r"the assignments hw3 and .* differ only by upper and"):
        build_assignment(course.path, spec_of(other, ["4/3"]), update=True)
