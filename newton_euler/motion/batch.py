"""Many motions of one model at once: arrays of starts, of parameters, or of both, of one length."""

from dataclasses import dataclass
from time import perf_counter
from types import MappingProxyType

from .control.knots import knots
from .control.run import ROUND_OFF_OF_RATES, SERIES_SAFETY, Run, predicted, told, usable
from .control.verified import NEAR_END, NEAR_START, SPARE
from .methods.exact import within
from .methods.table import METHODS
from .methods.taylor import MAX_PREPARED_STEPS, integrator, level_of
from .model import ModelError
from .prepared import PreparedModel, prepared_model
from .solution import AccuracyError, Cost, MotionError

WINDOW = 64  # motions among which those close to one are looked for
MIN_HEYOKA_BATCH = 64  # motions; fewer are not worth the compilation of a batch integrator


@dataclass(frozen=True, eq=False)
class Motions:
    """Many motions: ``times`` (samples), ``states`` by name as arrays (motions, times), ``method``,
    the estimated ``error`` of each motion, of exact solutions a bound, ``cost``.
    """

    model: object
    times: object
    states: MappingProxyType
    method: object
    rtol: float
    error: object
    cost: Cost

    def __len__(self):
        return len(next(iter(self.states.values())))


def integrate_batch(model, t0, t1, state, rtol, method, events, samples):
    """The :class:`Motions` of :func:`newton_euler.motion.integration.integrate` where the start or
    the parameters are arrays.
    """
    import numpy as np

    if events:
        raise ModelError("events need one motion at a time; integrate each start by itself")
    begun, size = perf_counter(), len(state)
    values = {n: x for n, x in model.parameters.items() if getattr(x, "shape", ())}
    try:
        arrays = np.broadcast_arrays(*state, *values.values())
    except ValueError as error:
        given = [*zip(model.states, state, strict=True), *values.items()]
        shapes = ", ".join(f"{n} {np.shape(x)}" for n, x in given)
        raise ModelError(f"these arrays have lengths that do not fit together: {shapes}") from error
    if arrays[0].ndim != 1:
        raise ModelError(f"many motions need arrays of one dimension, got {arrays[0].shape}")
    starts = np.array(arrays[:size], dtype=float)
    parameters = dict(zip(values, arrays[size:], strict=True))
    if not all(np.isfinite(a).all() for a in (starts, *arrays[size:])):
        raise ModelError(f"starts and parameters of {model.name!r} must be finite numbers")
    if isinstance(samples, int):
        times = np.linspace(t0, t1, samples)
    else:
        times = np.array((t0, t1) if samples is None else samples, dtype=float)
    system, exact = PreparedModel(model), METHODS["exact"]

    def alone(n):
        """The model of the motion of this number, and its start."""
        values = {k: float(x[n]) for k, x in parameters.items()}
        changed = model.changed(**values) if values else model
        return prepared_model(changed), tuple(starts[:, n].tolist())

    count = starts.shape[1]
    found, errors = np.full((size, count, len(times)), np.nan), np.full(count, np.inf)
    used, calls, refused = METHODS.get(method), 0, {}
    if method in ("auto", "exact") and not exact.unusable_because(system, t0):
        used, calls = exact, len(times)
        columns = model.changed(**{n: x[:, None] for n, x in parameters.items()})
        rows = PreparedModel(columns).function(model.exact)(times - t0, *starts[:, :, None])
        for row, values in zip(found, rows, strict=True):
            row[:] = values
        ends = found[:, :, -1]
        begins = np.array([*starts, *(parameters[n] for n in parameters)])
        chosen, vouching = _representatives(begins, ends)
        for n in chosen.tolist():
            one, x0 = alone(n)
            # those close to it are about as accurate
            if within(one, t1 - t0, x0, tuple(ends[:, n].tolist()), rtol / SPARE):
                errors[vouching == n] = rtol
    elif _by_series(system, method, count):
        used = usable("taylor", system)
        found, errors, calls = _taylor(system, starts, parameters, t0, times, rtol)
    # what is not as accurate as asked, one by one, with all care
    for n in np.flatnonzero(~(errors <= rtol)).tolist():
        one, x0 = alone(n)
        try:
            motion = Run(one, t0, t1, x0, rtol, samples=times).by_name(method)
        except MotionError as error:
            motion = error.reached
            refused[n] = error
        errors[n], calls = motion.error, calls + motion.cost.calls
        used = used or motion.method
        if motion.t_end == t1:
            found[:, n, :] = [motion.states[name] for name in model.states]
    states = MappingProxyType(dict(zip(model.states, found, strict=True)))
    cost = Cost(perf_counter() - begun, 0.0, calls)
    motions = Motions(model, times, states, used, rtol, errors, cost)
    if refused:
        n, why = next(iter(refused.items()))
        raise AccuracyError(
            f"{len(refused)} of {count} motions are not as accurate as asked for, first number "
            f"{n}: {str(why).split('. The motion')[0]}. .reached of this exception holds all "
            f"{count} with their errors, nan where a motion did not come to its end",
            motions,
        )
    return motions


def _by_series(system, method, count):
    """True if batches of heyoka are asked for, or are worth their compilation."""
    if system.traced.hazards:
        return False
    enough = method == "auto" and count >= MIN_HEYOKA_BATCH
    return method == "taylor" or (enough and not METHODS["taylor"].unusable_because(system))


