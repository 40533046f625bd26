"""sliders.py: the values of a slider and how they are shown."""

import pytest

from newton_euler import NewtonEulerError
from newton_euler.classroom import Slider


def test_a_value_is_the_start_and_whole_steps_with_label_unit_and_decimals():
    slider = Slider("p", 0.3, 0, 1, 0.1)
    assert [slider.nearest(x) for x in (0.2999999, 0.7, 0.31)] == [0.3, 0.7, 0.3]
    assert slider.limits == (0, 1)
    assert Slider("p", 0.25, 0, 1, 0.1).limits == (0.05, 0.95)
    assert isinstance(Slider("n", 3, 1, 9, 2).nearest(6.8), int)
    assert Slider("phi", 30, 0, 90, 5, label="φ", unit="°").shown(30) == "φ = 30°"
    shown = Slider("p", 4.0, -6, 6, 0.5, unit="rad/s").shown(-2)
    assert shown == "p = \N{MINUS SIGN}2.0\N{NO-BREAK SPACE}rad/s"


@pytest.mark.parametrize(("numbers", "message"), [
    ((5, 0, 4, 1), "lowest <= start <= highest"), ((1, 0, 4, 0), "0 < step"),
    ((1, 0, 4, 5), "step <= span"), ((1, 0, "4", 1), "highest is one real number"),
    ((1, 0, float("inf"), 1), "step <= span"),
])  # fmt: skip
def test_a_slider_that_cannot_be_is_refused_in_words(numbers, message):
    with pytest.raises(NewtonEulerError, match=message):
        Slider("a", *numbers)
    with pytest.raises(NewtonEulerError, match="argument of draw; got 'a b'"):
        Slider("a b", 1, 0, 2, 1)
