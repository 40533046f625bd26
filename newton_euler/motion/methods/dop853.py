"""The Runge-Kutta method DOP853 of Hairer, Norsett and Wanner as straight-line Python, generated
for the number of states.

No arrays and no library to import: between two steps nothing is called but the right-hand side. On
a top with six states it is three to four times faster than SciPy's DOP853 with the same right-hand
side. Coefficients: :mod:`newton_euler.motion.methods.dop853_coefficients`. E. Hairer, S. P.
Norsett, G. Wanner, Solving Ordinary Differential Equations I, 2nd edition (1993), sections II.4 to
II.6 and II.10.
"""

from bisect import bisect_right
from contextlib import suppress
from functools import lru_cache
from math import inf, isfinite, sqrt, ulp
from textwrap import indent

from ..endings import sticking
from .base import MAX_STALLED_STEPS, StallError, StepError, Stepper
from .dop853_coefficients import ERROR_3, ERROR_5, INTERPOLATION, NODES, STAGES, WEIGHTS

# The new step is the old one times SAFETY*error**(-1/8), since the error estimate is of order 8 in
# h, and between these bounds (II.4).
SAFETY, SHRINK, GROW = 0.9, 0.2, 6.0
# Rates that jump are steady for so many times as long as it takes to pass the jump, else they are
# singular there or the motion sticks; and how often that time is doubled.
STEADY, ROOMS = 100.0, 16
AGAIN = 1e4  # such times: two jumps that are closer are one
# how many jumps may follow each other within this part of the whole time: where more do, it sticks
OFTEN, NEAR = 16, 1e-6
RECENT = 16  # steps that show how rates jump to and fro
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
def generated(n, constants):
    """The functions ``run``, ``one_step`` and ``polynomial`` for n states and so many constants, as
    a dict.
    """
    space = {"sqrt": sqrt, "isfinite": isfinite, "inf": inf}
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
    """The dense output of order 7 of the state i (II.6): what is added to its value, in powers of u
    and 1 - u by turns.
    """
    d = f"(y{i} - x{i})"
    more = [f"h*({_sum(row, i)})" for row in INTERPOLATION]
    return f"({', '.join([d, f'h*k0_{i} - {d}', f'2.0*{d} - h*(k12_{i} + k0_{i})', *more])})"


