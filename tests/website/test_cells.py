"""Cells of a page: what they show, what they need, figures that sliders move, packages that come late."""

import json
import subprocess
import sys

import pytest

from website.browser import cells

FRAME = "from newton_euler import Frame\nfrom newton_euler.drawing import Sketch"
MOVING = """
from newton_euler.classroom import Slider, interactive_figure

def boom(ax, tilt):
    ground = Frame("ground")
    Sketch(ax, ground, plane="xz").rod((0, 0, 0), ground.rotate("b", "-y", tilt / 57.3).point("A", length, 0, 0))

interactive_figure(boom, Slider("tilt", 30, 0, 90, 5, unit="°"), alt=lambda tilt: f"A boom of a crane is raised by {tilt} degrees.")
"""


@pytest.fixture
def page():
    yield "a page"
    cells._open.clear()


SHOWN = {
    "a value": ("1 + 1", [["text/plain", "2"]]),
    "nothing": ("None", []),
    "no value before a semicolon": ("1 + 1;", []),
    "prints, joined": ("print(1)\nprint(2)", [["text/plain", "1\n2\n"]]),
    "a formula": ('from newton_euler import Frame\nFrame("g").vector(1, 0, 0)', [["text/latex", r"$\left(1\,\hat{\imath}\right)_{\text{g}}$"]]),
    "what is displayed, in order": (
        "from IPython.display import HTML, display\nprint(1)\ndisplay(HTML('<b>2</b>'))\nprint(3)",
        [["text/plain", "1\n"], ["text/html", "<b>2</b>"], ["text/plain", "3\n"]],
    ),
    "an empty cell": ("# nothing", []),
}  # fmt: skip


@pytest.mark.parametrize("case", SHOWN)
def test_what_a_cell_shows(page, case):
    source, shown = SHOWN[case]
    assert cells.run(page, [source], 0) == {"shown": shown}


@pytest.mark.parametrize(
    ("source", "words"),
    [
        ("x = 1\n1 / 0", "ZeroDivisionError: division by zero (line 2)"),
        ("e = KeyError('m')\ne.add_note('at 2 s')\nraise e", "KeyError: 'm'; at 2 s (line 3)"),
        ("x = (", "SyntaxError: '(' was never closed (line 1)"),
        ("y", "NameError: name 'y' is not defined (line 1)"),
    ],
)
def test_an_error_is_reported_with_its_line_after_what_was_shown_before(page, source, words):
    assert cells.run(page, [source], 0)["error"] == words


def test_where_no_ipython_is_a_cell_is_not_in_a_notebook(page, monkeypatch):
    monkeypatch.setitem(sys.modules, "IPython", None)
    monkeypatch.setitem(sys.modules, "IPython.display", None)
    assert cells.run(page, ["import IPython\nIPython.get_ipython()"], 0) == {"shown": []}


def test_a_cell_runs_after_what_it_needs_and_keeps_what_the_reader_ran(page):
    above = ["print('not seen')\na = 1", "a = a + 1", "broken = 1 / 0\nc = 3"]
    assert cells.run(page, [*above, "a, c"], 3) == {"shown": [["text/plain", "(2, 3)"]]}
    assert "division" in cells.run(page, [*above, "broken"], 3)["error"]
    assert "division" in cells.run("another", [*above, "d = broken + 1", "d"], 4)["error"]
    assert "'x'" in cells.run("a third", ["x = x + 1", "x"], 1)["error"]
    cells.run(page, ["a = 5", *above[1:]], 0)
    assert cells.run(page, [*above, "a"], 3) == {"shown": [["text/plain", "6"]]}


def test_what_runs_unseen_stays_unseen_even_if_what_it_needs_fails(page):
    notebook = ["n = 1 / 0", "for n in 'a': print(n)", "n"]
    assert cells.run(page, notebook, 2) == {"shown": [["text/plain", "'a'"]]}


def test_a_figure_moves_with_what_its_cell_needs_though_nobody_ran_it(page):
    notebook = [FRAME, "length = 2.0", MOVING]
    low, high = (cells.picture(page, notebook, 2, 0, {"tilt": x}) for x in (0, 90))
    assert low["svg"].startswith("<svg")
    assert low["svg"] != high["svg"]
    assert high["alt"] == "A boom of a crane is raised by 90 degrees."
    ((kind, figure),) = cells.run(page, notebook, 2)["shown"]
    assert (kind, figure["sliders"]) == ("figure", [
        {"name": "tilt", "label": "tilt", "unit": "°", "start": 30, "low": 0, "high": 90, "step": 5}
    ])  # fmt: skip


WITHOUT = """
import sys
sys.modules["numpy"] = sys.modules["matplotlib"] = None
from website.browser import answer, cells, late
late.find_spec = lambda name: None
del sys.modules["numpy"], sys.modules["matplotlib"]
late.install()
cell = "import numpy as np\\nimport matplotlib.pyplot as plt\\nfrom math import pi\\nx = 3"
print(cells.run("p", [cell, "x"], 1))
import json
for source in ("np.eye(3)", "plt.plot", "from numpy import eye"):
    print(answer("cells.run", json.dumps({"page": "p", "cells": [cell, source], "number": 1})))
"""


def test_a_missing_package_is_missed_only_by_the_cells_that_use_it():
    done = subprocess.run([sys.executable, "-c", WITHOUT], capture_output=True, text=True)
    assert done.stderr == ""
    first, *missing = done.stdout.splitlines()
    assert first == "{'shown': [['text/plain', '3']]}"
    assert [json.loads(x)["needs"] for x in missing] == ["numpy", "matplotlib", "numpy"]
    assert json.loads(missing[1])["error"].startswith("this needs Matplotlib, which the page")


def test_names_that_a_later_cell_rebinds_do_not_separate_what_belongs_together(page):
    """Two frames of one name, in one tree: cells run in order, and out of order."""
    notebook = [
        "from newton_euler import Frame\nground = Frame('ground')\narm = ground.rotate('arm', 'z', rate=2.0)",
        "first = arm.angular_velocity(ground)",
        "ground = Frame('ground')\nboom = ground.rotate('boom', 'x', rate=1.0)\n1 / 0",
        "boom.angular_velocity(ground).norm()",
        "first.norm()",
    ]  # fmt: skip
    for number in (0, 1, 2, 3, 4, 1, 3):
        found = cells.run(page, notebook, number)
        assert ("error" in found) == (number == 2)
    assert found == {"shown": [["text/plain", "1.0"]]}
