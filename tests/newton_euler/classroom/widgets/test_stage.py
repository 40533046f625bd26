"""stage.py: all pictures of a figure share one window and one scale, and leave nothing out."""

import re
from xml.etree import ElementTree

import numpy as np
import pytest
from matplotlib.colors import to_hex

from newton_euler import Frame
from newton_euler.classroom.widgets.stage import Stage
from newton_euler.drawing import Sketch
from newton_euler.drawing.page.primitives import DARK, KINDS

NAME = "{http://www.w3.org/2000/svg}"
GROUND, O = Frame("ground"), (0, 0, 0)


def stage(draw, samples, **options):
    found = Stage(draw, **{"size": (5, 4), "panels": (1, 1), **options})
    found.rehearse(samples)
    return found


def lines(picture, colour):
    """The positions of each line of one colour on the page, in points."""
    groups = ElementTree.fromstring(picture).iter(f"{NAME}g")
    paths = [path for group in groups if group.get("stroke") == colour for path in group]
    numbers = [re.findall(r"-?[\d.]+", path.get("d")) for path in paths]
    return [np.array(n, float).reshape(-1, 2) for n in numbers]


def arrow(ax, a):
    s = Sketch(ax, GROUND, plane="xy")
    s.line(O, (3, 0, 0), style="solid")
    s.vector(O, (0, a, 0))


def arrow_length(picture):
    shaft = lines(picture, KINDS["velocity"])[0]
    return np.hypot(*(shaft[1] - shaft[0]))


def test_what_stays_in_the_scene_stays_in_the_picture_and_arrows_are_in_proportion():
    moving = stage(arrow, [{"a": a} for a in (0, 5, 10)])
    pictures = {a: moving.picture({"a": a}, None) for a in (10, 5, 0.5)}
    first, *others = (lines(p, DARK)[0] for p in pictures.values())
    assert all((other == first).all() for other in others)
    full = arrow_length(pictures[10])
    assert arrow_length(pictures[5]) == pytest.approx(full / 2, abs=0.15)
    assert arrow_length(pictures[0.5]) == pytest.approx(full / 20, abs=0.15)


def bulge(ax, a):
    """A rod that is long only at one value between the samples."""
    s = Sketch(ax, GROUND, plane="xy")
    s.rod((-1, 0, 0), (1 + 9 * (a == 0.3), 0, 0))
    s.vector(O, (0, 1 + 9 * (a == 0.3), 0))


def test_an_extreme_between_the_samples_is_not_cut_off_and_the_window_stays_wider():
    moving = stage(bulge, [{"a": a} for a in (0, 0.5, 1)])
    before = lines(moving.picture({"a": 0}, None), DARK)[0]
    for line in lines(moving.picture({"a": 0.3}, None), DARK):
        assert (line.min(axis=0) >= 0).all()
        assert (line.max(axis=0) <= (360, 288)).all()
    after = lines(moving.picture({"a": 0}, None), DARK)[0]
    assert np.ptp(after[:, 0]) < np.ptp(before[:, 0])
    assert (lines(moving.picture({"a": 1}, None), DARK)[0] == after).all()


def test_all_panels_have_one_scale():
    def two(axes, a):
        for ax, length in zip(axes, (1, 4), strict=True):
            Sketch(ax, GROUND, plane="xy").line(O, (length, 0, 0), style="solid")

    moving = stage(two, [{"a": 0}], panels=(1, 2))
    short, long = (np.ptp(v[:, 0]) for v in lines(moving.picture({"a": 0}, None), DARK))
    assert long == pytest.approx(4 * short, abs=0.15)


def test_what_only_matplotlib_draws_if_only_for_some_values_is_drawn_by_it_for_all():
    def sometimes(ax, a):
        arrow(ax, a)
        if a > 1:
            ax.text(0.5, 0.5, "by hand", transform=ax.transAxes)

    moving = stage(sometimes, [{"a": a} for a in (1, 2, 3)])
    pictures = [moving.picture({"a": a}, "both") for a in (1, 2, 2)]
    assert all(b"matplotlib" in picture for picture in pictures)
    assert pictures[0] != pictures[1]
    assert len(moving._plotted.figure.axes[0].texts) == 1  # the earlier ones are gone


def test_a_title_stands_for_its_values_only_and_one_of_the_whole_page_makes_room():
    def titled(ax, a):
        arrow(ax, a)
        if a:
            ax.set_title("moves")

    moving = stage(titled, [{"a": 0}, {"a": 1}])
    assert [moving.picture({"a": a}).count(b"moves</text>") for a in (1, 0, 1)] == [1, 0, 1]
    (first, second) = (lines(moving.picture({"a": a}), DARK)[0] for a in (0, 1))
    assert (first == second).all()
    moving = stage(arrow, [{"a": 1}])
    plain, titled = (moving.picture({"a": 1}, title) for title in (None, "all of it"))
    assert titled.count(b"all of it</text>") == 1
    assert lines(titled, DARK)[0][:, 1].min() > lines(plain, DARK)[0][:, 1].min()


def test_a_plot_beside_a_sketch_keeps_room_for_its_labels_and_is_redrawn_for_each_value():
    def both(axes, a):
        arrow(axes[0], a)
        axes[1].bar([0, 1], [a, 1], label=f"at {a}")
        axes[1].legend()
        axes[1].set(xlabel="time (s)", ylabel="force (N)")

    moving = stage(both, [{"a": a} for a in (1, 2)], panels=(1, 2))
    for a in (2, 1, 2):
        picture = moving.picture({"a": a})
        assert picture.count(b"at ") == picture.count(f"at {a}</text>".encode()) == 1
    texts = ElementTree.fromstring(picture).iter(f"{NAME}text")
    places = {"".join(t.itertext()): (float(t.get("x")), float(t.get("y"))) for t in texts}
    assert 180 < places["force (N)"][0] < places["time (s)"][0] < 360
    assert places["force (N)"][1] < places["time (s)"][1] < 285
    assert moving.png()[:4] == b"\x89PNG"


def test_nothing_of_the_rehearsal_and_of_earlier_pictures_stays_in_a_plot():
    seen = []

    def bars_beside(axes, a):
        seen.append(len(axes[1].patches) + len(axes[1].lines))  # which a panel does not have
        arrow(axes[0], a)
        axes[1].bar([0, 1], [a, 1], label=f"at {a}")
        axes[1].plot([0, 1], [a, 0])
        axes[1].legend()

    moving = stage(bars_beside, [{"a": a} for a in (1, 2, 3)], panels=(1, 2))
    assert seen == [0, 0, 0]
    for a in (3, 1, 2):
        moving.picture({"a": a}, None)
        plot = moving._plotted.axes[1]
        assert [bar.get_height() for bar in plot.patches] == [a, 1]
        assert [to_hex(line.get_color()) for line in plot.lines] == [to_hex("C0")]
        assert [text.get_text() for text in plot.get_legend().get_texts()] == [f"at {a}"]
