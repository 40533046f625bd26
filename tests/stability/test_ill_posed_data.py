"""Data that contradict each other, leave something open, or fit no body are refused in words, where
NumPy returns numbers (7.13), (8.21).
"""

import mpmath
import numpy as np
import pytest

from newton_euler import Frame, Inertia, solve_linear
from newton_euler.algebra.linear import LinearError
from newton_euler.bodies import MassError
from newton_euler.dynamics.euler import angular_acceleration

body = Frame("body")


def test_a_nearly_singular_solve_returns_1e16_and_the_engine_reports_what_is_open():
    M = np.array([[0.1, 0.3], [0.3, 0.9]])  # of rank 1, except for the rounding of 0.1 and 0.3
    assert abs(np.linalg.solve(M, [0.4, 1.2000001])).max() > 1e8
    s = solve_linear(
        lambda A, B: {"one": 0.1 * A + 0.3 * B - 0.4, "three": 0.3 * A + 0.9 * B - 1.2}
    )
    assert s.undetermined == ("A", "B")
    assert "follows from 'one'" in s.report()
    with pytest.raises(LinearError, match="is not determined"):
        _ = s.A


@pytest.mark.parametrize("gap", [1e-3, 1e-6, 1e-9])
def test_a_mass_matrix_near_singular_is_solved_to_round_off_over_the_gap(gap):
    laws = lambda a, b: {"one": a + b - 2.0, "two": a + (1 + gap) * b - (2.0 + gap)}
    s = solve_linear(laws)
    with mpmath.workdps(40):  # the data as the floats hold them
        exact = (mpmath.mpf(2.0 + gap) - 2) / (mpmath.mpf(1 + gap) - 1)
    assert abs(s.b - exact) < 1e-15 / gap


def test_a_mass_matrix_singular_within_rounding_is_left_open_not_solved():
    s = solve_linear(lambda a, b: {"one": a + b - 2.0, "two": a + (1 + 1e-15) * b - 2.0})
    assert s.undetermined == ("a", "b")


def test_a_thin_rod_has_no_inverse_inertia_and_is_refused_where_numpy_raises_without_a_reason():
    at_rest, rod = body.vector(0.0, 0, 0), Inertia(body, (0.0, 3.0, 3.0))
    with pytest.raises(np.linalg.LinAlgError, match="Singular matrix"):
        np.linalg.solve(rod.to_array(), [1.0, 0.0, 0.0])
    with pytest.raises(MassError, match="thin rod about its own"):
        angular_acceleration(rod, at_rest, body.vector(1.0, 0, 0))
    thick = Inertia(body, (1e-12, 3.0, 3.0))
    found = angular_acceleration(thick, at_rest, body.vector(1e-12, 3.0, 0))
    assert found.components() == pytest.approx((1.0, 1.0, 0.0), abs=1e-15)
