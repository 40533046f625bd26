"""Elimination of linear equations of numbers, one equation after the other, in their units."""

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace

from .names import listed
from .scalars import ZERO, Scalar, largest_abs, max_abs, min_abs, short, unit_roundoff
from .vectors import FrameError

# Thresholds of the elimination, in round-offs of the coarsest number. Measured on 3000 surplus
# equations of systems with 2 to 12 random unknowns and condition numbers up to 1e4: what should
# vanish is at most 2**2 of them in a row, and 2**4 in a right side; what should not, at least
# 2**37.
# Relative to the largest coefficient of a condition: what remains of a sum of a few terms that
# cancel, as in the components of a turned vector.
CANCELLATION = 16
# Relative to the largest coefficient of the equation, also where unknowns are left open: in 1500
# such systems what should vanish is at most 2**10, what should not at least 2**22.
NO_PIVOT = 2**12
# Relative to the pivot, or to the largest part of a sum: halfway between both measured sizes.
ABSENT = 2**19
# Relative to the terms of the equation: 1e-9, so that data that agree to nine digits agree.
CONTRADICTION = 2**22


class LinearError(FrameError):
    """Linear equations, of these names, contradict each other or leave an unknown undetermined."""

    def __init__(self, message: str, equations: Iterable[str] = ()):
        super().__init__(message)
        self.equations = tuple(equations)


@dataclass(frozen=True)
class LinearEquation:
    """The sum of coefficient times unknown is ``right``. ``group`` numbers the condition."""

    name: str
    coefficients: tuple[Scalar, ...]
    right: Scalar
    group: int

    def parts(self) -> tuple[Scalar, ...]:
        """All its numbers: the coefficients, then the right side."""
        return (*self.coefficients, self.right)

    def each(self, change: Callable[[Scalar], Scalar]) -> "LinearEquation":
        """The equation with ``change`` applied to each of its numbers."""
        coefficients = tuple(map(change, self.coefficients))
        return replace(self, coefficients=coefficients, right=change(self.right))


class Varies(Exception):
    """No unknown can serve as the pivot at all instants of the arrays."""


def _subtracted(row, other, pivot):
    """The row less the multiple of another, whose pivot is 1, that makes its own pivot vanish."""
    row = [a - row[pivot] * b for a, b in zip(row, other, strict=True)]
    row[pivot] = ZERO  # exactly, so that no round-off is taken for a coefficient
    return row


