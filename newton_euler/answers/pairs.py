"""Two mistakes at once, where no single one explains an answer: one of the problem's own, or the
opposite sign, and another. What they change is added, as of terms, or multiplied, as of factors, or
stands under one root.

A number meets some pair by chance. Of formulas in symbols alone a pair must give all digits at all
points; of numbers two components or more must be wrong, each in its own way, and all pairs count as
tried. Two slips in the computation are never named: these explain guesses as well.
"""

import math
from collections.abc import Callable, Iterator, Sequence
from functools import cached_property
from typing import Any

from .causes import INVERTED, OPPOSITE_NUMBER, Cause, both
from .fit import Fit
from .kinds import Kind
from .near import AROUND, CHANCE, Singles
from .tolerance import NOISE, ROUND_OFF, Points


def of_two(
    fit: Fit,
    kind: Kind,
    own: Sequence[tuple[Cause, Points]],
    slips: Callable[[], Singles],
    is_contradicted: Callable[[Cause], bool],
) -> tuple[Cause, ...]:
    """The two mistakes that give an answer together, as one cause: the simplest two, of numbers
    only if there are no others as simple; () if there are none.

    own : the models of the problem's own mistakes
    slips : finds those that may be made beside one of them
    """
    of_numbers = kind.has_size and len(fit.key[0]) > 1  # any single number meets some pair
    if fit.index is None or not (of_numbers or kind.is_formula):
        return ()
    try:
        import numpy  # noqa: F401
    except ImportError:  # on a page of the site
        return ()
    found: dict[int, dict[tuple[Cause, Cause], None]] = {}
    for level, pair in _Pairs(fit, kind, own, slips()).fitting():
        if not any(map(is_contradicted, pair)):
            found.setdefault(level, {})[pair] = None
    simplest = [*found[min(found)]] if found else []
    is_one = len(simplest) == 1 or kind.is_formula
    return (both(*simplest[0]),) if simplest and is_one else ()


