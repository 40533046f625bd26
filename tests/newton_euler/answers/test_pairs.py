"""Two mistakes at once: which pairs are named, and that guesses are not."""

import numpy as np
import pytest

from newton_euler.algebra.language import speaking
from newton_euler.answers.causes import (
    INVERTED,
    LEFT_OUT,
    OPPOSITE_NUMBER,
    both,
    computed,
    listed,
    term_reversed,
    unconverted,
)
from newton_euler.answers.fit import Fit
from newton_euler.answers.kinds import KINDS
from newton_euler.answers.near import NO_SINGLES, Singles
from newton_euler.answers.pairs import of_two

A, B = np.linspace(1.1, 1.9, 8), np.linspace(0.4, 2.7, 8) ** 2
LISTED, SLIP, OTHER = listed("own", "own"), computed("slip", "slip"), computed("other", "other")


def points(*components):
    return tuple(zip(*(np.broadcast_to(x, A.shape).tolist() for x in components), strict=True))


NAMELESS = computed("nameless", "leaves out one term of a sum", does=LEFT_OUT)


def in_symbols(given, key, own, **slips):
    """The pair that gives a formula; ``own`` is the key with the problem's own mistake."""
    made = [points(x) for x in slips.values()]
    causes = {"slip": SLIP, "other": OTHER, "nameless": NAMELESS}
    causes = [(1, causes[name]) for name in slips]
    singles = Singles(causes, lambda n: [x[n] for x in made], of_symbols=True)
    kind = KINDS["expression"]
    fit = Fit(points(given), points(key), kind.rtol)
    return of_two(fit, kind, [(LISTED, points(own))], lambda: singles, lambda cause: False)


ROOT_OF = lambda x, y: np.sqrt(x**2 + y**2)


@pytest.mark.parametrize(
    ("given", "key", "own", "slip"),
    [
        (A, A + A * B + B**2, A + A * B, A + B**2),  # two terms of a sum left out
        (A / 3, A * B, A, A * B / 3),  # two factors
        (ROOT_OF(0, B / 3), ROOT_OF(A, B), B, ROOT_OF(A, B / 3)),  # two terms under a root
    ],
)
def test_a_listed_mistake_and_a_slip_are_named_together(given, key, own, slip):
    assert in_symbols(given, key, own, slip=slip) == (both(LISTED, SLIP),)
    assert in_symbols(1.001 * given, key, own, slip=slip) == ()
    assert in_symbols(given, key, own, nameless=slip) == ()


def test_opposite_signs_and_fractions_upside_down_are_seen_where_the_words_have_room():
    assert in_symbols(-A, A * B, A) == (both(LISTED, OPPOSITE_NUMBER),)
    assert in_symbols(1 / A, A * B, A) == (both(LISTED, INVERTED),)
    long = "takes the speed of B" + ", that of C" * 5
    assert both(LISTED, listed("", f"{long} twice")).what == f"own, and also {long} twice"
    assert both(LISTED, listed("", f"{long} two times")) is None


@pytest.mark.parametrize(("language", "words"), [
    ("en", "has all but the weight with the opposite sign"),
    ("de", "alles außer the weight mit falschem Vorzeichen ansetzt"),
])  # fmt: skip
def test_one_term_reversed_of_an_answer_reversed_is_all_but_this(language, words):
    with speaking(language):
        assert both(term_reversed("g", "the weight"), OPPOSITE_NUMBER).what == words


def test_what_also_explains_a_guess_is_not_a_pair():
    """Of the strangers' answers that matched two slips a third had other causes."""
    given, key, slip = A, A + A * B + B**2, A + A * B
    assert in_symbols(given, key, B, slip=slip, other=A + B**2) == ()
    reversed_ = A + A * B - B**2  # two changes to one term
    assert in_symbols(key - 3 * B**2, key, A, slip=slip, other=reversed_) == ()
    assert in_symbols(A * B * 3 / 2, A * B, A * B * 3, slip=A * B / 2) == ()  # numbers as factors
    # factors of one component are not added, and nothing is added to nothing
    assert in_symbols(-3 * A * B, A * B, 0 * A, slip=-2 * A * B) == ()
    assert in_symbols(A * B + B, A * B, B, slip=2 * A * B) == ()


