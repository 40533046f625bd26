"""Degrees of freedom (5.11), (5.28), Table 5-1: counted by rank, against the counts of Chapter 5;
redundant, singular and impossible constraints.
"""

import pytest
import sympy

from newton_euler import cos, sin, sqrt
from newton_euler.dynamics import ConstraintError, degrees_of_freedom
from newton_euler.dynamics.constraints import KINDS


def squared(P, Q):
    return sum((a - b) ** 2 for a, b in zip(P, Q, strict=True))


def end(B, length):
    """The far end of a bar in the plane, from its first end and its angle."""
    return B[0] + length * cos(B[2]), B[1] + length * sin(B[2])


def meet(P, Q):
    return P[0] - Q[0], P[1] - Q[1]


def count(bodies, constraints=None, **options):
    return degrees_of_freedom(bodies, constraints, **options).count


@pytest.mark.parametrize(
    ("kind", "dof"), [("particle in plane", 2), ("particle", 3), ("body in plane", 3), ("body", 6)]
)
def test_table_5_1_free_particles_and_bodies(kind, dof):
    assert count({"B": kind}) == dof == KINDS[kind]


@pytest.mark.parametrize("surfaces", [0, 1, 2, 3])
def test_eqn_5_28_each_independent_constraint_takes_one_away(surfaces):
    """3 - L for a particle under L surfaces f(x, y, z) = 0."""
    sphere, plane = lambda P: squared(P, (0, 0, 0)) - 1, lambda P: P[0] + 2 * P[1] - P[2] / 3
    f = [("sphere", sphere), ("plane", plane), ("saddle", lambda P: P[2] - P[0] * P[1] - 0.1)]
    assert count({"P": "particle"}, dict(f[:surfaces])) == 3 - surfaces
    assert count({"P": "particle"}, {"z = 0": lambda P: P[2]}) == 2  # plane motion


HEIGHT, PLANAR = "particle on line", "particle in plane"


CONE_AND_STRING = {  # problem 5/28
    "cone": lambda P: P[2] ** 2 - 3 * (P[0] ** 2 + P[1] ** 2),
    "string": lambda P, Q: sqrt(squared(P, (0, 0, 0))) + sqrt(squared(Q, (0, 0, 0))) - 1,
}


@pytest.mark.parametrize("angle", [0.1, 1.0, 2.5, 4.0])
def test_the_count_does_not_depend_on_the_configuration(angle):
    bodies = {"P": "particle", "Q": "particle"}
    r = 0.1 + angle / 20
    P, Q = (r * cos(angle), r * sin(angle), sqrt(3) * r), (0.0, 0.6 - 1.2 * r, -0.8 + 1.6 * r)
    at = {"P": P, "Q": Q}
    found = degrees_of_freedom(bodies, CONE_AND_STRING, at=at)
    assert (found.count, found.singular) == (count(bodies, CONE_AND_STRING), False) == (4, False)


@pytest.mark.parametrize(("L", "factor"), [(1.0, 1.0), (1e6, 1.0), (1.0, 1e6), (1e-3, 1e-6)])
def test_the_count_does_not_depend_on_units(L, factor):
    """Lengths in metres or micrometres; the constraint in square metres or a million times that."""
    rod = lambda P: factor * (squared(P, (0, 0, 0)) - L * L)
    assert count({"P": "particle"}, {"rod": rod, "plane": lambda P: P[1]}) == 1


def four_bar(crank, coupler, follower, base):
    return {"c": "body in plane", "r": "body in plane", "f": "body in plane"}, {
        "A0": lambda c: (c[0], c[1]),
        "A": lambda c, r: meet(end(c, crank), r),
        "B": lambda r, f: meet(end(r, coupler), f),
        "B0": lambda f: meet(end(f, follower), (base, 0)),
    }


def test_four_bar_linkage_and_a_redundant_parallel_bar():
    """A double parallelogram has a fifth bar: counting equations gives 0, yet it moves."""
    bodies, joints = four_bar(1.0, 2.5, 2.0, 3.0)
    found = degrees_of_freedom(bodies, joints)
    assert (found.count, found.unknowns, found.rank, found.redundant) == (1, 9, 8, {})
    assert int(f"{found.count}") == found.__index__() == 1
    same = degrees_of_freedom(bodies, {**joints, "A again": joints["A"]})
    assert (same.count, same.redundant) == (1, {"A again": 2})
    assert "redundant: A again, 2 of its equations follow from the constraints before it" in str(
        same
    )


