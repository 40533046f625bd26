"""Whether a state that cancellation has left small is genuine or mere round-off: a swing of a
micrometre at the surface of the Earth is genuine, however many of its digits round-off hides.
"""

from contextlib import suppress

from ..algebra.late import np
from .methods.base import Floats, rows_of
from .narrow import narrow_times
from .trajectory import Trajectory

# a rate, or a state, is genuine above this multiple of what the last digits of states and
# parameters contribute to it; 10 000 steady motions of tops, pendulums and orbits stayed below it
GENUINE, LAST_DIGIT = 1.5, 2.0**-52
SWINGING = 10.0  # GENUINE for the change of a rate with time
# fractions of the time at which the rates are examined: early ones, at which the phase of a
# clock is still accurate, irregular ones, and the ends of this many steps
EARLY, MANY, IRREGULAR, STEPS = (5e-4, 5e-3, 5e-2), 40, 0.618033988749895, 2000
ERROR = 10.0  # error of a state in tolerances, relative to its departure from a uniform change
DRIVEN = 1e-3  # fraction of its rate above which a state is driven by others


def driven(trajectory: Trajectory, start: Floats, natural: Floats, doubted: set[int]) -> set[int]:
    """The genuine states among the ``doubted`` ones, given by their numbers: their initial values,
    or their rates in the first segment of the trajectory, exceed what last digits contribute.

    States that move by themselves, such as a clock, are taken from the trajectory, whose error is
    within its tolerance. Those that are driven by doubted ones only, such as a distant position,
    keep their values at the ``start``: the run for comparison begins displaced.
    """
    found = {k for k in doubted if abs(start[k]) > 2 * GENUINE * LAST_DIGIT * natural[k]}
    system, stepper, begin, *_ = trajectory.segments[0]
    if found == doubted:
        return found
    with suppress(ArithmeticError, ValueError), np.errstate(all="ignore"):
        times, x = _points_passed(stepper)

        def rates(x, p=system.p):
            return rows_of(system.traced.rhs.on(np)(times, *x, *p), len(times))

        first, held = np.array(start)[:, None], _driven_by(rates, x, doubted)
        change = np.where(held[:, None], 0.0, x - x[:, :1])
        x = first + change
        found_rates, apart = rates(x), []
        # a clock that runs uniformly has no error
        departure = np.minimum(abs(change), abs(change - found_rates[:, :1] * (times - begin)))
        errors = LAST_DIGIT * abs(x) + ERROR * trajectory.tolerance * departure
        for k, error in enumerate(errors):
            displaced = x.copy()
            displaced[k] += error
            apart.append(rates(displaced) - found_rates)
        for k, number in enumerate(system.p):
            p = *system.p[:k], number * (1 + LAST_DIGIT), *system.p[k + 1 :]
            apart.append(rates(x, p) - found_rates)
        genuine = (abs(found_rates) > GENUINE * sum(map(abs, apart))).any(axis=1)
        # a constant error hides no oscillating force, which may be in resonance
        hidden = sum(np.ptp(error, axis=1) for error in apart)
        genuine |= np.ptp(found_rates, axis=1) > SWINGING * hidden
        found |= doubted & set(np.flatnonzero(genuine).tolist())
    return found


def _points_passed(stepper):
    """Times of a run and its states there: the start, narrow features, and between these."""
    begin, end, narrow = stepper.start[0], stepper.t, stepper.system.traced.narrow
    if begin == end:
        return np.array([begin]), np.array(stepper.start[1])[:, None]
    parts = np.array([*EARLY, *((n * IRREGULAR) % 1.0 for n in range(1, MANY))])
    ends = stepper.step_times[:: len(stepper.step_times) // STEPS + 1]
    times = [begin + (end - begin) * parts, ends]
    if narrow:
        at, knots, near = narrow_times(stepper, narrow, 0)
        places = np.sort([*at, *knots, *(t for t, _ in near)])
        times += [places, (places[1:] + places[:-1]) / 2]
    times = np.unique(np.concatenate(times))
    times = np.concatenate([[begin], times[times > begin]])
    return times, stepper.states(times)


def _driven_by(rates, x, doubted):
    """For each state, whether it is doubted, or driven, perhaps indirectly, by doubted ones."""
    moved, found_rates = abs(x - x[:, :1]).max(axis=1), rates(x)
    driven_ones = np.isin(np.arange(len(x)), list(doubted))
    moved = np.where(driven_ones, abs(x).max(axis=1), moved)[:, None]
    for _ in x:
        change = abs(rates(np.where(driven_ones[:, None], x + moved, x)) - found_rates)
        driven_ones = driven_ones | (change > DRIVEN * abs(found_rates)).any(axis=1)
    return driven_ones
