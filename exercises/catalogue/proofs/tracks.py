"""A particle on a smooth track: its speed, from the force along the track."""

from mpmath import mp, mpf

from .digits import DIGITS, Force, Number, Path, ProofError
from .integrals import integral
from .motions import rate

PIECES = 32  # pieces of the track, at whose ends the particle must still move


def speed_along(
    m: Number, force: Force, path: Path, start: Number, end: Number, speed: Number = 0
) -> Number:
    """The speed at ``path(end)`` of a particle that leaves ``path(start)`` with ``speed`` on a
    smooth track: m v dv = F.dr, integrated.

    force : function of the place, both lists of three
    path : the place as a function of any parameter
    Raises :class:`ProofError` if the particle comes to rest before.

    >>> def weight(place):
    ...     return [0, 0, mpf(-10)]
    >>> def slope(q):
    ...     return [3 * q, 0, -2 * q**2]
    >>> print(mp.nstr(speed_along(1, weight, slope, 0, 3), 10))  # sqrt(2*10*18)
    18.97366596
    """
    with mp.workdps(DIGITS):
        start, end, square = mpf(start), mpf(end), mpf(speed) ** 2

        def gain(q):  # gain of the square of the speed
            F, along = force(path(q)), rate(path, q)
            return 2 * sum(f * x for f, x in zip(F, along, strict=True)) / m

        _moves_on(gain, start, end, square)
        return mp.sqrt(square + integral(gain, start, end))


def _moves_on(gain, start, end, square):
    """Raise ProofError if the particle stops, by Simpson's rule on each piece."""
    step = (end - start) / PIECES
    for n in range(PIECES):
        q = start + n * step
        square += step * (gain(q) + 4 * gain(q + step / 2) + gain(q + step)) / 6
        if square <= 0:
            raise ProofError(
                f"the particle comes to rest on the way, between {mp.nstr(q, 5)} and "
                f"{mp.nstr(q + step, 5)} of the path"
            )
