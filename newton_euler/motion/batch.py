"""Many motions of one model at once: arrays of starts, of parameters, or of both, of one length."""

from dataclasses import dataclass
from time import perf_counter
from types import MappingProxyType

from .methods.table import METHODS
from .methods.taylor import ABSOLUTE_SCALE, integrator
from .model import ModelError
from .prepared import PreparedModel, prepared_model
from .run import Run, usable
from .solution import Cost

MIN_HEYOKA_BATCH = 64  # motions; fewer are not worth the compilation of a batch integrator


@dataclass(frozen=True, eq=False)
class Motions:
    """Many motions: ``times`` (samples), ``states`` by name as arrays (motions, times), ``method``,
    ``error`` of each motion, ``cost``.

    The error is None for exact solutions and for batches of heyoka, whose tolerance is far below
    rtol.
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
    system, exact, taylor = PreparedModel(model), METHODS["exact"], METHODS["taylor"]
    if method in ("auto", "exact") and not exact.unusable_because(system, t0):
        used, errors, calls = exact, None, len(times)
        columns = model.changed(**{n: x[:, None] for n, x in parameters.items()})
        rows = PreparedModel(columns).function(model.exact)(times - t0, *starts[:, :, None])
        found = [np.broadcast_to(row, (starts.shape[1], len(times))) for row in rows]
    elif method == "taylor" or (
        method == "auto"
        and starts.shape[1] >= MIN_HEYOKA_BATCH
        and not taylor.unusable_because(system)
    ):
        used, errors = usable("taylor", system), None
        found, calls = _taylor(system, starts, parameters, t0, times, rtol)
    else:
        motions = []
        for n, start in enumerate(starts.T.tolist()):
            one = prepared_model(model.changed(**{k: float(x[n]) for k, x in parameters.items()}))
            run = Run(one, t0, t1, tuple(start), rtol, samples=times)
            motions.append(run.by_name(method))
        used, errors = motions[0].method, np.array([m.error for m in motions])
        found = [np.array([m.states[name] for m in motions]) for name in model.states]
        calls = sum(m.cost.calls for m in motions)
    states = MappingProxyType(dict(zip(model.states, found, strict=True)))
    cost = Cost(perf_counter() - begun, 0.0, calls)
    return Motions(model, times, states, used, rtol, errors, cost)


def _taylor(system, starts, parameters, t0, times, rtol):
    """The states (states, motions, times) and the number of calls, by batches as wide as the
    processor's registers; the last batch is filled up with copies.
    """
    import heyoka
    import numpy as np

    if np.any(np.diff(times) <= 0) or times[0] < t0:
        raise ModelError(f"the samples of many motions must increase from t = {t0:g}")
    width, count = heyoka.recommended_simd_size(), starts.shape[1]
    tolerance = rtol / METHODS["taylor"].tolerance_ratio
    # of the motion with the smallest states: heyoka's tolerance is absolute there (taylor._scale)
    smallest = abs(starts).max(axis=0).min()
    if 0 < smallest < ABSOLUTE_SCALE:
        tolerance *= smallest
    ta = integrator(system, tolerance, width)
    constants = system.traced.folded[1].on(np)(
        *(parameters.get(n, v) for n, v in zip(system.free, system.p, strict=True))
    )
    p = np.array([np.broadcast_to(x, count) for x in constants], dtype=float)[: len(ta.pars)]
    before = int(times[0] != t0)  # a grid of heyoka begins at the start
    grid = np.repeat(np.concatenate(([t0] * before, times))[:, None], width, axis=1)
    out, steps = np.empty((len(starts), count, len(times))), 0
    for first in range(0, count, width):
        chosen = np.minimum(np.arange(first, first + width), count - 1)
        ta.set_time(t0)
        ta.state[:] = starts[:, chosen]
        if len(p):
            ta.pars[:] = p[:, chosen]
        kept = out[:, first : first + width]
        real = kept.shape[1]  # motions of this batch that are no copies
        if len(grid) == 2:  # only the ends are asked for: no dense output
            ta.propagate_until(times[-1])
            kept[:, :, 0] = starts[:, first : first + width]
            kept[:, :, -1] = ta.state[:, :real]
        else:
            kept[:] = np.moveaxis(ta.propagate_grid(grid)[-1][before:], 0, 2)[:, :real]
        steps += sum(r[3] for r in ta.propagate_res)
    return out, steps * ta.order
