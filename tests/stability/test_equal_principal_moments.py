"""Principal axes where moments are equal: a change in the last digit turns them, and any axes will
do (7.18)-(7.20).
"""

import math

import mpmath
import numpy as np
import pytest

from newton_euler import Frame, Inertia
from newton_euler.kinematics.rotations import determinant
from tests.kinds import close

body = Frame("body")
BASES = [[(1, 0, 0), (0, 1, 0)], [(1, 1, 1), (1, -1, 0)], [(0.36, 0.48, 0.8), (-0.8, 0.6, 0)]]


def turned(moments, first, second):
    """The Inertia with these principal moments about axes along first, second and their cross
    product.
    """
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
        after = np.linalg.eigh(changed)[1]
        assert np.linalg.norm(np.cross(after[:, 2], before[:, 2])) < 1e-15  # the third axis stays,
        turns.append(math.degrees(math.acos(min(1.0, abs(after[:, 0] @ before[:, 0])))))
    assert max(turns) > 20  # the others do not


def test_the_general_routines_return_left_handed_axes_in_some_cases_and_the_engine_in_none():
    left = 0
    for moments in ((1.0, 2.0, 2.5), (2.0, 2.0, 3.0), (2.0, 3.0, 3.0), (2.0, 2.0, 2.0)):
        for basis in BASES:
            I = turned(moments, *basis)
            left += np.linalg.det(np.linalg.eigh(I.to_array())[1]) < 0
            assert close(determinant(I.principal().rotation), 1, 1e-14)
    assert left > 3


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


@pytest.mark.parametrize("basis", BASES)
def test_the_axes_chosen_diagonalise_to_1e_minus_15_of_the_largest_moment(basis):
    I = turned((2.0, 2.0, 3.0), *basis)
    p = I.principal()
    M, R = mpmath.matrix(I.matrix), mpmath.matrix(p.rotation)
    D = R.T * M * R
    assert (
        max(abs(D[n, m] - (p.moments[n] if n == m else 0)) for n in range(3) for m in range(3))
        < 3 * 2e-15
    )


def test_the_report_says_in_words_which_axes_are_not_determined():
    p = turned((2.0, 2.0, 3.0), *BASES[1]).principal()
    assert p.determined == (False, False, True)
    assert "axes 1 and 2 are not determined" in str(p)
    assert "any two axes in it will do" in str(p)
    assert "any axis is a principal axis" in str(turned((2.0, 2.0, 2.0), *BASES[1]).principal())


def test_just_beside_equality_the_axes_are_determined_and_right():
    true = [np.array(v) / np.linalg.norm(v) for v in BASES[1]]
    p = turned((2.0, 2.0 + 1e-6, 3.0), *BASES[1]).principal()
    assert p.determined == (True, True, True)
    assert abs(abs(np.dot(p.axes[0].components(), true[0])) - 1) < 1e-15
    # rad: round-off over the relative gap 5e-7
    assert np.linalg.norm(np.cross(p.axes[0].components(), true[0])) < 1e-8
