"""Many motions of one model at once: arrays of starts, of parameters, or of both, of one length.
The exact solution, or batches of heyoka, give all of them in one sweep, of which a few are checked
and vouch for those close to them; any other motion is a :class:`.run.Run` of its own.
"""

from dataclasses import dataclass, replace
from time import perf_counter
from types import MappingProxyType, SimpleNamespace
from typing import Any, NamedTuple

from ..algebra.late import np
from ..algebra.names import Guided
from ..algebra.scalars import Scalar
from .error_estimates import REPORTED_SAFETY, error_by_difference, relative_shift
from .knots import knots
from .methods.base import rows_of
from .methods.table import METHODS, Method
from .methods.taylor import batches
from .model import Model, ModelError, expect, real_numbers
from .prepared import PreparedModel, prepared_model
from .run import Run, known_accurate, usable
from .sizes import NATURAL_PART, ROUND_OFF, TIME_SAFETY, time_round_off
from .solution import AccuracyError, Cost, MotionError
from .verified import NEAR_END, NEAR_START, SPARE

BLOCK = 64  # neighbours in a sweep; the one in the middle may vouch for the others
INSIDE = 31  # instants on the way at which the sizes of the states are sampled
SLOPE_STEP = 1e-6  # part of its size by which a state is moved for a slope
MIN_HEYOKA_BATCH = 64  # motions; fewer are not worth the compilation of a batch integrator


@dataclass(frozen=True, eq=False)
class Motions(Guided):
    """Many motions: ``times`` (samples), ``states`` by name as arrays (motions, times), ``method``,
    the estimated ``error`` of each motion, of exact solutions a bound, ``cost``.
    """

    model: Model
    times: Any
    states: MappingProxyType
    method: Method
    rtol: float
    error: Any
    cost: Cost

    def __len__(self) -> int:
        return len(next(iter(self.states.values())))

    @property
    def t_end(self) -> float:
        """The time of the last sample, at which the motions end."""
        return float(self.times[-1])

    @property
    def end(self) -> dict:
        """The last states, arrays (motions,) by name."""
        return self.at(self.t_end)

    def at(self, t: Scalar) -> dict:
        """The states at one of the ``times``, arrays (motions,) by name; between these
        :class:`ModelError`: give ``integrate`` the times that are needed as ``samples``.
        """
        what = "many motions are known at their times alone, see samples= of integrate"
        place = real_numbers(t, what)
        found: Any = [] if place.ndim else (self.times == place).nonzero()[0]
        expect(len(found), what, t)
        return {name: x[:, found[-1]] for name, x in self.states.items()}


class Sweep(NamedTuple):
    """The ``states`` (states, motions, times) of many motions, the ``errors``, inf where a motion
    is not known to be accurate, and the number of ``calls``.
    """

    states: Any
    errors: Any
    calls: int


def integrate_many(run: Run, name: str) -> Motions:
    """The :class:`Motions` of a run with arrays, by the method of this name or "auto"."""
    if run.events:
        raise ModelError("events need one motion at a time; integrate each start by itself")
    begun, many = perf_counter(), _Many.of(run)
    sweep, used = _sweep(many, run, name)
    states, errors, calls = sweep
    alike, refused = replace(run, samples=many.times, progress=None), {}
    for n in np.flatnonzero(~(errors <= run.rtol)).tolist():
        one, x0 = many.alone(n)
        try:
            motion = replace(alike, system=one, state=x0).by_name(name)
        except MotionError as error:
            motion = error.reached
            refused[n] = error
        errors[n], calls = motion.error, calls + motion.cost.calls
        used = used or motion.method
        if motion.t_end == run.t1:
            states[:, n, :] = [motion.states[state] for state in many.model.states]
    by_name = MappingProxyType(dict(zip(many.model.states, states, strict=True)))
    cost = Cost(perf_counter() - begun, run.preparing, calls)
    motions = Motions(many.model, many.times, by_name, used, run.rtol, errors, cost)
    if refused:
        n, why = next(iter(refused.items()))
        raise AccuracyError(
            f"{len(refused)} of {len(motions)} motions are not as accurate as requested, the first "
            f"is number {n}: {str(why).split('. The motion')[0]}. .reached of this exception holds "
            "all motions with their errors, nan where a motion did not come to its end",
            motions,
        )
    return motions


