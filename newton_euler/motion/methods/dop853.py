"""The Runge-Kutta method DOP853 of Hairer, Norsett and Wanner in straight-line Python.

No arrays: between two steps nothing is called but the right-hand side. On a top with six states it
is three to four times faster than SciPy's DOP853. E. Hairer, S. P. Norsett, G. Wanner, Solving
Ordinary Differential Equations I, 2nd edition (Springer, 1993), sections II.4 to II.6 and II.10.
"""

from collections.abc import Callable
from functools import cached_property, lru_cache, partial
from math import inf, isfinite, sqrt
from textwrap import indent
from typing import Any

from ...algebra.late import np
from ...algebra.places import GENERATED
from .base import MAX_STALLED_STEPS, Demand, Floats, StepError, Stepper
from .dop853_coefficients import ERROR_3, ERROR_5, INTERPOLATION, NODES, STAGES, WEIGHTS

# The new step is the old one times SAFETY*error**(-1/8), since the error estimate is of order 8 in
# h, and between these bounds (II.4).
SAFETY, SHRINK, GROW = 0.9, 0.2, 6.0
KEPT = 64  # steps whose polynomials are kept

# A step is what the time changes by: were it the h before rounding, the clock would drift from the
# states, by 1e-16 of the time at each step.
# The error combines the estimates of orders 5 and 3 as |e5|^2/sqrt(|e5|^2 + 0.01|e3|^2) (II.10).
_CODE = """\
def run(f, p, t, goal, x, s, q, k, h, tol, hmax, least, limit, keep):
    {x}, = x; {s}, = s; {q}, = q; {a}, = k; {p}
    tried = 0
    while t < goal and limit > 0:
        if h > hmax: h = hmax
        last = t + 1.001*h >= goal
        if last: h = goal - t
        elif h > 100.0*least: h = (t + h) - t
        tried += 1
        try:
{inner}
            {n}, = f(t + h, {y}{args})
{errors}
            e5 = {e5}; e3 = {e3}
            e = h*e5/sqrt((e5 + 0.01*e3)*{count}) if e5 > 0.0 else e5
        except (ZeroDivisionError, OverflowError, ValueError):
            e = inf
        if not e <= 1.0:
            h *= max({shrink}, {safety}*e**-0.125) if isfinite(e) else {shrink}
            if h < least: return t, ({x},), ({s},), ({a},), 0.0, tried
            continue
        keep((t, h, {x}))
        t = goal if last else t + h
        {x}, = {y},
        {a}, = {n},
        limit -= 1
{scales}
        h *= min({grow}, {safety}*e**-0.125) if e > 1e-12 else {grow}
    return t, ({x},), ({s},), ({a},), h, tried

def one_step(f, p, t, h, x):
{outer}
    return {y},

def polynomial(f, p, t, h, x):
{outer}
    {n}, = f(t + h, {y}{args})
{more}
    return {rows},
"""


@lru_cache(maxsize=32)
def generated(n: int, constants: int) -> dict[str, Any]:
    """{"run", "one_step", "polynomial": function} for ``n`` states and this many ``constants``."""
    space = {"sqrt": sqrt, "isfinite": isfinite, "inf": inf, "__name__": GENERATED}
    exec(compile(_text(n, constants), f"<DOP853 for {n} states>", "exec"), space)
    return space


def _text(n, constants):
    states = range(n)

    def each(pattern, separator=", "):
        return separator.join(pattern.format(i=i) for i in states)

    def stages(rows):
        for k in rows:
            at = ", ".join(f"x{i} + h*({_sum(STAGES[k], i)})" for i in states)
            yield f"{each(f'k{k}_{{i}}')}, = f(t + {NODES[k]!r}*h, {at}{args})"

    def lines(width, *parts):
        return indent("\n".join(parts), width * " ")

    x, k, args = each("x{i}"), each("k0_{i}"), "".join(f", p{j}" for j in range(constants))
    p = f"{args[2:]}, = p" if constants else ""
    body = [*stages(range(1, 12)), *(f"y{i} = x{i} + h*({_sum(WEIGHTS, i)})" for i in states)]
    errors = [
        f"c = tol*max(s{i}, abs(y{i})) + q{i}; u{i} = ({_sum(ERROR_5, i)})/c; v{i} = "
        f"({_sum(ERROR_3, i)})/c"
        for i in states
    ]
    return _CODE.format(
        x=x, y=each("y{i}"), s=each("s{i}"), q=each("q{i}"), a=k, n=each("k12_{i}"), args=args, p=p,
        count=n,
        shrink=SHRINK, safety=SAFETY, grow=GROW,
        inner=lines(12, *body), outer=lines(4, f"{x}, = x; {p}", f"{k}, = f(t, {x}{args})", *body),
        errors=lines(12, *errors), e5=each("u{i}*u{i}", " + "), e3=each("v{i}*v{i}", " + "),
        scales=lines(8, each("if abs(x{i}) > s{i}: s{i} = abs(x{i})", "\n")),
        more=lines(4, *stages((13, 14, 15))), rows=", ".join(map(_row, states)),
    )  # fmt: skip


