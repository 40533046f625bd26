"""Verdicts on a made-up problem: what is right, what follows from earlier answers, the words."""

from types import SimpleNamespace

import numpy as np
import pytest

from newton_euler.answers.causes import BOOK, GIVES_ZERO, Cause, answer_to, follows, listed
from newton_euler.answers.forms import Form
from newton_euler.answers.kinds import KINDS
from newton_euler.answers.near import LESS, NO_SINGLES, NO_SLIPS, RARER, Slips
from newton_euler.answers.tolerance import RTOL
from newton_euler.answers.verdicts import explain, judge, value_line


def asked(key, kind, unit="1", of=()):
    form = Form(KINDS[kind], unit, of)
    return SimpleNamespace(key=key, kind=form.kind, unit=unit, atol=1e-6, rtol=RTOL, form=form)


class Fall:
    """The speed after a fall, its square, and whether it rises; the square follows."""

    answers = (
        asked("v", "number", "m/s"),
        asked("square", "number", "m^2/s^2"),
        asked("sense", "choice", of=("rises", "falls")),
        asked("bounces", "count"),
    )

    def __init__(self, wrong=()):
        self._wrong, self.symbols, self.book, self.sheets = wrong, {}, {}, ()
        self.slips, self.where = NO_SLIPS, "section 6.1"
        self.key = {
            "v": ((5.0,),), "square": ((25.0,),), "sense": (("falls",),), "bounces": ((2,),),
        }  # fmt: skip
        self.earlier = {"square": ("v",), "sense": ("v",)}

    def wrong(self, key):
        return [model[1:] for model in self._wrong if model[0] == key]

    def sequel(self, key, earlier):
        return NO_SLIPS

    def other_ways(self, key):
        return ()

    def following(self, key, earlier):
        ((v,),) = earlier["v"]
        return ((v**2,),) if key == "square" else (("falls" if v > 0 else "rises",),)


def verdicts(numbers, answers, faults=None):
    by_key = {a.key: a for a in numbers.answers}
    return {
        key: judge(by_key[key], by_key[key].form, tree, (faults or {}).get(key), numbers, [100])
        for key, tree in answers.items()
    }


def explained(numbers, key, answers, faults=None):
    found = verdicts(numbers, answers, faults)
    return explain(next(a for a in numbers.answers if a.key == key), found, numbers)


@pytest.mark.parametrize(("key", "tree", "verdict"), [
    ("v", 5.02, "right"), ("v", 5.04, "wrong"), ("v", None, "blank"), ("v", "5", "unreadable"),
    ("sense", "falls", "right"), ("sense", "rises", "wrong"), ("sense", ["falls"], "wrong"),
    ("sense", 1, "wrong"), ("bounces", 2, "right"), ("bounces", 2.0, "wrong"),
    ("bounces", True, "wrong"), ("bounces", "2", "wrong"),
])  # fmt: skip
def test_an_answer_is_right_wrong_unreadable_or_blank(key, tree, verdict):
    assert verdicts(Fall(), {key: tree})[key].verdict == verdict


def test_an_answer_in_another_unit_is_converted_before_it_is_compared():
    v = Fall.answers[0]
    assert judge(v, Form("number", "mm/s"), 5000.0, None, Fall(), [100], 1e-3).verdict == "right"


def test_what_follows_is_recognised_before_any_other_cause():
    why = explained(Fall(), "square", {"v": 6.0, "square": 36.0})
    assert why.earlier == ("v",)
    assert why.message == "not right; it follows from your v"
    assert why.diagnosis == "follows from a wrong v"
    assert explained(Fall(), "sense", {"v": -6.0, "sense": "rises"}).earlier == ("v",)
    doubled = listed("doubled", "takes the speed twice")
    why = explained(Fall([("square", doubled, ((36.0,),))]), "square", {"v": 6.0, "square": 36.0})
    assert why.causes == (follows(["v"]), doubled)
    assert why.message == "not right; it follows from your v"
    assert why.also == "; it also fits a solution that takes the speed twice (see section 6.1)"


class There(Fall):
    """The speeds at two places, and at a third place where the body is at rest."""

    def __init__(self):
        super().__init__()
        self.answers = tuple(asked(key, "number", "m/s") for key in ("v", "w", "rest"))
        self.key, self.earlier = {"v": ((5.0,),), "w": ((8.0,),), "rest": ((0.0,),)}, {}


