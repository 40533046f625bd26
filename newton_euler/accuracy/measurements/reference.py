"""The final state of a motion to 30 digits, against which the errors of all methods are taken.

By heyoka in multiple precision; without it, and to check it, in mpmath's numbers by extrapolation
(W. B. Gragg 1965): the error of the midpoint rule has even powers of the step only, and each
further run, with 2, 4, 6, … steps, removes one. No measured method works this way.
"""

import importlib
from collections.abc import Sequence

from ...algebra.late import mpmath as mp
from ...algebra.scalars import Scalar
from ...motion.arguments import start_state
from ...motion.methods.taylor import installed
from ...motion.model import Model, ModelError
from ...motion.prepared import PreparedModel

RUNS = 14  # runs of the midpoint rule over one step: order 28
GUARD = 10  # digits beyond those asked for
BITS = 140  # precision of heyoka's numbers, 42 digits


def reference_solution(model: Model, t: Scalar, start: Sequence[Scalar]) -> tuple:
    """The states at ``t`` after ``start`` at t = 0, mpf with about 30 digits of the largest size of
    each; parameters and start are taken as exact.

    >>> from newton_euler.scenes.planar.pendulum import physical_pendulum
    >>> theta, omega = reference_solution(physical_pendulum(2.0, 0.5, 0.5, 10.0), 1.0, (1.0, 0.0))
    >>> round(float(theta), 15), round(float(omega), 15)
    (-0.985198951317957, -0.497895914005568)
    """
    return (by_heyoka if installed() else by_extrapolation)(model, t, start)


def by_heyoka(model: Model, t: Scalar, start: Sequence[Scalar]) -> tuple[Scalar, ...]:
    """The same states in heyoka's numbers of 42 digits. Heyoka divides by a number through its
    inverse, a float: dividing by 60 leaves 17 digits, by 64 all.
    """
    hy, system = importlib.import_module("heyoka"), PreparedModel(model)
    variables, one = [hy.expression(n) for n in model.states], hy.real(1, BITS)
    outputs = system.traced.rhs(hy.time, *variables, *(hy.par[i] for i in range(len(system.free))))
    # + 0: a rate may be a plain number, which heyoka does not take
    equations = [(v, o + hy.expression(0.0)) for v, o in zip(variables, outputs, strict=True)]
    begin = [one * x for x in start_state(model, start)]
    ta = hy.taylor_adaptive(equations, begin, fp_type=hy.real, prec=BITS, compact_mode=True)
    for i in range(len(ta.pars)):
        ta.pars[i] = one * system.p[i]
    ta.propagate_until(one * t)
    with mp.workprec(BITS):
        return tuple(mp.mpf(str(x)) for x in ta.state)


def by_extrapolation(
    model: Model, t: Scalar, start: Sequence[Scalar], digits: int = 30
) -> tuple[Scalar, ...]:
    """The same states by extrapolation; ten swings of a pendulum take some seconds."""
    with mp.workdps(digits + GUARD):
        system = PreparedModel(model)
        p = [mp.mpf(x) for x in system.p]

        def rates(t, x):
            return system.traced.rhs(t, *x, *p)

        now, end = mp.mpf(0), mp.mpf(t)
        x = [mp.mpf(v) for v in start_state(model, start)]
        goal, h = mp.mpf(10) ** -(digits + 2), end / 64
        sizes = [abs(v) for v in x]
        while now < end:
            h = min(h, end - now)
            new, error = _step(rates, now, x, h, sizes)
            # the error of a step is of order 2 RUNS - 1 in h; 1e-20: it may be zero
            factor = float(goal / (error + goal * mp.mpf("1e-20"))) ** (1 / (2 * RUNS - 1))
            if error <= goal:
                now, x = now + h, new
                sizes = [max(a, abs(b)) for a, b in zip(sizes, x, strict=True)]
            elif h < end * mp.mpf(10) ** -8:
                raise ModelError(f"{model.name!r} cannot be integrated beyond {float(now):.6g}")
            # usual limits of a step control: Hairer, Norsett and Wanner, II.4
            h = h * mp.mpf(min(4.0, max(0.2, 0.9 * factor)))
        return tuple(+v for v in x)


def _step(rates, t, x, h, sizes):
    """The state after a step h, and its error relative to the largest state."""
    first, table = rates(t, x), []
    for run in range(1, RUNS + 1):
        row = [_midpoint(rates, t, x, first, h, 2 * run)]
        for back, column in enumerate(table[-1] if table else [], start=1):
            # Aitken and Neville for even powers of the step; + 0 x: in the digits of the states
            weight = 1 / ((row[0][0] * 0 + run) ** 2 / (run - back) ** 2 - 1)
            row.append([a + (a - b) * weight for a, b in zip(row[-1], column, strict=True)])
        table.append(row)
    *_, before, best = table[-1]
    size = max(*map(abs, best), *sizes)
    return best, max(abs(a - b) for a, b in zip(best, before, strict=True)) / size


def _midpoint(rates, t, x, first, h, n):
    """The state after n steps h/n of Gragg's midpoint rule."""
    d = h / n
    before, now = x, [a + d * k for a, k in zip(x, first, strict=True)]
    for i in range(1, n):
        k = rates(t + i * d, now)
        before, now = now, [a + 2 * d * b for a, b in zip(before, k, strict=True)]
    return now