def _sum(coefficients, i):
    return " + ".join(f"{c!r}*k{j}_{i}" for j, c in coefficients.items())


def _row(i):
    """Dense output (II.6) of order 7 of the state i: what is added, in powers of u and 1 - u."""
    d = f"(y{i} - x{i})"
    more = [f"h*({_sum(row, i)})" for row in INTERPOLATION]
    return f"({', '.join([d, f'h*k0_{i} - {d}', f'2.0*{d} - h*(k12_{i} + k0_{i})', *more])})"


class Dop853(Stepper):
    """A run of DOP853; each of its ``steps`` is (time, length, *state)."""

    resumable = True
    remade = "f", "code"

    @cached_property
    def f(self) -> tuple[Callable[..., Floats], Floats]:
        """The rates, and the constants in them."""
        return self.system.folded_rates, self.system.constants

    @cached_property
    def code(self) -> dict[str, Any]:
        """The functions that take and interpolate steps."""
        return generated(len(self.x), len(self.system.constants))

    def begin(self, trajectory: Demand) -> None:
        step, span = trajectory.step, self.goal - self.t
        self.rates, self.calls = self.system.rates(self.t, self.x), 1
        self._kept: dict[int, Any] = {}
        if step:
            self.tolerance = 1e300  # any step is accepted
        # at least so long that the time changes
        self.hmax = step or max(trajectory.longest_part * span, 1e-13 * abs(self.goal))
        self.h = step or self._first_step()

    def _first_step(self):
        """A step in which the fastest state changes by half of its scale times tol**(1/8); states
        that start from zero, whose rate is huge relative to the scale, do not count.
        """
        pairs = zip(self.rates, self.scales, strict=True)
        fastest = max((abs(k) / s for k, s in pairs if abs(k) < 1e3 * s), default=0.0)
        h = 0.5 * self.tolerance**0.125 / fastest if fastest else 1e-3 * (self.goal - self.t)
        return min(h, self.hmax)

    def resume(self) -> None:
        self.rates, self._kept = self.system.rates(self.t, self.x), {}
        self.calls, self.h = self.calls + 1, self.h or self._first_step()

    def step(self, limit: float = inf) -> None:
        while limit > 0 and self.t < self.goal:
            # the least step: a shorter one would not change the time
            done, (before, after) = len(self.steps), self.around_stop()
            least = 4e-16 * max(abs(self.t), abs(self.goal))
            self.t, self.x, self.scales, self.rates, self.h, tried = self.code["run"](
                *self.f, self.t, before, self.x, self.scales, self.noise, self.rates,
                self.h, self.tolerance, self.hmax, least, min(limit, MAX_STALLED_STEPS),
                self.steps.append,
            )  # fmt: skip
            self.calls += 12 * tried  # stages of a step; the first is the last of the step before
            self.step_times += [t + h for t, h, *_ in self.steps[done:]]
            if self.t == before < after:
                self.pass_stop(after)
                self.rates, self.calls = self.system.rates(self.t, self.x), self.calls + 3
            self.step_times[-1] = self.t
            if self.h == 0.0:
                raise StepError("the step became too small to go on")
            limit -= len(self.steps) - done
            self.check_progress()

    def step_end(self, n: int) -> float:
        return sum(self.steps[n][:2])

    def state_at(self, t: float) -> Floats:
        """The state at ``t`` by a step to there: more accurate than the interpolation."""
        start, _, *x = self.steps[self.step_index(t)]
        self.calls += 12
        return self.code["one_step"](*self.f, start, t - start, x)

    def halved(self, n: int) -> list[float]:
        """How much step n differs from two halves of it, over the scales."""
        (t, h, *x), step = self.steps[n], partial(self.code["one_step"], *self.f)
        last = n + 1 == len(self.steps)
        begin, reached = (self.t, self.x) if last else (self.steps[n + 1][0], self.steps[n + 1][2:])
        if begin > t + h:  # past a stop, which moved the state
            reached = step(t, h, x)
        self.calls += 24
        rows = zip(step(t + h / 2, h / 2, step(t, h / 2, x)), reached, self.scales, strict=True)
        return [(u - v) / (s or 1.0) for u, v, s in rows]

    def interpolate(self, n: int, times: "np.ndarray") -> "np.ndarray":
        """See the base class; of order 7."""
        start, h, *x = self.steps[n]
        rows = self._kept.get(n)
        if rows is None:
            if len(self._kept) >= KEPT:  # another thread may use the old ones
                self._kept = {}
            try:
                rows = self.code["polynomial"](*self.f, start, h, x)
            except (ArithmeticError, ValueError):  # a stage past zero, as of a root; shorter steps
                return np.array([self.state_at(t) for t in times.tolist()]).T
            rows = np.array(rows).T[::-1, :, None]
            self._kept[n] = rows
            self.calls += 16
        u = (times - start) / h
        out = 0.0
        # Horner's rule, with the factors u and 1 - u by turns (II.6)
        for k, row in enumerate(rows):
            out = (out + row) * (1 - u if k % 2 else u)
        return out + np.array(x)[:, None]
