"""The error that round-off of the time and of the states causes by way of the rates."""

from ..algebra.late import np
from .chebyshev import EPS
from .methods.base import Stepper
from .narrow import rates_along

MOVED = 2.0**-40  # relative change by which the slopes of the rates are measured
# number of steps over which a state's round-off affects the rates, and its size in last bits;
# measured on 150 bounces off poles, gates and brakes
LASTING, LOST = 16, 0.2
MOST_STEPS = 20_000  # beyond this the round-off of the steps themselves dominates
FAR = 1e3  # a state is far from zero if its size is more than this multiple of its change


def round_off_far_away(stepper: Stepper) -> float:
    """As :func:`round_off_of_rates`, for a run through a narrow feature far from zero, such as a
    stiff floor, where the digits that a state loses stay lost; 0 for other runs.
    """
    if not (stepper.resumable and stepper.steps and stepper.system.traced.narrow):
        return 0.0
    columns = zip(*(s[-len(stepper.x) :] for s in stepper.steps), strict=True)
    far = any(max(map(abs, c)) > FAR * (max(c) - min(c)) > 0.0 for c in columns)
    return round_off_of_rates(stepper, MOST_STEPS) if far else 0.0


def round_off_of_rates(stepper: Stepper, lasting: int = LASTING) -> float:
    """The error, relative to the scales, that round-off of time and states causes by way of the
    rates, a random walk over the steps: large where a narrow feature lies at a large coordinate, as
    in c - x beside c. The digits that a state loses affect the rates of the next ``lasting`` steps.
    """
    if max(stepper.taken, len(stepper.step_times)) > MOST_STEPS or stepper.t == stepper.start[0]:
        return 0.0
    kept, stepper = stepper.steps, stepper.dense
    times, size = np.array(stepper.step_times), len(stepper.x)
    x = np.array([*(s[-size:] for s in kept), stepper.x]).T if kept else stepper.states(times)
    made, x, lengths = abs(np.diff(x)), x[:, :-1], np.diff(times)
    rows = np.vstack([times[:-1], x])
    number, slopes = np.arange(len(lengths)), []
    with np.errstate(all="ignore"):
        rates = rates_along(stepper, rows[0], x)
        for k, row in enumerate(rows):
            differences = []
            for part in (MOVED, -MOVED):
                moved = rows.copy()
                moved[k] *= 1 + part
                differences.append((rates_along(stepper, moved[0], moved[1:]) - rates) / part)
            # across a jump on one side the difference is not a slope
            least = np.where(abs(differences[0]) < abs(differences[1]), *differences)
            slopes.append(np.nan_to_num(least / row, posinf=0.0, neginf=0.0))
    # a state that decays fast forgets it within the step
    own = np.array([slopes[k + 1][k] for k in range(size)])
    lengths, total = lengths / (1 + lengths * np.maximum(-own, 0.0)), np.zeros(size)
    for k, row in enumerate(rows):
        sums = np.pad((slopes[k] * lengths).cumsum(axis=1), ((0, 0), (1, 0)))
        later = np.minimum(number + (lasting if k else 1), len(number))
        # a state that does not change loses nothing
        part = LOST * np.minimum(abs(row), made[k - 1] * 2 / EPS) if k else row
        lost = (sums[:, later] - sums[:, number]) * part
        total += (lost**2).sum(axis=1)
    scales = np.array([s or 1.0 for s in stepper.scales])
    return float((np.sqrt(total) / scales).max()) * EPS / 2
