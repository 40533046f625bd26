"""Worked examples of chapter 8, Euler's equations: the three rods of ch07 turning about three axes,
one after the other (8.4); a round body on a surface, rolling or slipping (6.4, 8.5, 8.6); a sphere
that slides, then rolls (8.6).
"""

from dataclasses import dataclass

from newton_euler import Body, Frame, NewtonEulerError, Point, Vector, solve_linear, where
from newton_euler.algebra.linear import Solution
from newton_euler.algebra.scalars import Scalar, is_numeric, max_abs, scalar, to_plain
from newton_euler.chapters.examples.ch07 import three_rods
from newton_euler.dynamics.momentum import angular_momentum, resultant_moment
from newton_euler.scenes.planar import sliding_sphere
from newton_euler.scenes.planar.rolling_sphere import inertia_ratio


@dataclass(frozen=True)
class Turning:
    """A turning body, with its angular momentum ``H`` and the resultant moment ``M`` of the
    external forces, both about ``about`` and seen from ``ground``.
    """

    body: Body
    ground: Frame
    about: Frame | Point
    H: Vector
    M: Vector


def bars_about_x(m: Scalar, length: Scalar, rate: Scalar, acceleration: Scalar) -> Turning:
    """The three rods turning about x (8.4, example 1), a :class:`Turning`: x is not principal, so
    that Euler's equations do not apply. M = (2/3 alpha, -(alpha + omega^2)/4, (alpha - omega^2)/4)
    m L^2 about the origin of the rods' axes. Any consistent units of mass and length.

    m : mass of one rod; rate, acceleration : omega in rad/s, alpha in rad/s^2

    >>> bars_about_x(12.0, 1.0, 2.0, 1.0).M
    Vector(8.0, -15.0, -9.0 in bars)
    """
    ground = Frame("ground")
    frame = ground.rotate("bars", "x", rate=rate, acceleration=acceleration)
    return _turning(three_rods(m, length, frame), ground, frame)


def bars_about_principal_axis(
    m: Scalar, length: Scalar, rate: Scalar, acceleration: Scalar
) -> Turning:
    """The three rods turning about (2, 1, -1) (8.4, example 2), a :class:`Turning`: a principal
    axis, with H and M along it, and the moment 5/12 m L^2. Arguments as in :func:`bars_about_x`.

    >>> e = bars_about_principal_axis(12.0, 1.0, 2.0, 3.0)
    >>> round(e.H.norm(), 12), round(e.M.norm(), 12), round(e.M.cross(e.H).norm(), 12)
    (10.0, 15.0, 0.0)
    """
    ground = Frame("ground")
    frame = ground.rotate("bars", (2, 1, -1), rate=rate, acceleration=acceleration)
    return _turning(three_rods(m, length, frame), ground, frame)


def bars_about_mass_centre(
    m: Scalar, length: Scalar, rate: Scalar, acceleration: Scalar
) -> Turning:
    """The three rods turning about the axis through G parallel to z (8.4, example 3), a
    :class:`Turning`: M = (3 alpha - omega^2, alpha + 3 omega^2, 10 alpha) m L^2/12 about G, with
    the whole mass 3 m; the book takes that of one rod. Arguments as in :func:`bars_about_x`.

    >>> print(bars_about_mass_centre(12.0, 1.0, 2.0, 1.0).M)
    [-1, 13, 10] in bars
    """
    ground = Frame("ground")
    shaft = ground.rotate("shaft", "z", rate=rate, acceleration=acceleration)
    # G is at the origin of the shaft
    frame = shaft.translate("bars", shaft.point("middle of rod 2", 0, -length / 6, -length / 6))
    body = three_rods(m, length, frame)
    return _turning(body, ground, body.centre)


def _turning(body, ground, about):
    H, M = angular_momentum(body, ground, about), resultant_moment(body, ground, about)
    return Turning(body, ground, about, H, M)


@dataclass(frozen=True)
class RollingBegins:
    """The instant at which sliding turns into rolling: time ``t`` from the start, place ``x``,
    speed ``v``, angular velocity ``omega``.
    """

    t: Scalar
    x: Scalar
    v: Scalar
    omega: Scalar


def rolling_begins(
    v0: Scalar,
    mu: Scalar,
    g: Scalar,
    radius: Scalar,
    omega0: Scalar = 0,
    k: Scalar | None = None,
    sense: int = 1,
) -> RollingBegins:
    """When and how a sliding sphere begins to roll (8.6): :class:`RollingBegins`.

    Without spin t = 2 v0/(7 mu g), v = 5 v0/7, omega = -5 v0/(7 r).

    sense : the sign of v0 + omega0 r, as in
        :func:`newton_euler.scenes.planar.sliding_sphere.sliding`; with the wrong sign the time is
        negative

    >>> b = rolling_begins(7.0, 0.2, 10.0, 0.5)
    >>> round(b.t, 12), b.v, b.omega
    (1.0, 5.0, -10.0)
    """
    k = inertia_ratio(mu, k)
    slip = v0 + scalar(omega0) * radius
    t = sense * slip * k / ((1 + k) * (mu * g))
    v = (v0 - k * (scalar(omega0) * radius)) / (1 + k)
    return RollingBegins(t, to_plain(t * (v0 + v) / 2), v, -v / radius)


