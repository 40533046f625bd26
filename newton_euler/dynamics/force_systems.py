"""Force systems (8.1, 8.7): forces at points and couples, their resultant, their moment about any
point, the wrench.

A rigid body feels of all its forces only the resultant force and the moment about one point:
systems that agree in both are equivalent, and a force may be moved if the couple of its moment goes
with it (8.20). Forces may hold unknowns of :func:`newton_euler.algebra.linear.solve_linear`.

>>> from newton_euler import Frame
>>> ground = Frame("ground")
>>> A = ground.point("A", 2.0, 0, 0)
>>> pull = ForceSystem({"rope": (ground.vector(0, 3.0, 0), A), "motor": Couple(ground.vector(0, 0, 1.0))})
>>> pull.moment(ground).z, pull.moment(A).z
(7.0, 1.0)
"""

from collections.abc import Mapping
from dataclasses import dataclass, replace

from ..algebra.ledger import equations
from ..algebra.scalars import is_numeric, least, plain, scalar, short, size
from ..algebra.vectors import FrameError, Vector, add3, named_sum
from ..kinematics.frames import place

EQUATIONS = equations({
    "resultant": ("8.21", r"\mathbf{F}^e", {}),
    "moment of the forces": ("8.7", r"\mathbf{M}", {}),
})  # fmt: skip
ROUND_OFF = 1e-12  # of the sum of the magnitudes: a resultant below it is none


class ForceError(FrameError):
    """What is no force or couple, or a question about a system that it has no answer to."""


@dataclass(frozen=True)
class Force:
    """A force at a point (of application, or any point of its line): ``vector`` in N, ``point`` a
    Point.
    """

    vector: Vector
    point: object
    name: str = "force"

    def moment(self, about):
        """Its moment about a Point or the origin of a Frame: d x F, d from there to the point of
        the force (8.4); N m.
        """
        return (
            (self.point - place(about, "the point that the moment is about"))
            .expressed_in(self.vector.frame)
            .cross(self.vector)
        )

    def moved(self, to):
        """The equivalent system with the force at ``to`` and the couple M = CA x F, of its moment
        about C = ``to`` (8.20).

        >>> from newton_euler import Frame
        >>> ground = Frame("ground")
        >>> print(Force(ground.vector(0, 3.0, 0), ground.point("A", 2.0, 0, 0)).moved(ground))
        force: [0, 3, 0] in ground at origin of ground
        couple of force: [0, 0, 6] in ground
        """
        to = place(to, "the force that is moved")
        return ForceSystem(
            [Force(self.vector, to, self.name), Couple(self.moment(to), f"couple of {self.name}")]
        )

    def __str__(self):
        return f"{self.name}: {self.vector} at {self.point.name}"


@dataclass(frozen=True)
class Couple:
    """A couple: ``vector``, its moment in N m, the same about every point."""

    vector: Vector
    name: str = "couple"

    def moment(self, about=None):
        """Its moment: about any point the same."""
        return self.vector

    def __str__(self):
        return f"{self.name}: {self.vector}"


