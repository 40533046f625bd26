"""Structures of the rates that a step passes over without seeing them: a brake of some centimetres
on a path of some metres, a blow of some milliseconds.

The rates change fast where the argument of an operation with a scale of its own is about zero or,
for ``exp``, largest: see :mod:`.narrow_arguments`. That time is found however narrow the structure
is, since the argument is smooth: in each step it is a polynomial whose extrema are known, or the
step is divided. Around it the rates are integrated along the trajectory, in pieces shorter by
powers of two, and compared with the change of the states.
"""

from functools import cache, partial
from itertools import pairwise
from math import ulp
from typing import NamedTuple

from ..algebra.late import np
from .chebyshev import DEGREE, extrema, values_at
from .methods.base import Stepper, rows_of
from .narrow_arguments import CHANGE, LIMITS, RATIO, Arguments
from .zeros import sampling

# the part of its change by which an argument may differ from a polynomial; and how many times that
# difference its extremum is from zero if it certainly does not reach zero
ROUGH, CLEAR, KNOWN = 0.2, 2.0, 1e-4
NOISE = 1e-14  # noise of an argument, relative to its largest value on the way
FEW, MANY = 4, 100  # steps: from FEW on their ends show fast changes; from MANY on NumPy is faster
FOLLOWED = 500  # the most suspect steps that are followed, the longest ones
RESOLVED = 6.0  # the most radians of a sine that a polynomial represents in one part
DEPTH, DIVIDED, MOST = 8, 4, 2000  # how often a step is divided, into how many parts, and in all
SAMPLES, NEWTON_STEPS = 32, 3  # samples of a step that find when it passes the places of a table
ROUNDS, PARTS = 12, 16  # rounds and parts of the search for the least value of an argument
HALVINGS = 44  # halvings of a step towards it
LIMIT, ROUND_OFF = 10.0, 1e-13  # tolerances by which a step may differ; and its round-off
# fraction of a part by which the ends of parts are moved off even places: an argument that turned
# back where two meet, as in the middle of a motion, would do so in neither
ASIDE = 0.0618
SHORT = 0.1  # time between two jumps, over the longest step, that may be passed over
UNEQUAL = 2  # the most distances at which a function that turns may have two signs
SLIGHT, HIT = 0.01, 40.0  # the least change that matters of an argument; the largest one of exp
NUDGE = 2.0**-51  # relative change of states and constants that changes rates by round-off only


class Passage(NamedTuple):
    """The ``number`` of a step that does not see all of the rates; ``stops``, the times to stop at
    when it is repeated; ``changes``, how much each state differs from the integral of its rate; how
    much of that may be ``noise`` of the rates; the largest ``size`` of these over the scales.
    """

    number: int
    stops: tuple
    changes: tuple
    noise: tuple
    size: float


def passage(stepper: Stepper, first: int) -> Passage | None:
    """The first :class:`Passage` in the steps from number ``first`` on, or None; ``stepper.near``
    are the times, with the numbers of the arguments, at which one turns back.
    """
    stepper.near = [pair for pair in stepper.near if pair[0] < stepper.step_times[first]]
    # asked again for the same steps
    clear = vars(stepper.system).setdefault("_clear", {})
    key, steps = stepper.tolerance, (first, stepper.start, stepper.t, stepper.x)
    if key in clear and clear[key][0] == steps:
        stepper.near = clear[key][1]
        return None
    arguments = stepper.system.traced.narrow
    plain = not (stepper.repeated or arguments.tables or arguments.powers)
    if plain and FEW <= len(stepper.steps) - first < MANY and _calm(stepper, arguments, first):
        return None
    with np.errstate(all="ignore"):
        times, knots, near = narrow_times(stepper, arguments, first)
        stepper.near += near
        if not len(times) and not len(knots):
            if not first:
                clear[key] = steps, stepper.near
            return None
        stepper = stepper.dense
        ends = np.array(stepper.step_times)
        of = [first + np.searchsorted(ends[first + 1 : -1], t, "right") for t in (times, knots)]
        for n in np.unique(np.concatenate(of)).tolist():
            found = _difference(stepper, n, times[of[0] == n], knots[of[1] == n])
            if found:
                return found
    return None


