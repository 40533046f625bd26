"""The closed form of the free body next to the separatrix, where k^2 is 1 within rounding (8.14)."""

import math

import mpmath
import numpy as np
import pytest
import sympy
from scipy import special

from newton_euler.motion.model import ModelError
from newton_euler.scenes.closed_forms.elliptic import jacobi
from newton_euler.scenes.spatial.free_body import free_body
from tests.kinds import close

BODY = free_body(1.0, 2.0, 3.0)


def test_at_a_tilt_of_1e_minus_7_scipys_jacobi_functions_are_nonsense():
    with np.errstate(all="ignore"):
        assert abs(special.ellipj(60.0, 1 - 1e-14)[1]) > 1e11  # a function that stays within 1
    sn, cn, dn, _ = jacobi(60.0, 1e-14)
    assert abs(sn**2 + cn**2 - 1) < 1e-15
    # one half-period earlier it still works, to 2 digits
    assert abs(dn - special.ellipj(60.0 - 2 * special.ellipkm1(1e-14), 1 - 1e-14)[2]) < 1e-2


@pytest.mark.parametrize("tilt", [0.1, 1e-2, 1e-4, 1e-7, 1e-12, 1e-100])
@pytest.mark.parametrize("t", [5.0, 50.0])
def test_the_engines_closed_form_is_right_to_1e_minus_14_at_every_tilt(tilt, t):
    start = (tilt, 1.0, tilt)
    assert close(BODY.solution(t, start), BODY.solution(mpmath.mpf(t), start), 2e-14)  # rad/s


@pytest.mark.parametrize("tilt", [0.1, 1e-4, 1e-7, 1e-12])
def test_it_agrees_with_the_printed_form_in_80_digits_after_several_turnovers(tilt):
    with mpmath.workdps(80):  # mpmath's own elliptic functions, of a k^2 that 80 digits hold
        x, y, z = mpmath.mpf(tilt), 1, mpmath.mpf(tilt)
        twice, square = x * x + 2 * y * y + 3 * z * z, x * x + 4 * y * y + 9 * z * z
        k2, rate = (3 * twice - square) / (square - twice), mpmath.sqrt((square - twice) / 6)
        c = mpmath.sqrt((3 * twice - square) / 2)
        u = mpmath.ellipf(mpmath.atan2(y, x), k2) + rate * 150
        sn, cn, dn = (mpmath.ellipfun(kind, u, m=k2) for kind in ("sn", "cn", "dn"))
        exact = c * cn, c * sn, rate * dn
    assert close(BODY.solution(150.0, (tilt, 1.0, tilt)), exact, 6e-14)  # rad/s


@pytest.mark.parametrize("start", [
    (1e-3, 1.0, 1e-3), (0.01, 1.0, 0.01), (0.5, 0.2, 0.1), (0.1, -0.2, -0.5),
    (math.sqrt(3) * 0.1, 1.0, 0.1),
])  # fmt: skip
def test_the_30_digit_closed_form_agrees_with_30_digit_integration_by_taylor_series(start):
    rates = lambda t, y: list(BODY.derivative(y, t))
    y = mpmath.odefun(rates, 0, [mpmath.mpf(x) for x in start], tol=mpmath.mpf("1e-20"))(2)
    assert close(tuple(y), BODY.solution(mpmath.mpf(2), start), 1e-18)


def test_on_the_separatrix_itself_the_motion_is_that_of_hyperbolic_functions():
    # I_z (I_z - I_y) w_z^2 = I_x (I_y - I_x) w_x^2: w_x = 2 w_z
    body, start = free_body(1.0, 2.5, 4.0), (0.2, 0.0, 0.1)
    x, y, _ = body.solution(400.0, start)
    assert abs(x) < 1e-15
    assert abs(y) == pytest.approx(math.sqrt(0.1**2 * 4 * 3 / (2.5 * 1.5)), rel=1e-15)
    decayed = 0.2 / math.cosh(math.sqrt(1.5 * 1.5 / 4) * abs(y))
    assert body.solution(1.0, start)[0] == pytest.approx(decayed, rel=1e-14)


@pytest.mark.parametrize("m1", [1.0, 0.5, 1e-3, 1e-10, 1e-30, 1e-200])
def test_jacobis_functions_from_the_complementary_parameter_are_right_to_round_offs_of_the_argument(
    m1,
):
    for u in (-3.0, 0.0, 0.1, 1.0, 7.3, 33.3):
        with mpmath.workdps(300):
            exact = [mpmath.ellipfun(kind, u, m=1 - mpmath.mpf(m1)) for kind in ("sn", "cn", "dn")]
        assert close(jacobi(u, m1)[:3], tuple(exact), 4e-16 * max(1.0, abs(u)))


def test_arrays_of_starts_on_both_sides_at_once():
    starts = [(0.1, 1.0, 0.1), (0.5, 0.2, 0.1), (1e-7, 1.0, 1e-7), (0.0, 1.0, 0.0), (1.0, 0.0, 0.0)]
    together = BODY.solution(30.0, tuple(map(np.array, zip(*starts, strict=True))))
    for n, start in enumerate(starts):
        assert close([x[n] for x in together], BODY.solution(30.0, start), 1e-15)


@pytest.mark.parametrize(("body", "t", "x", "words"), [
    (BODY, sympy.Symbol("t"), 0.1, "needs numbers"),
    (free_body(0.0, 2.0, 2.0), 1.0, 0.1, "three positive numbers"),
    (BODY, 1.0, math.nan, "must be finite"),
])  # fmt: skip
def test_what_is_not_a_motion_of_a_body_is_refused_in_words(body, t, x, words):
    with pytest.raises(ModelError, match=words):
        body.solution(t, (x, 1.0, 0.1))
