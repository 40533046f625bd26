"""The page of everything that a sketch can draw: it is complete, and each picture can be read."""

import re

from newton_euler.drawing import Sketch
from newton_euler.drawing.__main__ import main
from newton_euler.drawing.vocabulary import entries

METHODS = {name for name in dir(Sketch) if not name.startswith("_")} - {"finish"}


def test_every_method_of_a_sketch_is_on_the_page():
    used = {name for entry in entries() for name in re.findall(r"\bs\.(\w+)\(", entry.code)}
    assert used == METHODS


def test_the_command_writes_a_page_with_a_text_for_each_picture(tmp_path, capsys):
    main(["--to", str(tmp_path / "new" / "page.html")])
    page = (tmp_path / "new" / "page.html").read_text(encoding="utf-8")
    assert capsys.readouterr().out.strip().endswith("page.html")
    described = re.findall(r'<svg [^>]+ aria-label="Drawing: [^"]+\."', page)
    assert page.count("<svg") == len(described) == len(entries())
    assert "s.hemisphere(" in page