def _calm(stepper, arguments, first):
    """True if no step is suspect, as by :meth:`_Path.suspects`; faster for few steps."""
    f, p, size = arguments.formula.on_floats, stepper.system.p, len(stepper.x)
    times = stepper.step_times[first:]
    ends = [s[-size:] for s in stepper.steps[first:]]
    try:
        values = [f(t, *x, *p) for t, x in zip(times, [*ends, stepper.x], strict=True)]
    except (ArithmeticError, ValueError):
        return False
    lengths = [b - a for a, b in pairwise(times)]
    ratios = [y / x for x, y in pairwise(lengths)]
    columns, crossed = zip(*values, strict=True), 0
    for kind, a, b in zip(arguments.kinds, columns, columns, strict=False):
        row = [x - y for x, y in zip(a, b, strict=True)]
        d = [y - x for x, y in pairwise(row)]
        before = [d[0], *(x * r for x, r in zip(d, ratios, strict=False))]
        after = [*(x / r for x, r in zip(d[1:], ratios, strict=True)), d[-1]]
        # nothing is known of the steps next to the first and the last one
        if row[0] * row[1] > 0:
            before[0] = -after[0]
        if row[-1] * row[-2] > 0:
            after[-1] = -before[-1]
        limit = LIMITS[kind][0]
        crossed += kind == "jump" and min(row) <= 0 <= max(row)
        for x, y, k, change, m in zip(row, row[1:], before, d, after, strict=False):
            much = not abs(k) + abs(change) + abs(m) <= (limit or 2 * min(abs(x), abs(y)))
            turns = k * m <= 0 or (k * change < 0 and k * x < 0) or (m * change < 0 and m * y > 0)
            if much and (kind != "jump" or turns or crossed > 1):
                return False
    return True


def narrow_times(
    stepper: Stepper, arguments: Arguments, first: int
) -> "tuple[np.ndarray, np.ndarray, list[tuple[float, int]]]":
    """Two arrays of times: those at which one of the :class:`~.narrow_arguments.Arguments` passes
    its narrow place within a step, from number ``first`` on, or several places of a table in one
    step; and a list of pairs (time, number of an argument) where one is least but keeps its sign.
    """
    with np.errstate(all="ignore"):
        path = _Path(stepper, arguments, first)
        suspects = path.suspects()
        brackets, near = _brackets(path, suspects) if suspects.any() else ([], [])
        times, more = np.array([]), []
        if brackets:
            times, more = _located(stepper.dense, arguments, brackets)
        knots = [_knots(path, j, table.places) for j, table in arguments.tables.items()]
        near += [*more, *_inside(path)]
        return times, np.concatenate([*knots, times[:0]]), near


def _knots(path, j, places):
    """The times at which an argument passes these places, in the steps that pass more than one."""
    places, row = np.array(places, dtype=float), path.rows[j]
    rises = np.diff(row)
    turns = np.zeros(len(rises), bool)
    turns[:-1] |= rises[:-1] * rises[1:] < 0
    turns[1:] |= turns[:-1]
    n = np.flatnonzero((abs(np.diff(np.searchsorted(places, row))) > 1) | turns)
    if not len(n):
        return np.array([])
    times = path.ends[n, None] + path.lengths[n, None] * np.linspace(0, 1, SAMPLES + 1)
    values = path.arguments(times)[j]
    index = np.searchsorted(places, values)
    found = []
    for i, k in zip(*np.nonzero(np.diff(index, axis=1)), strict=True):
        (x, y), (t, u) = values[i, k : k + 2], times[i, k : k + 2]
        between = places[min(index[i, k : k + 2]) : max(index[i, k : k + 2])]
        found += [(p, t + (p - x) * (u - t) / (y - x), (y - x) / (u - t)) for p in between]
    if not found:
        return np.array([])
    place, t, slope = np.array(found).T
    for _ in range(NEWTON_STEPS):
        t = t - (path.arguments(t)[j] - place) / slope
    return t


