"""``python -m newton_euler chapters``."""

import json

from newton_euler.__main__ import main


def test_the_notebooks_are_copied_and_work_is_never_overwritten(tmp_path, capsys):
    assert main(["chapters", str(tmp_path / "here")]) == 0
    copy = tmp_path / "here" / "ch04_relative_motion.ipynb"
    assert json.loads(copy.read_text())["nbformat"] == 4
    copy.write_text("my notes")
    main(["chapters", str(tmp_path / "here")])
    assert copy.read_text() == "my notes"
    assert "left alone" in capsys.readouterr().out
