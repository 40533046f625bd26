"""The poles of spherical coordinates, where the azimuth and its rates do not exist (3.24)-(3.27)."""

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from newton_euler import Frame
from newton_euler.algebra.scalars import SingularError
from newton_euler.kinematics.coordinates import spherical, spherical_coordinates
from tests.kinds import close
from tests.stability.naive import TIGHT

ground = Frame("ground")


def straight_in_spherical_coordinates(eps):
    """A free particle that passes the pole of the unit sphere at the distance eps: how often r'' =
    0 in R, theta, phi is called.
    """

    def rates(t, y):
        R, _, phi, dR, dtheta, dphi = y.tolist()
        c, s = np.cos(phi), np.sin(phi)
        return [
            dR, dtheta, dphi,
            R * dphi**2 + R * dtheta**2 * c * c,
            -2 * dR * dtheta / R + 2 * dtheta * dphi * s / c,
            -2 * dR * dphi / R - dtheta**2 * s * c,
        ]  # fmt: skip

    r, v = ground.vector(-1.0, eps, 1.0), ground.vector(1.0, 0, 0)
    q = spherical_coordinates(r, v)
    start = [*(x.value for x in q), *(x.rate for x in q)]
    found = solve_ivp(rates, (0, 2), start, **TIGHT)
    end = spherical(ground, "P", *found.y[:3, -1]).position(ground)
    assert np.linalg.norm(np.array(end.components(ground)) - [1.0, eps, 1.0]) < 1e-9
    return found.nfev


def test_a_straight_line_past_the_pole_costs_four_times_the_steps():
    wide, near = straight_in_spherical_coordinates(1e-1), straight_in_spherical_coordinates(1e-6)
    assert near > 4 * wide  # theta' reaches 1/eps there


@pytest.mark.parametrize("eps", [1e-1, 1e-6, 0.0])
def test_in_rectangular_components_the_same_line_is_one_step_and_exact(eps):
    found = solve_ivp(lambda t, y: [1.0, 0.0, 0.0], (0, 2), [-1.0, eps, 1.0], **TIGHT)
    assert np.allclose(found.y[:, -1], [1.0, eps, 1.0], atol=1e-15, rtol=0)


def test_the_elevation_itself_is_too_coarse_a_number_to_hold_its_cosine():
    eps = 1e-9
    _, _, phi = spherical_coordinates(ground.vector(eps, 0, 1.0))
    # half of the digits of R cos(phi), the printed scale factor of theta
    assert abs(np.cos(phi) / eps - 1) > 1e-9
    azimuth = spherical_coordinates(ground.vector(eps, 0, 1.0), ground.vector(0, 1.0, 0))[1]
    assert abs(azimuth.rate * eps - 1) < 1e-15  # the engine takes it from the position


def test_at_the_pole_the_printed_rate_is_8e15_rad_per_s_and_the_engine_refuses_in_words_and_1e_minus_12_beside_it_answers():
    # rad/s: the printed v_theta/(R cos phi), of a cosine that is rounding noise
    assert 1.0 / (2.0 * np.cos(np.arctan2(2.0, 0.0))) > 8e15
    with pytest.raises(SingularError, match="at a pole"):
        spherical_coordinates(ground.vector(0.0, 0.0, 2.0), ground.vector(1.0, 0, 0))
    r, v, a = ground.vector(1e-12, 0, 2.0), ground.vector(3.0, 1.0, 0), ground.vector(0, 0, 1.0)
    P = spherical(ground, "P", *spherical_coordinates(r))
    assert close(P.position(ground), r, 1e-15)
    assert spherical_coordinates(r, v, a)[1].rate == pytest.approx(1e12, rel=1e-14)