def test_answers_exchanged_between_parts_are_named():
    given = {"v": 8.0, "w": 5.0, "rest": 3.0}
    assert explained(There(), "v", given).causes == (answer_to("w"),)
    assert explained(There(), "w", given).causes == (answer_to("v"),)
    assert explained(There(), "rest", given).causes == ()
    assert explained(There(), "v", given | {"v": 0.0}).causes == (GIVES_ZERO,)
    assert explained(There(), "v", {"v": 8.0}).causes == ()  # w is not asked for


def test_neither_a_component_nor_a_vector_in_another_unit_is_met_by_chance():
    numbers = There()
    numbers.answers = asked("v", "number", "m/s"), asked("w", "vector", "m/s")
    numbers.key["w"] = ((8.0, 1.0, 2.0),)
    assert explained(numbers, "v", {"v": 8.0, "w": [8.0, 1.0, 2.0]}).causes == ()
    numbers = Body()
    numbers.answers = asked("r", "vector", "m"), asked("v", "vector", "m/s")
    numbers.key = {"r": ((1.0, 2.0, 3.0),), "v": ((4.0, -7.0, 9.0),)}
    given = {"r": [4.0, -7.0, 9.0], "v": [4.0, -7.0, 9.0]}
    assert explained(numbers, "r", given).causes == (answer_to("v"),)


@pytest.mark.parametrize(("square", "causes"), [(5.0, (answer_to("square"),)), (30.0, ())])
def test_a_number_in_another_unit_is_taken_for_exchanged_if_both_were(square, causes):
    numbers = Fall()
    numbers.key["square"] = ((26.0,),)
    assert explained(numbers, "v", {"v": 26.0, "square": square}).causes == causes


def test_the_other_parts_tell_which_of_two_mistakes_was_made():
    once, alone = listed("once", "takes the mean"), listed("alone", "forgets the root")
    numbers = Fall([("v", once, ((6.0,),)), ("v", alone, ((6.0,),)), ("square", once, ((36.0,),))])
    words = lambda **given: [c.what for c in explained(numbers, "v", {"v": 6.0, **given}).causes]
    assert words() == ["takes the mean", "forgets the root"]
    assert words(square=36.0) == ["takes the mean"]
    assert words(square=25.0) == ["forgets the root", "in this part takes the mean"]


def test_a_remark_on_the_digits_is_the_message_where_nothing_explains_the_answer_else_where_to_read():
    (seen,) = (why := explained(Fall(), "v", {"v": 5.12})).causes
    assert seen.is_observation
    assert why.message == f"not right; {seen.text}"
    for cause, where in (
        (listed("a", "halves it"), "6.1"),
        (listed("b", "x").at("section 9.9"), "9.9"),
    ):
        (found,) = explained(Fall([("v", cause, ((2.5,),))]), "v", {"v": 2.5}).causes
        assert found.where == f"section {where}"


@pytest.mark.parametrize("answers", [
    {"v": 6.0, "square": 30.0}, {"v": 5.0, "square": 36.0}, {"square": 36.0},
    {"v": None, "square": 36.0}, {"v": 0.0, "square": 0.0},
])  # fmt: skip
def test_an_answer_that_does_not_follow_is_not_reported_as_following(answers):
    assert explained(Fall(), "square", answers).earlier == ()


class Two(Fall):
    """The square follows from two answers, one of which may be unreadable."""

    def __init__(self):
        super().__init__()
        self.earlier = {"square": ("v", "bounces")}

    def sequel(self, key, earlier):
        assert None not in earlier.values()
        return NO_SLIPS

    def following(self, key, earlier):
        assert None not in earlier.values()
        return super().following(key, earlier)


@pytest.mark.parametrize(
    ("others", "earlier"),
    [({"bounces": 3}, ("v", "bounces")), ({"bounces": "text"}, ()), ({"bounces": None}, ()),
     ({}, ("v",))],
)  # fmt: skip
def test_nothing_follows_from_an_answer_that_was_not_read(others, earlier):
    """This holds even if the other answers are wrong and alone would give it. An answer that was
    not asked for is taken as right.
    """
    answers = {"v": 6.0, "square": 36.0, **others}
    assert explained(Two(), "square", answers).earlier == earlier


