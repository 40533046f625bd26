"""Masses on ropes over pulleys, some of which hang on ropes themselves, after Atwood: 5/24, 5/25.

A machine is a pulley: its name, its radius, and for each end of its rope the length of the run and
its load, the name of a mass or another pulley.
"""

from collections.abc import Callable, Collection, Iterable, Sequence
from typing import TypeAlias

from exercises.annotations import Mistakes, Scalar, Steps
from exercises.tools import Sketch, Step
from newton_euler import Frame
from newton_euler.answers.kinds import KINDS
from newton_euler.dynamics import degrees_of_freedom
from newton_euler.dynamics.constraints import Freedom

Machine: TypeAlias = tuple[str, Scalar, "Run", "Run"]
Run: TypeAlias = tuple[Scalar, str | Machine]

SIZE = 0.45  # size of a mass


def rope(pulley: Sequence[Scalar], left: Sequence[Scalar], right: Sequence[Scalar]) -> Scalar:
    """A constraint for ``degrees_of_freedom``: the rope keeps its length."""
    return left[0] + right[0] - 2 * pulley[0]


def count(names: Iterable[str], **ropes: Callable[..., Scalar]) -> Freedom:
    """Degrees of freedom of the named parts, which move vertically, with these ropes."""
    return degrees_of_freedom(dict.fromkeys(names, 1), ropes)


def steps_to_count(heights: Iterable[str], ropes: Collection[str], phrase: str) -> Steps:
    """Heights and ropes; ``phrase`` describes the heights."""
    yield Step("heights", count(heights).unknowns, "1", phrase, "5.11", kind=KINDS["count"])
    yield Step("ropes", len(ropes), "1", "constraints: each rope keeps its length", "5.11", "5.28",
               kind=KINDS["count"])  # fmt: skip


def miscounts(masses: Iterable[str], heights: Iterable[str], ropes: Collection[str]) -> Mistakes:
    """Wrong counts of degrees of freedom."""
    return {
        "no_pulleys": {"dof": count(masses).count - len(ropes)},
        "masses_only": {"dof": count(masses)},
        "no_ropes": {"dof": count(heights)},
    }


def draw_machine(s: Sketch, frame: Frame, machine: Machine) -> None:
    """The machine in the (x, z) plane of ``frame``, under a ceiling."""
    radius = machine[1]
    z = 1.6 * radius
    s.road([(2 * radius, 0, z), (-2 * radius, 0, z)])
    s.rod((0, 0, z), (0, 0, 0))
    _hang(s, frame, machine, (0, 0, 0))


def _hang(s, frame, machine, C):
    name, radius, *ends = machine
    sides = zip((-1, 1), ends, strict=True)
    places = [(C[0] + side * radius, 0, C[2] - run) for side, (run, _) in sides]
    s.cable(places[0], s.pulley(C, frame.j, radius), places[1])
    s.label((C[0], 0, C[2] - 0.6 * radius), name, offset=(0, 0), bold=False)
    for (x, _, z), (_, load) in zip(places, ends, strict=True):
        if isinstance(load, str):
            s.box((x, 0, z - SIZE / 2), frame, (SIZE, SIZE, SIZE))
            s.label((x, 0, z - SIZE / 2), load, offset=(0, 0), bold=False)
        else:
            _hang(s, frame, load, (x, 0, z))
