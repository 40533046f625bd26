"""Heyoka's Taylor method on the traced right-hand side: compiled once for a right-hand side and a level of accuracy, then the fastest by far.

Parameters are arguments of what is compiled, so that other values need no other compilation.
"""

import importlib
import importlib.util
import math
from functools import cache

from .courses import MAX_STALLED_STEPS, STALLED_RATIO, StepError, Stepper, sample_times

LEVELS = (*(10.0 ** (-n / 2) for n in range(8, 31)), 2.3e-16)  # of heyoka's tolerance: each one is compiled by itself
TAYLOR_MARGIN = 10.0**1.5  # the error asked for over heyoka's tolerance: of 310 runs 3 are then worse than asked for, at 10 14
ABSOLUTE_SCALE = 0.1  # states of this size are accurate enough with the tolerance as it is
SHORT = 0.6  # of a natural step: at the orders used (8 to 20) the error is then a hundredth or less


@cache
def installed():
    """True where heyoka is."""
    return importlib.util.find_spec("heyoka") is not None


def integrator(system, tolerance, batch=None):
    """Heyoka's integrator for this right-hand side, of the first level not above the tolerance; with ``batch`` one for so many motions at once."""
    level = next((x for x in LEVELS if x <= 1.01 * tolerance), LEVELS[-1])
    known = system.traced.integrators
    if (level, batch) not in known:
        hy = importlib.import_module("heyoka")
        variables = [hy.expression(n) for n in system.model.states]
        rest, _ = system.traced.folded
        outputs = rest._on(hy)(hy.time, *variables, *(hy.par[i] for i in range(len(system.constants))))
        equations = [(v, o + hy.expression(0.0)) for v, o in zip(variables, outputs, strict=True)]
        n = len(variables)
        if batch is None:
            known[level, batch] = hy.taylor_adaptive(equations, [0.0] * n, tol=level)
        else:
            import numpy as np

            known[level, batch] = hy.taylor_adaptive_batch(equations, np.zeros((n, batch)), tol=level)
    return known[level, batch]


def _scale(system, t, x, goal):
    """By what to make the tolerance smaller: to heyoka it is absolute where all states are less than 1."""
    largest = max(map(abs, x))
    if largest == 0.0:  # what they may become
        largest = max(abs(rate) for rate in system.rates(t, x)) * (goal - t)
    return 1.0 if largest >= ABSOLUTE_SCALE or not largest > 0.0 else largest