class Made(Slips):
    """Slips (level, cause, {answer: points}) as a computation may have."""

    def __init__(self, *made):
        self.made, self.tried = made, []

    def near(self, key, fit, kind):
        return [(level, cause, x[key]) for level, cause, x in self.made if key in x]

    def of(self, key, cause):
        return [x[key] for _, own, x in self.made if own == cause and key in x]

    def singles(self, key, most):
        self.tried.append(most)
        return NO_SINGLES


def slip(what):
    return Cause("computed", what, what)


@pytest.mark.parametrize(("level", "given", "words"), [
    (3, {}, "halves g"), (3, {"v": 5.0}, "forgets the root"),
    (4, {"v": 5.0}, "in this part halves g"), (3, {"v": 5.5}, "halves g"),
    (3, {"v": 6.0}, "halves g"),
])  # fmt: skip
def test_a_slip_that_a_right_earlier_answer_denies_gives_way_to_one_about_as_simple(
    level, given, words
):
    numbers, square = Fall(), {"square": ((30.0,),)}
    halves, forgets = slip("halves g"), slip("forgets the root")
    numbers.slips = Made((1, halves, {"v": ((5.5,),), **square}), (level, forgets, square))
    (cause,) = explained(numbers, "square", {"square": 30.0, **given}).causes
    assert cause.what == words


def test_where_an_answer_follows_no_slip_in_it_is_named():
    numbers = Fall()
    numbers.slips = Made((1, slip("halves g"), {"square": ((36.0,),)}))
    numbers.sequel = lambda key, earlier: Made((1, slip("halves it"), {key: ((36.0,),)}))
    assert explained(numbers, "square", {"v": 6.0, "square": 36.0}).causes == (follows(["v"]),)
    assert explained(numbers, "square", {"v": 5.0, "square": 36.0}).causes == (slip("halves g"),)


@pytest.mark.parametrize(("v", "square", "words"), [
    (6.0, 18.0, "goes on from your v, but halves it"), (5.0, 18.0, "halves it"),
    (6.0, 0.0, GIVES_ZERO.what),
])  # fmt: skip
def test_a_slip_in_going_on_from_a_wrong_answer_is_named_but_zero_is_no_evidence(v, square, words):
    numbers = Fall()
    numbers.sequel = lambda key, earlier: Made((1, slip("halves it"), {key: ((square,),)}))
    (cause,) = explained(numbers, "square", {"v": v, "square": square}).causes
    assert cause.what == words


class Further(Fall):
    """What follows from the speed: twice and three more; nothing from one below zero."""

    answers = *Fall.answers, asked("twice", "number"), asked("more", "number")

    def __init__(self):
        super().__init__()
        self.key |= {"twice": ((10.0,),), "more": ((8.0,),)}
        self.earlier |= {"twice": ("v",), "more": ("v",)}

    def following(self, key, earlier):
        ((v,),) = earlier["v"]
        return {"twice": ((2 * v,),), "more": ((v + 3,),)}[key] if v >= 0 else None


@pytest.mark.parametrize(("key", "v", "given", "does"), [
    ("twice", 6.0, 12.0, True), ("twice", 1e9, 2e9, True), ("twice", 0.0, 0.0, False),
    ("twice", -6.0, -12.0, False), ("more", 6.0, 9.0, True), ("more", 1e9, 1e9, False),
    ("more", 1e3, 1002.5, True), ("more", 1e3, 1002.0, False), ("more", 1.7e308, 1.7e308, False),
])  # fmt: skip
def test_it_follows_where_the_computation_shows(key, v, given, does):
    """Not in zeros, nor in one huge number for every answer, beside which three do not count."""
    found = explained(Further(), key, {"v": v, key: given}).earlier
    assert found == (("v",) if does else ())


class Body(Fall):
    """A moment of inertia as a formula, the same as a matrix of numbers, and a vector."""

    def __init__(self):
        super().__init__()
        kinds = {"I": "expression", "all": "matrix", "r": "vector"}
        self.answers = tuple(asked(key, kind, "kg*m^2") for key, kind in kinds.items())
        m, R = np.array([1.0, 2.0, 3.5, 5.0, 1.3]), np.array([0.5, 1.7, 0.9, 2.0, 3.0])
        self.symbols, self.earlier = {"m": m, "R": R}, {}
        self.key = {"I": tuple((x,) for x in m * R**2 / 2), "r": ((1.0, 2.0, 3.0),)}
        self.key["all"] = ((1.0, 2.0, 3.0, 2.0, 5.0, 6.0, 3.0, 6.0, 9.0),)