def _inside(path):
    """Pairs (time, number of an argument) between two jumps that are close to each other."""
    near, ends = [], path.ends
    for j in np.flatnonzero(path.of.jumps[:, 0]).tolist():
        edges = np.flatnonzero(np.diff(np.sign(path.rows[j])))
        first, last = edges[:-1] + 1, edges[1:] + 1
        close = ends[last - 1] - ends[first] < SHORT * path.lengths.max()
        rows = (~close).cumsum()
        # many in a row: it slides along a jump, or chatters
        close &= np.bincount(rows[close], minlength=rows.max(initial=0) + 1)[rows] <= MANY
        for a, b in zip(first[close].tolist(), last[close].tolist(), strict=True):
            near.append((float(ends[a + abs(path.rows[j, a:b]).argmax()]), j))
    return near


class _Path:
    """The path from step ``first`` on in parts between the times ``ends``: the steps, or, where the
    method does not keep its steps, halves of them; ``x`` are the states there.
    """

    def __init__(self, stepper, arguments, first):
        self.stepper, self.of = stepper, arguments
        ends, size, kept = stepper.step_times[first:], len(stepper.x), bool(stepper.steps)
        if kept:
            self.ends = np.array(ends)
            self.x = np.empty((size, len(ends)))
            self.x[:, :-1] = np.array(stepper.steps[first:])[:, -size:].T
            self.x[:, -1] = stepper.x
        else:
            count = len(ends) - 1
            places = np.linspace(0, count, 2 * max(count, stepper.taken) + 1)
            places[1:-1] -= ASIDE * places[1]
            self.ends = np.interp(places, np.arange(count + 1), ends)
            self.x = stepper.states(self.ends)
        self.lengths = np.diff(self.ends)
        self.rows = _values(stepper, arguments, self.ends, self.x)
        # True if the ends are not those of steps, or one of them has missed something
        near = any(self.ends[0] <= t <= self.ends[-1] for t in stepper.stops)
        self.closely = not kept or (stepper.repeated and near)

    def suspects(self):
        """For each argument and part whether it may be narrow there, by its values at the ends."""
        of = self.of
        if len(self.lengths) < FEW:
            return np.full((len(of.kinds), len(self.lengths)), True)
        a, b = self.rows[:, :-1], self.rows[:, 1:]
        change = b - a
        slopes = change / self.lengths
        # the slopes at the ends of a step are those of the steps next to it
        k = np.concatenate([slopes[:, :1], slopes[:, :-1]], axis=1)
        m = np.concatenate([slopes[:, 1:], slopes[:, -1:]], axis=1)
        sizes = abs(a), abs(b)
        known = RATIO[1] * np.maximum(*sizes) if self.closely else 2 * np.minimum(*sizes)
        limits = of.limits[:, int(self.closely), None]
        limits = np.where(limits == 0, known, limits)
        much = ~((abs(k) + abs(m)) * self.lengths + abs(change) <= limits)
        if not self.closely and much.any():
            # where the rates jump once in a step, its end shows it
            crossed = of.jumps & (a * b <= 0)
            # towards zero at one end, or away from it, and on the whole the other way
            turns = (k * m <= 0) | ((k * change < 0) & (k * a < 0))
            turns |= (m * change < 0) & (m * b > 0)
            turns[:, [0, -1]] |= (a * b > 0)[:, [0, -1]]  # unknown there
            much &= ~of.jumps | (crossed.sum(axis=0) > 1) | turns
            much |= crossed & much.any(axis=0)
        return much | (much & of.phases).any(axis=0)

    def arguments(self, times):
        """The arguments at an array of times, an array (arguments, *of the times)."""
        flat = np.clip(times.reshape(-1), self.ends[0], self.ends[-1])
        rows = _values(self.stepper, self.of, flat, self.stepper.states(flat))
        return rows.reshape(-1, *times.shape)


