"""Bodies with holes and thickness: one sees through holes, into shells, and the near parts."""

import numpy as np
import pytest

from newton_euler.drawing.page.primitives import LIGHT, MIDDLE, PALE, SHADED, WHITE
from tests.sketching import O, colour_at, ground, sketch

CORNERS = [(0, 0, 0), (4, 0, 0), (4, 2, 0), (0, 2, 0)]


@pytest.mark.parametrize("sense", [1, -1])
@pytest.mark.parametrize("order", [1, -1])
@pytest.mark.parametrize("thickness", [0, 0.5])
def test_the_holes_of_a_plate_can_be_seen_through(sense, order, thickness):
    """This holds whichever way the outline and the hole run."""
    s = sketch(plane="xy")
    hole = s.around((1, 1, 0), (1.5, 1, 0), ground.k * sense)
    s.plate(CORNERS[::order], [hole], thickness=thickness)
    assert colour_at(s, 1, 1, 0) == WHITE
    assert colour_at(s, 3, 1, 0) == LIGHT.lower()


def test_a_plate_shows_what_is_behind_its_hole_and_covers_an_earlier_one():
    s = sketch(plane="xy")
    s.plate(CORNERS, [s.around((1, 1, 0), (1.5, 1, 0), ground.k)])
    s.plate([(0, 0, -1), (4, 0, -1), (4, 2, -1), (0, 2, -1)], shade="dark")
    assert colour_at(s, 1, 1, 0) == SHADED.lower()
    s = sketch(azimuth=35, elevation=40)
    s.plate(CORNERS)
    s.plate([(0.2, 0.2, 0), (0.8, 0.2, 0), (0.8, 1.8, 0), (0.2, 1.8, 0)], shade="dark")
    assert colour_at(s, 0.5, 1, 0) == SHADED.lower()


def test_a_tube_is_open_with_a_dark_wall_inside():
    for bore, colour in ((0.6, WHITE), (0, PALE.lower())):
        s = sketch(plane="xy")
        s.cylinder((0, 0, -1), (0, 0, 1), 1, bore=bore)
        assert colour_at(s, 0, 0, 0) == colour
        assert colour_at(s, 0.8, 0, 0) == PALE.lower()
    s = sketch(azimuth=0, elevation=30)
    s.cylinder(O, (0, 0, 3), 1, bore=0.8)
    assert colour_at(s, -0.8, 0, 2.8) == SHADED.lower()
    assert colour_at(s, 1, 0, 1.5) == MIDDLE.lower()


def test_thick_plates_have_their_thickness_and_sharp_edges_and_a_round_wall():
    s = sketch(azimuth=0, elevation=0)
    s.disk((0, 1, 0), ground.j, 2, thickness=0.5)
    s.finish()
    xs, ys = np.concatenate([p.get_path().vertices for p in s.ax.patches]).T
    assert (xs.min(), xs.max()) == pytest.approx((0.75, 1.25))
    assert (ys.min(), ys.max()) == pytest.approx((-2, 2), rel=3e-3)

    def walls(corners):
        s = sketch(azimuth=20, elevation=30)
        s.plate(corners, thickness=0.5)
        s.finish()
        return len(s.ax.patches) - 1  # without the face

    assert walls(CORNERS) == 2
    places = sketch().around(O, (1, 0, 0), ground.k)
    assert walls(places) == 1, len(places)


def test_walls_hide_what_is_behind_them_and_show_what_is_within():
    s = sketch(azimuth=-80, elevation=20)
    L = [(0, 0, 0), (2, 0, 0), (2, 0, 0.5), (0.5, 0, 0.5), (0.5, 0, 1.5), (0, 0, 1.5)]
    s.plate(L, thickness=1)
    assert colour_at(s, 0.25, -0.5, 1) == LIGHT.lower()
    assert colour_at(s, 1.5, 0, 0.5) == MIDDLE.lower()
    s = sketch(azimuth=0, elevation=45)
    s.hemisphere(O, -ground.k, 1, open=True)
    s.plate([(-0.6, -0.2, -0.1), (-0.6, 0.2, -0.1), (0.6, 0.2, -0.5), (0.6, -0.2, -0.5)])
    assert colour_at(s, -0.3, 0, -0.2) == LIGHT.lower()
    assert colour_at(s, 1, 0, -0.05) == MIDDLE.lower()
    s = sketch(azimuth=0, elevation=40)
    s.cone(O, ground.k, 2, 1, open=True)
    assert colour_at(s, 0, 0, 2) == SHADED.lower()


@pytest.mark.parametrize(
    ("elevation", "axis", "is_open", "colour"),
    [
        (40, -1, True, SHADED),  # into a bowl from above
        (40, -1, False, PALE),  # the cut through half a ball
        (40, 1, True, MIDDLE),  # a dome from above
        (-40, 1, True, SHADED),  # a dome from below
    ],
)
def test_a_hemisphere_shows_its_inside_its_base_or_its_outside(elevation, axis, is_open, colour):
    s = sketch(elevation=elevation)
    s.hemisphere(O, ground.k * axis, 1, open=is_open)
    assert colour_at(s, 0, 0, 0) == colour.lower()


@pytest.mark.parametrize("azimuth", [-60, 30, 130])
def test_the_equator_of_a_sphere_is_its_front_alone_from_all_sides(azimuth):
    """No chord joins the ends of the equator."""
    s = sketch(azimuth=azimuth, elevation=50)
    s.sphere(O, 1)
    assert len({colour_at(s, 0, 0, z / 200) for z in range(-20, 21)}) == 1
