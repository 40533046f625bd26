"""All zeros in an interval at which a function of time changes its sign (J. P. Boyd, SIAM J. Numer.
Anal. 40 (2002) 1666).

The interval is bisected until on each piece the function is known to seven digits: it is the
polynomial through its values at 13 Chebyshev points, which is compared with the function at three
more. Then no zero is missed, not even one of two that are close together: between two extrema of
the polynomial there is at most one, and the signs of the function itself at the extrema show
whether there is. No piece is given up. Around a kink or a jump the pieces become so short that the
function is below round-off there, and the signs at their ends decide.
"""

from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from functools import cache
from itertools import pairwise
from typing import Any, NamedTuple

from ..algebra.late import np
from ..algebra.scalars import NewtonEulerError
from .chebyshev import DEGREE, EPS, derivatives_at, extrema, root, value_at, values_at

# check points at irregular distances: a fast oscillation may look slow at Chebyshev points alone
CHECKS = (-0.8617, -0.2913, 0.4477)
# a polynomial represents the function if its last two coefficients and the differences at the check
# points are smaller than this fraction of the largest value
RESOLUTION = 1e-7
# ratio of the change at an end of a piece to that in between, above which it may be the foot of a
# peak
FOOT = 2.0
# pieces that are sampled at once, and the most that one interval may need
BATCH, MAX_PIECES = 128, 60_000
# fractions of the largest value in a piece: above the first a polynomial has the sign of the
# function; below the others a value, at an end or at an extremum, may be round-off, which is then
# measured
CERTAIN, DOUBTFUL, TOUCHING = 1e-5, 1e-9, 1e-13
NOISE_MARGIN = 8.0  # factor for round-off that is measured at a few points only
PICKED = [2, 7, 11]  # Chebyshev points at which it is measured, none of them at an end
NEWTON_STEPS = 4


class UnresolvedError(NewtonEulerError, ArithmeticError):
    """Raised where not all zeros of a function can be found; the message says where, and why."""


class VoidError(UnresolvedError):
    """Raised where the function has no value on part of the way."""


class Zero(NamedTuple):
    """A zero at the time ``t``; ``slope`` of the function there, 0 at a kink or a jump."""

    t: float
    slope: float


class Piece:
    """A part of the interval, and what is known about the function there.

    values : those at the points of :func:`sampling`, with the ``largest`` absolute value
    fit : the coefficients of the polynomial, then its differences from the function at the checks
    floor : absolute values up to this are round-off
    state : "new"; "split", to be bisected; "smooth", a polynomial; "empty", without zeros; "rough",
        too short to be bisected; "void", without values
    """

    __slots__ = ("fit", "floor", "largest", "left", "right", "state", "values")

    fit: "np.ndarray"

    def __init__(self, left: float, right: float):
        self.left, self.right, self.state, self.floor = left, right, "new", 0.0

    def halves(self) -> "tuple[Piece, Piece]":
        """The right half and the left half."""
        middle = (self.left + self.right) / 2
        return Piece(middle, self.right), Piece(self.left, middle)

    def time(self, x: float) -> float:
        """The time that belongs to ``x`` between -1 and 1."""
        return self.left + (self.right - self.left) * (1 + x) / 2

    def slope(self, end: int) -> float:
        """The slope of the polynomial at its left end, -1, or right end, 1."""
        terms = (k * k * c * end ** (k + 1) for k, c in enumerate(self.fit[: DEGREE + 1].tolist()))
        return 2 * sum(terms) / (self.right - self.left)

    def sign(self, value: float) -> int:
        """The sign of a value of the function in this piece; 0 for round-off, and for nan."""
        return int(value > self.floor) - int(value < -self.floor)


class Bracket(NamedTuple):
    """A part of a piece, from ``low`` to ``high`` in -1 to 1, where the sign becomes ``sign``."""

    piece: Piece
    low: float
    high: float
    sign: int


