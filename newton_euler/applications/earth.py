"""Motion as seen from the rotating Earth (6.8)-(6.11): frames, weight, projectiles, weather.

*Ground axes*: i east, j north, k up, away from the centre of a uniform sphere. Angles in rad:
latitude, north positive; azimuth from east toward north; elevation from the horizontal. ``rate`` is
the Earth's, rad/s. ``g`` is the acceleration by attraction alone; a vector ``gravity`` may be the
:func:`effective_gravity`.

>>> from newton_euler import Frame, radians
>>> ground = ground_frame(earth_frame(Frame("stars")), radians(45.0))
>>> print(earth_rate(ground))
[0, 5.1563e-05, 5.1563e-05] in ground
"""

from collections.abc import Iterable
from itertools import accumulate, pairwise

from ..algebra.errors import NewtonEulerError, checked
from ..algebra.scalars import (
    ZERO,
    Scalar,
    Triple,
    cos,
    is_numeric,
    is_positive,
    max_abs,
    scalar,
    sin,
    sqrt,
    to_plain,
    vanishes,
)
from ..algebra.vectors import Vector, add3, cross3, dot3, named_sum, scale3
from ..bodies.admissibility import not_negative, positive
from ..kinematics.frames import Frame

EARTH_RATE = 7.292115e-5  # rad/s: one turn in a sidereal day (WGS 84)
EARTH_RADIUS = 6.371e6  # m: of the sphere of equal volume (IUGG)
EARTH_GM = 3.986004418e14  # m^3/s^2: gravitational constant times mass (WGS 84)


class EarthError(NewtonEulerError, ValueError):
    """A latitude out of range, or a motion that does not exist on the rotating Earth."""


# -- frames


@checked
def earth_frame(stars: Frame, rate: Scalar = EARTH_RATE) -> Frame:
    """The frame of the Earth in ``stars``, which does not rotate; origin in its centre, axes as at
    longitude 0 on the equator: i east, j north, k up.

    >>> from newton_euler import Frame
    >>> stars = Frame("stars")
    >>> print(earth_frame(stars).angular_velocity(stars))
    [0, 7.29211e-05, 0] in earth
    """
    return stars.rotate("earth", "y", 0, rate)


@checked
def ground_frame(
    earth: Frame, latitude: Scalar, longitude: Scalar = 0, radius: Scalar = EARTH_RADIUS
) -> Frame:
    """The ground axes at a place, with their origin there, in the frame by :func:`earth_frame`;
    longitude positive east. Raises :class:`EarthError` for a latitude beyond the poles (degrees?).

    >>> from newton_euler import Frame
    >>> ground = ground_frame(earth_frame(Frame("stars"), 7e-5), 0.0, radius=6.4e6)
    >>> print(ground.origin.velocity(ground.tree[0]).expressed_in(ground))  # 448 m/s to the east
    [448, 0, 0] in ground
    """
    meridian = earth.rotate("meridian of ground", "y", longitude)
    _check_latitude(latitude)
    positive(radius, "the radius of the Earth")
    latitude = scalar(latitude)
    up, north = radius * cos(latitude), radius * sin(latitude)
    origin = meridian.point("origin of ground", ZERO, north, up)
    return meridian.rotate("ground", "-x", latitude, origin=origin)


def _check_latitude(latitude):
    # 1.5708 is pi/2 rounded up
    if is_numeric(latitude) and max_abs(latitude) > 1.5708:
        raise EarthError(f"a latitude is from -pi/2 to pi/2 rad, as radians(45); got {latitude!r}")


@checked
def earth_rate(ground: Frame) -> Vector:
    """The angular velocity of the Earth (6.18) in ``ground``, seen from the root of its tree."""
    return ground.angular_velocity(ground.tree[0])


def earth_rate3(latitude: Scalar, rate: Scalar = EARTH_RATE) -> Triple:
    """The Earth's angular velocity (6.18) as a triple along ground axes.

    >>> earth_rate3(0.0)
    (0, 7.292115e-05, 0.0)
    """
    _check_latitude(latitude)
    return ZERO, rate * cos(latitude), rate * sin(latitude)


