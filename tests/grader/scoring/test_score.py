"""Points: right, wrong, blank, unreadable; the tolerance; formulas; junk of every sort."""

import json
import math

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from exercises.catalogue import Answer, problem, problems
from exercises.variants import draw, evaluate
from grader.scoring import score as scoring
from grader.scoring.score import FORMULA_RTOL, RTOL, Score, close, read, score_receipt
from newton_euler.classroom.answers import record
from newton_euler.classroom.forms import Form

CH04 = problems("ch04")
VALUES = {p.id: draw(p, b"tests of score") for p in CH04}


def trees(p, answers):
    """Answers as a receipt holds them."""
    forms = {a.key: Form(a.kind, a.unit, a.of) for a in p.answers}
    found, faults = record(forms, {n: s.unit for n, s in p.symbols.items()}, answers)
    assert not faults
    return found


def key(p):
    return trees(p, p.solve({**p.sympy_symbols(), **VALUES[p.id]}))


def judged(p, answers, values=None):
    """The one part that matters: {key: Part}."""
    return {
        part.key: part
        for part in score_receipt(p, values or VALUES[p.id], {"answers": answers}).parts
    }


@pytest.mark.parametrize("p", CH04, ids=lambda p: p.id)
def test_the_engines_answer_earns_every_point_without_a_diagnosis(p):
    result = score_receipt(p, VALUES[p.id], {"answers": key(p)})
    assert result.points == result.out_of == len(p.answers)
    assert [(part.verdict, part.diagnosis) for part in result.parts] == [("right", None)] * len(
        p.answers
    )


@pytest.mark.parametrize("p", CH04, ids=lambda p: p.id)
def test_the_answers_to_the_books_numbers_earn_nothing_where_the_numbers_differ(p):
    book = trees(p, p.solve({**p.sympy_symbols(), **p.book_values}))
    right, _ = evaluate(p, scoring._sample(p, VALUES[p.id]))
    books, _ = evaluate(p, scoring._sample(p, p.book_values))
    result = judged(p, book)
    for a in p.answers:
        gap = math.hypot(
            *(np.max(np.abs(x - y)) for x, y in zip(right[a.key], books[a.key], strict=True))
        )
        if gap > 0.01 * math.hypot(*(np.max(np.abs(x)) for x in right[a.key])):
            assert result[a.key].points == 0


def test_no_receipt_at_all_is_blank_and_costs_only_the_points():
    for receipt in (
        None,
        {},
        {"answers": {}},
        {"answers": None},
        {"answers": []},
        "text",
        3,
        [],
        {"faults": "x"},
    ):
        result = score_receipt(problem("4/16"), VALUES["4/16"], receipt)
        assert [(p.verdict, p.points, p.out_of) for p in result.parts] == [("blank", 0, 1)] * 3


def test_a_fault_makes_its_part_unreadable_and_leaves_the_others():
    p = problem("4/16")
    answers = key(p)
    result = score_receipt(
        p, VALUES["4/16"], {"answers": answers, "faults": {"v_D": "expected a vector"}}
    )
    assert [part.verdict for part in result.parts] == ["right", "unreadable", "right"]
    assert result.points == 2


def test_an_error_in_the_cell_is_told_once_for_the_problem():
    result = score_receipt(
        problem("4/1"),
        VALUES["4/1"],
        {"error": "ZeroDivisionError, line 3: float division by zero"},
        note="a copy was graded",
    )
    assert result.note == (
        "a copy was graded; the cell stopped with ZeroDivisionError, line 3: float division by zero"
    )


def test_a_score_survives_json():
    result = score_receipt(problem("4/1"), VALUES["4/1"], {"answers": key(problem("4/1"))})
    assert json.loads(result.json())["points"] == 2
    assert isinstance(result, Score)


# -- tolerance


@pytest.mark.parametrize(
    ("off", "points"), [(0.00499, 1), (-0.00499, 1), (0.00501, 0), (-0.00501, 0)]
)
def test_a_number_may_be_half_a_percent_off_and_no_more(off, points):
    p = problem("4/1")
    answers = {k: v * (1 + off) for k, v in key(p).items()}
    assert [part.points for part in judged(p, answers).values()] == [points] * 2


@pytest.mark.parametrize(("off", "points"), [(0.00499, 1), (0.00501, 0)])
@pytest.mark.parametrize("direction", [(1, 0, 0), (0, 1, 0), (0, 0, 1), (0.6, 0, -0.8)])
def test_a_vector_may_be_half_a_percent_of_its_magnitude_off_in_any_direction(
    off, points, direction
):
    p = problem("4/16")
    a_D = key(p)["a_D"]
    moved = [x + off * math.hypot(*a_D) * e for x, e in zip(a_D, direction, strict=True)]
    assert judged(p, {"a_D": moved})["a_D"].points == points


