"""The true states, events and conditioning of a case, to more digits than floats have, by two ways.

The first way is a closed form where the case has one, else Taylor series by heyoka in numbers of
42 digits. The second checks it: a closed form is put into the rates; a series is compared with
Gragg's extrapolation in mpmath's numbers, which shares neither method nor code nor arithmetic with
it, and where that takes too long with series of 60 digits. Where heyoka is missing, extrapolation
in 42 digits is the first way. Rates with kinks are followed from one analytic piece to the next
(:mod:`tests.honesty.pieces`). No code under test takes part, except the tracing of formulas.
"""

import hashlib
import importlib.util
import inspect
import json
import math
import os
import tempfile
from dataclasses import asdict, dataclass, replace
from inspect import Parameter, Signature
from itertools import pairwise
from pathlib import Path
from random import Random
from time import perf_counter

import mpmath as mp
import numpy as np

from newton_euler import compiled
from tests.honesty import closed_forms
from tests.honesty.cases import names
from tests.honesty.limits import TimeUp, limited
from tests.honesty.pieces import pieces

VERSION = 5  # of what is stored
BITS, FINE_BITS = 140, 200  # of heyoka's numbers: 42 and 60 digits
DIGITS, CHECK_DIGITS, EXACT_DIGITS = 42, 22, 50
AGREEMENT = 1e-15  # of the two ways: a thousandth of the tightest tolerance
SECONDS, CHECK_SECONDS = 60.0, 8.0
MOST_INSIDE = 1000
INSIDE = 12  # parts of a step, at whose ends switches and events are evaluated
GOLDEN = (math.sqrt(5) - 1) / 2
EDGE = 1e-6  # of a step: a point this close to its ends shows on which side of it an extremum lies
RUNS = 14  # of Gragg's rule over one step: order 28
OWN = 1e-3  # of its natural size: no state is judged more finely, see :func:`scales`
NUDGE = 1e-18  # relative change of the start and the parameters, to measure the conditioning
# seeds of its signs: if position and speed change alike, the time of an impact stays the same
NUDGES = 1, 2, 4
SAMPLES = 60  # states along the way, for the sizes


class NoReferenceError(Exception):
    """No reference was reached; the message says why."""


@dataclass(frozen=True)
class Reference:
    """The truth about a case.

    times, states : the motion, decimal numbers as text; the last is the end, at an event that ends
        the motion or at ``t_end``
    sizes : the largest size of each state on the way; ``natural`` : what the coupling to the other
        states makes of it, see :func:`natural_sizes`
    condition : by how much a relative change of the start and of the parameters is magnified at the
        end
    events : (number of the event, its time as text, weight), where the weight makes a difference in
        time one of the function, over its range
    margin : the smallest extremum of an event's function over its range: an error larger than that
        may make two events or take them away
    ways, agreement : the two ways, and by how much they differ
    """

    times: tuple
    states: tuple
    sizes: tuple
    natural: tuple
    condition: float
    events: tuple
    margin: float
    ways: tuple
    agreement: float


def reference(case, cache=None, seconds=SECONDS):
    """The :class:`Reference` of a case (one motion, not many), from the folder ``cache`` if stored
    there.

    Raises :class:`NoReferenceError` if it is not reached in so many seconds, or if the two ways
    disagree.
    """
    case = replace(case, model=case.written_out or case.model)
    path = Path(cache) / f"{_key(case)}.json" if cache else None
    if path and path.exists():
        known = json.loads(path.read_text())
        if "trouble" in known and known["seconds"] >= seconds:
            raise NoReferenceError(known["trouble"])
        if "trouble" not in known:
            return Reference(**{n: _tuples(x) for n, x in known.items()})
    try:
        found = _computed(case, seconds)
    except NoReferenceError as error:
        _store(path, {"trouble": str(error), "seconds": seconds})
        raise
    _store(path, asdict(found))
    return found


def cache_folder():
    """The user's folder in which references are kept unless another is given."""
    root = Path(os.environ.get("XDG_CACHE_HOME") or Path.home() / ".cache")
    return root / "newton_euler" / "honesty"


def _tuples(x):
    return tuple(map(_tuples, x)) if isinstance(x, list) else x


