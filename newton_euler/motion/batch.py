"""Many motions of one model at once: arrays of starts, of parameters, or of both, of one length."""

from dataclasses import dataclass
from time import perf_counter
from types import MappingProxyType, SimpleNamespace

from .knots import knots
from .methods.exact import within
from .methods.table import METHODS
from .methods.taylor import MAX_PREPARED_STEPS, integrator, level_of
from .model import ModelError
from .prepared import PreparedModel, prepared_model
from .run import ROUND_OFF_OF_RATES, SERIES_SAFETY, TOLD_SAFETY, Run, predicted, usable
from .sizes import ROUND_OFF, TIME_SAFETY, time_round_off
from .solution import AccuracyError, Cost, MotionError
from .verified import NEAR_END, NEAR_START, SPARE

BLOCK = 64  # neighbours in a sweep of which the one in the middle may vouch for the others
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
    begun = perf_counter()
    many = _many(model, state)
    if isinstance(samples, int):
        times = np.linspace(t0, t1, samples)
    else:
        times = np.array((t0, t1) if samples is None else samples, dtype=float)
    count, used, calls = many.starts.shape[1], METHODS.get(method), 0
    system, exact = PreparedModel(model), METHODS["exact"]
    if method in ("auto", "exact") and not exact.unusable_because(system, t0):
        used, calls = exact, len(times)
        found, errors = _exact(many, t0, t1, times, rtol)
    elif _by_series(system, method, count):
        used = usable("taylor", system)
        found, errors, calls = _taylor(system, many.starts, many.parameters, t0, times, rtol)
    else:
        found, errors = _unknown(many.starts, times)
    # what is not as accurate as asked, one by one, with all care
    refused = {}
    for n in np.flatnonzero(~(errors <= rtol)).tolist():
        one, x0 = many.alone(n)
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


@dataclass(frozen=True, eq=False)
class _Many:
    """A model with its starts (states, motions) and those of its parameters that are arrays."""

    model: object
    starts: object
    parameters: dict

    def alone(self, n):
        """The model of the motion of this number, and its start."""
        values = {k: float(x[n]) for k, x in self.parameters.items()}
        changed = self.model.changed(**values) if values else self.model
        return prepared_model(changed), tuple(self.starts[:, n].tolist())


def _many(model, state):
    """The :class:`_Many` of a model and a start that fit together, or :class:`ModelError`."""
    import numpy as np

    size = len(state)
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
    if not all(np.isfinite(a).all() for a in (starts, *arrays[size:])):
        raise ModelError(f"starts and parameters of {model.name!r} must be finite numbers")
    return _Many(model, starts, dict(zip(values, arrays[size:], strict=True)))


def _exact(many, t0, t1, times, rtol):
    """The states (states, motions, times) by the exact solution, and the errors: ``rtol`` is their
    bound where the solution is as accurate, inf where it is not known to be.
    """
    import numpy as np

    model, starts, parameters = many.model, many.starts, many.parameters
    found, errors = _unknown(starts, times)
    columns = model.changed(**{n: x[:, None] for n, x in parameters.items()})
    rows = PreparedModel(columns).function(model.exact)(times - t0, *starts[:, :, None])
    for row, values in zip(found, rows, strict=True):
        row[:] = values
    ends = found[:, :, -1]
    chosen, group = _representatives(np.array([*starts, *parameters.values()]), ends)
    for place, n in enumerate(chosen.tolist()):
        one, x0 = many.alone(n)
        # those close to it are about as accurate
        if within(one, t1 - t0, x0, tuple(ends[:, n].tolist()), rtol / SPARE):
            errors[group == place] = rtol
    return found, errors


