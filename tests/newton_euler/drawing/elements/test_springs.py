"""Springs and dampers."""

import numpy as np
import pytest

from tests.sketching import O, sketch, vertices


@pytest.mark.parametrize("azimuth", [0, 35, 80])
@pytest.mark.parametrize("reach", [1, 4])
def test_a_spring_goes_round_a_shaft_behind_it_and_in_front_of_it(azimuth, reach):
    """This holds however far the shaft extends beyond the spring."""
    s = sketch(azimuth=azimuth, elevation=20)
    s.shaft((0, -reach, 0), (0, 1, 0))
    s.spring((0, -0.9, 0), (0, 0.9, 0), radius=0.3, coils=5)
    s.finish()
    order = s.drawn.strokes
    (shaft,) = [n for n, stroke in enumerate(order) if "shaft" in stroke.styles]
    coils = [(n, x) for n, x in enumerate(order) if x.styles == ("spring",)]
    middles = [(n, np.array(x.points[len(x.points) // 2])) for n, x in coils]
    eye = np.array(s.view.eye) * (1, 0, 1)  # its part perpendicular to the shaft
    front = [n for n, P in middles if P @ eye > 0.1]
    behind = [n for n, P in middles if P @ eye < -0.1]
    assert len(front) == len(behind) == 5
    assert max(behind) < shaft < min(front)


def test_a_helix_has_its_radius_and_a_damper_one_size_on_the_page():
    s = sketch(plane="xy")
    s.spring(O, (4, 0, 0), radius=0.5, coils=6)
    _, y = np.array(sorted(map(tuple, np.concatenate(vertices(s))))).T  # from left to right
    assert (y.min(), y.max()) == pytest.approx((-0.5, 0.5))
    assert (np.diff(np.sign(y[np.abs(y) > 1e-9])) != 0).sum() == 2 * 6

    def width(length):
        s = sketch(plane="xy")
        s.damper(O, (length, 0, 0))
        xs, ys = np.concatenate(vertices(s)).T
        assert (xs.min(), xs.max()) == pytest.approx((0, length))
        return np.ptp(ys) / s.drawn.pt

    assert width(1) == pytest.approx(width(1000)) == pytest.approx(14)
