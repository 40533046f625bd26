"""Whether a state that is small by cancellation is there, or mere round-off: a swing of a
micrometre about the surface of the Earth is there, however much of it round-off hides.
"""

from contextlib import suppress

from .narrow import narrow_times

# times what the last digits of states and parameters make of a rate, or of a state, above which it
# is there; below 1.5 for 10 000 steady motions of tops, pendulums and orbits
THERE, LAST_DIGIT = 1.5, 2.0**-52
SWINGING = 10.0  # the same of the change of a rate with time
# parts of the time at which the rates are looked at: early ones too, at which a clock is known by
# many of its turns, irregular ones, and the ends of so many steps
EARLY, MANY, IRREGULAR, STEPS = (5e-4, 5e-3, 5e-2), 40, 0.618033988749895, 2000
OFF = 10.0  # tolerances, of its distance from an even change, by which a state may be off
HELD = 1e-3  # part of the rate of a state that small states make if it does not move without them


def driven(trajectory, start, natural, doubted):
    """Those of the ``doubted`` numbers of states that are there: they begin, or their rates in the
    first segment of the trajectory are, with more than what the last digits of states and
    parameters make.

    States that move by themselves, as a clock, are taken as the trajectory has them, which may be
    off by its tolerance; those that only doubted ones move, as a place far away, as at the
    ``start``, from which a run for comparison is shifted.
    """
    found = {k for k in doubted if abs(start[k]) > 2 * THERE * LAST_DIGIT * natural[k]}
    system, stepper, begin, *_ = trajectory.segments[0]
    if found == doubted:
        return found
    import numpy as np

    with suppress(ArithmeticError, ValueError), np.errstate(all="ignore"):
        times, x = _passed(np, stepper)

        def rates(x, p=system.p):
            values = system.traced.rhs.on(np)(times, *x, *p)
            return np.array([np.broadcast_to(row, times.shape) for row in values])

        first, held = np.array(start)[:, None], _held(np, rates, x, doubted)
        way = np.where(held[:, None], 0.0, x - x[:, :1])
        x = first + way
        made, apart = rates(x), []
        # a clock that runs evenly has no error, nor has what is held
        curved = np.minimum(abs(way), abs(way - made[:, :1] * (times - begin)))
        off = LAST_DIGIT * abs(x) + OFF * trajectory.tolerance * curved
        for k, d in enumerate(off):
            moved = x.copy()
            moved[k] += d
            apart.append(rates(moved) - made)
        for k, number in enumerate(system.p):
            p = *system.p[:k], number * (1 + LAST_DIGIT), *system.p[k + 1 :]
            apart.append(rates(x, p) - made)
        there = (abs(made) > THERE * sum(map(abs, apart))).any(axis=1)
        # what is the same at all times hides no push to and fro, which may be in resonance
        there |= np.ptp(made, axis=1) > SWINGING * sum(np.ptp(a, axis=1) for a in apart)
        found |= doubted & set(np.flatnonzero(there).tolist())
    return found


def _passed(np, stepper):
    """An array of times of a run, the start first, with those of narrow things and between them;
    and the states there.
    """
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


def _held(np, rates, x, doubted):
    """For each state whether its rates are made by the ``doubted`` ones, or by those that these
    move, or it is doubted.
    """
    moved, made = abs(x - x[:, :1]).max(axis=1), rates(x)
    held = np.isin(np.arange(len(x)), list(doubted))
    moved = np.where(held, abs(x).max(axis=1), moved)[:, None]
    for _ in x:
        apart = abs(rates(np.where(held[:, None], x + moved, x)) - made)
        held = held | (apart > HELD * abs(made)).any(axis=1)
    return held
