"""Integrate the motion of a model: states at any time, an honest error, the drift of invariants, what it cost, and what happened on the way.

:func:`integrate` is the public face; the methods are in :mod:`.methods`, events in :mod:`.events`, the record in :mod:`.records`.
"""

import math
from contextlib import suppress
from time import perf_counter

from .batches import integrate_batch
from .events import Event
from .journeys import Journey
from .methods import COARSEST, DECADES, METHODS
from .models import ModelError
from .records import Cost, Motion, MotionError
from .systems import prepared, start_state
from .taylor import TAYLOR_MARGIN, ShortSteps, installed

HEYOKA_PAYS = 0.5  # seconds of integrating one right-hand side, after which heyoka's import and compilation would have been earned
RUNS = 5
CAUTION = 4.0  # times the error that the difference foretells
ROUND_OFF = 2e-14  # no estimate is smaller


def integrate(model, t, start, rtol=1e-9, method="auto", events=(), samples=None, progress=None, step=None):
    """The motion of a model from its start: a :class:`~newton_euler.records.Motion`.

    t : the time at which to end, from 0, or a pair (from, to)
    start : the states, in their order or by name; arrays of one length are many starts at once, as are arrays among the parameters of the model
    rtol : the error that the states may have at the end, each relative to its largest size on the way (never below 1e-6 in its unit)
    method : one of :data:`~newton_euler.methods.METHODS`; "auto" takes the exact solution where there is one, and else the straight-line DOP853 until
        heyoka, if it is installed, pays or is needed
    events : :class:`~newton_euler.events.Event`, several in a tuple
    samples : times, or how many at equal distances; default: the ends of the steps
    progress : a function of the fraction of time done, called now and then
    step : a fixed step for methods that have an order; then no accuracy is controlled

    Raises :class:`ModelError` for what cannot be done, and :class:`~newton_euler.records.MotionError`, with what was ``reached``, if the motion
    runs into a singular place.

    >>> from newton_euler.scenes.pendulum import physical_pendulum
    >>> motion = integrate(physical_pendulum(2.0, 0.5, 0.5, 10.0), 10.0, (1.0, 0.0))
    >>> motion.error < 1e-9, motion.drift["energy"] < 1e-9
    (True, True)
    >>> round(motion.at(2.5)["theta"], 6)
    0.433788
    """
    begun = perf_counter()
    system = prepared(model)
    t0, t1 = _span(t)
    state = start_state(model, start)
    events = (events,) if isinstance(events, Event) else tuple(events)
    _check(rtol, method, events, step)
    if system.many or (state is not start and any(type(x) is not float for x in state)):
        return integrate_batch(model, t0, t1, state, rtol, method, events, samples, integrate)
    run = _Run(system, t0, t1, state, rtol, events, progress, begun)
    if step:
        return run.fixed(_usable(method, system), step, samples)
    return run.auto(samples) if method == "auto" else run.by(_usable(method, system, t0), samples)


def _span(t):
    if type(t) is float and 0.0 < t < math.inf:
        return 0.0, t
    try:
        t0, t1 = map(float, t) if hasattr(t, "__iter__") else (0.0, float(t))
    except (TypeError, ValueError) as error:
        raise ModelError(f"t is the time at which to end, or a pair (from, to); got {t!r}") from error
    if not (math.isfinite(t0) and math.isfinite(t1) and t0 < t1):
        raise ModelError(f"time runs forward: the end must come after the start, got from {t0!r} to {t1!r}")
    return t0, t1


def _check(rtol, method, events, step):
    if method != "auto" and method not in METHODS:
        raise ModelError(f"there is no method {method!r}; take 'auto' or one of {', '.join(METHODS)}")
    least = 1e-15 if method == "auto" else METHODS[method].least
    if type(rtol) is float and least <= rtol < 1 and not events and step is None:
        return
    if step is None and not (isinstance(rtol, (int, float)) and least <= rtol < 1):
        what = f"method {method!r} cannot reach it, the least is {least:g}" if isinstance(rtol, (int, float)) and 0 < rtol < 1 else "it lies below 1"
        raise ModelError(f"rtol is the error asked for, got {rtol!r}: {what}")
    for event in events:
        if not isinstance(event, Event):
            raise ModelError(f"events are made by Event(function, direction, ...), got {event!r}")
    if step is not None and not step > 0:
        raise ModelError(f"the step is a positive time, got {step!r}")


