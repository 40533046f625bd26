"""Two mistakes at once, where no single one explains an answer: one of the problem's own, the
opposite sign or a factor of 2, and another. What they change is added, as of terms, or multiplied,
as of factors, or stands under one root.

A number meets some pair by chance. Of formulas in symbols alone a pair must give all digits at all
points; of numbers, all pairs that are as simple and near count as tried. Two slips in the
computation are never named: they would explain guesses, too.
"""

import math
from collections.abc import Callable, Iterator, Sequence
from fractions import Fraction
from functools import cached_property
from itertools import chain
from typing import Any

from ..algebra.late import is_here, np
from . import causes
from .causes import OPPOSITE_NUMBER, Cause, both
from .fit import Fit
from .kinds import Kind
from .near import AROUND, FIRST, Singles
from .slips import PURE
from .tolerance import NOISE, ROUND_OFF, Points

(TWO, *_) = PURE
SIMPLE, FEW = 12, 4  # the largest denominator of a simple number in a formula, in a number
CHANCE = 0.005  # that a random answer meets a pair that is named


def of_two(
    fit: Fit,
    kind: Kind,
    own: Sequence[tuple[Cause, Points]],
    slips: Callable[[], Singles],
    is_contradicted: Callable[[Cause], bool],
) -> tuple[Cause, ...]:
    """The two mistakes that give an answer together, as one cause: the simplest two, of numbers
    only if there are no others as simple; () if no pair can be named in few words.

    own : the models of the problem's own mistakes
    slips : finds those that may be made beside one of them
    """
    none = fit.is_plain or not (kind.has_size or kind.is_formula)
    if none or not is_here("numpy"):  # as on a page of the site
        return ()
    found: dict[int, dict[tuple[Cause, ...], None]] = {}
    pairs = _Pairs(fit, kind, own, slips())
    for level, pair in pairs.fitting():
        if not any(map(is_contradicted, pair)):
            found.setdefault(level, {})[pair] = None
    simplest = [*found[min(found)]] if found else []
    is_one = len(simplest) == 1 or kind.is_formula
    named = (both(*pair) if len(pair) > 1 else pair[0] for pair in simplest if is_one)
    first = next(filter(None, named), None)
    return (first,) if first else pairs.multiple()


def _turns(cause):
    """True of a mistake after which a size may be that of a component of the other sign."""
    return cause.group == "unit" or cause.does in (causes.REVERSED, causes.LEFT_OUT, causes.ZERO)


