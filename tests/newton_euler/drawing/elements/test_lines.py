"""Circles and curves."""

import math

import numpy as np
import pytest

from tests.sketching import O, ground, sketch, vertices


def test_around_goes_right_handed_and_once_round_repeats_no_place():
    arm = ground.rotate("arm", "z", angle=0.3)
    places = np.array(sketch().around((1, 1, 1), arm.point("A", 3, 1, 1), -ground.k, math.pi / 2))
    centred = places - (1, 1, 1)
    start = arm.point("A", 3, 1, 1).position(ground)
    assert places[0] == pytest.approx([start.x, start.y, start.z])
    assert np.hypot(*centred[:, :2].T) == pytest.approx(np.hypot(*centred[0, :2]))
    assert centred[:, 2] == pytest.approx(0)
    turned = np.unwrap(np.arctan2(centred[:, 1], centred[:, 0]))
    assert turned[-1] - turned[0] == pytest.approx(-math.pi / 2)
    places = sketch().around(O, (1, 0, 0), ground.k)
    assert len(set(places)) == len(places) == 60
    assert places[0] == pytest.approx((1, 0, 0))
    assert math.dist(places[-1], places[0]) == pytest.approx(math.dist(places[1], places[0]))


def test_a_wire_runs_through_all_its_places_and_a_dashed_curve_is_one_line():
    s = sketch(plane="xy")
    s.wire(s.around(O, (2, 0, 0), ground.k, math.pi))
    along = np.concatenate(vertices(s))
    assert np.hypot(*along.T) == pytest.approx(2)
    assert along[:, 0].min() == pytest.approx(-2)
    assert along[:, 1].min() == pytest.approx(0, abs=1e-12)
    s = sketch(plane="xy")
    s.path([(x, x * x, 0) for x in range(20)], style="dashed")
    assert [len(v) for v in vertices(s)] == [20]


@pytest.mark.parametrize("elevation", [-30, 0, 15, 40])
def test_only_the_near_side_of_a_helix_on_a_cylinder_is_drawn(elevation):
    s = sketch(azimuth=20, elevation=elevation)
    turns = [math.radians(6 * n) for n in range(181)]
    s.cylinder((0, 0, 0), (0, 0, 3), 1)
    s.path([(math.cos(w), math.sin(w), w / 6) for w in turns], on=(O, (0, 0, 1)))
    s.finish()
    runs = [stroke for stroke in s.drawn.strokes if stroke.styles == ("path",)]
    assert sum(len(run.points) for run in runs) == pytest.approx(90, abs=2)
    near = np.cos(np.radians(20)), np.sin(np.radians(20))
    for run in runs:
        assert (np.array(run.points)[:, :2] @ near > -1e-9).all()
        assert s.drawn.strokes.index(run) > 1  # drawn over the cylinder and its end


def test_only_the_near_side_of_a_curve_on_a_sphere_is_drawn():
    s = sketch(azimuth=0, elevation=0)
    s.sphere(O, 1)
    s.path([(math.cos(n / 10), math.sin(n / 10), 0) for n in range(63)], on=O)
    s.finish()
    runs = [stroke for stroke in s.drawn.strokes if stroke.styles == ("path",)]
    assert all(P[0] >= 0 for run in runs for P in run.points)
    assert sum(len(run.points) for run in runs) == pytest.approx(31, abs=2)