def test_two_constraints_in_one_need_not_all_be_redundant():
    found = degrees_of_freedom({"P": 3}, {"plane": lambda P: P[2], "line": lambda P: (P[2], P[1])})
    assert (found.count, found.redundant) == (1, {"line": 1})


def test_a_dead_point_is_singular():
    """A flat parallelogram of four bars: two degrees of freedom at that instant, one nearby."""
    bodies, joints = four_bar(1.0, 2.0, 1.0, 2.0)
    flat = {"c": (0.0, 0.0, 0.0), "r": (1.0, 0.0, 0.0), "f": (3.0, 0.0, 3.141592653589793)}
    found = degrees_of_freedom(bodies, joints, at=flat)
    assert (found.count, found.singular) == (2, True)
    assert "the configuration is singular" in str(found)
    assert found.configuration["r"] == (1.0, 0.0, 0.0)
    general = degrees_of_freedom(bodies, joints)
    assert (general.count, general.singular) == (1, False)


def test_forces_are_not_constraints_and_a_refusal_says_how_to_pass_a_configuration():
    free = {"A": HEIGHT, "B": HEIGHT}
    assert count(free) == count(free, {}) == 2  # the call takes no springs or dampers
    with pytest.raises(ConstraintError, match=r"If not, pass one as at=\{'P': \.\.\.\}"):
        degrees_of_freedom({"P": "particle on line"}, {"a": lambda P: P[0] ** 2 + 1})
    # Newton's method gets stuck at the minimum at 0
    far = {"far": lambda P: (P[0] ** 2 + 4) * (P[0] - 1e3)}
    assert count({"P": "particle on line"}, far, at={"P": (1e3,)}) == 0


@pytest.mark.parametrize(("constraints", "match"), [
    ({"a": lambda P: P[0], "b": lambda P: P[0] - 1}, r"no configuration was found for all constraints \(a, b\)"),
    ({"pole": lambda P: P[0] ** 2 + P[1] ** 2}, "the gradient of the constraint 'pole' vanishes: split it"),
    ({"a": lambda P, Z: P[0]}, r"constraint 'a' takes \['P', 'Z'\], not P"),
    ({"a": lambda P: P[0] * sympy.Symbol("L")}, "put numbers in"),
    ({"a": lambda P: P[0] * float("nan")}, "is nan at some place; write it with a value everywhere"),
])  # fmt: skip
def test_constraints_that_cannot_be_counted_are_refused(constraints, match):
    with pytest.raises(ConstraintError, match=match):
        degrees_of_freedom({"P": "particle"}, constraints)


def test_what_a_constraint_raises_arrives_as_raised_with_its_name():
    words = r"float division by zero\nthe constraint 'a' fails"
    with pytest.raises(ZeroDivisionError, match=words):
        degrees_of_freedom({"P": "particle"}, {"a": lambda P: P[0] - 1 / (P[1] - P[1])})
    with pytest.raises(IndexError, match="tuple index out of range") as caught:
        degrees_of_freedom({"P": "particle"}, {"a": lambda P: P[5]})
    assert caught.value.__notes__ == ["the constraint 'a' gets coordinates: P 3"]


@pytest.mark.parametrize(("kind", "at", "match"), [
    ("point", None, r"P is a number of coordinates, or particle, .* got 'point'"),
    (PLANAR, {"P": (2.0, 0.0)}, "does not meet the constraint 'rod': it is 3 instead of 0"),
    (PLANAR, {"Q": (1.0, 0.0)}, r"at= gives the coordinates of P; it has Q"),
    (PLANAR, {"P": (1.0, 0.0, 0.0)}, "at= holds 3 numbers; the bodies have 2 coordinates"),
])  # fmt: skip
def test_a_wrong_kind_or_place_is_refused(kind, at, match):
    with pytest.raises(ConstraintError, match=match):
        degrees_of_freedom({"P": kind}, {"rod": lambda P: squared(P, (0, 0)) - 1}, at=at)