def attraction3(r: Triple, g: Scalar, radius: Scalar) -> Triple:
    """The attraction of the Earth (5.22) as an acceleration at ``r`` from the ground's origin,
    triples along ground axes; ``g`` is that at ``radius`` from the centre.

    >>> attraction3((0, 0, 1.0), 9.0, 2.0)
    (0, 0, -4.0)
    """
    x, y, z = _from_centre(r, radius)
    square = dot3((x, y, z), (x, y, z))
    factor = g * radius**2 / (square * sqrt(square))
    return tuple(to_plain(-factor * q) for q in (x, y, z))


def centrifugal3(r: Triple, omega: Triple, radius: Scalar) -> Triple:
    """-omega x (omega x rho), as a triple along ground axes, at ``r`` from the ground's origin."""
    return cross3(cross3(omega, _from_centre(r, radius)), omega)


def _from_centre(r, radius):
    x, y, z = (scalar(q) for q in r)
    return x, y, z + radius


# -- apparent weight (6.8)


@checked
def ground_acceleration(ground: Frame) -> Vector:
    """The acceleration a_B of the origin of ``ground`` (6.12), toward the axis of rotation.

    >>> from newton_euler import Frame
    >>> ground = ground_frame(earth_frame(Frame("stars"), 1e-4), 0.0, radius=6.4e6)
    >>> print(ground_acceleration(ground))
    [0, 0, -0.064] in ground
    """
    return ground.origin.acceleration(ground.tree[0]).expressed_in(ground)


@checked
def effective_gravity(g: Scalar, ground: Frame) -> Vector:
    """The acceleration of a body released at rest, g' = -g k - a_B (6.11), along ground axes and a
    plumb line; terms ``attraction``, ``centrifugal``. The book's apparent g, g - R omega^2
    cos(latitude)^2, is its component down; ``g'.angle_to(-ground.k)`` the plumb line's angle.

    >>> from newton_euler import Frame
    >>> print(effective_gravity(9.82, ground_frame(earth_frame(Frame("stars")), 1.5)))
    [0, -0.00239041, -9.81983] in ground
    """
    parts = {"attraction": scalar(g) * -ground.k, "centrifugal": -ground_acceleration(ground)}
    return named_sum("effective gravity", f"in {ground.name}", parts, ground)


@checked
def support_force(m: Scalar, g: Scalar, ground: Frame) -> Vector:
    """The force N of the ground on a body of mass ``m`` at rest on it (6.13), along ground axes;
    terms ``weight``, m g k (6.14), and ``rotation``, which keeps the body on its circle.

    >>> from newton_euler import Frame
    >>> ground = ground_frame(earth_frame(Frame("stars"), 1e-4), 0.0, radius=6.4e6)
    >>> support_force(2.0, 10.0, ground).terms["rotation"].z
    -0.128
    """
    not_negative(m, "the mass")
    m = scalar(m)
    parts = {"weight": m * scalar(g) * ground.k, "rotation": m * ground_acceleration(ground)}
    return named_sum("support force", f"in {ground.name}", parts, ground)


# -- projectiles (6.9, 6.10)


@checked
def coriolis_acceleration(omega: Vector, v: Vector) -> Vector:
    """The Coriolis acceleration -2 omega x v for ``v`` seen from a frame that turns at ``omega``.

    >>> from newton_euler import Frame
    >>> ground = Frame("ground")
    >>> coriolis_acceleration(2.0*ground.k, 3.0*ground.i).components()
    (0, -12.0, 0)
    """
    return -2 * omega.cross(v)


@checked
def apparent_acceleration(v: Vector, gravity: Vector, omega: Vector) -> Vector:
    """The acceleration of a projectile with the velocity ``v``, seen from the ground (6.16): the
    terms ``gravity`` and ``coriolis``; only the effective gravity has those in omega^2.

    >>> from newton_euler import Frame
    >>> ground = Frame("ground")
    >>> print(apparent_acceleration(100.0*ground.i, -10.0*ground.k, 1e-4*ground.j))
    [0, 0, -9.98] in ground
    """
    parts = {"gravity": gravity, "coriolis": coriolis_acceleration(omega, v)}
    return named_sum("apparent acceleration", f"in {v.frame.name}", parts, v.frame)


