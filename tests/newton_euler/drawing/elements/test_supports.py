"""Ground of any profile."""

from itertools import pairwise

import numpy as np
import pytest

from tests.sketching import O, sketch, vertices


@pytest.mark.parametrize("way", [
    [(0, 0, 0), (3, 1, 0)],
    [(3, 1, 0), (0, 0, 0)],
    [(0, 0, 0), (1, 0.5, 0), (2, 0.4, 0), (3, 1, 0)],
])  # fmt: skip
def test_a_road_is_hatched_on_the_right_of_the_way(way):
    s = sketch(plane="xy")
    s.road(way)
    line, *hatches = vertices(s)
    assert len(line) == len(way)
    assert len(hatches) > 20
    for foot, end in hatches:
        reached = lambda a, b, x=foot[0]: min(a[0], b[0]) - 1e-9 <= x <= max(a[0], b[0]) + 1e-9
        a, b = next(pair for pair in pairwise(way) if reached(*pair))
        along, out = np.subtract(b, a)[:2], end - foot
        assert along[0] * out[1] - along[1] * out[0] < 0


def test_hatching_follows_a_slope():
    """The hatching meets the ground at the same angle as on level ground."""

    def angle(rise):
        s = sketch(plane="xy")
        s.road([O, (1, rise, 0)])
        line, hatch = vertices(s)[:2]
        a, b = line[1] - line[0], hatch[1] - hatch[0]
        return np.arctan2(a[0] * b[1] - a[1] * b[0], a @ b)

    assert angle(-0.6) == pytest.approx(angle(0))
