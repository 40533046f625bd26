"""Degrees of freedom and holonomic constraints (5.11): counted by the rank of the constraints, redundant ones named.

A body has coordinates of its own (Table 5-1); a constraint is a function of them that must vanish (5.28). Whether constraints are independent is
not seen from their number but from the rank of their Jacobian at a general configuration; derivatives are exact (no step size).
"""

import inspect
import random
from dataclasses import dataclass

from .jets import Moving
from .scalars import is_finite, is_numeric, scalar
from .vectors import Vector

# Table 5-1, and the coordinates that a constraint gets
KINDS = {
    "particle": 3,  # x, y, z
    "particle in plane": 2,  # x, y
    "particle on line": 1,  # x
    "body": 6,  # x, y, z of one of its points, and three angles
    "body in plane": 3,  # x, y of one of its points, and an angle
}


class ConstraintError(ValueError):
    """Constraints that cannot all hold, or that are not functions of the coordinates."""


@dataclass(frozen=True)
class Freedom:
    """The degrees of freedom of a system: ``count`` = ``unknowns`` - ``rank``.

    redundant : names of constraints that follow from those before them (at a general configuration), with how many of their equations do
    configuration : the coordinates by body at which the rank was taken
    singular : at the configuration that was asked for, the rank is lower than in its neighbourhood: instantly freer, as a linkage at its dead point
    """

    count: int
    unknowns: int
    rank: int
    redundant: dict
    configuration: dict
    singular: bool = False

    def __index__(self):
        return self.count

    def __str__(self):
        lines = [f"{self.count} degrees of freedom: {self.unknowns} coordinates less {self.rank} independent constraints"]
        lines += [f"  redundant: {name}, {times} of its equations follow from the constraints before it" for name, times in self.redundant.items()]
        return "\n".join(lines + ["  the configuration is singular: nearby the constraints take away more"] * self.singular)


def degrees_of_freedom(bodies, constraints=None, at=None, tolerance=1e-9, seed=5):
    """The :class:`Freedom` of a system of bodies under holonomic constraints (5.11): DOF = unknowns - rank of the Jacobian.

    bodies : name -> kind, one of :data:`KINDS`, or a number of coordinates
    constraints : name -> function that vanishes (5.28), of the bodies it names as its parameters, each a tuple of coordinates (lengths and radians);
        it returns a scalar or a tuple of them, in arithmetic and with functions of this package
    at : name -> coordinates: a configuration to look at; default: general ones, found from random places (``seed``) by Newton's method
    tolerance : singular values of the Jacobian below it, relative to the largest, count as zero; its rows are scaled to 1 before
    Raises :class:`ConstraintError` if no configuration meets the constraints. Springs, dampers and weights are forces and no constraints.

    >>> pendulum = degrees_of_freedom({"P": "particle in plane"}, {"rod": lambda P: P[0]**2 + P[1]**2 - 1})
    >>> pendulum.count
    1
    """
    system = _System(bodies, constraints or {})
    found = [system.settled(random.Random(seed + n)) for n in range(3)]
    best = max((system.rank(q, tolerance) for q in found), default=0)
    general = next(q for q in found if system.rank(q, tolerance) == best)
    if at is None:
        return Freedom(system.size - best, system.size, best, system.redundant(general, tolerance), system.by_name(general))
    q = system.given(at)
    rank = system.rank(q, tolerance)
    near = system.rank(system.settled(random.Random(seed), q, 0.05), tolerance)
    return Freedom(system.size - rank, system.size, rank, system.redundant(q, tolerance), system.by_name(q), rank < near)


