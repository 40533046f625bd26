"""animation.py: one window for all pictures, one call for each time, and refusals in words."""

import io
import math
from itertools import pairwise

import numpy as np
import pytest
from PIL import Image

from newton_euler import Frame
from newton_euler.algebra.errors import ArgumentError
from newton_euler.drawing.animation import MAX_PICTURES, AnimationError, animate
from newton_euler.drawing.page.primitives import KINDS
from newton_euler.drawing.page.recorder import share_window
from newton_euler.drawing.sketch import Sketch
from tests.sketching import ground, sketch, texts, vertices


def arm(t, ax):
    """A rod that turns once in two seconds and grows; its tip has an arrow for its velocity."""
    tip = ground.vector(0, (1 + t) * math.cos(math.pi * t), (1 + t) * math.sin(math.pi * t))
    s = Sketch(ax, ground, plane="yz")
    s.rod((0, 0, 0), tip)
    s.vector(tip, ground.vector(0, 1 + t, 0), "v")
    s.label((0, 0, 0), "O")


TIMES = [0.25 * n for n in range(9)]


def seen(film):
    return [np.asarray(Image.open(io.BytesIO(picture)).convert("L")) for picture in film.pictures]


def test_every_picture_has_one_size_shows_its_own_instant_and_reaches_no_edge():
    pictures = seen(animate(arm, TIMES, size=(3, 2)))
    assert {p.shape for p in pictures} == {(200, 300)}
    assert all((a != b).any() for a, b in pairwise(pictures))
    called = []
    animate(lambda t, ax: (called.append(t), arm(t, ax)), np.linspace(0, 1, 5))
    assert called == [0, 0.25, 0.5, 0.75, 1]
    assert {type(t) for t in called} == {float}
    for picture in seen(animate(arm, TIMES, size=(3, 2))):
        edges = picture[0], picture[-1], picture[:, 0], picture[:, -1]
        assert (np.concatenate(edges) > 250).all()


def test_what_rests_stays_on_the_page_and_arrows_of_one_kind_have_one_measure_in_all_pictures():
    scenes = []
    for size in (1, 2, 4):
        s = sketch(plane="yz")
        s.rod((0, 0, 0), (0, size, 0))
        s.vector((0, size, 0), (0, 0, size), "v")
        s.label((0, 0, 0), "O")
        scenes.append(s)
    share_window(scenes)
    assert len({texts(s)["O"].get_position() for s in scenes}) == 1
    assert len({(*s.ax.get_xlim(), *s.ax.get_ylim()) for s in scenes}) == 1
    shafts = [next(v for v in vertices(s, KINDS["velocity"]) if len(v) == 2) for s in scenes]
    lengths = np.array([np.ptp(shaft[:, 1]) for shaft in shafts])
    assert lengths / lengths[-1] == pytest.approx([0.25, 0.5, 1])


@pytest.mark.parametrize(("end", "speed"), [(2, 1), (30, 1), (0.008, 0.001), (800, 100)])
def test_a_motion_that_is_too_quick_or_too_slow_to_watch_lasts_8_seconds(end, speed):
    assert animate(arm, [0, end / 2, end]).speed == pytest.approx(speed)
    assert animate(arm, [0, end], speed=0.5).speed == 0.5


@pytest.mark.parametrize(("arguments", "words"), [
    ({"times": range(MAX_PICTURES + 1)}, r"601 pictures are too many .* 600 at most: give fewer times, as times\[::2\]"),
    ({"times": range(500), "size": (15, 12)}, "500 pictures of 1500 by 1200 pixels are too much .* a smaller size"),
    ({"times": [1]}, "two times or more, got 1"),
    ({"times": [0, 2, 1]}, "increase; got 2.0 and then 1.0"),
    ({"times": [0, math.nan]}, "finite and increase; got 0.0 and then nan"),
    ({"times": 3}, "times is a sequence, .*; got 3"),
    ({"times": [0, 1], "speed": 0}, "positive; got 0"),
    ({"times": [0, 1], "draw": lambda t, ax: None}, r"with Sketch\(ax, ...\), and did not at t = 0 s"),
])  # fmt: skip
def test_what_cannot_be_shown_is_an_error_before_anything_is_drawn(arguments, words):
    with pytest.raises((AnimationError, ArgumentError), match=words):
        animate(**({"draw": arm} | arguments))


def test_an_error_of_draw_comes_through_and_names_the_instant():
    def draw(t, ax):
        arm(t, ax)
        Frame("ground").point("P", 1 / (2 - t), 0, 0)

    with pytest.raises(ZeroDivisionError) as caught:
        animate(draw, [0, 1, 2])
    assert caught.value.__notes__ == ["This came up while the picture at t = 2 s was drawn."]
