"""Heyoka's Taylor method on the traced right-hand side: compiled once for a right-hand side and a
level of accuracy, then by far the fastest.

Parameters are arguments of the compiled code, so that other values need no new compilation. F.
Biscani, D. Izzo, Revisiting high-order Taylor methods for astrodynamics and celestial mechanics,
MNRAS 504 (2021) 2614.
"""

import importlib
import importlib.util
from functools import cache
from math import inf, isfinite

from .base import MAX_STALLED_STEPS, STALLED_RATIO, StepError, Stepper, sample_times

# levels of heyoka's tolerance, which is fixed when it compiles; the last is a float's epsilon
LEVELS = (*(10.0 ** (-n / 2) for n in range(8, 31)), 2.3e-16)
# rtol over heyoka's tolerance: of 310 measured runs 3 then have an error above rtol, with a margin
# of 10 it is 14
TAYLOR_MARGIN = 10.0**1.5
# heyoka's tolerance is absolute for states below 1; from this size on the margin covers that
ABSOLUTE_SCALE = 0.1
# part of a natural step: at the orders used (8 to 20) its truncation error is 0.6**8 to 0.6**20 of
# that of a natural step, less than a fiftieth
SHORT = 0.6


@cache
def installed():
    """True if heyoka is installed."""
    return importlib.util.find_spec("heyoka") is not None


def integrator(system, tolerance, batch=None):
    """Heyoka's integrator of this right-hand side at the first level not above the tolerance; with
    ``batch`` one for so many motions at once.
    """
    # 1.01: the levels are powers of 10 with round-off
    level = next((x for x in LEVELS if x <= 1.01 * tolerance), LEVELS[-1])
    known = system.traced.integrators
    if (level, batch) not in known:
        import numpy as np

        hy, names = importlib.import_module("heyoka"), system.model.states
        variables = [hy.expression(n) for n in names]
        pars = [hy.par[i] for i in range(len(system.constants))]
        rates = system.traced.folded[0].on(hy)(hy.time, *variables, *pars)
        zero = hy.expression(0.0)  # a rate may be a plain number
        equations = [(v, rate + zero) for v, rate in zip(variables, rates, strict=True)]
        make = hy.taylor_adaptive_batch if batch else hy.taylor_adaptive
        shape = (len(names), batch) if batch else len(names)
        known[level, batch] = make(equations, np.zeros(shape), tol=level)
    return known[level, batch]


def _scale(system, t, x, goal):
    """The factor, at most 1, for the tolerance of a motion whose states are all small."""
    largest = max(map(abs, x))
    if largest == 0.0:  # what they may become
        largest = max(map(abs, system.rates(t, x))) * (goal - t)
    return largest if 0.0 < largest < ABSOLUTE_SCALE else 1.0


