"""Work and power of forces and couples (11.1)-(11.11).

Work belongs to a displacement between two positions or instants, power to one instant. All forms of
the work integral are integrals of one function over one variable, by :func:`work_integral`:

    U = integral of F.v dt       work_in_time(force, velocity, start, end)                    (11.2)
    U = integral of F_t ds       work_integral(F_t, s0, s1), F_t the tangential component     (11.3)
    U = integral of F ds_F       work_integral(F, s0, s1), over the displacement along F      (11.4)
    U = integral of F.dr         work_along(force, path, start, end)
                                                                                     (11.1), (11.5)
    U = integral of M dtheta     work_integral(M, theta0, theta1)                            (11.11)

A force at right angles to the velocity of its point of application does no work. Units: any
consistent ones; in SI J and W. Velocities are those in an inertial frame.
"""

from collections.abc import Callable, Sequence
from typing import TypeAlias

from ..algebra import WorkError
from ..algebra.errors import Accuracy, checked
from ..algebra.jets import Moving
from ..algebra.ledger import Amount, summed
from ..algebra.quadrature import quadrature
from ..algebra.scalars import ZERO, Scalar, Triple, max_abs, probe, scalar, to_plain
from ..algebra.vectors import FrameError, Vector
from ..kinematics.frames import Frame, Point
from ..kinematics.paths import Path, along
from ..kinematics.rotations import Components

Field: TypeAlias = Callable[..., Triple]  # a force as a function of x, y, z


@checked
def work_integral(
    f: Callable[[Scalar], Scalar],
    start: Scalar,
    end: Scalar,
    rtol: Accuracy = 1e-10,
    exact: bool = False,
    breaks: Sequence[Scalar] = (),
) -> Amount:
    """The integral of ``f`` with its estimated error: (11.2), (11.3), (11.4) or (11.11).

    f : function of one number. Floats: by an adaptive quadrature to ``rtol``, relative to the
        integral of abs(f). Arrays and mpf: to nearly their accuracy, for a smooth f; likewise
        dimensions, moving and traced numbers. With symbols, or ``exact=True``: by SymPy
    breaks : in order, where f has corners or jumps. Of floats a pulse is seen if it is longer than
        2 % of the distance between two of them; a shorter one may count as nothing, without a word,
        unless breaks stand where it begins and ends
    Raises :class:`WorkError` where it does not converge, is not finite, or has no formula.

    >>> round(work_integral(lambda x: -200.0*x, 0.0, 0.1).value, 9)  # a spring, stretched from rest
    -1.0
    """
    value, error = quadrature(f, start, end, rtol, exact, breaks)
    return Amount(to_plain(value), error=error)


def magnitude(x: Scalar) -> float:
    """The size of a number; of a SymPy expression that at sample values of its symbols."""
    if (value := probe(scalar(x))) is None:
        raise WorkError(f"{x!r} has no size to be compared; put numbers in")
    return max_abs(value)


@checked
def work_along(
    force: Field,
    path: Path,
    start: Scalar,
    end: Scalar,
    rtol: Accuracy = 1e-10,
    exact: bool = False,
    breaks: Sequence[Scalar] = (),
) -> Amount:
    """The work of a force whose point of application moves along a curve (11.1), with its
    rectangular ``terms`` x, y, z (11.5).

    force : function of x, y, z that returns (F_x, F_y, F_z), along the axes of the path
    path : function of one parameter, from ``start`` to ``end``, that returns (x, y, z)
    The others are those of :func:`work_integral`.

    >>> from newton_euler import cos, sin
    >>> U = work_along(lambda x, y, z: (-y, x, 0), lambda a: (cos(a), sin(a), 0), 0.0, 1.5)
    >>> round(U.value, 12)
    1.5
    """

    if any(isinstance(x, Moving) for x in path(start)):
        raise WorkError(
            "the path moves: freeze it at the instant, or take work_in_time(force, velocity, ...)"
        )

    def component(n):
        def f(q):
            place = along(path, q)
            return scalar(force(*(to_plain(x.value) for x in place))[n]) * place[n].rate

        return f

    how = rtol, exact, breaks
    parts = {n: work_integral(component(k), start, end, *how) for k, n in enumerate("xyz")}
    return summed(parts, number="11.5", error=sum(p.error for p in parts.values()))


