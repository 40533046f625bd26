"""Ladders: the models of one scene from the coarsest to the fullest, and the smallest that will do.

Rungs may have different states, but the same quantity is *observed*, as the position of a shot. The
error of a rung is its largest distance from the fullest, measured where no bound is known.
"""

import math
import textwrap
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from types import MappingProxyType
from typing import TYPE_CHECKING

from ..algebra.errors import Tolerance, checked, checked_but
from ..algebra.late import np
from ..algebra.portable import Formulas, Portable
from ..algebra.reads import Reads
from ..algebra.scalars import Scalar, is_numeric, max_abs
from ..motion.model import Model, ModelError

if TYPE_CHECKING:
    from numpy import ndarray

INSTANTS = 257  # instants at which rungs are compared: steps of t/256, exact in binary
FINER = 1e-3  # share of the tolerance that integration may contribute to a measured error
# relative errors of the states: the second is tried where the first is not enough
ROUGH, FINEST = 1e-9, 1e-11


@checked
@dataclass(frozen=True, eq=False)
class Rung(Portable):
    """One model of a ladder.

    model : it ``neglects`` what the fuller rungs contain, with bounds of its error
    start : its states at t = 0
    observed : a function ``(s, p, t)`` of its states that returns what is observed, a tuple, in the
        unit of the ladder
    """

    model: Model
    start: tuple[Scalar, ...]
    observed: Formulas

    @property
    def name(self) -> str:
        """The name of the model."""
        return self.model.name

    @checked_but("t")
    def bound(self, t: float) -> float:
        """The bound of the error until ``t`` by what the model neglects; inf where unknown."""
        bounds = list(self.model.neglected(t, self.start).values())
        if not all(map(is_numeric, bounds)):
            raise ModelError(f"the bounds of {self.name!r} need numbers as parameters and start")
        return float(sum(map(max_abs, bounds))) if bounds else math.inf


def observed_states(*names: str) -> Formulas:
    """The function for :class:`Rung` that returns the states of these names."""
    return lambda s, p, t: tuple(getattr(s, n) for n in names)


@checked
@dataclass(frozen=True, eq=False)
class Ladder:
    """The models of one scene, with one start, for one question.

    of, t : what is observed, with its unit, as "position, m", and for what time
    rungs : a tuple of :class:`Rung`, the coarsest first; the last, the fullest, measures the others
    """

    name: str
    of: str
    t: float
    rungs: tuple[Rung, ...]

    def __post_init__(self):
        names = [rung.name for rung in self.rungs]
        if len(set(names)) < len(names) or not names:
            raise ModelError(f"the rungs of {self.name!r} need names of their own, got {names}")
        other = [n.of for rung in self.rungs for n in rung.model.neglects if n.of != self.of]
        if other:
            raise ModelError(
                f"the bounds of {self.name!r} are of different quantities: {self.of}; {other[0]}"
            )

    def __getstate__(self):
        return {n: x for n, x in vars(self).items() if n != "_found"}

    @classmethod
    @checked
    def of_models(
        cls,
        name: str,
        of: str,
        t: float,
        start: tuple[Scalar, ...],
        names: Sequence[str],
        *models: Model,
    ) -> "Ladder":
        """The ladder of models with the same states: these ``names`` are observed."""
        observed = observed_states(*names)
        return cls(name, of, t, tuple(Rung(model, start, observed) for model in models))

    @property
    def fullest(self) -> Rung:
        """The last rung."""
        return self.rungs[-1]

    @checked
    def rung(self, name: str) -> Rung:
        """The rung of this name."""
        found = {rung.name: rung for rung in self.rungs}
        if name not in found:
            raise ModelError(f"{self.name} has no rung {name!r}; it has {', '.join(found)}")
        return found[name]

    @checked
    def observe(self, rung: Rung, rtol: float) -> "ndarray":
        """What is observed of a rung, an array (components, instants), at this ``rtol``."""
        from ..motion.integration import integrate
        from ..motion.prepared import prepared_model
        from ..motion.solution import FarError

        times = np.linspace(0.0, self.t, INSTANTS)
        try:
            motion = integrate(rung.model, self.t, rung.start, rtol, samples=times)
        except FarError as error:  # as the radial speed on a nearly circular orbit
            motion = error.reached
        values = prepared_model(rung.model).function(rung.observed)(times, *motion.states.values())
        return np.array([np.broadcast_to(v, times.shape) for v in values], dtype=float)

    @checked
    def observed(self, rung: Rung, accuracy: Tolerance) -> "ndarray":
        """The same within about ``accuracy``, in the ladder's unit, if this can be reached."""
        values = self.observe(rung, ROUGH)
        return values if ROUGH * abs(values).max() <= accuracy else self.observe(rung, FINEST)

    @checked
    def error(self, rung: Rung, accuracy: Tolerance = 0.0) -> float:
        """The largest of :meth:`distances`, to within ``accuracy`` (by default the best that can be
        reached); infinite for a rung that cannot be integrated to the end.
        """
        return float(self.distances(rung, accuracy).max())

    @checked
    def distances(self, rung: Rung, accuracy: Tolerance = 0.0) -> "ndarray":
        """The distance from the fullest rung at each of the instants; the largest is the error."""
        if rung is self.fullest:
            return np.zeros(INSTANTS)
        full = self.fullest
        observed = self._kept(accuracy, [full], lambda: self.observed(full, accuracy))
        return self._kept(accuracy, [rung, full], lambda: self._apart(rung, observed, accuracy))

    def _apart(self, rung, full, accuracy):
        try:
            apart = self.observed(rung, accuracy) - full
        except ModelError:
            return np.full(INSTANTS, math.inf)
        far = (apart**2).sum(axis=0) ** 0.5
        return np.where(np.isnan(far), math.inf, far)  # nan where an exact solution ends

    def _kept(self, accuracy, rungs, compute):
        """The value computed with this accuracy or better, while what its functions read holds."""
        key = tuple(rungs)  # rungs by identity: one of another ladder may have the same name
        known = self._found.get(key)
        if known is None or known[1] > accuracy or not known[2].hold():
            reads = Reads(*(f for rung in rungs for f in (rung.model, rung.observed)))
            known = self._found[key] = compute(), accuracy, reads
        return known[0]

    @cached_property
    def _found(self):
        return {}


