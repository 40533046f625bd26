"""The poles of spherical coordinates, where the azimuth and its rates do not exist (3.24)-(3.27)."""

import numpy as np
import pytest

from newton_euler import Frame
from newton_euler.algebra.scalars import SingularError
from newton_euler.kinematics.coordinates import spherical, spherical_coordinates
from tests.kinds import close

ground = Frame("ground")


def test_the_elevation_itself_is_too_coarse_a_number_to_hold_its_cosine():
    eps = 1e-9
    _, _, phi = spherical_coordinates(ground.vector(eps, 0, 1.0))
    # half of the digits of R cos(phi), the printed scale factor of theta
    assert abs(np.cos(phi) / eps - 1) > 1e-9
    azimuth = spherical_coordinates(ground.vector(eps, 0, 1.0), ground.vector(0, 1.0, 0))[1]
    assert abs(azimuth.rate * eps - 1) < 1e-15  # the engine takes it from the position


def test_at_the_pole_it_refuses_in_words_and_1e_minus_12_beside_it_answers():
    with pytest.raises(SingularError, match="at a pole"):
        spherical_coordinates(ground.vector(0.0, 0.0, 2.0), ground.vector(1.0, 0, 0))
    r, v, a = ground.vector(1e-12, 0, 2.0), ground.vector(3.0, 1.0, 0), ground.vector(0, 0, 1.0)
    P = spherical(ground, "P", *spherical_coordinates(r))
    assert close(P.position(ground), r, 1e-15)
    assert spherical_coordinates(r, v, a)[1].rate == pytest.approx(1e12, rel=1e-14)