class _Pairs:
    """The pairs that an answer meets. Each of the ``rows`` is the answer with a single mistake: the
    first ``own`` are the problem's own mistakes and a factor of 2, the last the opposite sign.
    """

    def __init__(self, fit, kind, own, slips):
        self.fit, self.kind, self.own, self.models, self.slips = fit, kind, len(own) + 2, own, slips
        self.of_symbols = kind.is_formula and slips.of_symbols
        self.exactly = fit.rtol if kind.is_formula and not self.of_symbols else ROUND_OFF

    @cached_property
    def causes(self) -> list[tuple[int, Cause]]:
        """(how simple, the cause) of each row; the opposite sign has words of its own, which are
        shorter.
        """
        opposite = self.fit.times(-1.0)
        own = [(4 if x == opposite else 2 * (c.group != "listed"), c) for c, x in self.models]
        own += [(2, causes.multiplied(TWO, 2.0, large)) for large in (True, False)]
        return [*own, *((n + 2, c) for n, c in self.slips.causes), (1, OPPOSITE_NUMBER)]

    def at(self, point: int) -> tuple[Any, Any]:
        """(key, rows) at a point."""
        key, own = self.fit.key[point], [x[point] for _, x in self.models]
        own += [[n * x for x in key] for n in (2.0, 0.5, -1.0)]
        rows, slips = np.array(own, float), np.array(self.slips.at(point), float)
        parts = rows[:-1], slips.reshape(-1, len(key)), rows[-1:]
        return np.array(key, float), np.concatenate(parts)

    def fitting(self) -> Iterator[tuple[int, tuple[Cause, ...]]]:
        """(level, the two causes) of each pair that is met; one cause that turns a sign as well."""
        with np.errstate(all="ignore"):
            for i, j in [*self._near()]:
                (n, first), (m, second) = self.causes[i], self.causes[j]
                is_one = second == OPPOSITE_NUMBER and self.slips.is_size and _turns(first)
                yield n + m, (first,) if is_one else (first, second)
            for i in self._upside_down():
                yield 1, (self.causes[i][1], causes.INVERTED)

    def _near(self):
        size = math.hypot(*self.fit.first[0])
        near = max(self.exactly * size, self.fit.rounding)
        if not NOISE * self.fit.first[2] < size < math.inf:
            return
        key, rows = self.at(self.fit.index)
        if not self._is_met_in_one(rows, near):
            return
        given = np.array(self.fit.first[0], float)
        off = abs(given - key) > near
        if not off.any():
            return
        # a mistake that undoes another, or leaves nothing, does not count as a second one
        undoes = (abs(rows - key)[:, ~off] > NOISE * size).any(axis=1)
        usable = np.isfinite(rows).all(axis=1) & rows.any(axis=1) & ~undoes
        usable &= (abs(rows - key) > NOISE * size).any(axis=1)
        last = len(rows) - 1
        # a pair says nothing if its first mistake has no name
        usable &= [bool(c.of or not c.does) for _, c in self.causes]
        usable[last] = len(key) == off.sum() or not key[~off].any()
        ratio = given[off] / key[off]
        alike = ratio.all() and np.ptp(ratio) <= 0.01 * abs(ratio).max()
        share, wrong = near / (AROUND * size), int(off.sum())
        levels = np.array([n for n, _ in self.causes])
        usable[self.own : last] &= levels[self.own : last] > FIRST // 2 + 2  # handed back alone
        firsts, seconds = np.flatnonzero(usable[: self.own]), np.flatnonzero(usable)
        operations = _added, _multiplied, *[_under_a_root] * (self.kind.length == 1)
        tried = [(op, firsts) for op in operations]
        tried += [(_multiplied, np.flatnonzero(usable[last:]) + last)]
        for op, places in tried:
            gaps = abs(op(rows[places][:, None], rows[seconds], key) - given)
            sums = levels[places][:, None] + levels[seconds]
            there = sums[(gaps <= AROUND * size).all(axis=2)]
            for i, j in np.argwhere((gaps <= near).all(axis=2)):
                one, two = sorted((int(places[i]), int(seconds[j])))
                is_slip = self.own <= two < last
                by_factor = any(self.own - 2 <= n < self.own for n in (one, two))
                of_numbers = self.kind.is_formula and not self.of_symbols
                by_sign = two == last
                twice = abs(abs(np.log2(abs(rows[one] / key))) - 1).max() < NOISE
                is_mere = by_factor and not self.of_symbols
                is_mere |= bool(by_sign and self.kind.is_met_by_chance and twice)
                if is_mere or (is_slip and (by_factor or of_numbers)):
                    continue
                shares = share ** (1 if alike and not by_sign else wrong)
                by_chance = len(tried) * (there <= sums[i, j]).sum() * shares > CHANCE
                met = self.of_symbols or not by_chance
                differ = (abs(rows[one] - rows[two]) > NOISE * size).any()
                one = self._of_one_term(one, two, rows - key) if op is _added else one
                if met and differ and one is not None and self._is_named(one, two, op):
                    yield one, two

    def _of_one_term(self, one, two, changes):
        """The first of two mistakes; of one that leaves out the term of which the other is a half,
        the one that reverses it; or None.
        """
        near = NOISE * abs(changes[one]).max()
        if (abs(changes[one] - 2 * changes[two]) > near).any():
            return one
        reverses = (abs(changes[: self.own] - 2 * changes[one]) <= near).all(axis=1)
        return int(reverses.argmax()) if reverses.any() else None

    def _is_met_in_one(self, rows, near):
        """False if no pair gives the component that is largest in the key, as for most answers."""
        given, key, _ = self.fit.first
        at = max(range(len(key)), key=lambda n: abs(key[n]))
        x, k, y = rows[:, at].copy(), float(key[at]), float(given[at])
        own, gap = np.concatenate((x[: self.own], x[-1:])), 2 * near
        x.sort()
        if _is_any(x, k + y - own, gap) or _is_any(x, k * y / own, abs(k / own) * gap):
            return True
        if self.kind.length > 1:
            return False
        squares, rest = np.sort(x * x), k * k - own * own
        return any(_is_any(squares, rest + n * y * y, gap * (2 * abs(y) + gap)) for n in (1, -1))

    def _is_named(self, i, j, op):
        """True of a pair that is not two mere factors, and holds at all points of a formula."""
        by_sign, of_formula = j == len(self.causes) - 1, self.kind.is_formula
        key, rows = self.at(self.fit.index)
        both = rows[[i, j]]
        if op is _added and _are_of_one_term(*(both - key)):
            return False
        factors = both[:, key != 0] / key[key != 0]
        if op is _multiplied and not by_sign and _are_powers(*factors):
            return False
        return not (by_sign and op is not _multiplied) and (
            not of_formula or self._is_met_everywhere(i, j, op)
        )

    def _is_met_everywhere(self, i, j, op):
        ratios = []
        for n, given in enumerate(self.fit.given):
            key, rows = self.at(n)
            if np.isfinite(key).all() and np.isfinite(rows[[i, j]]).all():
                if math.dist(op(rows[i], rows[j], key), given) > self.exactly * math.hypot(*given):
                    return False
                with np.errstate(all="ignore"):
                    ratios.append(rows[[i, j]] / key)
        found = np.array(ratios)
        there = np.isfinite(found).all(axis=(0, 1))  # a component may be zero at some points
        first, second = found[:, 0, there], found[:, 1, there]
        factors = [(np.ptp(x, axis=0) < NOISE) & (abs(x[0] - 1) > NOISE) for x in (first, second)]
        if op is _added:  # factors of one component are not added
            changed = [(abs(x - 1) > NOISE).any(axis=0) for x in (first, second)]
            return not ((factors[0] | factors[1]) & changed[0] & changed[1]).any()
        by_sign = any((abs(abs(x) - 1) < NOISE).all() for x in (first, second))
        return by_sign or any((np.ptp(x, axis=0) >= NOISE).any() for x in (first, second))

    def multiple(self) -> tuple[Cause, ...]:
        """A term of which the answer has another multiple, where the rest is right; the simplest.
        It must show in two components or points, by the digits that were written.
        """
        points, size = range(len(self.fit.key)), math.hypot(*self.fit.first[0])
        pairs = zip(chain(*self.fit.given[:2]), chain(*self.fit.key[:2]), strict=True)
        first, *ratios = [x / k for x, k in pairs if k] or [0.0]
        if all(abs(x - first) <= 0.01 * abs(first) for x in ratios):
            return ()  # a single number, or the whole is multiplied
        terms = [(k, c.of) for k, (_, c) in enumerate(self.causes) if c.does == causes.LEFT_OUT]
        if not terms or not NOISE * self.fit.first[2] < size < math.inf:
            return ()
        places, near = [k for k, _ in terms], max(self.exactly * size, self.fit.rounding)
        for last in (1, len(points)) if len(points) > 1 else (0,):
            keys, rows = zip(*(self.at(n) for n in points[: last + 1]), strict=True)
            key, off = np.concatenate(keys), np.concatenate(self.fit.given[: last + 1])
            off = off - key
            changed = np.concatenate([r[places] for r in rows], axis=1) - key
            with np.errstate(all="ignore"):
                gaps = _off_line(off, changed)
                shown = (abs(changed) > NOISE * size).sum(axis=1)
                is_met = (gaps <= near) & (shown > 1)
                is_met &= _off_line(key, changed) > NOISE * size  # the whole is not a term
            if not is_met.any():
                return ()
        chance = len(places) * (near / (AROUND * abs(off).max())) ** (shown - 1.0)
        is_met &= chance <= CHANCE
        largest = np.where(is_met, abs(changed).max(axis=1), 0).argmax()
        if not is_met.any():
            return ()
        change = changed[largest]
        factor = 1 - float((change * off).sum() / (change**2).sum())
        simple = Fraction(factor).limit_denominator(SIMPLE if self.kind.is_formula else FEW)
        is_simple = abs(factor - simple) <= near / abs(change).max()
        term = terms[largest][1] or causes.UNNAMED
        return (causes.multiple_of(term, str(simple) if is_simple else ""),)

    def _upside_down(self):
        if self.of_symbols and self.kind.length == 1:
            met = np.ones(self.own, bool)
            for n, (x,) in enumerate(self.fit.given):
                if met.any():
                    met &= abs(self.at(n)[1][: self.own, 0] * x - 1) <= ROUND_OFF
            yield from np.flatnonzero(met)


