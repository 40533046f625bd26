"""Composites of bodies that share their names: every part counts."""

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from newton_euler import Frame, composite, particle
from newton_euler.bodies.solids import disk
from tests.named_sums import NAMES, TRIPLES, by_any_names, check_terms, value

POINTS = st.lists(
    st.tuples(NAMES, st.integers(1, 20).map(lambda n: n / 4), TRIPLES), min_size=1, max_size=5
)


def matrix(m, r):
    """The inertia matrix of a mass point about the origin."""
    return m * (np.dot(r, r) * np.eye(3) - np.outer(r, r))


def particles(points, frame):
    return [particle(m, frame.point("P", *r), name) for name, m, r in points]


@by_any_names
@given(POINTS)
def test_the_inertia_of_a_composite_is_the_sum_of_its_parts(points):
    frame = Frame("body")
    whole = composite("whole", particles(points, frame))
    names = [name for name, _, _ in points]
    check_terms(whole.about(frame), [matrix(m, r) for _, m, r in points], names)
    assert whole.mass == sum(m for _, m, _ in points)


@by_any_names
@given(POINTS, POINTS, NAMES)
def test_composites_of_one_name_nest(first, second, name):
    frame = Frame("body")
    halves = [composite(name, particles(points, frame)) for points in (first, second)]
    parts = [sum(matrix(m, r) for _, m, r in points) for points in (first, second)]
    check_terms(composite(name, halves).about(frame), parts, [name, name])
    check_terms(composite(name, halves[::-1]).about(frame), parts[::-1], [name, name])


def test_two_holes_of_one_name_are_both_cut_out():
    sheet = Frame("sheet")
    holes = [disk(0.1, sheet.point("C", x, 0, 0), "z", density=10.0) for x in (-0.3, 0.3)]
    plate = disk(0.5, sheet, "z", density=10.0)
    rest = composite("plate", [plate], removed=holes)
    left = value(plate.inertia) - sum(value(hole.about(sheet)) for hole in holes)
    assert np.allclose(value(rest.about(sheet)), left, atol=1e-14)
    assert np.allclose(value(rest.about(sheet).without("disk")), 0)
