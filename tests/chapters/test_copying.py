"""``python -m newton_euler chapters``."""

import json

import pytest

from newton_euler.__main__ import main
from newton_euler.chapters import copying as notebooks


@pytest.fixture
def call(tmp_path, capsys):
    """A function that calls the command for a folder here and returns what it prints."""

    def called(name="here"):
        assert main(["chapters", str(tmp_path / name)]) == 0
        return capsys.readouterr().out

    return called


def test_the_notebooks_are_copied_and_counted(call, tmp_path):
    output = call()
    copies = sorted((tmp_path / "here").iterdir())
    assert {path.suffix for path in copies} == {".ipynb"}
    assert json.loads((tmp_path / "here" / "ch04_relative_motion.ipynb").read_text())["cells"]
    assert f"copied to {tmp_path / 'here'}: {len(copies)} notebooks" in output
    assert "left alone" not in output


def test_work_is_never_overwritten_and_what_was_left_alone_is_counted(call, tmp_path):
    call()
    copy, *others = sorted((tmp_path / "here").iterdir())
    copy.write_text("my notes")
    others[0].unlink()
    output = call()
    assert copy.read_text() == "my notes"
    assert others[0].exists()
    assert "1 notebook\n" in output
    assert f"there already, left alone: {len(others)} notebook" in output


def test_it_says_how_to_open_them(call, tmp_path, monkeypatch):
    assert f"To open them:\n  jupyter lab '{tmp_path / 'my work'}'" in call("my work")
    monkeypatch.setattr(notebooks, "find_spec", lambda name: None)
    assert "  pip install jupyterlab ipywidgets\n  jupyter lab" in call()


def test_a_file_in_the_place_of_the_folder_is_refused_in_words(tmp_path, capsys):
    (tmp_path / "taken").write_text("mine")
    for folder in (tmp_path / "taken", tmp_path / "taken" / "below"):
        with pytest.raises(SystemExit) as stopped:
            main(["chapters", str(folder)])
        assert stopped.value.code == 2
        output = capsys.readouterr().err
        assert "is a file; name a folder" in output or "nothing can be written to" in output
    assert (tmp_path / "taken").read_text() == "mine"


@pytest.mark.parametrize("words", [["--help"], ["chapters", "--help"]])
def test_the_help_has_an_example(words, capsys):
    with pytest.raises(SystemExit) as stopped:
        main(words)
    assert stopped.value.code == 0
    assert "python -m newton_euler chapters" in capsys.readouterr().out
