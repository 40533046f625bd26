"""Angular velocities and accelerations of frames that share their names: every frame counts.

The oracle is the same chain of frames with names that all differ.
"""

from hypothesis import given
from hypothesis import strategies as st

from newton_euler import Frame, moving
from newton_euler.kinematics import curvilinear
from tests.named_sums import COMPONENTS, NAMES, TRIPLES, by_any_names, check_terms, value

TURNS = st.lists(
    st.tuples(NAMES, st.sampled_from(["x", "-y", "z", (1, 2, 2)]), TRIPLES), min_size=1, max_size=4
)


def chain(turns, names):
    """The first and the last frame of a chain of turns."""
    last = ground = Frame("ground")
    for name, (_, axis, angle) in zip(names, turns, strict=True):
        last = last.rotate(name, axis, moving(*angle))
    return ground, last


def both(turns):
    """The chain with its own names, and with names that all differ."""
    return chain(turns, [t[0] for t in turns]), chain(turns, [f"f{n}" for n in range(len(turns))])


@by_any_names
@given(TURNS)
def test_every_frame_has_its_term_in_the_angular_velocity(turns):
    (ground, last), (other, end) = both(turns)
    parts = [value(v) for v in end.angular_velocity(other).terms.values()]
    check_terms(last.angular_velocity(ground), parts, [t[0] for t in turns])


@by_any_names
@given(TURNS)
def test_every_frame_and_pair_of_frames_has_its_term_in_the_angular_acceleration(turns):
    (ground, last), (other, end) = both(turns)
    names = [t[0] for t in turns]
    crossed = [f"{u} x {v}" for n, u in enumerate(names) for v in names[n + 1 :]]
    parts = [value(v) for v in end.angular_acceleration(other).terms.values()]
    found = last.angular_acceleration(ground)
    check_terms(found, parts, names + crossed)
    formula = found.explain().latex.partition(r"\tag")[0]
    assert formula.count(r"\times") == len(crossed)  # and none for a frame called "a x b"


@by_any_names
@given(TURNS, COMPONENTS)
def test_seen_from_a_branch_the_frames_of_both_branches_count(turns, angle):
    names = [t[0] for t in turns]
    ground, last = chain(turns, names)
    branch = ground.rotate(names[0], "y", angle, rate=1.5)
    terms = [-branch.angular_velocity(ground).expressed_in(last)]
    terms += last.angular_velocity(ground).terms.values()
    check_terms(last.angular_velocity(branch), [*map(value, terms)], [names[0], *names])


def test_coordinates_of_one_name_keep_all_their_terms():
    q = moving(1.0, 2.0, 3.0), moving(0.5, -1.0, 0.25), moving(0.0, 1.0, 1.0)
    parabolic = lambda u, v, w: ((u**2 - v**2) / 2, u * v, w)
    ground = Frame("ground")
    known, P = (curvilinear(ground, "P", parabolic, *q, tuple(names)) for names in ("uvw", "qqq"))
    for of in (lambda X: X.velocity(ground), lambda X: X.acceleration(ground)):
        a, b = of(known), of(P)
        names = [name.replace("u", "q").replace("v", "q").replace("w", "q") for name in a.terms]
        check_terms(b, [value(v.expressed_in(known.local)) for v in a.terms.values()], names)
