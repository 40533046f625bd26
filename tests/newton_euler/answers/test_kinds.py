"""The kinds of answers, found by name, and everything that the direction does differently."""

import copy
import math
import pickle

import numpy as np
import pytest

from newton_euler import Frame
from newton_euler.answers import tolerance
from newton_euler.answers.causes import NEAR, Cause, exchanged_components
from newton_euler.answers.diagnosis import diagnose
from newton_euler.answers.forms import AnswerError, Form
from newton_euler.answers.kinds import KINDS, Kind, _Formula
from newton_euler.answers.seals import opens, seal
from newton_euler.answers.trees import TreeError
from newton_euler.classroom import expect, receipt

DIRECTION = KINDS["direction"]
KEY = ((0.6, 0.0, -0.8),)
EXAMPLES = {
    "number": 2.5, "vector": [1.0, 2.0, 3.0], "direction": [0.0, -3.0, 4.0], "count": 3,
    "matrix": [[1.0, 2, 3], [4, 5, 6], [7, 8, 9]], "interval": [1.0, 2.0], "choice": "stable",
    "expression": 1.0, "vector_expression": [1.0, 2.0, 3.0],
    "matrix_expression": [[1.0, 2, 3], [4, 5, 6], [7, 8, 9]],
}  # fmt: skip


def form_of(name):
    return Form(KINDS[name], "1", ("stable", "unstable") if KINDS[name].has_options else ())


@pytest.mark.parametrize("name", KINDS)
def test_every_kind_reads_states_and_compares_its_own_answers(name):
    form = form_of(name)
    assert Form.read(str(form)) == form
    tree = form.kind.read(EXAMPLES[name], form, {}, [100])
    (key,) = form.kind.readings(tree, form, {}, [100])
    assert form.kind.is_right(key, key, 1e-9)
    assert form.kind.unfit(key) is None
    assert form.kind.change(key, key) == 0
    assert len(key[0]) == form.kind.length == len(set(form.kind.places()))
    # a platform that compares numbers cannot judge what several of them answer
    assert bool(form.kind.many) == (len(form.kind.sealed(key[0])) > 1)
    if not form.kind.is_word:
        assert form.kind.nested(list(key[0])) == EXAMPLES[name]
        assert form.kind.typeset(["1"] * form.kind.length)


class Roots(Kind):
    """Three numbers that are no vector."""

    name = "roots"
    shape = (3,)


class RootFormulas(_Formula, Roots):
    """The same as formulas."""

    name = "root_formulas"


@pytest.mark.parametrize("given", [(7.0, -4.0, 0.0), (0.84, -0.48, 0.36), (7.0, -8.0, 3.0)])
def test_three_numbers_that_are_no_vector_have_no_components(given):
    key, none = ((7.0, -4.0, 3.0),), lambda fit, kind: ()
    unit = tuple(x / math.hypot(*key[0]) for x in key[0])
    given = unit if given[0] < 1 else given
    assert diagnose((given,), key, [], KINDS["vector"], slips=none)
    assert not diagnose((given,), key, [], Roots(), slips=none)


@pytest.mark.parametrize("factor", [-1.0, (1.0, 1.0, 0.5), (1.0, -1.0, 1.0), (1.0, 1.0, 3.01)])
@pytest.mark.parametrize("kinds", [("vector", Roots()), ("vector_expression", RootFormulas())])
def test_the_words_of_components_are_for_vectors(factor, kinds):
    """Also of a whole answer with the opposite sign, and of a listed mistake in one number."""
    keys = ((7.0, -4.0, 3.0), (2.0, 5.0, 1.5), (3.0, 1.0, 2.5))
    factors = np.broadcast_to(factor, 3)
    given = tuple(tuple(factors * x) for x in keys)
    wrong = [
        (
            Cause("listed", "thrice", "takes it thrice"),
            tuple(tuple(3.01 * x for x in k) for k in keys),
        )
    ]

    def words(kind, n):
        some = given[:n], keys[:n]
        causes = diagnose(*some, [(c, x[:n]) for c, x in wrong], kind, {}, slips=lambda *_: ())
        return " ".join(c.text for c in (*causes, *filter(None, [kind.observed(*some)])))

    vector, roots = KINDS[kinds[0]], kinds[1]
    n = len(keys) if vector.is_formula else 1
    assert "component" in words(vector, n)
    assert "component" not in words(roots, n)
    assert [roots.names("x"), vector.names("x")] == [["x_1", "x_2", "x_3"], ["x_x", "x_y", "x_z"]]


@pytest.mark.parametrize("name", KINDS)
def test_a_kind_is_one_object_also_after_copying(name):
    assert pickle.loads(pickle.dumps(KINDS[name])) is KINDS[name]
    assert copy.deepcopy(KINDS[name]) is KINDS[name]
    assert KINDS[name].numeric.is_formula is False


@pytest.mark.parametrize(
    ("point", "words"),
    [
        ((0.0, 1e-17, 3.0), None),
        ((0.0, 0.04, 3.0), None),
        ((0.0, 0.02, 3.0), "with a component of 6.7e-03 of the whole"),
        ((0.0, 0.0, 0.0), None),
        ((0.0, math.nan, 1.0), "= (0.0, nan, 1.0)"),
    ],
)
def test_a_key_with_a_component_that_could_be_left_out_is_unfit(point, words):
    assert KINDS["vector"].unfit((point,)) == words


def test_a_key_is_unfit_below_the_least_share_and_a_formula_that_is_rarely_real(monkeypatch):
    real, nan = (1.0,), (math.nan,)
    assert KINDS["expression"].unfit((real, nan)) is None
    assert "nan at most points" in KINDS["expression"].unfit((real, nan, nan))
    monkeypatch.setattr(tolerance, "COMPONENT", 0.6)
    assert KINDS["vector"].unfit(((3.0, 4.0),)) is None


