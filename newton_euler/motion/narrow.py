"""Structures of the rates that a step passes over without seeing them: a brake of some centimetres
on a way of some metres, a blow of some milliseconds.

The rates change fast where an operation with a scale of its own does: ``where``, ``abs``, ``exp``,
``tanh``, and a quotient whose denominator comes close to zero. The trajectory is there where the
argument is about zero, or of ``exp`` the largest, at a time that is found however narrow the
structure is, since the argument is smooth: in each step it is a cubic polynomial, or the step is
divided. Around that time the rates are integrated along the trajectory, in pieces that become
shorter by powers of two, and compared with the change of the states.
"""

from functools import cache, cached_property
from typing import NamedTuple

from ..algebra.compile import Compiled
from ..algebra.trace import COMPARISONS, Step
from .analytic import factors, varying

GROWING, STEEP = {"exp", "pow"}, {"tanh", "sinh", "cosh", "atan"}
# What an argument changes by in a step before a structure can lie between the stages of a method,
# or the ratio of its values; and the same in a part of a step
CHANGE, RATIO = (4.0, 0.5), (0.1, 0.5)
NODES = (0.0, 1e-3, 0.27, 0.5, 0.77, 0.999, 1.0)  # of a part, where arguments are computed
# part of its change by which an argument may differ from a cubic polynomial, and how many times
# that its slope and its change are where it does not turn
ROUGH, STEADY = 0.2, 8.0
NOISE = 1e-12  # of an argument, relative
SAMPLES = 16  # of the polynomial
FEW = 4  # steps: more tell by their ends how fast arguments change
DEPTH, DIVIDED, MOST = 8, 4, 20_000  # of the division of steps: how often, into how many, in all
ROUNDS, PARTS = 12, 16  # of the search for the least of an argument
HALVINGS = 44  # of a step towards it
LIMIT, ROUND_OFF = 10.0, 1e-13  # tolerances by which a step may differ; and its round-off


class Arguments(NamedTuple):
    """The ``kinds`` of operations with scales of their own, "largest", "jump", "steep" or "ratio",
    and the ``formula`` of their arguments, each as two numbers to be subtracted.
    """

    kinds: tuple
    formula: Compiled


def narrow_arguments(traced):
    """The :class:`Arguments` in the rates; None if there are none."""
    steps, depends = varying(traced), {}
    for s in steps:
        below = [depends.get(a.number, set()) for a in s.args if isinstance(a, Step)]
        depends[s.number] = {s.args[0]} if s.op == "argument" else set().union(*below)
    found = [pair for s in steps for pair in _scaled(s, depends)]
    if not found:
        return None
    rhs, leaves = traced.rhs, [x for _, pair in found for x in pair]
    formula = Compiled("arguments", rhs.parameters, rhs.trace, leaves)
    return Arguments(tuple(kind for kind, _ in found), formula)


def _scaled(s, depends):
    """The arguments of one step, pairs (kind, (a, b)) for the argument a - b."""
    if s.op in COMPARISONS:
        yield "jump", tuple(s.args)
    elif s.op == "abs":
        yield "jump", (s.args[0], 0.0)
    elif s.op in STEEP:
        yield "steep", (s.args[0], 0.0)
    elif s.op in GROWING:
        yield "largest", (s.args[-1], 0.0)
    elif s.op in ("/", "sqrt", "**"):
        for factor in factors(s.args[s.op == "/"]):
            if depends.get(factor.number) and _with_squares(factor, depends):
                yield "ratio", (factor, 0.0)


def _with_squares(s, depends):
    """True for a sum with a constant that may be about zero without being zero, as 1 + x*x."""

    def varies(x):
        return isinstance(x, Step) and bool(depends.get(x.number))

    def below(x):
        return [x, *(y for a in x.args for y in below(a))] if varies(x) else []

    def constant(x):
        return not varies(x) or (x.op in ("+", "-") and any(map(constant, x.args)))

    def square(x):
        return x.op in ("**", "exp", "pow") or (x.op == "*" and all(map(varies, x.args)))

    steps = below(s)
    periodic = any(x.op in ("sin", "cos") for x in steps)
    return s.op in ("+", "-") and constant(s) and any(map(square, steps)) and not periodic


# -- along a trajectory