@dataclass(eq=False, repr=False)
class ZeroSearch:
    """The search for the zeros of a function between the times a and b.

    values : a function of an array of times that returns the values there
    noise : a function of an array (pieces, times) that returns the largest round-off in each piece
    sign : that of the function before a, or 0; later, that up to where the search has come
    direction : 1 for zeros at which the function grows, -1 where it falls, 0 for both
    start : None, or where the motion begins at a the value there, which is a zero that does not
        count if it is round-off; and True if it is known to be a zero
    closed : True if a zero at b counts, as where the motion ends
    cuts : times in between, in order, at which the function may have something narrow

    Raises :class:`UnresolvedError` where it cannot continue.
    """

    values: Callable[[Any], Any]
    noise: Callable[[Any], Any]
    a: float
    b: float
    sign: int
    direction: int = 0
    start: tuple[float, bool] | None = None
    closed: bool = False
    cuts: list[float] = field(default_factory=list)

    def __iter__(self) -> Iterator[tuple[list[float], float]]:
        """Lists of zeros, in order, each with the time up to which all have been found."""
        edges = pairwise([self.a, *self.cuts, self.b])
        todo, count = [Piece(*ends) for ends in edges][::-1], 0
        while todo:
            pieces, new = list[Piece](), list[Piece]()
            while todo and len(new) < BATCH:
                pieces.append(todo.pop())
                if pieces[-1].state == "new":
                    new.append(pieces[-1])
            self._sample(new)
            count += len(new)
            ends = (k for k, piece in enumerate(pieces) if piece.state in ("split", "void"))
            done = next(ends, len(pieces))
            if done:
                yield self._zeros(pieces[:done]), pieces[done - 1].right
            for piece in reversed(pieces[done:]):
                todo += piece.halves() if piece.state == "split" else [piece]
            if todo:
                self._check(todo[-1], count)

    def _check(self, piece, count):
        """Raise :class:`UnresolvedError` if the search cannot continue with this piece."""
        if piece.state == "void":
            raise VoidError(
                f"has no value from t = {piece.left:.9g} to {piece.right:.9g}; give one that is "
                "defined along the whole motion, also a little beyond its zero"
            )
        if count > MAX_PIECES:
            raise UnresolvedError(
                f"was sampled in {count} pieces of the time from {self.a:.9g} to {self.b:.9g}, and "
                f"is resolved only up to t = {piece.left:.9g}: it has too many zeros, or is too "
                "rough; integrate a shorter time, or give a smoother function"
            )

    def _sample(self, pieces):
        """Fit polynomials to the function on new pieces, and decide which of them to bisect."""
        points, transform = sampling()
        left, right = np.array([(piece.left, piece.right) for piece in pieces]).T
        width = right - left
        times = left[:, None] + width[:, None] * points
        times[:, DEGREE] = right
        values = self.values(times.reshape(-1)).reshape(times.shape)
        with np.errstate(invalid="ignore"):  # nan where there are no values
            fits = values[:, : DEGREE + 1] @ transform
            fits[:, DEGREE + 1 :] -= values[:, DEGREE + 1 :]
        sizes, largest = np.abs(fits), np.abs(values).max(axis=1)
        rest = sizes[:, DEGREE - 1 :].max(axis=1)
        # the times are rounded as well
        rounding = 32 * EPS * np.maximum(abs(left), abs(right)) / width
        smooth = rest <= (RESOLUTION + rounding) * largest
        # no Chebyshev polynomial exceeds 1; 1.5 leaves a margin for what the samples do not show
        empty = sizes[:, 0] > 1.5 * sizes[:, 1:].sum(axis=1)
        rough = np.flatnonzero(empty & ~smooth)
        if rough.size:
            empty[rough] = ~_has_foot(values[rough])
        for k, piece in enumerate(pieces):
            piece.values, piece.fit, piece.largest = values[k], fits[k], float(largest[k])
            piece.state = "empty" if empty[k] else "smooth" if smooth[k] else "split"
        rows = np.flatnonzero(~(smooth | empty))
        if rows.size:
            short = width <= np.maximum(rounding * width, 2.0**-60 * (self.b - self.a))
            self._unresolved([pieces[k] for k in rows], times[rows], rest[rows], short[rows])

    def _unresolved(self, pieces, times, rest, short):
        """Set the state of pieces on which the function is not a polynomial, unless to be split."""
        picked = times[:, PICKED]
        noise = NOISE_MARGIN * self.noise(picked)
        for k, piece in enumerate(pieces):
            finite = np.isfinite(piece.values)
            if not finite.any():
                piece.state = "void"
            elif finite.all() and rest[k] <= noise[k]:
                piece.state, piece.floor = "smooth", float(noise[k])
            elif short[k]:
                piece.state = "rough"

    def _zeros(self, pieces):
        """The zeros in pieces that are not to be bisected, in order."""
        smooth = [piece for piece in pieces if piece.state == "smooth"]
        extrema, brackets = self._extrema(smooth) if smooth else {}, []
        for piece in pieces:
            if piece.left == self.a and self.start:  # no sign there if the value is round-off
                value, is_zero = self.start
                doubtful = abs(value) <= DOUBTFUL * piece.largest
                if doubtful and (is_zero or self._is_noise(piece, -1, piece.left, value)):
                    self.sign = 0
            before = -1.0
            for x, sign in [*extrema.get(piece, ()), (1.0, self._end_sign(piece))]:
                if sign and self.sign and sign != self.sign and self.direction in (0, sign):
                    brackets.append(Bracket(piece, before, x, sign))
                self.sign, before = sign or self.sign, x
        return self._located(brackets) if brackets else []

    def _end_sign(self, piece):
        """The sign at the right end of a piece; at a zero that ends the motion, the one beyond."""
        value = float(piece.values[DEGREE])
        if self.closed and piece.right == self.b and abs(value) <= DOUBTFUL * piece.largest:
            slope = piece.slope(1)
            crosses = abs(slope) * (piece.right - piece.left) > CERTAIN * piece.largest
            if crosses and self._is_noise(piece, 1, piece.right, value):
                return 1 if slope > 0 else -1
        return piece.sign(value)

    def _is_noise(self, piece, end, t, value):
        """True if a value at an end of a piece is zero up to round-off, also of the time."""
        times = piece.left + (piece.right - piece.left) * sampling()[0][PICKED]
        noise = NOISE_MARGIN * float(self.noise(np.append(times, t)[None])[0])
        return abs(value) <= noise + 2 * EPS * abs(t * piece.slope(end))

    def _extrema(self, pieces):
        """For each piece a list of pairs: the extrema of its polynomial, and the signs there."""
        fits = np.array([piece.fit[: DEGREE + 1] for piece in pieces])
        rows, x = extrema(fits)
        values = values_at(fits[rows], x)
        largest = np.array([piece.largest for piece in pieces])[rows]
        unsure = np.flatnonzero(np.abs(values) <= CERTAIN * largest)
        if unsure.size:
            times = np.array([pieces[rows[k]].time(x[k]) for k in unsure])
            values[unsure] = self.values(times)
            for k, t in zip(unsure.tolist(), times.tolist(), strict=True):
                value = abs(values[k])
                # measured here: near a short hop the states may be much larger
                if value <= TOUCHING * largest[k]:
                    noise = NOISE_MARGIN * float(self.noise(np.array([[t]]))[0])
                    values[k] = 0.0 if value <= noise else values[k]
        found: dict = {}
        for row, place, value in zip(rows.tolist(), x.tolist(), values.tolist(), strict=True):
            found.setdefault(pieces[row], []).append((place, pieces[row].sign(value)))
        return found

    def _located(self, brackets):
        """The zeros in brackets, by Newton's method; where that fails, by bisection."""
        pieces, fits = [b.piece for b in brackets], np.array([b.piece.fit for b in brackets])
        left, right = np.array([(piece.left, piece.right) for piece in pieces]).T
        low, high = np.array([(b.piece.time(b.low), b.piece.time(b.high)) for b in brackets]).T
        x, signs = np.array([_guess(b) for b in brackets]), np.array([b.sign for b in brackets])
        width = right - left
        t, slope = left + width * (1 + x) / 2, 2 * derivatives_at(fits, x) / width
        typical = np.median(np.abs([piece.values for piece in pieces]), axis=1)
        # a slope this small is not accurate enough
        newton = slope * signs * width > 1e-4 * np.array([piece.largest for piece in pieces])
        for _ in range(NEWTON_STEPS):
            value = self.values(t)
            step = np.where(newton, value / np.where(newton, slope, 1.0), 0.0)
            t = np.clip(t - step, low, high)
            if not (np.abs(step) > EPS * np.abs(t)).any():
                break
        newton &= np.abs(step) <= 1e-9 * width + 16 * EPS * np.abs(t)
        # near a pole the steps become small as well
        newton &= np.abs(value) <= 1e-2 * typical
        found = []
        for k, good in enumerate(newton.tolist()):
            if good:
                found.append(Zero(float(t[k]), float(slope[k])))
            else:
                zero = root(self._value, float(low[k]), float(high[k]))
                if not self._is_pole(zero):
                    found.append(Zero(zero, 0.0))
        return found

    def _value(self, t):
        return float(self.values(np.array([t]))[0])

    def _is_pole(self, t):
        """True if the sign changes at ``t`` because the function becomes infinite."""
        near = 64 * EPS * max(abs(t), self.b - self.a)
        places = np.clip(t + near * np.array([-1.0, 1.0, -1e3, 1e3]), self.a, self.b)
        sizes = np.abs(self.values(places))
        return bool(sizes[:2].min() > 100 * sizes[2:].max())


