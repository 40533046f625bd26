"""The error that round-off of the time and of the states makes by their rates."""

from .chebyshev import EPS
from .narrow import rates_along

MOVED = 2.0**-40  # relative change by which the slopes of the rates are measured
# steps over which what a state loses by round-off moves the rates, and what part of the last bit it
# is; measured on 150 bounces off poles, gates and brakes
LASTING, LOST = 16, 0.2
MOST_STEPS = 20_000  # in more the round-off of the steps themselves is more
FAR = 1e3  # times what it changes by: the size of a state that is far from zero


def round_off_far_away(stepper):
    """As :func:`round_off_of_rates`, of a run through something narrow that is far from zero, such
    as a stiff floor, where what a state loses stays lost; 0 for others.
    """
    if not (stepper.resumable and stepper.steps and stepper.system.traced.narrow):
        return 0.0
    columns = zip(*(s[-len(stepper.x) :] for s in stepper.steps), strict=True)
    far = any(max(map(abs, c)) > FAR * (max(c) - min(c)) > 0.0 for c in columns)
    return round_off_of_rates(stepper, MOST_STEPS) if far else 0.0


def round_off_of_rates(stepper, lasting=LASTING):
    """The error, over the scales, by round-off of time and states in the rates, a random walk over
    the steps: large where something narrow is reached by a large coordinate, as c - x beside c.
    What a state loses moves the rates of the next steps, too, ``lasting`` of them.
    """
    import numpy as np

    if max(stepper.taken, len(stepper.step_times)) > MOST_STEPS or stepper.t == stepper.start[0]:
        return 0.0
    kept, stepper = stepper.steps, stepper.dense
    times, size = np.array(stepper.step_times), len(stepper.x)
    x = np.array([*(s[-size:] for s in kept), stepper.x]).T if kept else stepper.states(times)
    made, x, lengths = abs(np.diff(x)), x[:, :-1], np.diff(times)
    rows = np.vstack([times[:-1], x])
    number, slopes = np.arange(len(lengths)), []
    with np.errstate(all="ignore"):
        rates = rates_along(np, stepper, rows[0], x)
        for k, row in enumerate(rows):
            apart = []
            for part in (MOVED, -MOVED):
                moved = rows.copy()
                moved[k] *= 1 + part
                apart.append((rates_along(np, stepper, moved[0], moved[1:]) - rates) / part)
            # across a jump on one side the difference is not a slope
            least = np.where(abs(apart[0]) < abs(apart[1]), *apart)
            slopes.append(np.nan_to_num(least / row, posinf=0.0, neginf=0.0))
    # a state that decays fast has forgotten it within the step
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