def _store(path, record):
    if not path:
        return
    path.parent.mkdir(parents=True, exist_ok=True)
    with tempfile.NamedTemporaryFile("w", dir=path.parent, delete=False) as file:
        json.dump(record, file)
    os.replace(file.name, path)


def _key(case):
    """A hash of all that the reference depends on."""
    problem = _Problem(case)
    watched = [w.source for w in problem.watched]
    parts = [VERSION, problem.rates.source, watched, dict(case.model.parameters)]
    parts += [case.start, case.times, case.t0, case.knots, case.singular_at]
    parts += [("all extrema", e.direction, e.terminal) for e in case.events]
    parts += [impact and impact.source for impact in problem.impacts]
    code = [f for f in (case.exact, case.event_times) if f]
    code += [closed_forms] if case.exact else [_Integration] if watched else []
    parts += map(inspect.getsource, code)
    return hashlib.sha256(repr(parts).encode()).hexdigest()[:32]


# -- one case


def _computed(case, seconds):
    begun = perf_counter()
    if case.singular:
        ways = "given: no motion there", "none"
        return Reference((), (), (), (), math.inf, (), math.inf, ways, 0.0)
    try:
        with limited(seconds):
            found, way, again = _first(case)
            about = sizes, natural = _sizes(case, found.way)
            moved = max(_distance(again(seed), found, *about) for seed in NUDGES)
        left = max(seconds - (perf_counter() - begun), 1.0)
        checked, agreement = _second(case, found, sizes, natural, left)
    except TimeUp:
        raise NoReferenceError(f"not reached in {seconds:g} s") from None
    except (ArithmeticError, ValueError) as error:
        raise NoReferenceError(f"{type(error).__name__}: {error}") from error
    if not agreement <= AGREEMENT:
        raise NoReferenceError(f"{way} and {checked} differ by {agreement:.1g}")
    events, margin = found.events(case)
    times, states = (
        tuple(map(_text, found.times)),
        tuple(tuple(map(_text, x)) for x in found.states),
    )
    condition, ways = moved / NUDGE, (way, checked)
    return Reference(times, states, *about, condition, events, margin, ways, agreement)


def _text(x):
    return mp.nstr(x, 34, strip_zeros=False, min_fixed=0, max_fixed=0)


def _first(case):
    """The motion by the first way, its name, and a function that follows it from near the start."""
    if case.exact:
        with mp.workdps(EXACT_DIGITS):
            return _closed(case, None), "closed form", lambda seed: _closed(case, seed)
    if importlib.util.find_spec("heyoka") is None:
        stepper, way = Extrapolation(_Problem(case), DIGITS), "extrapolation, 42 digits"
    else:
        stepper, way = TaylorSeries(_Problem(case), BITS), "Taylor series, 42 digits"
    again = lambda seed=None: _followed(case, stepper, DIGITS, seed)
    return again(), way, again


def _second(case, found, sizes, natural, seconds):
    """The name of the second way, and how far the first one is from it."""
    if case.exact:
        return "put into the rates", _residual(case, sizes, natural)
    try:
        with limited(min(CHECK_SECONDS, seconds)):
            checker = Extrapolation(_Problem(case), CHECK_DIGITS, scales(sizes, natural))
            again, way = _followed(case, checker, CHECK_DIGITS), "extrapolation, 22 digits"
    except TimeUp:
        with limited(seconds):
            again = _followed(case, TaylorSeries(_Problem(case), FINE_BITS), DIGITS)
            way = "Taylor series, 60 digits"
    return way, _distance(again, found, sizes, natural)


def _distance(a, b, sizes, natural):
    """The largest difference at the times of comparison, each state relative to its size."""
    counts = len(a.states), len(b.states)
    if counts[0] != counts[1]:
        raise NoReferenceError(f"times of comparison reached by two ways: {counts}")
    with mp.workdps(EXACT_DIGITS):
        pairs = zip(a.states, b.states, strict=True)
        return float(max(_relative(x, y, scales(sizes, natural)) for x, y in pairs))


def _relative(a, b, sizes):
    """The largest difference of the numbers of two states over their sizes."""
    return max(abs(u - v) / s for u, v, s in zip(a, b, sizes, strict=True))


