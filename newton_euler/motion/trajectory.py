"""The trajectory by one method at one tolerance: its segments between events that end them."""

from collections.abc import Callable
from itertools import pairwise
from math import inf
from typing import Any, NamedTuple, Protocol

from ..algebra.errors import NewtonEulerError
from ..algebra.places import note_place, raised_by_the_caller, raised_by_the_engine
from .arguments import start_state
from .crossings import Crossings, off_a_border, unsettled
from .endings import stuck_at, why
from .events import Event, EventLocator, Occurrence, events_in_step
from .knots import knots
from .methods.base import SMALLEST_SCALE, Floats, LengthError, StepError, Stepper
from .methods.table import METHODS, Method
from .model import ModelError
from .narrow import passage, within_reach
from .prepared import PreparedModel, prepared_model
from .sizes import NATURAL_PART, ROUND_OFF, Sizes, least_scales, natural_sizes, small
from .solution import MotionError

# steps between two searches for events: few at first, then more, as a search has a fixed cost
FIRST_STEPS, MAX_STEPS = 8, 128
MAX_SEGMENTS = 20_000
MAX_REPEATS = 100  # the most repeats of the steps between two searches
TRIES = 4  # attempts to see more of what one step passes over
# part of the time: events in faster succession accumulate (Zeno), as those of a bouncing ball
MIN_SEGMENT = 1e-9
# fraction of the size of a state during the motion below which its errors do not count; the larger
# one where rates jump, as otherwise the motion would stall where it comes to rest
OWN_PART, KINKED_PART = 1e-6, 1e-3
# OWN_PART where steps end at changes of formula: behind one of them a state may begin from zero, by
# rates of which a small step sees the round-off alone
STOPPING_PART = 0.1
# longest step as a fraction of the time, in the first trajectory and in later ones: two runs by the
# same few steps would agree on what both have passed over
LONGEST_PARTS = 0.4, 0.13
# weight of the difference of two runs on the way: near a singular place it is the larger one
INNER_PART = 0.05
NEXT_TO_ZERO = 1e-150  # scales so small that an error relative to them may have no square
# fraction of its natural size at the start below which a state is nearly zero
SMALL_PART = 1e-2
# steps that a motion which sticks makes in this fraction of the whole time
STICKING, STICKING_PART = 100, 1e-2
# more round-off explains why no step is possible if it is this many times that so far, and this
# part of a step's tolerance
ROUGHER, HINDERING = 2.0, 1e-2
CRAWL, FEWEST = 100.0, 100  # the steps within this many times the shortest of so many are repeated
CRAWLING = 100_000  # steps between two checks for sticking


class Segment(NamedTuple):
    """The part from ``t0`` to ``t1``, where the state is ``x1``, in which one ``system`` holds."""

    system: PreparedModel
    stepper: Stepper
    t0: float
    t1: float
    x1: tuple


class Request(Protocol):
    """What a trajectory asks of the :class:`~newton_euler.motion.run.Run` that it belongs to."""

    system: PreparedModel
    t0: float
    t1: float
    state: Floats
    events: tuple[Event, ...]
    samples: Any
    progress: Callable | None
    step: float | None
    max_steps: float


