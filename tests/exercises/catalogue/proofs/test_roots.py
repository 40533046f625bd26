"""Roots in proofs: inside the bracket, to nearly fifty digits, or refused."""

import pytest
from mpmath import mp, mpf

from exercises.catalogue.proofs import ProofError, root


@pytest.mark.parametrize(("f", "low", "high", "expected"), [
    (lambda x: x * x - 2, 0, 5, lambda: mp.sqrt(2)),
    (lambda x: 2 - x * x, 5, 0, lambda: mp.sqrt(2)),
    (lambda x: (x - mpf("0.3")) ** 3, -1, 5, lambda: mpf("0.3")),
    (lambda x: x - mpf("1e-20"), -1, 1, lambda: mpf("1e-20")),
    (mp.tan, 3, 4, lambda: mp.pi),
    (lambda x: mp.exp(50 * x) - 2, -1, 1, lambda: mp.log(2) / 50),
    (lambda x: x, 0, 1, lambda: mpf(0)),
    (lambda x: x - 1, 0, 1, lambda: mpf(1)),
])  # fmt: skip
def test_a_root_has_nearly_fifty_digits(f, low, high, expected):
    assert abs(root(f, low, high) - expected()) <= mpf(10) ** -48


@pytest.mark.parametrize("f", [lambda x: x**9 - mpf("1e-30"), lambda x: mp.atan(1e6 * (x - 0.9))])
def test_a_hard_root_takes_few_values(f):
    places = []

    def counted(x):
        places.append(x)
        return f(x)

    x = root(counted, 0, 1)
    assert f(x - mpf("1e-40")) < 0 < f(x + mpf("1e-40"))
    assert len(places) < 200
    assert all(0 <= place <= 1 for place in places)


def test_a_bracket_without_a_change_of_sign_is_refused():
    with pytest.raises(ProofError, match=r"f is 1\.0 at 0\.0 and 2\.0 at 1\.0; give ends"):
        root(lambda x: x * x + 1, 0, 1)
