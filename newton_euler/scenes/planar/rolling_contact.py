"""A round body on a surface, rolling or slipping: which of the two, and the friction (6.4, 8.5,
8.6).

Axes: x along the surface, y out of it, z = x cross y. The contact is at -r y from the centre. ``a``
    is the acceleration of the centre along x,
``alpha`` the angular acceleration about z, ``friction`` the force of the surface on the body along
x. ``force`` is the sum of all other forces along x (all that turn the body come in ``moment``,
about the centre), ``surface`` the acceleration of the surface along x.
"""

from dataclasses import dataclass

from ...algebra.errors import NewtonEulerError
from ...algebra.linear import solve_linear
from ...algebra.scalars import is_numeric, plain, scalar, size, where


class ContactError(NewtonEulerError, ValueError):
    """A body that leaves the surface, or a question that only numbers can decide."""


@dataclass(frozen=True)
class Contact:
    """How a round body moves on a surface; ``print`` it for words.

    rolls : True if it rolls without slip (an array of instants or bodies: of bools)
    a, alpha, friction : what then holds
    needed : the friction that rolling needs; limit : what the surface can give to a body that does
        not slip, mu N
    """

    rolls: object
    a: object
    alpha: object
    friction: object
    needed: object
    limit: object

    def __str__(self):
        if getattr(self.rolls, "shape", ()):
            return f"rolls: {self.rolls}"
        compared = (
            f"the friction needed is {float(abs(self.needed)):.6g}, the limit "
            f"{float(self.limit):.6g}"
        )
        return f"{'rolls without slip' if self.rolls else 'slips'}: {compared}"


def rolling(mass, radius, inertia, force=0, moment=0, surface=0):
    """Rolling without slip: a, alpha and the friction it needs, a
    :class:`newton_euler.algebra.linear.Solution`. Over scalars of every kind.

    inertia : about the centre, which is the mass centre

    >>> disk = rolling(2.0, 0.5, 0.25, force=6.0)  # I = m r^2/2: two thirds of the force move the centre
    >>> round(disk.a, 12), round(disk.friction, 12)
    (2.0, -2.0)
    """

    def laws(a, alpha, friction):
        return {
            "along the surface (8.15)": mass * a - force - friction,
            "about the centre (8.19)": inertia * alpha - moment - radius * friction,
            "no slip": a + radius * alpha - surface,
        }

    return solve_linear(laws)


def slipping(mass, radius, inertia, friction, force=0, moment=0):
    """Slipping, with the friction known, as -mu N against the slip: the accelerations (a, alpha)."""
    return plain((force + friction) / scalar(mass)), plain(
        (moment + radius * friction) / scalar(inertia)
    )


def contact(
    mass, radius, inertia, normal, mu, mu_kinetic=None, force=0, moment=0, surface=0, slip=0
):
    """Which regime holds, and what follows: a :class:`Contact`. For numbers and arrays; expressions
    go to :func:`rolling` and :func:`slipping`.

    normal : N, the force of the surface along y; mu : coefficient of static friction, mu_kinetic :
        of sliding friction (default: the same)
    slip : velocity of the body's lowest point relative to the surface, v + r omega - v_surface. A
        body that slips goes on slipping; one that does not rolls if it can: if the friction needed
        is at most mu N. If not, it slips to the side to which it would go without friction
    Raises :class:`ContactError` where N is negative.

    >>> print(contact(2.0, 0.5, 0.25, normal=19.62, mu=0.05, force=6.0))
    slips: the friction needed is 2, the limit 0.981
    """
    given = [scalar(x) for x in (normal, mu, force, moment, surface, slip, mass, radius, inertia)]
    if not all(map(is_numeric, given)):
        raise ContactError(
            "which regime holds depends on values: ask rolling(...) and slipping(...), and "
            "compare the friction with mu N"
        )
    if size(given[0] - abs(given[0])) > 0:
        raise ContactError(
            f"the normal force is {normal!r}: the surface would have to pull, so the body has "
            "left it; it is in free flight"
        )
    roll, kinetic = (
        rolling(mass, radius, inertia, force, moment, surface),
        mu if mu_kinetic is None else mu_kinetic,
    )
    limit, needed = mu * normal, roll.friction
    slip = plain(given[5])
    sense = where(slip == 0, where(needed >= 0, 1, -1), where(slip > 0, -1, 1))
    rolls = (slip == 0) & (abs(needed) <= limit)
    friction = where(rolls, needed, sense * kinetic * normal)
    a, alpha = slipping(mass, radius, inertia, friction, force, moment)
    return Contact(
        rolls, where(rolls, roll.a, a), where(rolls, roll.alpha, alpha), friction, needed, limit
    )