def _brackets(path, suspects):
    """Triples (number of an argument, times between which it is at its narrow place); and pairs
    (time, number of an argument) where it turns back before that.
    """
    near = []
    points, transform = sampling()
    n = np.flatnonzero(suspects.any(axis=0))
    if len(n) > max(FOLLOWED, len(path.lengths) / 2):
        return [], []  # it sticks, and chatters in each step
    n = np.sort(n[np.argsort(path.lengths[n])[-FOLLOWED:]])
    suspects, low, width, found = suspects[:, n], np.zeros(len(n)), 1.0, []
    noise = NOISE * np.nan_to_num(abs(path.rows)).max(axis=1)
    for depth in range(DEPTH + 1):
        length = width * path.lengths[n]
        begin = path.ends[n] + path.lengths[n] * low
        rows = path.arguments(begin[:, None] + length[:, None] * points)
        j, c = np.nonzero(suspects & np.isfinite(rows).all(axis=2))
        values = rows[j, c]
        fits = values[:, : DEGREE + 1] @ transform
        off = abs(fits[:, DEGREE + 1 :] - values[:, DEGREE + 1 :]).max(axis=1)
        off = np.maximum(off, abs(fits[:, DEGREE - 1 : DEGREE + 1]).max(axis=1))
        off += noise[j]
        closely, kinds = depth > 0 or path.closely, path.of.names[j]
        u, v = _turns(fits[:, : DEGREE + 1])
        narrow, rough, turned = _judged(kinds, u, v, off, n[c], closely)
        rough &= np.ptp(v, axis=1) > CLEAR * noise[j]
        last = depth == DEPTH or DIVIDED * rough.sum() > MOST
        here = (narrow | rough) & (kinds != "phase") if last else narrow & ~rough
        for row in np.flatnonzero(here).tolist():
            for edges in [(0.0, 1.0)] if rough[row] else _about(kinds[row], u[row], v[row]):
                times = begin[c[row]] + length[c[row]] * np.array(edges)
                found.append((int(j[row]), *times.tolist()))
        level = np.where((kinds == "largest")[:, None], -v, abs(v))[:, 1:-1]
        for row in np.flatnonzero(narrow & ~rough & (kinds == "jump")).tolist():
            for before, after in pairwise(_about("jump", u[row], v[row])):
                place = (before[1] + after[0]) / 2
                near.append((float(begin[c[row]] + length[c[row]] * place), int(j[row])))
        for row in np.flatnonzero(~(narrow | rough) & turned & (kinds != "phase")).tolist():
            place = u[row, 1 + level[row].argmin()]
            near.append((float(begin[c[row]] + length[c[row]] * place), int(j[row])))
        if last or not rough.any():
            break
        again = np.zeros(suspects.shape, bool)
        again[j[rough], c[rough]] = True
        again |= (again & path.of.phases).any(axis=0)
        chosen, width = np.flatnonzero(again.any(axis=0)), width / DIVIDED
        low = (low[chosen] + width * np.arange(DIVIDED)[:, None]).reshape(-1)
        n, suspects = np.tile(n[chosen], DIVIDED), np.tile(again[:, chosen], DIVIDED)
    return found, near


def _turns(fits):
    """The ends and extrema of each polynomial, in order, filled up by ends; and its values."""
    row, x = extrema(fits)
    place = np.arange(len(row)) - np.searchsorted(row, row)
    u = np.ones((len(fits), 2 + place.max(initial=-1) + 1))
    u[:, 0] = -1.0
    u[row, 1 + place] = x
    rows = np.repeat(fits, u.shape[1], axis=0)
    return (1 + u) / 2, values_at(rows, u.reshape(-1)).reshape(u.shape)


