"""Geometric integrators of fixed step: they preserve reversibility, phase-space volume, or angular
momentum. Whether a model has the form that they need is read from its traced rates.

Verlet's method and its compositions (H. Yoshida, Phys. Lett. A 150 (1990) 262) are for states in
two groups, as coordinates and velocities, such that no rate depends on its own group; they are
symplectic if the forces have a potential. The Lie-Poisson methods (R. I. McLachlan, Phys. Rev.
Lett. 71 (1993) 3043) are for Euler's equations of a free body: they rotate the angular momentum
about one principal axis after the other, so that its magnitude is preserved to round-off.
"""

from collections.abc import Callable
from functools import cached_property, lru_cache
from math import ceil, cos, inf, isclose, isfinite, sin, sqrt

from ...algebra.late import np
from ...algebra.places import GENERATED
from ...algebra.vectors import cross3, dot3
from .base import Demand, Floats, LengthError, StepError, Stepper, System

MAX_STEPS = 3_000_000
# w1, w2, w3 of Yoshida's solution A for order 6 (his table 1)
_W6 = (-1.17767998417887, 0.235573213359357, 0.784513610477560)
# w1 ... w7 of one of his solutions for order 8 (his table 2)
_W8 = (
    -1.61582374150097, -2.44699182370524, -0.00716989419708120, 2.44002732616735,
    0.157739928123617, 1.82020630970714, 1.04242620869991,
)  # fmt: skip


def _mirror(*weights):
    """The weights w_m ... w_1 w_0 w_1 ... w_m from w_1 ... w_m; their sum is 1."""
    return *weights[::-1], 1 - 2 * sum(weights), *weights


COMPOSITIONS = {2: (1.0,), 4: _mirror(1 / (2 - 2 ** (1 / 3))), 6: _mirror(*_W6), 8: _mirror(*_W8)}


# -- which models have the structure


def partition(system: System) -> tuple[tuple[int, ...], tuple[int, ...]] | None:
    """Two tuples of the indices of states such that no rate depends on its own group; or None."""
    states, needs = system.model.states, system.traced.rhs.dependencies
    if any("t" in need for need in needs):
        return None
    group: dict[int, int] = {}
    for first in range(len(states)):
        waiting = [(first, group.get(first, 0))]
        while waiting:
            i, side = waiting.pop()
            if i not in group:
                group[i] = side
                for j, n in enumerate(states):
                    if n in needs[i] or states[i] in needs[j]:
                        waiting.append((j, 1 - side))
            elif group[i] != side:
                return None
    return tuple(i for i in group if not group[i]), tuple(i for i in group if group[i])


def principal_moments(system: System) -> Floats | None:
    """The principal moments of inertia, up to a factor, of a free body, whose three rates are each
    a constant, which follows from the moments, times the two other states; None for other models.
    """
    states, needs = system.model.states, system.traced.rhs.dependencies
    if len(states) != 3 or any(states[i] in needs[i] or "t" in needs[i] for i in range(3)):
        return None
    try:
        a, b, c = system.rates(0.0, (1.0, 1.0, 1.0))
        probe = system.rates(0.0, (2.0, 3.0, -5.0))
    except ArithmeticError:
        return None
    products = zip(probe, (-15.0 * a, -10.0 * b, 6.0 * c), strict=True)
    if not all(isclose(*pair, rel_tol=1e-12, abs_tol=1e-14) for pair in products):
        return None
    # a I1 = I2 - I3, ...: three equations, of which two are independent; the moments are the cross
    # product of the two rows that are least parallel
    rows = (a, -1.0, 1.0), (1.0, b, -1.0), (-1.0, 1.0, c)
    found = max((cross3(rows[i], rows[i - 1]) for i in range(3)), key=lambda v: sum(map(abs, v)))
    size = sum(found)
    if not size or min(x / size for x in found) <= 0:
        return None  # moments of inertia are positive
    found = tuple(3 * x / size for x in found)
    return found if all(abs(dot3(row, found)) < 1e-12 for row in rows) else None


# -- one step: for each weight a symmetric product of the flows of the parts of the equations


def _generated(setup, flows, result):
    """A function ``move(f, p, x, h, weights)`` that returns the state after a step h."""
    loop = ["for w in weights:", "    e = w*h; d = 0.5*e", *("    " + flow for flow in flows)]
    lines = ["def move(f, p, x, h, weights):", *setup, *loop, f"return {result},"]
    space = {"cos": cos, "sin": sin, "__name__": GENERATED}
    exec("\n    ".join(lines), space)
    return space["move"]


