"""Degrees of freedom under holonomic constraints (5.11), functions of the bodies' coordinates that
must vanish (5.28): by the rank of their Jacobian, with exact derivatives, at a general
configuration. Redundant constraints are named.
"""

import inspect
import math
import random
from collections import Counter
from dataclasses import dataclass
from operator import mul
from typing import Any

from ..algebra.errors import NewtonEulerError, Tolerance, checked
from ..algebra.jets import Moving
from ..algebra.places import add_place, at_a_place
from ..algebra.scalars import clipped, is_finite, is_numeric, scalar
from ..algebra.vectors import Vector

# Table 5-1, and the coordinates that are passed to a constraint
KINDS = {
    "particle": 3,  # x, y, z
    "particle in plane": 2,  # x, y
    "particle on line": 1,  # x
    "body": 6,  # x, y, z of one of its points, and three angles
    "body in plane": 3,  # x, y of one of its points, and an angle
}


class ConstraintError(NewtonEulerError, ValueError):
    """Constraints that cannot all hold, or that are not functions of the coordinates."""


@dataclass(frozen=True)
class Freedom:
    """The degrees of freedom of a system: ``count`` = ``unknowns`` - ``rank``.

    redundant : names of constraints that follow from those before, and how many of their equations
    configuration : the coordinates by body at which the rank was computed
    bodies : name -> kind, as they were given
    singular : True if at the configuration passed as ``at`` the rank is lower than in its
        neighbourhood, as for a linkage at its dead point
    """

    count: int
    unknowns: int
    rank: int
    redundant: dict
    configuration: dict
    bodies: dict
    singular: bool = False

    def __index__(self) -> int:
        return self.count

    def __str__(self):
        text = (
            f"{self.count} degree{'s' * (self.count != 1)} of freedom: {self.unknowns} coordinates "
            f"less {self.rank} independent constraint{'s' * (self.rank != 1)}"
        )
        for name, times in self.redundant.items():
            text += f"\n  redundant: {name}, {times} of its equations follow{'s' * (times == 1)} "
            text += "from the constraints before it"
        return text + "\n  the configuration is singular: nearby the rank is higher" * self.singular


@checked
def degrees_of_freedom(
    bodies: dict[str, str | int],
    constraints: dict[str, Any] | None = None,
    at: dict[str, Any] | None = None,
    tolerance: Tolerance = 1e-09,
) -> Freedom:
    """The degrees of freedom of a system of bodies under holonomic constraints (5.11): the number
    of coordinates less the rank of the Jacobian. Springs and weights are not constraints.

    bodies : name -> kind, one of :data:`KINDS`, or a number of coordinates
    constraints : name -> function that vanishes (5.28), a scalar or a tuple of them, of the bodies
        it names as its parameters, each a tuple of coordinates (lengths and radians)
    at : name -> coordinates: the configuration at which the rank is computed; default: one that
        Newton's method finds, in no special position; :class:`ConstraintError` if it breaks them
    tolerance : a row of the Jacobian, scaled to 1, depends on those before it if less than this
        lies outside their span

    >>> rod = lambda P: P[0]**2 + P[1]**2 - 1
    >>> degrees_of_freedom({"P": "particle in plane"}, {"rod": rod}).count
    1
    """
    system = _System(bodies, constraints or {})
    q = system.settled() if at is None else system.given(at)
    rank, redundant = system.rank(q, tolerance)
    singular = at is not None and rank < system.rank(system.settled(q, 0.05), tolerance)[0]
    found = system.size - rank, system.size, rank, redundant, system.by_name(q)
    return Freedom(*found, bodies, singular)


