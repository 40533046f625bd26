"""Events: times at which a function of the state changes its sign, in the steps of a trajectory."""

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from heapq import merge
from math import nan
from numbers import Real

from ..algebra.late import np
from ..algebra.names import guided
from ..algebra.places import at_a_place, raised_by_the_engine
from ..algebra.portable import Formula, Portable, Values
from ..algebra.scalars import Scalar
from .chebyshev import EPS, root
from .methods.base import Stepper
from .model import ModelError, expect
from .narrow import narrow_times
from .zeros import UnresolvedError, VoidError, ZeroSearch

# relative change of the time and of each state by which the round-off of a function is measured
NUDGE = 2.0**-50
MARGIN = 64  # units in the last place of a time, between pieces that are searched


class EventError(ModelError):
    """Raised for an event whose function cannot be used with any method of integration."""


@guided
@dataclass(frozen=True)
class Event(Portable):
    """A zero of ``function(s, p, t)`` during a motion: impact, loss of contact, a turning point.

    function : a function of the states, the parameters and the time, as in a :class:`Model`, that
        returns a number. It is an event where its sign changes, also at the end of the motion, but
        not where it only touches zero or where the motion starts at one. Kinks and jumps are slow
    direction : 1 if only zeros count at which it grows, -1 at which it falls, 0 for both
    terminal : True if the motion ends there
    then : a function ``(s, p, t)`` that returns the model and the start with which the motion
        continues, ``(model, start)`` or, to change the events as well, ``(model, start, events)``;
        if it returns None, the motion ends. A new right-hand side ends the search for this event.
    name : how the motion lists it

    Raises :class:`~newton_euler.motion.model.ModelError` for arguments that do not fit.

    >>> landing = Event(lambda s, p, t: s.h, direction=-1, terminal=True, name="landing")
    """

    function: Formula
    direction: int = 0
    terminal: bool = False
    then: Callable[[Values, Values, Scalar], tuple | None] | None = None
    name: str = ""

    def __post_init__(self):
        for name in ("direction", "terminal"):
            if getattr(getattr(self, name), "shape", None) == ():  # an array of NumPy without axes
                object.__setattr__(self, name, getattr(self, name).item())
        direction, then = self.direction, self.then
        what = "an event takes a function (s, p, t) whose zeros are looked for"
        expect(callable(self.function), what, self.function)
        what = "the direction of an event is 1 where its function grows, -1 where it falls, 0 both"
        expect(type(direction) is int and direction in (-1, 0, 1), what, direction)
        what = "terminal is True for an event that ends the motion, or False"
        expect(type(self.terminal) is bool, what, self.terminal)
        what = "then= of an event is a function (s, p, t) that returns (model, start), or None"
        expect(then is None or callable(then), what, then)
        expect(isinstance(self.name, str), "the name of an event is a text", self.name)

    @property
    def ends(self) -> bool:
        """True if the event ends the segment of the trajectory."""
        return self.terminal or self.then is not None


@dataclass(frozen=True)
class Occurrence:
    """An event that occurred: ``name``, time ``t``, and ``state`` by name, before any ``then``."""

    name: str
    t: float
    state: dict


def events_in_step(locators: list, n: int) -> Iterator[list[tuple[float, int]]]:
    """The events in step ``n``, in order of time: for each time, within round-off, a list of pairs
    (time, index of the locator), in which those that end the segment come last. The step is
    searched only as far as the lists are consumed, so nothing is spent beyond the end of a segment.
    """

    def numbered(k):
        return ((t, k, is_event) for t, is_event in locators[k].search(n))

    def in_order(found):
        return sorted(found, key=lambda pair: locators[pair[1]].event.ends)

    found: list = []
    for t, k, is_event in merge(*map(numbered, range(len(locators)))):
        if found and t > found[0][0] + 4 * EPS * abs(t):
            yield in_order(found)
            found = []
        if is_event:
            found.append((t, k))
    if found:
        yield in_order(found)