class Passage(NamedTuple):
    """The ``number`` of a step that does not see all of the rates, the ``time`` at which it differs
    most from their integral, and by how much, relative to the scales of the states.
    """

    number: int
    time: float
    size: float


def passage(stepper, first):
    """The first :class:`Passage` in the steps from number ``first`` on, or None."""
    import numpy as np

    # the same steps again, as of the same call
    clear = vars(stepper.system).setdefault("_clear", {})
    key, steps = stepper.tolerance, (first, stepper.start, stepper.t, stepper.x)
    if clear.get(key) == steps:
        return None
    with np.errstate(all="ignore"):
        path = _Path(np, stepper, first)
        brackets = [] if _quiet(np, path) else _brackets(np, path)
        if not brackets:
            if not first:
                clear[key] = steps
            return None
        stepper = stepper.dense
        times = np.array([_located(np, stepper, *bracket) for bracket in brackets])
        ends = np.array(stepper.step_times)
        numbers = np.clip(np.searchsorted(ends, times, side="right") - 1, first, len(ends) - 2)
        for n in np.unique(numbers).tolist():
            when, size = _difference(stepper, n, times[numbers == n].tolist())
            if size > 0:
                return Passage(n, when, size)
    return None


class _Path:
    """The way from step ``first`` on in parts between the times ``ends``: the steps, with cubic
    polynomials in them, or where the method does not keep its steps parts of them.
    """

    def __init__(self, np, stepper, first):
        self.np, self.stepper, ends = np, stepper, stepper.step_times[first:]
        self.kinds, size = stepper.system.traced.narrow.kinds, len(stepper.x)
        self.x = None
        if stepper.steps:
            self.ends = np.array(ends)
            self.x = np.array([*(s[-size:] for s in stepper.steps[first:]), stepper.x]).T
        else:
            count = len(ends) - 1
            places = np.linspace(0, count, 2 * max(count, stepper.taken) + 1)
            self.ends = np.interp(places, np.arange(count + 1), ends)
        self.lengths = np.diff(self.ends)
        # True if the ends are not those of steps, or a step next to them has missed something
        self.closely = self.x is None or stepper.repeated

    @cached_property
    def changes(self):
        """The rates at the ends."""
        return _rates(self.stepper, self.ends, self.x)

    def arguments(self, n, u):
        """The arguments at the fractions u of the parts of numbers n, an array (arguments, u)."""
        times = self.ends[n] + u * self.lengths[n]
        return _values(self.stepper, times, self._states(n, u, times))

    def _states(self, n, u, times):
        np = self.np
        if self.x is None:
            inside = np.clip(times, self.ends[0], self.ends[-1])
            at, place = np.unique(inside, return_inverse=True)
            return self.stepper.states(at)[:, place]
        a, b, h = self.x[:, n], self.x[:, n + 1], self.lengths[n]
        return _cubic(a, b, h * self.changes[:, n], h * self.changes[:, n + 1], u)


def _cubic(a, b, k, m, u):
    """The polynomial with the values a, b and the slopes k, m at 0 and 1."""
    d = b - a
    return a + u * (k + u * (3 * d - 2 * k - m + u * (k + m - 2 * d)))


def _brackets(np, path):
    """Triples (number of an argument, times between which it is at its narrow place)."""
    n, low = np.arange(len(path.lengths)), np.zeros(len(path.lengths))
    found, width = [], 1.0
    for depth in range(DEPTH):
        u = low + width * np.array(NODES)[:, None]
        rows = path.arguments(np.tile(n, len(NODES)), u.reshape(-1))
        rows = rows.reshape(len(path.kinds), len(NODES), len(n))
        parts = depth > 0 or path.closely
        j, c, cubic, off = _turning(np, path.kinds, rows, parts)
        if not len(j):
            break
        u, values = _samples(np, *cubic)
        narrow, rough = _judged(np, np.array(path.kinds)[j], values, off, n[c], parts)
        for row in np.flatnonzero(narrow & ~rough).tolist():
            begin, length = path.ends[n[c[row]]], path.lengths[n[c[row]]]
            for edges in _about(np, path.kinds[j[row]], u[row], values[row]):
                times = begin + length * (low[c[row]] + width * edges)
                found.append((int(j[row]), *times.tolist()))
        again = np.unique(c[rough])
        if DIVIDED * len(again) > MOST:
            break
        width /= DIVIDED
        parts = low[again] + width * np.arange(DIVIDED)[:, None]
        n, low = np.tile(n[again], DIVIDED), parts.reshape(-1)
    return found


