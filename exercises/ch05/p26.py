"""5/26: degrees of freedom, a count and a word, in a problem without numbers."""

from exercises.tools import freedom, mpf, on_ground
from newton_euler import dynamics

BLOCKS = {"first": 1, "second": 1}  # one coordinate each, along the track
PAIRS = 3


def count(bodies=BLOCKS, **constraints):
    return dynamics.degrees_of_freedom(bodies, constraints)


def answers(dof, without):
    """The count with springs and dampers, and the choice for the count without."""
    more = without.count - dof.count
    word = "larger" if more > 0 else "smaller" if more else "unchanged"
    return {"dof": dof, "without": word}


def solve(g):
    # springs and dampers are forces, not constraints
    return answers(count(), count())


def steps(g):
    return {"coordinates": count().unknowns}


def prove(g):
    """By the positions of the blocks, which are independent."""
    return {"dof": freedom(lambda x, y: [x, y], mpf(1), mpf(2)), "without": "unchanged"}


def mistakes(g):
    left, right = (lambda first: first[0] - 1), (lambda second: second[0] - 2)
    return {
        "springs_hold": {"without": "larger"},
        "rigid_link": answers(count(pair=lambda first, second: second[0] - first[0] - 1), count()),
        "outer_pairs_hold": answers(count(left=left, right=right), count()),
        "each_pair": {"dof": PAIRS},
        "pairs_move": {"dof": count().count + PAIRS, "without": "smaller"},
        "two_directions": {"dof": count(dict.fromkeys(BLOCKS, "particle in plane"))},
    }


def draw(g, ax):
    ground, s = on_ground(ax, plane="xz")
    s.ground((0, 0, 0.5), normal=ground.i, size=1)
    s.ground((9, 0, 0.5), normal=-ground.i, size=1)
    s.road([(0, 0, 0), (9, 0, 0)])
    for x in (3, 6):
        s.box((x, 0, 0.5), ground, (1, 1, 1))
    for start, end in ((0, 2.5), (3.5, 5.5), (6.5, 9)):
        s.spring((start, 0, 0.75), (end, 0, 0.75))
        s.damper((start, 0, 0.25), (end, 0, 0.25))
