"""interactive.py: pictures that stay still without sliders and move with them."""

import sys

import matplotlib
import pytest

from newton_euler import Frame, NewtonEulerError
from newton_euler.classroom import Slider, interactive_figure

matplotlib.use("Agg")
ALT = "A line from the origin to the place (a, b)."
A, B = Slider("a", 1.0, 0, 2, 0.5, unit="m"), Slider("b", 2, 0, 3, 1, label="β")
GROUND = Frame("ground")


def plot(ax, a, b):
    ax.plot([0, a], [0, b])
    ax.set(xlim=(0, 3), ylim=(0, 3))


def test_without_ipywidgets_the_picture_stands_alone(shown, monkeypatch):
    monkeypatch.setitem(sys.modules, "ipywidgets", None)
    interactive_figure(plot, A, B, alt=ALT, size=(2, 2))
    ((data, metadata),) = shown.outputs
    words = f"{ALT} (a = 1.0\N{NO-BREAK SPACE}m, β = 2)"
    assert f'alt="{words}"' in data["text/html"]
    assert metadata["image/png"] == {"alt": words, "width": 200, "height": 200}


def boxes(shown):
    """The sliders and the texts beside them."""
    pytest.importorskip("ipywidgets")
    return [row.children for row in shown.outputs[1].children]


def test_a_slider_redraws_the_picture_in_its_place(shown):
    interactive_figure(plot, A, B, alt=lambda a, b: f"{ALT} a = {a}, b = {b}", size=(2, 2))
    (first, beside), (second, _) = boxes(shown)
    assert beside.value == "a = 1.0\N{NO-BREAK SPACE}m"
    assert first.continuous_update
    first.value, second.value = 1.5, 3
    assert beside.value == "a = 1.5\N{NO-BREAK SPACE}m"
    assert shown.updates[-1][0]["text/plain"].endswith("a = 1.5, b = 3")
    assert len({data["text/html"] for data, _ in [shown.outputs[0], *shown.updates]}) == 3


def test_an_alternative_text_says_where_the_sliders_are(shown):
    interactive_figure(plot, A, B, alt=ALT, size=(2, 2))
    boxes(shown)[1][0].value = 3
    assert shown.updates[-1][0]["text/plain"] == f"{ALT} (a = 1.0\N{NO-BREAK SPACE}m, β = 3)"


def test_an_error_in_draw_is_shown_in_place_of_the_picture(shown):
    def fails(ax, a):
        if a == 1.51:
            raise ValueError("too far")

    interactive_figure(fails, Slider("a", 1.0, 0, 4, 0.01), alt=ALT)
    boxes(shown)[0][0].value = 1.51
    assert "No picture for a = 1.51. ValueError: too far" in shown.updates[-1][0]["text/html"]


def test_plots_have_no_window_to_find_and_are_tried_at_the_corners_alone(shown):
    drawn = []

    def noted(ax, a):
        plot(ax, a, 0)
        drawn.append(a)

    interactive_figure(noted, Slider("a", 1.0, 0, 4, 0.1), alt=ALT)
    assert {*drawn} == {0, 1, 4}


def test_an_error_in_draw_at_a_sample_says_for_which_values(shown):
    def fails(ax, a, b):
        if a == 2:
            raise ValueError("too far")

    with pytest.raises(ValueError, match="too far") as error:
        interactive_figure(fails, A, B, alt=ALT)
    assert error.value.__notes__ == ["This came up while the picture for a = 2, b = 0 was drawn."]


@pytest.mark.parametrize(("sliders", "options", "message"), [
    ((A, A), {}, "different names"),
    ((), {}, "different names"),
    ((A, B), {"alt": "too short"}, "8 words"),
    ((A, B), {"alt": lambda a, b: "too short"}, "8 words"),
    ((A, B), {"panels": (0, 1)}, "one row and column or more"),
    ((A, B), {"size": 3}, "size is a sequence"),
    ((A, B), {"draw": lambda ax, a, b: ax.figure}, "returns nothing"),
    ((3,), {}, "Slider"),
])  # fmt: skip
def test_a_figure_that_cannot_be_is_refused_in_words(shown, sliders, options, message):
    given = {"draw": plot, "alt": ALT, **options}
    with pytest.raises(NewtonEulerError, match=message):
        interactive_figure(given.pop("draw"), *sliders, **given)
