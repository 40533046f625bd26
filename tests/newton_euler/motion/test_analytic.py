"""What a series may miss, read from the rates."""

import pytest

from newton_euler import Model, acos, asin, atan2, cos, cosh, exp, sin, sinh, sqrt, tan, tanh, where
from newton_euler.motion.analytic import hazards, kinks
from newton_euler.motion.prepared import prepared_model


def traced(rate):
    """The traced rate of a model with states x and y, and parameters k > 0 and m < 0."""
    rates = lambda s, p, t: (rate(s, p, t), 0.0 * s.y)
    return prepared_model(Model("any", {"k": 2.0, "m": -2.0}, ("x", "y"), rates)).traced


@pytest.mark.parametrize(
    ("rate", "found"),
    [
        (lambda s, p, t: sin(s.x) / cos(s.y), []),
        (lambda s, p, t: abs(s.x), ["abs"]),
        (lambda s, p, t: where(s.x > 0, s.x, 1.0), ["where"]),
        (lambda s, p, t: where(t > 1, s.x, abs(s.y)), ["abs", "where"]),
        (lambda s, p, t: abs(p.k) * s.x, []),
        (lambda s, p, t: where(p.k > 0, p.k, 1.0) * s.x, []),
        (lambda s, p, t: (abs(s.x), s.y)[1], []),
    ],
)
def test_kinks_are_choices_that_change_on_the_way(rate, found):
    assert kinks(traced(rate)) == found


SQUARES = lambda s: s.x * s.x + s.y * s.y


@pytest.mark.parametrize(
    "rate",
    [
        lambda s, p, t: s.x / s.y,
        lambda s, p, t: sin(s.x) * tan(s.y),
        lambda s, p, t: s.x**2 + s.x**-3,
        lambda s, p, t: s.x**3,
        lambda s, p, t: sqrt(p.k) * asin(p.k / 4) * exp(p.k) * p.k**0.5 * s.x,
        # the same root in a denominator, even of another term, and as a factor there
        lambda s, p, t: 1 / sqrt(s.x),
        lambda s, p, t: sqrt(s.x) + 1 / s.x,
        lambda s, p, t: s.x / sqrt(SQUARES(s)),
        lambda s, p, t: sqrt(SQUARES(s)) + 1 / SQUARES(s),
        lambda s, p, t: sqrt(SQUARES(s)) + 1 / (p.k * SQUARES(s)),
        lambda s, p, t: sqrt(SQUARES(s)) + 1 / (SQUARES(s) * sqrt(SQUARES(s))),
        lambda s, p, t: sqrt(SQUARES(s)) + 1 / SQUARES(s) ** 1.5,
        lambda s, p, t: sqrt(s.x) + 1 / (-s.x),
        lambda s, p, t: sqrt(s.x) + 1 / sqrt(s.x),
        # a negative power
        lambda s, p, t: s.x**-1.5,
        lambda s, p, t: SQUARES(s) ** -1.5 + sqrt(SQUARES(s)),
        lambda s, p, t: sqrt(s.x) + s.x**-2,
        # never zero
        lambda s, p, t: sqrt(1 + s.x * s.x),
        lambda s, p, t: sqrt(s.x * s.x + s.y * s.y + 0.5),
        lambda s, p, t: (1 + s.x * s.x) ** p.k,
        lambda s, p, t: sqrt(2 * (1 + s.x * s.x)),
        lambda s, p, t: sqrt((1 + s.x * s.x) / 3),
        lambda s, p, t: sqrt((1 + s.x * s.x) / (2 + s.y * s.y)),
        lambda s, p, t: sqrt((1 + s.x * s.x) * (1 + s.y * s.y)),
        lambda s, p, t: sqrt(1 + (s.x * s.x) * (s.y * s.y)),
        lambda s, p, t: sqrt(1 + abs(s.x)) + 0 * abs(s.x),
        lambda s, p, t: sqrt(sqrt(1 + s.x * s.x)),
    ],
)
def test_what_a_series_sees_is_not_a_hazard(rate):
    assert hazards(traced(rate)) == []


