"""Heyoka's Taylor method on the traced right-hand side: compiled once for a right-hand side and a
level of accuracy, then by far the fastest.

Parameters are arguments of the compiled code, so that other values need no new compilation. F.
Biscani, D. Izzo, Revisiting high-order Taylor methods for astrodynamics and celestial mechanics,
MNRAS 504 (2021) 2614.
"""

import importlib
import importlib.util
from contextlib import contextmanager
from copy import copy
from functools import cache, cached_property
from itertools import pairwise
from math import exp, frexp, inf, isfinite, ldexp

from .base import MAX_STALLED_STEPS, STALLED_RATIO, StepError, Stepper, sample_times

# Heyoka chooses its order by its tolerance, as the least above 1 - log(tolerance)/2; the steps
# depend on it little. These are the tolerances at which another order begins, from 3 to 19, the
# last a float's epsilon.
LEVELS = tuple(1.0000001 * exp(-2.0 * order) for order in range(2, 19))
MAX_KINDS = 12  # of integrators of one right-hand side that are kept
MAX_PREPARED_STEPS = 100 * MAX_STALLED_STEPS
# instants at which the rates of a series are compared with those of the model: in each step, and in
# the whole motion at the least
IN_STEP, IN_ALL = 8, 1024
# states this small or large have a scale of their own: heyoka's tolerance is relative to the
# largest state, and absolute below 1
ORDINARY = 0.25, 4.0


@cache
def installed():
    """True if heyoka is installed."""
    return importlib.util.find_spec("heyoka") is not None


def level_of(tolerance):
    """The first of the levels that is not above the tolerance, the last if all are."""
    return next((x for x in LEVELS if x <= tolerance), LEVELS[-1])


def _made(system, level, scaled, batch):
    """A new integrator, and its arrays: time, state and parameters are set through them."""
    import numpy as np

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
def integrator(system, tolerance, scaled=False, batch=None):
    """An integrator of this right-hand side at the first level not above the tolerance, for one
    user at a time; with ``scaled`` one of the states over their scales, which are its last
    parameters, with ``batch`` one for so many motions at once.
    """
    key, known = (level_of(tolerance), scaled, batch), system.traced.integrators
    free = known.setdefault(key, [])
    if len(known) > MAX_KINDS:  # 2 MB each; those that were made first go
        known.pop(next(iter(known)), None)
    try:
        ta = free.pop()  # of a list these are atomic: no two threads get the same
    except IndexError:
        ta = _made(system, *key)
    try:
        yield ta
    finally:
        free.append(ta)


def _power_of_two(x):
    """The power of two at or below x; multiplying by it does not round."""
    return ldexp(1.0, frexp(x)[1] - 1) if x else 1.0


