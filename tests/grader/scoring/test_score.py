"""Points: right, wrong, blank, unreadable; junk of every sort."""

import pytest

from exercises.catalogue import problem
from grader.scoring.score import score_receipt
from tests.grader.scoring.answered import VALUES, judged, key


def test_no_receipt_at_all_is_blank_and_costs_only_the_points():
    empty = ({"answers": x} for x in ({}, None, []))
    for receipt in (None, {}, *empty, "text", 3, [], {"faults": "x"}):
        result = score_receipt(problem("4/16"), VALUES["4/16"], receipt)
        assert [(p.verdict, p.points, p.out_of) for p in result.parts] == [("blank", 0, 1)] * 3


def test_a_vector_is_right_if_its_components_in_the_ground_are():
    a_D = key(problem("4/16"))["a_D"]
    turned = [a_D[1], -a_D[0], a_D[2]]
    for own, ground, points in ((turned, a_D, 1), (a_D, turned, 0)):
        found = judged(problem("4/16"), {"a_D": {"arm": own, "ground": ground}})["a_D"]
        assert found.points == points
    assert judged(problem("4/16"), {"a_D": {"arm": turned}})["a_D"].verdict == "wrong"
    many = {str(n): a_D for n in range(5)}  # more frames than a vector is read in
    assert judged(problem("4/16"), {"a_D": many})["a_D"].verdict == "unreadable"


def test_faults_and_errors_of_the_cell_leave_the_other_parts():
    p = problem("4/16")
    receipt = {"answers": key(p), "faults": {"v_D": "expected a vector"}}
    result = score_receipt(p, VALUES["4/16"], receipt)
    assert [part.verdict for part in result.parts] == ["right", "unreadable", "right"]
    assert result.points == 2
    error = "ZeroDivisionError, line 3: float division by zero"
    result = score_receipt(
        problem("4/1"), VALUES["4/1"], {"error": error}, note="a copy was graded"
    )
    assert result.note == f"a copy was graded; the cell stopped with {error}"
    assert judged(problem("4/16"), {"a_D": [0.0, 0.0, 5e-324]})["a_D"].verdict == "wrong"


# -- junk


def nested(n, tree="omega"):
    for _ in range(n):
        tree = ["sin", tree]
    return tree


JUNK = {
    "nan": float("nan"),
    "inf": float("inf"),
    "huge": 1e308,
    "a long integer": 10**4000,
    "tall tower": ["^", 9, ["^", 9, ["^", 9, 9]]],
    "tower of a symbol": ["^", "omega", ["^", 9.0, ["^", 9.0, 9.0]]],
    "deep": nested(150),
    "much too deep": nested(900),
    "100000 nodes": ["+", *(["*", "omega", 1e-9] for _ in range(33_000))],
    "no arguments": ["+"],
    "empty": [],
    "text": "anything",
    "dict": {"a": 1},
    "true": True,
    "nothing in a list": [None],
    "an unknown function": ["exec", 1],
    "attribute": ["__class__", 1],
    "too many": ["^", 1, 2, 3],
    "0/0": ["/", 0, 0],
    "0^-1": ["^", 0, -1],
    "log 0": ["log", 0],
    "root of -1": ["sqrt", -1],
    "complex power": ["^", -8.0, ["/", 1, 3]],
    "operator as a number": [1, 2],
    "nested in a nest": [["+", 1, 2]],
    "surrogate": "\ud800",
    "nul": "\0",
    "html": "<script>",
    "list of lists": [[1, 2], [3, 4]],
    "the angle of a complex number": ["atan2", ["^", -1, 0.5], "omega"],
    "two numbers compared that are complex": ["<", ["^", -1, 0.5], "omega"],
    "components in no frame": {},
    "components in many frames": {str(n): [1, 2, 3] for n in range(1000)},
    "two vectors in two frames": {"arm": [1, 2, 3], "ground": [3, 2, 2]},
    "frames in frames": {"arm": {"arm": [1, 2, 3]}},
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


def test_messages_hold_no_key_and_nothing_unprintable():
    p = problem("4/16")
    numbers = {f"{abs(x):.4g}" for v in key(p).values() for x in v}
    wrong = {k: [2.0 * x + 1 for x in v] for k, v in key(p).items()}
    receipt = {"answers": wrong, "error": "\x1b[31m\ud800 [/red]"}
    for part in score_receipt(p, VALUES["4/16"], receipt).parts:
        assert not any(n in part.message for n in numbers if len(n) > 2)
    assert score_receipt(p, VALUES["4/16"], {"error": "\x1b[31m\ud800"}).note.isprintable()


def test_the_value_that_was_read_is_shown_with_its_unit_on_one_line():
    p = problem("4/16")
    answers = {"alpha_CD": [1, 2.5, 3], "v_D": {"rod\x1b[2J\n": [1, 2, 3]}, "a_D": "text"}
    read = {x.key: x.read for x in score_receipt(p, p.book_values, {"answers": answers}).parts}
    assert read == {
        "alpha_CD": "[1, 2.5, 3] rad/s^2",
        "v_D": "[1, 2, 3] in rod\ufffd[2J , mm/s",
        "a_D": "",
    }