def _unknown(starts, times):
    """The states (states, motions, times), nan, and the errors, inf, before anything is known."""
    import numpy as np

    return np.full((*starts.shape, len(times)), np.nan), np.full(starts.shape[1], np.inf)


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
    that was, as :class:`~newton_euler.motion.verified.Verified` has it for one motion after
    the other.
    """
    import numpy as np

    if np.any(np.diff(times) <= 0):
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
        apart = (apart / sizes[:, group[members]]).max(axis=0)
        ratio = tolerance / other
        errors[members] = [predicted(d, ratio, tolerance) for d in apart.tolist()]
        ran = t0, float(times[-1]), ends[:, members], p[:, members]
        errors[members] += _clock_errors(system, *ran, sizes[:, group[members]], rtol / 100)
        return more

    chosen, group = _representatives(np.concatenate([starts, p]), ends)
    # of motions that are close to each other one shows how large a state is that is zero at the
    # end of another
    members = np.argsort(group)
    firsts = np.searchsorted(group, np.arange(len(chosen)), sorter=members)
    sizes = np.maximum(abs(starts), abs(ends))[:, members]
    sizes = np.maximum.reduceat(sizes, firsts, axis=1)
    sizes[~(sizes > 0)] = 1.0
    calls += compare(chosen)
    others = SPARE * errors[chosen][group]
    alone = np.ones(count, dtype=bool)
    alone[chosen] = False
    covered = alone & (others <= rtol)
    errors[covered] = others[covered]
    rest = np.flatnonzero(alone & ~covered)
    if len(rest):
        calls += compare(rest)
    told = np.maximum(errors, np.minimum(rtol, TOLD_SAFETY * errors))  # as that of one motion
    return found, told, calls


def _clock_errors(system, t0, t1, ends, p, sizes, enough):
    """The error of each motion that :func:`~newton_euler.motion.sizes.time_round_off`
    tells, or a bound of it that is below ``enough``.
    """
    import numpy as np

    count = ends.shape[1]
    if system.autonomous:
        return np.zeros(count)
    rates, span = system.traced.folded[0], t1 - t0 or 1.0
    later = t1 + 1e-6 * span
    with np.errstate(all="ignore"):
        beside, here = (
            np.array([np.broadcast_to(row, count) for row in rates.on(np)(t, *ends, *p)])
            for t in (later, t1)
        )
        # as if no state changed faster than once in the whole time
        slope = abs((beside - here) / (later - t1) * t1) * span
        errors = TIME_SAFETY * ROUND_OFF * (slope / sizes).max(axis=0)
    for n in np.flatnonzero(~(errors <= enough)).tolist():
        values = p[:, n].tolist()
        one = SimpleNamespace(
            autonomous=False,
            traced=system.traced,
            rates=lambda t, x, p=values: rates.on_floats(t, *x, *p),
        )
        errors[n] = time_round_off(one, t1, tuple(ends[:, n].tolist()), sizes[:, n].tolist(), span)
    return errors


def _representatives(begins, ends):
    """The numbers of motions to one of which every other one is close, and for each motion the
    place of that one among them.

    Sorted, those close to each other stand beside each other: a motion that is not close to the
    one in the middle of its block waits for smaller blocks.
    """
    import numpy as np

    count, states = begins.shape[1], len(ends)
    vouching, waiting = np.arange(count), np.lexsort(begins)
    # A state by its size at either end, or, as it may be zero at both, by its largest in all
    # motions times how large this one is beside them, in the state in which it is the smallest.
    sizes = abs(begins)
    seen = np.maximum(sizes[:states], abs(ends))
    largest = seen.max(axis=1, initial=0.0, where=np.isfinite(seen), keepdims=True)
    parts = np.where(begins[:states] != 0, seen / np.where(largest > 0, largest, 1.0), 1.0)
    sizes[:states] = np.maximum(seen, largest * parts.min(axis=0))
    both = np.concatenate([begins, ends])
    both[~np.isfinite(both)] = np.nan  # not close to anything
    allowed = np.concatenate([NEAR_START * sizes, NEAR_END * sizes[:states]])
    block = BLOCK
    while block > 1:
        first = np.arange(0, len(waiting), block)
        middles = waiting[np.minimum(first + block // 2, len(waiting) - 1)]
        middle = middles.repeat(block)[: len(waiting)]
        limit = np.maximum(allowed[:, waiting], allowed[:, middle])
        close = (abs(both[:, waiting] - both[:, middle]) <= limit).all(axis=0)
        vouching[waiting[close]] = middle[close]
        waiting = waiting[~close]
        block //= 2
    return np.unique(vouching, return_inverse=True)


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
        filled = np.minimum(np.arange(count + -count % width), count - 1)
        filled_starts, p = starts[:, filled], p[: len(ta.pars), filled]
        state, pars = ta.state, ta.pars
        for first in range(0, count, width):
            ta.set_time(t0)
            state[:] = filled_starts[:, first : first + width]
            pars[:] = p[:, first : first + width]
            kept = out[:, first : first + width]
            real = kept.shape[1]  # motions of this batch that are no copies
            if len(grid) == 2 or len(times) == 1:  # only the ends: no dense output
                ta.propagate_until(times[-1], max_steps=MAX_PREPARED_STEPS)
                kept[:, :, 0] = starts[:, first : first + width]
                kept[:, :, -1] = state[:, :real]
                if (reached := ta.time).min() < times[-1]:
                    kept[:, reached[:real] < times[-1], -1] = np.nan
            else:
                rows = ta.propagate_grid(grid, max_steps=MAX_PREPARED_STEPS)[-1][before:]
                kept[:, :, : len(rows)] = np.moveaxis(rows, 0, 2)[:, :real]
            steps += sum([r[3] for r in ta.propagate_res])
    return out, steps * ta.order
