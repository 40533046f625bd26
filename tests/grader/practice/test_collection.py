"""A problem tried where it stands in a chapter."""

import pytest

from newton_euler.classroom import PracticeFileError, PracticeProblem, try_problem
from newton_euler.classroom.practising import collection


def test_try_problem_opens_the_practice_file_in_the_folder_that_has_the_problem(
    practice_file, hints_file
):
    assert practice_file.parent != hints_file.parent
    p = try_problem("2/18", practice_file.parent)
    assert isinstance(p, PracticeProblem)
    assert p.id == "2/18"
    assert "2/18" in str(p)


def test_in_a_notebook_it_is_a_form(practice_file, monkeypatch):
    widgets = pytest.importorskip("ipywidgets")
    monkeypatch.setattr(collection, "in_notebook", lambda: True)
    assert isinstance(try_problem("2/18", practice_file.parent), widgets.VBox)


@pytest.mark.parametrize(
    ("problem", "chapter"), [("4/12", "ch04"), ("11/3", "ch11"), ("A/1", "appA")]
)
def test_without_a_file_that_has_it_try_problem_says_where_to_get_one(
    problem, chapter, practice_file, tmp_path
):
    for folder in (practice_file.parent, tmp_path):
        said = try_problem(problem, folder)
        assert f"No practice file here has problem {problem}" in str(said)
        assert f"`python -m grader practice {chapter} -o {chapter}.practice`" in said.markdown


def test_a_broken_practice_file_is_told_apart_from_none(tmp_path):
    (tmp_path / "ch04.practice").write_text("nothing")
    with pytest.raises(PracticeFileError, match="not a practice file"):
        try_problem("4/12", tmp_path)
