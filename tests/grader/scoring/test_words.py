"""Words and counts: scored, and diagnosed by the listed mistakes."""

import pytest

from exercises.catalogue import problem
from grader.reports.diagnoses import diagnosis_shares, handed_in
from grader.scoring import score_receipt
from tests.exercises.kinds.thrown import DOF, SLIPS, ball
from tests.making import made as made

PLACE = " (see section 4.10)"  # of the problem made here


def scored(p, **answers):
    parts = score_receipt(p, p.book_values, {"answers": answers}).parts
    return {x.key: x for x in parts if x.key in answers}


def test_a_listed_wrong_word_is_named(made):
    part = scored(ball(made), sense="falls")["sense"]
    assert (part.verdict, part.points, part.diagnosis) == ("wrong", 0, SLIPS["downward"] + PLACE)
    assert part.message == f"not right; it fits a solution that takes downward as positive{PLACE}"


def test_a_listed_wrong_count_is_named_with_all_mistakes_that_give_it(made):
    slips = {"fixed": "forgets that the hook moves", "rigid": "takes the rope for a rod"}
    p = made(
        lambda g: {"dof": lambda: 3},
        wrong=lambda g: {"fixed": {"dof": 2}, "rigid": {"dof": 2}},
        answers=(DOF,),
        mistakes=slips,
    )
    assert scored(p, dof=3)["dof"].verdict == "right"
    assert scored(p, dof=2)["dof"].diagnosis == "; or one that ".join(slips.values()) + PLACE
    assert scored(p, dof=7)["dof"].diagnosis is None
    assert scored(p, dof=True)["dof"].diagnosis is None


MISCOUNTS = [
    ("5/22", 4, "forgets constraints"),
    ("5/22", 8, "counts coordinates in space, and forgets constraints"),
    ("5/27", 0, "takes each constraint off twice"),
    ("5/27", 1, "takes off too many constraints, or forgets coordinates"),
    ("5/27", 6, "counts coordinates in space, and takes no constraint off"),
    ("5/24", 6, "counts coordinates across a line"),
    ("5/26", 6, "takes particles for bodies"),
    ("5/25", 5, "forgets constraints, or counts coordinates that are not free"),
    ("5/25", 1, "movable pulleys; or one that takes off too many constraints"),
    ("5/25", 40, None),
]


@pytest.mark.parametrize(("name", "given", "says"), MISCOUNTS)
def test_degrees_of_freedom_counted_wrongly_are_named_in_any_problem(name, given, says):
    p = problem(name)
    (key, *_) = (a.key for a in p.answers)
    found = score_receipt(p, {}, {"answers": {key: given}}).parts[0].diagnosis
    assert found is None if says is None else says in found


def test_a_mistake_in_a_word_is_not_named_where_the_other_parts_show_none_of_it():
    """Taking the result for a dropped stone gives "east", and an x of its own."""
    p = problem("6/22")
    symbols = p.sympy_symbols()
    dropped = p.wrong(symbols)["dropped_from_the_top"]
    reversed_only = dropped | {"x": -p.solve(symbols)["x"]}
    for given, is_named in ((dropped, True), (reversed_only, False), ({"side": "east"}, True)):
        side = score_receipt(p, {}, {"answers": handed_in(p, given)}).parts[0]
        assert ("dropped from rest" in (side.diagnosis or "")) == is_named


def test_every_listed_mistake_in_a_word_is_named_in_the_report(made):
    p = ball(made)
    assert diagnosis_shares([p], 1)[p.id] == {"named": 4}
