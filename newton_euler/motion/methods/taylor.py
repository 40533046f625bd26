"""Heyoka's Taylor method, compiled once for a right-hand side, whatever its parameters, and a level
of accuracy; then by far the fastest. F. Biscani, D. Izzo, Revisiting high-order Taylor methods for
astrodynamics and celestial mechanics, MNRAS 504 (2021) 2614.
"""

import importlib
import importlib.util
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from copy import copy
from functools import cache, cached_property
from itertools import pairwise
from math import exp, frexp, inf, isfinite, ldexp
from typing import Any

from ...algebra.late import np
from . import base
from .base import MAX_STALLED_STEPS, Demand, FastRun, Floats, LengthError, StepError, System

# Heyoka's order is the least one above 1 - log(tolerance)/2; its steps barely depend on the
# tolerance. These are the tolerances at which the order changes, from 3 to 19, down to a float's
# epsilon.
LEVELS = tuple(1.0000001 * exp(-2.0 * order) for order in range(2, 19))
MAX_KINDS = 12  # kinds of integrators of one right-hand side that are kept
MAX_PREPARED_STEPS = 100 * MAX_STALLED_STEPS
FEW_STEPS = 20_000  # steps whose series are kept where a single state between them is needed
# the fewest instants, in a step and in all, at which the rates of a series are compared
IN_STEP, IN_ALL = 8, 1024
# states outside are scaled: heyoka's tolerance is relative to the largest one, absolute below 1
ORDINARY = 0.25, 4.0


@cache
def installed() -> bool:
    """True if heyoka is installed."""
    return importlib.util.find_spec("heyoka") is not None


def level_of(tolerance: float) -> float:
    """The largest of the levels that does not exceed the tolerance, or else the smallest."""
    return next((x for x in LEVELS if x <= tolerance), LEVELS[-1])


def _made(system, level, scaled, batch):
    """A new integrator; its time, state and parameters are set before each use."""
    hy, names = importlib.import_module("heyoka"), system.model.states
    variables = [hy.expression(n) for n in names]
    count = len(system.constants)
    pars = [hy.par[i] for i in range(count)]
    states = variables
    if scaled:
        scales = [hy.par[count + i] for i in range(len(names))]
        states = [s * v for s, v in zip(scales, variables, strict=True)]
    rates = system.traced.folded[0].on(hy)(hy.time, *states, *pars)
    zero = hy.expression(0.0)  # a rate may be a plain number
    rates = [rate + zero for rate in rates]
    if scaled:
        rates = [rate / s for rate, s in zip(rates, scales, strict=True)]
    make = hy.taylor_adaptive_batch if batch else hy.taylor_adaptive
    shape = (len(names), batch) if batch else len(names)
    return make(list(zip(variables, rates, strict=True)), np.zeros(shape), tol=level)


@contextmanager
def integrator(
    system: System, tolerance: float, scaled: bool = False, batch: int | None = None
) -> Iterator[Any]:
    """An integrator of this right-hand side at the level of the tolerance, for one user at a time;
    ``scaled``: of states divided by its last parameters; ``batch``: of that many motions at once.
    """
    key, known = (level_of(tolerance), scaled, batch), system.traced.integrators
    free = known.setdefault(key, [])
    if len(known) > MAX_KINDS:  # 2 MB each; the oldest is dropped
        known.pop(next(iter(known)), None)
    try:
        ta = free.pop()  # atomic: no two threads get the same one
    except IndexError:
        ta = _made(system, *key)
    try:
        yield ta
    finally:
        free.append(ta)


def _power_of_two(x):
    """The power of two at or below x; multiplying by it does not round."""
    return ldexp(1.0, frexp(x)[1] - 1) if x else 1.0