@checked
def force_near_earth(m: Scalar, v: Vector, a: Vector, omega: Vector) -> Vector:
    """The resultant force, weight included, on a body that moves as seen from the ground (6.15): m
    a + 2 m omega x v, terms ``relative``, ``coriolis``; omega^2 is in the effective gravity.

    v, a : velocity and acceleration seen from the ground

    >>> from newton_euler import Frame
    >>> ground = ground_frame(earth_frame(Frame("stars")), 0.8)
    >>> v = -30.0*ground.j  # a car to the south is held by the road to the east
    >>> print(force_near_earth(1000.0, v, 0*v, earth_rate(ground)))
    [3.13863, 0, 0] in ground
    """
    not_negative(m, "the mass")
    parts = {"relative": scalar(m) * a, "coriolis": -scalar(m) * coriolis_acceleration(omega, v)}
    return named_sum("force near the earth", f"in {v.frame.name}", parts, v.frame)


def launch_direction(azimuth: Scalar, elevation: Scalar) -> Triple:
    """The direction of a shot (6.17), a triple along ground axes."""
    return cos(azimuth) * cos(elevation), sin(azimuth) * cos(elevation), sin(elevation)


@checked
def launch_velocity(ground: Frame, speed: Scalar, azimuth: Scalar, elevation: Scalar) -> Vector:
    """The velocity of a shot, seen from the ground, along ground axes (6.17).

    >>> from newton_euler import Frame
    >>> print(launch_velocity(Frame("ground"), 10.0, 0.0, 0.5))
    [8.77583, 0, 4.79426] in ground
    """
    return ground.vector(*(speed * e for e in launch_direction(azimuth, elevation)))


@checked
def projectile_position(t: Scalar, launch: Vector, gravity: Vector, omega: Vector) -> Vector:
    """The position of a projectile at time ``t`` after it left the origin (6.24), to first order in
    the rotation; terms ``launch``, ``fall``, ``launch turned``, ``fall turned``. The error is about
    (2 omega t)^2/6 of the way; see :func:`projectile_to_order`.

    launch, gravity, omega : Vectors, the velocity of the shot, the acceleration of free fall, the
        Earth's angular velocity

    >>> from newton_euler import Frame, radians
    >>> ground = ground_frame(earth_frame(Frame("stars")), radians(45.0))
    >>> launch = launch_velocity(ground, 100.0, 0.0, 0.5)
    >>> r = projectile_position(10.0, launch, 9.81*-ground.k, earth_rate(ground))
    >>> print(r.terms["fall turned"])
    [0.168611, 0, 0] in ground
    """
    frame = launch.frame
    v, g, w = _along(frame, launch, gravity, omega)
    triples = {
        "launch": scale3(t, v),
        "fall": scale3(t * t / 2, g),
        "launch turned": scale3(-t * t, cross3(w, v)),
        "fall turned": scale3(-t * t * t / 3, cross3(w, g)),
    }
    terms = {name: Vector(c, frame) for name, c in triples.items()}
    return named_sum("projectile", f"in {frame.name}", terms, frame)


def _along(frame, *vectors):
    return [v.expressed_in(frame).c for v in vectors]


def coriolis_series(v: Triple, g: Triple, w: Triple, factors: Iterable[tuple]) -> Triple:
    """The sum over (a, b) in ``factors`` of (-2 w x)^n (a v + b g), triples: Horner's scheme."""
    *rest, total = (add3(scale3(a, v), scale3(b, g)) for a, b in factors)
    for term in reversed(rest):
        total = add3(term, cross3(scale3(-2, w), total))
    return total


def _integrals(t, m, order):
    """(t^k/k!, t^(k + 1)/(k + 1)!) for k = m ... m + ``order``: one integration each."""
    powers = list(accumulate(range(1, m + order + 2), lambda power, k: power * t / k, initial=1))
    return list(pairwise(powers[m:]))


