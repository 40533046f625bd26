"""Newton's second law for the centre of mass of a body (6.1)-(6.10), in every component system.

*Motion given, which forces?* Pass the acceleration of a point by ``polar(ground, "P", r, theta)``,
``frenet(v, a)``, ``ground.point(…)`` … in an inertial frame to :func:`resultant_force` or
:func:`reaction`. *Forces given, which motion?* :func:`acceleration_by` in an inertial frame,
:func:`coordinate_accelerations` in curvilinear coordinates, :func:`path_rates` along the path,
:func:`relative_acceleration` in a frame that moves: the right-hand side of a
:class:`~newton_euler.motion.model.Model`.

Units: any consistent ones; in SI kg, m, s, N. A mass that is not positive raises
:class:`~newton_euler.bodies.admissibility.MassError`.
"""

from collections.abc import Sequence

from ..algebra.errors import checked
from ..algebra.ledger import Chosen
from ..algebra.scalars import (
    Scalar,
    SingularError,
    is_finite,
    is_positive,
    scalar,
    to_plain,
    vanishes,
)
from ..algebra.vectors import FrameError, Vector, named_sum
from ..bodies.admissibility import MassError
from ..kinematics.coordinates import CoordinatePoint
from ..kinematics.frames import Frame, Point

# the kinds of acceleration whose terms, times m, are those of a force (6.5)-(6.10)
FORCES = {f"{system}force" for system in ("", "intrinsic ", "polar ", "cylindrical ", "spherical ")}


def _mass(m):
    if not is_positive(m) or not is_finite(m):
        raise MassError(f"the mass must be positive and finite, got m = {m!r}")
    return scalar(m)


@checked
def resultant_force(m: Scalar, a: Vector) -> Vector:
    """The resultant external force F = m a (6.1), ``a`` the acceleration of the centre of mass in
    an inertial frame; its terms, times m, are those of the force: (6.5), (6.6), (6.8) to (6.10).

    >>> from newton_euler import Frame, moving, polar
    >>> ground = Frame("ground")
    >>> P = polar(ground, "P", moving(2.0, rate=0.5), moving(0.0, rate=3.0))
    >>> F = resultant_force(4.0, P.acceleration(ground))
    >>> print(F, F.terms["coriolis"])
    [-72, 12, 0] in polar axes of P [0, 12, 0] in polar axes of P
    """
    F = _mass(m) * a
    kind = F.equation and F.equation.kind.replace("acceleration", "force")
    return F.as_sum(kind) if kind in FORCES else F


@checked
def reaction(m: Scalar, a: Vector, **known: Vector) -> Vector:
    """The one unknown force R = m a - (the known forces) (6.1), along the axes of ``a``, a Vector
    as the ``known`` are. Terms: ``inertia``, which is m a, and minus each known force.

    >>> from newton_euler import Frame
    >>> ground = Frame("ground")
    >>> print(reaction(2.0, ground.vector(0, 0, 1.0), weight=-2.0*9.81*ground.k))
    [0, 0, 21.62] in ground
    """
    parts = [("inertia", _mass(m) * a), *((Chosen(name), -F) for name, F in known.items())]
    subject = f"with {', '.join(known)} known" if known else "alone"
    return named_sum("reaction", subject, parts, a.frame)


@checked
def path_force(
    m: Scalar, speed: Scalar, speed_rate: Scalar, flexure: Scalar
) -> tuple[Scalar, Scalar]:
    """The force components (F_t, F_n) along the path (6.5), in the plane or in space: m v' and m
    v^2/rho, F_n toward the centre of curvature; ``flexure`` is 1/rho, theta'/v in the plane.

    >>> path_force(2.0, 4.8, 0.0, 1/0.5)
    (0.0, 92.16)
    """
    m = _mass(m)
    return to_plain(m * speed_rate), to_plain(m * speed * speed * flexure)


@checked
def acceleration_by(m: Scalar, **forces: Vector) -> Vector:
    """The acceleration of the centre of mass by the forces named, Vectors: a = F/m (6.1), with F/m
    of each as terms, along the axes of the first.

    >>> from newton_euler import Frame
    >>> ground = Frame("ground")
    >>> a = acceleration_by(2.0, weight=-19.62*ground.k, wind=3.0*ground.i)
    >>> print(a, a.terms["wind"])
    [1.5, 0, -9.81] in ground [1.5, 0, 0] in ground
    """
    if not forces:
        raise FrameError("no force is given; name each of them, as in acceleration_by(m, weight=W)")
    parts = _per_mass(m, forces)
    kind, frame = "acceleration by forces", next(iter(parts.values())).frame
    return named_sum(kind, "of the centre of mass", parts, frame)


