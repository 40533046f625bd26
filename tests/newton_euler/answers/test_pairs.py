"""Two mistakes at once: which are named, and that guesses are not."""

import numpy as np
import pytest

from newton_euler.answers.causes import INVERTED, OPPOSITE_NUMBER, both, computed, listed
from newton_euler.answers.fit import Fit
from newton_euler.answers.kinds import KINDS
from newton_euler.answers.near import NO_SINGLES, Singles
from newton_euler.answers.pairs import of_two

A, B = np.linspace(1.1, 1.9, 8), np.linspace(0.4, 2.7, 8) ** 2
LISTED, SLIP, OTHER = listed("own", "own"), computed("slip", "slip"), computed("other", "other")


def points(*components):
    return tuple(zip(*(np.broadcast_to(x, A.shape).tolist() for x in components), strict=True))


def in_symbols(given, key, own, **slips):
    """The pair that gives a formula; ``own`` is what the problem's own mistake makes of it."""
    made = [points(x) for x in slips.values()]
    causes = [(1, {"slip": SLIP, "other": OTHER}[name]) for name in slips]
    singles = Singles(causes, lambda n: [x[n] for x in made], of_symbols=True)
    kind = KINDS["expression"]
    fit = Fit(points(given), points(key), kind.rtol)
    return of_two(fit, kind, [(LISTED, points(own))], lambda: singles, lambda cause: False)


ROOT_OF = lambda x, y: np.sqrt(x**2 + y**2)


@pytest.mark.parametrize(
    ("given", "key", "own", "slip"),
    [
        (A, A + A * B + B**2, A + A * B, A + B**2),  # two terms of a sum left out
        (A / 2, A * B, A, A * B / 2),  # two factors
        (ROOT_OF(0, B / 2), ROOT_OF(A, B), B, ROOT_OF(A, B / 2)),  # two terms under a root
    ],
)
def test_a_listed_mistake_and_a_slip_are_named_together(given, key, own, slip):
    assert in_symbols(given, key, own, slip=slip) == (both(LISTED, SLIP),)
    assert in_symbols(1.001 * given, key, own, slip=slip) == ()


def test_the_opposite_sign_and_a_fraction_upside_down_are_seen_beside_a_listed_mistake():
    assert in_symbols(-A, A * B, A) == (both(LISTED, OPPOSITE_NUMBER),)
    assert in_symbols(1 / A, A * B, A) == (both(LISTED, INVERTED),)


def test_two_slips_and_two_numbers_as_factors_are_no_pair():
    """A guess of the right form is met by these as well."""
    assert in_symbols(A, A + A * B + B**2, B, slip=A + A * B, other=A + B**2) == ()
    assert in_symbols(A * B * 3 / 2, A * B, A * B * 3, slip=A * B / 2) == ()


def test_factors_of_one_component_are_not_added_and_nothing_is_added_to_nothing():
    assert in_symbols(-2 * A * B, A * B, 0 * A, slip=-A * B) == ()
    assert in_symbols(A * B + B, A * B, B, slip=2 * A * B) == ()


KEY = (3.127, -4.216, 1.871)


def of_numbers(given, own, slips):
    """The pair that gives a vector."""
    kind = KINDS["vector"]
    singles = Singles([(1, SLIP)] * len(slips), lambda n: slips) if slips else NO_SINGLES
    fit = Fit((given,), (KEY,), kind.rtol)
    return of_two(fit, kind, [(LISTED, (own,))], lambda: singles, lambda cause: False)


def test_numbers_are_named_where_two_components_are_wrong_with_the_digits_that_were_written():
    own, slip = (5.418, -4.216, 1.871), (3.127, -2.204, 1.871)
    assert of_numbers((5.418, -2.204, 1.871), own, [slip]) == (both(LISTED, SLIP),)
    assert of_numbers((5.4, -2.2, 1.9), own, [slip]) == ()
    assert of_numbers((5.43, -2.204, 1.871), own, [slip]) == ()
    one = (4.018, -4.216, 1.871)  # in one component alone
    assert of_numbers((6.309, -4.216, 1.871), own, [one]) == ()


def test_random_vectors_are_hardly_ever_two_mistakes():
    rng = np.random.default_rng(4)
    draw = lambda: tuple(np.round(KEY * rng.choice((-1, 1), 3) * 3 ** rng.uniform(-1, 1, 3), 3))
    slips = [draw() for _ in range(200)]
    found = [of_numbers(tuple(map(float, draw())), draw(), slips) for _ in range(300)]
    assert sum(map(bool, found)) <= 3


def test_a_mistake_that_the_other_undoes_does_not_count():
    own, slip = (5.418, -2.108, 1.871), (3.127, -6.324, 1.871)  # their sum in y is the right one
    assert of_numbers((5.418, -4.216, 1.871), own, [slip]) == ()