def _judged(kinds, u, values, off, steps, divided):
    """For each of these arguments: whether it changes fast in its part, whether its polynomial
    cannot tell, and whether it turns back inside; ``u``, ``values`` as from :func:`_turns`. Less
    counts in ``divided`` steps, of whose ends no stage of the method has seen all.
    """
    change, ratio = CHANGE[divided], RATIO[divided]
    level = np.where((kinds == "largest")[:, None], -values, abs(values))
    turns = np.where(u[:, 1:-1] < 1, level[:, 1:-1], np.inf).min(axis=1, initial=np.inf)
    crossed = (np.diff(np.sign(values), axis=1) != 0).sum(axis=1) * (kinds != "largest")
    lower, upper = np.sort(level[:, [0, -1]]).T
    beside = upper if divided else lower
    least = np.where(crossed > 0, 0.0, np.minimum(turns, lower))
    size = np.ptp(values, axis=1)
    # at a kink the difference may be larger than where it is measured
    touched = turns < np.where(off > KNOWN * size, ROUGH * size, CLEAR * off)
    jumps = np.bincount(steps, (crossed + touched) * (kinds == "jump"))[steps]
    inside = (crossed > 0) | (turns < lower)
    of_kind = [kinds == "phase", kinds == "jump", kinds == "ratio"]
    narrow = [False, (jumps > 1 - divided) & (crossed > 0), inside & (least < ratio * beside)]
    rough = [size > RESOLVED, touched, off > ROUGH * lower]
    found = np.select(of_kind, narrow, inside & (beside - least > change))
    rough = np.select(of_kind, rough, off > ROUGH * np.maximum(lower - least, change))
    return found, rough, (crossed == 0) & (turns < lower)


def _about(kind, u, values):
    """The fractions of a part, pairs, between which an argument is at its narrow place."""
    crossed = np.flatnonzero(np.diff(np.sign(values)) != 0).tolist()
    if kind == "jump" or (crossed and kind != "largest"):
        return [(u[k], u[k + 1]) for k in crossed]
    level = -values if kind == "largest" else abs(values)
    inner = np.flatnonzero((level[1:-1] <= level[:-2]) & (level[1:-1] < level[2:])).tolist()
    return [(u[k], u[k + 2]) for k in inner] or [(0.0, 1.0)]


def _values(stepper, arguments, times, x):
    """The arguments at some times, rows of an array."""
    rows = rows_of(arguments.formula.on(np)(times, *x, *stepper.system.p), len(times))
    found = rows[::2] - rows[1::2]
    for j in arguments.powers:
        # about its largest value x**n is exp(n*log(x)), and this is n*log(x) but smooth at zero
        squares, n = rows[2 * j] ** 2, np.maximum(rows[2 * j + 1], 0.0)
        found[j] = n / 2 * (squares / (np.nanmax(squares) or 1.0) - 1.0)
    return found


def rates_along(
    stepper: Stepper, times: "np.ndarray", x: "np.ndarray", nudge: float = 0.0
) -> "np.ndarray":
    """The rates; ``nudge`` is a relative change, by turns up and down, of states and constants."""
    system = stepper.system
    numbers = [v * (1 + (nudge if k % 2 else -nudge)) for k, v in enumerate(system.constants)]
    moved = [v * (1 + (nudge if k % 2 else -nudge)) for k, v in enumerate(x)]
    return rows_of(system.traced.folded[0].on(np)(times, *moved, *numbers), len(times))


