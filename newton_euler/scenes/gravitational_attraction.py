"""A particle attracted by a body at the origin, as far as energy tells (11.10)."""

from ..energy import speed_after
from ..scalars import plain, scalar, sqrt


def attraction_field(K, M, m):
    """The force of a mass M at the origin on m at (x, y, z) (11.22), (11.23): a function of x, y, z.

    :func:`newton_euler.potential.find_potential` takes it. Its potential is that of
    :func:`newton_euler.potential.gravitational_potential` (11.24). It does not exist at the origin.

    >>> attraction_field(1.0, 125.0, 2.0)(3.0, 4.0, 0)
    (-6.0, -8.0, 0)
    """

    def force(x, y, z):
        x, y, z = map(scalar, (x, y, z))
        square = x * x + y * y + z * z
        strength = -(scalar(K) * M * m) / (square * sqrt(square))
        return plain(strength * x), plain(strength * y), plain(strength * z)

    return force


def speed_at_distance(r, r0, v0, K, M):
    """The speed at the distance ``r``, from that at ``r0``, on whatever path: v^2 = v0^2 + 2 K M (1/r - 1/r0), without cancellation as r -> r0.

    :class:`~newton_euler.energy.EnergyError` if it does not get so far.

    >>> round(speed_at_distance(4.0, 2.0, 3.0, 1.0, 14.0), 12)
    1.414213562373
    """
    return speed_after(v0, scalar(K) * M * (scalar(r0) - r) / (scalar(r) * r0), 1)


def escape_speed(r, K, M):
    """The speed at ``r`` that just suffices to get away for ever: sqrt(2 K M/r).

    >>> round(escape_speed(6.371e6, 6.673e-11, 5.97e24))
    11183
    """
    return plain(sqrt(2 * scalar(K) * M / r))