def _quiet(np, path):
    """True if no argument changes by much in a step, by its values at the ends of the steps."""
    if path.closely or len(path.lengths) < FEW:
        return False
    rows = _values(path.stepper, path.ends, path.x)
    slopes = np.diff(rows) / path.lengths
    # at the beginning and at the end of a step as in the steps next to it
    k, m = np.empty_like(slopes), np.empty_like(slopes)
    k[:, 0], k[:, 1:], m[:, -1], m[:, :-1] = (
        slopes[:, 0],
        slopes[:, :-1],
        slopes[:, -1],
        slopes[:, 1:],
    )
    cubic = rows[:, :-1], rows[:, 1:], k * path.lengths, m * path.lengths
    return not _much(np, path.kinds, cubic, False).any()


def _much(np, kinds, cubic, divided):
    """Whether each argument changes by much in each part, an array (arguments, parts).

    cubic : the values of the arguments and their slopes at both ends of each part
    """
    a, b, k, m = cubic
    jump, relative = _of(np, kinds, "jump"), _of(np, kinds, "jump", "ratio")
    low = np.minimum(abs(a), abs(b))
    sizes = RATIO[1] * np.maximum(abs(a), abs(b)) if divided else 2 * low
    much = ~(abs(k) + abs(m) + abs(b - a) <= np.where(relative, sizes, 2 * CHANGE[divided]))
    if jump.any() and not divided:  # where the rates jump once in a step, its end shows it
        often = (jump & (a * b <= 0)).sum(axis=0) > 1
        much &= ~jump | often | (k * m <= 0)
    return much


def _turning(np, kinds, rows, divided):
    """The arguments, and the parts of steps, in which one changes by much and may turn or change
    its sign; their values and slopes at both ends, and by how much they are not cubic polynomials.
    """
    a, b = rows[:, 0], rows[:, -1]
    k, m = (rows[:, 1] - a) / NODES[1], (b - rows[:, -2]) / NODES[1]
    much = _much(np, kinds, (a, b, k, m), divided)
    if not much.any():
        return [], [], [], []
    inside = np.array(NODES[2:-2])[:, None]
    cubic = _cubic(*(x[:, None] for x in (a, b, k, m)), inside)
    off = abs(rows[:, 2:-2] - cubic).max(axis=1) - NOISE * abs(rows).max(axis=1)
    slowest = np.minimum(np.minimum(abs(k), abs(m)), abs(b - a))
    steady = (k * m > 0) & (k * (b - a) > 0) & (slowest > STEADY * off)
    steady &= (a * b > 0) | _of(np, kinds, "largest")
    j, c = np.nonzero(~steady & much & np.isfinite(off))
    return j, c, [x[j, c][:, None] for x in (a, b, k, m)], off[j, c]


def _of(np, kinds, *chosen):
    """For each argument whether it is of one of these kinds, a column."""
    return np.array([[kind in chosen] for kind in kinds])


def _samples(np, a, b, k, m):
    """Fractions of parts, with those at which a polynomial turns, and its values there."""
    d = b - a
    first, second = 3 * d - 2 * k - m, 3 * (k + m - 2 * d)
    q = -(first + np.where(first < 0, -1.0, 1.0) * np.sqrt(first * first - second * k))
    turns = np.hstack([q / second, k / q])
    turns = np.clip(np.where(np.isfinite(turns), turns, 0.0), 0.0, 1.0)
    grid = np.tile(np.linspace(0, 1, SAMPLES + 1), (len(a), 1))
    u = np.sort(np.hstack([grid, turns]))
    return u, _cubic(a, b, k, m, u)