class Taylor(Stepper):
    """A run by Taylor series. Without events it is one call of heyoka; the steps are made again if
    something between them is asked for.
    """

    natural = True

    def begin(self, trajectory):
        """See :class:`~newton_euler.motion.methods.base.Stepper`."""
        scale = _scale(self.system, self.t, self.x, self.goal)
        self.ta = integrator(self.system, self.tolerance * scale)
        self.series, self.kept, self.samples = [], None, trajectory.samples

    def _put(self, t, x):
        """Set the state of heyoka's integrator, which all motions of a right-hand side share."""
        ta = self.ta
        ta.pars[:] = self.system.constants[: len(ta.pars)]
        ta.time, ta.state[:] = t, x

    @staticmethod
    def prepared_run(system, tolerance, fallback):
        """The function that :func:`newton_euler.motion.integration.prepare` returns; where heyoka
        stops on the way or its tolerance is too coarse, that is ``fallback(t, start)``.
        """
        ta = integrator(system, tolerance)
        state, pars, propagate = ta.state, ta.pars, ta.propagate_until
        p, count = pars.copy(), len(state)
        p[:] = system.constants[: len(pars)]

        def run(t, start):
            if len(start) != count or max(map(abs, start)) < ABSOLUTE_SCALE:
                return fallback(t, start)
            pars[:] = p  # another model of this right-hand side may have set its own
            ta.time = 0.0
            state[:] = start
            # a limit, since near a singular place the steps become shorter without end
            propagate(t, max_steps=100 * MAX_STALLED_STEPS)
            x = tuple(state.tolist())
            return x if ta.time == t and isfinite(sum(x)) else fallback(t, start)

        return run

    def step(self, limit=inf):
        """See :class:`~newton_euler.motion.methods.base.Stepper`."""
        if limit < inf or not self.natural:
            self._by_steps(limit)
        elif self.samples is None or not self._by_samples():
            self._at_once()

    def _at_once(self):
        ta = self.ta
        self._put(self.t, self.x)
        while self.t < self.goal:
            _, _, longest, steps, *_ = ta.propagate_until(self.goal, max_steps=MAX_STALLED_STEPS)
            before, self.t, self.x = self.t, ta.time, tuple(ta.state.tolist())
            self.calls += steps * ta.order
            self.longest = max(self.longest, longest)
            stalled = self.t - before < STALLED_RATIO * steps * self.longest
            if (self.t < self.goal and stalled) or not isfinite(sum(self.x)):
                self._by_steps()  # to see where it fails
                return
        self.step_times.append(self.t)
        self.update_scales()

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
        self.x = tuple(found[:, -1].tolist())
        self.step_times.append(self.t)
        self.update_scales()
        return True

    def _grid(self, times):
        """The states at increasing times from the start on, an array (states, times); None if
        heyoka stops on the way.
        """
        import numpy as np

        self._put(*self.start)
        begin = self.start[0]
        grid = times if times[0] == begin else np.concatenate(([begin], times))
        _, _, _, steps, *_, found = self.ta.propagate_grid(grid, max_steps=100 * MAX_STALLED_STEPS)
        self.calls += steps * self.ta.order
        return found[-len(times) :].T if len(found) == len(grid) else None

    def _by_steps(self, limit=None):
        """Go on by so many steps and keep their series; None: all steps again from the start."""
        ta = self.ta
        if limit is None:
            (self.t, self.x), limit = self.start, inf
            self.step_times = [self.t]
        self._put(self.t, self.x)
        while limit > 0 and self.t < self.goal:
            h = self.goal - self.t
            if not self.natural:
                ta.step(max_delta_t=h)
                h = min(h, SHORT * ta.last_h)
                self._put(self.t, self.x)
            ta.step(max_delta_t=h, write_tc=True)
            x = tuple(ta.state.tolist())
            # a step of less than twice a float's epsilon does not change the time
            if not isfinite(sum(x)) or ta.last_h < 4e-16 * abs(self.t):
                raise StepError("the series is not finite here, or the step became too small")
            self.series.append(ta.tc.copy())
            self.t, self.x, limit = float(ta.time), x, limit - 1
            self.calls += ta.order
            self.step_times.append(self.t)
            self.update_scales()
            self.check_progress()

    def states(self, times):
        """See :class:`~newton_euler.motion.methods.base.Stepper`."""
        import numpy as np

        times = np.asarray(times, dtype=float)
        if self.kept and np.array_equal(times, self.kept[0]):
            return self.kept[1]
        if not self.series and len(self.step_times) > 1:
            increasing = len(times) > 1 and np.all(np.diff(times) > 0)
            found = self._grid(times) if increasing else None
            if found is not None:
                return found
            self._by_steps()
        return super().states(times)

    def interpolate(self, n, times):
        """See :class:`~newton_euler.motion.methods.base.Stepper`; the Taylor polynomial is as
        accurate as the step.
        """
        from numpy.polynomial.polynomial import polyval

        return polyval(times - self.step_times[n], self.series[n].T)


class ShortSteps(Taylor):
    """The same by shorter steps; the difference is the error of :class:`Taylor`, truncation and
    round-off.
    """

    natural = False