def _has_foot(values):
    """For rows of samples whether nearly all of the change is at one end: perhaps a narrow peak."""
    edges = (0, 4), (3, DEGREE - 2), (DEGREE - 3, DEGREE + 1)
    first, between, last = (np.ptp(values[:, a:b], axis=1) for a, b in edges)
    return (first > FOOT * between) | (last > FOOT * between)


def _guess(bracket):
    """The zero of the polynomial in a bracket, or the end of the bracket that is closer to it."""
    c, sign = bracket.piece.fit[: DEGREE + 1].tolist(), bracket.sign
    low, high = bracket.low, bracket.high
    if bracket.piece.state == "rough" or value_at(c, low) * sign >= 0:
        return low
    if value_at(c, high) * sign <= 0:
        return high
    return root(lambda x: value_at(c, x), low, high, 1e-12)


@cache
def sampling() -> "tuple[np.ndarray, np.ndarray]":
    """The points of (0, 1) at which a piece is sampled, 13 Chebyshev points from left to right and
    the check points; and the matrix that turns the values at the former into the coefficients of
    the polynomial and its values at the latter.
    """
    k = np.arange(DEGREE + 1)
    angles = np.pi * k[::-1] / DEGREE
    to_coefficients = 2 / DEGREE * np.cos(np.outer(angles, k))
    to_coefficients[[0, -1]] /= 2
    to_coefficients[:, [0, -1]] /= 2
    at_checks = np.cos(np.outer(k, np.arccos(CHECKS)))
    points = np.concatenate([np.cos(angles), CHECKS])
    return (1 + points) / 2, np.hstack([to_coefficients, to_coefficients @ at_checks])