class Elimination:
    """Equations of numbers, eliminated one after the other: a new one gives a pivot, another must
    agree. A row is a sum of equations: its coefficients, its right side, and how much of each
    equation is in it. ``rows`` has them by the unknown that is their pivot, with 1 there,
    ``dependent`` those without by the number of the last equation. Sizes are compared unknown by
    unknown (in ``scale``) and within a condition (``usual``, for each equation), in their units.
    """

    def __init__(self, equations: list[LinearEquation], count: int, faithful: bool, numbers: bool):
        self.equations, self.count, self.numbers = equations, count, numbers
        self.round_off = float(unit_roundoff(x for e in equations for x in e.parts()))
        self.scale = self._scales()
        self.usual = self._by_group([self._relative(e.coefficients) for e in equations])
        self.rows: dict[int, list[Scalar]] = {}
        self.dependent: dict[int, list[Scalar]] = {}
        for n in range(len(equations)):
            self._eliminate(n)
        self.free = {pivot: self._others(pivot, row) for pivot, row in self.rows.items()}
        self.values = {k: row[count] for k, row in self.rows.items() if not self.free[k]}
        for n, row in self.dependent.items() if faithful else ():
            self._check(n, row)

    def _by_group(self, values):
        """For each equation the largest of its values and of those of the same condition."""
        largest = {}
        for e, own in zip(self.equations, values, strict=True):
            largest[e.group] = max(largest.get(e.group, 0.0), largest_abs(own))
        return [largest[e.group] for e in self.equations]

    def _scales(self):
        """The size of the coefficients of each unknown; 0 if they are rounding errors only."""
        scale = [0.0] * self.count
        usual = self._by_group([e.coefficients for e in self.equations])
        for e, largest in zip(self.equations, usual, strict=True):
            for k, size in enumerate(map(max_abs, e.coefficients)):
                if size > CANCELLATION * self.round_off * largest:
                    scale[k] = max(scale[k], size)
        return scale

    def _relative(self, row, measure=max_abs):
        """The size of the coefficients of a row, each relative to what is usual for its unknown."""
        pairs = zip(row, self.scale, strict=False)
        return [measure(x) / s if s else 0.0 for x, s in pairs]

    def _others(self, pivot, row):
        """The unknowns of a row other than its pivot."""
        noise = ABSENT * self.round_off / self.scale[pivot]
        return [k for k, size in enumerate(self._relative(row)) if k != pivot and size > noise]

    def _eliminate(self, n):
        own = (int(n == m) or ZERO for m in range(len(self.equations)))
        row = [*self.equations[n].parts(), *own]
        for pivot, other in self.rows.items():
            if row[pivot] is not ZERO:
                row = _subtracted(row, other, pivot)
        pivot = self._pivot(row, NO_PIVOT * self.round_off * self.usual[n])
        if pivot is None:
            self.dependent[n] = row
            return
        row = [x / row[pivot] for x in row]
        for k, r in self.rows.items():
            if r[pivot] is not ZERO:
                self.rows[k] = _subtracted(r, row, pivot)
        self.rows[pivot] = row

    def _pivot(self, row, noise):
        """The unknown with the largest coefficient at every instant; None if all are round-off."""
        smallest = self._relative(row, min_abs)
        best = max(range(self.count), key=smallest.__getitem__)
        if smallest[best] > noise:
            return best
        if max(self._relative(row)) > noise:
            raise Varies
        return None

    def _check(self, last, row):
        """Raises LinearError if the right side of a row without unknowns does not vanish."""
        involved, values = self._involved(last, row), self.values

        def terms(e):
            return [e.right, *(c * values[k] for k, c in enumerate(e.coefficients) if k in values)]

        sizes = self._by_group(map(terms, self.equations))
        own = max(max_abs(row[self.count + 1 + n]) * sizes[n] for n in involved)
        difference = max_abs(row[self.count])
        if difference <= (CONTRADICTION * own + NO_PIVOT * max(sizes)) * self.round_off:
            return
        *others, name = names = [self.equations[n].name for n in involved]
        off = f"is off by {difference:.3g}" if self.numbers else "does not hold"
        if not others:
            raise LinearError(f"the equation {name!r} {off}: no unknown occurs in it", names)
        raise LinearError(
            f"the equations contradict each other: {name!r} {off} if {listed(map(repr, others))} "
            f"hold{'s' * (len(others) == 1)}",
            names,
        )

    def _involved(self, last, row):
        """The equations of which a row is the sum, in their order, ``last`` however small."""
        parts = enumerate(zip(row[self.count + 1 :], self.usual, strict=True))
        weights = {n: max_abs(w) * usual for n, (w, usual) in parts if w is not ZERO}
        absent = ABSENT * self.round_off * max(weights.values())
        return [n for n, w in weights.items() if w >= absent or n == last]

    def relations(self, names: Sequence[str]) -> Iterator[str]:
        """What is known of the unknowns that are not determined, in words."""
        for pivot, free in self.free.items():
            row = self.rows[pivot]
            if free and not any(getattr(x, "shape", ()) for x in row[: self.count + 1]):
                text = f"{names[pivot]} = {short(row[self.count])}"
                for k in free:
                    c = float(row[k])
                    times = "" if abs(c) == 1 else f"{abs(c):.6g} "
                    text += f" {'-' if c > 0 else '+'} {times}{names[k]}"
                yield text

    def redundant(self) -> Mapping[str, tuple[str, ...]]:
        """By name, the equations that follow from others."""
        rows = self.dependent.items()
        found = ([self.equations[n].name for n in self._involved(*row)] for row in rows)
        return {last: tuple(others) for *others, last in found if others}
