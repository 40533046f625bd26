"""widgets.py: pictures that stay where there are no sliders, and move where there are."""

import sys

import matplotlib
import pytest

from newton_euler import Frame
from newton_euler.classroom.widgets import error_message, interactive_figure

matplotlib.use("Agg")


class Shown:
    """Stands in for IPython's display: what was shown, and what it was replaced by."""

    def __init__(self, monkeypatch):
        self.outputs, self.updates = [], []
        monkeypatch.setattr("IPython.display.display", self.display)

    def display(self, thing, display_id=False):
        self.outputs.append(thing)
        return self

    def update(self, thing):
        self.updates.append(thing)


@pytest.fixture
def shown(monkeypatch):
    return Shown(monkeypatch)


def drawing(calls):
    import matplotlib.pyplot as plt

    def draw(**settings):
        calls.append(settings)
        figure, ax = plt.subplots(figsize=(2, 2))
        ax.plot([0, settings["a"]], [0, settings["b"]])
        return figure

    return draw


def test_without_ipywidgets_the_picture_is_shown_and_nothing_else(shown, monkeypatch):
    monkeypatch.setitem(sys.modules, "ipywidgets", None)
    calls = []
    interactive_figure(drawing(calls), a=(1.0, 0, 2), b=(2, 0, 3, 0.5))
    assert calls == [{"a": 1.0, "b": 2}]
    assert [thing.data[:4] for thing in shown.outputs] == [b"\x89PNG"]


def test_a_slider_draws_the_picture_anew_in_its_place(shown):
    pytest.importorskip("ipywidgets")
    import matplotlib.pyplot as plt

    calls = []
    interactive_figure(drawing(calls), a=(1.0, 0, 2), b=(2, 0, 3, 0.5))
    picture, box = shown.outputs
    first, second = box.children
    assert (first.description, first.min, first.max, first.step, second.step) == (
        "a",
        0,
        2,
        0.04,
        0.5,
    )
    first.value = 1.6
    assert calls[-1] == {"a": 1.6, "b": 2.0}
    (new,) = shown.updates
    assert new.data[:4] == b"\x89PNG"
    assert new.data != picture.data
    assert not plt.get_fignums()  # else the notebook would show each figure twice


def test_a_refusal_is_told_in_lines_and_its_absence_is_an_error():
    ground = Frame("ground")
    told = error_message(lambda: ground.i.rate(), width=60)
    assert told.startswith("FrameError: a vector changes differently")
    assert max(map(len, told.splitlines())) <= 60
    with pytest.raises(AssertionError, match="nothing was refused; the result is 3"):
        error_message(lambda: 3)
