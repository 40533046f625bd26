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


def by_scipy(start, t):
    """Landau and Lifshitz (37.10) as written, with scipy's Jacobi functions of k^2, for I = 1, 2, 3
    and H^2 > 2 T I_y.
    """
    x, y, z = start
    twice, square = x * x + 2 * y * y + 3 * z * z, x * x + 4 * y * y + 9 * z * z
    k2 = (3 * twice - square) / (square - twice)
    rate = math.sqrt((square - twice) / 6)
    b = math.sqrt((3 * twice - square) / 2)
    u0 = special.ellipkinc(math.atan2(y / b, x / b), k2)
    sn, cn, dn, _ = special.ellipj(u0 - rate * t if x * z > 0 and y < 0 else u0 + rate * t, k2)
    return b * cn, b * sn, rate * dn


def error(found, start, t):
    exact = BODY.solution(mpmath.mpf(t), start)
    return max(
        min(abs(float(a) - float(b)), abs(abs(float(a)) - abs(float(b))))
        for a, b in zip(found, exact, strict=True)
    )


@pytest.mark.parametrize(("tilt", "more"), [(1e-4, 1e-9), (1e-6, 1e-5)])
def test_the_printed_form_with_scipy_loses_digits_towards_the_separatrix(tilt, more):
    assert error(by_scipy((tilt, 1.0, tilt), 20.0), (tilt, 1.0, tilt), 20.0) > more


def test_at_a_tilt_of_1e_minus_7_scipys_jacobi_functions_are_nonsense():
    with np.errstate(all="ignore"):
        cn = special.ellipj(60.0, 1 - 1e-14)[1]
    assert abs(cn) > 1e11  # of a function that stays within 1
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
        x, y, z, t = mpmath.mpf(tilt), mpmath.mpf(1), mpmath.mpf(tilt), mpmath.mpf(150)
        twice, square = x * x + 2 * y * y + 3 * z * z, x * x + 4 * y * y + 9 * z * z
        k2, rate = (3 * twice - square) / (square - twice), mpmath.sqrt((square - twice) / 6)
        c = mpmath.sqrt((3 * twice - square) / 2)
        u = mpmath.ellipf(mpmath.atan2(y, x), k2) + rate * t
        sizes = zip((c, c, rate), ("cn", "sn", "dn"), strict=True)
        exact = tuple(size * mpmath.ellipfun(kind, u, m=k2) for size, kind in sizes)
    assert close(BODY.solution(150.0, (tilt, 1.0, tilt)), exact, 6e-14)  # rad/s


@pytest.mark.parametrize("start", [
    (1e-3, 1.0, 1e-3), (0.01, 1.0, 0.01), (0.5, 0.2, 0.1), (0.1, -0.2, -0.5),
    (math.sqrt(3) * 0.1, 1.0, 0.1),
])  # fmt: skip
def test_the_30_digit_closed_form_agrees_with_30_digit_integration_by_taylor_series(start):
    rates = lambda t, y: list(BODY.derivative(y, t))
    y = mpmath.odefun(rates, 0, [mpmath.mpf(x) for x in start], tol=mpmath.mpf("1e-20"))(2)
    assert close(tuple(y), BODY.solution(mpmath.mpf(2), start), 1e-18)


@pytest.mark.parametrize("off", [0.0, 1e-16, -1e-16, 1e-14, -1e-14, 1e-8, -1e-8])
def test_on_the_separatrix_within_rounding_the_digits_that_decide_are_taken_from_the_data_themselves(
    off,
):
    """w_x = sqrt(3) w_z: one side circles z, the other x; the difference of the two squares has no
    digits left in floats.
    """
    start = (math.sqrt(3) * 0.1 * (1 + off), 1.0, 0.1)
    assert close(BODY.solution(40.0, start), BODY.solution(mpmath.mpf(40), start), 2e-14)


def test_on_the_separatrix_itself_the_motion_is_that_of_hyperbolic_functions():
    # I_z (I_z - I_y) w_z^2 = I_x (I_y - I_x) w_x^2 for w_x/w_z = sqrt(15)
    body = free_body(1.0, 4.0, 9.0)
    start = (mpmath.mpf(0), mpmath.mpf(1), mpmath.mpf(0))
    assert body.solution(30.0, start) == (0.0, 1.0, 0.0)
    even = free_body(1.0, 2.5, 4.0)  # 4*1.5 = 6 and 1*1.5 = 1.5: w_x = 2 w_z exactly
    w = even.solution(400.0, (0.2, 0.0, 0.1))
    assert abs(w[0]) < 1e-15
    assert abs(w[1]) == pytest.approx(math.sqrt(0.1**2 * 4 * 3 / (2.5 * 1.5)), rel=1e-15)
    assert even.solution(1.0, (0.2, 0.0, 0.1))[0] == pytest.approx(
        0.2 / math.cosh(math.sqrt(1.5 * 1.5 / 4) * abs(w[1])), rel=1e-14
    )


@pytest.mark.parametrize("m1", [1.0, 0.5, 1e-3, 1e-10, 1e-30, 1e-200])
def test_jacobis_functions_from_the_complementary_parameter_are_right_to_round_offs_of_the_argument(
    m1,
):
    for u in (-3.0, 0.0, 0.1, 1.0, 7.3, 33.3):
        with mpmath.workdps(300):
            exact = [mpmath.ellipfun(kind, u, m=1 - mpmath.mpf(m1)) for kind in ("sn", "cn", "dn")]
        assert close(jacobi(u, m1)[:3], tuple(exact), 4e-16 * max(1.0, abs(u)))


def test_arrays_of_starts_on_both_sides_at_once_and_expressions_refused():
    starts = [(0.1, 1.0, 0.1), (0.5, 0.2, 0.1), (1e-7, 1.0, 1e-7), (0.0, 1.0, 0.0), (1.0, 0.0, 0.0)]
    together = BODY.solution(30.0, tuple(map(np.array, zip(*starts, strict=True))))
    for n, start in enumerate(starts):
        assert close([x[n] for x in together], BODY.solution(30.0, start), 1e-15)
    with pytest.raises(ModelError, match="needs numbers"):
        BODY.solution(sympy.Symbol("t"), (0.1, 1.0, 0.1))
    with pytest.raises(ModelError, match="three positive numbers"):
        free_body(0.0, 2.0, 2.0).solution(1.0, (0.1, 1.0, 0.1))
    with pytest.raises(ModelError, match="must be finite"):
        BODY.solution(1.0, (math.nan, 1.0, 0.1))
