"""Integration of the motion of a model: its states at any time, the estimated error, the drift of
invariants, the cost, and the events.

The methods are in :mod:`.methods.table`; how one is chosen and its error controlled, in
:mod:`.run`; events in :mod:`.events`, the record in :mod:`.solution`.
"""

from collections.abc import Callable, Iterable, Sequence
from itertools import islice
from time import perf_counter

from ..algebra.errors import LONGEST_SEQUENCE
from ..algebra.scalars import clipped
from .batch import Motions, integrate_batch
from .events import Event
from .methods.table import METHODS
from .model import Model, ModelError, State, has_unit, real_numbers
from .prepared import prepared_model, start_state
from .run import Run, check, checked_samples, span, usable, verified_series
from .solution import Motion


def integrate(
    model: Model,
    t: float | Sequence[float],
    start: State,
    rtol: float = 1e-9,
    method: str = "auto",
    events: Event | Iterable[Event] = (),
    samples: int | Iterable[float] | None = None,
    progress: Callable | None = None,
    step: float | None = None,
) -> Motion | Motions:
    """The motion of a model from its start: a :class:`~newton_euler.motion.solution.Motion`, or
    :class:`~newton_euler.motion.batch.Motions` where the start or the parameters are arrays.

    t : the time at which to end, from 0, or a pair (from, to)
    start : the states, in their order or by name; arrays of one length are many starts at once, as
        are arrays among the parameters of the model
    rtol : the error that each state may have at the end, relative to its largest absolute value
        during the motion; for a state that is nearly zero by cancellation, to a thousandth of what
        its coupling to the others would make of it
    method : one of :data:`~newton_euler.motion.methods.table.METHODS`; "auto" takes the exact
        solution if there is one, else the straight-line DOP853 until heyoka, if it is installed and
        a series sees all that the rates do, is worth its compilation; where one method cannot reach
        what was asked for, the other
    events : an :class:`~newton_euler.motion.events.Event`, or several
    samples : times, or the number of times at equal distances; default: the ends of the steps
    progress : a function of the fraction of the time that is done, called now and then
    step : a fixed step, for methods that have an order; the error is then not controlled

    Every answer was compared with what was asked for. Raises :class:`ModelError` for what cannot be
    done, :class:`~newton_euler.motion.solution.MotionError`, with what was ``reached``, if the
    motion comes to a singular place, and its subclass
    :class:`~newton_euler.motion.solution.AccuracyError` if the error asked for cannot be had.

    >>> from newton_euler.scenes.planar.pendulum import physical_pendulum
    >>> motion = integrate(physical_pendulum(2.0, 0.5, 0.5, 10.0), 10.0, (1.0, 0.0))
    >>> motion.error < 1e-9, motion.drift["energy"] < 1e-9
    (True, True)
    >>> round(motion.at(2.5)["theta"], 6)
    0.433788
    """
    begun = perf_counter()
    system = prepared_model(model)
    t0, t1 = span(_time(t))
    state = start_state(model, start)
    asked = events if type(events) is tuple else _several(events)
    check(rtol, _name(method), asked, step, progress)
    samples = checked_samples(_plain_samples(samples), t0, t1)
    if system.many or (state is not start and any(type(x) is not float for x in state)):
        return integrate_batch(model, t0, t1, state, rtol, method, asked, samples)
    preparing = perf_counter() - begun
    run = Run(system, t0, t1, state, rtol, asked, samples, progress, step, preparing)
    return run.by_name(method)


LONGEST_TIME = 2**53  # of whole numbers, which beyond it are no floats


def _time(t):
    """``t`` itself; :class:`ModelError` if it is no number, or has a unit."""
    kind = type(t)
    # the usual times, told in a moment
    usual = kind is float or kind is int or (kind is tuple and {*map(type, t)} == {float})
    if not usual or (kind is int and t > LONGEST_TIME):
        real_numbers(t, "t is the time at which to end, or (from, to)")
    return t