@checked
def work_in_time(
    force: Callable[[Scalar], Components],
    velocity: Callable[[Scalar], Components],
    start: Scalar,
    end: Scalar,
    rtol: Accuracy = 1e-10,
    exact: bool = False,
    breaks: Sequence[Scalar] = (),
) -> Amount:
    """The work of a force from the instant ``start`` to ``end`` (11.2), or of a couple (11.11).

    force, velocity : functions of time that return Vectors or triples: the force and the velocity
        of its point of application, or the moment of a couple and the angular velocity
    The others are those of :func:`work_integral`.

    >>> weight, velocity = lambda t: (0, 0, -19.62), lambda t: (5.0, 0, 10.0 - 9.81*t)
    >>> round(work_in_time(weight, velocity, 0.0, 1.0).value, 9)
    -99.9639
    """
    return work_integral(lambda t: power(force(t), velocity(t)), start, end, rtol, exact, breaks)


@checked
def constant_force_work(force: Vector, start: Point, end: Point) -> Amount:
    """The work of a constant force, a Vector, between two Points of frames at relative rest, by any
    path: F.(r_1 - r_0) (11.6), with the ``terms`` x, y, z along its axes. That of a weight is m g
    (z_0 - z_1) (11.7).

    >>> from newton_euler import Frame
    >>> ground = Frame("ground")
    >>> A, B = ground.point("A", 0, 0, 2.0), ground.point("B", 5.0, 1.0, 0)
    >>> constant_force_work(-9.81*ground.k, A, B).value
    19.62
    """
    path = (end - start).expressed_in(force.frame).c
    terms = {name: f * d for name, f, d in zip("xyz", force.c, path, strict=True)}
    return summed(terms, number="11.6")


@checked
def power(
    force: Vector | Sequence,
    velocity: Vector | Sequence | Point | Frame,
    observer: Frame | None = None,
) -> Scalar:
    """The power P = F.v of a force (11.8), (11.9), v the velocity of its point of application, or P
    = M.omega of a couple (11.10). Positive: it drives the body.

    velocity : a Vector, like the force; or triples both, along the same axes. With an ``observer``,
        an inertial frame: the Point at which the force acts, or the Frame on which the couple acts

    >>> from newton_euler import Frame
    >>> ground = Frame("ground")
    >>> wheel = ground.rotate("wheel", "z", rate=3.0)
    >>> power((0, 0, -2.0), (1.0, 0, 3.0)), power(5.0*ground.k, wheel, ground)
    (-6.0, 15.0)
    """
    if observer is not None:
        seen = getattr(velocity, "angular_velocity", getattr(velocity, "velocity", None))
        if seen is None:
            raise FrameError(
                f"power(F, P, ground) takes a Point, or the Frame of a couple; got {velocity!r}"
            )
        velocity = seen(observer)
    if isinstance(force, Vector) and isinstance(velocity, Vector):
        return force.dot(velocity)
    if isinstance(force, (tuple, list)) and isinstance(velocity, (tuple, list)):
        pairs = zip(map(scalar, force), map(scalar, velocity), strict=True)
        return to_plain(sum((a * b for a, b in pairs), ZERO))
    raise FrameError(
        f"power needs two Vectors, two triples, or power(F, P, ground); got {force!r}, {velocity!r}"
    )


@checked
def pair_power(force: Vector, first: Point, second: Point, observer: Frame) -> Scalar:
    """The power of a pair of opposite forces, ``force`` at the Point ``first`` and its opposite at
    ``second`` (11.10), (11.13): F.(v_1 - v_2). A couple if both are points of one body; a spring,
    damper or joint between two; zero along the line between two points of one rigid body.

    >>> from newton_euler import Frame
    >>> ground = Frame("ground"); body = ground.rotate("body", "z", rate=2.0)
    >>> C, D = body.point("C", 0.0, 0.0, 0.0), body.point("D", 1.0, 0.0, 0.0)
    >>> pair_power(3.0*body.j, D, C, ground), pair_power(3.0*body.i, D, C, ground)
    (6.0, 0.0)
    """
    return power(force, first.velocity(observer) - second.velocity(observer))
