"""quadrature.py without SciPy: integrals of floats by the engine alone, and their errors."""

import math
import sys

import pytest

from newton_euler.algebra import WorkError
from newton_euler.algebra.quadrature import quadrature

# f, start, end, the integral in closed form, breaks
KNOWN = {
    "a polynomial": (lambda x: 3 * x**2 - 1, -1.0, 2.0, 6.0, ()),
    "backwards": (math.cos, 1.0, 0.0, -math.sin(1.0), ()),
    "nothing": (lambda x: 0.0, 0.0, 5.0, 0.0, ()),
    "no way": (math.exp, 2.0, 2.0, 0.0, ()),
    "cancels": (math.sin, -3.0, 3.0, 0.0, ()),
    "a narrow peak": (lambda x: 1e-3 / (x * x + 1e-6), -1.0, 1.0, 2 * math.atan(1e3), ()),
    "many turns": (lambda x: math.cos(200 * x), 0.0, 1.0, math.sin(200.0) / 200, ()),
    "a corner": (lambda x: abs(x - 0.3), 0.0, 1.0, 0.29, ()),
    "a jump": (lambda x: 1.0 if x > 0.3 else -2.0, 0.0, 1.0, 0.1, ()),
    "a jump at its stated place": (lambda x: 1.0 if x > 0.3 else -2.0, 0.0, 1.0, 0.1, (0.3,)),
    "a root at its start": (math.sqrt, 0.0, 4.0, 16 / 3, ()),
    "infinite at its start": (lambda x: x**-0.5, 0.0, 4.0, 4.0, ()),
    "a logarithm": (math.log, 0.0, 1.0, -1.0, ()),
    "huge": (lambda x: 1e200 * x, 0.0, 1e50, 5e299, ()),
    "tiny": (lambda x: 1e-200 * math.exp(x), 0.0, 1.0, 1e-200 * (math.e - 1), ()),
    "far away": (lambda x: (x - 1e4) ** 3, 1e4, 1e4 + 2, 4.0, ()),
}
NOT = {
    "grows without bound": (lambda x: 1 / x, 0.0, 1.0),
    "jumps everywhere": (lambda x: hash(x) % 1000 / 1000, 0.0, 1.0),
    "has no value": (lambda x: math.inf if x > 0.5 else 1.0, 0.0, 1.0),
}


@pytest.fixture(autouse=True)
def _no_scipy(monkeypatch):
    monkeypatch.setitem(sys.modules, "scipy.integrate", None)


@pytest.mark.parametrize("case", KNOWN)
@pytest.mark.parametrize("rtol", [1e-6, 1e-10])
def test_the_error_is_smaller_than_estimated_and_than_asked_for(case, rtol):
    f, start, end, exact, breaks = KNOWN[case]
    value, error = quadrature(f, start, end, rtol, breaks=breaks)
    size = max(abs(f(start + (end - start) * (n + 0.5) / 64)) for n in range(64)) * abs(end - start)
    assert abs(value - exact) <= error or value == pytest.approx(exact, rel=1e-15)
    assert error <= 2 * rtol * size


@pytest.mark.parametrize("case", NOT)
def test_what_does_not_converge_is_refused(case):
    f, *limits = NOT[case]
    with pytest.raises(WorkError, match=r"did not converge to 1e-10|the integrand is inf"):
        quadrature(f, *limits)


def test_an_accuracy_beyond_round_off_is_refused():
    with pytest.raises(WorkError, match=r"did not converge to 1e-17: \d+ intervals leave an error"):
        quadrature(math.exp, 0.0, 1.0, rtol=1e-17)
