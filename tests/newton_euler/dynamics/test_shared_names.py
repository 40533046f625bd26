"""Sums of forces, moments and energies whose terms share their names: every term counts."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from newton_euler import Couple, Force, ForceSystem, Frame, dynamics, kinetic_energy, moving
from newton_euler.algebra.linear import solve_linear
from newton_euler.bodies import particle
from tests.named_sums import NAMES, TRIPLES, by_any_names, check_terms, value

LOADS = st.lists(st.tuples(NAMES, TRIPLES, TRIPLES | st.none()), min_size=1, max_size=5)


def system(loads, ground):
    """Forces at points; a load without a point is a couple."""
    force = lambda name, v, r: Force(ground.vector(*v), ground.point("P", *r), name)
    couple = lambda name, v: Couple(ground.vector(*v), name)
    return [force(name, v, r) if r else couple(name, v) for name, v, r in loads]


def added(parts, ground):
    """The parts added at once, from the left, from the right, and in halves, in the same order."""
    one = [ForceSystem([part], ground) for part in parts]
    left = right = ForceSystem([], ground)
    for first, last in zip(one, one[::-1], strict=True):
        left, right = left + first, last + right
    half = len(one) // 2
    pairs = ForceSystem([ForceSystem(one[:half], ground), ForceSystem(one[half:], ground)], ground)
    return ForceSystem(parts, ground), left, right, pairs


@by_any_names
@given(LOADS, TRIPLES)
def test_resultant_and_moment_are_sums_over_all_forces_however_they_were_added(loads, about):
    ground = Frame("ground")
    O = ground.point("O", *about)
    forces = [(name, np.array(v)) for name, v, r in loads if r is not None]
    arm = lambda r: np.subtract(r, about)
    moments = [np.cross(arm(r), v) if r else np.array(v) for _, v, r in loads]
    for s in added(system(loads, ground), ground):
        check_terms(s.force, [v for _, v in forces], [name for name, _ in forces])
        check_terms(s.moment(O), moments, [name for name, _, _ in loads])
        assert len({line.partition(":")[0] for line in str(s).split("\n")}) == len(loads)


@by_any_names
@given(st.permutations([(1, 0, 0), (0, 2, 0), (0, 0, 4)]), NAMES)
def test_a_ball_is_accelerated_by_every_force_on_it(vectors, name):
    ground = Frame("ground")
    loads = [ForceSystem([Force(ground.vector(*v), ground.origin, name)]) for v in vectors]

    def laws(x, y, z):
        G = ground.point("G", moving(0, 0, x), moving(0, 0, y), moving(0, 0, z))
        ball = particle(2.0, G)
        return dynamics.equations_of_motion(ball, [loads[0] + loads[1], loads[2]], ground)[
            "force on particle"
        ]

    assert tuple(solve_linear(laws)) == (0.5, 1.0, 2.0)


def test_equations_of_two_bodies_of_one_name_are_both_kept():
    ground = Frame("ground")
    along, over = ground.i, ground.point("P", 1.0, 0, 0)

    def laws(a, R):
        first, second = (particle(m, ground.point("G", moving(0, 0, a), 0, 0)) for m in (1.0, 3.0))
        one = dynamics.equations_of_motion(first, [(R * along, over)], ground)
        two = [(8.0 * along, over), (-R * along, over)]
        return one | dynamics.equations_of_motion(second, two, ground)

    found = solve_linear(laws)
    assert (found.a, found.R) == (2.0, 2.0)


@by_any_names
@given(st.lists(st.tuples(NAMES, TRIPLES, TRIPLES), min_size=1, max_size=4))
def test_kinetic_energy_and_angular_momentum_are_sums_over_all_bodies(bodies):
    ground = Frame("ground")
    parts = [particle(2.0, ground.point("P", *map(moving, r, v)), name) for name, r, v in bodies]
    energies = [np.dot(v, v) for _, _, v in bodies]
    check_terms(kinetic_energy(parts, ground), energies, [name for name, _, _ in bodies])
    spin = sum(2 * np.cross(r, v) for _, r, v in bodies)
    about = ground.point("O", 0, 0, 0)
    total = sum(value(dynamics.angular_momentum(p, ground, about)) for p in parts)
    assert np.allclose(total, spin, atol=1e-12)


@pytest.mark.parametrize("name", ["inertia", "origin", "coriolis", "euler", "centrifugal"])
def test_a_force_may_have_the_name_of_a_term_of_the_motion(name):
    ground = Frame("ground")
    disk = ground.rotate("disk", "z", rate=2.0, acceleration=1.0)
    P = disk.point("P", moving(3.0, rate=1.0), 0, 0)
    F = 5.0 * disk.i
    R = dynamics.reaction(2.0, P.acceleration(ground), **{name: F})
    assert np.allclose(value(R), value(2.0 * P.acceleration(ground) - F))
    assert np.allclose(value(sum(R.terms.values())), value(R))
    a = dynamics.relative_acceleration(2.0, P, ground, **{name: F})
    assert np.allclose(value(a), value(dynamics.relative_acceleration(2.0, P, ground, spring=F)))
    assert np.allclose(value(sum(a.terms.values())), value(a))
    check_terms(dynamics.acceleration_by(2.0, **{name: F}), [value(F) / 2], [name])


def test_a_force_is_not_explained_as_the_term_of_the_motion_whose_name_it_has():
    ground = Frame("ground")
    R = dynamics.reaction(2.0, ground.vector(0, 0, 3.0), inertia=ground.i)
    _, *rows = str(R.explain()).split("\n")
    assert [row.split()[:4] for row in rows[:2]] == [
        ["inertia", "1", "m", "a"], ["minus", "inertia", "2", "-F"]
    ]  # fmt: skip
    formulas = R.explain().latex.partition(r"\tag")[0]
    assert formulas.endswith(r"m\bar{\mathbf{a}} - {\mathbf{F}}_{\text{inertia 2}} ")
    P = ground.point("P", 1.0, 0, 0)  # seen from its own frame: the motion has no term
    a = dynamics.relative_acceleration(2.0, P, ground, coriolis=ground.i)
    assert "omega" not in str(a.explain())
    assert "omega" not in a.explain().latex.partition(r"\tag")[0]


@by_any_names
@given(st.dictionaries(NAMES, TRIPLES, max_size=4), st.dictionaries(NAMES, TRIPLES, max_size=4))
def test_an_energy_balance_counts_every_potential_and_every_work(potentials, powers):
    in_time = lambda c: lambda t: c[0] + c[1] * t
    given = ({name: in_time(c) for name, c in x.items()} for x in (potentials, powers))
    found = dynamics.audit(lambda t: 2.0 * t, 0.0, 2.0, *given)
    change = 4.0 + sum(2 * c[1] for c in potentials.values())
    work = sum(2 * c[0] + 2 * c[1] for c in powers.values())
    assert float(found.energy) == pytest.approx(change, abs=1e-9)
    assert float(found.residual) == pytest.approx(change - work, abs=1e-9)
    assert float(found.heat()) == pytest.approx(-work, abs=1e-9)
