"""Default tolerances: rtol 1e-3 and atol 1e-6 are neither small for a motion near a turning point
nor relative for a small one.
"""

import math

import numpy as np
import pytest

from newton_euler.motion.integration import integrate
from newton_euler.scenes.planar.pendulum import physical_pendulum
from tests.stability.naive import solved

G = 9.81
PENDULUM = physical_pendulum(1.0, 0.0, 1.0, G)  # of 1 kg on 1 m; theta from the lowest place


def test_a_pendulum_released_at_3_1_rad_gains_more_energy_than_it_has_and_turns_over_dozens_of_times():
    found = solved(PENDULUM, 100.0, (3.1, 0.0))
    energies = [PENDULUM.invariant("energy", s) for s in found.y.T.tolist()]
    assert found.success
    # J: as much as lifts it from the lowest place to the highest
    assert energies[-1] - energies[0] > 2 * G
    assert np.max(np.abs(found.y[0])) > 100  # rad


@pytest.mark.parametrize("method", ["auto", "dop853", "taylor"])
def test_the_engine_keeps_its_energy_to_1e_minus_9_and_swings_back_every_time(method):
    # the Runge-Kutta method refuses 1e-9: its round-off grows at every turn near the top
    rtol = 1e-8 if method == "dop853" else 1e-9
    motion = integrate(PENDULUM, 100.0, (3.1, 0.0), rtol, method)
    assert motion.error <= rtol
    assert motion.drift["energy"] < 1e-9
    assert np.max(np.abs(motion.states["theta"])) <= 3.1 * (1 + 1e-12)


@pytest.mark.parametrize("beside", [1e-2, 1e-4, 1e-6])
def test_beside_the_highest_place_it_turns_back_from_one_side_and_over_from_the_other(beside):
    """With a hair less than the energy that takes it to the top, and a hair more."""
    back, over = (
        integrate(PENDULUM, 30.0, (math.pi - beside, rate), samples=2001).states["theta"].max()
        for rate in (0.0, 2 * beside * math.sqrt(G))
    )
    assert back < math.pi
    assert over > 2 * math.pi