def position3(t: Scalar, v: Triple, g: Triple, w: Triple, order: int = 1) -> Triple:
    """The displacement by (6.20), to any order in w, of triples. Order 1 is (6.24)."""
    return coriolis_series(v, g, w, _integrals(t, 1, order))


@checked
def projectile_to_order(
    t: Scalar, launch: Vector, gravity: Vector, omega: Vector, order: int
) -> Vector:
    """The position of a projectile to any order in the rotation, for uniform ``gravity``: the
    solution of (6.20) as a series. The remainder after ``order`` is less than (2 omega t)^(order +
    1)/(order + 2)! of the way; 24 orders are exact to round-off within five hours.

    >>> from newton_euler import Frame
    >>> ground = Frame("ground")
    >>> print(projectile_to_order(2.0, 0*ground.i, -10.0*ground.k, 0.1*ground.j, 2))
    [2.66667, 0, -19.7333] in ground
    """
    v, g, w = _along(launch.frame, launch, gravity, omega)
    return Vector(position3(t, v, g, w, order), launch.frame)


@checked
def projectile_velocity(
    t: Scalar, launch: Vector, gravity: Vector, omega: Vector, order: int = 1
) -> Vector:
    """The rate of :func:`projectile_position` seen from the ground (6.22), or to a higher order.

    >>> from newton_euler import Frame
    >>> ground = Frame("ground")
    >>> print(projectile_velocity(2.0, 0*ground.i, -10.0*ground.k, 0.1*ground.j))
    [4, 0, -20] in ground
    """
    v, g, w = _along(launch.frame, launch, gravity, omega)
    return Vector(coriolis_series(v, g, w, _integrals(t, 0, order)), launch.frame)


@checked
def projectile(
    t: Scalar,
    speed: Scalar,
    azimuth: Scalar,
    elevation: Scalar,
    latitude: Scalar,
    g: Scalar,
    rate: Scalar = EARTH_RATE,
) -> Triple:
    """The coordinates (east, north, up) of a shot at time ``t``, with the book's angles (6.25), to
    first order in the rotation.

    >>> [round(x, 3) for x in projectile(10.0, 0.0, 0.0, 0.0, 0.0, 9.81)]  # a drop at the equator
    [0.238, 0.0, -490.5]
    """
    v = tuple(speed * e for e in launch_direction(azimuth, elevation))
    way = position3(t, v, (ZERO, ZERO, -scalar(g)), earth_rate3(latitude, rate))
    return tuple(map(to_plain, way))


@checked
def flight_time(
    speed: Scalar,
    azimuth: Scalar,
    elevation: Scalar,
    latitude: Scalar,
    g: Scalar,
    rate: Scalar = EARTH_RATE,
) -> Scalar:
    """The time until a shot is back at its level (6.26), to first order in the rotation.

    >>> flight_time(50.0, 0.0, 1.5707963267948966, 0.0, 10.0, rate=0.0)
    10.0
    """
    e = launch_direction(azimuth, elevation)
    down = g - 2 * speed * e[0] * earth_rate3(latitude, rate)[1]
    if not is_positive(down):
        raise EarthError("at this speed the Coriolis acceleration outweighs gravity")
    return 2 * speed * e[2] / down


@checked
def shot_range(
    speed: Scalar,
    azimuth: Scalar,
    elevation: Scalar,
    latitude: Scalar,
    g: Scalar,
    rate: Scalar = EARTH_RATE,
) -> Scalar:
    """The distance along the ground to the point of impact (6.27).

    >>> round(shot_range(100.0, 0.0, 0.7853981633974483, 0.0, 10.0, rate=0.0), 9)
    1000.0
    """
    t = flight_time(speed, azimuth, elevation, latitude, g, rate)
    x, y, _ = projectile(t, speed, azimuth, elevation, latitude, g, rate)
    return sqrt(x * x + y * y)


