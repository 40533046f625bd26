"""Many motions of one model at once: other starts, other parameters, or both, as arrays of one
length.
"""

from dataclasses import dataclass
from time import perf_counter
from types import MappingProxyType

from .methods.table import METHODS
from .methods.taylor import ABSOLUTE_SCALE, integrator
from .model import ModelError
from .prepared import PreparedModel, prepared
from .run import Run, usable
from .solution import Cost

MIN_HEYOKA_BATCH = 64  # motions, from which on heyoka's batches are worth their compilation


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
        raise ModelError(
            "events are sought on one motion at a time; integrate each start by itself"
        )
    begun = perf_counter()
    values = {n: x for n, x in model.parameters.items() if getattr(x, "shape", ())}
    try:
        arrays = np.broadcast_arrays(*state, *values.values())
    except ValueError as error:
        shapes = ", ".join(
            f"{n} {np.shape(x)}"
            for n, x in [*zip(model.states, state, strict=True), *values.items()]
        )
        raise ModelError(
            f"the arrays of starts and parameters have lengths that do not fit together: {shapes}"
        ) from error
    if arrays[0].ndim != 1:
        raise ModelError(f"many motions are arrays of one dimension, got shape {arrays[0].shape}")
    starts, parameters = (
        np.array(arrays[: len(state)], dtype=float),
        dict(zip(values, arrays[len(state) :], strict=True)),
    )
    if not all(np.isfinite(a).all() for a in (starts, *parameters.values())):
        raise ModelError(f"the starts and parameters of {model.name!r} must all be finite numbers")
    times = (
        np.linspace(t0, t1, samples)
        if isinstance(samples, int)
        else np.array((t0, t1) if samples is None else samples, dtype=float)
    )
    system, exact, taylor = PreparedModel(model), METHODS["exact"], METHODS["taylor"]
    if method in ("auto", "exact") and not exact.unusable_because(system, t0):
        used, error, calls, found = (
            exact,
            None,
            len(times),
            _exact(system, starts, parameters, times - t0),
        )
    elif method == "taylor" or (
        method == "auto"
        and starts.shape[1] >= MIN_HEYOKA_BATCH
        and not taylor.unusable_because(system)
    ):
        used, error = usable("taylor", system), None
        found, calls = _taylor(system, starts, parameters, t0, times, rtol)
    else:
        found, error, used, calls = _each(model, starts, parameters, (t0, t1), rtol, method, times)
    states = MappingProxyType(dict(zip(model.states, found, strict=True)))
    return Motions(
        model, times, states, used, rtol, error, Cost(perf_counter() - begun, 0.0, calls)
    )


def _exact(system, starts, parameters, times):
    import numpy as np

    model = system.model.changed(**{n: x[:, None] for n, x in parameters.items()})
    found = PreparedModel(model).function(model.exact)(
        times[None, :], *(x[:, None] for x in starts)
    )
    return [np.broadcast_to(row, (starts.shape[1], len(times))) for row in found]


def _taylor(system, starts, parameters, t0, times, rtol):
    """The states and calls, by batches as wide as the processor's registers; the last one is filled
    up with copies.
    """
    import heyoka
    import numpy as np

    if np.any(np.diff(times) <= 0) or times[0] < t0:
        raise ModelError(f"the samples of many motions are times that grow, from t = {t0:g} on")
    width, count = heyoka.recommended_simd_size(), starts.shape[1]
    smallest = abs(starts).max(axis=0).min()  # motion: see taylor._scale
    ta = integrator(
        system,
        rtol
        / METHODS["taylor"].tolerance_ratio
        * (smallest if 0 < smallest < ABSOLUTE_SCALE else 1.0),
        width,
    )
    constants = system.traced.folded[1].on(np)(
        *(parameters.get(n, v) for n, v in zip(system.free, system.p, strict=True))
    )
    p = np.array([np.broadcast_to(x, count) for x in constants], dtype=float)[: len(ta.pars)]
    before = int(times[0] != t0)
    grid = np.repeat(np.concatenate(([t0] * before, times))[:, None], width, axis=1)
    out, steps = np.empty((len(starts), count, len(times))), 0
    for first in range(0, count, width):
        chosen = np.minimum(np.arange(first, first + width), count - 1)
        ta.set_time(t0)
        ta.state[:] = starts[:, chosen]
        if len(p):
            ta.pars[:] = p[:, chosen]
        kept = out[:, first : first + width]
        if len(grid) == 2:  # only the ends are asked for
            ta.propagate_until(times[-1])
            kept[:, :, 0], kept[:, :, -1] = (
                starts[:, first : first + width],
                ta.state[:, : kept.shape[1]],
            )
        else:
            kept[:] = np.moveaxis(ta.propagate_grid(grid)[-1][before:], 0, 2)[:, : kept.shape[1]]
        steps += sum(r[3] for r in ta.propagate_res)
    return out, steps * ta.order


def _each(model, starts, parameters, span, rtol, method, times):
    import numpy as np

    motions = []
    for n, start in enumerate(starts.T.tolist()):
        system = prepared(model.changed(**{name: float(x[n]) for name, x in parameters.items()}))
        motions.append(Run(system, *span, tuple(start), rtol, samples=times).by_name(method))
    found = [np.array([m.states[name] for m in motions]) for name in model.states]
    return (
        found,
        np.array([m.error for m in motions]),
        motions[0].method,
        sum(m.cost.calls for m in motions),
    )
