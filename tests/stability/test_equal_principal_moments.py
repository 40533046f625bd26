"""Principal axes where moments are equal: a change in the last digit turns them, and any axes will
do (7.18)-(7.20).
"""

import math

import numpy as np
import pytest

from newton_euler import Frame, Inertia
from tests.kinds import close

body = Frame("body")
BASES = [[(1, 0, 0), (0, 1, 0)], [(1, 1, 1), (1, -1, 0)], [(0.36, 0.48, 0.8), (-0.8, 0.6, 0)]]


def turned(moments, first, second):
    """Principal moments about axes along first, second and their cross product."""
    e = [np.array(first) / np.linalg.norm(first), np.array(second) / np.linalg.norm(second)]
    e.append(np.cross(*e))
    M = sum(m * np.outer(a, a) for m, a in zip(moments, e, strict=True))
    return Inertia(body, (M[0, 0], M[1, 1], M[2, 2]), (-M[0, 1], -M[1, 2], -M[2, 0]))


def test_a_change_of_one_round_off_turns_the_axes_of_a_general_routine_by_more_than_20_degrees():
    I = turned((2.0, 2.0, 3.0), *BASES[1]).to_array()
    before, turns = np.linalg.eigh(I)[1], []
    for n, m in ((0, 0), (1, 1), (2, 2), (1, 0), (2, 0), (2, 1)):
        changed = I.copy()
        changed[n, m] = changed[m, n] = I[n, m] * (1 + 4e-16)
        turns.append(abs(np.linalg.eigh(changed)[1][:, 0] @ before[:, 0]))
    assert min(turns) < math.cos(math.radians(20))


@pytest.mark.parametrize("basis", BASES)
@pytest.mark.parametrize("moments", [(2.0, 2.0, 3.0), (2.0, 3.0, 3.0), (2.0, 2.0, 2.0)])
def test_with_equal_moments_the_axes_do_not_move_by_more_than_1e_minus_14_rad_when_the_last_digits_do(
    moments, basis
):
    I = turned(moments, *basis)
    axes = [a.components() for a in I.principal().axes]
    for n in range(6):
        entries = [*I.moments, *I.products]
        entries[n] *= 1 + 4e-16
        again = Inertia(body, entries[:3], entries[3:]).principal()
        assert close([a.components() for a in again.axes], axes, 1e-14)
