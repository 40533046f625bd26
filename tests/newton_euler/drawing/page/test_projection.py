"""projection.py: a point appears where it should, in a right-handed view."""

import math

import numpy as np
import pytest

from newton_euler.drawing.page.projection import circle, convex_hull, plane_view, space_view
from tests.sketching import sketch, vertices


@pytest.mark.parametrize(("view", "place", "page"), [
    ({"plane": "xz"}, (3, 5, 2), (3, 2)),
    ({"plane": "yx"}, (3, 5, 2), (5, 3)),
    ({"azimuth": 0, "elevation": 0}, (3, 5, 2), (5, 2)),
    ({"azimuth": -90, "elevation": 0}, (3, 5, 2), (3, 2)),
    ({"azimuth": -90, "elevation": 90}, (3, 5, 2), (3, 5)),
    ({"azimuth": 0, "elevation": 0, "up": "y"}, (3, 5, 2), (3, 5)),
    ({"azimuth": 30, "elevation": 0}, (1, 0, 0), (-0.5, 0)),
    ({"azimuth": 0, "elevation": 30}, (1, 0, 1), (0, math.sqrt(3) / 2 - 0.5)),
])  # fmt: skip
def test_a_place_is_seen_where_it_should_be(view, place, page):
    s = sketch(**view)
    s.line((0, 0, 0), place)
    assert vertices(s)[0] == pytest.approx(np.array([(0, 0), page]), abs=1e-12)


@pytest.mark.parametrize(
    "view",
    [space_view(a, h, up) for a in (-200, 35, 90) for h in (-60, 0, 20) for up in "xyz"]
    + [plane_view("zy")],
)
def test_right_up_and_eye_are_a_right_handed_triple_of_unit_vectors(view):
    R = np.array([view.right, view.up, view.eye])
    assert pytest.approx(np.eye(3), abs=1e-15) == R @ R.T
    assert np.linalg.det(R) == pytest.approx(1)


def test_the_vertical_axis_points_up_the_page_and_the_eye_looks_from_above():
    for up, n in zip("xyz", range(3), strict=True):
        view = space_view(35, 20, up)
        assert view.right[n] == 0
        assert view.eye[n] == pytest.approx(math.sin(math.radians(20)))


@pytest.mark.parametrize("azimuth", range(-180, 180, 15))
def test_the_outline_of_a_cylinder_is_convex_though_rims_are_above_each_other(azimuth):
    view = space_view(azimuth, 22, "z")
    rims = [circle((5.0, 2.25, z), (0.0, 0.0, 1.0), 1.1) for z in (3.0, 7.0)]
    seen = np.array([view.project(p) for p in convex_hull(view, rims[0] + rims[1])])
    a = np.roll(seen, -1, axis=0) - seen
    b = np.roll(a, -1, axis=0)
    assert np.all(a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0] > -1e-7)  # the grid of the hull
    assert np.hypot(*a.T).sum() < 2 * (2.2 + 4 + 2.2)  # it goes round once
