"""plots.py, plot_writer.py: the plots of a panel lie where matplotlib puts them."""

import math
import re
from xml.etree import ElementTree

import pytest
from matplotlib.figure import Figure

from newton_euler.drawing.page.paper import NeedsMatplotlib, Page
from newton_euler.drawing.page.plot_writer import Drawing
from newton_euler.drawing.page.plots import Scale
from newton_euler.drawing.page.recorder import figure_of
from newton_euler.drawing.page.svg import svg

NAME = "{http://www.w3.org/2000/svg}"
TIMES = [n / 20 for n in range(41)]


def curves(ax):
    ax.plot(TIMES, [math.sin(5 * t) for t in TIMES], "--", color="#D55E00", label=r"$\omega_x$")
    ax.plot([0.5], [0.2], "o", ms=8, label="now")
    ax.axhline(0, color="black", lw=0.8)
    ax.axvline(1.3, ls=":")
    ax.fill_between(TIMES, TIMES, where=[t > 1 for t in TIMES], alpha=0.4)
    ax.set(xlabel="time (s)", ylabel="rad/s", xlim=(0, 2), ylim=(-1, 3))
    ax.legend(frameon=False, loc="upper left")
    ax.set_title("a motion")


def powers(ax):
    ax.loglog([1e-4, 1e-2, 1], [1e-8, 1e-4, 1], "o-", label="square")
    ax.set(xlabel="step", ylabel="error")


def bars(ax):
    for n, x in enumerate((3.0, -2.0)):
        ax.bar(n, x, 0.6, color=f"C{n}", hatch="//", edgecolor="white")
        ax.annotate(f"{x}", (n, x), (0, 3), textcoords="offset points", ha="center")
    ax.set_xticks(range(2), ["T", "V"])


def circle(ax):
    ax.plot([math.cos(t * math.pi) for t in TIMES], [math.sin(t * math.pi) for t in TIMES])
    ax.set(aspect="equal", xlim=(-2, 2), ylim=(-1, 1))


def tree_of(draw, size=(5, 4)):
    page = Page(size)
    draw(page.panel)
    return page, ElementTree.fromstring(svg(page))


@pytest.mark.parametrize("draw", [curves, powers, bars, circle])
def test_limits_scales_and_lines_are_those_of_matplotlib(draw):
    page, tree = tree_of(draw)
    ax = Figure(figsize=(5, 4)).add_subplot()
    draw(ax)
    found = Drawing(page.panel)
    for scale, limits in ((found.x, ax.get_xlim()), (found.y, ax.get_ylim())):
        assert (scale.low, scale.high) == pytest.approx(limits, rel=0.06, abs=0.1)
    replayed = figure_of(page).axes[0]
    assert [len(line.get_xdata()) for line in replayed.lines] == [
        len(line.get_xdata()) for line in ax.lines
    ]
    texts = {"".join(text.itertext()) for text in tree.iter(NAME + "text")}
    assert {ax.get_xlabel(), ax.get_ylabel(), ax.get_title()} - {""} <= texts


def test_places_are_drawn_where_their_numbers_are_and_none_is_a_gap():
    page, tree = tree_of(lambda ax: (ax.plot([1], [10], "o"), ax.set(xlim=(0, 4), ylim=(0, 40))))
    (dot,) = tree.iter(NAME + "circle")
    frame = Drawing(page.panel)
    assert float(dot.get("cx")) == pytest.approx(frame.left + frame.w / 4, abs=0.1)
    assert float(dot.get("cy")) == pytest.approx(frame.top + frame.h * 3 / 4, abs=0.1)
    page, _ = tree_of(circle)
    frame = Drawing(page.panel)
    assert frame.w == pytest.approx(2 * frame.h)
    _, tree = tree_of(lambda ax: ax.plot([0, 1, 2, 3, 4], [0, 1, math.nan, 1, math.inf]))
    (line,) = (p for p in tree.iter(NAME + "path") if p.get("fill") == "none")
    assert re.sub(r"[^ML]", "", line.get("d")) == "MLM"
    _, tree = tree_of(lambda ax: ax.set(xlabel="x"))
    assert any("".join(t.itertext()) == "x" for t in tree.iter(NAME + "text"))


def test_an_arrow_leads_to_its_place_or_is_as_long_as_its_scale_says():
    def arrows(ax):
        ax.annotate("", (3, 20), (1, 10), arrowprops={"arrowstyle": "->"})
        ax.quiver([2], [20], [3.0], [0.0], scale=10, pivot="mid")
        ax.set(xlim=(0, 4), ylim=(0, 40))
        ax.axis("off")

    page, tree = tree_of(arrows)
    frame = Drawing(page.panel)
    begins = lambda path: [float(x) for x in re.findall(r"[\d.]+", path.get("d"))[:2]]
    paths = [*tree.iter(NAME + "path")]
    tails, tips = ([begins(p) for p in paths if p.get(of)] for of in ("stroke", "fill"))
    assert tails[0] == pytest.approx(frame.at(1, 10), abs=0.1)
    assert tips[0] == pytest.approx(frame.at(3, 20), abs=0.1)
    assert tips[1][0] - tails[1][0] == pytest.approx(0.3 * frame.w, abs=0.2)
    assert (tips[1][0] + tails[1][0]) / 2 == pytest.approx(frame.at(2, 20)[0], abs=0.2)
    assert len([*tree.iter(NAME + "rect")]) == 1  # the page alone, no frame


@pytest.mark.parametrize(("limits", "log", "ticks"), [
    ((0, 2), False, ["0.0", "0.5", "1.0", "1.5", "2.0"]),
    ((-6, 6), False, ["−5", "0", "5"]),
    ((0, 0.07), False, ["0.00", "0.02", "0.04", "0.06"]),
    ((-0.3, 0.3), False, ["−0.2", "0.0", "0.2"]),
    ((0, 0.3), False, ["0.0", "0.1", "0.2", "0.3"]),  # 0.3/0.1 is a little less than 3
    ((-0.3, 0), False, ["−0.3", "−0.2", "−0.1", "0.0"]),
    ((40, 0), False, ["0", "10", "20", "30", "40"]),
    ((1e-5, 20), True, ["$10^{-4}$", "$10^{-2}$", "$10^{0}$"]),
    ((3, 3), False, ["3"]),
])  # fmt: skip
def test_ticks_are_round_numbers(limits, log, ticks):
    scale = Scale([], limits, log)
    places = scale.ticks(4)
    step = places[1] - places[0] if len(places) > 1 else 1
    assert [scale.text(x, step) for x in places] == ticks


@pytest.mark.parametrize("draw", [
    lambda ax: ax.plot([0, 1], [0, 1], [0, 1], [1, 0]),
    lambda ax: ax.plot([0, 1], "P:"),
    lambda ax: ax.quiver(0, 0, 1, 1),
    lambda ax: ax.twinx(),
    lambda ax: ax.set(zlabel="z"),
    lambda ax: ax.axhline(0, xmin=0.5),
    lambda ax: ax.annotate("", (0, 0), (1, 1), arrowprops={}),
    lambda ax: ax.legend(title="curves"),
])  # fmt: skip
def test_what_only_matplotlib_draws_is_refused(draw):
    with pytest.raises(NeedsMatplotlib):
        draw(Page().panel)
