"""Work and power of forces and couples (11.1)-(11.11).

Work belongs to a displacement, between two positions or instants, power to an instant. All forms of the work integral are integrals of one
function over one variable: :func:`integral` finds them in floats with an error estimate, in the digits of an mpf, or exactly by SymPy.
"""

from dataclasses import dataclass, field

from .paths import derivatives
from .scalars import ZERO, epsilon, is_numeric, plain, scalar
from .vectors import FrameError, Vector

SUBDIVISIONS = 400


class WorkError(ValueError):
    """An integral that does not converge, or a force or path that has no value where it is needed."""


@dataclass(frozen=True)
class Work:
    """Work done between two positions or instants: ``value``, its estimated ``error`` (both in J), and its ``terms`` by name.

    It can be used as the number it is: ``float(U)``, ``U + 1``, ``2*U``.
    """

    value: object
    error: float = 0.0
    terms: dict = field(default_factory=dict)

    def __float__(self):
        return float(self.value)

    def __add__(self, other):
        return self.value + (other.value if isinstance(other, Work) else other)

    __radd__ = __add__

    def __neg__(self):
        return -self.value

    def __sub__(self, other):
        return self.value - (other.value if isinstance(other, Work) else other)

    def __rsub__(self, other):
        return other - self.value

    def __mul__(self, other):
        return self.value * other

    __rmul__ = __mul__


def integral(f, start, end, rtol=1e-10, exact=False):
    """The integral of ``f`` from ``start`` to ``end``, as a :class:`Work` with its estimated error.

    f : function of one number. With floats by SciPy's adaptive quadrature to ``rtol``, relative to the integral of abs(f); with mpf limits
        in their working precision; with ``exact=True`` by SymPy, where f is written with functions of this package
    This is (11.3) for the tangential component over arc length, (11.4) for the force over the displacement along it, (11.2) for the power over time,
    (11.11) for a moment over the angle. Raises :class:`WorkError` where it does not converge or has no closed form.

    >>> integral(lambda x: -200.0*x, 0.0, 0.1).value  # a spring, stretched from rest
    -1.0
    """
    if exact:
        return Work(_exact(f, start, end))
    if not (is_numeric(start) and is_numeric(end)):
        raise WorkError(f"the limits {start!r} and {end!r} hold symbols: pass exact=True to integrate by formulas, or put numbers in")
    if min(epsilon(start), epsilon(end)) < 2.0**-52:  # an mpf of more digits than a float
        return _precise(f, start, end)
    return _numeric(f, float(start), float(end), rtol)


def _numeric(f, start, end, rtol):
    import math
    import warnings

    from scipy.integrate import IntegrationWarning, quad

    def g(x):
        value = float(plain(scalar(f(x))))
        if not math.isfinite(value):
            raise WorkError(f"the integrand is {value} at {x:.6g}, between the limits {start:.6g} and {end:.6g}; look at divisions and roots there")
        return value

    scale = abs(end - start) * sum(abs(g(start + (end - start) * (n + 0.5) / 16)) for n in range(16)) / 16
    with warnings.catch_warnings():
        warnings.simplefilter("error", IntegrationWarning)
        try:
            value, error = quad(g, start, end, epsabs=rtol * scale, epsrel=rtol, limit=SUBDIVISIONS)
        except IntegrationWarning as problem:
            raise WorkError(
                f"the integral from {start:.6g} to {end:.6g} did not converge to {rtol:.1g}: {str(problem).split('.')[0].strip()}. Divide it "
                "where the force has a corner or a jump, or ask for less with rtol="
            ) from None
    return Work(value, error)


def _precise(f, start, end):
    import mpmath

    value, error = mpmath.quad(lambda x: plain(scalar(f(x))), [start, end], error=True)
    return Work(value, float(error))


def _exact(f, start, end):
    import sympy

    q = sympy.Dummy("q", real=True)
    value = sympy.integrate(sympy.sympify(plain(scalar(f(q)))), (q, start, end))
    if value.has(sympy.Integral):
        raise WorkError("SymPy finds no formula for this integral; put numbers in, without exact=True")
    return value


def work_along(force, path, start, end, rtol=1e-10, exact=False):
    """The work of a force whose point of application moves along a curve (11.1), with its rectangular ``terms`` x, y, z (11.5).

    force : function of x, y, z (of the place, along the axes in which the path is given) that returns (F_x, F_y, F_z)
    path : function of one parameter that returns (x, y, z), written with functions of this package; ``start``, ``end`` its limits

    >>> from newton_euler import cos, sin
    >>> import math
    >>> U = work_along(lambda x, y, z: (-y, x, 0), lambda a: (cos(a), sin(a), 0), 0.0, math.pi)
    >>> round(U.value, 12) == round(math.pi, 12)
    True
    """
    def component(n):
        def f(q):
            place, tangent, *_ = derivatives(path, q)
            return scalar(force(*map(plain, place))[n]) * tangent[n]

        return f

    parts = {name: integral(component(n), start, end, rtol, exact) for n, name in enumerate("xyz")}
    return Work(sum(p.value for p in parts.values()), sum(p.error for p in parts.values()), {n: p.value for n, p in parts.items()})


def work_in_time(force, velocity, start, end, rtol=1e-10, exact=False):
    """The work of a force from the instant ``start`` to ``end`` (11.2); force and velocity are functions of time that return Vectors or triples.

    The velocity is that of the point of application, seen from an inertial frame.

    >>> round(work_in_time(lambda t: (0, 0, -19.62), lambda t: (5.0, 0, 10.0 - 9.81*t), 0.0, 1.0).value, 9)
    -99.9639
    """
    return integral(lambda t: power(force(t), velocity(t)), start, end, rtol, exact)


def power(force, velocity):
    """P = F . v (11.9): of a force, with the velocity of its point of application; or of a couple, with the angular velocity, P = M . omega (11.10).

    Both Vectors (of related frames), or both triples along the same axes.

    >>> power((0, 0, -2.0), (1.0, 0, 3.0))
    -6.0
    """
    if isinstance(force, Vector) or isinstance(velocity, Vector):
        if not (isinstance(force, Vector) and isinstance(velocity, Vector)):
            raise FrameError("power needs two Vectors, or two triples along the same axes; got one of each")
        return force.dot(velocity)
    total = ZERO
    for a, b in zip(force, velocity, strict=True):
        total = total + scalar(a) * b
    return plain(total)


def constant_force_work(force, start, end):
    """The work of a constant force between two Points or positions, by whatever path: F . (r_1 - r_0) (11.6), (11.7).

    force : a Vector; start, end : Points of related frames

    >>> from newton_euler import Frame
    >>> ground = Frame("ground")
    >>> constant_force_work(-9.81*ground.k, ground.point("A", 0, 0, 2.0), ground.point("B", 5.0, 1.0, 0))
    19.62
    """
    return force.dot(end - start)
