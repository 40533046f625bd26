"""What every method of integration is to the motion: a *course*, that goes on step by step and knows the states in between.

Here are the frame that they share, the exact solution as a course, and SciPy's methods. Others: :mod:`.dop853`, :mod:`.taylor`, :mod:`.splitting`.
"""

from bisect import bisect_right
from itertools import pairwise

SMALL = 1e-6  # a state that stays smaller than this, in its unit, is accurate relative to this
PATIENCE, CREEPING = 2000, 1e-5  # so many steps, each on average less than this part of the longest one, lead nowhere


def instants(samples, begin, end):
    """The times of samples, an array: those given that lie between begin and end, or so many at equal distances."""
    import numpy as np

    if isinstance(samples, int):
        return np.linspace(begin, end, samples)
    times = np.asarray(samples, dtype=float)
    return times if len(times) and times[0] >= begin and times[-1] <= end else times[(times >= begin) & (times <= end)]


class StepError(ArithmeticError):
    """The method cannot go on from the place that its course has reached."""


class Course:
    """From the state ``x`` at ``t`` towards the goal of the ``journey``, which also has the ``tolerance``, a fixed ``step`` for methods that have an
    order, and the ``samples`` that will be asked for.

    t, x : reached so far; ``bounds`` : ends of the pieces (steps) behind it; ``sizes`` : the largest size of each state; ``calls`` of the
    right-hand side. A subclass has ``advance(limit)`` and ``on_piece(at, times)``.
    """

    def __init__(self, system, t, x, journey):
        self.system, self.t, self.x, self.goal, self.tolerance = system, t, tuple(x), journey.goal, journey.tolerance
        self.bounds, self.calls, self.start = [t], 0, (t, tuple(x))
        self.creep, self.longest = 0, 0.0
        self.sizes = tuple([v if v > SMALL else SMALL for v in map(abs, x)])
        if journey.known_sizes:
            self.sizes = tuple(max(s, 1e-6 * known) for s, known in zip(self.sizes, journey.known_sizes, strict=True))

    @property
    def places(self):
        """The states at some of the ends of pieces, as pairs of time and state: for another run to be compared with."""
        return []

    def piece(self, t):
        """The number of the piece in which t lies."""
        return min(max(bisect_right(self.bounds, t) - 1, 0), len(self.bounds) - 2)

    def restep(self, t):
        """The state at t, as accurate as the method can."""
        import numpy as np

        return tuple(self.on_piece(self.piece(t), np.array([t]))[:, 0].tolist())

    def states(self, times):
        """The states at an array of times already behind, as an array (states, times)."""
        import numpy as np

        times = np.asarray(times, dtype=float)
        out = np.empty((len(self.x), len(times)))
        at = np.clip(np.searchsorted(self.bounds, times, side="right") - 1, 0, max(len(self.bounds) - 2, 0))
        for piece in np.unique(at):
            chosen = at == piece
            out[:, chosen] = self.on_piece(int(piece), times[chosen]) if len(self.bounds) > 1 else np.array(self.x)[:, None]
        return out

    def creeps(self):
        """Raise :class:`StepError` if the last steps have hardly led on, as where the rates jump between plus and minus infinity."""
        n = len(self.bounds)
        if n > self.creep + PATIENCE:
            done = self.bounds[self.creep :]
            self.longest = max(self.longest, *(b - a for a, b in pairwise(done)))
            if self.t - done[0] < CREEPING * (len(done) - 1) * self.longest:
                raise StepError(f"{len(done) - 1} steps have led on by {self.t - done[0]:.1g} only")
            self.creep = n - 1

    def grown(self):
        """Keep the largest sizes."""
        self.sizes = tuple(map(max, self.sizes, map(abs, self.x)))


def chosen(count):
    """Two numbers below ``count``, in the second half."""
    return sorted({3 * count // 5, 4 * count // 5}) if count > 4 else []
