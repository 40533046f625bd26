"""A motion from start to end by one method at one tolerance: the legs between events at which it turns, bounces, or becomes another model."""

import math
from typing import NamedTuple

from .courses import SMALLEST_SCALE, StepError, Stepper
from .events import EventLocator, Occurrence
from .methods import METHODS
from .models import ModelError
from .systems import prepared, start_state

FIRST, MOST = 8, 128  # pieces between two looks for events
MAX_SEGMENTS = 20_000
MIN_SEGMENT = 1e-9  # leg, in parts of the whole time
ACCUMULATION = "events follow each other without end"


class Segment(NamedTuple):
    """A part of a motion under one model: ``system``, ``course``, from ``t0`` to ``t1``, where the state is ``x1``."""

    system: object
    stepper: object
    t0: float
    t1: float
    x1: tuple


class Trajectory:
    """Legs, occurrences and how it ended; ``trouble`` is True if that was in a place where the method could not go on."""

    def __init__(self, run, method, tolerance, scales=None):
        self.method, self.tolerance, self.initial_scales = method, tolerance, scales
        self.origin, self.goal, self.step, self.progress = run.t0, run.t1, run.step, run.progress
        self.samples = None if run.events or run.progress else run.samples
        self.segments, self.occurrences, self.ended, self.failed = [], [], "", False
        start = run.system, run.t0, run.state, run.events, None
        while start:
            start = self._leg(*start)
        self.calls = sum([segment.stepper.calls for segment in self.segments])

    @property
    def scales(self):
        """The largest sizes of the states of the first leg, for the next run; None if it led where they grow without bounds."""
        return None if self.failed else self.segments[0].stepper.scales

    def _leg(self, system, t, x, events, initial_event):
        """One leg; returns what the next one starts from, None at the end."""
        stepper, hit = None, None
        try:
            known = not self.segments or not self.method.unusable_because(system)  # another model than the first: by the method that can do all
            stepper = (self.method if known else METHODS["dop853"]).stepper(system, t, x, self)
            hit = self._follow(stepper, events, initial_event)
        except ArithmeticError as error:
            stepper = stepper or Stepper(system, t, x, self)
            self._stopped(system, stepper, error)
        end, event, x1 = hit or (stepper.t, None, stepper.x)
        self.segments.append(Segment(system, stepper, t, end, x1))
        self.initial_scales = None  # they are of the states of the first leg
        if event:
            return self._after(end, event, x1, system, events)
        self.ended = self.ended or f"reached t = {end:.6g}"
        return None

    def _follow(self, stepper, events, initial_event):
        """Go on to the end or the first event that ends the leg; that is returned as (t, event, state)."""
        if not events and not self.progress:
            stepper.step()
            return None
        watches = [EventLocator(event, stepper, event is initial_event) for event in events]
        limit, done = FIRST, 0
        while stepper.t < self.goal:
            stepper.step(limit)
            for at in range(done, len(stepper.step_times) - 1):
                hit = self._happened(watches, stepper, at)
                if hit:
                    return hit
            done, limit = len(stepper.step_times) - 1, min(2 * limit, MOST)
            if self.progress:
                self.progress((stepper.t - self.origin) / (self.goal - self.origin))
        return None

    def _happened(self, watches, stepper, at):
        found = sorted(((t, n) for n, watch in enumerate(watches) for t in watch.found(at)))
        for t, n in found:
            event = watches[n].event
            x = stepper.state_at(t)
            name = event.name or f"event {n + 1}"
            self.occurrences.append(Occurrence(name, t, dict(zip(stepper.system.model.states, x, strict=True))))
            if event.ends:
                return t, event, x
        return None

    def _after(self, t, event, x, system, events):
        name = self.occurrences[-1].name
        self.ended = f"{name} at t = {t:.6g}"
        following = event.then and system.model._call(event.then, dict(zip(system.model.states, x, strict=True)), system.model.parameters, t)
        if following is None:
            return None
        if not isinstance(following, tuple) or len(following) not in (2, 3):
            raise ModelError(f"then= of {name!r} returns (model, start) or (model, start, events), not {following!r}")
        if len(self.segments) >= MAX_SEGMENTS or (
            len(self.segments) > 1 and self.segments[-1].t1 - self.segments[-1].t0 < MIN_SEGMENT * (self.goal - self.origin)
        ):
            self.ended = f"{ACCUMULATION}: {name} at t = {t:.9g}; give then= a rule for what comes after"
            return None
        if t >= self.goal:
            return None
        model, start, *given = following
        events = given[0] if given else [e for e in events if e is not event or model.rhs is system.model.rhs]
        self.ended = ""
        return prepared(model), t, start_state(model, start), tuple(events), event

    def _stopped(self, system, stepper, error):
        self.failed = True
        place = ", ".join(f"{n} = {v:.6g}" for n, v in zip(system.model.states, stepper.x, strict=True))
        why = "the coordinates are singular there"
        if isinstance(error, StepError):
            why = "the coordinates may be singular there, or the motion leaves the model"
        self.ended = f"{system.model.name} could not be followed beyond t = {stepper.t:.6g}, at {place}: {error}; {why}"

    # -- errors

    def difference(self, other):
        """How far two runs end from each other: the largest difference of a state over its size, and of the time if events ended them."""
        if self.ended.startswith(ACCUMULATION) and other.ended.startswith(ACCUMULATION):
            return abs(self.segments[-1].t1 - other.segments[-1].t1) / (self.goal - self.origin)
        if len(self.segments) != len(other.segments) or self.segments[-1].system.model.states != other.segments[-1].system.model.states:
            return 1.0
        a, b = self.segments[-1], other.segments[-1]
        shift = abs(a.t1 - b.t1) / (self.goal - self.origin)
        scales = [max(s) for s in zip(a.stepper.scales, b.stepper.scales, strict=True)]
        pairs = [(a.x1, b.x1)]
        if len(self.segments) == 1 and not self.failed and not other.failed:  # at some earlier instants too: it may be right by chance
            pairs += [(x, b.stepper.state_at(t)) for t, x in a.stepper.checkpoints if t <= b.t1]
        return max(shift, *(abs(u - v) / s for one, two in pairs for u, v, s in zip(one, two, scales, strict=True)))

    def exact_error(self):
        """Of an exact solution: how far half of the way, taken twice, leads from the whole one. None if some leg is not exact."""
        if any(segment.stepper.__class__ is not METHODS["exact"].stepper for segment in self.segments):
            return None
        worst = 0.0
        for segment in self.segments:
            x, half = segment.stepper.start[1], (segment.t1 - segment.t0) / 2
            try:
                middle = segment.system.solution(half, x) if segment.system.autonomous else None
                again = segment.system.solution(half, middle) if middle else segment.x1
            except (ArithmeticError, ModelError):
                return 1.0
            differences = [abs(u - v) / max(abs(v), abs(w), SMALLEST_SCALE) for u, v, w in zip(again, segment.x1, x, strict=True)]
            worst = max([worst, *differences])
        return worst + 2e-16 if math.isfinite(worst) else 1.0