class Taylor(base.Stepper):
    """A run by Taylor series: without events one call of heyoka, repeated for states in between."""

    most_steps = 5e7  # seconds, as they are not kept

    def begin(self, trajectory: Demand) -> None:
        low, high = ORDINARY
        scales = [_power_of_two(s) for s in trajectory.units or ()]
        self.units = scales if any(not low <= s <= high for s in scales) else ()
        self.series: list[Any] = []
        self.kept, self.samples, self.taken = None, trajectory.samples, 0

    def _integrator(self):
        return integrator(self.system, self.tolerance, bool(self.units))

    def _put(self, ta, t, x):
        """Set time, state and parameters of an integrator."""
        ta.pars[:] = (*self.system.constants, *self.units)[: len(ta.pars)]
        if self.units:
            x = [v / s for v, s in zip(x, self.units, strict=True)]
        ta.time, ta.state[:] = t, x

    def _state(self, ta):
        x = ta.state.tolist()
        if self.units:
            x = [v * s for v, s in zip(x, self.units, strict=True)]
        return tuple(x)

    @staticmethod
    def fast_run(system: System, tolerance: float) -> FastRun | None:
        """See the base class; None where a series may not see all that the rates do."""
        if system.traced.hazards:
            return None
        free = system.traced.integrators.setdefault((level_of(tolerance), False, None), [])
        p, count = system.constants, len(system.model.states)

        def run(t, start):
            if len(start) != count:
                return None
            try:
                ta = free.pop()
            except IndexError:
                ta = _made(system, level_of(tolerance), False, None)
            try:
                pars = ta.pars
                if len(pars):  # the last user may have had other parameters
                    pars[:] = p[: len(pars)]
                ta.time = 0.0
                ta.state[:] = start
                # a part at a time, since steps become ever shorter near a singular place
                taken, part = 0, MAX_PREPARED_STEPS
                while ta.propagate_until(t, max_steps=part)[3] == part:
                    taken += part
                    if taken * t > Taylor.most_steps * ta.time:
                        break
                x = tuple(ta.state.tolist())
                reached = ta.time == t and isfinite(sum(x))
            finally:
                free.append(ta)
            return x if reached else None

        return run

    def step(self, limit: float = inf) -> None:
        if limit < inf or self.system.traced.hazards:
            self._by_steps(limit)
        elif self.stops or self.samples is None or not self._by_samples():
            self._at_once()

    def _at_once(self):
        with self._integrator() as ta:
            self._put(ta, self.t, self.x)
            while self.t < self.goal:
                stop = self.next_stop()
                before, done = self.t, ta.propagate_until(stop, max_steps=MAX_STALLED_STEPS)
                self.t, self.x = ta.time, self._state(ta)
                stalled = self._stalled(ta, before, done) and self.t < stop
                if stalled or not isfinite(sum(self.x)):
                    break
                self.update_scales()
                self.check_length(self.taken)
            else:
                self.step_times.append(self.t)
                return
        self._begin_again()
        self._by_steps(inf)  # shows where it fails

    def _stalled(self, ta, before, done):
        """True if the steps after the time ``before``, which returned ``done``, barely advance."""
        _, _, longest, steps, *_ = done
        self.calls, self.taken = self.calls + steps * ta.order, self.taken + steps
        self.longest = max(self.longest, longest)
        return ta.time - before < base.STALLED_RATIO * steps * self.longest

    def _begin_again(self):
        (self.t, self.x), self.series = self.start, []
        self.step_times, self.taken = [self.t], 0

    def _by_samples(self):
        """Go to the goal by heyoka's grid and keep the samples; False if that is impossible."""
        times = base.sample_times(self.samples, self.t, self.goal)
        if not len(times) or (times[1:] <= times[:-1]).any():
            return False
        found = self._grid(times if times[-1] == self.goal else np.append(times, self.goal))
        if found is None or not isfinite(found[:, -1].sum()):
            return False
        self.kept, self.t = (times, found[:, : len(times)]), self.goal
        some = found[:, :: len(times) // 64 + 1]
        self.scales = tuple(map(max, self.scales, abs(some).max(axis=1).tolist()))
        self.x = tuple(found[:, -1].tolist())
        self.step_times.append(self.t)
        return True

    def _grid(self, times):
        """The states at increasing times, an array (states, times); None if heyoka stops early."""
        blocks, found, walk = [], 0, copy(self)  # several threads may need it at once
        walk.taken = 0
        with self._integrator() as ta, suppress(LengthError):
            self._put(ta, *self.start)
            while found < len(times):
                before, rest = ta.time, times[found:]
                first = int(rest[0] != before)  # a grid of heyoka begins at its time
                grid = np.append(before, rest) if first else rest
                done = ta.propagate_grid(grid, max_steps=MAX_STALLED_STEPS)
                blocks.append(done[-1][first:])
                found += len(blocks[-1])
                walk.t = ta.time
                # where a series is not finite heyoka stops, and may have put the time forward
                if walk._stalled(ta, before, done) or not isfinite(walk.t + sum(ta.state)):
                    break
                walk.check_length(walk.taken)
        self.calls += walk.taken * ta.order
        if found < len(times):
            return None
        rows = blocks[0] if len(blocks) == 1 else np.concatenate(blocks)
        return self._unscaled(rows.T)

    def _by_steps(self, limit):
        """Take at most ``limit`` steps and keep their series."""
        self.max_steps = min(self.max_steps, base.MAX_STEPS)
        with self._integrator() as ta:
            self._put(ta, self.t, self.x)
            while limit > 0 and self.t < self.goal:
                stop = self.next_stop()
                ta.step(max_delta_t=stop - self.t, write_tc=True)
                x = self._state(ta)
                # a step below twice a float's epsilon does not change the time
                if not isfinite(sum(x)) or ta.last_h < 4e-16 * abs(self.t):
                    raise StepError("the series is not finite here, or the step became too small")
                self.series.append(self._unscaled(ta.tc.copy()))
                self.t, self.x, limit = float(ta.time), x, limit - 1
                if abs(stop - self.t) <= 4e-16 * abs(stop):
                    self.t = stop  # the time was rounded
                self.calls += ta.order
                self.step_times.append(self.t)
                self.update_scales()
                self.check_progress()

    def _unscaled(self, rows):
        return rows * np.array(self.units)[:, None] if self.units else rows

    def states(self, times: Any) -> "np.ndarray":
        times = np.asarray(times, dtype=float)
        if self.kept and len(times) == len(self.kept[0]) and (times == self.kept[0]).all():
            return self.kept[1].copy()
        if self.series:
            return self._polynomials(times)
        if len(self.step_times) < 2:
            return super().states(times)
        enough = len(times) > 1 or self.taken > FEW_STEPS
        increasing = enough and not self.stops and np.all(np.diff(times) > 0)
        found = self._grid(times) if increasing else None
        return self.dense.states(times) if found is None else found

    def state_at(self, t: float) -> Floats:
        # without events no series has been kept yet
        return tuple(self.states([t])[:, 0].tolist())

    def _polynomials(self, times):
        """The states at an array of times by the series of the steps."""
        n = np.searchsorted(self.step_times[1:-1], times, side="right")
        u, out = times - np.array(self.step_times)[n], 0.0
        # an array (order, states, times) of coefficients, the highest first
        for row in np.array(self.series)[n].T[::-1]:
            out = out * u + row
        return out

    @cached_property
    def dense(self) -> "Taylor":
        """The same run step by step; a copy, since several threads may need it at once."""
        if self.series:
            return self
        dense = copy(self)
        dense._begin_again()
        dense._by_steps(inf)
        return dense

    def residual(self) -> float:
        """The integral of the difference between the rates of the series and those of the model:
        that of the worst state relative to its scale; 0 if steps were not kept.
        """
        from numpy.polynomial.polynomial import polyder, polyval

        count = max(IN_STEP, -(-IN_ALL // max(len(self.series), 1)))
        # irregular, so that nothing periodic stays hidden between them
        fractions = (0.5 + np.arange(count) * 0.618033988749895) % 1.0
        rates, total = self.system.traced.folded[0].on(np), np.zeros(len(self.x))
        with np.errstate(all="ignore"):
            for (a, b), series in zip(pairwise(self.step_times), self.series, strict=True):
                u = (b - a) * fractions
                x, made = polyval(u, series.T), polyval(u, polyder(series.T))
                for n, f in enumerate(rates(a + u, *x, *self.system.constants)):
                    total[n] += abs(made[n] - f).mean() * (b - a)
        scales = [s or 1.0 for s in self.scales]
        worst = float((total / scales).max())
        return worst if isfinite(worst) else inf

    def interpolate(self, n: int, times: "np.ndarray") -> "np.ndarray":
        from numpy.polynomial.polynomial import polyval

        return polyval(times - self.step_times[n], self.series[n].T)


def batches(
    system: System,
    tolerance: float,
    starts: "np.ndarray",
    p: "np.ndarray",
    t0: float,
    times: "np.ndarray",
) -> "tuple[np.ndarray, int]":
    """The states (states, motions, times) of many motions, nan where heyoka stopped early, and the
    number of calls: batches as wide as the processor's registers, the last filled up with copies.

    starts, p : arrays (states, motions) and (constants, motions)
    """
    import heyoka

    width, count = heyoka.recommended_simd_size(), starts.shape[1]
    before = int(times[0] != t0)  # a grid of heyoka begins at the start
    grid = np.repeat(np.concatenate(([t0] * before, times))[:, None], width, axis=1)
    out, steps = np.full((len(starts), count, len(times)), np.nan), 0
    with integrator(system, tolerance, batch=width) as ta:
        filled = np.minimum(np.arange(count + -count % width), count - 1)
        filled_starts, p = starts[:, filled], p[: len(ta.pars), filled]
        state, pars, goal = ta.state, ta.pars, [float(times[-1])] * width
        ends_only = len(grid) == 2 or len(times) == 1
        if ends_only:
            out[:, :, 0] = starts
        for first in range(0, count, width):
            ta.set_time(t0)
            state[:] = filled_starts[:, first : first + width]
            pars[:] = p[:, first : first + width]
            kept = out[:, first : first + width]
            real = kept.shape[1]  # motions of this batch that are not copies
            if ends_only:  # no dense output
                ta.propagate_until(times[-1], max_steps=MAX_PREPARED_STEPS)
                kept[:, :, -1] = state[:, :real]
                if ta.time.tolist() != goal:
                    kept[:, ta.time[:real] < times[-1], -1] = np.nan
            else:
                rows = ta.propagate_grid(grid, max_steps=MAX_PREPARED_STEPS)[-1][before:]
                kept[:, :, : len(rows)] = np.moveaxis(rows, 0, 2)[:, :real]
            steps += sum([r[3] for r in ta.propagate_res])
    return out, steps * ta.order
