"""The exact solution of a model as a method of integration."""

from math import inf

from .base import Stepper


class Exact(Stepper):
    """The exact solution of the model: one step, inside which every state is exact too."""

    def step(self, limit=inf):
        """See :class:`~newton_euler.motion.methods.base.Stepper`."""
        self.x, self.t, self.calls = self.system.solution(self.goal - self.t, self.x), self.goal, 1
        self.step_times.append(self.t)

    @staticmethod
    def prepared_run(system, tolerance, fallback):
        """The function that :func:`newton_euler.motion.integration.prepare` returns."""
        return system.solution

    def interpolate(self, n, times):
        """See :class:`~newton_euler.motion.methods.base.Stepper`."""
        start, x = self.start
        self.calls += len(times)
        return self.system.solutions(times - start, x)
