"""The slips that a wrong answer meets more closely than by chance.

**The test.** A slip is at a distance ``gap`` from an answer, no less than what the answer was
rounded by. Of the slips that are as simple or simpler, ``n`` are within a quarter of the size of
the answer; a random answer of ``d`` components at this place would be as near to one of them with
the chance ``n (gap / a quarter)^d``. A slip is named where that is at most :data:`CHANCE`. Counted
over all places, random numbers are named in a quarter of a percent.
"""

import math
from collections.abc import Callable, Sequence
from typing import Any, NamedTuple

from ..algebra.late import np
from .causes import FACTOR_2, REVERSED, Cause
from .fit import Fit, digits_written, mixed, most_digits, rounding
from .kinds import Kind
from .tolerance import NOISE, ROUND_OFF, Points

# ranks, the simplest first; the two of a pair are equally simple, the second is made less often
FIRST, SIMPLE, RARER, LESS, LEAST = 1, 2, 3, 4, 6

FEW = 3  # slips that are named together, which give zero
AROUND = 0.25  # fraction of the size of an answer, within which slips are counted
ROUNDED = 1e-5  # relative error of a number in a formula that was written in five digits
CHANCE = 0.01  # that a random answer meets a slip that is named, where slips are many
CHANCE_ROUNDED = 0.0005  # CHANCE where it differs by more than the digits written
CHANCE_MET = 0.05  # CHANCE where the slip's own number has few digits
CHANCE_ZEROS = 0.0004  # CHANCE where it agrees in more digits than were written: 2.81 is 2.8100
CHANCE_IN_ONE = 0.1  # share of CHANCE for a slip in the wrong components alone
ALIKE = 0.01  # relative: components have one ratio to their right values if they differ by less
CHANCE_BESIDE = 0.015  # CHANCE where some of its components are right