def _usable(name, system, t0=0.0):
    if name == "auto":
        raise ModelError("a fixed step needs a method by name")
    trouble = METHODS[name].cannot(system)
    if name == "exact" and t0 and not system.autonomous:
        trouble = f"the rates of {system.model.name!r} depend on time, so its exact solution starts at t = 0"
    if trouble:
        raise ModelError(f"method {name!r} cannot be used: {trouble}")
    return METHODS[name]


class _Run:
    """One question to :func:`integrate`, and the runs that answer it."""

    def __init__(self, system, t0, t1, state, rtol, events, progress, begun):
        self.system, self.t0, self.t1, self.state, self.rtol = system, t0, t1, state, rtol
        self.events, self.progress, self.begun = events, progress, begun
        self.calls, self.prepared = 0, perf_counter()

    def go(self, method, tolerance, sizes=None, step=None, samples=None):
        """One run; SciPy or heyoka are imported and compiled on the way, which is not counted as integrating."""
        journey = Journey(method, self.system, self.t0, self.state, self.t1, tolerance, self.events, self.progress, sizes, step, samples=samples)
        self.calls += journey.calls
        return journey

    def record(self, journey, method, error, samples):
        now = perf_counter()
        cost = Cost(now - self.prepared, self.prepared - self.begun, self.calls)
        motion = Motion(self.system.model, tuple(journey.legs), tuple(journey.occurrences), method, self.rtol, journey.ended, cost, samples, error)
        if journey.trouble:
            raise MotionError(f"{journey.ended}; what was reached is in the error's .reached", motion)
        return motion

    # -- by method

    def auto(self, samples):
        exact = METHODS["exact"]
        if exact.cannot(self.system) is None and (self.t0 == 0 or self.system.autonomous):
            try:
                journey = self.go(exact, self.rtol)
            except ModelError:  # it refuses this start in words: there are other methods
                journey = None
            if journey and self.holds(journey):
                return self.record(journey, exact, journey.exact_error, samples)
        name = cheapest(self.system, self.rtol)
        if name == "taylor":
            try:
                return self.by(METHODS["taylor"], samples)
            except MotionError:  # as where the rates are not analytic: |v| v at rest; Runge-Kutta methods do not mind
                if self.rtol < METHODS["dop853"].least:
                    raise
        return self.calibrated(METHODS["dop853"], samples, heyoka=name != "taylor" and installed())

    def by(self, method, samples):
        if method.calibrated:
            return self.calibrated(method, samples)
        if method.name == "exact":
            journey = self.go(method, self.rtol)
            if not self.holds(journey):
                name, error = self.system.model.name, journey.exact_error()
                why = "it becomes a model without one" if error is None else f"it is not accurate here: its error is about {error:.1g}"
                raise ModelError(f"the closed form of {name!r} does not do: {why}; take method='auto'")
            return self.record(journey, method, journey.exact_error, samples)
        journey = self.go(method, TAYLOR_MARGIN * self.rtol, samples=samples)

        def error():
            again = Journey(method, self.system, self.t0, self.state, self.t1, TAYLOR_MARGIN * self.rtol, self.events, None, None, None, ShortSteps)
            return 2 * journey.difference(again) + 2e-15

        return self.record(journey, method, error, samples)

    def holds(self, journey):
        """True if an exact solution is one: the first of a model is tried by going half of the way twice, and the model is then trusted.

        Of every motion this is its ``error``, when that is asked for.
        """
        if len(journey.legs) > 1 or not self.system.trusted:
            error = journey.exact_error()
            self.system.trusted = error is not None and error <= self.rtol
            return self.system.trusted
        return True

    def fixed(self, method, step, samples):
        if method.order is None:
            raise ModelError(f"method {method.name!r} has no fixed step")
        return self.record(self.go(method, self.rtol, step=step), method, math.nan, samples)

    def calibrated(self, method, samples, heyoka=False):
        """Two runs or more, as :mod:`.methods` says."""
        least = method.tightest
        tolerance = max(min(self.rtol / method.easy, method.loosest), least)
        coarse = min(tolerance * DECADES, COARSEST)
        begun = perf_counter()
        before = self.go(method, coarse)
        spent = perf_counter() - begun
        if heyoka and spent * (coarse / tolerance) ** 0.125 > HEYOKA_PAYS:
            with suppress(MotionError):
                return self.by(METHODS["taylor"], samples)
        journey = self.go(method, tolerance, before.sizes)
        error = self._foretold(before, journey, coarse, tolerance)
        for _ in range(RUNS):
            if error <= self.rtol or tolerance <= least or journey.trouble:
                break
            finer = max(tolerance * max(1 / DECADES, self.rtol / error / 3), least)
            finer = min(finer, tolerance / 4)
            before, journey = journey, self.go(method, finer, journey.sizes)
            error = self._foretold(before, journey, tolerance, finer)
            tolerance = finer
        self.system.traced.seconds += perf_counter() - begun
        return self.record(journey, method, error, samples)

    def _foretold(self, before, journey, coarse, tolerance):
        """The error of a run from its difference to one of coarser tolerance."""
        difference = before.difference(journey)
        if difference > 0.05:
            return difference  # the coarse one is too far off to foretell anything
        steps = sum(len(leg.course.bounds) for leg in journey.legs)
        return CAUTION * difference * tolerance / coarse + ROUND_OFF * math.sqrt(1 + steps / 100)