class Dop853(Stepper):
    """A run of DOP853; each of its ``steps`` is (time, length, *state)."""

    resumable = True

    def begin(self, trajectory):
        """See :class:`~newton_euler.motion.methods.base.Stepper`."""
        system, step, span = self.system, trajectory.step, self.goal - self.t
        self.f = system.folded_rates, system.constants
        self.rates, self.calls = system.rates(self.t, self.x), 1
        self.code = generated(len(self.x), len(system.constants))
        self._kept = {}
        if step:
            self.tolerance = 1e300  # any step is accepted
        # at the least what changes the time
        self.hmax = step or max(trajectory.longest_part * span, 1e-13 * abs(self.goal))
        self.h = step or self._first_step(span)
        self.jumped, self._passed, self._often = (0.0,) * len(self.x), (-inf, 0.0, ()), 0

    def _first_step(self, span):
        """The length of a step in which the fastest state changes by half of its scale times
        tol**(1/8); states that start from nothing, with a huge rate to scale, do not count.
        """
        pairs = zip(self.rates, self.scales, strict=True)
        fastest = max((abs(k) / s for k, s in pairs if abs(k) < 1e3 * s), default=0.0)
        return min(0.5 * self.tolerance**0.125 / fastest if fastest else 1e-3 * span, self.hmax)

    def resume(self):
        """Continue from the present state, see ``back_to``."""
        self.rates, self._kept = self.system.rates(self.t, self.x), {}
        self.calls += 1

    def step(self, limit=inf):
        """See :class:`~newton_euler.motion.methods.base.Stepper`."""
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
                self.pass_stop(after, self.rates)
                self.rates, self.calls = self.system.rates(self.t, self.x), self.calls + 1
            self.step_times[-1] = self.t
            if self.h == 0.0:
                self._pass_jump()
            limit -= len(self.steps) - done
            try:
                self.check_progress()
            except StallError as stall:
                self._passed = self._stalled()
                try:
                    self._pass_jump()
                except StepError:
                    raise stall from None

    def _stalled(self):
        """The time, how long the last steps took, and by how much the rates changed in them."""
        few = [self.system.rates(t, x) for t, _, *x in self.steps[-RECENT:]]
        jumps = tuple([max(row) - min(row) for row in zip(*few, strict=True)])
        return self.t, self.t - self.step_times[-MAX_STALLED_STEPS], jumps

    def _pass_jump(self):
        """Go on beyond a time at which rates jump that are steady on both sides; where they are not,
        :class:`~.base.StepError`. The argument of a choice may be round-off for longer than the
        last digits of the time: then over more and more of it.
        """
        t, x, before, (last, room, known) = self.t, self.x, self.rates, self._passed
        if t - last > AGAIN * room:
            room, known = ulp(self.goal), (0.0,) * len(x)
        near = t - last < NEAR * (self.goal - self.start[0])
        self._often = self._often + 1 if near else 0
        span = self.goal - self.start[0]
        sticks = self._often > OFTEN or (self._often and sticking(self.system, t, x, span))
        for _ in range(ROOMS if self.system.traced.surprises and not sticks else 0):
            room *= 2
            with suppress(ArithmeticError, ValueError):
                after, there = self._moved(t, x, before, room)
                rates = self._earlier(t - STEADY * room), before, self.system.rates(after, there)
                later = self._moved(after, there, rates[-1], STEADY * room)
                if after < self.goal and self._steady(*rates, self.system.rates(*later), room):
                    break
        else:
            raise StepError("the step became too small to go on")
        earlier, _, rates = rates
        jumps = tuple(max(abs(b - a), c) for a, b, c in zip(earlier, rates, known, strict=True))
        self.jumped = tuple([a + room * b for a, b in zip(self.jumped, jumps, strict=True)])
        self.steps.append((t, room, *x))
        self.step_times.append(after)
        self.t, self.x, self.rates, self._passed = after, there, rates, (after, room, jumps)
        self.h, self.checked = self._first_step(self.goal - after), len(self.steps)
        self.update_scales()

    def _moved(self, t, x, rates, step):
        self.calls += 1
        return t + step, tuple([v + step * k for v, k in zip(x, rates, strict=True)])

    def _earlier(self, t):
        """The rates at the last step before ``t``."""
        begin, _, *x = self.steps[max(bisect_right(self.step_times, t) - 1, 0)]
        self.calls += 1
        return self.system.rates(begin, x)

    def _steady(self, earlier, before, rates, later, room):
        """True if rates are nearly those of an earlier instant before they jump, and nearly those of
        a later one after it.
        """
        rows = zip(earlier, before, rates, later, self.scales, strict=True)
        for a, b, c, d, s in rows:
            little = max(0.01 * abs(c - a), self.tolerance * s / (STEADY * room))
            if not (min(abs(b - a), abs(b - c)) <= little and abs(d - c) <= little):
                return False
        return True

    def state_at(self, t):
        """The state at ``t`` by a step of the method from the last step before, more accurate than
        the interpolation.
        """
        start, _, *x = self.steps[self.step_index(t)]
        self.calls += 12
        return self.code["one_step"](*self.f, start, t - start, x)

    def interpolate(self, n, times):
        """See :class:`~newton_euler.motion.methods.base.Stepper`; of order 7."""
        import numpy as np

        start, h, *x = self.steps[n]
        rows = self._kept.get(n)
        if rows is None:
            if len(self._kept) >= KEPT:  # another thread may use the old ones
                self._kept = {}
            rows = np.array(self.code["polynomial"](*self.f, start, h, x)).T[::-1, :, None]
            self._kept[n] = rows
            self.calls += 16
        u = (times - start) / h
        out = 0.0
        # Horner's rule, with the factors u and 1 - u by turns (II.6)
        for k, row in enumerate(rows):
            out = (out + row) * (1 - u if k % 2 else u)
        return out + np.array(x)[:, None]
