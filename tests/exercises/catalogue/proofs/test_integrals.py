"""Integrals in proofs agree with closed forms to thirty digits, or are refused."""

import pytest
from mpmath import mp, mpf

from exercises.catalogue.proofs import ProofError, integral


@pytest.mark.parametrize(("f", "start", "end", "expected"), [
    (lambda x: x**7, 0, 2, lambda: mpf(32)),
    (mp.sin, 0, lambda: mp.pi, lambda: mpf(2)),
    (mp.sqrt, 0, 1, lambda: mpf(2) / 3),
    (lambda x: mp.sqrt(1 - x * x), -1, 1, lambda: mp.pi / 2),
    (lambda x: 1 / mp.sqrt(x), 0, 4, lambda: mpf(4)),
    (lambda x: 1 / mp.sqrt(1 - x), 0, 1, lambda: mpf(2)),
    (mp.log, 0, 1, lambda: mpf(-1)),
    (lambda x: mp.exp(-x), 3, 1, lambda: mp.exp(-3) - mp.exp(-1)),
    (mp.sin, -1, 1, lambda: mpf(0)),
    (lambda x: 0 * x, 0, 1, lambda: mpf(0)),
    (lambda x: 1 / (1 + 100 * x * x), -1, 1, lambda: mp.atan(10) / 5),
])  # fmt: skip
def test_an_integral_has_thirty_digits(f, start, end, expected):
    end = end() if callable(end) else end
    assert abs(integral(f, start, end) - expected()) < mpf(10) ** -30


def test_vectors_and_matrices_are_integrated_entry_by_entry():
    (a, b), (c, d) = integral(lambda t: [[t, 1], [t * t, 0]], 0, 3)
    assert max(abs(a - mpf(9) / 2), abs(b - 3), abs(c - 9), abs(d)) < mpf(10) ** -45


def test_a_corner_that_is_not_named_and_an_integral_that_does_not_exist_are_refused():
    with pytest.raises(ProofError, match=r"does not converge.*breaks"):
        integral(abs, -1, mpf("2.1"))
    assert abs(integral(abs, -1, 2, breaks=(0,)) - mpf(5) / 2) < mpf(10) ** -45
    with pytest.raises(ProofError, match="does not converge"):
        integral(lambda x: 1 / x, 0, 1)