@pytest.mark.parametrize("digits", [3, 4, 6])
@pytest.mark.parametrize("p", [p for p in CH04 if not p.symbolic], ids=lambda p: p.id)
def test_answers_rounded_to_three_significant_figures_are_right(p, digits):
    answers = json.loads(json.dumps(key(p)), parse_float=lambda x: float(f"{float(x):.{digits}g}"))
    assert all(part.points for part in judged(p, answers).values())


def answer(kind, atol=1e-6, of=()):
    return Answer("x", kind, "1", "", of, atol)


def verdict(a, tree, right):
    """The verdict on a tree for a made-up answer whose key is ``right``."""

    class Nothing:
        id, mistakes, givens = "0/0", {}, {}

        class code:
            @staticmethod
            def solve(g):
                return {"x": right[0]}

        @staticmethod
        def base(sample):
            class G:
                but = staticmethod(lambda **_: None)

            return G

        @staticmethod
        def in_units(results):
            return results

    return scoring._score_part(Nothing, a, tree, {}, right, {}).verdict


@pytest.mark.parametrize(
    ("tree", "expected"),
    [
        (0, "right"),
        (0.9e-6, "right"),
        (-0.9e-6, "right"),
        (1.1e-6, "wrong"),
        (1, "wrong"),
        (1e-300, "right"),
    ],
)
def test_a_key_of_zero_is_compared_with_its_absolute_tolerance(tree, expected):
    assert verdict(answer("number"), tree, (0.0,)) == expected


def test_the_absolute_tolerance_of_a_problem_is_used():
    assert verdict(answer("number", atol=0.1), 0.09, (0.0,)) == "right"
    assert verdict(answer("number", atol=0.1), 0.11, (0.0,)) == "wrong"
    # not where the key is not zero
    assert verdict(answer("number", atol=0.1), 5.09, (5.0,)) == "wrong"


def test_a_zero_component_of_a_vector_is_measured_by_the_whole_vector():
    assert verdict(answer("vector"), [1000.0, 4.9, 0], (1000.0, 0.0, 0.0)) == "right"
    assert verdict(answer("vector"), [1000.0, 5.1, 0], (1000.0, 0.0, 0.0)) == "wrong"


def test_each_bound_of_an_interval_counts_by_itself():
    assert verdict(answer("interval"), [0.1004, 100.4], (0.1, 100.0)) == "right"
    assert verdict(answer("interval"), [0.4, 100.0], (0.1, 100.0)) == "wrong"


@pytest.mark.parametrize(
    ("kind", "of", "right", "tree", "expected"),
    [
        ("count", (), 3, 3, "right"),
        ("count", (), 3, 4, "wrong"),
        ("count", (), 1, True, "wrong"),
        ("count", (), 3, 3.0, "wrong"),
        ("count", (), 3, "3", "wrong"),
        ("choice", ("stable", "unstable"), "stable", "stable", "right"),
        ("choice", ("stable", "unstable"), "stable", "unstable", "wrong"),
        ("choice", ("stable", "unstable"), "stable", ["stable"], "wrong"),
        ("choice", ("stable", "unstable"), "stable", {"a": 1}, "wrong"),
        ("matrix", (), tuple(map(float, range(1, 10))), [1, 2, 3, 4, 5, 6, 7, 8, 9], "right"),
        ("matrix", (), tuple(map(float, range(1, 10))), [1, 4, 7, 2, 5, 8, 3, 6, 9], "wrong"),
        ("matrix", (), tuple(map(float, range(1, 10))), [1, 2, 3], "unreadable"),
        (
            "matrix",
            (),
            tuple(map(float, range(1, 10))),
            [[1, 2, 3], [4, 5, 6], [7, 8, 9]],
            "unreadable",
        ),
    ],
)
def test_counts_words_and_matrices_have_one_way_to_be_right(kind, of, right, tree, expected):
    assert (
        verdict(answer(kind, of=of), tree, right if isinstance(right, tuple) else (right,))
        == expected
    )


# -- formulas

OMEGA, NU, D, TILT = "omega", "nu", "d", "tilt"
SPEED = ["^", ["+", ["^", NU, 2], ["^", ["*", OMEGA, D, ["sin", TILT]], 2]], 0.5]  # 4/2