@lru_cache(maxsize=64)
def _verlet(n, first, second, free):
    """Half a step of the first group, a step of the second, half a step of the first."""
    x, p = ", ".join(f"x{i}" for i in range(n)), "".join(f", p{j}" for j in range(free))

    def flow(group, time):
        k = ", ".join(f"k{i}" if i in group else "_" for i in range(n))
        return [f"{k}, = f(0.0, {x}{p})", *(f"x{i} += {time}*k{i}" for i in group)]

    setup = [f"{x}, = x", *([f"{p[2:]}, = p"] if free else [])]
    return _generated(setup, [*flow(first, "d"), *flow(second, "e"), *flow(first, "d")], x)


@lru_cache(maxsize=1)
def _lie_poisson():
    """The angular momentum, turned by the energy of one principal axis after the other."""

    def turn(i, time):
        j, k = (i + 1) % 3, (i + 2) % 3
        return (
            f"u = x{i}*{time}/I{i}; c = cos(u); s = sin(u); x{j}, x{k} = c*x{j} + s*x{k}, "
            f"c*x{k} - s*x{j}"
        )

    setup = ["I0, I1, I2 = p", "x0, x1, x2 = x[0]*I0, x[1]*I1, x[2]*I2"]
    turns = [turn(0, "d"), turn(1, "d"), turn(2, "e"), turn(1, "d"), turn(0, "d")]
    return _generated(setup, turns, "x0/I0, x1/I1, x2/I2")


class Splitting(Stepper):
    """A run of equal steps, as given or by the tolerance, which two runs calibrate."""

    remade = ("move",)

    @cached_property
    def move(self) -> tuple[Callable[..., Floats], Floats]:
        """The function that takes a step, and its constants."""
        p, groups = self.system.p, partition(self.system)
        assert groups is not None
        return _verlet(len(self.x), *groups, len(p)), p

    def begin(self, trajectory: Demand) -> None:
        order, span = trajectory.method.order, self.goal - self.t
        self.weights = COMPOSITIONS[order]
        count = span / (trajectory.step or self._time_scale() * self.tolerance ** (1 / order))
        if count > MAX_STEPS:
            raise LengthError(
                f"{count:.2g} steps of order {order} would be needed; take a higher order, another "
                "method, or a coarser rtol"
            )
        self.count = max(1, ceil(count * (1 - 1e-12)))  # round-off must not add a step
        self.h, self.steps = span / self.count, [self.x]

    def _time_scale(self):
        """The shortest time in which a rate changes by its own size: about a radian."""
        span, k = self.goal - self.t, self.system.rates(self.t, self.x)
        # a difference quotient of the rates over the time d, in which no state changes much
        pairs = zip(self.scales, k, strict=True)
        d = 1e-3 * min([span, *(s / abs(v) for s, v in pairs if abs(v) > 1e-3 * s)])
        later = self.system.rates(self.t, tuple(x + d * v for x, v in zip(self.x, k, strict=True)))
        times = [span / 4]
        for s, f, v, w in zip(self.scales, self.floors, k, later, strict=True):
            change = abs(w - v) / d
            if s > f and change > 1e-12 * s:  # a state that starts at zero has no size yet
                times.append(sqrt(max(s, abs(v) * d) / change))
        return min(times)

    def step(self, limit: float = inf) -> None:
        steps, times, h, weights = self.steps, self.step_times, self.h, self.weights
        (begin, _), f, (move, p) = self.start, self.system.f, self.move
        done = len(steps)
        for n in range(done, int(min(done + limit, self.count + 1))):
            x = move(f, p, steps[-1], h, weights)
            if not isfinite(sum(x)):
                raise StepError("the states have become infinite")
            steps.append(x)
            times.append(begin + n * h)
        if len(steps) > self.count:
            times[-1] = self.goal
        self.x, self.t = steps[-1], times[-1]
        columns = zip(self.scales, *steps[done - 1 :], strict=True)
        self.scales = tuple(max(map(abs, column)) for column in columns)
        self.calls += 3 * len(weights) * (len(steps) - done)

    def state_at(self, t: float) -> Floats:
        """The state at ``t`` by a shorter step from the last step before."""
        n = self.step_index(t)
        move, p = self.move
        return move(self.system.f, p, self.steps[n], t - self.step_times[n], self.weights)

    def interpolate(self, n: int, times: "np.ndarray") -> "np.ndarray":
        return np.array([self.state_at(t) for t in times.tolist()]).T


class LiePoisson(Splitting):
    """A run of equal steps of a free rigid body."""

    @cached_property
    def move(self) -> tuple[Callable[..., Floats], Floats]:
        """The function that takes a step, and the moments of inertia."""
        moments = principal_moments(self.system)
        assert moments is not None
        return _lie_poisson(), moments
