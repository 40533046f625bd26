"""Which components of a vector in several frames count."""

import itertools
import math
from dataclasses import dataclass

import pytest

from newton_euler import Frame
from newton_euler.answers.causes import other_axes, turned_the_wrong_way
from newton_euler.answers.kinds import KINDS, Kind
from newton_euler.answers.tolerance import RTOL
from newton_euler.answers.verdicts import counted
from tests.newton_euler.answers.one_answer import one

KEY = ((-9.6, 6.25, -3.6),)
ARM = ((6.25, 9.6, -3.6),)  # the same vector along the axes of the problem's arm


@dataclass(frozen=True)
class Asked:
    kind: Kind = KINDS["vector"]
    atol: float = 1e-6
    rtol: float = RTOL


def along(axes):
    """The wrong models that give the key along other axes, from {place: points}."""
    return lambda: [(other_axes(place, "another frame"), x) for place, x in axes.items()]


def turned(components, *turns):
    """The readings of a vector with these components in a frame made by these turns."""
    frame = Frame("ground")
    for axis, angle in turns:
        frame = frame.rotate("mine", axis, angle=angle, rate=1.0)
    return readings(frame.vector(*components))


def readings(vector):
    """The components of a vector as a receipt reads them, one point per frame."""
    tree = one("vector, m", vector)
    return [(tuple(x),) for x in (tree.values() if isinstance(tree, dict) else [tree])]


@pytest.mark.parametrize("axes", [{}, {0: ARM}, {1: ARM}], ids=["none", "turning", "ground"])
def test_of_all_patterns_of_sign_in_frames_of_half_a_turn_one_is_right(axes):
    for signs in itertools.product((1, -1), repeat=3):
        guess = [s * x for s, x in zip(signs, KEY[0], strict=True)]
        given = turned(guess, *((axis, math.pi) for axis in "xyx"))
        assert len(given) == 4
        found = counted(given, KEY, Asked(), along(axes))
        assert (found is not None) == (signs == (-1, 1, -1))  # as seen from the ground


@pytest.mark.parametrize("turns", [
    [("z", 0.7)], [("z", 0.7), ("-x", 2.1)], [("z", math.pi)], [("x", math.pi / 2), ("y", 0.2)],
])  # fmt: skip
def test_a_vector_is_right_in_whatever_frame_it_is_given(turns):
    """Its components in the ground decide."""
    frame = ground = Frame("ground")
    for axis, angle in turns:
        frame = frame.rotate("arm", axis, angle=angle, rate=1.0)
    given = readings(ground.vector(*KEY[0]).expressed_in(frame))
    assert len(given) == len(turns) + 1
    assert counted(given, KEY, Asked(), along({1: ARM}))[0] == pytest.approx(KEY[0])


def test_the_axes_asked_for_may_be_those_of_a_frame_that_turns():
    """The other components are then those along the problem's other axes."""
    quarter = turned(KEY[0], ("z", math.pi / 2))
    ground = quarter[1]
    assert counted(quarter, KEY, Asked(), along({0: ground})) == KEY
    assert counted(quarter, KEY, Asked(), along({0: ARM})) is None


@pytest.mark.parametrize(("axes", "right"), [
    ({}, True), ({0: ARM}, True), ({1: ARM}, False),
], ids=["no other axes", "axes that turn", "axes of the ground"])  # fmt: skip
def test_a_ground_that_the_problem_does_not_place_may_lie_as_a_student_chose(axes, right):
    found = counted(turned(KEY[0], ("z", 0.7)), KEY, Asked(), along(axes))
    assert found == (KEY if right else None)


@pytest.mark.parametrize("axis", ["x", "z", (1, 1, 1)])
def test_such_a_ground_does_not_make_the_components_another_guess(axis):
    angle = 2 * math.pi / 3 if axis == (1, 1, 1) else math.pi / 2
    assert counted(turned(KEY[0], (axis, angle)), KEY, Asked(), along({})) is None


@pytest.mark.parametrize("axes", [{}, {0: ARM}])
def test_such_a_ground_does_not_excuse_a_known_mistake(axes):
    """Such a mistake is a turn the wrong way, undone by a frame of twice the angle."""
    given = turned(KEY[0], ("z", 0.7))
    mistake = turned_the_wrong_way(1, "the arm"), given[1]
    assert counted(given, KEY, Asked(), lambda: [*along(axes)(), mistake]) is None


def test_of_directions_in_a_chain_of_frames_at_most_two_are_guesses():
    """Only the components in the student's own frame and in the ground the student placed are
    guesses; the frames between are neither.
    """
    steps = [("z", 0.5), ("z", 0.6), ("z", 0.7)]
    passed = 0
    for place in range(4):
        frames = [Frame("ground")]
        for axis, angle in steps:
            frames.append(frames[-1].rotate("mine", axis, angle=angle, rate=1.0))
        vector = frames[place].vector(*KEY[0]).expressed_in(frames[-1])
        passed += counted(readings(vector), KEY, Asked(), along({})) is not None
    assert passed == 2