class _Pairs:
    """The pairs that an answer meets; each row of ``rows`` is what a single mistake makes of it, of
    which the first ``own`` are the problem's own, and the last the opposite sign.
    """

    def __init__(self, fit, kind, own, slips):
        self.fit, self.kind, self.own, self.models, self.slips = fit, kind, len(own), own, slips
        self.of_symbols = kind.is_formula and slips.of_symbols

    @cached_property
    def causes(self) -> list[tuple[int, Cause]]:
        """(how simple, the cause) of each row; the opposite sign has words of its own, which are
        shorter.
        """
        opposite = tuple(tuple(-x for x in point) for point in self.fit.key)
        own = [(4 if x == opposite else 2 * (c.group != "listed"), c) for c, x in self.models]
        return [*own, *((n + 2, c) for n, c in self.slips.causes), (1, OPPOSITE_NUMBER)]

    def at(self, point: int) -> tuple[Any, Any]:
        """(key, rows) at a point."""
        import numpy as np

        key = np.array(self.fit.key[point], float)
        rows = [*(x[point] for _, x in self.models), *self.slips.at(point), -key]
        return key, np.array(rows, float)

    def fitting(self) -> Iterator[tuple[int, tuple[Cause, Cause]]]:
        """(how simple, the two causes) of each pair that is met."""
        import numpy as np

        with np.errstate(all="ignore"):
            for i, j in [*self._near()]:
                (n, first), (m, second) = self.causes[i], self.causes[j]
                yield n + m, (first, second)
            for i in self._upside_down():
                yield 1, (self.causes[i][1], INVERTED)

    def _near(self):
        import numpy as np

        given, size = np.array(self.fit.first[0], float), math.hypot(*self.fit.first[0])
        key, rows = self.at(self.fit.index)
        near = max(ROUND_OFF * size, self.fit.rounding)
        off = abs(given - key) > near
        is_possible = 0 < size < math.inf and off.any()
        if not is_possible or not self._is_met_in_one(rows, key, given, near):
            return
        # what undoes another mistake, or leaves nothing, is none of two
        undoes = (abs(rows - key)[:, ~off] > NOISE * size).any(axis=1)
        usable = np.isfinite(rows).all(axis=1) & rows.any(axis=1) & ~undoes
        usable &= (abs(rows - key) > NOISE * size).any(axis=1)
        last = len(rows) - 1
        usable[last] = len(key) == off.sum() or not key[~off].any()
        needs_sign = self.kind.is_formula and not self.of_symbols
        firsts = np.flatnonzero(usable[: 0 if needs_sign else self.own])
        seconds = np.flatnonzero(usable)
        tried = [(op, firsts) for op in self._operations()]
        tried += [(_multiplied, np.flatnonzero(usable[last:]) + last)]
        for op, places in tried:
            made = op(rows[places][:, None], rows[seconds], key)
            for i, j in np.argwhere((abs(made - given) <= near).all(axis=2)):
                one, two = sorted((int(places[i]), int(seconds[j])))
                met = math.dist(made[i, j], given) <= near
                differ = (abs(rows[one] - rows[two]) > NOISE * size).any()
                if met and differ and self._is_named(one, two, op, near, given, key, off):
                    yield one, two

    def _is_met_in_one(self, rows, key, given, near):
        """False where no pair gives the largest component of the key, as of most answers."""
        at = abs(key).argmax()
        x, k, y = rows[:, at], float(key[at]), float(given[at])
        own = x[[*range(self.own), -1]][:, None]
        close = abs(own + x - (k + y)) <= 2 * near
        close |= abs(own * x - k * y) <= 2 * near * abs(k)
        if self.of_symbols:
            close |= abs(abs(own * own + x * x - k * k) ** 0.5 - abs(y)) <= 2 * near
        return close.any()

    def _operations(self):
        return (_added, _multiplied, *[_under_a_root] * (self.of_symbols and self.kind.length == 1))

    def _is_named(self, i, j, op, near, given, key, off):
        """True of what is met neither by chance nor by two mere factors."""
        import numpy as np

        by_sign = j == len(self.causes) - 1
        if by_sign and op is not _multiplied:
            return False
        if self.kind.is_formula:
            return (self.of_symbols or by_sign) and self._is_met_everywhere(i, j, op)
        if len(key) < 2 or (j < self.own and op is not _added):
            return False
        tried = self.own**2
        if j >= self.own:
            ratio = given[off] / key[off]
            alike = np.ptp(ratio) <= 0.01 * abs(ratio).max()
            if off.sum() < 2 or (alike and not by_sign) or not given[off].all():
                return False
            tried = len(self.causes) * (1 if by_sign else self.own + 1)
        share = near / (AROUND * math.hypot(*given))
        return tried * share ** int(off.sum()) <= CHANCE

    def _is_met_everywhere(self, i, j, op):
        import numpy as np

        ratios = []
        for n, given in enumerate(self.fit.given):
            key, rows = self.at(n)
            if np.isfinite(key).all() and np.isfinite(rows[[i, j]]).all():
                if math.dist(op(rows[i], rows[j], key), given) > ROUND_OFF * math.hypot(*given):
                    return False
                ratios.append(rows[[i, j]][:, key != 0] / key[key != 0])
        first, second = (np.array(x) for x in zip(*ratios, strict=True))
        factors = [(np.ptp(x, axis=0) < NOISE) & (abs(x[0] - 1) > NOISE) for x in (first, second)]
        if op is _added:  # factors of one component are not added
            changed = [(abs(x - 1) > NOISE).any(axis=0) for x in (first, second)]
            return not ((factors[0] | factors[1]) & changed[0] & changed[1]).any()
        by_sign = any((abs(abs(x) - 1) < NOISE).all() for x in (first, second))
        return by_sign or any((np.ptp(x, axis=0) >= NOISE).any() for x in (first, second))

    def _upside_down(self):
        import numpy as np

        if self.of_symbols and self.kind.length == 1:
            met = np.ones(self.own, bool)
            for n, (x,) in enumerate(self.fit.given):
                if met.any():
                    met &= abs(self.at(n)[1][: self.own, 0] * x - 1) <= ROUND_OFF
            yield from np.flatnonzero(met)


def _added(x, y, key):
    return x + y - key


def _multiplied(x, y, key):
    import numpy as np

    return np.where(key == 0, x + y, x * y / np.where(key == 0, 1.0, key))


def _under_a_root(x, y, key):
    return abs(x * x + y * y - key * key) ** 0.5
