"""What every method of integration is to the motion: a *course*, that goes on step by step and knows the states in between.

Here are the frame that they share, the exact solution as a course, and SciPy's methods. Others: :mod:`.dop853`, :mod:`.taylor`, :mod:`.splitting`.
"""

from bisect import bisect_right
from itertools import pairwise

SMALLEST_SCALE = 1e-6  # a state that stays smaller than this, in its unit, is accurate relative to this
MAX_STALLED_STEPS, STALLED_RATIO = 2000, 1e-5  # so many steps, each on average less than this part of the longest one, lead nowhere


def sample_times(samples, begin, end):
    """The times of samples, an array: those given that lie between begin and end, or so many at equal distances."""
    import numpy as np

    if isinstance(samples, int):
        return np.linspace(begin, end, samples)
    times = np.asarray(samples, dtype=float)
    return times if len(times) and times[0] >= begin and times[-1] <= end else times[(times >= begin) & (times <= end)]


class StepError(ArithmeticError):
    """The method cannot go on from the place that its course has reached."""


class Stepper:
    """From the state ``x`` at ``t`` towards the goal of the ``journey``, which also has the ``tolerance``, a fixed ``step`` for methods that have an
    order, and the ``samples`` that will be asked for.

    t, x : reached so far; ``bounds`` : ends of the pieces (steps) behind it; ``sizes`` : the largest size of each state; ``calls`` of the
    right-hand side. A subclass has ``advance(limit)`` and ``on_piece(at, times)``.
    """

    def __init__(self, system, t, x, trajectory):
        self.system, self.t, self.x, self.goal, self.tolerance = system, t, tuple(x), trajectory.goal, trajectory.tolerance
        self.step_times, self.calls, self.start = [t], 0, (t, tuple(x))
        self.checked, self.longest = 0, 0.0
        self.scales = tuple([v if v > SMALLEST_SCALE else SMALLEST_SCALE for v in map(abs, x)])
        if trajectory.initial_scales:
            self.scales = tuple(max(s, 1e-6 * known) for s, known in zip(self.scales, trajectory.initial_scales, strict=True))

    @property
    def checkpoints(self):
        """The states at some of the ends of pieces, as pairs of time and state: for another run to be compared with."""
        return []

    def step_index(self, t):
        """The number of the piece in which t lies."""
        return min(max(bisect_right(self.step_times, t) - 1, 0), len(self.step_times) - 2)

    def state_at(self, t):
        """The state at t, as accurate as the method can."""
        import numpy as np

        return tuple(self.interpolate(self.step_index(t), np.array([t]))[:, 0].tolist())

    def states(self, times):
        """The states at an array of times already behind, as an array (states, times)."""
        import numpy as np

        times = np.asarray(times, dtype=float)
        out = np.empty((len(self.x), len(times)))
        at = np.clip(np.searchsorted(self.step_times, times, side="right") - 1, 0, max(len(self.step_times) - 2, 0))
        for step_index in np.unique(at):
            chosen = at == step_index
            out[:, chosen] = self.interpolate(int(step_index), times[chosen]) if len(self.step_times) > 1 else np.array(self.x)[:, None]
        return out

    def check_progress(self):
        """Raise :class:`StepError` if the last steps have hardly led on, as where the rates jump between plus and minus infinity."""
        n = len(self.step_times)
        if n > self.checked + MAX_STALLED_STEPS:
            done = self.step_times[self.checked :]
            self.longest = max(self.longest, *(b - a for a, b in pairwise(done)))
            if self.t - done[0] < STALLED_RATIO * (len(done) - 1) * self.longest:
                raise StepError(f"{len(done) - 1} steps have led on by {self.t - done[0]:.1g} only")
            self.checked = n - 1

    def update_scales(self):
        """Keep the largest sizes."""
        self.scales = tuple(map(max, self.scales, map(abs, self.x)))


def checkpoint_indices(count):
    """Two numbers below ``count``, in the second half."""
    return sorted({3 * count // 5, 4 * count // 5}) if count > 4 else []