def _located(stepper, arguments, brackets):
    """The time in each of the brackets at which its argument is least; and a list of pairs (time,
    number of the argument) of those that do not change their sign there.
    """
    j, low, high = map(np.array, zip(*brackets, strict=True))
    ends, rows, largest = (low, high), np.arange(len(j)), (arguments.names[j] == "largest")[:, None]
    signs = []
    for _ in range(ROUNDS):
        times = np.linspace(low, high, PARTS + 1, axis=1)
        flat = times.reshape(-1)
        values = _values(stepper, arguments, flat, stepper.states(flat))
        values = values.reshape(-1, *times.shape)[j, rows]
        k = np.where(largest, -values, abs(values)).argmin(axis=1)
        signs.append(np.sign(values[:, [0, -1]]).T)
        low, high = times[rows, np.maximum(k - 1, 0)], times[rows, np.minimum(k + 1, PARTS)]
    times = times[rows, k]
    turns = largest[:, 0] | (np.ptp(np.concatenate(signs), axis=0) == 0)
    turns &= (ends[0] < times) & (times < ends[1])
    return times, list(zip(times[turns].tolist(), j[turns].tolist(), strict=True))


def _difference(stepper, n, centres, knots):
    """The :class:`Passage` by which step ``n`` differs from the integral of its rates, in pieces
    ever shorter about the ``centres`` that end at ``knots``; or None.
    """
    ends, states = (stepper.step_times[n], stepper.step_end(n)), partial(stepper.interpolate, n)
    edges, integrals = _along(stepper, ends, states, centres, knots)
    made, jumps = integrals()
    apart = np.nan_to_num(made - np.diff(stepper.interpolate(n, edges), axis=1))
    scales = np.array([s or 1.0 for s in stepper.scales])
    factor = LIMIT * (1.0 if len(centres) else LIMIT) if stepper.resumable else 1.0
    limits = (stepper.tolerance * factor + ROUND_OFF) * scales
    # the round-off of the time too
    limits += stepper.around * ulp(float(edges[-1])) * jumps + stepper.noise
    sizes = abs(apart.cumsum(axis=1)).max(axis=1)
    if not (sizes > limits).any():
        return None
    off = sum(abs(np.nan_to_num(integrals(x)[0] - made)).sum(axis=1) for x in (NUDGE, -NUDGE))
    if not (sizes > limits + off).any():  # no better by floats
        stepper.noise = tuple(np.maximum(stepper.noise, off).tolist())
        return None
    worst = int((abs(apart) / scales[:, None]).max(axis=0).argmax())
    stops = [*knots.tolist(), float(edges[worst : worst + 2].mean())]
    noise = tuple(np.maximum(stepper.noise, off).tolist())
    return Passage(n, tuple(stops), tuple(sizes.tolist()), noise, float((sizes / scales).max()))


def _along(stepper, ends, states, centres, knots=()):
    """The ends of the pieces between two times, see :func:`_difference`, and a function of a nudge,
    see :func:`rates_along`, and of a shift of each state: the integrals of the rates over each
    piece, and the largest difference of each rate.
    """
    a, b = ends
    reach = (b - a) * 0.5 ** np.arange(1, HALVINGS)
    edges = np.concatenate([[a, b], knots, *([t, *(t - reach), *(t + reach)] for t in centres)])
    edges = np.unique(edges[(edges >= a) & (edges <= b)])
    nodes, weights = _gauss()
    widths = np.diff(edges)[:, None]
    times = (edges[:-1, None] + widths * nodes).reshape(-1)
    x = states(times)

    def integrals(nudge=0.0, shift=0.0):
        rates = rates_along(stepper, times, x + shift, nudge).reshape(len(x), len(widths), -1)
        sums = (rates * weights).sum(axis=2) * widths[:, 0]
        return sums, np.ptp(rates.reshape(len(x), -1), axis=1)

    return edges, integrals


