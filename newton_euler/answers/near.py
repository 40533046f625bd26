"""Which slips a wrong answer meets more closely than by chance.

**The test.** A slip is at a distance ``gap`` from an answer, no less than what the answer was
rounded by. Of the slips that are as simple or simpler, ``n`` are within a quarter of the size of
the answer; a random answer of ``d`` components at this place would be as near to one of them with
the chance ``n (gap / a quarter)^d``. A slip is named where that is at most :data:`CHANCE`. Counted
over all places, random numbers are named in less than half a percent.
"""

import math
from collections.abc import Sequence
from functools import cached_property
from typing import Any

from .causes import Cause
from .fit import Fit
from .kinds import Kind
from .tolerance import NOISE, ROUND_OFF, Points

AROUND = 0.25  # of the size of an answer: where slips are counted
CHANCE = 0.01  # by which a random answer may meet a slip that is named, where slips are many
CHANCE_ROUNDED = 0.0005  # the same where it differs by more than the digits written
CHANCE_BESIDE = 0.05  # the same where some of its components are right


class Ranked:
    """Slips, each with its rank: the lower, the simpler; two of one level are equally simple."""

    def __init__(self, slips: Sequence[tuple[int, Cause]]):
        self.slips = slips
        self.places: dict[Cause, list[int]] = {}
        for n, (_, cause) in enumerate(slips):
            self.places.setdefault(cause, []).append(n)

    @cached_property
    def ranks(self) -> Any:
        """Their ranks, as an array."""
        import numpy as np

        return np.array([rank for rank, _ in self.slips])


class Slips:
    """What slips make of the answers of a student; of this class itself, none."""

    def of_answer(self, key: str) -> tuple[Ranked, Any] | None:
        """The slips in an answer, and what it is with each: an array (slips, points, components);
        None of an answer without slips.
        """
        return None

    def of(self, key: str, cause: Cause) -> list[Points]:
        """What the slips of this cause make of an answer; none if it is no slip of this kind."""
        if (found := self.of_answer(key)) is None:
            return []
        ranked, rows = found
        return [_points(rows[n]) for n in ranked.places.get(cause, ())]

    def near(self, key: str, fit: Fit, kind: Kind) -> list[tuple[int, Cause, Points]]:
        """[(level, cause, points)] of the slips that an answer is nearer to than by chance."""
        import numpy as np

        found = self.of_answer(key)
        if found is None or fit.index is None or not 0 < math.hypot(*fit.first[0]) < math.inf:
            return []
        ranked, rows = found
        with np.errstate(all="ignore"):
            places = (
                _formulas_near(rows, fit)
                if kind.is_formula
                else _numbers_near(rows, fit, kind, ranked.ranks)
            )
        return [
            (ranked.slips[n][0] // 2, ranked.slips[n][1], kind.like(_points(rows[n]), fit.given))
            for n in places
        ]


NO_SLIPS = Slips()


def _points(row):
    return tuple(map(tuple, row.tolist()))


def _formulas_near(rows, fit):
    """Of formulas: those near at the first point where the key has a value; few are, by chance."""
    import numpy as np

    given = np.array(fit.given[fit.index])
    gaps = np.linalg.norm(rows[:, fit.index] - given, axis=-1)
    return np.flatnonzero(gaps <= fit.rtol * np.linalg.norm(given)).tolist()


def _numbers_near(rows, fit, kind, ranks):
    import numpy as np

    given, key = np.array(fit.given[0]), np.array(fit.key[0])
    rows = rows[:, 0]
    if not kind.has_size:
        rows = np.array([kind.like((row,), fit.given)[0] for row in rows.tolist()])
    size = np.linalg.norm(given)
    gaps = np.linalg.norm(rows - given, axis=1)
    around = (gaps <= AROUND * size) & (np.linalg.norm(rows - key, axis=1) > NOISE * size)
    nearest = max(fit.rounding, ROUND_OFF * size)
    there = int((abs(key) > NOISE * fit.sizes[0]).sum()) or 1
    wrong = int((abs(given - key) > max(nearest, NOISE * fit.sizes[0])).sum())
    found = []
    for n in np.flatnonzero(around & (gaps <= fit.rtol * size)):
        others = rows[around & (ranks <= ranks[n])]
        count = len(np.unique(np.round(others / size, 9), axis=0))
        share = max(gaps[n], nearest) / (AROUND * size)
        limit = CHANCE if gaps[n] <= nearest else CHANCE_ROUNDED
        if count * share**there <= limit and count * share**wrong <= CHANCE_BESIDE:
            found.append(int(n))
    return found
