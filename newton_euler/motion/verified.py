"""Verified runs: those close to one are as accurate, so under a slider few are compared."""

# largest distance of a start, and of an end, from a verified one, as a fraction of the state's size
from .methods.base import Floats

NEAR_START, NEAR_END = 0.02, 0.2
# factor by which a run that vouches for others must be more accurate than requested; by 3 some of
# a vibration beside a large state, which a few steps resolve or not, were off 5 times
SPARE = 10.0


class Verified:
    """The last verified run of a model for each rtol; threads see whole records, all right."""

    def __init__(self):
        self.runs: dict[float, tuple] = {}

    def add(self, rtol: float, t0: float, t1: float, x0: Floats, x1: Floats, error: float) -> None:
        """Record a run whose error is not above the rtol."""
        self.runs[rtol] = (t0, t1), x0, x1, error

    def covers(self, rtol: float, t0: float, t1: float, start: Floats, end: Floats) -> bool:
        """True if this run is the verified one; or so close to it that it has about the same error,
        if that is well below the rtol: other steps from the same start are close, not the same.
        """
        span, known_start, known_end, error = self.runs.get(rtol, (None,) * 4)
        if span != (t0, t1):
            return False
        if (start, end) == (known_start, known_end):
            return True
        return SPARE * error <= rtol and near(start, end, known_start, known_end)


def near(start: Floats, end: Floats, other_start: Floats, other_end: Floats) -> bool:
    """True if two motions begin and end close to each other, each state relative to its size."""
    for a, b, c, d in zip(start, end, other_start, other_end, strict=True):
        size = max(abs(a), abs(b), abs(c), abs(d))
        if abs(a - c) > NEAR_START * size or abs(b - d) > NEAR_END * size:
            return False
    return True
