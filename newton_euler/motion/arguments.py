"""The arguments of an integration, checked: each as it is used, or a :class:`ModelError`."""

import math
from collections.abc import Callable, Iterable
from itertools import islice
from numbers import Real
from typing import Any

from ..algebra.errors import LONGEST_SEQUENCE
from ..algebra.scalars import clipped
from .events import Event
from .methods.table import METHODS
from .model import Model, ModelError, expect, finite_number, is_iterable, real_numbers


def time_span(t: Any) -> tuple[float, float]:
    """The times of start and end as floats; a single number is the end, with the start at 0."""
    if type(t) is float and 0.0 < t < math.inf:
        return 0.0, t
    what = "t is the time at which to end, or (from, to)"
    plain = type(t) is int or (type(t) is tuple and {*map(type, t)} <= {float, int})
    given = t if plain else real_numbers(t, what).tolist()  # without NumPy for plain numbers
    try:
        t0, t1 = map(float, given if isinstance(given, (list, tuple)) else (0.0, given))
    except (TypeError, ValueError, OverflowError) as error:
        raise ModelError(f"{what}; got {clipped(t)}") from error
    if not (math.isfinite(t0) and math.isfinite(t1) and t0 < t1):
        raise ModelError(f"time runs forward: the end is after the start, got {t0!r} to {t1!r}")
    return t0, t1


def start_state(model: Model, start: Any) -> tuple[Any, ...]:
    """The start as a tuple of floats (or arrays) in the order of the states."""
    # the usual start, checked in few calls: this is a good part of the time of a short run
    if (
        type(start) in (tuple, list)
        and len(start) == len(model.states)
        and set(map(type, start)) == {float}
        and math.isfinite(sum(start))
    ):
        return tuple(start)
    kind = getattr(getattr(start, "dtype", None), "char", "")
    if kind == "d" and type(start).__module__ == "numpy" and start.ndim == 1:
        return start_state(model, tuple(start.tolist()))
    names = ", ".join(model.states)
    subject = f"the start of {model.name!r}"
    if not is_iterable(start):
        raise ModelError(f"{subject} is a value for each of {names}, not {start!r}")
    unknown = [n for n in start if n not in model.states] if hasattr(start, "keys") else ()
    if unknown:
        raise ModelError(f"{model.name} has no state {unknown[0]!r}; its states are {names}")
    return tuple(_start_value(subject, n, x) for n, x in model._state(start).items())


def _start_value(subject, name, x):
    if type(x) is float and -math.inf < x < math.inf:
        return x  # before the messages are written
    expected = f"{subject} needs a number for {name}"
    if getattr(x, "shape", ()):
        real_numbers(x, expected)
        return x
    if isinstance(x, (str, bytes, bool)):
        raise ModelError(f"{expected}, got {x!r}")
    return finite_number(x, f"{subject} has {name} =", f"{expected}, got {clipped(x)}")


def check_options(
    rtol: float,
    method: str,
    step: float | None = None,
    progress: Callable[[float], object] | None = None,
) -> float:
    """``rtol`` as a float; :class:`ModelError` for options that suit no model."""
    if not (isinstance(method, str) and method in ("auto", *METHODS)):
        raise ModelError(f"method is 'auto' or one of {', '.join(METHODS)}; got {clipped(method)}")
    least = 1e-15 if method == "auto" else METHODS[method].min_rtol
    if step is None and not (_is_real(rtol) and least <= rtol < 1):
        why = "it is a number between 0 and 1"
        if _is_real(rtol) and 0 < rtol < 1:
            why = f"method {method!r} cannot reach it, the least is {least:g}"
        raise ModelError(f"rtol is the requested tolerance, got {clipped(rtol)}: {why}")
    positive = step is None or (_is_real(step) and 0 < step < math.inf)
    expect(positive, "the step is a positive time", step)
    what = "progress is a function of the fraction that is done"
    expect(progress is None or callable(progress), what, progress)
    return rtol if step is not None else float(rtol)


def _is_real(x):
    """True for one number of Python or NumPy."""
    return isinstance(x, Real) and not isinstance(x, bool)


def event_tuple(events: Event | Iterable[Event]) -> tuple[Event, ...]:
    """One or several events as a tuple."""
    if isinstance(events, Event):
        return (events,)
    several = is_iterable(events) and not isinstance(events, (str, bytes, range))
    expect(several, "events are an Event, or several", events)
    events = tuple(events)
    for event in events:
        expect(isinstance(event, Event), "events are made by Event(...)", event)
    return events


def sample_request(samples: Any, t0: float, t1: float) -> Any:
    """The samples: None, a number of times, or an array of times between t0 and t1."""
    if samples is None or (type(samples) is int and 0 < samples <= LONGEST_SEQUENCE):
        return samples
    if getattr(samples, "shape", None) == () and samples.dtype.kind in "iu":
        return sample_request(int(samples), t0, t1)  # a whole number of NumPy
    what = "samples are a number of times, or times"
    if hasattr(samples, "__next__"):
        samples = list(islice(samples, LONGEST_SEQUENCE))
    times = real_numbers(samples, what)
    if times.ndim != 1 or not len(times):
        raise ModelError(f"{what}; got {clipped(samples)}")
    outside = times[~((times >= t0) & (times <= t1))]
    if len(outside):
        raise ModelError(
            f"{what} from t = {t0:g} to {t1:g}, the time of the motion; got {outside[0]:g} among "
            "them"
        )
    return times
