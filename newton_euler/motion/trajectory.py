"""The trajectory of a model by one method at one tolerance: the segments between the events at
which it jumps or goes on as another model.
"""

import math
from typing import NamedTuple

from .events import EventLocator, Occurrence
from .methods.base import SMALLEST_SCALE, StepError, Stepper
from .methods.table import METHODS
from .model import ModelError
from .prepared import prepared, start_state

# between two searches for events: few at first, as an event may come soon, then more, as a search
# has a fixed cost
FIRST_STEPS, MAX_STEPS = 8, 128
MAX_SEGMENTS = 20_000
# of the whole time: events that come faster accumulate (Zeno), as the impacts of a ball that comes
# to rest
MIN_SEGMENT = 1e-9
ACCUMULATION = "events follow each other without end"


class Segment(NamedTuple):
    """The part from ``t0`` to ``t1``, where the state is ``x1``, in which one model holds:
    ``system`` is the prepared model.
    """

    system: object
    stepper: object
    t0: float
    t1: float
    x1: tuple


class Trajectory:
    """Segments, occurrences of events and, in words, how it ended; ``failed`` if that was where the
    method could not continue.

    run : the :class:`~newton_euler.motion.run.Run` that it belongs to; ``scales`` : of an earlier
        trajectory of this run
    """

    def __init__(self, run, method, tolerance, scales=None):
        self.method, self.tolerance, self.initial_scales = method, tolerance, scales
        self.origin, self.goal, self.step, self.progress = run.t0, run.t1, run.step, run.progress
        self.samples = None if run.events or run.progress else run.samples
        self.segments, self.occurrences, self.ended, self.failed = [], [], "", False
        start = run.system, run.t0, run.state, run.events, None
        while start:
            start = self._segment(*start)
        self.calls = sum([segment.stepper.calls for segment in self.segments])

    @property
    def scales(self):
        """The scales of the first segment, for the next trajectory; None after a failure, since
        states may grow without bounds there.
        """
        return None if self.failed else self.segments[0].stepper.scales

    def _segment(self, system, t, x, events, initial_event):
        """Add the segment that starts here; returns the arguments for the next one, or None."""
        # another model may need another
        method = (
            METHODS["dop853"]
            if self.segments and self.method.unusable_because(system)
            else self.method
        )
        stepper = found = None
        try:
            stepper = method.stepper(system, t, x, self)
            found = self._follow(stepper, events, initial_event)
        except ArithmeticError as error:
            stepper = stepper or Stepper(system, t, x, self)
            self._fail(system, stepper, error)
        t1, event, x1 = found or (stepper.t, None, stepper.x)
        self.segments.append(Segment(system, stepper, t, t1, x1))
        self.initial_scales = None  # those of the first segment
        if event:
            return self._after(event, system, t1, x1, events)
        self.ended = self.ended or f"reached t = {t1:.6g}"
        return None

    def _follow(self, stepper, events, initial_event):
        """Go to the goal or to the first event that ends the segment; returns that as (t, event,
        state).
        """
        if not events and not self.progress:
            stepper.step()
            return None
        locators = [EventLocator(event, stepper, event is initial_event) for event in events]
        limit, done = FIRST_STEPS, 0
        while stepper.t < self.goal:
            stepper.step(limit)
            for n in range(done, len(stepper.step_times) - 1):
                for t, k in sorted(
                    (t, k) for k, locator in enumerate(locators) for t in locator.roots(n)
                ):
                    x = stepper.state_at(t)
                    self.occurrences.append(
                        Occurrence(
                            events[k].name or f"event {k + 1}", t, stepper.system.model._state(x)
                        )
                    )
                    if events[k].ends:
                        return t, events[k], x
            done, limit = len(stepper.step_times) - 1, min(2 * limit, MAX_STEPS)
            if self.progress:
                self.progress((stepper.t - self.origin) / (self.goal - self.origin))
        return None

    def _after(self, event, system, t, x, events):
        """What follows an event: the arguments of the next segment, or None."""
        name, last = self.occurrences[-1].name, self.segments[-1]
        self.ended = f"{name} at t = {t:.6g}"
        following = event.then and system.untraced(event.then)(t, *x)
        if following is None:
            return None
        if not isinstance(following, tuple) or len(following) not in (2, 3):
            raise ModelError(
                f"then= of {name!r} returns (model, start) or (model, start, events), not "
                f"{following!r}"
            )
        if len(self.segments) >= MAX_SEGMENTS or (
            len(self.segments) > 1 and last.t1 - last.t0 < MIN_SEGMENT * (self.goal - self.origin)
        ):
            self.ended = (
                f"{ACCUMULATION}: {name} at t = {t:.9g}; give then= a rule for what comes after"
            )
            return None
        if t >= self.goal:
            return None
        model, start, *given = following
        events = (
            given[0]
            if given
            else [e for e in events if e is not event or model.rhs is system.model.rhs]
        )
        self.ended = ""
        return prepared(model), t, start_state(model, start), tuple(events), event

    def _fail(self, system, stepper, error):
        self.failed = True
        place = ", ".join(f"{n} = {v:.6g}" for n, v in system.model._state(stepper.x).items())
        why = (
            "may be singular there, or the motion leaves the model"
            if isinstance(error, StepError)
            else "are singular there"
        )
        self.ended = (
            f"{system.model.name} could not be followed beyond t = {stepper.t:.6g}, at "
            f"{place}: {error}; the coordinates {why}"
        )

    # -- errors

    def difference(self, other):
        """The distance of two trajectories: the largest difference of a state at the end over its
        scale, or of the end over the whole time.
        """
        a, b = self.segments[-1], other.segments[-1]
        shift = abs(a.t1 - b.t1) / (self.goal - self.origin)
        if self.ended.startswith(ACCUMULATION) and other.ended.startswith(ACCUMULATION):
            return shift
        if (
            len(self.segments) != len(other.segments)
            or a.system.model.states != b.system.model.states
        ):
            return 1.0
        scales = list(map(max, a.stepper.scales, b.stepper.scales))
        pairs = [(a.x1, b.x1)]
        # earlier too: at the end they may agree by chance
        if len(self.segments) == 1 and not self.failed and not other.failed:
            pairs += [(x, b.stepper.state_at(t)) for t, x in a.stepper.checkpoints if t <= b.t1]
        return max(
            shift,
            *(
                abs(u - v) / s
                for one, two in pairs
                for u, v, s in zip(one, two, scales, strict=True)
            ),
        )

    def exact_error(self):
        """The error of an exact solution: how far it is, at the end, from going half of the time
        twice; None if a segment is not exact.
        """
        worst = 0.0
        for system, stepper, t0, t1, x1 in self.segments:
            if type(stepper) is not METHODS["exact"].stepper:
                return None
            x, half = stepper.start[1], (t1 - t0) / 2
            try:
                twice = system.solution(half, system.solution(half, x)) if system.autonomous else x1
            except (ArithmeticError, ModelError):
                return 1.0
            worst = max(
                worst,
                *(
                    abs(u - v) / max(abs(v), abs(w), SMALLEST_SCALE)
                    for u, v, w in zip(twice, x1, x, strict=True)
                ),
            )
        # plus the round-off of one evaluation
        return worst + 2e-16 if math.isfinite(worst) else 1.0