class Trajectory:
    """``segments``, ``occurrences`` of events and, in words, how the trajectory ``ended``;
    ``failed`` is the error if the method could not continue there, else None; ``refusal`` is then
    the class of the error to be raised.

    run : the :class:`~newton_euler.motion.run.Run` that it belongs to
    known : the sizes of the states, as :meth:`sizes` of an earlier one; None for the first
    scaled : True if the states are divided by their sizes where the method itself does not
    samples : default those of the run
    watched : True if its steps are checked for narrow structures
    stopping : True if they are to end where the rates change their formula by the states
    """

    refusal: type[MotionError]
    calls: int

    def __init__(
        self,
        run: Request,
        method: Method,
        tolerance: float,
        known: Sizes | None = None,
        scaled: bool = False,
        samples: Any = None,
        watched: bool = False,
        stopping: bool = False,
    ):
        self.method, self.known, self.scaled = method, known, scaled
        self.tolerance = method.rounded(tolerance)
        self.origin, self.goal, self.step, self.progress = run.t0, run.t1, run.step, run.progress
        samples = run.samples if samples is None else samples
        self.samples = None if run.events or run.progress else samples
        self.segments: list[Segment] = []
        self.occurrences: list[Occurrence] = []
        self.ended = ""
        self.failed: Exception | None = None
        self.accumulates = False  # True where events follow each other without end
        self.natural: tuple[Floats, Floats] | None = None
        self.units: Floats = ()
        self.max_steps = run.max_steps
        # what its steps did not see, relative to the scales
        self.watched, self.missed = watched and not (self.step or method.closed), 0.0
        self.stopping = stopping
        self.repeated = False  # True if steps were repeated since they had not seen something
        self.longest_part = LONGEST_PARTS[known is not None]
        start = run.system, run.t0, run.state, run.events, ()
        while start:
            start = self._segment(*start)
        self.calls = sum([part.stepper.calls for part in self.segments])

    @property
    def count(self) -> int:
        """The number of steps."""
        return sum([len(part.stepper.step_times) - 1 for part in self.segments])

    def largest(self) -> Floats:
        """The largest absolute value of each state in the first segment, a tuple."""
        _, stepper, _, t1, x1 = self.segments[0]
        points = [stepper.start, *stepper.checkpoints, (t1, x1)]
        seen = [max(map(abs, column)) for column in zip(*[x for _, x in points], strict=True)]
        rows = zip(stepper.scales, stepper.floors, seen, strict=True)
        return tuple([s if s > f else v for s, f, v in rows])

    def sizes(self) -> Sizes:
        """Three tuples for the first segment: the largest absolute value of each state, its natural
        size, and its natural size with the round-off of the time.
        """
        system, stepper, t0, t1, x1 = self.segments[0]
        points, largest = (stepper.start, (t1, x1)), self.largest()
        natural, noise = self.natural or (largest, largest)
        # the sizes at the start will do, unless a state is or was nearly zero
        if not self.natural or not all(
            s > SMALL_PART * n > 0 for s, n in zip(largest, natural, strict=True)
        ):
            natural, noise = natural_sizes(system, points, largest, t1 - t0 or 1.0)
        return largest, natural, noise

    def limits(self, system: PreparedModel, t: float, x: Floats) -> tuple[Floats, Floats, Floats]:
        """The least scale and the round-off of each state, and the times to stop at."""
        nothing, series = (0.0,) * len(x), self.method.series
        own = KINKED_PART if system.traced.surprises else OWN_PART
        if self.method.closed:
            return nothing, nothing, ()
        stops = () if self.step else knots(system, self.origin, self.goal)
        if series and not self.scaled:
            return nothing, nothing, stops
        # sizes seen in the first segment serve the others only where needed
        known = self.known if self.known and len(self.known[0]) == len(x) else None
        if known and (not self.segments or small(*known[:2])):
            sizes, natural, noise = known
            floors = least_scales(sizes, natural, own)
            if self.stopping:
                floors = [max(f, STOPPING_PART * s) for f, s in zip(floors, sizes, strict=True)]
            likely = [max(s, f / NATURAL_PART) for s, f in zip(sizes, floors, strict=True)]
        else:
            natural, noise = natural_sizes(system, [(t, x)], tuple(map(abs, x)), self.goal - t)
            floors, likely = [NATURAL_PART * n for n in natural], list(natural)
        if not self.segments:
            self.natural = natural, noise
        # the stepper adds the sizes that the states have had so far, since a small error of a state
        # that is still small may grow with it
        if series:  # the sizes that the states will have
            self.units = tuple(map(max, map(abs, x), likely))
        least = tuple([f if f > NEXT_TO_ZERO else SMALLEST_SCALE for f in floors])
        return least, tuple([ROUND_OFF * n for n in noise]), stops

    def _segment(self, system, t, x, events, initial):
        """Add the segment that starts here; return the arguments for the next one, or None."""
        method = self.method
        if self.segments and method.unusable_because(system):
            method = METHODS["dop853"]  # which integrates every model
        stepper = stopped = None
        try:
            if not method.closed:
                x = off_a_border(system, t, x)
            stepper = method.stepper(system, t, x, self)
            stopped = self._follow(stepper, events, initial)
        except ModelError:
            raise
        except (ArithmeticError, ValueError) as error:
            is_engines = isinstance(error, NewtonEulerError) and not raised_by_the_caller(error)
            if not is_engines and note_place(error):
                raise  # the error of an event's function or of progress
            stepper = stepper or _not_begun(system, t, x)
            self._fail(stepper, error)
        except RuntimeError as error:
            # a generator of the engine turns the StopIteration of an event's function into this
            if isinstance(error.__cause__, StopIteration) and raised_by_the_engine(error):
                raise error.__cause__ from None
            raise
        t1, ending, x1 = stopped or (stepper.t, (), stepper.x)
        self.segments.append(Segment(system, stepper, t, t1, x1))
        if ending:
            return self._after(ending, events)
        self.ended = self.ended or f"reached t = {t1:.6g}"
        return None

    def _follow(self, stepper, events, initial):
        """Go to the goal, or to the first events that end the segment; return these as (t, events,
        state): there may be several at one time, as where a ball hits a corner. ``initial`` : the
        events with which the segment began.
        """
        watched = self.watched and stepper.resumable and stepper.system.traced.narrow
        locators = [EventLocator(e, stepper, any(e is i for i in initial)) for e in events]
        patience = CRAWLING if stepper.system.traced.choices else inf
        limit, done = FIRST_STEPS if events or self.progress else patience, 0
        stopping = self.stopping and stepper.system.traced.choices
        step = Crossings(stepper).step if stopping else stepper.step
        while stepper.t < self.goal:
            try:
                step(limit)
            except StepError as error:
                if isinstance(error, LengthError) or not self._rougher(stepper, done):
                    raise
                continue
            steps = len(stepper.step_times) - 1
            if steps >= patience:
                patience += CRAWLING
                if self._sticks(stepper, steps - STICKING):
                    raise StepError(f"{steps} steps led there, and the next ones go back and forth")
            if watched:
                self._see(stepper, step, done, min(limit, MAX_STEPS))
            for locator in locators:
                locator.look(done)
            for n in range(done, len(stepper.step_times) - 1) if events else ():
                for found in events_in_step(locators, n):
                    ending = [k for _, k in found if events[k].ends]
                    for t, k in found:
                        x, name = stepper.state_at(t), events[k].name or f"event {k + 1}"
                        state = stepper.system.model._state(x)
                        self.occurrences.append(Occurrence(name, t, state))
                    if ending:
                        return t, [events[k] for k in ending], x
            done = len(stepper.step_times) - 1
            if limit < CRAWLING:
                limit = min(2 * limit, MAX_STEPS)
            if self.progress:
                self.progress((stepper.t - self.origin) / (self.goal - self.origin))
        return None

    def _rougher(self, stepper, first):
        """Continue from one of the steps, number ``first`` or later, where no step was possible
        since the rates are rougher by round-off than at the start, as those of a stiff floor far
        from the origin; False where that is not the reason.
        """
        if not stepper.resumable:
            return False
        begun, *_ = stepper.start
        here, span = [(stepper.t, stepper.x)], self.goal - begun
        *_, noise = natural_sizes(stepper.system, here, stepper.scales, span)
        noise = tuple([max(ROUND_OFF * a, b) for a, b in zip(noise, stepper.noise, strict=True)])
        rows = zip(noise, stepper.noise, stepper.scales, strict=True)
        least = HINDERING * stepper.tolerance
        if not any(a > max(ROUGHER * b, least * scale) for a, b, scale in rows):
            return False
        stepper.noise, self.repeated, times = noise, True, stepper.step_times
        lengths = [b - a for a, b in pairwise(times)]
        # each of the short steps that led here has lost a part of the last digit
        short, n = CRAWL * min(lengths[-FEWEST:], default=0.0), len(lengths)
        while n > first and lengths[n - 1] < short:
            n -= 1
        stepper.h = 0.0
        if n < len(lengths):
            stepper.back_to(n, ())
        else:
            stepper.resume()
        return True

    def _see(self, stepper, step, first, limit):
        """Repeat the steps from number ``first`` on that passed over something narrow."""
        if self._sticks(stepper, first):
            return  # it chatters in each step
        last, tries = 0.0, TRIES
        for _ in range(MAX_REPEATS):
            passed = passage(stepper, first)
            if not passed:
                return
            tries = tries - 1 if passed.number == first and passed.size > last / 2 else TRIES
            if not tries:
                break
            first, last, self.repeated = passed.number, passed.size, True
            floors, changes, stepper.noise = stepper.floors, passed.changes, passed.noise
            for _ in range(2):
                # the sizes that states will have that are zero so far
                made = [KINKED_PART * x for x in changes]
                stepper.floors = tuple(map(max, floors, made))
                stepper.back_to(first, passed.stops)
                step(limit)
                ends = stepper.x, *(s[-len(stepper.x) :] for s in stepper.steps[first:])
                changes = [max(map(abs, column)) for column in zip(*ends, strict=True)]
                if all(m <= max(f, x) for m, f, x in zip(made, floors, changes, strict=True)):
                    break  # else the way that missed it has made them too large
        self.missed += passed.size

    def _sticks(self, stepper, first):
        """True if many steps from ``first`` on took little time at a border that holds it."""
        span, count = self.goal - self.origin, len(stepper.step_times) - 1 - first
        if count < STICKING or stepper.t - stepper.step_times[first] > STICKING_PART * span:
            return False
        return bool(stuck_at(stepper.system, stepper.t, stepper.x, span))

    def unseen(self, error: float) -> float:
        """What the steps did not see of the rates, over the scales, for states off by ``error``."""
        total = self.missed
        for part in self.segments if self.repeated else ():
            rows = zip(part.stepper.noise, part.stepper.scales, strict=True)
            total += max([noise / (scale or 1.0) for noise, scale in rows])
        for system, stepper, begun, end, _ in self.segments if self.watched else ():
            if begun == end:
                continue  # no step
            passed = system.traced.narrow and not stepper.resumable and passage(stepper, 0)
            if stepper.halved and system.traced.surprises:
                total += unsettled(stepper, end)
            while passed:
                total, first = total + passed.size, passed.number + 1
                passed = first < len(stepper.dense.step_times) - 1 and passage(stepper.dense, first)
            if system.traced.narrow and error < inf:
                total += within_reach(stepper, error)
        return total

    def _after(self, ending, events):
        """The arguments of the segment that follows the events, or None."""
        name, (system, _, t0, t, x) = self.occurrences[-1].name, self.segments[-1]
        self.ended = f"{name} at t = {t:.6g}"
        for event in ending:
            new = event.then and system.untraced(event.then)(t, *x)
            if new is None:
                return None
            if not isinstance(new, tuple) or len(new) not in (2, 3):
                raise ModelError(
                    f"then= of {event.name or name!r} returns (model, start) or (model, start, "
                    f"events), not {new!r}"
                )
            (model, start, *given), before = new, system.model
            system, x = prepared_model(model), start_state(model, start)
            if given:
                events = tuple(given[0])
            elif model.rhs is not before.rhs:
                events = tuple(e for e in events if e is not event)
        count, least = len(self.segments), MIN_SEGMENT * (self.goal - self.origin)
        if count >= MAX_SEGMENTS or (count > 1 and t - t0 < least):
            self.accumulates = True
            self.ended = (
                f"events follow each other without end: {name} at t = {t:.9g}; give then= a rule "
                "for what comes after"
            )
            return None
        if t >= self.goal:
            return None
        self.ended = ""
        return system, t, x, events, ending

    def _fail(self, stepper, error):
        model, self.failed = stepper.system.model, error
        place = ", ".join(f"{n} = {v:.6g}" for n, v in model._state(stepper.x).items())
        span = self.goal - self.origin
        self.refusal, reason = why(error, stepper.system, stepper.t, stepper.x, span)
        self.ended = (
            f"{model.name} could not be followed beyond t = {stepper.t:.6g}, at {place}: {error}"
            f"{reason}"
        )

    def difference(self, other: "Trajectory") -> float:
        """The distance: the largest of states over their scales, of ends over the whole time."""
        a, b = self.segments[-1], other.segments[-1]
        shift = abs(a.t1 - b.t1) / (self.goal - self.origin)
        # where events accumulate, the two runs may stop after different numbers of them
        if self.accumulates and other.accumulates:
            return shift
        count, states = len(self.segments), a.system.model.states
        if count != len(other.segments) or states != b.system.model.states:
            return 1.0
        # the smaller of the two scales: one of the runs may have gone astray
        a_b, floors = (a.stepper, b.stepper), (a.stepper.floors, b.stepper.floors)
        values = map(min, *(stepper.scales for stepper in a_b))
        scales = [max(v) or 1.0 for v in zip(values, *floors, strict=True)]

        def apart(x, y):
            return max([abs(u - v) / s for u, v, s in zip(x, y, scales, strict=True)])

        largest = max(shift, apart(a.x1, b.x1))
        # states on the way too: those at the end may agree by chance
        if count == 1 and not self.failed and not other.failed:
            inner = [(x, b.stepper.state_at(t)) for t, x in a.stepper.checkpoints if t <= b.t1]
            largest = max([largest, *(INNER_PART * apart(*pair) for pair in inner)])
        return largest


def _not_begun(system, t, x):
    """A stepper that could not begin, for the record of where it is."""
    stepper = Stepper.__new__(Stepper)
    stepper.system, stepper.t, stepper.x, stepper.start = system, t, tuple(x), (t, tuple(x))
    stepper.step_times, stepper.steps, stepper.calls = [t], [], 0
    stepper.scales, stepper.floors = tuple(map(abs, x)), (0.0,) * len(x)
    return stepper
