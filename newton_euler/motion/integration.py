"""Integration of the motion of a model.

One way leads down: the arguments are checked (:mod:`.arguments`), the model is traced
(:mod:`.prepared`), one motion is a :class:`.run.Run`, and many are :func:`.batch.integrate_many`,
which leaves to a run each motion that is not accurate at once. A run makes trajectories
(:mod:`.trajectory`) by :mod:`.methods.table` and returns a :mod:`.solution`.
"""

from collections.abc import Callable, Iterable, Sequence
from time import perf_counter

from ..algebra.names import guided
from .arguments import check_options, event_tuple, sample_request, start_state, time_span
from .batch import Motions, integrate_many
from .events import Event
from .methods.base import Floats
from .methods.table import METHODS
from .model import Model, ModelError, State, expect, has_unit
from .prepared import PreparedModel, prepared_model
from .run import Run, fast_run, usable
from .solution import Motion


@guided
def integrate(
    model: Model,
    t: float | Sequence[float],
    start: State,
    rtol: float = 1e-9,
    method: str = "auto",
    events: Event | Iterable[Event] = (),
    samples: int | Iterable[float] | None = None,
    progress: Callable[[float], object] | None = None,
    step: float | None = None,
) -> Motion | Motions:
    """The motion of a model from its start: a :class:`~newton_euler.motion.solution.Motion`, or
    :class:`~newton_euler.motion.batch.Motions` where the start or the parameters are arrays.

    t : the time at which to end, from 0, or a pair (from, to)
    start : the states, in their order or by name; arrays of one length are many starts at once, as
        are arrays among the parameters of the model
    rtol : the requested tolerance: the error that each state may have at the end, relative to its
        largest absolute value during the motion. A state that is zero by cancellation, and so holds
        only round-off, may be wrong by this round-off. Where round-off makes a larger error in a
        state that is not zero, as in the speed on a spring far from the origin, the motion is
        refused: take the distance from there as the state
    method : one of :data:`~newton_euler.motion.methods.table.METHODS`; "auto" takes the exact
        solution if there is one, else the straight-line DOP853 until compiling with heyoka pays
        off, if it is installed and a series sees all that the rates do; where one method cannot
        reach the tolerance, it takes the other
    events : an :class:`~newton_euler.motion.events.Event`, or several
    samples : times, or the number of times at equal distances; default: the ends of the steps
    progress : a function of the fraction of the time that is done, called now and then
    step : a fixed step, for methods that have an order; the error is then not controlled

    Every result was compared with the requested tolerance; its error is an estimate, not a bound:
    of random models in a hundred families, more than 99 in 100 are within rtol; the others are off
    by a few times rtol, most of them at 1e-3 where the rates jump on the way, or at 0.1 where a
    long oscillation spans only some thousand last digits of its coordinate. Raises
    :class:`ModelError` for what cannot be integrated,
    :class:`~newton_euler.motion.solution.MotionError`, with what was ``reached``, if the motion
    comes to a singular place, and its subclasses
    :class:`~newton_euler.motion.solution.StickingError`, ``NoValueError`` and ``LongError`` where
    that is known, and :class:`~newton_euler.motion.solution.AccuracyError` if the tolerance cannot
    be reached.

    A narrow structure, as a brake of a millimetre on a path of kilometres, is seen where its rates,
    or the function of an event, are written with ``where``, ``abs``, ``exp``, ``tanh``, ``atan``, a
    quotient like 1/(1 + x**2) or a table of places, whose arguments are followed along the steps
    (:mod:`.narrow`). It is found if it is 1e-7 of the path or more; an expanded square, as x*x +
    y*y < R*R, or the top of a curve that rises by w above a level, if w is 1e-14 of the largest
    value of the argument or more. Smaller ones may be refused. A spot in the plane, which an error
    of the path may hit or miss, is met or refused down to 1e-9 of the path, and one within the
    error adds to it. Not seen are rates without such an argument, as the sine of a fast variable;
    an argument that turns twice within a step whose ends do not show it; and a peak of a table that
    the argument touches by less than two of its places without turning.

    >>> from newton_euler.scenes.planar.pendulum import physical_pendulum
    >>> motion = integrate(physical_pendulum(2.0, 0.5, 0.5, 10.0), 10.0, (1.0, 0.0))
    >>> motion.error < 1e-9, motion.drift["energy"] < 1e-9
    (True, True)
    >>> round(motion.at(2.5)["theta"], 6)
    0.433788
    """
    begun = perf_counter()
    system = prepared_model(model)
    t0, t1 = time_span(t)
    state = start_state(model, start)
    rtol = check_options(rtol, method, step, progress)
    looked_for, sampled = event_tuple(events), sample_request(samples, t0, t1)
    preparing = perf_counter() - begun
    run = Run(system, t0, t1, state, rtol, looked_for, sampled, progress, step, preparing)
    if system.many or (state is not start and any(type(x) is not float for x in state)):
        return integrate_many(run, method)
    return run.by_name(method)


@guided
def prepare(model: Model, rtol: float = 1e-9, method: str = "auto") -> "Prepared":
    """A function ``(t, start)`` that returns the states at ``t`` after ``start`` at t = 0 as a
    tuple: one model for many runs, as under a slider.

    t, start : a float, and a tuple of floats in the order of the states
    rtol, method : as in :func:`integrate`; if there is no exact solution, "auto" compiles with
        heyoka at once, if it is installed

    Errors are as in :func:`integrate`, and every result was compared with the requested tolerance
    too, a run of heyoka unless a run close to it was (:mod:`newton_euler.motion.verified`). There
    is no record, so no error estimate and no drift: see those of one run of :func:`integrate`.

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
    rtol = check_options(rtol, method)
    return Prepared(system, rtol, method)


class Prepared:
    """What :func:`prepare` returns; a pickle contains its model as it was when this was made."""

    def __init__(self, system: PreparedModel, rtol: float, requested: str):
        self.system, self.rtol, self.requested, self.method = system, rtol, requested, requested
        if requested == "auto":
            series = not METHODS["taylor"].unusable_because(system) and not system.traced.hazards
            self.method = "exact" if system.model.exact else "taylor" if series else "dop853"
        self._fast = fast_run(system, usable(self.method, system), rtol) or (lambda t, start: None)

    def __reduce__(self):
        return Prepared, (self.system, self.rtol, self.requested)

    def __call__(self, t: float, start: Floats) -> Floats:
        try:
            # one short test of all of them: a method might drop a unit
            plain = type(sum(start, t)) is float or not any(map(has_unit, (t, start, *start)))
            x = self._fast(t, start) if plain else None
        except (TypeError, ValueError, OverflowError):
            x = None  # the integration raises an error that says what is wrong
        return self._integrated(t, start) if x is None else x

    @guided
    def _integrated(self, t, start):
        state = start_state(self.system.model, start)
        for given in (t, *state):
            one = not getattr(given, "shape", ()) and not isinstance(given, (tuple, list))
            expect(one, "what is prepared takes one time and one start, integrate many", given)
        t0, t1 = time_span(t)
        run = Run(self.system, t0, t1, state, self.rtol)
        return tuple(run.by_name(self.requested).end.values())