@checked
def path_rates(m: Scalar, F_t: Scalar, F_n: Scalar, speed: Scalar) -> tuple[Scalar, Scalar]:
    """The rates (v', theta') of motion along a plane path (6.5): F_t/m and F_n/(m v), theta the
    direction of the velocity, positive toward F_n; :class:`SingularError` at rest.

    >>> path_rates(2.0, 3.0, 8.0, 4.0)
    (1.5, 1.0)
    """
    m = _mass(m)
    if vanishes(speed):
        raise SingularError("at rest the velocity has no direction; use rectangular components")
    return to_plain(F_t / m), to_plain(F_n / (m * speed))


@checked
def coordinate_accelerations(
    m: Scalar, P: CoordinatePoint, **forces: Vector | Sequence
) -> tuple[Scalar, ...]:
    """The second rates of the coordinates of ``P`` by the forces named: (6.6), (6.8), (6.9) solved
    for r'', theta'', …, a tuple; :class:`SingularError` where the coordinates are singular.

    P : a point by :func:`~newton_euler.kinematics.coordinates.polar`, ``cylindrical``,
        ``spherical`` or ``curvilinear``, with its coordinates and their first rates
    forces : Vectors, or components along the local axes of P (as F_r, F_theta, F_z)

    >>> from newton_euler import Frame, moving, polar
    >>> P = polar(Frame("ground"), "P", moving(2.0, rate=0.5), moving(0.0, rate=3.0))
    >>> coordinate_accelerations(4.0, P, cord=(-72.0, 12.0, 0.0))
    (0.0, 0.0)
    """
    forces = {
        name: F if isinstance(F, Vector) else P.local.vector(*_three(F, name))
        for name, F in forces.items()
    }
    kind, parts = "acceleration by forces", _per_mass(m, forces)
    total = named_sum(kind, f"of {P.name}", parts, P.local)
    # the acceleration is linear in the second rates, with the scale factors h: the difference in
    # acceleration, over h, is that in the second rates
    missing = (total - P.acceleration(P.ground)).expressed_in(P.local).c
    if any(map(vanishes, P.scale_factors)):
        raise SingularError(
            f"a coordinate moves nothing at {P.name}, by {P.scale_factors}: turn the axes"
        )
    changes = zip(P.coordinates, missing, P.scale_factors, strict=False)  # two in the plane
    return tuple(to_plain(q.acceleration + a / h) for q, a, h in changes)


@checked
def relative_acceleration(m: Scalar, P: Point, observer: Frame, **forces: Vector) -> Vector:
    """The acceleration of ``P`` seen in its own moving frame (6.10), with the terms F/m of each
    force, and ``origin``, ``coriolis``, ``euler``, ``centrifugal`` as seen.

    P : a point with its coordinates and their rates in the moving frame; second rates are ignored
    observer : an inertial frame; forces : Vectors, by name

    >>> from newton_euler import Frame, moving
    >>> ground = Frame("ground"); disk = ground.rotate("disk", "z", rate=2.0)
    >>> P = disk.point("P", moving(3.0, rate=1.0), 0, 0)
    >>> a = relative_acceleration(1.0, P, ground, spring=-5.0*disk.i)
    >>> print(a, a.terms["coriolis"])
    [7, -4, 0] in disk [0, -4, 0] in disk
    """
    seen = P.acceleration(observer, via=P.frame).terms
    names = {n: n for n in ("origin", "coriolis", "euler")} | {"centrifugal": "centripetal"}
    parts: list[tuple[str, Vector]] = [(Chosen(n), F) for n, F in _per_mass(m, forces).items()]
    parts += [(name, -seen[term]) for name, term in names.items() if seen]
    subject = f"of {P.name} in {P.frame.name}"
    return named_sum("relative acceleration", subject, parts, P.frame)


def _per_mass(m, forces):
    m = _mass(m)
    return {name: F / m for name, F in forces.items()}


def _three(F, name):
    if len(F) > 3:
        raise FrameError(f"the force {name} has {len(F)} components: {F!r}; give 3, or 2")
    return (*F, 0, 0, 0)[:3]