@pytest.mark.parametrize(
    ("tree", "words"),
    [
        (["*", 0.4, "m", "R", "R"], "has the number 2/5 of a solid sphere"),
        (["*", 0.5, "m", "R"], "has another power of R than asked for"),
        (["*", 3.5, "m", "R", "R"], "has 7 times the right number"),
        (["+", ["*", 0.5, "m", "R", "R"], ["*", 2, "m", "R"]], "is off by one term, in m and R"),
    ],
)
def test_a_formula_that_nothing_explains_is_compared_with_the_right_one(tree, words):
    (cause,) = explained(Body(), "I", {"I": tree}).causes
    assert cause.what == words


def test_a_formula_that_follows_from_a_wrong_one_is_not_compared():
    numbers, half = Body(), Body().key["I"]
    numbers.answers += (asked("J", "expression", "kg*m^2"),)
    numbers.key["J"], numbers.earlier = tuple((2 * x,) for (x,) in half), {"I": ("J",)}
    numbers.following = lambda key, earlier: tuple((x / 2,) for (x,) in earlier["J"])
    given = {"J": ["*", 7, "m", "R", "R"], "I": ["*", 3.5, "m", "R", "R"]}
    assert explained(numbers, "I", given).causes == (follows(["J"]),)


@pytest.mark.parametrize(("key", "tree", "most"), [
    ("I", ["sin", "m"], LESS), ("r", [1.5, 7.1, 2.2], RARER),
    ("all", [1.7, 7.1, 2.2, 9.1, 4.4, 3.7, 8.2, 5.2, 6.1], LESS),
])  # fmt: skip
def test_two_mistakes_at_once_are_looked_for_further_where_chance_meets_fewer(key, tree, most):
    numbers = Body()
    numbers.slips = Made()
    explained(numbers, key, {key: tree})
    assert numbers.slips.tried == [most]


def test_a_listed_word_is_named_and_another_is_not():
    pin, rod = listed("pin", "counts the pin as rigid"), listed("rod", "forgets the turning")
    numbers = Fall([("bounces", pin, ((3,),)), ("bounces", rod, ((3,),))])
    assert explained(numbers, "bounces", {"bounces": 3}).causes == (pin, rod)
    assert explained(numbers, "bounces", {"bounces": 4}).causes == ()
    elsewhere = Fall([("bounces", pin, ((3,),)), ("v", pin, ((6.0,),))])
    assert explained(elsewhere, "bounces", {"bounces": 3, "v": 6.0}).causes == (pin,)
    assert explained(elsewhere, "bounces", {"bounces": 3, "v": 7.0}).causes == ()


def test_the_answer_for_the_books_numbers_is_named_and_does_not_follow():
    numbers = Fall()
    numbers.book = {"v": ((6.0,),), "square": ((36.0,),)}
    why = explained(numbers, "square", {"v": 6.0, "square": 36.0})
    assert (why.causes, why.earlier) == ((BOOK,), ())
    assert why.message.startswith("not right: this is the answer for the book's numbers")


@pytest.mark.parametrize(("form", "tree", "line"), [
    ("vector, mm/s", [1.0, 2.5, 0.0], "[1, 2.5, 0] mm/s"),
    ("vector, mm/s", {"arm": [1, 0, 0], "ground": [0, 1, 0]},
     "[1, 0, 0] in arm, [0, 1, 0] in ground, mm/s"),
    ("matrix, 1", [1.0, 0.0, 0.0, 0.0, 2.0, 0.0, 0.0, 0.0, 3.5],
     "[[1, 0, 0], [0, 2, 0], [0, 0, 3.5]]"),
    ("count", 3, "3"),
    ("choice: a | b", "a\nb", "a b"),
])  # fmt: skip
def test_the_value_that_was_read_is_one_line(form, tree, line):
    assert value_line(Form.read(form), tree, "wrong") == line
    assert value_line(Form.read(form), tree, "unreadable") == ""


@pytest.mark.parametrize("tree", [[[[]]] * 9999, "x" * 99999, 1e999, {"a": {"b": {}}}])
@pytest.mark.parametrize("form", ["choice: a | b", "count"])
def test_the_line_of_a_word_is_short_whatever_it_is(form, tree):
    assert 0 < len(value_line(Form.read(form), tree, "wrong")) <= 200
