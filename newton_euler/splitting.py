"""Methods of fixed step that keep the structure of a motion: its reversibility, its area in phase space, its angular momentum.

``verlet`` and its compositions are for models that split into two groups of states, as coordinates and velocities, in which no rate depends on
its own group; they are symplectic if the forces have a potential. ``lie_poisson`` is for Euler's equations of a free body: it turns the angular
momentum about one principal axis after the other, so that its size is kept to round-off. That a model is of such a form is read from its text.

H. Yoshida, Construction of higher order symplectic integrators, Phys. Lett. A 150 (1990) 262; R. I. McLachlan, Explicit Lie-Poisson integration
and the Euler equations, Phys. Rev. Lett. 71 (1993) 3043.
"""

import math
from functools import lru_cache

from .courses import StepError, Stepper, checkpoint_indices
from .models import ModelError
from .vectors import cross3, dot3

MAX_STEPS = 3_000_000
_W6 = (-1.17767998417887, 0.235573213359357, 0.784513610477560)  # Yoshida's solution A for order 6, outside to middle reversed
_W8 = (-1.61582374150097, -2.44699182370524, -0.00716989419708120, 2.44002732616735, 0.157739928123617, 1.82020630970714, 1.04242620869991)


def _triple(order):
    """The triple jump that raises a symmetric method by two orders."""
    outer = 1 / (2 - 2 ** (1 / (order - 1)))
    return outer, 1 - 2 * outer, outer


def _symmetric(weights):
    """The weights w_m ... w_1 w_0 w_1 ... w_m from w_1 ... w_m."""
    outer = weights[::-1]
    return *outer, 1 - 2 * sum(weights), *outer[::-1]


COMPOSITIONS = {2: (1.0,), 4: _triple(4), 6: _symmetric(_W6), 8: _symmetric(_W8)}


# -- which models have the structure


def partition(system):
    """The states in two groups, no rate of which depends on its own group, as two tuples of numbers; None if there are none."""
    states, needs = system.model.states, system.traced.needs
    if any("t" in need for need in needs):
        return None
    joined = {i: {j for j, n in enumerate(states) if n in needs[i] or states[i] in needs[j]} for i in range(len(states))}
    side = {}
    for first in joined:
        side.setdefault(first, 0)
        waiting = [first]
        while waiting:
            i = waiting.pop()
            for j in joined[i]:
                if j not in side:
                    side[j] = 1 - side[i]
                    waiting.append(j)
                elif side[j] == side[i]:
                    return None
    return tuple(i for i in side if not side[i]), tuple(i for i in side if side[i])


def principal_moments(system):
    """The principal moments of inertia, to a factor, of a model that is Euler's equations without moments; None for any other.

    Three rates, each a number times the product of the two other states; the numbers must belong to moments.
    """
    states, needs = system.model.states, system.traced.needs
    if len(states) != 3 or any(states[i] in needs[i] or "t" in needs[i] for i in range(3)):
        return None
    try:
        a, b, c = system.rates(0.0, (1.0, 1.0, 1.0))
        probe = system.rates(0.0, (2.0, 3.0, -5.0))
    except ArithmeticError:
        return None
    if not all(math.isclose(x, k * v, rel_tol=1e-12, abs_tol=1e-14) for x, k, v in zip(probe, (a, b, c), (-15.0, -10.0, 6.0), strict=True)):
        return None
    rows = (a, -1.0, 1.0), (1.0, b, -1.0), (-1.0, 1.0, c)  # a I1 = I2 - I3, ...: three equations, two of which are enough
    found = max((cross3(rows[i], rows[i - 1]) for i in range(3)), key=lambda v: sum(map(abs, v)))
    size = sum(found)
    if not size or min(x / size for x in found) <= 0:
        return None
    found = tuple(3 * x / size for x in found)
    return found if all(abs(dot3(row, found)) < 1e-12 for row in rows) else None


# -- one step


@lru_cache(maxsize=64)
def _verlet(n, first, second, free):
    """A step ``move(f, p, t, x, h, weights)``: half of the first group, the second, half of the first, for each weight."""
    x, p = ", ".join(f"x{i}" for i in range(n)), "".join(f", p{j}" for j in range(free))

    def flow(group, name):
        k = ", ".join(f"k{i}" if i in group else "_" for i in range(n))
        return [f"{k}, = f(t, {x}{p})"] + [f"x{i} += {name}*k{i}" for i in group]

    loop = ["e = w*h", "d = 0.5*e", *flow(first, "d"), *flow(second, "e"), *flow(first, "d")]
    lines = [f"{x}, = x", *([f"{p[2:]}, = p"] if free else []), "for w in weights:", *("    " + line for line in loop), f"return {x},"]
    space = {}
    exec("def move(f, p, t, x, h, weights):\n" + "".join(f"    {line}\n" for line in lines), space)
    return space["move"]


