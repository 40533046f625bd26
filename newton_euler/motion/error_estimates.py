"""The error of a run, from its difference to one of another tolerance, and by round-off."""

import math

from ..algebra.late import is_here, np
from .chebyshev import EPS
from .methods.base import Stepper
from .methods.table import Method
from .narrow import rates_along
from .sizes import small, time_round_off
from .trajectory import Trajectory

# A run is compared with one of a coarser tolerance. If both are in the regime in which errors are
# proportional to the tolerance, the error of the fine one is predicted by a power of the ratio of
# the tolerances a little below 1; else, as at kinks, by a low power. Measured by tests/honesty on
# 115 models, at 1e-3 to 1e-12: these cover 98 % of the true errors, and are 15 times too large in
# the median.
SAFETY, REGULAR, IRREGULAR = 7.0, 0.9, 0.4
REPORTED_SAFETY = 3.0  # factor on the reported error: with it 99 % are covered
# factors on the difference of a series from one of higher order, and on the integral of its
# residual
SERIES_SAFETY = RESIDUAL_SAFETY = 3.0
# limits of the regime: the fewest steps, and the factor by which the number of steps of the fine
# run may differ from what its order predicts
MIN_STEPS, STEPS_OFF = 8, 1.25
# the error, for a short run, that the difference of two runs does not show; over n steps it grows
# as sqrt(n), like a random walk
ROUND_OFF, SERIES_ROUND_OFF = 5e-14, 9e-15
# The run for comparison starts from slightly shifted states, so that the predicted error contains
# the effect of round-off in the rates, 25 times a float's epsilon, in the start and in parameters,
# which is the same in both runs.
ROUND_OFF_OF_RATES = 5e-15
# the largest tolerance at which round-off on the way may be more than what the difference shows
TIGHT = 1e-13
MOVED = 2.0**-40  # relative change by which the slopes of the rates are measured
# number of steps over which a state's round-off affects the rates, and its size in last bits;
# measured on 150 bounces off poles, gates and brakes
LASTING, LOST = 16, 0.2
MOST_STEPS = 20_000  # beyond this the round-off of the steps themselves dominates
FAR = 1e3  # a state is far from zero if its size is more than this multiple of its change


def reported_error(error: float, rtol: float) -> float:
    """The reported error: with more safety than the one that is judged, but not above the rtol."""
    return max(error, min(rtol, REPORTED_SAFETY * error))


def relative_shift(ratio: float) -> float:
    """The relative shift of the states with which a run for comparison starts; see
    :func:`error_by_difference` for the ratio.
    """
    safety = SERIES_SAFETY if ratio > 1 else SAFETY * ratio**REGULAR
    return ROUND_OFF_OF_RATES / safety


def error_by_comparison(before: Trajectory, trajectory: Trajectory, method: Method) -> float:
    """The error of a trajectory, predicted from its difference to one of another tolerance."""
    difference, tolerance = before.difference(trajectory), trajectory.tolerance
    ratio, traced = tolerance / before.tolerance, trajectory.segments[0].system.traced
    coarse, fine = before.count, trajectory.count
    regular = method.series or coarse >= MIN_STEPS
    if method.adaptive and not trajectory.stopping:
        assert method.order is not None
        growth = fine / max(coarse, 1) * ratio ** (1 / method.order)
        regular = regular and 1 / STEPS_OFF < growth < STEPS_OFF
    # steps that end at kinks are as regular as others
    if traced.hazards or (traced.surprises and not trajectory.stopping):
        regular = False
    # far from the origin the error of a coordinate, which is large there, does not set the steps
    if method.adaptive and trajectory.known and small(*trajectory.known[:2]):
        regular = False
    system, stepper, t0, t1, x1 = trajectory.segments[-1]
    more = time_round_off(system, t1, x1, stepper.scales, t1 - t0 or 1.0)  # round-off of the time
    if method.series and traced.hazards:
        more += RESIDUAL_SAFETY * max([part.stepper.residual() for part in trajectory.segments])
    if tolerance <= TIGHT and (method.series or method.adaptive) and is_here("numpy"):
        found = [round_off_of_rates(part.stepper) for part in trajectory.segments]
        more = math.hypot(more, *found)
    more = math.hypot(more, *(round_off_far_away(part.stepper) for part in trajectory.segments))
    return math.hypot(error_by_difference(difference, ratio, tolerance, regular, fine), more)


def error_by_difference(
    difference: float, ratio: float, tolerance: float, regular: bool = True, steps: int = 0
) -> float:
    """The error of a run, predicted from its difference to one of another tolerance; ``ratio`` is
    that of this run over that of the other, above 1 if the other one is more accurate.
    """
    if not difference <= 0.05:
        return difference  # too large to predict anything
    growth = math.sqrt(1 + steps / 100)
    if ratio > 1:  # the difference is the error itself
        return SERIES_SAFETY * difference + SERIES_ROUND_OFF * growth
    error = SAFETY * difference * ratio ** (REGULAR if regular else IRREGULAR)
    return max(error, tolerance) + ROUND_OFF * growth


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