class Taylor(Stepper):
    """A run by Taylor series. Without events it is one call of heyoka; the steps are made again if
    something between them is asked for.
    """

    def begin(self, trajectory):
        """See :class:`~newton_euler.motion.methods.base.Stepper`."""
        low, high = ORDINARY
        scales = [_power_of_two(s) for s in trajectory.units or ()]
        self.units = scales if any(not low <= s <= high for s in scales) else ()
        self.series, self.kept, self.samples = [], None, trajectory.samples

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
    def prepared_run(system, tolerance, verify, fallback):
        """The function that :func:`newton_euler.motion.integration.prepare` returns; where heyoka
        stops on the way, or ``verify(t, start, x)`` is false, that is ``fallback(t, start)``.
        """
        free = system.traced.integrators.setdefault((level_of(tolerance), False, None), [])
        p, count = system.constants, len(system.model.states)

        def run(t, start):
            if len(start) != count:
                return fallback(t, start)
            try:
                ta = free.pop()
            except IndexError:
                ta = _made(system, level_of(tolerance), False, None)
            try:
                pars = ta.pars
                if len(pars):  # another model of this right-hand side may have set its own
                    pars[:] = p[: len(pars)]
                ta.time = 0.0
                ta.state[:] = start
                # a limit, since near a singular place the steps become shorter without end
                ta.propagate_until(t, max_steps=MAX_PREPARED_STEPS)
                x = tuple(ta.state.tolist())
                reached = ta.time == t and isfinite(sum(x))
            finally:
                free.append(ta)
            return x if reached and verify(t, start, x) else fallback(t, start)

        return run

    def step(self, limit=inf):
        """See :class:`~newton_euler.motion.methods.base.Stepper`."""
        if limit < inf or self.system.traced.hazards:
            self._by_steps(limit)
        elif self.stops or self.samples is None or not self._by_samples():
            self._at_once()

    def _at_once(self):
        with self._integrator() as ta:
            self._put(ta, self.t, self.x)
            while self.t < self.goal:
                stop = self.next_stop()
                _, _, longest, steps, *_ = ta.propagate_until(stop, max_steps=MAX_STALLED_STEPS)
                before, self.t, self.x = self.t, ta.time, self._state(ta)
                self.calls += steps * ta.order
                self.longest = max(self.longest, longest)
                stalled = self.t - before < STALLED_RATIO * steps * self.longest
                if (self.t < stop and stalled) or not isfinite(sum(self.x)):
                    break
                self.update_scales()
                self.check_length(self.calls / ta.order)
            else:
                self.step_times.append(self.t)
                return
        self._begin_again()
        self._by_steps(inf)  # to see where it fails

    def _begin_again(self):
        (self.t, self.x), self.series = self.start, []
        self.step_times = [self.t]

    def _by_samples(self):
        """Go to the goal by heyoka's grid and keep the samples; False if they are in no order or
        heyoka stops on the way.
        """
        import numpy as np

        times = sample_times(self.samples, self.t, self.goal)
        if not len(times) or np.any(np.diff(times) <= 0):
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
        """The states at increasing times from the start on, an array (states, times); None if
        heyoka stops on the way.
        """
        import numpy as np

        begin = self.start[0]
        grid = times if times[0] == begin else np.concatenate(([begin], times))
        with self._integrator() as ta:
            self._put(ta, *self.start)
            _, _, _, steps, *_, found = ta.propagate_grid(grid, max_steps=MAX_PREPARED_STEPS)
            self.calls += steps * ta.order
        if len(found) != len(grid):
            return None
        rows = found[-len(times) :].T
        return rows * np.array(self.units)[:, None] if self.units else rows

    def _by_steps(self, limit):
        """Go on by so many steps and keep their series."""
        with self._integrator() as ta:
            self._put(ta, self.t, self.x)
            while limit > 0 and self.t < self.goal:
                stop = self.next_stop()
                ta.step(max_delta_t=stop - self.t, write_tc=True)
                x = self._state(ta)
                # a step of less than twice a float's epsilon does not change the time
                if not isfinite(sum(x)) or ta.last_h < 4e-16 * abs(self.t):
                    raise StepError("the series is not finite here, or the step became too small")
                tc = ta.tc.copy()
                self.series.append(tc * self._columns() if self.units else tc)
                self.t, self.x, limit = float(ta.time), x, limit - 1
                if abs(stop - self.t) <= 4e-16 * abs(stop):
                    self.t = stop  # the time was rounded
                self.calls += ta.order
                self.step_times.append(self.t)
                self.update_scales()
                self.check_progress()

    def _columns(self):
        import numpy as np

        return np.array(self.units)[:, None]

    def states(self, times):
        """See :class:`~newton_euler.motion.methods.base.Stepper`."""
        import numpy as np

        times = np.asarray(times, dtype=float)
        if self.kept and np.array_equal(times, self.kept[0]):
            return self.kept[1].copy()
        if self.series or len(self.step_times) < 2:
            return super().states(times)
        increasing = not self.stops and len(times) > 1 and np.all(np.diff(times) > 0)
        found = self._grid(times) if increasing else None
        return self.dense.states(times) if found is None else found

    @cached_property
    def dense(self):
        """The same run by its steps; an object of its own, since several threads may ask for it."""
        dense = copy(self)
        dense._begin_again()
        dense._by_steps(inf)
        return dense

    def residual(self):
        """The integral of how far the rates of the series are from those of the model, of the worst
        state over its scale: 0 if steps were not kept.
        """
        import numpy as np
        from numpy.polynomial.polynomial import polyder, polyval

        count = max(IN_STEP, -(-IN_ALL // max(len(self.series), 1)))
        # irregular, so that nothing periodic hides between them
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

    def interpolate(self, n, times):
        """See :class:`~newton_euler.motion.methods.base.Stepper`; the Taylor polynomial is as
        accurate as the step.
        """
        from numpy.polynomial.polynomial import polyval

        return polyval(times - self.step_times[n], self.series[n].T)