def within_reach(stepper: Stepper, error: float) -> float:
    """How far the steps of a run may be off, relative to the scales, because it passes something
    narrow at a distance below its error: a spot in the plane.

    Each state is moved in turn by up to its error so that the argument, as a parabola in it, comes
    closest to its place; then all of them by as much across the path, so that it is farther. The
    rates along the path moved so are integrated about that time.
    """
    if not stepper.near:
        return 0.0
    arguments, total = stepper.system.traced.narrow, 0.0
    times, j = map(np.array, zip(*stepper.near, strict=True))
    j, dense = j.astype(int), stepper.dense
    scales = np.array([s or 1.0 for s in stepper.scales])[:, None]
    begin, end, longest = dense.start[0], dense.t, np.diff(dense.step_times).max()
    with np.errstate(all="ignore"):
        beside = longest * 0.5 ** np.arange(HALVINGS)[:, None]
        beside = np.clip([times - beside, times + beside], begin, end).reshape(-1)
        values = _values(stepper, arguments, beside, dense.states(beside))
        values = np.sign(values.reshape(len(values), 2, -1, len(j))[j, :, :, np.arange(len(j))])
        kinds = arguments.names[j]
        # if the signs differ on both sides, it only seems to turn, by round-off
        turns = np.isin(kinds, ("largest", "ratio"))
        turns |= (values[:, 0] != values[:, 1]).sum(axis=1) <= UNEQUAL
        inside = (np.ptp(values, axis=(1, 2)) > 0) & (kinds == "jump")
        times, j, kinds, inside = times[turns], j[turns], kinds[turns], inside[turns]
        x, signs = dense.states(times), np.ones(len(times))

        def levels(shift):
            values = _values(stepper, arguments, times, x + shift)
            return signs * values[j, np.arange(len(j))]

        nothing = np.zeros_like(x)
        signs = np.where(kinds == "largest", -1.0, np.sign(levels(nothing)) * (1 - 2 * inside))
        first, least, closer, needed = levels(nothing), levels(nothing), nothing.copy(), []
        ways = error * scales * np.eye(len(x))[:, :, None]
        for way in ways:
            below, above = levels(closer - way), levels(closer + way)
            top = np.nan_to_num((below - above) / (2 * (below - 2 * least + above)))
            tried = [closer, closer - way, closer + way, closer + np.clip(top, -1, 1) * way]
            found = [least, below, above, levels(tried[3])]
            best = np.argmin(found, axis=0)
            needed.append(abs(below - least) + abs(above - least) > 0)
            closer, least = np.choose(best, tried), np.choose(best, found)
        along = needed * rates_along(dense, times, x) / scales
        along /= np.sqrt((along**2).sum(axis=0)) + 1e-300
        across = [way - error * scales * along * along[i] for i, way in enumerate(ways)]
        most = np.array([levels(way * needed[i]) for i, way in enumerate(across)])
        farther = np.take_along_axis(np.array(across), most.argmax(axis=0)[None, None], axis=0)[0]
        of_kind, limit = [kinds == "jump", kinds == "ratio"], SLIGHT * abs(first)
        hit = (first < HIT) & (kinds == "largest")
        nearer, across_it = first - least, most.max(axis=0) > first + limit
        much = [
            np.select(of_kind, [(least < 0) & ~inside, nearer > limit], nearer > SLIGHT),
            np.select(of_kind, [inside, True], hit) & across_it,
        ]
        for way, k in zip(*np.nonzero(much), strict=True):
            ends = max(begin, times[k] - longest), min(end, times[k] + longest)
            _, integrals = _along(dense, ends, dense.states, times[k : k + 1])
            apart = integrals(shift=(closer, farther)[way][:, k : k + 1])[0] - integrals()[0]
            off = float((abs(np.nan_to_num(apart).cumsum(axis=1)) / scales).max())
            total += off if off > LIMIT * error else 0.0
    return total


@cache
def _gauss():
    """Nodes and weights of Gauss's rule of order 8 on (0, 1)."""
    nodes, weights = np.polynomial.legendre.leggauss(4)
    return (1 + nodes) / 2, weights / 2
