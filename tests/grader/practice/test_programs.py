"""How later quantities follow from earlier ones."""

import math

import pytest

from exercises.catalogue import problem
from grader.practice.quantities import quantities
from grader.practice.relations import relations
from grader.practice.twins import twin
from newton_euler.classroom.practising.programs import Program

SOME = "2/18", "3/27", "4/2", "4/16", "5/16", "6/15", "7/1", "8/8", "9/1", "A/17"


@pytest.mark.parametrize("name", SOME)
def test_with_nothing_replaced_every_quantity_is_the_right_one(name):
    p = twin(problem(name))
    _, right = quantities(p, p.book_values)
    program = Program(relations(p, p.book_values))
    found = {k: program.following(k, {}) for k in right if not isinstance(right[k], (str, int))}
    found = {k: x for k, x in found.items() if x is not None}
    for key, x in found.items():
        assert math.dist(x, right[key]) <= 1e-9 * (math.hypot(*right[key]) or 1), key


def test_a_program_holds_no_formula_in_the_givens_and_computes_what_follows():
    """What depends on the givens alone is a number, so that it gives away no other key."""
    p = problem("4/16")
    data = relations(p, p.book_values)
    assert all(isinstance(a, (float, list)) for _, *args in data["operations"] for a in args)
    assert "argument" not in {op for op, *_ in data["operations"]}
    one, other = (relations(p, {**p.book_values, "omega": w}) for w in (0.6, 0.7))
    assert one != other
    # 2 omega x v_r about Z, with a student's v_r along Y
    p = problem("4/16")
    program = Program(relations(p, p.book_values))
    omega = p.book_values["omega"]
    assert program.following("a_D_coriolis", {"v_r": (0.0, 2.0, 3.0)}) == pytest.approx(
        (-2 * omega * 2.0, 0, 0)
    )
    assert program.earlier["a_D_coriolis"] == ["v_r"]
