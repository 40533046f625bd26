"""A problem tried in place, in a chapter."""

import pytest

from newton_euler.classroom import PracticeFileError, PracticeProblem, practice, try_problem
from newton_euler.classroom.practising import collection


def test_try_problem_opens_the_file_that_has_the_problem_and_names_a_broken_one(
    practice_file, hints_file, tmp_path
):
    assert practice_file.parent != hints_file.parent
    p = try_problem("2/18", practice_file.parent)
    assert isinstance(p, PracticeProblem)
    assert p.id == "2/18"
    assert "2/18" in str(p)
    (tmp_path / "ch04.practice").write_text("nothing")
    with pytest.raises(PracticeFileError, match="not a practice file"):
        try_problem("4/12", tmp_path)


def test_in_a_notebook_it_is_a_form(practice_file, monkeypatch):
    widgets = pytest.importorskip("ipywidgets")
    monkeypatch.setattr(collection, "in_notebook", lambda: True)
    assert isinstance(try_problem("2/18", practice_file.parent), widgets.VBox)


def test_where_no_file_has_it_try_problem_opens_the_engines(practice_file, tmp_path, monkeypatch):
    monkeypatch.setattr(collection, "SETS", practice_file.parent)
    p = try_problem("4/16", tmp_path)
    p.check(v_D=[1, 2, 3])
    assert [path.name for path in tmp_path.iterdir()] == ["practice.progress.json"]
    monkeypatch.chdir(tmp_path)
    assert list(practice()) == list(practice(practice_file)) == list(practice("some"))
    assert practice()["4/16"].givens == p.givens
    assert "4/16 is unfinished" in str(practice().next)


def test_an_engine_without_any_says_how_they_are_written(practice_file, tmp_path, monkeypatch):
    monkeypatch.setattr(collection, "SETS", tmp_path)
    output = try_problem("4/12", tmp_path)
    assert "No practice file has problem 4/12" in str(output)
    assert "`python -m grader sets`" in output.markdown
    (tmp_path / "ch04.practice").write_bytes(practice_file.read_bytes())
    assert "of its chapter there are 4/1, 4/2" in str(try_problem("4/999", tmp_path))
    (tmp_path / "ch04.practice").unlink()
    with pytest.raises(PracticeFileError, match="no practice comes with this engine"):
        practice()