def scales(sizes, natural):
    """The scales of differences: the largest size of each state on the way, and for states
    that are nearly zero a thousandth of their natural size.

    A state that happens to be zero gets the round-off of those that it is coupled with. A
    thousandth of its natural size leaves room for a relative 1e-12 above that, but none for a
    state that stays small: what couples to it is then small as well.
    """
    return [max(s, OWN * n) or 1.0 for s, n in zip(sizes, natural, strict=True)]


def _sizes(case, way):
    sizes = [max(map(abs, column)) for column in zip(*(x for _, x in way), strict=True)]
    return tuple(sizes), natural_sizes(case, way[:: len(way) // 40 + 1], sizes)


def natural_sizes(case, way, sizes):
    """The size of each state that its coupling to the others gives it: sum over j of |df_i/dx_j| size_j, over
    the fastest rate of the linearised motion.

    That is independent of units, and says how large a state is that happens to be zero: the rate of
    nutation of a steady precession is as large as a nutation by the whole angle would make it.
    """
    f, p = case.model.compiled_rhs(*case.model.parameters), case.model.parameters.values()
    natural = np.zeros(len(sizes))
    for _ in range(2):  # the second time with a step also for states that are zero
        scale = np.maximum(sizes, natural)
        steps = 1e-6 * np.where(scale > 0, scale, 1.0)
        made, fastest = np.zeros(len(sizes)), 1 / (case.t_end - case.t0)
        for t, x in way:
            J = _jacobian(lambda *x, t=t: f(t, *x, *p), x, steps)
            if np.isfinite(J).all():
                made = np.maximum(made, abs(J) @ np.array(sizes))
                fastest = max(fastest, abs(np.linalg.eigvals(J * steps / steps[:, None])).max())
        natural = made / fastest
    return tuple(float(x) for x in natural)


def _jacobian(f, x, steps):
    """The Jacobian by differences; nan where the rates have no value."""
    columns = []
    for j, step in enumerate(steps):
        up, down = list(x), list(x)
        up[j] += step
        down[j] -= step
        try:
            difference = np.array(f(*up)) - np.array(f(*down))
        except (ArithmeticError, ValueError):
            return np.array([math.nan])
        columns.append(difference / (up[j] - down[j]))
    return np.transpose(columns)


# -- the formulas of a case


class _Problem:
    """Rates ``f(t, *states, *parameters, *signs)``; watched ``g(t, *states, *parameters)``: the
    switches, whose signs these are, then the events; ``impacts`` : the states after these, or None.
    """

    def __init__(self, case):
        self.case, model, switches = case, case.model, []
        self.free = list(model.parameters)
        if case.exact:
            self.rates = model.compiled_rhs(*self.free)
        else:
            self.rates, switches = pieces(model)
        self.switches = len(switches)
        self.watched = [*switches, *(_formula(model, e.function) for e in case.events)]
        self.impacts = [_impact(model, e.then) for e in case.events]


def _impact(model, then):
    return _formula(model, lambda s, p, t: then(s, p, t)[1]) if then else None


def _formula(model, f):
    """A function ``(s, p, t)`` of a model, traced."""
    order = ("t", *model.states, *model.parameters)

    def values(**given):
        s, p = (names(part, map(given.get, part)) for part in (model.states, model.parameters))
        return f(s, p, given["t"])

    values.__signature__ = Signature([Parameter(n, Parameter.POSITIONAL_OR_KEYWORD) for n in order])
    return compiled(values)


# -- closed forms


class _Motion:
    """The states at the times of comparison, states along the way, and the events of a case."""

    def __init__(self):
        self.times, self.states, self.way, self.found, self.extrema = [], [], [], [], []
        self.ranges = {}

    def events(self, case):
        """The events with their weights, and the margin."""
        span = case.t_end - case.t0
        weights = {n: span / r if r else 1.0 for n, r in self.ranges.items()}
        weight = lambda n, slope: min(1.0, abs(slope) * weights.get(n, 1.0))
        events = tuple((n, _text(t), weight(n, slope)) for n, t, slope in self.found)
        extrema = [abs(g) / self.ranges[n] for n, g in self.extrema if self.ranges[n]]
        return events, min(extrema, default=math.inf)


def _given(case, seed):
    """Start and parameters as mpf; with a seed each is changed by a relative 1e-18, up or down."""
    chance = Random(seed)

    def change(x):
        return mp.mpf(x) * (1 + mp.mpf(NUDGE) * chance.choice((-1, 1))) if seed else mp.mpf(x)

    return [change(x) for x in case.start], [change(x) for x in case.model.parameters.values()]


def _closed(case, seed):
    with mp.workdps(EXACT_DIGITS):
        x, p = _given(case, seed)
        s, p = names(case.model.states, x), names(case.model.parameters, p)

        def at(t):
            return tuple(mp.mpf(v) for v in case.exact(mp, s, p, mp.mpf(t)))

        out = _Motion()
        out.times = [mp.mpf(t) for t in case.times]
        out.states = [at(t) for t in out.times]
        if seed is None:
            with mp.workdps(20 + max(0, round(math.log10(max(case.t_end - case.t0, 1))))):
                chance, span = Random(1), case.t_end - case.t0
                # a state that has died out long before the end has a size too
                early = [10 ** (-5 + 5 * k / SAMPLES) for k in range(SAMPLES)]
                parts = sorted([0.0, *early, *(chance.random() for _ in range(SAMPLES)), 1.0])
                times = [case.t0 + part * span for part in parts]
                out.way = [(t, tuple(map(float, at(t)))) for t in times]
        if case.event_times:
            out.found = [(0, t, math.inf) for t in case.event_times(mp, s, p)]
    return out


def _residual(case, sizes, natural):
    """How far the derivative of a closed form is from the rates, and its start from the start."""
    span, f = case.t_end - case.t0, case.model.compiled_rhs(*case.model.parameters)
    with mp.workdps(EXACT_DIGITS):
        x, p = _given(case, None)
        s, q = names(case.model.states, x), names(case.model.parameters, p)
        at = lambda t: tuple(map(mp.mpf, case.exact(mp, s, q, mp.mpf(t))))
        known, last = scales(sizes, natural), at(case.t_end)
        off, largest = [0] * len(x), [size / span for size in known]
        for t in map(mp.mpf, case.times[:-1]):
            now = at(t)
            if now == last:  # the motion has come to rest, where rates that jump have no value
                continue
            rates = f(t, *now, *p)
            paces = [size / abs(r) for size, r in zip(sizes, rates, strict=True) if r and size]
            h = min([mp.mpf(10) ** -18 * span, *(mp.mpf(10) ** -16 * pace for pace in paces)])
            for i, (a, b, r) in enumerate(zip(at(t - h), at(t + h), rates, strict=True)):
                off[i] = max(off[i], abs((b - a) / (2 * h) - r))
                largest[i] = max(largest[i], abs(r))
        of_rates = max(o / r for o, r in zip(off, largest, strict=True))
        return float(max(_relative(at(case.t0), x, known), of_rates))


# -- step by step


def _followed(case, stepper, digits, seed=None):
    """The motion from the start to the end, one analytic piece after the other."""
    with mp.workdps(digits + 6):
        return _Integration(case, stepper, *_given(case, seed)).run()


class _Integration:
    """Integration by a stepper that changes branch at a zero of a switch and records the events."""

    def __init__(self, case, stepper, x, p):
        problem = stepper.problem
        self.case, self.problem, self.stepper, self.p = case, problem, stepper, p
        self.out, self.signs = _Motion(), [1] * problem.switches
        self.goal, self.floats = mp.mpf(case.t_end), [float(v) for v in p]
        stepper.begin(mp.mpf(case.t0), x, p, self.signs, self.goal - case.t0, bool(problem.watched))
        self._first_signs(x)
        self._sides(x)

    def _first_signs(self, x):
        """The branches at the start; at a zero of a switch, the one into which the motion goes."""
        t = self.stepper.t
        for i in range(self.problem.switches):
            g = self._g(i, t, x)
            if g == 0:
                ahead = (self.goal - t) * 10**-9
                for sign in (1, -1):
                    self.signs[i] = sign
                    self.stepper.put(t, x, self.signs)
                    self.stepper.step(ahead)
                    g = self._g(i, self.stepper.t, self.stepper.state())
                    if g * sign > 0:
                        break
                else:
                    raise NoReferenceError("the motion stays at a switch from the start on")
            self.signs[i] = 1 if g > 0 else -1
        self.stepper.put(t, x, self.signs)

    def _sides(self, x, but=None):
        """The sign of each event's function before the next look; None just after the event ``but``."""
        self.side = [None] * len(self.problem.watched)
        for i in range(self.problem.switches, len(self.side)):
            g = self._g(i, self.stepper.t, x)
            if i != but and abs(g) >= self.stepper.precision:
                self.side[i] = 1 if g > 0 else -1

    def _g(self, i, t, x):
        return self.problem.watched[i](t, *x, *self.p)

    def run(self):
        case, stepper, out = self.case, self.stepper, self.out
        out.way.append((float(stepper.t), tuple(map(float, stepper.state()))))
        goals = sorted({*case.times, *(t for t in case.knots if case.t0 < t < case.t_end)})
        for goal in map(mp.mpf, goals):
            while stepper.t < goal:
                stepper.step(goal - stepper.t)
                if self.problem.watched and self._looked() == "ended":
                    out.times.append(stepper.t)
                    out.states.append(stepper.state())
                    return out
                out.way.extend(stepper.way())
            if goal in case.times:
                out.times.append(goal)
                out.states.append(stepper.state())
        return out

    def _looked(self):
        """Go back to the first zero in the last step, and change the branch at a switch."""
        stepper, h = self.stepper, float(self.stepper.h)
        begun, first = float(stepper.before[0]), self.problem.switches
        hits = [hit for i in range(len(self.problem.watched)) for hit in self._zeros(i, h, begun)]
        for tau, i in sorted(hits):
            t, x = stepper.before[0] + tau, stepper.inside(tau)
            if i < first:
                self.signs[i] = -self.signs[i]
                return self._go_on(t, x)
            event, slope = self.case.events[i - first], self._slope(i, tau, h)
            if event.direction in (0, 1 if slope > 0 else -1):
                self.out.found.append((i - first, t, slope))
                if impact := self.problem.impacts[i - first]:
                    return self._go_on(t, list(map(mp.mpf, impact(t, *x, *self.p))), but=i)
                if event.ends:
                    stepper.put(t, x, self.signs)
                    return "ended"
        return None

    def _go_on(self, t, x, but=None):
        self.stepper.put(t, x, self.signs)
        self._sides(x, but)
        return "switched"

    def _float(self, i, tau, begun):
        x = map(float, self.stepper.inside(tau))
        return float(self.problem.watched[i](begun + tau, *x, *self.floats))

    def _slope(self, i, tau, h):
        t, inside, d = self.stepper.before[0], self.stepper.inside, 1e-4 * h
        a, b = (self._g(i, t + u, inside(u)) for u in (tau - d, tau + d))
        return float(b - a) / (2 * d)

    def _looks(self, i, h, begun):
        """Times and values of function i, so many that twice as many show no more extrema."""
        if not self.stepper.dense:
            return [h], [self._float(i, h, begun)]
        parts, turns = INSIDE, None
        while True:
            # unequal distances, or a fast oscillation could look slow
            inner = sorted(h * (k * GOLDEN % 1.0) for k in range(1, parts))
            taus = [0.0, EDGE * h, *inner, h - EDGE * h, h]
            values = [self._float(i, tau, begun) for tau in taus]
            rises = [b > a for a, b in pairwise(values)]
            before, turns = turns, sum(a != b for a, b in pairwise(rises))
            if turns == before or parts > MOST_INSIDE:
                return taus, values
            parts *= 2

    def _zeros(self, i, h, begun):
        """Zeros of function number i in the last step, as pairs (time in the step, i)."""
        n, switch = i - self.problem.switches, i < self.problem.switches
        taus, values = self._looks(i, h, begun)
        largest = self.out.ranges[n] = max(self.out.ranges.get(n, 0.0), *map(abs, values))
        points = list(zip(taus, values, strict=True))
        for (a, ga), (b, gb), (c, gc) in zip(points, points[1:], points[2:], strict=False):
            near = abs(gb) < 0.1 * largest
            if near and abs(gb) <= min(abs(ga), abs(gc)) and ga * gb > 0 and gb * gc > 0:
                b, gb = self._extremum(i, a, c, begun, math.copysign(1.0, ga))
                if not switch:
                    self.out.extrema.append((n, gb))
                if gb * ga < 0:
                    points.append((b, gb))
            elif not switch and (gb - ga) * (gc - gb) < 0:
                if near:  # the bottom of a dip that contains one of the points
                    _, gb = self._extremum(i, a, c, begun, math.copysign(1.0, ga - gb))
                self.out.extrema.append((n, gb))
        before, sign, out = 0.0, self.signs[i] if switch else self.side[i], []
        for tau, g in sorted(points)[1 if self.stepper.dense else 0 :]:  # the first sign is known
            now = 1 if g > 0 else -1
            if sign not in (None, now) and not (switch and out):  # beyond lies another branch
                out.append((self._root(i, before, tau, sign), i))
            before, sign = tau, now
        self.side[i] = sign
        return out

    def _extremum(self, i, a, c, begun, sign):
        """The smallest value of sign*g between a and c, by golden section."""
        value = lambda tau: sign * self._float(i, tau, begun)
        u, v = c - GOLDEN * (c - a), a + GOLDEN * (c - a)
        gu, gv = value(u), value(v)
        for _ in range(60):
            if gu < gv:
                c, v, gv = v, u, gu
                u = c - GOLDEN * (c - a)
                gu = value(u)
            else:
                a, u, gu = u, v, gv
                v = a + GOLDEN * (c - a)
                gv = value(v)
            if c - a < 1e-9 * c:
                break
        return (u, sign * gu) if gu < gv else (v, sign * gv)

    def _root(self, i, a, b, sign):
        """The zero between a and b by false position (Illinois); before it the sign is this."""
        t0, inside = self.stepper.before[0], self.stepper.inside
        value = lambda tau: self._g(i, t0 + tau, inside(tau))
        a, b = mp.mpf(a), mp.mpf(b)
        ga, gb = value(a), value(b)
        if ga * sign <= 0:  # it passed zero before the first point, or starts there
            if a > 0:
                return a
            a = b * mp.mpf(10) ** -12
            ga = value(a)
            if ga * sign <= 0:
                raise NoReferenceError(f"the motion stays at a switch from t = {float(t0):.6g} on")
        if gb == 0:
            return b
        scale, side = b, 0
        for _ in range(200):
            if abs(b - a) <= scale * self.stepper.precision:
                break
            c = (a * gb - b * ga) / (gb - ga)
            gc = value(c)
            if gc == 0:
                return c
            if gc * gb > 0:
                b, gb, ga, side = c, gc, ga / 2 if side == 1 else ga, 1
            else:
                a, ga, gb, side = c, gc, gb / 2 if side == -1 else gb, -1
        return (a + b) / 2


class TaylorSeries:
    """Steps of Taylor series by heyoka in multiple precision.

    Heyoka multiplies by the inverse of a number that a formula divides by, and rounds it to a
    float: the families divide by parameters, not by numbers.
    """

    dense = True

    def __init__(self, problem, bits):
        import heyoka as hy

        self.hy, self.bits, self.problem = hy, bits, problem
        states = problem.case.model.states
        variables = [hy.expression(n) for n in states]
        count = len(problem.free) + problem.switches
        rates = problem.rates(hy.time, *variables, *(hy.par[i] for i in range(count)))
        equations = [(v, r + hy.expression(0.0)) for v, r in zip(variables, rates, strict=True)]
        zero = hy.real(0, bits)
        self.ta = hy.taylor_adaptive(
            equations, [zero] * len(states), fp_type=hy.real, prec=bits, compact_mode=True
        )
        self.h, self.before = None, None
        self.precision = 10.0 ** -(0.3 * bits - 6)

    def _real(self, x):
        return self.hy.real(mp.nstr(x, 64), self.bits)

    def _mpf(self, x):
        return mp.mpf(str(x))

    def begin(self, t, x, p, signs, span, watched):
        """Start with these parameters and branches."""
        self.p = [self._real(v) for v in p]
        self.put(t, x, signs)

    def put(self, t, x, signs):
        """Go on from there."""
        ta, values = self.ta, [*self.p, *(self.hy.real(s, self.bits) for s in signs)]
        for i in range(len(ta.pars)):
            ta.pars[i] = values[i]
        ta.time = self._real(t)
        for i, v in enumerate(x):
            ta.state[i] = self._real(v)
        self.t = t

    def step(self, most):
        """One step, of at most that length."""
        self.before = (self.t,)
        outcome, h = self.ta.step(max_delta_t=self._real(most), write_tc=True)
        ends = self.hy.taylor_outcome
        if outcome not in (ends.success, ends.time_limit) or not float(h) > 0:
            at = f"t = {float(self.t):.6g}"
            raise NoReferenceError(f"the series of heyoka end at {at}: {outcome}")
        self.h = self._mpf(h)
        self.t += most if outcome == ends.time_limit else self.h

    def state(self):
        """The state that is reached."""
        return [self._mpf(x) for x in self.ta.state]

    def inside(self, tau):
        """The state so long after the beginning of the last step; in floats if tau is one."""
        if type(tau) is float:
            number, back = float, self.hy.real(tau - float(self.h), self.bits)
        else:
            number, back = self._mpf, self._real(tau - self.h)
        return [number(x) for x in self.ta.update_d_output(back, rel_time=True)]

    def way(self):
        """Floats of the middle and the end of the last step."""
        t, h = float(self.before[0]), float(self.h)
        middle, end = tuple(self.inside(h / 2)), tuple(map(float, self.ta.state))
        return [(t + h / 2, middle), (t + h, end)]


class Extrapolation:
    """Steps of Gragg's midpoint rule, extrapolated (W. B. Gragg 1965), in mpmath's numbers."""

    dense = False

    def __init__(self, problem, digits, sizes=None):
        self.problem, self.known = problem, sizes
        self.goal, self.precision = mp.mpf(10) ** -(digits + 2), mp.mpf(10) ** -(digits - 2)

    def begin(self, t, x, p, signs, span, watched):
        """Start with these parameters and branches."""
        self.p, self.most, self.next = p, span / (100 if watched else 4), span / 64
        self.sizes = [max(abs(v), s) for v, s in zip(x, self.known or [0] * len(x), strict=True)]
        self.shortest = span * self.goal
        self.put(t, x, signs)

    def put(self, t, x, signs):
        """Go on from there."""
        self.t, self.x, self.signs = t, list(x), list(signs)

    def _rates(self, t, x):
        return self.problem.rates(t, *x, *self.p, *self.signs)

    def step(self, most):
        """One step, of at most that length."""
        self.before = (self.t, self.x)
        while True:
            h = min(most, self.next, self.most)
            new, error = self._to(h)
            margin = float(self.goal / (error + self.goal * 1e-20))
            factor = min(4.0, max(0.2, 0.9 * margin ** (1 / (2 * RUNS - 1))))
            if error <= self.goal:
                break
            self.next = h * factor
            if self.next < self.shortest:
                raise NoReferenceError(f"extrapolation ends at t = {float(self.t):.6g}")
        self.next = max(self.next, h * factor) if h == most else h * factor
        self.h, self.t, self.x = h, self.t + h, new
        self.sizes = [max(a, abs(b)) for a, b in zip(self.sizes, new, strict=True)]

    def state(self):
        """The state that is reached."""
        return list(self.x)

    def inside(self, tau):
        """The state so long after the beginning of the last step, by a step of its own."""
        return self._to(tau)[0] if tau else self.before[1]

    def way(self):
        """The end of the last step in floats."""
        return [(float(self.t), tuple(map(float, self.x)))]

    def _to(self, h):
        t, x = self.before
        first, table = self._rates(t, x), []
        for run in range(1, RUNS + 1):
            row = [self._midpoint(t, x, first, h, 2 * run)]
            for back, column in enumerate(table[-1] if table else [], start=1):
                weight = 1 / ((self.goal * 0 + run) ** 2 / (run - back) ** 2 - 1)
                row.append([a + (a - b) * weight for a, b in zip(row[-1], column, strict=True)])
            table.append(row)
        *_, before, best = table[-1]
        floor = max(max(map(abs, best)), *self.sizes) * self.goal  # for states that are zero
        sizes = [max(abs(a), s, floor) for a, s in zip(best, self.sizes, strict=True)]
        return best, _relative(best, before, sizes)

    def _midpoint(self, t, x, first, h, n):
        """Gragg's rule: n steps of h/n."""
        d = h / n
        before, now = x, [a + d * k for a, k in zip(x, first, strict=True)]
        for i in range(1, n):
            rates = self._rates(t + i * d, now)
            before, now = now, [a + 2 * d * k for a, k in zip(before, rates, strict=True)]
        return now