@pytest.mark.parametrize(
    ("rate", "found"),
    [
        (lambda s, p, t: sqrt(s.x), ["sqrt"]),
        (lambda s, p, t: sqrt(s.x * s.x), ["sqrt"]),
        (lambda s, p, t: s.x**1.5, ["**"]),
        (lambda s, p, t: s.x**8 + cos(s.y) ** 20, ["**"]),
        (lambda s, p, t: s.x**2.0 + sqrt(s.y), ["sqrt"]),
        (lambda s, p, t: asin(s.x), ["asin"]),
        (lambda s, p, t: acos(s.x), ["acos"]),
        (lambda s, p, t: atan2(s.x, s.y), ["atan2"]),
        (lambda s, p, t: exp(s.x), ["exp"]),
        (lambda s, p, t: tanh(s.x) + sqrt(s.y), ["sqrt", "tanh"]),
        (lambda s, p, t: 2.0 ** (-s.x), ["pow"]),
        (lambda s, p, t: 1 / asin(s.x), ["asin"]),
        # something else is in the denominator
        (lambda s, p, t: sqrt(s.x) / (s.x + s.y), ["sqrt"]),
        (lambda s, p, t: s.x / sqrt(s.y) + sqrt(s.x), ["sqrt"]),
        (lambda s, p, t: sqrt(s.x) * s.x**2, ["sqrt"]),
        (lambda s, p, t: sqrt(s.x) + s.y**-2, ["sqrt"]),
        (lambda s, p, t: s.x**0.5 + s.y**-0.5, ["**"]),
        # may be zero or negative
        (lambda s, p, t: sqrt(s.x * s.x - 1), ["sqrt"]),
        (lambda s, p, t: sqrt(1 - s.x * s.x), ["sqrt"]),
        (lambda s, p, t: sqrt(1 + s.x), ["sqrt"]),
        (lambda s, p, t: sqrt(s.x + 1), ["sqrt"]),
        (lambda s, p, t: sqrt(1 + s.x * s.y), ["sqrt"]),
        (lambda s, p, t: sqrt(1 + s.x * abs(s.y)), ["sqrt"]),
        (lambda s, p, t: sqrt(1 + s.x / (1 + s.y * s.y)), ["sqrt"]),
        (lambda s, p, t: sqrt(s.x * s.x + s.y * s.y), ["sqrt"]),
        (lambda s, p, t: sqrt(s.x * (1 + s.y * s.y)), ["sqrt"]),
        (lambda s, p, t: sqrt(s.x / (1 + s.y * s.y)), ["sqrt"]),
        (lambda s, p, t: sqrt((1 + s.y * s.y) * (-2)), ["sqrt"]),
        (lambda s, p, t: sqrt(sqrt(s.x * s.x + s.y * s.y)), ["sqrt"]),
        (lambda s, p, t: sqrt(1 + -2 * (s.x * s.x)), ["sqrt"]),
        (lambda s, p, t: sqrt(cos(s.x)), ["sqrt"]),
        (lambda s, p, t: (sqrt(s.x), s.y)[1], []),  # the rates do not need it
        # never zero: no branch point on the way, but the exponential itself may be hidden
        (lambda s, p, t: sqrt(exp(s.x)), ["exp"]),
        (lambda s, p, t: sqrt(cosh(s.x)), ["cosh"]),
        (lambda s, p, t: sqrt(1 + exp(s.x)), ["exp"]),
        (lambda s, p, t: sqrt(1 + s.x * s.x * cosh(s.y)), ["cosh"]),
        (lambda s, p, t: sqrt(sinh(s.x)), ["sinh", "sqrt"]),
    ],
)
def test_what_a_series_may_not_see_is_a_hazard(rate, found):
    assert hazards(traced(rate)) == found