@checked
def range_east(speed: Scalar, elevation: Scalar, g: Scalar, rate: Scalar = EARTH_RATE) -> Scalar:
    """The range of a shot to the east on the equator (6.30): :func:`shot_range` to first order.

    >>> round(range_east(100.0, 0.7853981633974483, 10.0), 3)
    1000.688
    """
    turned = 4 * rate * speed**3 * sin(elevation) * (1 - 4 * cos(elevation) ** 2) / (3 * g**2)
    return speed**2 * sin(2 * elevation) / g - turned


@checked
def range_error(speed: Scalar, elevation: Scalar, g: Scalar, rate: Scalar = EARTH_RATE) -> Scalar:
    """The relative error (R_0 - R)/R_0 of the range to the east without rotation (6.31), in the
    book in per cent; negative below 60 degrees, where the rotation lengthens the shot.

    >>> round(range_error(100.0, 0.7853981633974483, 10.0), 6)
    -0.000688
    """
    return 2 * rate * speed * (1 - 4 * cos(elevation) ** 2) / (3 * g * cos(elevation))


# -- weather (6.11)


@checked
def coriolis_parameter(latitude: Scalar, rate: Scalar = EARTH_RATE) -> Scalar:
    """The rate 2 omega sin(latitude), rad/s, at which the direction of a free horizontal motion
    turns; clockwise where it is positive, in the north.

    >>> round(coriolis_parameter(0.8), 9)
    0.000104621
    """
    return 2 * earth_rate3(latitude, rate)[2]


@checked
def wind_acceleration(
    speed: Scalar, azimuth: Scalar, latitude: Scalar, rate: Scalar = EARTH_RATE
) -> tuple[Scalar, Scalar]:
    """The acceleration (east, north) of air that moves freely on the level with ``speed`` toward
    ``azimuth`` (6.33), (6.34): to the right in the north, to the left in the south.

    >>> [round(x, 6) for x in wind_acceleration(20.0, 0.0, 0.5, 7e-5)]
    [0.0, -0.001342]
    """
    f = coriolis_parameter(latitude, rate)
    return f * speed * sin(azimuth), -f * speed * cos(azimuth)


@checked
def buoyancy(
    m: Scalar,
    speed: Scalar,
    azimuth: Scalar,
    latitude: Scalar,
    g: Scalar,
    rate: Scalar = EARTH_RATE,
) -> Scalar:
    """The vertical force that keeps air of mass ``m`` on its level (6.32): its weight, less the
    vertical Coriolis force of an eastward wind.

    >>> buoyancy(1.0, 100.0, 0.0, 0.0, 9.8, rate=1e-4)
    9.780000000000001
    """
    not_negative(m, "the mass")
    return m * (g - 2 * earth_rate3(latitude, rate)[1] * speed * cos(azimuth))


@checked
def gradient_wind(
    pressure_gradient: Scalar, radius: Scalar, latitude: Scalar, rate: Scalar = EARTH_RATE
) -> Scalar:
    """The speed v of a steady wind on a circle of ``radius`` about a centre of pressure, v^2/radius
    + 2 omega |sin(latitude)| v = G; positive for a cyclone: counterclockwise in the north.

    pressure_gradient : G, over the density, m/s^2; positive about a low, negative about a high, and
        then :class:`EarthError` if it is steeper than any wind can balance

    >>> round(gradient_wind(1e-3, 500e3, 0.8), 2), round(gradient_wind(-1e-3, 500e3, 0.8), 2)
    (8.26, -12.59)
    """
    f = coriolis_parameter(latitude, rate)
    if vanishes(f):
        raise EarthError("on the equator, or an Earth at rest, nothing turns a wind aside")
    f = sqrt(f * f)
    square = f * f + 4 * pressure_gradient / radius
    if is_numeric(square) and max_abs(abs(square) - square) > 0:
        raise EarthError(
            f"no steady wind: at radius {radius!r} the Coriolis acceleration balances an "
            f"outward gradient of at most {float(f * f * radius / 4):.3g}, not "
            f"{to_plain(-pressure_gradient)!r}; a high has a flat middle"
        )
    # the root (sqrt(square) - f) radius/2 without its cancellation on large circles
    return 2 * pressure_gradient / (f + sqrt(square))
