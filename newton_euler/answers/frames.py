"""Which components of a vector count if it was given along the axes of several frames.

A student may make any frames. If any right components earned the points, frames turned by half a
turn would be four guesses in one answer. One vector is one guess: its components in the ground, as
its frames convert them, are the answer; those in another frame count only where the rest is the
same right vector along other axes.
"""

from collections.abc import Callable, Sequence
from typing import Protocol

from .causes import Cause
from .kinds import Kind
from .tolerance import Points

GROUND = 1  # index among the readings of a vector: in its own frame, in the ground, between


class Toleranced(Protocol):
    """The kind of an answer, and its tolerances, as for :meth:`~.kinds.Kind.is_right`."""

    @property
    def kind(self) -> Kind: ...
    @property
    def atol(self) -> float: ...
    @property
    def rtol(self) -> float: ...


def is_right(asked: Toleranced, given: Points, key: Points) -> bool:
    """True if an answer is near enough to the key for what is asked."""
    return asked.kind.is_right(given, key, asked.atol, asked.rtol)


def counted(
    readings: Sequence[Points],
    key: Points,
    asked: Toleranced,
    wrong: Callable[[], Sequence[tuple[Cause, Points]]],
) -> Points | None:
    """The right one of the readings of an answer, or None.

    wrong : returns [(cause, points)] of the wrong models, which most right answers do not need: of
        the group "axes", the right vector along the axes of the problem's other frames, of which
        the ground is named "0"
    """
    right = [is_right(asked, r, key) for r in readings]
    if True not in right or len(readings) == 1:
        return readings[0] if right == [True] else None
    if right[GROUND] or _is_one_guess(readings, right, key, asked, wrong()):
        return readings[right.index(True)]
    return None


def _is_one_guess(readings, right, key, asked, wrong):
    """True if each reading that is not the key is the right vector along axes of the problem, or,
    as long as the problem leaves the axes of the ground open, may be along axes that the student
    chose, which a known mistake is not.
    """
    axes = {cause.name: points for cause, points in wrong if cause.group == "axes"}
    free = not axes or "0" in axes  # else the axes are those of the ground

    def is_among(r, models):
        return any(is_right(asked, r, points) for points in models)

    mistakes = [points for cause, points in wrong if cause.group != "axes"]
    return all(
        is_among(r, axes.values())
        or (free and (right[0] or place == GROUND) and not is_among(r, mistakes)
            and not is_among(_sizes(r), [_sizes(key)]))
        for place, r in enumerate(readings)
        if not right[place]
    )  # fmt: skip


def _sizes(points):
    """The components without sign and order, which are the same for two guesses at the axes."""
    return tuple(tuple(sorted(map(abs, point))) for point in points)
