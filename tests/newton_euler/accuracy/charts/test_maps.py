"""charts/maps.py: regions are named, islands explained or smoothed as noise."""

import numpy as np
import pytest
from matplotlib.figure import Figure

from newton_euler.accuracy.charts import maps
from newton_euler.accuracy.measurements.regime_maps import MAPS, Axis, Map

SEA, LAND = "sea", "land"


def measured(land, timed=False):
    """A map of the square (0, 10) x (0, 10), whose land is where ``land(x, y)``, and its cells."""
    sides = Axis("x, m", 0.0, 10.0, "linear"), Axis("y, m", 0.0, 10.0, "linear")
    column = lambda x, ys: [LAND if land(x, y) else SEA for y in ys]
    about = "fake", "A sea", "Words.", *sides, (SEA, LAND)
    chart = Map(*about, column, (), (10, 10), timed=timed)
    return chart, chart.measure()


def test_parts_at_a_corner_are_one_and_islands_or_specks_of_missing_times_go():
    found = np.full((4, 4), SEA, dtype=object)
    found[0, 0] = found[1, 1] = found[3, 3] = LAND
    (island,) = maps.islands(found)
    assert (island.choice, island.cells) == (LAND, ((3, 3),))
    chart, found = measured(lambda x, y: False, timed=True)
    found[:6, 0] = found[9, 9] = found[:5, 5] = LAND
    better, changed = maps.without_noise(chart, found)
    assert (better[:, 1:] == SEA).all()
    assert (better[:6, 0] == LAND).all()  # the largest part is not an island
    assert changed == 6
    assert "noise of the times" in maps.map_caption(chart, better, changed)
    better, changed = maps.without_noise(
        *measured(lambda x, y: (y < 5 and x < 4) or (x > 9 and y > 6) or (x > 6 and y < 1), True)
    )
    assert changed == 4 + 4
    assert (better[:5, :4] == LAND).all()
    assert (better[6:, 9] == SEA).all()


def test_an_island_where_no_times_decide_is_called_a_strip_thinner_than_a_cell():
    found = measured(lambda x, y: (abs(y - 4.5) < 0.2 and abs(x - 4.5) < 0.1) or y > 9)
    (output,) = maps.island_sentences(*found)
    place = 'The island of "land" at x = 4.5 lies between 4.3 and 4.7 of y'
    assert output.startswith(f"{place}: a strip")
    assert output in maps.map_caption(*found)
    (output,) = maps.island_sentences(*measured(lambda x, y: (2 < x < 5 and 2 < y < 5) or y > 9))
    assert output.endswith("a region of its own.")  # larger than a cell


def test_the_caption_follows_when_the_choices_are_swapped():
    caption = maps.map_caption(*measured(lambda x, y: x < 3))
    assert "sea: 70 %; land: 30 %." in caption
    assert "At the lowest y, from left to right: land; from 3 on sea." in caption
    assert "sea: 30 %; land: 70 %." in maps.map_caption(*measured(lambda x, y: x >= 3))


def regions(chart, found):
    """{name: whether it is written inside its own region}, for the names drawn."""
    figure = Figure()
    ax = figure.subplots()
    maps.draw_choices(chart, found, ax)
    x, y = chart.x.edges(found.shape[1]), chart.y.edges(found.shape[0])
    places = {t.get_text().replace("\n", " "): t.get_position() for t in ax.texts}
    return {
        name: found[np.searchsorted(y, b) - 1, np.searchsorted(x, a) - 1] == name
        for name, (a, b) in places.items()
    }


@pytest.mark.parametrize("name", ["top", "projectile", "steady precession"])
def test_every_large_region_has_its_name_inside_it(name):
    chart = MAPS[name]
    found = chart.measure((14, 14))
    written = regions(chart, found)
    assert all(written.values())
    assert {choice for choice in chart.choices if (found == choice).mean() > 0.1} <= set(written)


def test_a_region_of_few_cells_is_in_the_legend_only():
    chart, found = measured(lambda x, y: False)
    found[0, 0] = LAND
    assert set(regions(chart, found)) == {SEA}