@dataclass(frozen=True, eq=False)
class _Many:
    """A model with its starts (states, motions), its array parameters, and the sample times."""

    model: Model
    starts: Any
    parameters: dict
    times: Any

    @classmethod
    def of(cls, run):
        """The motions of a run; :class:`ModelError` where the arrays do not fit together."""
        model, state, samples = run.system.model, run.state, run.samples
        values = {
            n: real_numbers(x, f"the parameter {n} of {model.name!r} is one real number per motion")
            for n, x in model.parameters.items()
            if getattr(x, "shape", ())
        }
        try:
            arrays = np.broadcast_arrays(*state, *values.values())
        except ValueError as error:
            given = [*zip(model.states, state, strict=True), *values.items()]
            shapes = ", ".join(f"{n} {np.shape(x)}" for n, x in given)
            what = f"these arrays have lengths that do not fit together: {shapes}"
            raise ModelError(what) from error
        if arrays[0].ndim != 1:
            raise ModelError(f"many motions need arrays of one dimension, got {arrays[0].shape}")
        if not arrays[0].size:
            raise ModelError(f"the arrays of {model.name!r} have no entries: there is no motion")
        starts = np.array(arrays[: len(state)], dtype=float)
        if not all(np.isfinite(a).all() for a in (starts, *arrays[len(state) :])):
            raise ModelError(f"starts and parameters of {model.name!r} must be finite numbers")
        if isinstance(samples, int):
            times = np.linspace(run.t0, run.t1, samples)
        else:
            times = np.array((run.t0, run.t1) if samples is None else samples, dtype=float)
        parameters = dict(zip(values, arrays[len(state) :], strict=True))
        return cls(model, starts, parameters, times)

    def alone(self, n):
        """The prepared model and the start of motion ``n``."""
        values = {k: float(x[n]) for k, x in self.parameters.items()}
        changed = self.model.changed(**values) if values else self.model
        return prepared_model(changed), tuple(self.starts[:, n].tolist())


def _sweep(many, run, name):
    """The :class:`Sweep` and its method; or one that knows nothing, and the method asked for."""
    exact, count, system = METHODS["exact"], many.starts.shape[1], run.system
    if not run.step:
        if name in ("auto", "exact") and not exact.unusable_because(system, run.t0):
            return _exact(many, run), exact
        if _by_series(system, name, count):
            return _taylor(many, run), usable("taylor", system)
    return _unknown(many), METHODS.get(name)


def _unknown(many):
    """The :class:`Sweep` before anything is known: states nan, errors inf."""
    count = many.starts.shape[1]
    return Sweep(np.full((*many.starts.shape, len(many.times)), np.nan), np.full(count, np.inf), 0)


def _exact(many, run):
    """The :class:`Sweep` by the exact solution; the errors are bounds."""
    model, starts, parameters = many.model, many.starts, many.parameters
    states, errors, _ = _unknown(many)
    columns = model.changed(**{n: x[:, None] for n, x in parameters.items()})
    rows = PreparedModel(columns).function(model.exact)(many.times - run.t0, *starts[:, :, None])
    for row, values in zip(states, rows, strict=True):
        row[:] = values
    ends = states[:, :, -1]
    chosen, group = _representatives(np.array([*starts, *parameters.values()]), ends)
    for place, n in enumerate(chosen.tolist()):
        one, x0 = many.alone(n)
        end = tuple(ends[:, n].tolist())
        # motions close to it are about as accurate
        if known_accurate(one, METHODS["exact"], run.rtol / SPARE, run.t0, run.t1, x0, end):
            errors[group == place] = run.rtol
    return Sweep(states, errors, len(many.times))


def _by_series(system, name, count):
    """True if batches of heyoka are asked for, or are worth their compilation."""
    if system.traced.hazards:
        return False
    enough = name == "auto" and count >= MIN_HEYOKA_BATCH
    return name == "taylor" or (enough and not METHODS["taylor"].unusable_because(system))


