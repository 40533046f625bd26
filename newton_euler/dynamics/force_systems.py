"""Force systems (8.1, 8.7): forces at points, and couples, their resultant, their moment about any
point. Systems that agree in force and moment are equivalent (8.20). Forces may hold
unknowns of :func:`newton_euler.solve_linear`.

>>> from newton_euler import Frame
>>> ground = Frame("ground")
>>> A = ground.point("A", 2.0, 0, 0)
>>> rope, motor = (ground.vector(0, 3.0, 0), A), Couple(ground.vector(0, 0, 1.0))
>>> pull = ForceSystem({"rope": rope, "motor": motor})
>>> pull.moment(ground).z, pull.moment(A).z
(7.0, 1.0)
"""

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, replace
from typing import TypeAlias

from ..algebra.errors import Tolerance, checked, checked_but
from ..algebra.ledger import distinct
from ..algebra.names import guided
from ..algebra.scalars import is_numeric, max_abs, scalar
from ..algebra.vectors import FrameError, Vector, named_sum
from ..kinematics.frames import Frame, Point, PointLike, as_point

ROUND_OFF = 1e-12  # fraction of the sum of magnitudes below which a resultant counts as zero


class ForceError(FrameError):
    """Not a force or couple, or a system that does not have the requested result."""


@checked_but("point")
@dataclass(frozen=True)
class Force:
    """A force, ``vector`` in N, at the Point ``point`` of its line of action."""

    vector: Vector
    point: Point
    name: str = "force"

    def __post_init__(self):
        object.__setattr__(self, "point", as_point(self.point, self.name))

    @checked
    def moment(self, about: Point | Frame) -> Vector:
        """The moment d x F about a Point or the origin of a Frame, d from there (8.4); N m."""
        d = self.point - as_point(about, "the point that the moment is about")
        return d.expressed_in(self.vector.frame).cross(self.vector)

    @checked
    def moved(self, to: Point | Frame) -> "ForceSystem":
        """The equivalent force at ``to`` and couple of its moment about ``to`` (8.20).

        >>> from newton_euler import Frame
        >>> ground = Frame("ground")
        >>> print(Force(ground.vector(0, 3.0, 0), ground.point("A", 2.0, 0, 0)).moved(ground))
        force: [0, 3, 0] in ground at origin of ground
        couple of force: [0, 0, 6] in ground
        """
        P = as_point(to, "the force that is moved")
        couple = Couple(self.moment(P), f"couple of {self.name}")
        return ForceSystem([replace(self, point=P), couple])

    def __str__(self):
        return f"{self.name}: {self.vector} at {self.point.name}"


@checked
@dataclass(frozen=True)
class Couple:
    """A couple: ``vector``, its moment in N m, the same about every point."""

    vector: Vector
    name: str = "couple"

    @checked
    def moment(self, about: object = None) -> Vector:
        """The moment, about any point the same."""
        return self.vector

    def __str__(self):
        return f"{self.name}: {self.vector}"


@guided
class ForceSystem:
    """Forces and couples on one body.

    parts : a dict by name of pairs (Vector, Point) and :class:`Couple`, or a sequence of
        :class:`Force`, :class:`Couple`, such pairs, and systems
    frame : whose components the results have; default: that of the first vector
    """

    @checked
    def __init__(self, parts: Iterable | Mapping = (), frame: Frame | None = None):
        pairs = parts.items() if isinstance(parts, Mapping) else ((None, part) for part in parts)
        self.parts = tuple(part for name, given in pairs for part in _parts(name, given))
        if not self.parts and frame is None:
            raise ForceError("a system without forces needs a frame: ForceSystem([], frame=ground)")
        self.frame = frame or self.parts[0].vector.frame

    def __str__(self):
        names = distinct([part.name for part in self.parts])
        parts = (replace(p, name=name) for p, name in zip(self.parts, names, strict=True))
        return "\n".join(map(str, parts)) or "no forces"

    def __add__(self, other: "ForceSystem") -> "ForceSystem":
        return ForceSystem([self, other], self.frame)

    @property
    def force(self) -> Vector:
        """The resultant force (8.21), with the forces by name as terms."""
        forces = [(p.name, p.vector) for p in self._forces()]
        return named_sum("resultant", "of the forces", forces, self.frame)

    @checked
    def moment(self, about: Point | Frame) -> Vector:
        """The moment of all about a Point or the origin of a Frame (8.7), with each as a term."""
        about = as_point(about, "the point that the moment is about")
        moments = [(p.name, p.moment(about)) for p in self.parts]
        subject = f"about {about.name}"
        return named_sum("moment of the forces", subject, moments, self.frame)

    @checked
    def at(self, point: Point | Frame) -> "ForceSystem":
        """The equivalent system of the resultant force at ``point`` and one couple (8.7)."""
        P = as_point(point, "the forces together")
        couple = Couple(self.moment(P), "resultant couple")
        return ForceSystem([Force(self.force, P, "resultant"), couple], self.frame)

    @checked
    def equivalent(self, other: "ForceSystem", tolerance: Tolerance = 1e-9) -> bool:
        """True if force and moment are the same to ``tolerance`` times the magnitudes (8.20)."""
        all_forces = *self._forces(), *other._forces()
        about = all_forces[0].point if all_forces else as_point(self.frame, "")
        forces = max((_size(f.vector) for f in all_forces), default=0.0)
        moments = max((_size(p.moment(about)) for p in (*self.parts, *other.parts)), default=0.0)
        noise = self._noise(about) + other._noise(about)
        return (
            _size(self.force - other.force) <= tolerance * forces
            and _size(self.moment(about) - other.moment(about)) <= tolerance * moments + noise
        )

    def _noise(self, about):
        """The round-off of the moments: of each force, that of its size times coordinates."""
        arm = lambda P: _size(P.position(self.frame))  # noqa: E731
        sizes = (_size(f.vector) * (arm(f.point) + arm(about)) for f in self._forces())
        return ROUND_OFF * sum(sizes)

    def _forces(self):
        return [p for p in self.parts if isinstance(p, Force)]


Part: TypeAlias = Force | Couple | ForceSystem | tuple[Vector, PointLike]
Parts: TypeAlias = Mapping[str, Part] | Iterable[Part]


def _parts(name, part):
    """The forces and couples of ``part``, named ``name`` unless that is None."""
    if isinstance(part, ForceSystem):
        return part.parts
    if isinstance(part, Force | Couple):
        return [replace(part, name=name or part.name)]
    try:
        vector, point = part
    except (TypeError, ValueError):
        raise ForceError(
            f"a force is a pair (Vector, Point), a couple Couple(Vector); got {part!r}"
        ) from None
    return [Force(vector, point, name or "force")]


def _size(v):
    length = scalar(v.norm())
    return max_abs(length) if is_numeric(length) else float("inf")