class Ranked:
    """Slips, each with its rank: the lower, the simpler; two of one level are equally simple."""

    def __init__(self, slips: Sequence[tuple[int, Cause]]):
        self.slips, self.ranks = slips, [rank for rank, _ in slips]
        self._simple: dict[int, tuple[Any, list[tuple[int, Cause]]]] = {}
        self.places: dict[Cause, list[int]] = {}
        for n, (_, cause) in enumerate(slips):
            self.places.setdefault(cause, []).append(n)

    def simple(self, most: int) -> tuple[Any, list[tuple[int, Cause]]]:
        """The places of those whose rank is no higher, an array, and (level, cause) of each."""
        if most not in self._simple:
            places = [n for n, rank in enumerate(self.ranks) if rank <= most]
            causes = [(rank // 2, cause) for rank, cause in (self.slips[n] for n in places)]
            self._simple[most] = np.array(places), causes
        return self._simple[most]


class Singles(NamedTuple):
    """Slips, each with its level, and the answer with each of them at a point, an array (slips,
    components); ``of_symbols``: the answer is computed from symbols alone; ``is_size``: it is the
    size of a single component, which has lost its sign.
    """

    causes: Sequence[tuple[int, Cause]] = ()
    at: Callable[[int], Any] = lambda point: ()
    of_symbols: bool = False
    is_size: bool = False


NO_SINGLES = Singles()


class Slips:
    """The answers of a student with slips in them; of this class itself, none."""

    def ranked(self, key: str) -> Ranked | None:
        """The slips in an answer; None of an answer without slips."""
        return None

    def points(self, key: str) -> int:
        """The number of points at which an answer with slips is compared."""
        return 1

    def at(self, key: str, point: int) -> Any:
        """The answer with each slip at a point: an array (slips, components), or of numbers a list
        of rows.
        """
        return []

    def of(self, key: str, cause: Cause) -> list[Points]:
        """The answers with the slips of this cause; [] if it is not a slip of this kind."""
        ranked = self.ranked(key)
        places = ranked.places.get(cause, ()) if ranked else ()
        return [self._points(key, n) for n in places]

    def singles(self, key: str, most: int) -> Singles:
        """The slips in an answer of rank ``most`` or less, to be tried in pairs."""
        ranked = self.ranked(key)
        places, causes = ranked.simple(most) if ranked else ([], [])
        if not causes:
            return NO_SINGLES

        def at(point):
            return np.asarray(self.at(key, point))[places]

        return Singles(causes, at, self.is_of_symbols(key), self.is_size(key))

    def is_of_symbols(self, key: str) -> bool:
        """True of an answer that is computed from symbols alone."""
        return False

    def is_size(self, key: str) -> bool:
        """True of the size of a single component, in which a slip may turn the sign."""
        return False

    def near(self, key: str, fit: Fit, kind: Kind) -> list[tuple[int, Cause, Points]]:
        """[(level, cause, points)] of the slips that an answer is nearer to than by chance."""
        ranked = self.ranked(key)
        if ranked is None:
            return []
        if not any(map(any, fit.given)):
            return self._giving_zero(key, ranked, fit)
        if not 0 < AROUND * math.hypot(*fit.first[0]) < math.inf:  # 5e-324 has no quarter
            return []
        rows = self.at(key, fit.index if kind.is_formula else 0)
        if places := _near(rows, fit, kind, ranked):
            made = [(n, *ranked.slips[n], self._points(key, n)) for n in places]
            return [(level // 2, cause, kind.like(x, fit.given)) for n, level, cause, x in made]
        may_be_in_part = not isinstance(rows, list) and (kind.has_size or kind.is_formula)
        if not may_be_in_part or not (right := _right(fit)):
            return []
        rows = rows.copy()
        rows[:, right] = [fit.first[1][n] for n in right]
        wrong = [n for n in range(len(fit.first[1])) if n not in right]
        found = [(n, *ranked.slips[n]) for n in _near(rows, fit, kind, ranked, CHANCE_IN_ONE)]
        here = lambda cause: kind.in_part(cause, wrong, fit.first[1])  # noqa: E731
        return [
            (level // 2, here(cause), mixed(self._points(key, n), fit.key, wrong))
            for n, level, cause in found
            if cause.does != FACTOR_2  # named as a factor of these components
        ]

    def _giving_zero(self, key, ranked, fit):
        """The terms of which one cancels the others if it is reversed, if few are as simple; what
        leaves nothing of an answer by itself says no more than the zero.
        """
        noise, rows = NOISE * fit.first[2], self.at(key, fit.index if self.points(key) > 1 else 0)
        found = [n for n, row in enumerate(rows) if max(map(abs, row)) <= noise]
        found = [n for n in found if ranked.slips[n][1].does == REVERSED]
        found = [n for n in found if ranked.ranks[n] == min(ranked.ranks[m] for m in found)]
        points = {n: self._points(key, n) for n in found[: FEW + 1]}
        pairs = (pair for own in points.values() for pair in zip(own, fit.sizes, strict=True))
        left = ((p, size) for p, size in pairs if math.isfinite(size))
        if len(points) > FEW or not all(max(map(abs, p)) <= NOISE * size for p, size in left):
            return []
        return [(k // 2, cause, fit.given) for k, cause in (ranked.slips[n] for n in points)]

    def _points(self, key, place):
        """The points of an answer with one slip."""
        return tuple(tuple(map(float, self.at(key, n)[place])) for n in range(self.points(key)))


NO_SLIPS = Slips()


def _near(rows, fit, kind, ranked, share=1.0):
    """The places of the slips that an answer is nearer to than by this share of the chance."""
    if kind.is_formula:
        return _formulas_near(rows, fit, ranked, share)
    return _numbers_near(rows, fit, kind, ranked, share)


def _right(fit):
    """The places of the components that are right, where others are wrong."""
    given, key, size = fit.first
    near = max(fit.rounding, ROUNDED * size)
    right = [n for n, (x, k) in enumerate(zip(given, key, strict=True)) if abs(x - k) <= near]
    some = any(abs(key[n]) > NOISE * size for n in right)
    return right if some and any(x for n, x in enumerate(given) if n not in right) else []


def _formulas_near(rows, fit, ranked, allowed):
    """The places of the slips that a formula is nearer to than by chance."""
    if fit.is_plain:
        return []
    given, key = fit.given[fit.index], fit.key[fit.index]
    size = math.hypot(*given)
    most, pairs = fit.rtol * size, enumerate(zip(given, key, strict=True))
    close, gaps = _within(most, rows, given)
    off = [n for n, (x, k) in pairs if abs(x - k) > most]
    wrong, more = 1 if _is_multiple(given, key, off) else len(off), _constant(fit)

    def near(n, gaps, most):
        """The number of slips within this distance that are as simple."""
        pairs = zip(gaps, ranked.ranks, strict=True)
        return sum(gap <= most and rank <= ranked.ranks[n] for gap, rank in pairs)

    def is_chance(n):
        if more:  # 10.4 x - 5.2 is met by few digits, such as a half of 10.4
            own = [abs(float(row[0]) - key[0] - more) / abs(more) for row in rows]
            if near(n, own, AROUND) * rounding([more]) > CHANCE_MET * AROUND * abs(more):
                return True
        chance = near(n, gaps, AROUND * size) * (max(gaps[n] / size, ROUNDED) / AROUND) ** wrong
        return gaps[n] > ROUND_OFF * size and chance > allowed * CHANCE

    return [n for n in close if not is_chance(n)]


def _is_multiple(given, key, off):
    """True if these components are a multiple of the key's: they are met as one number is."""
    ratios = [given[n] / key[n] if key[n] else 0.0 for n in off]
    some = len(off) > 1 and all(ratios)
    return some and max(ratios) - min(ratios) <= ALIKE * abs(max(ratios, key=abs))


def _constant(fit):
    """The number by which a formula is more than the key at all points, or 0."""
    if len(fit.key) == 1 or len(fit.key[0]) > 1:
        return 0.0
    off = [x - k for (x,), (k,) in zip(fit.given, fit.key, strict=True) if math.isfinite(x - k)]
    is_one = off and max(off) - min(off) <= NOISE * max(map(abs, off))
    return round(off[0], 9) if is_one else 0.0


def _numbers_near(rows, fit, kind, ranked, allowed):
    given, key = fit.given[0], fit.key[0]
    if not kind.has_size:
        rows = [kind.like((tuple(row),), fit.given)[0] for row in rows]
    size = math.hypot(*given)
    close, gaps = _within(fit.rtol * size, rows, given)
    if not close:  # as for most answers
        return []
    around = {
        n: tuple(round(x / size, 9) for x in map(float, rows[n]))
        for n, gap in enumerate(gaps)
        if gap <= AROUND * size and math.dist(rows[n], key) > NOISE * size
    }
    nearest = max(fit.rounding, ROUND_OFF * size)
    there = sum(abs(k) > NOISE * fit.sizes[0] for k in key) or 1
    least = max(nearest, NOISE * fit.sizes[0])
    off = [n for n, (x, k) in enumerate(zip(given, key, strict=True)) if abs(x - k) > least]
    wrong, written_by = len(off), _typed([given[n] for n in off])
    is_multiple = _is_multiple(given, key, off)
    few = _in_few_digits(rows, around, given, off)
    beside = CHANCE_BESIDE if allowed == 1 else allowed * CHANCE
    loosely = CHANCE_ROUNDED / CHANCE  # share of it where the digits written are not met
    found = []
    for n in filter(around.__contains__, close):
        # an answer met exactly in few digits, such as 7.1, is compared with slips of as few digits
        is_met = n in few and gaps[n] <= NOISE * size
        others = few if is_met else around
        count = len({around[m] for m in others if ranked.ranks[m] <= ranked.ranks[n]})
        # a given alone has the digits of the text
        typed = min(written_by, fit.nearest) if ranked.ranks[n] == FIRST else written_by
        share = (typed if is_met else max(gaps[n], nearest)) / (AROUND * size)
        limit = CHANCE_MET if is_met else CHANCE if gaps[n] <= nearest else CHANCE_ROUNDED
        few_are = beside * (1 if gaps[n] <= nearest else loosely)
        # met loosely, components are not independent evidence: slips of one body lie on a line
        most = there if gaps[n] <= nearest else 1 if is_multiple else 2
        is_few = count * share ** min(there, most) <= limit and (
            wrong >= there or count * share ** min(wrong, most) <= few_are
        )
        met = max(gaps[n], ROUND_OFF * size) / (AROUND * size)
        if is_few or (n not in few and count * met ** min(wrong, most) <= allowed * CHANCE_ZEROS):
            found.append(n)
    return found


def _typed(point):
    """How far rounding may have moved this point, if all components have as many digits as the one
    with most: 2.0 beside 3.775 has lost its zeros.
    """
    digits = most_digits(point)
    places = (math.floor(math.log10(abs(x))) + 1 - digits for x in point if x)
    return min(rounding(point), math.hypot(*(0.5 * 10.0**place for place in places)))


def _in_few_digits(rows, places, given, off):
    """The places of the rows without more decimals than were given in the components ``off``."""
    last = min((digits_written(given[n])[1] for n in off if given[n]), default=0)
    has_few = lambda x: abs(x - round(x, -last)) <= NOISE * abs(x)  # noqa: E731
    return {n for n in places if all(has_few(float(rows[n][m])) for m in off)}


def _within(most, rows, given):
    """The places of the rows within ``most`` of the answer, and the distance of each row; no
    distances for an array none of whose first components is near.
    """
    if isinstance(rows, list):
        gaps = [math.dist(row, given) for row in rows]
        return [n for n, gap in enumerate(gaps) if gap <= most], gaps
    with np.errstate(all="ignore"):  # a student may write 1e300
        if not (abs(rows[:, 0] - given[0]) <= most).nonzero()[0].size:  # faster than any()
            return [], []
        squares = ((column - x) ** 2 for column, x in zip(rows.T, given, strict=True))
        gaps = abs(rows[:, 0] - given[0]) if len(given) == 1 else sum(squares) ** 0.5
        return (gaps <= most).nonzero()[0].tolist(), gaps.tolist()