def _taylor(many, run):
    """The :class:`Sweep` by batches of heyoka: motions are compared with those of higher order, but
    for those close to one that was, as by :class:`.verified.Verified` for single runs.
    """
    system, starts, times, rtol = run.system, many.starts, many.times, run.rtol
    if np.any(np.diff(times) <= 0):
        raise ModelError(f"the samples of many motions must increase from t = {run.t0:g}")
    method, count = METHODS["taylor"], starts.shape[1]
    tolerance = method.rounded(rtol / method.tolerance_ratio)
    other = method.rounded(method.other(tolerance))
    values = [many.parameters.get(n, v) for n, v in zip(system.free, system.p, strict=True)]
    p = rows_of(system.traced.folded[1].on(np)(*values), count)  # constants by motions
    states, calls = batches(system, tolerance, starts, p, run.t0, times)
    ends, errors = states[:, :, -1], np.full(count, np.inf)
    span, ratio = (run.t0, float(times[-1])), tolerance / other
    if knots(system, *span):
        return Sweep(states, errors, calls)  # batches do not stop on the way
    chosen, group = _representatives(np.concatenate([starts, p]), ends)
    sizes = np.maximum(abs(starts), abs(ends))
    shift = 1 + relative_shift(ratio) * (-1.0) ** np.arange(len(starts))
    shifted = starts * shift[:, None]

    def compare(n, instants=1):
        inside = run.t0 + (times[-1] - run.t0) * np.arange(1, instants + 1) / instants
        compared, more = batches(system, other, shifted[:, n], p[:, n], run.t0, inside)
        known = sizes[:, n] = np.fmax(sizes[:, n], abs(compared).max(axis=2))
        scales = np.where(known > 0, known, 1.0)
        apart = (abs(ends[:, n] - compared[:, :, -1]) / scales).max(axis=0)
        errors[n] = [error_by_difference(d, ratio, tolerance) for d in apart.tolist()]
        errors[n] += _clock_errors(system, *span, ends[:, n], p[:, n], scales, rtol / 100)
        for k in n.tolist() if system.traced.narrow else ():  # what the series does not see
            one, x0 = many.alone(k)
            alone = replace(run, system=one, state=x0, samples=None, progress=None)
            errors[k] += alone.trajectory(method, tolerance).unseen(float(errors[k]))
        return more

    calls += compare(chosen)
    alone, like = np.ones(count, dtype=bool), chosen[group]
    alone[chosen] = False
    with np.errstate(all="ignore"):  # a state may be zero
        vouched = SPARE * errors[like] * np.fmax(sizes[:, like] / sizes, 1.0).max(axis=0)
    covered = alone & (vouched <= rtol)
    errors[covered] = vouched[covered]
    rest = np.flatnonzero(alone & ~covered)
    if len(rest):
        calls += compare(rest)
    # a state may be zero at the ends of a motion
    unsure = np.flatnonzero(~(errors <= rtol) & np.isfinite(ends).all(axis=0))
    if len(unsure):
        calls += compare(unsure, INSIDE)
    # a state that is small by cancellation may be all error, of which two runs may be alike
    doubtful = _cancelling(np.flatnonzero(errors <= rtol), system, span, (starts, ends), p, sizes)
    if len(doubtful):
        calls += compare(doubtful, INSIDE)
        errors[_cancelling(doubtful, system, span, (starts, ends), p, sizes)] = np.inf
    reported = np.maximum(errors, np.minimum(rtol, REPORTED_SAFETY * errors))
    return Sweep(states, reported, calls)


def _cancelling(motions, system, times, points, p, sizes):
    """Those of these ``motions`` of which a state is small by cancellation at both ends."""
    rates, found = system.traced.folded[0].on(np), np.ones((len(sizes), len(motions)), dtype=bool)
    with np.errstate(all="ignore"):
        for t, x in zip(times, points, strict=True):
            x, size, numbers = x[:, motions], sizes[:, motions], p[:, motions]
            scale = np.where(size > 0, size, 1.0)
            count = len(motions)
            here, slopes = rows_of(rates(t, *x, *numbers), count), []
            for k, step in enumerate(SLOPE_STEP * scale):
                moved = x.copy()
                moved[k] += step
                slopes.append(abs(rows_of(rates(t, *moved, *numbers), count) - here) / step)
            # arrays (rates, states, motions)
            matrix, vector = np.array(slopes).swapaxes(0, 1), np.ones_like(x)
            terms, matrix = (matrix * size).sum(axis=1), matrix * scale / scale[:, None]
            for _ in range(2):  # as in the estimate of the spectral radius there
                twice = (matrix * (matrix * vector).sum(axis=1)).sum(axis=1)
                square = twice.max(axis=0)
                vector = twice / square + 1e-12
            fastest = np.fmax(np.sqrt(square), 1 / ((times[1] - times[0]) or 1.0))
            found &= (size > 0) & (size <= NATURAL_PART * terms / fastest)
            motions, found = motions[found.any(axis=0)], found[:, found.any(axis=0)]
            if not len(motions):
                break
    return motions


def _clock_errors(system, t0, t1, ends, p, sizes, enough):
    """The error of each motion by the clock, or a bound of it that is below ``enough``."""
    count = ends.shape[1]
    if system.autonomous:
        return np.zeros(count)
    rates, span = system.traced.folded[0], t1 - t0 or 1.0
    later = t1 + 1e-6 * span
    with np.errstate(all="ignore"):
        beside, here = (rows_of(rates.on(np)(t, *ends, *p), count) for t in (later, t1))
        # a bound if no state changes faster than once in the whole time
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
    """The numbers of motions to one of which every other is close, and for each motion its place
    among them. In sorted order neighbours are close: a motion that is not close to the one in the
    middle of its block waits for smaller blocks.
    """
    count, states = begins.shape[1], len(ends)
    vouching, waiting = np.arange(count), np.lexsort(begins)
    # The size of a state is that at either end, or, as it may be zero at both, its largest in all
    # motions times the least ratio, over the states, of the size in this motion to the largest.
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
