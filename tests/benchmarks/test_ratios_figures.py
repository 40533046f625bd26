"""What a redraw costs while a slider is dragged, compared with saving the picture by Matplotlib."""

import io
import time
from functools import partial

import pytest

from newton_euler.classroom.widgets.stage import Stage
from tests.chapters.moving_figures import FIGURES

pytestmark = pytest.mark.benchmark


def shortest(f, count=7):
    """The least of several CPU times of this thread, in ms."""
    times = []
    for _ in range(count):
        start = time.thread_time()
        f()
        times.append(1000 * (time.thread_time() - start))
    return min(times)


def by_matplotlib(draw, values, size, panels):
    from matplotlib.figure import Figure

    figure = Figure(figsize=size)
    draw(figure.subplots(*panels), **values)
    figure.savefig(io.BytesIO(), format="png", dpi=100)


@pytest.mark.parametrize("name", FIGURES)
def test_a_redraw_takes_half_the_time_of_a_new_figure_or_less(name):
    figure, given = FIGURES[name]
    draw, options = partial(figure.draw, **given), figure.options
    size, panels = options.get("size", (7, 4.6)), options.get("panels", (1, 1))
    start = {slider.name: slider.start for slider in figure.sliders}
    stage = Stage(draw, size, panels)
    stage.rehearse([start])
    new = shortest(lambda: by_matplotlib(draw, start, size, panels))
    redraw = shortest(lambda: stage.picture(start, None))
    print(f"\n{name}: {redraw:.0f} ms, a new figure by matplotlib {new:.0f} ms")
    assert redraw < new / 2