@dataclass(frozen=True)
class Evidence:
    """The ``bound`` of a rung's error (inf if unknown), and its ``error`` (None if not needed)."""

    bound: float
    error: float | None


@dataclass(frozen=True)
class Choice:
    """The ``rung`` found by :func:`smallest`, and by name the :class:`Evidence` of all up to it."""

    rung: Rung
    evidence: Mapping
    tolerance: float
    of: str

    @property
    def model(self) -> Model:
        """The model of the rung."""
        return self.rung.model

    def explain(self) -> str:
        """The evidence rung by rung, and what the chosen one leaves out, as text."""
        lines = [f"for {self.of}, within {self.tolerance:.3g}:"]
        for name, e in self.evidence.items():
            bound = f"off by at most {e.bound:.3g}" if e.bound < math.inf else "no bound is known"
            error = "" if e.error is None else f", by {e.error:.3g} from the fullest"
            lines.append(f"{'takes' if name == self.rung.name else 'not'} {name}: {bound}{error}")
        if self.model.neglects:
            left = ", ".join(n.what for n in self.model.neglects)
            lines.append(textwrap.fill(f"it leaves out {left}", 96))
        return "\n".join(lines)

    __str__ = explain


@checked
def smallest(ladder: Ladder, tolerance: float) -> Choice:
    """The :class:`Choice` of the smallest rung, the first on the ladder, whose error stays within
    ``tolerance``, in the ladder's unit.

    A rung is accepted if the bound of what it neglects is small enough, or its motion near enough
    to that of the fullest, whose own bound is added. :class:`ModelError` if none is accepted.

    >>> from newton_euler.scenes import ladder
    >>> print(smallest(ladder("projectile"), 2.0))
    for position, m, within 2:
    not projectile, flat: off by at most 4.44, by 2.84 from the fullest
    takes projectile, Coriolis to first order: off by at most 2.02, by 1.23 from the fullest
    it leaves out the Coriolis acceleration beyond the first order in the rotation, the centrifugal
    acceleration, the change of the attraction with place, the air
    """
    if not tolerance > 0:
        raise ModelError(f"the tolerance is a positive number, {ladder.of}; got {tolerance!r}")
    evidence, left = {}, ladder.fullest.bound(ladder.t)
    left = 0.0 if left == math.inf else left
    for rung in ladder.rungs:
        bound, error = rung.bound(ladder.t), None
        if rung is ladder.fullest:
            bound = left
        elif bound > tolerance:
            error = ladder.error(rung, FINER * tolerance)
        evidence[rung.name] = Evidence(bound, error)
        if min(bound, math.inf if error is None else error + left) <= tolerance:
            return Choice(rung, MappingProxyType(evidence), tolerance, ladder.of)
    bounds = ", ".join(f"{name}: {e.bound:.3g}" for name, e in evidence.items())
    raise ModelError(f"no model is as accurate as {tolerance:.3g}; the errors may reach {bounds}")