def sphere_at(
    t: Scalar,
    v0: Scalar,
    mu: Scalar,
    g: Scalar,
    radius: Scalar,
    omega0: Scalar = 0,
    k: Scalar | None = None,
    sense: int = 1,
) -> tuple[Scalar, ...]:
    """(x, v, omega) at the time ``t``, through both regimes (8.6); for numbers and arrays of times.

    >>> [round(x, 9) for x in sphere_at(2.0, 7.0, 0.2, 10.0, 0.5)]
    [11.0, 5.0, -10.0]
    """
    b = rolling_begins(v0, mu, g, radius, omega0, k, sense)
    slid = sliding_sphere.sliding(mu, g, radius, k, sense).solution(t, (0 * v0, v0, omega0))
    rolled = sliding_sphere.rolling(radius, k).solution(t - b.t, (b.x, b.v, b.omega))
    return tuple(where(t < b.t, early, late) for early, late in zip(slid, rolled, strict=True))


# -- 6.4, 8.5, 8.6: a round body on a surface, rolling or slipping
#
# Axes: x along the surface, y out of it, z = x cross y. The contact is at -r y from the centre.
# ``a`` is the acceleration of the centre along x, ``alpha`` the angular acceleration about z,
# ``friction`` the force of the surface on the body along x. ``force`` is the sum of all other
# forces along x (all that turn the body come in ``moment``, about the centre), ``surface`` the
# acceleration of the surface along x.


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

    rolls: Scalar
    a: Scalar
    alpha: Scalar
    friction: Scalar
    needed: Scalar
    limit: Scalar

    def __str__(self):
        if getattr(self.rolls, "shape", ()):
            return f"rolls: {self.rolls}"
        needed, limit = float(abs(self.needed)), float(self.limit)
        regime = "rolls without slip" if self.rolls else "slips"
        return f"{regime}: the friction needed is {needed:.6g}, the limit {limit:.6g}"


def rolling(
    mass: Scalar,
    radius: Scalar,
    inertia: Scalar,
    force: Scalar = 0,
    moment: Scalar = 0,
    surface: Scalar = 0,
) -> Solution:
    """Rolling without slip: a, alpha and the friction it needs, a
    :class:`newton_euler.algebra.linear.Solution`. Over scalars of every kind.

    inertia : about the centre, which is the centre of mass

    >>> # I = m r^2/2: two thirds of the force move the centre
    >>> disk = rolling(2.0, 0.5, 0.25, force=6.0)
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


def slipping(
    mass: Scalar,
    radius: Scalar,
    inertia: Scalar,
    friction: Scalar,
    force: Scalar = 0,
    moment: Scalar = 0,
) -> tuple[Scalar, Scalar]:
    """The accelerations (a, alpha) of a body that slips, with the friction known, as -mu N against
    the slip.
    """
    a = (force + friction) / scalar(mass)
    return to_plain(a), to_plain((moment + radius * friction) / scalar(inertia))


def contact(
    mass: Scalar,
    radius: Scalar,
    inertia: Scalar,
    normal: Scalar,
    mu: Scalar,
    mu_kinetic: Scalar | None = None,
    force: Scalar = 0,
    moment: Scalar = 0,
    surface: Scalar = 0,
    slip: Scalar = 0,
) -> Contact:
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
    if max_abs(given[0] - abs(given[0])) > 0:
        raise ContactError(
            f"the normal force is {normal!r}: the surface would have to pull, so the body has "
            "left it; it is in free flight"
        )
    roll = rolling(mass, radius, inertia, force, moment, surface)
    kinetic = mu if mu_kinetic is None else mu_kinetic
    limit, needed = mu * normal, roll.friction
    slip = to_plain(given[5])
    sense = where(slip == 0, where(needed >= 0, 1, -1), where(slip > 0, -1, 1))
    rolls = (slip == 0) & (abs(needed) <= limit)
    friction = where(rolls, needed, sense * kinetic * normal)
    slips = slipping(mass, radius, inertia, friction, force, moment)
    a, alpha = (where(rolls, *both) for both in zip((roll.a, roll.alpha), slips, strict=True))
    return Contact(rolls, a, alpha, friction, needed, limit)