class Taylor(Stepper):
    """The course of a motion by Taylor series. Without events it is one call; what lies between is worked out when it is asked for."""

    natural = True

    def __init__(self, system, t, x, trajectory):
        super().__init__(system, t, x, trajectory)
        self.ta = integrator(system, trajectory.tolerance * _scale(system, t, self.x, self.goal))
        self.series, self.kept, self.samples = [], None, trajectory.samples

    def _put(self, t, x):
        pars = self.ta.pars
        pars[:] = self.system.constants[: len(pars)]
        self.ta.time = t
        self.ta.state[:] = x

    @staticmethod
    def prepared(system, tolerance, fallback):
        """See :func:`newton_euler.motion.prepare`; where it does not go smoothly, ``slowly(t, start)`` does, or says why not."""
        ta = integrator(system, tolerance)
        state, pars, propagate = ta.state, ta.pars, ta.propagate_until
        p, count = pars.copy(), len(state)
        p[:] = system.constants[: len(pars)]

        def run(t, start):
            if len(start) != count or max(map(abs, start)) < ABSOLUTE_SCALE:
                return fallback(t, start)
            pars[:] = p
            ta.time = 0.0
            state[:] = start
            propagate(t, max_steps=100 * MAX_STALLED_STEPS)
            x = tuple(state.tolist())
            return x if ta.time == t and math.isfinite(sum(x)) else fallback(t, start)

        return run

    def step(self, limit=math.inf):
        """Go on by at most so many steps."""
        if limit < math.inf or not self.natural:
            return self._by_steps(self.goal, limit)
        ta = self.ta
        self._put(self.t, self.x)
        if self.samples is not None and self._by_grid():
            return None
        while self.t < self.goal:
            _, _, longest, steps, *_ = ta.propagate_until(self.goal, max_steps=MAX_STALLED_STEPS)
            before, self.t, self.calls = self.t, ta.time, self.calls + steps * ta.order
            self.x, self.longest = tuple(ta.state.tolist()), max(self.longest, longest)
            if (self.t < self.goal and self.t - before < STALLED_RATIO * steps * self.longest) or not math.isfinite(sum(self.x)):
                return self._again()
        self.step_times.append(self.t)
        return self.update_scales()

    def _by_grid(self):
        """All the way by heyoka's grid, with the samples that are wanted; False if it does not go smoothly."""
        import numpy as np

        times = sample_times(self.samples, self.t, self.goal)
        if len(times) < 2 or times[0] < self.t or np.any(np.diff(times) <= 0) or times[-1] > self.goal:
            return False
        before, after = int(times[0] > self.t), int(times[-1] < self.goal)
        grid = np.concatenate(([self.t] * before, times, [self.goal] * after)) if before or after else times
        _, _, _, steps, *_, found = self.ta.propagate_grid(grid, max_steps=100 * MAX_STALLED_STEPS)
        if len(found) < len(grid) or not math.isfinite(sum(found[-1].tolist())):
            self._put(self.t, self.x)
            return False
        self.kept = times, found[before : len(grid) - after].T
        self.t, self.x, self.calls = self.goal, tuple(found[-1].tolist()), self.calls + steps * self.ta.order
        self.step_times.append(self.t)
        self.update_scales()
        return True

    def _again(self):
        """By single steps, to see where it fails."""
        self.t, self.x = self.start
        self._by_steps(self.goal, math.inf)

    def _by_steps(self, goal, limit):
        ta = self.ta
        self._put(self.t, self.x)
        while limit > 0 and self.t < goal:
            h = goal - self.t
            if not self.natural:
                ta.step(max_delta_t=h)
                h = min(h, SHORT * ta.last_h)
                self._put(self.t, self.x)
            ta.step(max_delta_t=h, write_tc=True)
            x = tuple(ta.state.tolist())
            if not math.isfinite(sum(x)) or ta.last_h < 4e-16 * abs(self.t):
                raise StepError("the series has no finite terms here, or the step became too small to go on")
            self.series.append(ta.tc.copy())
            self.t, self.x, self.calls, limit = float(ta.time), x, self.calls + ta.order, limit - 1
            self.step_times.append(self.t)
            self.update_scales()
            self.check_progress()

    def states(self, times):
        """On many times by heyoka's own grid, if the steps are not known yet."""
        import numpy as np

        times = np.asarray(times, dtype=float)
        if self.kept and np.array_equal(times, self.kept[0]):
            return self.kept[1]
        if self.series or len(self.step_times) < 2 or len(times) < 2 or np.any(np.diff(times) <= 0):
            return super().states(times)
        self._put(*self.start)
        begun = times[0] == self.start[0]
        found = self.ta.propagate_grid(times if begun else np.concatenate(([self.start[0]], times)))[-1]
        return found[0 if begun else 1 :].T

    def interpolate(self, at, times):
        """The Taylor polynomial of the step."""
        from numpy.polynomial.polynomial import polyval

        if not self.series:  # one call has led here: go the same way by steps
            ends = self.step_times[1:]
            self.t, self.x = self.start
            self.step_times = [self.t]
            self._by_steps(ends[-1], math.inf)
            return super().states(times)
        return polyval(times - self.step_times[at], self.series[at].T)

    def state_at(self, t):
        """The Taylor polynomial is as accurate as the step."""
        import numpy as np

        return tuple(self.states(np.array([t]))[:, 0].tolist())


class ShortSteps(Taylor):
    """The same with shorter steps: the difference is the error of :class:`Taylor`, truncation and round-off."""

    natural = False