class EventLocator:
    """Locates one event in the steps of a stepper, in their order.

    at_start : True if the segment starts with this very event, whose zero does not count again

    Raises :class:`EventError` where the function fails, or its zeros cannot be found.
    """

    def __init__(self, event: Event, stepper: Stepper, at_start: bool):
        self.event, self.stepper, self.at_start = event, stepper, at_start
        self.takes_arrays, self.failed = True, None
        t, x = stepper.start
        try:
            self.g = stepper.system.function(event.function)
            self.first = self._value(t, *x)
        except ModelError:
            raise
        except (AttributeError, LookupError, TypeError) as error:
            if not raised_by_the_engine(error):
                raise
            raise EventError(f"{self._name} fails when it is tried: {error}") from error
        self.sign = int(self.first > 0) - int(self.first < 0)
        self.cuts: list[float] = []

    def look(self, first: int) -> None:
        """Find where the function may be narrow, from step ``first`` on: a search begins there."""
        arguments = self.stepper.system.narrow_of(self.event.function)
        if arguments:
            times, knots, _ = narrow_times(self.stepper, arguments, first)
            self.cuts = sorted([*times.tolist(), *knots.tolist()])

    @property
    def _name(self):
        of = f"event {self.event.name!r}" if self.event.name else "an event"
        return f"the function of {of}"

    def search(self, n: int) -> Iterator[tuple[float, bool]]:
        """Pairs (time, is_event) in step ``n``, in order; without one all are found until then."""
        stepper, (a, b) = self.stepper, self.stepper.step_times[n : n + 2]

        def values(times):
            return self._values(times, stepper.interpolate(n, times))

        def noise(times):
            return self._noise(times, stepper.interpolate(n, times.reshape(-1)))

        if not a < b:
            return  # a step shorter than the last digit of the time
        search = ZeroSearch(values, noise, a, b, self.sign, self.event.direction)
        room, search.cuts = MARGIN * EPS * max(abs(a), abs(b)), []
        for t in self.cuts:
            if t - max([a, *search.cuts[-1:]]) > room and b - t > room:
                search.cuts.append(t)
        search.closed = b == stepper.goal
        if a == stepper.start[0]:
            search.start = self.first, self.at_start
        last, failed = a, None
        try:
            for zeros, end in search:
                for zero in zeros:
                    # refined, it must not precede the last one
                    last = max(self._refined(zero, a, b), last)
                    if last > stepper.start[0]:
                        yield last, True
                self.sign = search.sign
                yield max(end, last), False
        except UnresolvedError as error:
            what = f"{self._name} {error}"
            failed = self.failed
            if not (isinstance(error, VoidError) and failed):
                raise EventError(what) from error
            at_a_place(failed, EventError, what)
        if failed:
            raise failed

    def _value(self, t, *x):
        """The value at one state, or nan."""
        try:
            value = self.g(t, *x)
        except ModelError:
            raise
        except (ArithmeticError, ValueError) as error:  # ValueError: a root or logarithm in floats
            self.failed = error
            return nan
        if type(value) is float:
            return value
        if getattr(value, "shape", None) == ():  # a number of NumPy
            value = value.item()
        if isinstance(value, bool):
            raise EventError(
                f"{self._name} returns True or False, which has no zeros: return a number that "
                "changes its sign, as s.h, not s.h < 0"
            )
        if not isinstance(value, Real):
            raise EventError(f"{self._name} returns a real number, not {value!r}")
        return float(value)

    def _values(self, times, x):
        """The values at an array of times with the states there, an array."""
        if self.takes_arrays:
            try:
                with np.errstate(all="ignore"):
                    return np.broadcast_to(np.asarray(self.g(times, *x), float), times.shape)
            except (TypeError, ValueError):  # the function branches on values
                self.takes_arrays = False
        columns = zip(times.tolist(), *x.tolist(), strict=True)
        return np.array([self._value(*column) for column in columns])

    def _noise(self, times, x):
        """The largest round-off of the values in each row of times: how much they change with the
        last digits of the time and of each state, relative to its largest size in that row.
        """
        flat = times.reshape(-1)
        values = self._values(flat, x)
        total = np.abs(self._values(flat * (1 + NUDGE), x) - values)
        for k, row in enumerate(x):
            largest = np.abs(row).reshape(times.shape).max(axis=1, keepdims=True)
            nudged = x.copy()
            nudged[k] += (NUDGE * np.broadcast_to(largest, times.shape)).reshape(-1)
            total += np.abs(self._values(flat, nudged) - values)
        return total.reshape(times.shape).max(axis=1)

    def _refined(self, zero, a, b):
        """The time of a zero by the states that a step to there reaches: more accurate."""
        stepper, (t, slope), length = self.stepper, zero, b - a
        if type(stepper).state_at is Stepper.state_at:  # which interpolates
            return t

        def value(t):
            return self._value(t, *stepper.state_at(t))

        if not slope:  # a kink or a jump, where the sign changes
            for part in (1e-9, 1e-7, 1e-5, 1e-3):
                low, high = max(a, t - part * length), min(b, t + part * length)
                ends = value(low), value(high)
                if min(ends) < 0 < max(ends):  # a product might underflow
                    return root(value, low, high)
            return t
        # two steps: the zero is already accurate to the error of the interpolation
        for _ in range(2):
            move = value(t) / slope
            if not abs(move) < 1e-3 * length:
                break
            t = min(max(t - move, a), b)
        return t
