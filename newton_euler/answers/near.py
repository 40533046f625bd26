"""Which slips a wrong answer meets more closely than by chance.

**The test.** A slip is at a distance ``gap`` from an answer, no less than what the answer was
rounded by. Of the slips that are as simple or simpler, ``n`` are within a quarter of the size of
the answer; a random answer of ``d`` components at this place would be as near to one of them with
the chance ``n (gap / a quarter)^d``. A slip is named where that is at most :data:`CHANCE`. Counted
over all places, random numbers are named in a quarter of a percent.
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
    def ranks(self) -> list[int]:
        """Their ranks."""
        return [rank for rank, _ in self.slips]


class Slips:
    """What slips make of the answers of a student; of this class itself, none."""

    def ranked(self, key: str) -> Ranked | None:
        """The slips in an answer; None of an answer without slips."""
        return None

    def points(self, key: str) -> int:
        """The number of points at which an answer with slips is compared."""
        return 1

    def at(self, key: str, point: int) -> Any:
        """What such an answer is with each slip at a point: an array (slips, components), or of
        numbers a list of rows.
        """
        raise NotImplementedError

    def of(self, key: str, cause: Cause) -> list[Points]:
        """What the slips of this cause make of an answer; none if it is no slip of this kind."""
        ranked = self.ranked(key)
        places = ranked.places.get(cause, ()) if ranked else ()
        return [self._points(key, n) for n in places]

    def near(self, key: str, fit: Fit, kind: Kind) -> list[tuple[int, Cause, Points]]:
        """[(level, cause, points)] of the slips that an answer is nearer to than by chance."""
        ranked = self.ranked(key)
        if ranked is None or fit.index is None or not 0 < math.hypot(*fit.first[0]) < math.inf:
            return []
        places = (
            _formulas_near(self.at(key, fit.index), fit)
            if kind.is_formula
            else _numbers_near(self.at(key, 0), fit, kind, ranked)
        )
        return [
            (level // 2, cause, kind.like(self._points(key, n), fit.given))
            for n in places
            for level, cause in (ranked.slips[n],)
        ]

    def _points(self, key, place):
        """The points of an answer with one slip."""
        return tuple(tuple(map(float, self.at(key, n)[place])) for n in range(self.points(key)))


NO_SLIPS = Slips()


def _formulas_near(rows, fit):
    """Of formulas: those near at the first point where the key has a value; few are, by chance."""
    given = fit.given[fit.index]
    most = fit.rtol * math.hypot(*given)
    return [n for n, gap in enumerate(_gaps(rows, given)) if gap <= most]


def _numbers_near(rows, fit, kind, ranked):
    given, key = fit.given[0], fit.key[0]
    if not kind.has_size:
        rows = [kind.like((tuple(row),), fit.given)[0] for row in rows]
    size = math.hypot(*given)
    gaps = _gaps(rows, given)
    close = [n for n, gap in enumerate(gaps) if gap <= fit.rtol * size]
    if not close:  # of most answers
        return []
    around = {
        n: tuple(round(x / size, 9) for x in map(float, rows[n]))
        for n, gap in enumerate(gaps)
        if gap <= AROUND * size and math.dist(rows[n], key) > NOISE * size
    }
    nearest = max(fit.rounding, ROUND_OFF * size)
    there = sum(abs(k) > NOISE * fit.sizes[0] for k in key) or 1
    least = max(nearest, NOISE * fit.sizes[0])
    wrong = sum(abs(x - k) > least for x, k in zip(given, key, strict=True))
    found = []
    for n in filter(around.__contains__, close):
        count = len({row for m, row in around.items() if ranked.ranks[m] <= ranked.ranks[n]})
        share = max(gaps[n], nearest) / (AROUND * size)
        limit = CHANCE if gaps[n] <= nearest else CHANCE_ROUNDED
        if count * share**there <= limit and count * share**wrong <= CHANCE_BESIDE:
            found.append(n)
    return found


def _gaps(rows, given):
    """How far each row is from what was given."""
    if isinstance(rows, list):
        return [math.dist(row, given) for row in rows]
    import numpy as np

    with np.errstate(all="ignore"):  # a student may write 1e300
        gaps = rows - np.array(given)
        if gaps.shape[1] == 1:
            return abs(gaps[:, 0]).tolist()
        return ((gaps * gaps).sum(axis=1) ** 0.5).tolist()
