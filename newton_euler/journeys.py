"""A motion from start to end by one method at one tolerance: the legs between events at which it turns, bounces, or becomes another model."""

import math
from typing import NamedTuple

from .courses import SMALL, Course, StepError
from .events import Occurrence, Watch
from .methods import METHODS
from .models import ModelError
from .systems import prepared, start_state

FIRST, MOST = 8, 128  # pieces between two looks for events
LEGS = 20_000
SHORTEST = 1e-9  # leg, in parts of the whole time
ENDLESS = "events follow each other without end"


class Leg(NamedTuple):
    """A part of a motion under one model: ``system``, ``course``, from ``t0`` to ``t1``, where the state is ``x1``."""

    system: object
    course: object
    t0: float
    t1: float
    x1: tuple


class Journey:
    """Legs, occurrences and how it ended; ``trouble`` is True if that was in a place where the method could not go on."""

    def __init__(self, run, method, tolerance, sizes=None):
        self.method, self.tolerance, self.known_sizes = method, tolerance, sizes
        self.origin, self.goal, self.step, self.progress = run.t0, run.t1, run.step, run.progress
        self.samples = None if run.events or run.progress else run.samples
        self.legs, self.occurrences, self.ended, self.trouble = [], [], "", False
        start = run.system, run.t0, run.state, run.events, None
        while start:
            start = self._leg(*start)
        self.calls = sum([leg.course.calls for leg in self.legs])

    @property
    def sizes(self):
        """The largest sizes of the states of the first leg, for the next run; None if it led where they grow without bounds."""
        return None if self.trouble else self.legs[0].course.sizes

    def _leg(self, system, t, x, events, began):
        """One leg; returns what the next one starts from, None at the end."""
        course, hit = None, None
        try:
            known = not self.legs or not self.method.cannot(system)  # another model than the first: by the method that can do all
            course = (self.method if known else METHODS["dop853"]).course(system, t, x, self)
            hit = self._follow(course, events, began)
        except ArithmeticError as error:
            course = course or Course(system, t, x, self)
            self._stopped(system, course, error)
        end, event, x1 = hit or (course.t, None, course.x)
        self.legs.append(Leg(system, course, t, end, x1))
        self.known_sizes = None  # they are of the states of the first leg
        if event:
            return self._after(end, event, x1, system, events)
        self.ended = self.ended or f"reached t = {end:.6g}"
        return None

    def _follow(self, course, events, began):
        """Go on to the end or the first event that ends the leg; that is returned as (t, event, state)."""
        if not events and not self.progress:
            course.advance()
            return None
        watches = [Watch(event, course, event is began) for event in events]
        limit, done = FIRST, 0
        while course.t < self.goal:
            course.advance(limit)
            for at in range(done, len(course.bounds) - 1):
                hit = self._happened(watches, course, at)
                if hit:
                    return hit
            done, limit = len(course.bounds) - 1, min(2 * limit, MOST)
            if self.progress:
                self.progress((course.t - self.origin) / (self.goal - self.origin))
        return None

    def _happened(self, watches, course, at):
        found = sorted(((t, n) for n, watch in enumerate(watches) for t in watch.found(at)))
        for t, n in found:
            event = watches[n].event
            x = course.restep(t)
            name = event.name or f"event {n + 1}"
            self.occurrences.append(Occurrence(name, t, dict(zip(course.system.model.states, x, strict=True))))
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
        if len(self.legs) >= LEGS or (len(self.legs) > 1 and self.legs[-1].t1 - self.legs[-1].t0 < SHORTEST * (self.goal - self.origin)):
            self.ended = f"{ENDLESS}: {name} at t = {t:.9g}; give then= a rule for what comes after"
            return None
        if t >= self.goal:
            return None
        model, start, *given = following
        events = given[0] if given else [e for e in events if e is not event or model.rhs is system.model.rhs]
        self.ended = ""
        return prepared(model), t, start_state(model, start), tuple(events), event

    def _stopped(self, system, course, error):
        self.trouble = True
        place = ", ".join(f"{n} = {v:.6g}" for n, v in zip(system.model.states, course.x, strict=True))
        why = "the coordinates are singular there"
        if isinstance(error, StepError):
            why = "the coordinates may be singular there, or the motion leaves the model"
        self.ended = f"{system.model.name} could not be followed beyond t = {course.t:.6g}, at {place}: {error}; {why}"

    # -- errors

    def difference(self, other):
        """How far two runs end from each other: the largest difference of a state over its size, and of the time if events ended them."""
        if self.ended.startswith(ENDLESS) and other.ended.startswith(ENDLESS):
            return abs(self.legs[-1].t1 - other.legs[-1].t1) / (self.goal - self.origin)
        if len(self.legs) != len(other.legs) or self.legs[-1].system.model.states != other.legs[-1].system.model.states:
            return 1.0
        a, b = self.legs[-1], other.legs[-1]
        shift = abs(a.t1 - b.t1) / (self.goal - self.origin)
        sizes = [max(s) for s in zip(a.course.sizes, b.course.sizes, strict=True)]
        pairs = [(a.x1, b.x1)]
        if len(self.legs) == 1 and not self.trouble and not other.trouble:  # at some earlier instants too: it may be right by chance
            pairs += [(x, b.course.restep(t)) for t, x in a.course.places if t <= b.t1]
        return max(shift, *(abs(u - v) / s for one, two in pairs for u, v, s in zip(one, two, sizes, strict=True)))

    def exact_error(self):
        """Of an exact solution: how far half of the way, taken twice, leads from the whole one. None if some leg is not exact."""
        if any(leg.course.__class__ is not METHODS["exact"].course for leg in self.legs):
            return None
        worst = 0.0
        for leg in self.legs:
            x, half = leg.course.start[1], (leg.t1 - leg.t0) / 2
            try:
                middle = leg.system.solution(half, x) if leg.system.autonomous else None
                again = leg.system.solution(half, middle) if middle else leg.x1
            except (ArithmeticError, ModelError):
                return 1.0
            differences = [abs(u - v) / max(abs(v), abs(w), SMALL) for u, v, w in zip(again, leg.x1, x, strict=True)]
            worst = max([worst, *differences])
        return worst + 2e-16 if math.isfinite(worst) else 1.0
