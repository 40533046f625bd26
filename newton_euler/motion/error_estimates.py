"""The error of a run, estimated from its difference to a run of another tolerance."""

import math

from ..algebra.late import is_here
from .methods.table import Method
from .round_off import round_off_far_away, round_off_of_rates
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
