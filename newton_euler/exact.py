"""The exact solution of a model as a method of integration."""

import math

from .courses import Stepper

EVENT_INTERVALS = 8  # of the solution, in which events are sought


class Exact(Stepper):
    """The exact solution of the model, which takes no steps: what is in between is the solution too."""

    def step(self, limit=math.inf):
        """To the goal; with a limit, as events are sought, in pieces."""
        (t, x), goal = self.start, self.goal
        self.x, self.t, self.calls = self.system.solution(goal - t, x), goal, 1
        if limit < math.inf:
            self.step_times += [t + (goal - t) * n / EVENT_INTERVALS for n in range(1, EVENT_INTERVALS)]
        self.step_times.append(goal)

    @staticmethod
    def prepared(system, tolerance, fallback):
        """See :func:`newton_euler.motion.prepare`."""
        return system.solution

    def interpolate(self, at, times):
        """The solution itself."""
        start, x = self.start
        self.calls += len(times)
        return self.system.solutions(times - start, x)