def test_a_component_may_be_zero_at_some_points():
    """A component that changes sign is an example: nothing is divided by it where it is zero."""
    kind, zero = KINDS["vector_expression"], np.where(A < 1.2, 0.0, B)
    key, given = points(A + B, zero, A * B), points(A, zero, A)
    own, slip = points(A, zero, A * B), points(A + B, zero, A)
    singles = Singles([(1, SLIP)], lambda n: [slip[n]], of_symbols=True)
    found = of_two(
        Fit(given, key, kind.rtol), kind, [(LISTED, own)], lambda: singles, lambda cause: False
    )
    assert found == (both(LISTED, SLIP),)


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
    assert of_numbers((5.0, -2.0, 2.0), own, [slip]) == ()
    assert of_numbers((5.43, -2.204, 1.871), own, [slip]) == ()
    one = (4.018, -4.216, 1.871)  # wrong in one component, which one of many slips could match
    many = [(3.1 + n / 99, -4.216, 1.871) for n in range(99)]
    assert of_numbers((6.309, -4.216, 1.871), own, [one]) == (both(LISTED, SLIP),)
    assert of_numbers((6.309, -4.216, 1.871), own, [one, *many]) == ()


def test_random_vectors_are_rarely_taken_for_two_mistakes():
    rng = np.random.default_rng(4)
    draw = lambda: tuple(np.round(KEY * rng.choice((-1, 1), 3) * 3 ** rng.uniform(-1, 1, 3), 3))
    slips = [draw() for _ in range(200)]
    found = [of_numbers(tuple(map(float, draw())), draw(), slips) for _ in range(300)]
    assert sum(map(bool, found)) <= 3


def test_mistakes_that_undo_each_other_or_are_powers_of_one_another_are_no_pair():
    own, slip = (5.418, -2.108, 1.871), (3.127, -6.324, 1.871)  # their sum in y is right
    assert of_numbers((5.418, -4.216, 1.871), own, [slip]) == ()
    root = 1.7394
    assert of_number(4.8175 * root, 4.8175, [4.8175 * root**3], [(4.8175 / root**2,)]) == ()


def of_number(given, key, own, slips, is_size=False, slip=SLIP):
    fit = Fit(((given,),), ((key,),), KINDS["number"].rtol)
    singles = Singles([(1, slip)] * len(slips), lambda n: slips, is_size=is_size)
    own = [(LISTED, ((x,),)) for x in own]
    return of_two(fit, KINDS["number"], own, lambda: singles, lambda cause: False)


def test_a_single_number_is_two_mistakes_where_few_are_as_simple_and_near():
    own, slip = 7.3128, 2.0411
    added = own + slip - 4.8175
    many = [(4.8175 * (0.5 + n / 999),) for n in range(999)]
    assert of_number(round(added, 4), 4.8175, [own], [(slip,)]) == (both(LISTED, SLIP),)
    assert of_number(round(added, 4), 4.8175, [own], [(slip,), *many]) == ()
    assert of_number(round(added, 1), 4.8175, [own], [(slip,)]) == ()
    assert of_number(-own, 4.8175, [own], []) == (both(LISTED, OPPOSITE_NUMBER),)


def test_random_numbers_are_rarely_taken_for_two_mistakes():
    rng = np.random.default_rng(7)
    draw = lambda: float(f"{4.8175 * 3 ** rng.uniform(-1, 1):.5g}")
    cases = [
        (draw(), [draw() for _ in range(6)], [(draw(),) for _ in range(40)]) for _ in range(400)
    ]
    assert sum(bool(of_number(x, 4.8175, own, slips)) for x, own, slips in cases) <= 3


TERM = computed("term", "leaves out it", does=LEFT_OUT, of="the term b")


def test_a_term_with_another_factor_is_seen_where_it_shows_twice_and_is_not_the_whole():
    def multiple(given, key, without, kind="expression"):
        singles = Singles([(3, TERM)], lambda n: [without[n]], of_symbols=True)
        fit = Fit(given, key, KINDS[kind].rtol)
        return [c.what for c in of_two(fit, KINDS[kind], [], lambda: singles, lambda c: False)]

    expected = ["all but the factor of the term b is right"]
    assert multiple(points(A + 0.3137 * B), points(A + B), points(A)) == expected
    simple = ["has 3/10 times the term b"]
    assert multiple(points(A + 0.3 * B), points(A + B), points(A)) == simple
    assert multiple(points(A + 0.3 * B * A), points(A + B), points(A)) == []
    assert multiple(points(0.3 * B), points(B), points(0 * A)) == []  # the whole
    key, without = ((3.12714, -4.21638, 1.87102),), ((2.12714, -2.21638, 1.87102),)
    assert multiple(((3.32714, -4.61638, 1.87102),), key, without, "vector") == expected
    assert multiple(((3.32714, -4.61738, 1.87102),), key, without, "vector") == []


def test_a_size_has_lost_the_sign_that_a_mistake_turned():
    unit = unconverted("theta", "deg")
    of = lambda is_size, slip: of_number(-7.3128, 4.8175, [], [(7.3128,)], is_size, slip)
    assert of(True, unit) == (unit,)
    assert of(False, unit) == (both(unit, OPPOSITE_NUMBER),)
    assert of(True, SLIP) == (both(SLIP, OPPOSITE_NUMBER),)
