"""Times at which every method must stop: a pulse of a force that depends on time is missed by a
method whose steps have grown while nothing happened, and a step across a time at which the rates
change their formula is not accurate.
"""

import math

from ..algebra.compile import Compiled
from ..algebra.late import np
from ..algebra.trace import Step
from .methods.base import Floats, System

INTERVALS = 16384  # parts of the time: a pulse is found if it is longer than one of them
# an interval is quiet if a function of time changes in it by less than this fraction of its largest
# change in any interval, and if this many neighbours are quiet too: what a step may miss there is
# less than any rtol
QUIET, QUIET_RUN = 1e-14, 4
POLISHED = 2  # steps of Newton's rule by which such a time is exact, where its clock is linear
MAX_EVENTS = 1000  # pulses: more are an oscillation, which no step can miss


def knots(system: System, t0: float, t1: float) -> Floats:
    """The times between t0 and t1, in order, at which a function of time in the rates begins or
    ceases to change next to a quiet time, or at which they change their formula by the clock, as a
    table of time does; () for most models.
    """
    if system.autonomous:
        return ()
    kept = vars(system).get("_knots")
    if kept is None or kept[0] != (t0, t1):
        found = {*_found(system, t0, t1), *_joints(system, t0, t1)}
        kept = (t0, t1), tuple(sorted(found))
        vars(system)["_knots"] = kept
    return kept[1]


def _joints(system, t0, t1):
    """The times at which the clock changes the formula of the rates, as tables do."""
    steps, rhs = system.traced.clocked, system.traced.rhs
    pairs = [(s.args[0], 0.0 if s.op in ("abs", "table") else s.args[1]) for s in steps]
    leaves = [x for pair in pairs for x in pair]
    read = Compiled("clock", rhs.parameters, rhs.trace, leaves).on_floats
    states = [0.0] * len(system.model.states)
    begin, end = (read(t, *states, *system.p) for t in (t0, t1))
    for n, step in enumerate(steps):
        first, last = (values[2 * n] - values[2 * n + 1] for values in (begin, end))
        for x in step.args[1].places if step.op == "table" else (0.0,):
            part = (x - first) / ((last - first) or math.inf)
            if 0.0 < part <= 1.0:
                t, slope = t0 + part * (t1 - t0), (last - first) / (t1 - t0)
                for _ in range(POLISHED):  # exact to the last digit, since a jump may be large
                    one, other = read(t, *states, *system.p)[2 * n : 2 * n + 2]
                    t = min(max(t - (one - other - x) / slope, t0), t1)
                yield t


def _found(system, t0, t1):
    formula = _functions_of_time(system.traced)
    if formula is None:
        return ()
    times = np.linspace(t0, t1, INTERVALS + 1)
    # no function of time needs a state
    states = [0.0] * len(system.model.states)
    with np.errstate(all="ignore"):
        try:
            rows = formula.on(np)(times, *states, *system.p)
        except (ArithmeticError, ValueError):
            return ()
        found = set()
        for row in rows:
            changes = abs(np.diff(np.broadcast_to(row, times.shape)))
            if np.isfinite(changes).all() and changes.max() > 0:
                found |= _edges(changes > QUIET * changes.max())
    return tuple(times[sorted(found)].tolist())


def _edges(busy):
    """The indices at which busy intervals follow quiet ones, or end; empty if very many."""
    numbers = np.flatnonzero(busy)
    breaks = np.flatnonzero(np.diff(numbers) > QUIET_RUN)
    if len(breaks) >= MAX_EVENTS:
        return set()
    firsts = numbers[np.concatenate(([0], breaks + 1))]
    lasts = numbers[np.concatenate((breaks, [len(numbers) - 1]))] + 1
    begins = [n for n in firsts.tolist() if n > QUIET_RUN]
    ends = [n for n in lasts.tolist() if n < INTERVALS - QUIET_RUN]
    return {*begins, *ends}


def _functions_of_time(traced):
    """The functions of time alone in the rates, as one formula; or None."""
    rhs, found = traced.rhs, list(traced.rhs.leaves)
    for step in rhs.trace.steps:
        if traced.depends[step.number] - {"t"}:
            found += step.args
    steps = {x.number: x for x in found if isinstance(x, Step) and x.op != "argument"}
    chosen = [x for n, x in steps.items() if traced.depends[n] == {"t"}]
    return Compiled("time", rhs.parameters, rhs.trace, chosen) if chosen else None