class _System:
    """Bodies and constraints as functions of one list of coordinates."""

    def __init__(self, bodies, constraints):
        self.places, self.size, self.constraints = {}, 0, []
        for name, kind in bodies.items():
            count = KINDS.get(kind, kind)
            if type(count) is not int or count < 1:
                raise ConstraintError(f"the kind of {name} is one of {', '.join(map(repr, KINDS))}, or a number of coordinates; got {kind!r}")
            self.places[name] = slice(self.size, self.size + count)
            self.size += count
        for name, f in constraints.items():
            parameters = inspect.signature(f).parameters
            names = [n for n, p in parameters.items() if n in self.places or p.default is p.empty]  # lambda P, L=2: ... has one body
            unknown = [n for n in names if n not in self.places]
            if unknown or not names:
                raise ConstraintError(f"the constraint {name!r} takes {names or 'nothing'}; its parameters are bodies: {', '.join(self.places)}")
            self.constraints.append((name, names, f))

    def by_name(self, q):
        return {name: tuple(float(x) for x in q[place]) for name, place in self.places.items()}

    def equations(self, q):
        """(name, value) of every scalar equation."""
        for name, names, f in self.constraints:
            try:
                value = f(*(tuple(q[self.places[n]]) for n in names))
            except (IndexError, ZeroDivisionError, OverflowError) as problem:
                raise ConstraintError(f"the constraint {name!r} fails: {problem}; numbers of coordinates: {self._kinds(names)}") from problem
            for x in value if isinstance(value, (tuple, list, Vector)) else (value,):
                yield name, scalar(x)

    def _kinds(self, names):
        return ", ".join(f"{n} {self.places[n].stop - self.places[n].start}" for n in names)

    def values(self, q):
        import numpy as np

        return np.array([float(_number(name, x)) for name, x in self.equations(list(map(float, q)))])

    def jacobian(self, q):
        """Rows of equations, columns of coordinates; each column by one run on numbers that carry their derivative."""
        import numpy as np

        columns = []
        for n in range(self.size):
            moved = [Moving(float(x), 1) if n == m else float(x) for m, x in enumerate(q)]
            columns.append([float(_number(name, x.rate)) if isinstance(x, Moving) else 0.0 for name, x in self.equations(moved)])
        return np.array(columns).T.reshape(-1, self.size)

    def settled(self, dice, start=None, spread=1.0):
        """A configuration that meets the constraints, from a random one near ``start``, by Newton's method of least change."""
        for _ in range(20):
            begin = [dice.gauss(0.0, spread) + (0.0 if start is None else start[n]) for n in range(self.size)]
            q = self._newton(begin)
            if q is not None:
                self._look_for_flat_ones(begin, q)
                return q
        names = ", ".join(name for name, _, _ in self.constraints)
        raise ConstraintError(f"no configuration was found in which all constraints hold ({names}): do two of them contradict each other?")

    def _newton(self, begin):
        """The solution that 80 steps from ``begin`` lead to, or None."""
        import numpy as np

        q = np.array(begin)
        for _ in range(80):
            values = self.values(q)
            if not len(values) or np.abs(values).max() <= 1e-13 * max(1.0, np.abs(q).max()):
                return q
            q = q - np.linalg.lstsq(self.jacobian(q), values, rcond=1e-9)[0]
            if not np.isfinite(q).all():
                return None
        return q if np.abs(self.values(q)).max() <= 1e-9 * max(1.0, np.abs(q).max()) else None

    def _look_for_flat_ones(self, begin, q):
        """A constraint whose gradient vanishes wherever it holds, as x**2 + y**2 = 0, hides how many coordinates it takes away."""
        import numpy as np

        before, after = (np.linalg.norm(self.jacobian(p), axis=1) for p in (begin, q))
        for (name, _), a, b in zip(self.equations(list(map(float, q))), before, after, strict=True):
            if b < 1e-5 * a:
                raise ConstraintError(
                    f"the gradient of the constraint {name!r} vanishes where it holds, so it does not tell how many degrees of freedom it takes; "
                    "split it: x**2 + y**2 = 0 is x = 0 and y = 0, two constraints"
                )

    def given(self, at):
        import numpy as np

        missing = [name for name in self.places if name not in at]
        if missing or len(at) != len(self.places):
            raise ConstraintError(f"at= gives the coordinates of every body ({', '.join(self.places)}); it has {', '.join(at)}")
        q = np.concatenate([np.atleast_1d(np.asarray(at[name], dtype=float)) for name in self.places])
        if len(q) != self.size:
            raise ConstraintError(f"at= holds {len(q)} numbers; the bodies have {self.size} coordinates")
        for name, x in self.equations(list(map(float, q))):
            if abs(float(x)) > 1e-6 * max(1.0, float(abs(q).max())):
                raise ConstraintError(f"the configuration at= does not meet the constraint {name!r}: it is {float(x):.3g} instead of 0")
        return q

    def _scaled(self, q):
        """The Jacobian with each row divided by its length; rows of zeros stay."""
        import numpy as np

        J = self.jacobian(q)
        lengths = np.linalg.norm(J, axis=1, keepdims=True)
        return J / np.where(lengths > 0, lengths, 1.0)

    def rank(self, q, tolerance):
        import numpy as np

        return int(np.linalg.matrix_rank(self._scaled(q), tol=tolerance * max(1, len(self.constraints)))) if self.constraints else 0

    def redundant(self, q, tolerance):
        """Each constraint whose rows lie in the span of the rows before, and how many of its rows."""
        import numpy as np

        if not self.constraints:
            return {}
        basis, found = np.zeros((0, self.size)), {}
        for (name, _), row in zip(self.equations(list(map(float, q))), self._scaled(q), strict=True):
            rest = row - basis.T @ (basis @ row)
            rest = rest - basis.T @ (basis @ rest)
            if np.linalg.norm(rest) > tolerance * len(self.constraints):
                basis = np.vstack([basis, rest / np.linalg.norm(rest)])
            else:
                found[name] = found.get(name, 0) + 1
        return found


def _number(name, x):
    if not is_numeric(x):
        raise ConstraintError(f"the constraint {name!r} gives {x!r}; degrees of freedom are counted in numbers: put numbers in for its symbols")
    if not is_finite(x):
        raise ConstraintError(f"the constraint {name!r} is {x} at some place; write it so that it has a value everywhere, as x**2 + y**2 - L**2")
    return x