@pytest.mark.parametrize(
    "tree",
    [
        SPEED,
        [
            "sqrt",
            [
                "+",
                ["*", NU, NU],
                ["*", OMEGA, OMEGA, D, D, ["+", 1, ["*", -1, ["^", ["cos", TILT], 2]]]],
            ],
        ],
        ["*", NU, ["sqrt", ["+", 1.0, ["^", ["/", ["*", OMEGA, D, ["sin", TILT]], NU], 2.0]]]],
        ["*", ["/", "pi", 3.1416], SPEED],
        ["Abs", ["*", -1, SPEED]],
        ["exp", ["log", SPEED]],
        ["+", SPEED, ["*", 1e-6, OMEGA, D]],
    ],
)
def test_equivalent_formulas_are_right(tree):
    assert judged(problem("4/2"), {"speed": tree})["speed"].verdict == "right"


@pytest.mark.parametrize(
    "tree",
    [
        ["*", 1.0002, SPEED],
        ["+", SPEED, ["*", 3e-4, OMEGA, D]],
        ["^", ["+", ["^", NU, 2], ["^", ["*", OMEGA, D, TILT], 2]], 0.5],  # sin x = x for small x
        [
            "^",
            ["+", ["^", NU, 2], ["^", ["*", OMEGA, D, ["sin", ["*", "pi", ["/", TILT, 180]]]], 2]],
            0.5,
        ],
        ["+", NU, ["*", OMEGA, D, ["sin", TILT]]],
        1.234,
        NU,
        "pi",
    ],
)
def test_nearly_equal_formulas_are_wrong(tree):
    assert judged(problem("4/2"), {"speed": tree})["speed"].verdict == "wrong"


def test_a_formula_is_compared_at_the_same_points_for_everyone():
    sample = scoring._sample(problem("4/2"), {})
    again = scoring._sample(problem("4/2"), {})
    assert all((sample[n] == again[n]).all() and len(sample[n]) == scoring.POINTS for n in sample)


def test_a_formula_that_agrees_at_all_but_one_point_is_wrong():
    sample = scoring._sample(problem("4/2"), {})
    right = np.array(evaluate(problem("4/2"), sample)[0]["speed"])
    assert close(right, right, FORMULA_RTOL, 1e-6)
    assert not close(right * [1, 1, 1, 1, 1, 1, 1, 1.01], right, FORMULA_RTOL, 1e-6)


def test_an_imaginary_part_is_not_dropped():
    trick = ["+", SPEED, ["*", 5.0, ["^", -1.0, 0.5]]]
    assert judged(problem("4/2"), {"speed": trick})["speed"].verdict == "unreadable"


# -- junk


def nested(n, tree="omega"):
    for _ in range(n):
        tree = ["sin", tree]
    return tree


JUNK = {
    "nan": float("nan"),
    "inf": float("inf"),
    "minus inf": -float("inf"),
    "huge": 1e308,
    "a long integer": 10**4000,
    "tower": ["^", 9, ["^", 9, 9]],
    "tall tower": ["^", 9, ["^", 9, ["^", 9, 9]]],
    "tower of a symbol": ["^", "omega", ["^", 9.0, ["^", 9.0, 9.0]]],
    "deep": nested(150),
    "too deep": nested(300),
    "much too deep": nested(900),
    "100000 nodes": ["+", *(["*", "omega", 1e-9] for _ in range(33_000))],
    "no arguments": ["+"],
    "no arguments of a power": ["^"],
    "empty": [],
    "empty in empty": [[]],
    "text": "anything",
    "key": "speed",
    "dict": {"a": 1},
    "true": True,
    "nothing in a list": [None],
    "an unknown function": ["exec", 1],
    "attribute": ["__class__", 1],
    "too many": ["^", 1, 2, 3],
    "sin of two": ["sin", 1, 2],
    "0/0": ["/", 0, 0],
    "1/0": ["/", 1, 0],
    "0^-1": ["^", 0, -1],
    "log 0": ["log", 0],
    "root of -1": ["sqrt", -1],
    "acos 2": ["acos", 2.0],
    "complex power": ["^", -8.0, ["/", 1, 3]],
    "operator as a number": [1, 2],
    "nested in a nest": [["+", 1, 2]],
    "surrogate": "\ud800",
    "nul": "\0",
    "html": "<script>",
    "list of lists": [[1, 2], [3, 4]],
}


