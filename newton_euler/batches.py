"""Many motions of one model at once: other starts, other parameters, or both, as arrays of one length."""

from dataclasses import dataclass, replace
from time import perf_counter
from types import MappingProxyType

from .methods import METHODS
from .models import ModelError
from .records import Cost
from .run import Run
from .systems import PreparedModel, prepared
from .taylor import ABSOLUTE_SCALE, installed, integrator

MIN_HEYOKA_BATCH = 64  # motions, from which heyoka's batches are worth their compilation


@dataclass(frozen=True, eq=False)
class Motions:
    """Many motions: ``times`` (samples), ``states`` by name as arrays (motions, times), ``method``, ``error`` of each motion, ``cost``.

    The error is None for exact solutions and for batches of heyoka, whose tolerance is a hundredth of rtol.
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
    """What :func:`newton_euler.motion.integrate` does where the start or the parameters are arrays."""
    import numpy as np

    if events:
        raise ModelError("events are sought on one motion at a time; integrate each start by itself")
    begun = perf_counter()
    values = {n: x for n, x in model.parameters.items() if getattr(x, "shape", ())}
    try:
        arrays = np.broadcast_arrays(*state, *values.values())
    except ValueError as error:
        shapes = ", ".join(f"{n} {np.shape(x)}" for n, x in [*zip(model.states, state, strict=True), *values.items()])
        raise ModelError(f"the arrays of starts and parameters have lengths that do not fit together: {shapes}") from error
    if arrays[0].ndim != 1:
        raise ModelError(f"many motions are arrays of one dimension, got shape {arrays[0].shape}")
    starts, parameters = np.array(arrays[: len(state)], dtype=float), dict(zip(values, arrays[len(state) :], strict=True))
    if not all(np.isfinite(a).all() for a in (starts, *parameters.values())):
        raise ModelError(f"the starts and parameters of {model.name!r} must all be finite numbers")
    times = np.array([t0, t1]) if samples is None else np.linspace(t0, t1, samples) if isinstance(samples, int) else np.asarray(samples, dtype=float)
    system = PreparedModel(model)
    exact = model.exact is not None and method in ("auto", "exact") and (t0 == 0 or system.autonomous)
    if exact:
        found, error, taken, calls = _exact(system, starts, parameters, times - t0), None, METHODS["exact"], len(times)
    elif method == "taylor" or (method == "auto" and installed() and starts.shape[1] >= MIN_HEYOKA_BATCH):
        found, calls = _taylor(system, starts, parameters, t0, times, rtol)
        error, taken = None, METHODS["taylor"]
    else:
        found, error, taken, calls = _each(model, starts, parameters, (t0, t1), rtol, method, times)
    states = MappingProxyType(dict(zip(model.states, found, strict=True)))
    return Motions(model, times, states, taken, rtol, error, Cost(perf_counter() - begun, 0.0, calls))


def _exact(system, starts, parameters, times):
    import numpy as np

    model = replace(system.model, parameters={**system.model.parameters, **{n: x[:, None] for n, x in parameters.items()}})
    found = PreparedModel(model).function(model.exact)(times[None, :], *(x[:, None] for x in starts))
    return [np.broadcast_to(row, (starts.shape[1], len(times))) for row in found]


def _taylor(system, starts, parameters, t0, times, rtol):
    """In batches as wide as the processor's registers; the last one is filled up with copies."""
    import numpy as np

    if not installed():
        raise ModelError("method 'taylor' cannot be used: heyoka is not installed: pip install 'newton-euler[fast]' (Linux)")
    import heyoka

    width, count = heyoka.recommended_simd_size(), starts.shape[1]
    least = abs(starts).max(axis=0).min()  # of the smallest motion: see taylor._scale
    ta = integrator(system, rtol / METHODS["taylor"].tolerance_ratio * (least if 0 < least < ABSOLUTE_SCALE else 1.0), width)
    early = system.traced.folded[1]._on(np)
    p = np.array([np.broadcast_to(x, count) for x in early(*(parameters.get(n, v) for n, v in zip(system.free, system.p, strict=True)))], dtype=float)
    if np.any(np.diff(times) <= 0) or times[0] < t0:
        raise ModelError(f"the samples of many motions are times that grow, from t = {t0:g} on")
    begun = int(times[0] != t0)
    grid = np.repeat(np.concatenate(([t0] * begun, times))[:, None], width, axis=1)
    out, steps = np.empty((len(starts), count, len(times))), 0
    for first in range(0, count, width):
        chosen = np.minimum(np.arange(first, first + width), count - 1)
        ta.set_time(t0)
        ta.state[:] = starts[:, chosen]
        if len(ta.pars):
            ta.pars[:] = p[: len(ta.pars), chosen]
        kept = min(width, count - first)
        if len(grid) == 2:  # only the ends are asked for
            out[:, first : first + kept, 0] = starts[:, first : first + kept]
            ta.propagate_until(times[-1])
            out[:, first : first + kept, -1] = ta.state[:, :kept]
        else:
            out[:, first : first + kept] = np.moveaxis(ta.propagate_grid(grid)[-1][begun:], 0, 2)[:, :kept]
        steps += sum(r[3] for r in ta.propagate_res)
    return out, steps * ta.order


def _each(model, starts, parameters, span, rtol, method, times):
    import numpy as np

    motions = []
    for n, start in enumerate(starts.T.tolist()):
        one = replace(model, parameters={**model.parameters, **{name: float(x[n]) for name, x in parameters.items()}})
        motions.append(Run(prepared(one), *span, tuple(start), rtol, samples=times).by_name(method))
    found = [np.array([m.states[name] for m in motions]) for name in model.states]
    error = np.array([m.error for m in motions])
    return found, error, motions[0].method, sum(m.cost.calls for m in motions)