def _judged(np, kinds, values, off, steps, divided):
    """For each of these arguments: whether it changes fast in its part, and whether its polynomial
    cannot tell.

    divided : True for parts of steps, whose ends no stage of the method has seen: less counts
    """
    change, ratio = CHANGE[divided], RATIO[divided]
    level = np.where((kinds == "largest")[:, None], -values, abs(values))
    crossed = (np.diff(np.sign(values), axis=1) != 0).sum(axis=1)
    least, lower = level.min(axis=1), np.minimum(level[:, 0], level[:, -1])
    beside = np.maximum(level[:, 0], level[:, -1]) if divided else lower
    least[(crossed > 0) & (kinds != "largest")] = 0.0
    jumps = np.bincount(steps, crossed * (kinds == "jump"))[steps]
    of_kind = [kinds == "jump", kinds == "ratio"]
    known = [ROUGH * np.ptp(values, axis=1), ROUGH * lower]
    narrow = [(jumps > 1 - divided) & (crossed > 0), least < ratio * beside]
    drop = beside - least
    rough = off > np.select(of_kind, known, ROUGH * np.maximum(lower - least, change))
    return np.select(of_kind, narrow, drop > change), rough


def _about(np, kind, u, values):
    """Between which fractions of a part an argument is looked for, each an array of two."""
    if kind != "jump":
        return [np.array([0.0, 1.0])]
    places = np.flatnonzero(np.diff(np.sign(values))).tolist()
    return [u[[max(k - 1, 0), min(k + 2, len(u) - 1)]] for k in places]


def _values(stepper, times, x):
    """The arguments at some times, rows of an array."""
    import numpy as np

    rows = stepper.system.traced.narrow.formula.on(np)(times, *x, *stepper.system.p)
    rows = _array(np, rows, len(times))
    return rows[::2] - rows[1::2]


def _array(np, rows, count):
    """An array (rows, count); a row may be a number."""
    out = np.empty((len(rows), count))
    for n, row in enumerate(rows):
        out[n] = row
    return out


def _rates(stepper, times, x):
    import numpy as np

    system = stepper.system
    return _array(np, system.traced.folded[0].on(np)(times, *x, *system.constants), len(times))


def _located(np, stepper, j, low, high):
    """The time between these at which an argument is least; the middle if it has one sign although
    its operation jumps: a stage of the interpolation has met what the step has not.
    """
    kind, signs, middle = stepper.system.traced.narrow.kinds[j], set(), (low + high) / 2
    for _ in range(ROUNDS):
        times = np.linspace(low, high, PARTS + 1)
        values = _values(stepper, times, stepper.states(times))[j]
        signs |= set(np.sign(values).tolist())
        k = int((-values if kind == "largest" else abs(values)).argmin())
        low, high = times[max(k - 1, 0)], times[min(k + 1, PARTS)]
    return middle if kind == "jump" and len(signs) < 2 else float(times[k])


def _difference(stepper, n, centres):
    """How far step ``n`` is from the integral of the rates along it: the time of the largest
    difference and, relative to the scales, its size; 0 if it is as small as the tolerance allows.
    """
    import numpy as np

    a, b = stepper.step_times[n], stepper.step_end(n)
    reach = (b - a) * 0.5 ** np.arange(1, HALVINGS)
    edges = np.concatenate([[a, b], *([t, *(t - reach), *(t + reach)] for t in centres)])
    edges = np.unique(edges[(edges >= a) & (edges <= b)])
    nodes, weights = _gauss()
    widths = np.diff(edges)[:, None]
    times = (edges[:-1, None] + widths * nodes).reshape(-1)
    rates = _rates(stepper, times, stepper.interpolate(n, times))
    rates = rates.reshape(len(rates), len(widths), -1)
    made = (rates * weights).sum(axis=2) * widths[:, 0]
    apart = np.nan_to_num(made - np.diff(stepper.interpolate(n, edges), axis=1))
    scales = np.array([s or 1.0 for s in stepper.scales])
    limits = stepper.tolerance * (LIMIT if stepper.resumable else 1.0) * scales + ROUND_OFF * scales
    limits += stepper.noise
    sizes = abs(apart.cumsum(axis=1)).max(axis=1)
    if not (sizes > limits).any():
        return a, 0.0
    worst = int((abs(apart) / scales[:, None]).max(axis=0).argmax())
    return float(edges[worst : worst + 2].mean()), float((sizes / scales).max())


@cache
def _gauss():
    """Nodes and weights of Gauss's rule of order 8 on (0, 1)."""
    import numpy as np

    nodes, weights = np.polynomial.legendre.leggauss(4)
    return (1 + nodes) / 2, weights / 2