@pytest.mark.parametrize("name", JUNK)
def test_junk_earns_nothing_and_every_part_is_judged(name):
    for p in (problem("4/1"), problem("4/2"), problem("4/16"), problem("4/5")):
        for tree in (JUNK[name], [JUNK[name]] * 3):
            result = score_receipt(p, VALUES[p.id], {"answers": {a.key: tree for a in p.answers}})
            assert [part.key for part in result.parts] == [a.key for a in p.answers]
            assert result.points == 0
            assert all(
                part.verdict in ("wrong", "unreadable", "blank")
                and part.diagnosis is None
                and part.message.isprintable()
                for part in result.parts
            )


LEAF = st.one_of(
    st.none(),
    st.booleans(),
    st.integers(),
    st.floats(),
    st.text(max_size=5),
    st.sampled_from(
        [
            "omega",
            "nu",
            "d",
            "tilt",
            "pi",
            "+",
            "*",
            "^",
            "/",
            "sin",
            "Abs",
            "atan2",
            "exp",
            "log",
            "sqrt",
        ]
    ),
)
TREE = st.recursive(
    LEAF,
    lambda inner: (
        st.lists(inner, max_size=4) | st.dictionaries(st.text(max_size=3), inner, max_size=2)
    ),
    max_leaves=25,
)
OPERATION = st.recursive(
    st.floats() | st.integers(-9, 9) | st.sampled_from(["omega", "nu", "d", "tilt", "pi"]),
    lambda inner: (
        st.tuples(
            st.sampled_from(
                [
                    "+",
                    "*",
                    "^",
                    "/",
                    "sin",
                    "acos",
                    "exp",
                    "log",
                    "sqrt",
                    "atan2",
                    "Abs",
                    "tan",
                    "cosh",
                ]
            ),
            inner,
            inner,
        ).map(list)
        | st.tuples(
            st.sampled_from(["sin", "acos", "exp", "log", "sqrt", "Abs", "tan", "cosh"]), inner
        ).map(list)
    ),
    max_leaves=30,
)
CALM = settings(max_examples=150, deadline=None, suppress_health_check=list(HealthCheck))


@CALM
@given(TREE, TREE)
def test_score_never_raises_on_anything_that_json_can_hold(tree, other):
    for receipt in (
        tree,
        {"answers": tree, "faults": other, "error": other},
        {"answers": {"speed": tree, "acc_mag": other}, "faults": {"acc_mag": tree}},
    ):
        result = score_receipt(problem("4/2"), VALUES["4/2"], receipt)
        assert [part.key for part in result.parts] == ["speed", "acc_mag"]
        assert result.points == 0
        assert json.loads(result.json())["points"] == 0


@CALM
@given(OPERATION)
def test_score_never_raises_on_formulas_and_gives_points_only_to_right_ones(tree):
    part = judged(problem("4/2"), {"speed": tree})["speed"]
    assert part.points == (part.verdict == "right")
    if part.points:  # then it is right: at other points as well
        sample = {
            "omega": np.array([1.23]),
            "nu": np.array([0.77]),
            "d": np.array([1.31]),
            "tilt": np.array([0.41]),
        }
        given_, right = (
            read(problem("4/2").answers[0], tree, sample),
            np.array(evaluate(problem("4/2"), sample)[0]["speed"]),
        )
        assert close(given_, right, 10 * FORMULA_RTOL, 1e-6)


@CALM
@given(st.lists(st.floats() | st.integers(), min_size=3, max_size=3))
def test_numbers_earn_points_only_within_the_tolerance(numbers):
    p = problem("4/16")
    a_D = key(p)["a_D"]
    part = judged(p, {"a_D": numbers})["a_D"]
    near = all(
        math.isfinite(x) and abs(x) < 1e150 for x in map(float_or_inf, numbers)
    ) and math.dist(numbers, a_D) <= RTOL * math.hypot(*a_D)
    assert part.points == near


def float_or_inf(x):
    try:
        return float(x)
    except OverflowError:
        return math.inf


def test_messages_hold_no_key_and_nothing_unprintable():
    p = problem("4/16")
    numbers = {f"{abs(x):.4g}" for v in key(p).values() for x in v}
    wrong = {k: [2.0 * x + 1 for x in v] for k, v in key(p).items()}
    for part in score_receipt(
        p, VALUES["4/16"], {"answers": wrong, "error": "\x1b[31m\ud800 [/red]"}
    ).parts:
        assert not any(n in part.message for n in numbers if len(n) > 2)
    assert score_receipt(p, VALUES["4/16"], {"error": "\x1b[31m\ud800"}).note.isprintable()