@pytest.mark.parametrize(
    ("given", "word"),
    [
        ("W", "W"), ("w", "w"), (" w", "w"), ("\u00d6 ", "Ö"), ("O\u0308", "Ö"), ("Ö", "Ö"), ("Z", "z"), ("\uff5a ", "z"), ("cafe\u0301", "café"),
        ("one  Of", "one of"), ("", None), (1.0, None), ("y", None),
    ],
)  # fmt: skip
def test_a_choice_is_read_by_its_word_and_by_capitals_only_where_words_differ_in_these(given, word):
    form = Form("choice", "1", ("w", "W", "z", "café", "one of", "ö", "Ö"))
    read = lambda: form.kind.read(given, form, {}, [100])
    if word:
        assert read() == word
    else:
        with pytest.raises(AnswerError, match="expected one of 'w', 'W'"):
            read()


@pytest.mark.parametrize("text", ["choice", "choice, right wrong", "number: m", "tensor, m"])
def test_a_form_that_names_no_kind_or_a_choice_without_words_is_refused(text):
    with pytest.raises(AnswerError, match=r"a choice lists its words|there are number, vector"):
        Form.read(text)


def test_components_in_two_frames_of_unlike_size_are_those_of_two_vectors():
    vector, form = KINDS["vector"], Form(KINDS["vector"])
    same = {"arm": [3.0, 4.0, 0.0], "ground": [0.0, 0.0, 5.000004]}
    assert len(vector.readings(same, form, {}, [100])) == 2
    with pytest.raises(TreeError, match="those of two vectors"):
        vector.readings(same | {"ground": [0.0, 0.0, 5.000008]}, form, {}, [100])


# -- direction


@pytest.mark.parametrize(("given", "right"), [
    ((0.6, 0.0, -0.8), True), ((-0.6, 0.0, 0.8), True), ((30.0, 0.0, -40.0), True),
    ((-3e-9, 0.0, 4e-9), True), ((0.6, 0.0, 0.8), False), ((0.6, 0.0, -0.81), False),
])  # fmt: skip
def test_a_direction_has_any_length_and_either_sense(given, right):
    assert DIRECTION.is_right((given,), KEY, 1e-6) is right


@pytest.mark.parametrize(("angle", "right"), [(0.00498, True), (0.00502, False)])
def test_a_direction_is_compared_by_the_angle(angle, right):
    c, s = math.cos(angle), math.sin(angle)
    turned = (0.6 * c + 0.8 * s, 0.0, -0.8 * c + 0.6 * s)  # about y
    for scale in (1.0, -250.0):
        assert DIRECTION.is_right((tuple(scale * x for x in turned),), KEY, 1e-6) is right


@pytest.mark.parametrize("scale", [1e308, -1e200, 1e-200, 5e-324])
def test_a_direction_is_read_and_explained_whatever_its_length(scale):
    for given, right in (((3, 0, -4), True), ((3, 0, 4), False)):
        tree = [x / 4 * scale for x in given] if abs(scale) > 1 else [x * scale for x in given]
        (points,) = DIRECTION.readings(tree, Form(DIRECTION), {}, [100])
        assert DIRECTION.is_right(points, KEY, 1e-6) is right
        assert right or diagnose(points, DIRECTION.like(KEY, points), [], DIRECTION)


def test_a_direction_of_length_zero_is_refused_and_others_move_by_the_angle_alone():
    form = Form(DIRECTION)
    with pytest.raises(AnswerError, match="length zero, which has no direction"):
        DIRECTION.read([0, 0, 0], form, {}, [100])
    with pytest.raises(TreeError, match="length zero has no direction"):
        DIRECTION.readings([0, 0.0, 0], form, {}, [100])
    assert not DIRECTION.is_right(((0.0, 0.0, 0.0),), KEY, 1e-6)
    assert DIRECTION.change(((-1.2, 0.0, 1.6),), KEY) == pytest.approx(0.0, abs=1e-15)
    assert DIRECTION.change(((-0.8, 0.0, -0.6),), KEY) == pytest.approx(math.sqrt(2))


def test_a_direction_is_read_in_every_frame_of_a_vector():
    ground = Frame("ground")
    v = ground.rotate("arm", "z", angle=0.5).vector(2.0, 0, 0)
    expect("0/3", axis="direction")
    tree = receipt("0/3", axis=v).answers["axis"]
    assert list(tree) == ["arm", "ground"]
    key = ((-math.cos(0.5), -math.sin(0.5), 0.0),)
    readings = DIRECTION.readings(tree, Form(DIRECTION), {}, [100])
    assert [DIRECTION.is_right(r, key, 1e-6) for r in readings] == [False, True]


def test_wrong_directions_are_explained_whatever_their_length_and_sense():
    swapped = ((-80.0, 0.0, 60.0),)
    key = DIRECTION.like(KEY, swapped)
    assert diagnose(swapped, key, [], DIRECTION, DIRECTION.factors("1")) == (
        exchanged_components((0, 2)),
    )
    nearly = ((-0.603, 0.0, 0.81),)
    assert DIRECTION.observed(nearly, DIRECTION.like(KEY, nearly)) == NEAR


@pytest.mark.parametrize(
    ("key", "tree", "right"),
    [
        (KEY[0], [-6, 0, 8], True),
        (KEY[0], [0.6, 0, -0.8], True),
        (KEY[0], [6, 0, 8], False),
        ((0.0, 3.0, 0.0), [0, -2, 0], True),
    ],
)
def test_the_seal_of_a_direction_opens_for_either_sense(key, tree, right):
    assert opens(seal(DIRECTION, key), DIRECTION, tree) is right