class ForceSystem:
    """Forces and couples on one body.

    parts : a dict by name of pairs (Vector, Point) and :class:`Couple`, or a sequence of
        :class:`Force`, :class:`Couple`, such pairs, and systems
    frame : whose components the results have; default: that of the first vector
    """

    def __init__(self, parts=(), frame=None):
        pairs = (
            list(parts.items()) if isinstance(parts, Mapping) else [(None, part) for part in parts]
        )
        self.parts = tuple(_distinct([one for name, part in pairs for one in _parts(name, part)]))
        if not self.parts and frame is None:
            raise ForceError("a system without forces needs a frame: ForceSystem([], frame=ground)")
        self.frame = frame or self.parts[0].vector.frame

    def __str__(self):
        return "\n".join(map(str, self.parts)) or "no forces"

    def __add__(self, other):
        return ForceSystem([*self.parts, *ForceSystem([other]).parts], self.frame)

    @property
    def force(self):
        """The resultant force, the sum of all (8.21). terms : the forces by name."""
        return named_sum(
            EQUATIONS["resultant"], "", {p.name: p.vector for p in self._forces()}, self.frame
        )

    def moment(self, about):
        """The moment about a Point (or the origin of a Frame) of all forces and couples (8.7).
        terms : their moments by name.
        """
        about = place(about, "the point that the moment is about")
        return named_sum(
            EQUATIONS["moment of the forces"],
            f"about {about.name}",
            {p.name: p.moment(about) for p in self.parts},
            self.frame,
        )

    def at(self, point):
        """The equivalent system of one force at ``point`` and one couple, the moment about it
        (8.7).
        """
        point = place(point, "the forces together")
        return ForceSystem(
            [Force(self.force, point, "resultant"), Couple(self.moment(point), "resultant couple")],
            self.frame,
        )

    def equivalent(self, other, tolerance=1e-9):
        """True if the other system has the same resultant force and moment, to ``tolerance`` times
        the magnitudes in both. For numbers.
        """
        about = self._anywhere(other)
        forces = max((_size(f.vector) for f in (*self._forces(), *other._forces())), default=0.0)
        moments = max((_size(p.moment(about)) for p in (*self.parts, *other.parts)), default=0.0)
        noise = self._noise(about) + other._noise(about)
        apart = _size(self.force - other.force), _size(self.moment(about) - other.moment(about))
        return apart[0] <= tolerance * forces and apart[1] <= tolerance * moments + noise

    def _noise(self, about):
        """What rounding may leave of the moments: of each force, some round-offs of its magnitude
        times the coordinates of the points.
        """
        return sum(
            ROUND_OFF
            * _size(f.vector)
            * (_size(f.point.position(self.frame)) + _size(about.position(self.frame)))
            for f in self._forces()
        )

    def _forces(self):
        return [p for p in self.parts if isinstance(p, Force)]

    def _anywhere(self, *others):
        """A point that the system offers: that of its first force, else the origin of its frame."""
        points = [f.point for s in (self, *others) for f in s._forces()]
        return points[0] if points else place(self.frame, "")

    def wrench(self, about=None):
        """The simplest equivalent system: the force on its central axis and the couple along it; a
        :class:`Wrench`.

        about : the Point (or Frame) from which the axis is looked for: the answer's point is the
            nearest to it. Default: where the first force acts

        >>> from newton_euler import Frame
        >>> ground = Frame("ground")
        >>> s = ForceSystem([(ground.vector(0, 0, 2.0), ground.point("A", 1.0, 0, 0)), Couple(ground.vector(0, 3.0, 4.0))])
        >>> print(s.wrench(ground))
        a force [0, 0, 2] in ground on the axis through (-0.5, 0, 0) of ground with a couple along it, pitch 2
        """
        about = (
            self._anywhere()
            if about is None
            else place(about, "the point that the axis is looked for from")
        )
        F, M = self.force, self.moment(about)
        kind = self._kind(F, M, about)
        if kind in ("nothing", "couple"):
            return Wrench(kind, F, M, None, None)
        square = scalar(F.dot(F))
        pitch = plain(scalar(F.dot(M)) / square)
        offset = (F.cross(M) / square).expressed_in(about.frame)
        point = about.frame.point(
            "axis of the wrench", *add3(about.position(about.frame).c, offset.c)
        )
        return Wrench(kind, F, F * pitch, point, pitch)

    def _kind(self, F, M, about):
        """Which degenerate case it is. Of expressions only what is zero by its form is seen."""
        forces = ROUND_OFF * sum(_size(f.vector) for f in self._forces())
        moments = ROUND_OFF * sum(_size(p.moment(about)) for p in self.parts) + self._noise(about)
        if _nothing(scalar(F.norm()), forces):
            return "nothing" if _nothing(scalar(M.norm()), moments) else "couple"
        along = scalar(F.dot(M))
        return (
            "force"
            if is_numeric(along) and size(along) <= size(scalar(F.norm())) * moments
            else "wrench"
        )


@dataclass(frozen=True)
class Wrench:
    """A system reduced as far as it goes; ``print`` it for words.

    kind : "wrench"; "force", a single force without couple; "couple", without a force, about which
        every point is alike; "nothing", in balance
    force : the resultant; moment : the couple along it, pitch times force (of a couple: all of it)
    point : the Point of the central axis nearest to where it was looked for; None without a force
    pitch : couple over force (length), positive for a right-handed screw; None without a force
    """

    kind: str
    force: Vector
    moment: Vector
    point: object
    pitch: object

    def __str__(self):
        if self.kind == "nothing":
            return "in balance: neither a force nor a couple is left"
        if self.kind == "couple":
            return (
                f"a couple {self.moment}, the same about every point: there is no resultant "
                "force, and so no axis"
            )
        place = (
            f"({', '.join(short(x) for x in self.point.position(self.point.frame))}) of "
            f"{self.point.frame.name}"
        )
        if self.kind == "force":
            return f"a single force {self.force} on the line through {place}"
        return (
            f"a force {self.force} on the axis through {place} with a couple along it, pitch "
            f"{short(self.pitch)}"
        )


def _parts(name, part):
    """The forces and couples that a user means by ``part``."""
    if isinstance(part, ForceSystem):
        return part.parts
    if isinstance(part, Couple):
        return [Couple(part.vector, name or part.name)]
    if not isinstance(part, Force):
        try:
            vector, point = part
        except (TypeError, ValueError):
            raise ForceError(
                f"a force is a pair (Vector, Point), a couple is Couple(Vector); got {part!r}"
            ) from None
        part = Force(vector, point)
    if not isinstance(part.vector, Vector):
        raise ForceError(
            f"the vector of a force is a Vector, as ground.vector(0, 0, -9.81); got {part.vector!r}"
        )
    return [Force(part.vector, place(part.point, name or part.name), name or part.name)]


def _distinct(parts):
    """The parts with names that differ: a second "force" becomes "force 2"."""
    seen, out = {}, []
    for part in parts:
        seen[part.name] = n = seen.get(part.name, 0) + 1
        out.append(part if n == 1 else replace(part, name=f"{part.name} {n}"))
    return out


def _size(v):
    length = scalar(v.norm())
    return size(length) if is_numeric(length) else float("inf")


def _nothing(x, noise):
    """True if the magnitude x is rounding; for arrays at every instant, and an error if at some
    only.
    """
    if is_numeric(x) and least(x) <= noise < size(x):
        raise ForceError(
            "the forces have a resultant at some instants and at others none; ask for their "
            "wrench at these instants apart"
        )
    return is_numeric(x) and size(x) <= noise