class _System:
    """Bodies and constraints as functions of one list of coordinates."""

    def __init__(self, bodies, constraints):
        self.places, self.size, self.constraints = {}, 0, []
        for name, kind in bodies.items():
            count = KINDS.get(kind, kind)
            if type(count) is not int or count < 1:
                raise ConstraintError(
                    f"{name} is a number of coordinates, or {', '.join(KINDS)}; got {kind!r}"
                )
            self.places[name] = slice(self.size, self.size + count)
            self.size += count
        for name, f in constraints.items():
            try:
                parameters = {} if isinstance(f, type) else inspect.signature(f).parameters
            except (TypeError, ValueError):  # not a function, or one in C without names
                parameters = {}
            if not parameters:
                raise ConstraintError(
                    f"the constraint {name!r} is a function of bodies by name, as lambda P: P[0]; "
                    f"got {f!r}"
                )
            # lambda P, L=2: ... has one body
            names = [n for n, p in parameters.items() if n in self.places or p.default is p.empty]
            unknown = [n for n in names if n not in self.places]
            if unknown or not names:
                raise ConstraintError(
                    f"the constraint {name!r} takes {names or '[]'}, not {', '.join(self.places)}"
                )
            self.constraints.append((name, names, f))

    def by_name(self, q):
        return {name: tuple(float(x) for x in q[place]) for name, place in self.places.items()}

    def equations(self, q):
        """[(name, value)] of every scalar equation."""
        found = []  # not a generator, which would turn a StopIteration into another error
        for name, names, f in self.constraints:
            given = {n: tuple(q[self.places[n]]) for n in names}
            try:
                value = f(*given.values())
            except IndexError as problem:
                kinds = (f"{n} {self.places[n].stop - self.places[n].start}" for n in names)
                add_place(problem, f"the constraint {name!r} gets coordinates: {', '.join(kinds)}")
                raise
            except (ZeroDivisionError, OverflowError) as problem:
                where = ", ".join(f"{n} = {clipped(x)}" for n, x in given.items())
                at_a_place(problem, ConstraintError, f"the constraint {name!r} fails at {where}")
                raise
            parts = value if isinstance(value, (tuple, list, Vector)) else (value,)
            found += [(name, scalar(x)) for x in parts]
        return found

    def values(self, q):
        """[(name, float)] of every scalar equation."""
        return [(name, _finite(name, x)) for name, x in self.equations(list(map(float, q)))]

    def jacobian(self, q):
        """The Jacobian, a row for each equation; a column is one evaluation with derivatives."""
        columns = []
        for n in range(self.size):
            moved = [Moving(float(x), 1) if n == m else float(x) for m, x in enumerate(q)]
            rates = ((name, getattr(x, "rate", 0.0)) for name, x in self.equations(moved))
            columns.append([_finite(name, x) for name, x in rates])
        return list(zip(*columns, strict=True))

    def settled(self, near=None, spread=1.0):
        """A configuration that meets the constraints, by Newton's method from a fixed start."""
        chance = random.Random(5)
        near = [0.0] * self.size if near is None else near
        start = q = [x + spread * chance.gauss() for x in near]
        # enough even where a gradient vanishes, and each step only halves the distance
        for _ in range(80):
            values = [x for _, x in self.values(q)]
            off = max(map(abs, values), default=0.0) / max(1.0, *map(abs, q))
            if not off > 1e-13:  # round-off; also ends at nan
                break
            # a redundant equation must not add noise over what is left of its gradient
            basis, _ = _independent(self.jacobian(q), values, 1e-9)
            q = [x - sum(step * row[n] for row, step in basis) for n, x in enumerate(q)]
        if not off < 1e-9:
            names = ", ".join(name for name, _, _ in self.constraints)
            places = ", ".join(f"{name!r}: ..." for name in self.places)
            raise ConstraintError(
                f"no configuration was found for all constraints ({names}): do they contradict "
                f"each other? If not, pass one as at={{{places}}}"
            )
        self._check_gradients(start, q)
        return q

    def _check_gradients(self, start, q):
        """Raises :class:`ConstraintError` where a gradient vanishes, as for x**2 + y**2 = 0."""
        before, after = [[math.hypot(*row) for row in self.jacobian(p)] for p in (start, q)]
        for (name, _), a, b in zip(self.values(q), before, after, strict=True):
            if b < 1e-5 * a:  # at a double zero it falls as the square root of the residual, 1e-13
                raise ConstraintError(
                    f"the gradient of the constraint {name!r} vanishes: split it in two"
                )

    def given(self, at):
        """The configuration ``at``, {body: its coordinates}, as a list of floats; raises
        :class:`ConstraintError` if bodies or numbers are missing, or a constraint does not hold.
        """
        if set(at) != set(self.places):
            raise ConstraintError(
                f"at= gives the coordinates of {', '.join(self.places)}; it has {', '.join(at)}"
            )
        given = (at[n] for n in self.places)
        q = [float(x) for own in given for x in (own if hasattr(own, "__len__") else [own])]
        if len(q) != self.size:
            raise ConstraintError(
                f"at= holds {len(q)} numbers; the bodies have {self.size} coordinates"
            )
        for name, x in self.values(q):
            if abs(x) > 1e-6 * max(1.0, *map(abs, q)):  # as exact as coordinates are typed in
                raise ConstraintError(
                    f"at= does not meet the constraint {name!r}: it is {x:.3g} instead of 0"
                )
        return q

    def rank(self, q, tolerance):
        """The number of independent constraints, and by name of equations that depend on others."""
        names, rows = [name for name, _ in self.values(q)], self.jacobian(q)
        basis, others = _independent(rows, [0.0] * len(rows), tolerance * len(self.constraints))
        return len(basis), Counter(names[n] for n in others)


def _independent(rows, values, tolerance):
    """Pairs (unit vector, its component) of the shortest x with row·x = value for all rows, and the
    numbers of the rows that depend on those before them.
    """
    basis, others = [], []
    for n, (row, value) in enumerate(zip(rows, values, strict=True)):
        size = math.hypot(*row) or 1.0
        rest, left = [x / size for x in row], value / size
        # the second time removes what round-off left: twice is enough (Giraud, Langou and
        # Rozloznik 2005)
        for _ in range(2):
            for unit, step in basis:
                along = sum(map(mul, unit, rest))
                rest = [x - along * e for x, e in zip(rest, unit, strict=True)]
                left = left - along * step
        length = math.hypot(*rest)
        if length > tolerance:
            basis.append(([x / length for x in rest], left / length))
        else:
            others.append(n)
    return basis, others


def _finite(name, x):
    if not is_numeric(x):
        raise ConstraintError(f"the constraint {name!r} gives {x!r}; put numbers in")
    if not is_finite(x):
        raise ConstraintError(
            f"the constraint {name!r} is {x} at some place; write it with a value everywhere"
        )
    return float(x)
