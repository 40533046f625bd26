"""A shot over the rotating Earth (6.9, 6.10), as a ladder of models from the flat earth at rest to the full equations of motion.

All have the states x, y, z along ground axes (east, north, up) from a place on the surface, and vx, vy, vz seen from there; no air. What a model
neglects is bounded as an error of the position, in the unit of length of the parameters, as long as the shot is above the ground.

>>> from newton_euler import radians
>>> from newton_euler.models import smallest
>>> start = (0.0, 0.0, 0.0, 200.0, 0.0, 200.0)
>>> for metres in (5.0, 3.0, 1.0, 0.01):
...     print(smallest(ladder(9.82, radians(45.0)), metres, 10.0, start).model.name)
projectile, flat
projectile, Coriolis
projectile, Coriolis and effective gravity
projectile, full
"""

from ..earth import EARTH_RADIUS, EARTH_RATE, attraction3, centrifugal3, earth_rate3, position3, velocity3
from ..models import Model, Neglected
from ..scalars import ZERO, cos, cosh, sinh, sqrt
from ..vectors import ZERO3, add3, cross3, dot3, scale3

POSITION = "position"
STATES = ("x", "y", "z", "vx", "vy", "vz")
ORDER = 24  # of the series of the exact solutions: see earth.projectile_to_order


def flat(g, latitude=0, rate=EARTH_RATE, radius=EARTH_RADIUS):
    """Free fall with constant g on an earth at rest. Latitude, rate and radius serve to bound what it neglects."""
    return _model("projectile, flat", g, latitude, rate, radius, lambda p: (_down(p), ZERO3), (CORIOLIS, CENTRIFUGAL, CURVATURE))


def coriolis(g, latitude, rate=EARTH_RATE, radius=EARTH_RADIUS):
    """Constant g and the Coriolis acceleration: (6.16), which the book solves to first order (6.24)."""
    return _model("projectile, Coriolis", g, latitude, rate, radius, lambda p: (_down(p), _omega(p)), (CENTRIFUGAL, CURVATURE))


def plumb(g, latitude, rate=EARTH_RATE, radius=EARTH_RADIUS):
    """The same with the effective gravity at the origin in place of g: the direction of the plumb line."""

    def field(p):
        omega = _omega(p)
        return add3(_down(p), centrifugal3(ZERO3, omega, p.radius)), omega

    return _model("projectile, Coriolis and effective gravity", g, latitude, rate, radius, field, (CENTRIFUGAL_CHANGE, CURVATURE))


def full(g, latitude, rate=EARTH_RATE, radius=EARTH_RADIUS):
    """All terms of (6.10), and the attraction of a sphere (5.22). Invariants: energy, and angular momentum about the axis, among the stars."""
    invariants = {"energy over mass": _energy, "angular momentum over mass, about the axis": _axial}
    return Model("projectile, full", _parameters(g, latitude, rate, radius), STATES, _full, invariants)


def ladder(g, latitude, rate=EARTH_RATE, radius=EARTH_RADIUS):
    """The four models, the coarsest first, for :func:`newton_euler.models.smallest`."""
    return tuple(make(g, latitude, rate, radius) for make in (flat, coriolis, plumb, full))


def _parameters(g, latitude, rate, radius):
    return {"g": g, "latitude": latitude, "rate": rate, "radius": radius}


def _model(name, g, latitude, rate, radius, field, neglects):
    """A projectile in a uniform field; ``field(p)`` returns gravity and angular velocity as triples."""

    def rhs(s, p, t):
        gravity, omega = field(p)
        return *_v(s), *add3(gravity, scale3(-2, cross3(omega, _v(s))))

    def exact(s, p, t):
        moved = position3(t, _v(s), *field(p), order=ORDER)
        return *add3(_r(s), moved), *velocity3(t, _v(s), *field(p), order=ORDER)

    return Model(name, _parameters(g, latitude, rate, radius), STATES, rhs, exact=exact, neglects=neglects)


def _r(s):
    return s.x, s.y, s.z


def _v(s):
    return s.vx, s.vy, s.vz


def _down(p):
    return ZERO, ZERO, -p.g


def _omega(p):
    return earth_rate3(p.latitude, p.rate)


def _full(s, p, t):
    omega = _omega(p)
    seen = scale3(-2, cross3(omega, _v(s)))
    return *_v(s), *add3(add3(attraction3(_r(s), p.g, p.radius), centrifugal3(_r(s), omega, p.radius)), seen)


# -- invariants


def _among_stars(s, p):
    """Position from the Earth's centre, and velocity among the stars, along ground axes."""
    rho = (s.x, s.y, s.z + p.radius)
    return rho, add3(_v(s), cross3(_omega(p), rho))


def _energy(s, p, t):
    rho, v = _among_stars(s, p)
    return dot3(v, v) / 2 - p.g * p.radius**2 / sqrt(dot3(rho, rho))


def _axial(s, p, t):
    rho, v = _among_stars(s, p)
    return dot3(earth_rate3(p.latitude, 1), cross3(rho, v))


# -- what may be neglected
#
# Above the ground the attraction is at most g, the centrifugal acceleration at most rate^2 (R + d) at the distance d from the origin, and the
# Coriolis acceleration does no work. So d <= D(t) with D'' = g + rate^2 (R + D), and the error e of a model that keeps the Coriolis term grows as
# |e'| <= integral of what it leaves out. A Coriolis term that is left out makes the error 2 omega x (integral of the way).


def _reach(s, p, t):
    """The distance d from the origin at the start, and the bound of what is added to it until t."""
    start, speed = sqrt(dot3(_r(s), _r(s))), sqrt(dot3(_v(s), _v(s)))
    half = sinh(p.rate * t / 2) / p.rate  # cosh x - 1 = 2 sinh(x/2)^2 without cancellation
    return start, speed * 2 * half * cosh(p.rate * t / 2) + 2 * (p.g + p.rate**2 * (p.radius + start)) * half**2


def _by_coriolis(s, p, t):
    return p.rate * t * _reach(s, p, t)[1]


def _by_centrifugal(s, p, t):
    start, added = _reach(s, p, t)
    return p.rate**2 * (p.radius * cos(p.latitude) + start + added) * t * t / 2


def _by_centrifugal_change(s, p, t):
    start, added = _reach(s, p, t)
    return p.rate**2 * (start + added) * t * t / 2


def _by_curvature(s, p, t):
    start, added = _reach(s, p, t)
    return 3 * p.g * (start + added) / p.radius * t * t / 2


CORIOLIS = Neglected("the Coriolis acceleration", _by_coriolis, POSITION)
CENTRIFUGAL = Neglected("the centrifugal acceleration", _by_centrifugal, POSITION)
CENTRIFUGAL_CHANGE = Neglected("the change of the centrifugal acceleration with place", _by_centrifugal_change, POSITION)
CURVATURE = Neglected("the change of the attraction with place", _by_curvature, POSITION)
