"""tangents.py: a cable is tangent to its pulleys, goes round them the right way, and has the length
that geometry gives.
"""

import math
from itertools import pairwise

import numpy as np
import pytest

from newton_euler.algebra import FrameError
from newton_euler.drawing.elements.cables import Pulley, route
from tests.sketching import ground, sketch, vertices

Z = (0.0, 0.0, 1.0)


def length(lines):
    return sum(math.dist(p, q) for line in lines for p, q in pairwise(line))


def total(stops, turns=None):
    spans, arcs = route(stops, turns)
    return length(spans) + length(arcs)


def test_a_rope_over_a_pulley_hangs_on_both_sides_the_shortest_way_or_as_a_belt():
    """Chords of 6 degrees are shorter than their arc by less than 1 in 2000."""
    wheel = Pulley((0.0, 0.0, 0.0), Z, 1.0)
    spans, arcs = route([(-1.0, -5.0, 0.0), wheel, (1.0, -3.0, 0.0)])
    assert spans[0][1] == pytest.approx((-1, 0, 0), abs=1e-12)
    assert spans[1][0] == pytest.approx((1, 0, 0), abs=1e-12)
    assert length(arcs) == pytest.approx(math.pi, rel=5e-4)
    assert max(P[1] for P in arcs[1]) == pytest.approx(1, abs=2e-3)
    round_both = Pulley((0.0, 0.0, 0.0), Z, 1.0), Pulley((5.0, 1.0, 0.0), Z, 2.0)
    stops = [(-3.0, 2.0, 0.0), *round_both, (9.0, 0.0, 0.0)]
    assert total(stops) == pytest.approx(
        min(total(stops, (a, b)) for a in (1, -1) for b in (1, -1))
    )
    # crossed, its length is 2 sqrt(d^2 - 4r^2) + 2r(pi + 2 asin(2r/d))
    p, q = Pulley((0.0, 0.0, 0.0), Z, 1.0), Pulley((5.0, 0.0, 0.0), Z, 1.0)
    assert total([p, q, p]) == pytest.approx(10 + 2 * math.pi, rel=5e-4)
    assert total([p, q, p], (1, -1)) == pytest.approx(
        2 * math.sqrt(21) + 2 * (math.pi + 2 * math.asin(0.4)), rel=5e-4
    )


@pytest.mark.parametrize(("turns", "span"), [((1, 1), 5 * 0.96**0.5), ((1, -1), (25 - 9) ** 0.5)])
def test_a_span_between_two_pulleys_is_an_outer_or_an_inner_tangent(turns, span):
    """Centres 5 apart, radii 1 and 2: sqrt(d^2 - (R - r)^2) and sqrt(d^2 - (R + r)^2)."""
    spans, _ = route([Pulley((0.0, 0.0, 0.0), Z, 1.0), Pulley((5.0, 0.0, 0.0), Z, 2.0)], turns)
    assert length(spans) == pytest.approx(span, rel=1e-12)


@pytest.mark.parametrize("turns", [(1, 1), (1, -1), (-1, 1), (-1, -1)])
def test_spans_are_square_to_the_radius_and_run_the_way_the_pulley_turns(turns):
    wheels = [Pulley((0.0, 0.0, 0.0), Z, 1.0), Pulley((5.0, 1.0, 0.0), Z, 2.0)]
    spans, arcs = route([(-3.0, 2.0, 0.0), *wheels, (9.0, 0.0, 0.0)], turns)
    for wheel, turn, arriving, leaving, arc in zip(
        wheels, turns, spans, spans[1:], arcs[1:], strict=False
    ):
        for (A, B), T in ((arriving, arriving[1]), (leaving, leaving[0])):
            along, radius = np.subtract(B, A), np.subtract(T, wheel.centre)
            assert np.linalg.norm(radius) == pytest.approx(wheel.radius)
            assert along @ radius == pytest.approx(0, abs=1e-9)
            assert turn * np.cross(wheel.normal, radius) @ along > 0
        assert arc[0] == pytest.approx(arriving[1])
        assert arc[-1] == pytest.approx(leaving[0])


def test_a_straight_cable_that_just_touches_has_no_arc_and_no_whole_turn():
    spans, arcs = route([(-3.0, 1.0, 0.0), Pulley((0.0, 0.0, 0.0), Z, 1.0), (4.0, 1.0, 0.0)])
    assert length(spans) == pytest.approx(7)
    assert length(arcs) < 1e-6


def test_pulleys_in_two_planes_are_each_left_in_its_own_tangent():
    p, q = Pulley((0.0, 0.0, 0.0), Z, 1.0), Pulley((4.0, 0.0, 3.0), (0.0, 1.0, 0.0), 0.5)
    ((A, B),), _ = route([p, q])
    for wheel, T in ((p, A), (q, B)):
        radius = np.subtract(T, wheel.centre)
        assert np.linalg.norm(radius) == pytest.approx(wheel.radius)
        assert np.subtract(B, A) @ radius == pytest.approx(0, abs=1e-9)


def test_a_cable_does_not_begin_inside_a_pulley_and_pulleys_do_not_overlap_for_a_crossed_belt():
    wheel = Pulley((0.0, 0.0, 0.0), Z, 1.0)
    with pytest.raises(FrameError, match="is within the radius 1"):
        route([(0.5, 0.0, 0.0), wheel])
    with pytest.raises(FrameError, match="is within the radius"):
        route([wheel, Pulley((0.1, 0.0, 0.0), Z, 1.0)], (1, -1))


def test_the_flanges_are_a_tenth_larger_than_the_groove_and_the_cable_touches_the_groove():
    s = sketch(plane="xy")
    s.cable((-1, -5, 0), s.pulley((0, 0, 0), ground.k, 1), (1, -5, 0))
    widths = sorted({round(float(np.ptp(v[:, 0])), 2) for v in vertices(s)})
    assert widths[-1] == pytest.approx(2.2, abs=0.02)
    straight = [v for v in vertices(s) if len(v) == 2]
    assert {round(float(v[0][0]), 9) for v in straight} == {-1, 1}


@pytest.mark.parametrize("elevation", [60, -60])
def test_the_cable_lies_between_the_flanges(elevation):
    """Seen from either side it is drawn after the far flange and before the near one."""
    s = sketch(azimuth=-90, elevation=elevation)
    s.cable((-1, -5, 0), s.pulley((0, 0, 0), ground.k, 1), (1, -5, 0))
    drawn = vertices(s)
    flanges = [n for n, v in enumerate(drawn) if len(v) == 61 and np.ptp(v[:, 0]) > 2.15]
    touching = [n for n, v in enumerate(drawn) if len(v) == 2 and np.abs(v[:, 1]).min() < 1e-9]
    assert len(flanges) == len(touching) == 2
    assert flanges[0] < min(touching)
    assert max(touching) < flanges[1]