def _taylor(system, starts, parameters, t0, times, rtol):
    """The states (states, motions, times), the estimated errors, inf where heyoka stopped, and the
    number of calls.

    Motions are compared with those of higher order, but for those that begin and end close to one
    that was, as :class:`~newton_euler.motion.control.verified.Verified` has it for one motion after
    the other.
    """
    import numpy as np

    if np.any(np.diff(times) <= 0) or times[0] < t0:
        raise ModelError(f"the samples of many motions must increase from t = {t0:g}")
    method, count = METHODS["taylor"], starts.shape[1]
    tolerance = level_of(rtol / method.tolerance_ratio)
    other = level_of(method.other(tolerance))
    constants = system.traced.folded[1].on(np)(
        *(parameters.get(n, v) for n, v in zip(system.free, system.p, strict=True))
    )
    p = np.array([np.broadcast_to(x, count) for x in constants], dtype=float).reshape(-1, count)
    found, calls = _batches(system, tolerance, starts, p, t0, times)
    ends, errors = found[:, :, -1], np.full(count, np.inf)
    if knots(system, t0, float(times[-1])):
        return found, errors, calls  # batches know no stops on the way

    shift = 1 + ROUND_OFF_OF_RATES / SERIES_SAFETY * (-1.0) ** np.arange(len(starts))
    beside = starts * shift[:, None]

    def compare(members):
        compared, more = _batches(system, other, beside[:, members], p[:, members], t0, times[-1:])
        apart = abs(ends[:, members] - compared[:, :, -1])
        apart = (apart / sizes[:, vouching[members]]).max(axis=0)
        ratio = tolerance / other
        errors[members] = [predicted(d, ratio, tolerance) for d in apart.tolist()]
        return more

    chosen, vouching = _representatives(np.concatenate([starts, p]), ends)
    # of motions that are close to each other one shows how large a state is that is zero at the
    # end of another
    sizes = np.zeros_like(starts)
    np.maximum.at(sizes.T, vouching, np.maximum(abs(starts), abs(ends)).T)
    sizes[~(sizes > 0)] = 1.0
    calls += compare(chosen)
    others = SPARE * errors[vouching]
    rest = np.setdiff1d(np.arange(count), chosen)
    covered = rest[others[rest] <= rtol]
    errors[covered] = rtol  # no more is known
    rest = np.setdiff1d(rest, covered)
    if len(rest):
        calls += compare(rest)
    return found, np.array([told(error, rtol) for error in errors.tolist()]), calls


def _representatives(begins, ends):
    """The numbers of motions to which every other one is close, and for each motion the number of
    the one that it is close to.
    """
    import numpy as np

    count = begins.shape[1]
    vouching, waiting, chosen = np.arange(count), np.arange(count), []
    states = len(ends)
    # A state by its size at either end, or, as it may be zero at both, by its largest in all
    # motions times how large this one is beside them, in the state in which it is the smallest.
    sizes = abs(begins)
    seen = np.maximum(sizes[:states], abs(ends))
    largest = seen.max(axis=1, initial=0.0, where=np.isfinite(seen), keepdims=True)
    parts = np.where(begins[:states] != 0, seen / np.where(largest > 0, largest, 1.0), 1.0)
    sizes[:states] = np.maximum(seen, largest * parts.min(axis=0))
    while len(waiting):
        # a cover that is no smaller than the whole is not worth its search
        if len(chosen) > count // 4:
            return np.arange(count), np.arange(count)
        # those close to each other stand beside each other in a sweep
        some = waiting[:WINDOW]
        size = sizes[:, some]
        size = np.maximum(size, size[:, :1])
        here, there = begins[:, some], ends[:, some]
        close = (abs(here - here[:, :1]) <= NEAR_START * size).all(axis=0)
        close &= (abs(there - there[:, :1]) <= NEAR_END * size[:states]).all(axis=0)
        close[0] = True  # also where its end is not finite
        vouching[some[close]] = some[0]
        chosen.append(some[0])
        waiting = np.concatenate([some[~close], waiting[WINDOW:]])
    return np.array(chosen), vouching


def _batches(system, tolerance, starts, p, t0, times):
    """The states (states, motions, times), nan where heyoka stopped on the way, and the number of
    calls, by batches as wide as the processor's registers; the last is filled up with copies.
    """
    import heyoka
    import numpy as np

    width, count = heyoka.recommended_simd_size(), starts.shape[1]
    before = int(times[0] != t0)  # a grid of heyoka begins at the start
    grid = np.repeat(np.concatenate(([t0] * before, times))[:, None], width, axis=1)
    out, steps = np.full((len(starts), count, len(times)), np.nan), 0
    with integrator(system, tolerance, batch=width) as ta:
        p = p[: len(ta.pars)]
        for first in range(0, count, width):
            chosen = np.minimum(np.arange(first, first + width), count - 1)
            ta.set_time(t0)
            ta.state[:] = starts[:, chosen]
            if len(p):
                ta.pars[:] = p[:, chosen]
            kept = out[:, first : first + width]
            real = kept.shape[1]  # motions of this batch that are no copies
            if len(grid) == 2 or len(times) == 1:  # only the ends: no dense output
                ta.propagate_until(times[-1], max_steps=MAX_PREPARED_STEPS)
                kept[:, :, 0] = starts[:, first : first + width]
                kept[:, :, -1] = ta.state[:, :real]
                if min(ta.time) < times[-1]:
                    kept[:, ta.time[:real] < times[-1], -1] = np.nan
            else:
                rows = ta.propagate_grid(grid, max_steps=MAX_PREPARED_STEPS)[-1][before:]
                kept[:, :, : len(rows)] = np.moveaxis(rows, 0, 2)[:, :real]
            steps += sum(r[3] for r in ta.propagate_res)
    return out, steps * ta.order