def _is_any(numbers, places, gap):
    """True if one of the sorted ``numbers`` is within ``gap`` of a place; perhaps at nan."""
    first = numbers.searchsorted(places - gap)
    return bool((first < numbers.searchsorted(places + gap, "right")).any())


def _are_powers(x, y):
    """True of changes of which one is a power of the other: together they give a third power."""
    with np.errstate(all="ignore"):
        power = (np.log(abs(x)) / np.log(abs(y))).ravel()
    whole = 12 * power  # whole for halves, thirds and fourths
    return bool(whole[0]) and bool((abs(whole - np.round(whole[0])) < NOISE).all())


def _are_of_one_term(x, y):
    """True of changes of which one is the other, its half or its double, or opposite to that: what
    is left out is not reversed as well.
    """
    return any((abs(x - n * y) <= NOISE * abs(x).max()).all() for n in (-2, -1, -0.5, 0.5, 1, 2))


def _off_line(x, lines):
    """How far a point is from each of the lines through zero."""
    times = (lines * x).sum(axis=1) / (lines**2).sum(axis=1)
    return abs(times[:, None] * lines - x).max(axis=1)


def _added(x, y, key):
    return x + y - key


def _multiplied(x, y, key):
    return np.where(key == 0, x + y, x * y / np.where(key == 0, 1.0, key))


def _under_a_root(x, y, key):
    return abs(x * x + y * y - key * key) ** 0.5