def _name(method):
    """``method`` itself; :class:`ModelError` if it is no text."""
    if not isinstance(method, str):
        raise ModelError(f"method is 'auto' or one of {', '.join(METHODS)}; got {clipped(method)}")
    return method


def _several(events):
    """The events as a tuple; :class:`ModelError` for what cannot be gone through."""
    if isinstance(events, Event):
        return (events,)
    if not hasattr(events, "__iter__") or isinstance(events, (str, bytes, range)):
        raise ModelError(f"events are an Event, or several, got {clipped(events)}")
    return tuple(events)


def _plain_samples(samples):
    """A number of times, or None, as it is; times as an array; :class:`ModelError` for what has a
    unit, and for all else.
    """
    if samples is None or isinstance(samples, (int, str)):
        return samples
    if hasattr(samples, "__next__"):
        samples = list(islice(samples, LONGEST_SEQUENCE))
    return real_numbers(samples, "samples are a number of times, or times")


def prepare(model: Model, rtol: float = 1e-9, method: str = "auto") -> Callable:
    """A function ``(t, start)`` that returns the states at ``t`` after ``start`` at t = 0 as a
    tuple: one model for many runs, as under a slider.

    t, start : a float, and a tuple of floats in the order of the states
    rtol, method : as in :func:`integrate`; if there is no exact solution, "auto" compiles with
        heyoka at once, if it is installed

    Errors are as in :func:`integrate`, and so is every answer compared with what was asked for, a
    run of heyoka if no run close to it was (:mod:`newton_euler.motion.verified`). There is
    no record, so no error estimate and no drift: see those of one run of :func:`integrate`.

    >>> from newton_euler.scenes.planar.pendulum import physical_pendulum
    >>> swing = prepare(physical_pendulum(2.0, 0.5, 0.5, 10.0))
    >>> [round(swing(10.0, (amplitude, 0.0))[0], 6) for amplitude in (0.1, 1.0)]
    [0.098256, -0.192477]
    """
    system = prepared_model(model)
    if system.many:
        raise ModelError(
            f"prepare takes a model with numbers, but parameters of {model.name!r} are arrays; "
            "take integrate"
        )
    check(rtol, _name(method))
    asked = method
    if method == "auto":
        series = not METHODS["taylor"].unusable_because(system) and not system.traced.hazards
        method = "exact" if model.exact else "taylor" if series else "dop853"
    return Prepared(system, rtol, method, asked)


class Prepared:
    """What :func:`prepare` returns; in a pickle, its model as it was when this was made."""

    def __init__(self, system, rtol, method, asked):
        self.system, self.rtol, self.method, self.asked = system, rtol, method, asked
        used, fallback = usable(method, system), self._by_integration
        self._run = fallback
        if method == "exact":
            self._run = used.stepper.prepared_run(system, rtol, fallback)
        elif method == "taylor" and not system.traced.hazards:
            verify = verified_series(system, rtol, used)
            tolerance = rtol / used.tolerance_ratio
            self._run = used.stepper.prepared_run(system, tolerance, verify, fallback)

    def __reduce__(self):
        return Prepared, (self.system, self.rtol, self.method, self.asked)

    def __call__(self, t, start):
        try:
            if type(sum(start, t)) is not float:  # one short test of all of them
                _refuse_units(t, start)
            return self._run(t, start)
        except (TypeError, ValueError):
            return self._by_integration(t, start)  # which says what is wrong

    def _by_integration(self, t, start):
        t0, t1 = span(_time(t))
        state = start_state(self.system.model, start)
        run = Run(self.system, t0, t1, state, self.rtol)
        return tuple(run.by_name(self.asked).end.values())


def _refuse_units(t, start):
    """Raise a TypeError where something has a unit, which a method might drop."""
    if has_unit(t) or has_unit(start) or any(map(has_unit, start)):
        raise TypeError("it has a unit")