def _turn(moments, x, h, weights):
    """A step of the splitting of the energy into that about each axis: each part turns the angular momentum about its axis."""
    I1, I2, I3 = moments
    a, b, c = x[0] * I1, x[1] * I2, x[2] * I3
    cos, sin = math.cos, math.sin
    for w in weights:
        e = w * h
        for axis, d in ((1, 0.5 * e), (2, 0.5 * e), (3, e), (2, 0.5 * e), (1, 0.5 * e)):
            if axis == 1:
                u = a * d / I1
                k, s = cos(u), sin(u)
                b, c = k * b + s * c, k * c - s * b
            elif axis == 2:
                u = b * d / I2
                k, s = cos(u), sin(u)
                c, a = k * c + s * a, k * a - s * c
            else:
                u = c * d / I3
                k, s = cos(u), sin(u)
                a, b = k * a + s * b, k * b - s * a
    return a / I1, b / I2, c / I3


# -- the course


class Splitting(Stepper):
    """A course of equal steps; ``tolerance`` sets them, to be calibrated by the difference of two runs, or ``step`` does."""

    order = 2
    body = False

    def __init__(self, system, t, x, trajectory):
        super().__init__(system, t, x, trajectory)
        self.weights = COMPOSITIONS[self.order]
        self._prepare()
        span = self.goal - t
        count = span / (trajectory.step or self._time_scale() * trajectory.tolerance ** (1 / self.order))
        if count > MAX_STEPS:
            raise ModelError(f"{count:.2g} steps of order {self.order} would be needed; take a higher order, another method, or a coarser rtol")
        self.count = max(1, math.ceil(count * (1 - 1e-12)))  # a span of whole steps is not cut once more by round-off
        self.h, self.steps = span / self.count, [self.x]

    def _prepare(self):
        if self.body:
            self.principal_moments = principal_moments(self.system)
            self.move = lambda x, h: _turn(self.principal_moments, x, h, self.weights)
            return
        first, second = partition(self.system)
        step, f, p = _verlet(len(self.x), first, second, len(self.system.p)), self.system.f, self.system.p
        self.move = lambda x, h: step(f, p, 0.0, x, h, self.weights)

    def _time_scale(self):
        """The shortest time in which a rate changes by as much as it is or has been: about a radian of the fastest swing."""
        x = self.x
        k = self.system.rates(self.t, x)
        d = 1e-3 * (self.goal - self.t)
        d = min([d] + [1e-3 * s / abs(v) for s, v in zip(self.scales, k, strict=True) if abs(v) > 1e-3 * s])
        later = self.system.rates(self.t, tuple(a + d * v for a, v in zip(x, k, strict=True)))
        second = [abs(b - a) / d for a, b in zip(k, later, strict=True)]
        scales = [math.sqrt(max(s, abs(v) * d) / a) for s, v, a in zip(self.scales, k, second, strict=True) if a > 1e-12 * s and s > 1e-3]
        return min([*scales, (self.goal - self.t) / 4])

    def step(self, limit=math.inf):
        """Go on by at most so many steps."""
        start, done = self.start[0], len(self.steps) - 1
        x, move, h = self.x, self.move, self.h
        for n in range(done + 1, min(done + limit, self.count) + 1):
            x = move(x, h)
            if not math.isfinite(sum(x)):
                raise StepError("the states have grown beyond all bounds")
            self.steps.append(x)
            self.step_times.append(start + n * h)
        self.x, self.t = x, self.step_times[-1]
        if len(self.steps) > self.count:
            self.t = self.step_times[-1] = self.goal
        self.scales = tuple(max(s, max(map(abs, column))) for s, column in zip(self.scales, zip(*self.steps[done:], strict=True), strict=True))
        self.calls += 3 * len(self.weights) * (len(self.steps) - 1 - done)

    @property
    def checkpoints(self):
        """See :class:`newton_euler.courses.Course`."""
        return [(self.step_times[n], self.steps[n]) for n in checkpoint_indices(len(self.steps))]

    def state_at(self, t):
        """By a shorter step from the last place before."""
        at = self.step_index(t)
        return self.move(self.steps[at], t - self.step_times[at])

    def interpolate(self, at, times):
        """By a shorter step of the method from the last place before."""
        import numpy as np

        return np.array([self.move(self.steps[at], t - self.step_times[at]) for t in times.tolist()]).T


def splitting(order, body=False):
    """The class of the method of this order; ``body`` for the free rigid body."""
    return type("LiePoisson" if body else "Verlet", (Splitting,), {"order": order, "body": body, "__doc__": Splitting.__doc__})