def cheapest(system, rtol):
    """The name of the method without a closed form that costs least: heyoka's, once its compilation has been or will be earned back."""
    least = METHODS["dop853"].least
    if installed() and (system.traced.integrators or system.traced.seconds > HEYOKA_PAYS or rtol < least):
        return "taylor"
    if rtol < least:
        raise ModelError(f"rtol = {rtol:g} needs heyoka, which is not installed; without it the least is {least:g}")
    return "dop853"


def prepare(model, rtol=1e-9, method="auto"):
    """A function ``(t, start)`` that returns the states at ``t`` after ``start`` at t = 0, a tuple: one model for many runs, as under a slider.

    t, start : a float, and a tuple of floats in the order of the states. What is asked for, and raised, is as in :func:`integrate`, but there is no
    record, so no error estimate and no drift: look at those of one run. Where there is no exact solution, "auto" compiles with heyoka at once, if
    it is installed.

    >>> from newton_euler.scenes.pendulum import physical_pendulum
    >>> swing = prepare(physical_pendulum(2.0, 0.5, 0.5, 10.0))
    >>> [round(swing(10.0, (amplitude, 0.0))[0], 6) for amplitude in (0.1, 1.0)]
    [0.098256, -0.192477]
    """
    system = prepared(model)
    if system.many:
        raise ModelError(f"prepare takes a model with numbers, but parameters of {model.name!r} are arrays; integrate runs many motions at once")
    _check(rtol, method, (), None)
    if method == "auto":
        method = "exact" if METHODS["exact"].cannot(system) is None else "taylor" if installed() else "dop853"
    taken, tolerance = _usable(method, system), TAYLOR_MARGIN * rtol

    def slowly(t, start):
        return tuple(integrate(model, t, start, rtol, method).end.values())

    if not hasattr(taken.course, "prepared"):
        return slowly
    quickly = taken.course.prepared(system, tolerance, slowly)

    def run(t, start):
        try:
            return quickly(t, start)
        except (TypeError, ValueError):
            return slowly(t, start)  # which says what is wrong

    return run


__all__ = ["Event", "Motion", "MotionError", "integrate", "prepare"]
