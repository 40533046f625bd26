"""Differences of nearly equal numbers: the angle between nearly parallel vectors, distances between
near points, moments about a far point (A.11).
"""

import math

import mpmath
import numpy as np
import pytest

from newton_euler import Frame, Inertia
from newton_euler.algebra import FrameError

ground = Frame("ground")
A = (1.0, 2.0, 3.0)
ACROSS = (3.0, 0.0, -1.0)  # at right angles to A


def near(eps):
    return tuple(a + eps * c for a, c in zip(A, ACROSS, strict=True))


def exact(a, b):
    with mpmath.workdps(60):
        a, b = (tuple(map(mpmath.mpf, v)) for v in (a, b))
        cross = a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]
        return mpmath.atan2(
            mpmath.sqrt(sum(x * x for x in cross)), sum(x * y for x, y in zip(a, b, strict=True))
        )


@pytest.mark.parametrize("eps", [1e-3, 1e-6, 1e-9, 1e-12])
@pytest.mark.parametrize("sense", [1.0, -1.0])
def test_the_angle_by_arc_cosine_is_off_by_1e_minus_8_rad_and_angle_to_by_2e_minus_16(eps, sense):
    b = tuple(sense * x for x in near(eps))
    assert abs(ground.vector(*A).angle_to(ground.vector(*b)) - exact(A, b)) < 5e-16
    if eps <= 1e-9:
        cosine = np.dot(A, b) / (np.linalg.norm(A) * np.linalg.norm(b))
        assert abs(float(np.arccos(np.clip(cosine, -1, 1))) - float(exact(A, b))) > 0.4 * eps


def test_tiny_and_huge_vectors_have_angles_too():
    for size in (1e-70, 1e70):
        u, v = ground.vector(size, 0, 0), ground.vector(size, 1e-6 * size, 0)
        assert u.angle_to(v) == pytest.approx(math.atan(1e-6), rel=1e-14)


@pytest.mark.parametrize("x", [0.0, 0, np.array([1.0, 0.0])])
def test_the_angle_with_a_zero_vector_is_refused(x):
    v = ground.vector(x, 0, 0)
    with pytest.raises(FrameError, match="a zero vector makes no angle"):
        v.angle_to(v)


def test_moments_about_g_taken_back_from_a_point_1e7_lengths_away_are_right_to_what_is_left():
    body = Frame("body")
    G, beside = body.point("G", 1e7, 0, 0), body.point("H", 1e7 + 1e-6, 0, 0)
    about_G = Inertia(G, (1.0, 2.0, 2.5), mass=1.0, centre=G)
    # 1e14 holds 2 to two digits
    assert abs(about_G.about(body.origin).about(G).moments[1] - 2.0) < 0.02
    # from the difference of the points, so that nothing cancels
    assert abs(about_G.about(beside).moments[1] - (2.0 + 1e-12)) < 1e-15
