"""Run a case in every way that the engine offers, and compare each answer with the reference and
with its own error estimate.

:func:`runs_of` lists the ways, :func:`judged` takes one. :func:`repeated` and
:func:`in_two_threads` check whether an answer depends on what ran before or beside it.
"""

import math
import threading
from contextlib import suppress
from dataclasses import dataclass, replace
from decimal import Context, Decimal
from time import perf_counter

from newton_euler import integrate, prepare
from newton_euler.motion import METHODS, ModelError, UnfitError
from tests.honesty.limits import TimeUp, frequent_switches, limited
from tests.honesty.references import scales

TOLERANCES = (1e-3, 1e-6, 1e-9, 1e-12)
# the floor that the docstring of integrate states: no state is judged relative to less than this in
# its unit
UNIT = 1e-6
NOTHING = 1e-13  # of its natural size: a smaller state is mere round-off
GROSS = 10.0  # times what was asked for and estimated: beyond this an answer is silently wrong
EPS = 2.0**-53
DIGITS = Context(prec=60)  # more digits than a reference has
LAX = 1e3  # times the round-off of the start: an error that any sound method can reach
SECONDS = 4.0  # the limit for one run
BATCHES = (3, 64)
BESIDE = 1.003  # times the start: where the run before a prepared one begins
REPEATS, REPEAT_SECONDS = 40, 0.7  # `auto` may take another method after half a second
THREAD_RUNS = 40

PREPARED, SAMPLES, WITHOUT = "prepared", "samples", "without heyoka"
RETURNED = ("met", "missed")


@dataclass(frozen=True)
class Run:
    """One call and its outcome.

    case, tags, method, way, rtol : what was asked for; ``way`` is "" for a plain ``integrate``,
        else "prepared", "samples", "batch of 3", ...
    taken : the name of the method that was taken, or of the exception; ``end`` : the last state
    outcome : "met" or "missed", where it returned; "refused" in words of the engine; "raw", another
        exception; "timeout", not within the limit
    error : the true error of the end, see :func:`true_error`; ``unitless`` : the same without a
        floor in units; ``inside`` : the worst on the way
    estimate : the error estimate that came with it, or None
    needless : True for a refusal by ``auto`` of an error that floats can reach easily, see
        :func:`reachable`
    seconds, words : of the call; the words of an exception or of what is wrong
    """

    case: str
    tags: tuple
    method: str
    way: str
    rtol: float
    taken: str = ""
    end: tuple = ()
    outcome: str = ""
    error: float = math.nan
    unitless: float = math.nan
    inside: float = math.nan
    estimate: float | None = None
    needless: bool = False
    seconds: float = 0.0
    words: str = ""

    @property
    def row(self):
        """The name of the run's row in the table."""
        return f"{self.method}, {self.way}" if self.way else self.method

    @property
    def returned(self):
        """True if the call gave an answer."""
        return self.outcome in RETURNED

    @property
    def covers(self):
        """Whether the estimate is not below the true error; None without an estimate or answer."""
        return None if not self.returned or self.estimate is None else self.estimate >= self.error

    @property
    def ratio(self):
        """The estimate over the true error, known to half a unit of the last place."""
        return None if self.covers is None else self.estimate / max(self.error, EPS)

    @property
    def silent(self):
        """True if the answer is wrong by more than ten times what was asked for and estimated."""
        return self.returned and self.error > GROSS * max(self.rtol, self.estimate or 0.0)


# -- the true error


def true_error(state, true, sizes, natural, unit=UNIT):
    """The error of a state: the largest difference of one of its numbers from the truth, over the
    largest size of that number on the way.

    No size is smaller than ``unit``, 1e-6 in its unit, as ``integrate`` says; nor, where it is no
    more than the round-off of the natural size that its coupling to the others gives it, than a
    thousandth of that (:func:`~tests.honesty.references.scales`): a rate of nutation that is zero
    cannot be known relative to nothing. With ``unit=0`` only the latter remains, and the error is
    the same in metres and in parsecs.

    state : floats; true : decimal numbers as text. inf if a number is not finite.

    >>> true_error((1.001, 1e-12), ("1.0", "0.0"), (2.0, 0.0), (2.0, 1.0))  # of 2.0, and of 0.001
    0.0004999999999999449
    """
    if len(state) != len(true) or not all(map(math.isfinite, state)):
        return math.inf
    known = [
        s if s > NOTHING * n else k
        for s, n, k in zip(sizes, natural, scales(sizes, natural), strict=True)
    ]
    differences = (_difference(x, y) for x, y in zip(state, true, strict=True))
    return max(d / max(s, unit) if d else 0.0 for d, s in zip(differences, known, strict=True))


def _difference(x, y):
    """|x - y| of floats or of decimal numbers as text, however small."""
    return abs(float(DIGITS.subtract(Decimal(x), Decimal(y))))


def events_error(found, truth, rtol, t0=0.0):
    """The error of the events: of the time of each over the whole time, times its weight; inf if
    there are more or fewer.

    found : (number, time) of each, in order; truth : the reference; where two events are so close
        that an error of ``rtol`` may join them, 0; t0 : the time of the start
    """
    if truth.margin < GROSS * rtol:
        return 0.0
    if [n for n, _ in found] != [n for n, *_ in truth.events]:
        return math.inf
    span = _difference(truth.times[-1], t0) if truth.times else 1.0
    both = zip(found, truth.events, strict=True)
    off = [w * _difference(t, true) / span for (_, t), (_, true, w) in both]
    return max(off, default=0.0)


def reachable(truth, rtol):
    """True if a sound method in floats reaches this error by far."""
    return truth.condition * EPS * LAX < rtol


# -- the ways to ask


def runs_of(case, methods=("auto", *METHODS), tolerances=TOLERANCES, without=False):
    """All calls for a case: pairs of method and way, each at all tolerances, as tuples (method,
    way, rtol); ``auto`` comes first.

    without : True in a process in which heyoka cannot be imported: the ways are then called so
    """
    if case.count > 1:
        batch = "batch of 64" if case.count >= 64 else "batch of 3"
        ways = [(m, batch) for m in methods if m in ("auto", "taylor", "dop853")]
    else:
        ways = [(m, "") for m in methods]
        ways += [(m, SAMPLES) for m in methods if m in ("auto", "taylor")]
        if not case.events:
            ways += [(m, PREPARED) for m in methods if m in ("auto", "taylor") and not case.t0]
            ways += [(m, f"batch of {n}") for m in methods if m == "auto" for n in BATCHES]
    if without:
        ways = [(m, f"{way}, {WITHOUT}" if way else WITHOUT) for m, way in ways]
    ways.sort(key=lambda w: w[0] != "auto" or bool(w[1].removesuffix(WITHOUT)))
    return [(m, way, rtol) for m, way in ways for rtol in tolerances]


def members(case):
    """The numbers of the motions that are judged."""
    n = case.count
    return [0] if n == 1 else sorted({0, 1, n // 2, n - 1})


def judged(case, truths, method, way, rtol, seconds=SECONDS, integrate=integrate, prepare=prepare):
    """The :class:`Run` of one call.

    truths : the references of the members that are looked at, by their numbers; of a single motion
        {0: reference}
    """
    asked = Run(case.name, case.tags, method, way, rtol)
    begun = perf_counter()

    def without_answer(outcome, taken, words, needless=False):
        asked_in_vain = replace(asked, outcome=outcome, taken=taken, words=words)
        return replace(asked_in_vain, needless=needless, seconds=perf_counter() - begun)

    try:
        with limited(seconds):
            answers, taken = _asked(case, truths, method, way, rtol, integrate, prepare)
            passed = perf_counter() - begun
    except TimeUp:
        return without_answer("timeout", "timeout", f"no answer in {seconds:g} s")
    except ModelError as error:
        needless = method == "auto" and all(reachable(truth, rtol) for truth in truths.values())
        outcome = "unfit" if isinstance(error, UnfitError) else "refused"
        return without_answer(outcome, type(error).__name__, str(error), needless)
    except Exception as error:  # a user would meet any of them
        name = type(error).__name__
        return without_answer("raw", name, f"{name}: {error}")
    runs = [_compared(case, truths[k], *answer, asked) for k, answer in answers.items()]
    return replace(max(runs, key=lambda run: run.error), taken=taken, seconds=passed)


def _compared(case, truth, end, estimate, inside, found, asked):
    """One motion against its reference."""
    rtol, found_none = asked.rtol, {"error": math.inf, "unitless": math.inf}
    given = replace(asked, outcome="missed", estimate=estimate, end=end)
    if case.singular:
        return replace(given, words="there is no motion at that time", **found_none)
    about = truth.sizes, truth.natural
    error, unitless = (true_error(end, truth.states[-1], *about, unit) for unit in (UNIT, 0.0))
    words = f"end {end!r}, true {tuple(map(float, truth.states[-1]))!r}"
    if found is not None:
        times = events_error(found, truth, rtol, case.t0)
        error, unitless = max(error, times), max(unitless, times)
        if times == math.inf:
            words = f"{len(found)} events of {len(truth.events)}"
    rows = zip(inside or (), truth.states[:-1], strict=False)
    worst = max((true_error(row, true, *about) for row, true in rows), default=math.nan)
    outcome = "met" if error <= rtol else "missed"
    measured = {"error": error, "unitless": unitless, "inside": worst}
    return replace(given, outcome=outcome, words=words, **measured)


def _asked(case, truths, method, way, rtol, integrate, prepare):
    """The answers by member, (end, estimate, states inside, events), and the method's name."""
    way = way.removesuffix(WITHOUT).removesuffix(", ")
    if way == PREPARED:
        run = prepare(case.model, rtol, method)
        with suppress(ModelError):  # this run may vouch for the one asked for
            run(case.t_end, tuple(x * BESIDE for x in case.start))
        return {0: (tuple(run(case.t_end, case.start)), None, None, None)}, method
    if way.startswith("batch"):
        return _batch(case, truths, method, int(way.rpartition(" ")[2]), rtol, integrate)
    samples = case.times if way == SAMPLES else None
    motion = integrate(case.model, case.span, case.start, rtol, method, case.events, samples)
    estimate = float(motion.error)
    times = [t for t in case.times[:-1] if case.t0 <= t <= motion.t_end]
    states = motion.states if samples else motion.at(times) if times else {}
    rows = list(zip(*(x.tolist() for x in states.values()), strict=True))[: len(times)]
    named = [e.name or f"event {n + 1}" for n, e in enumerate(case.events)]
    found = [(named.index(e.name), e.t) for e in motion.events] if named else None
    answer = tuple(motion.end.values()), None if math.isnan(estimate) else estimate, rows, found
    return {0: answer}, motion.method.name


def _batch(case, truths, method, count, rtol, integrate):
    """A motion among others 1 % away, as first, middle and last; or a case's own many."""
    import numpy as np

    if case.count > 1:
        start, places = case.start, {k: k for k in truths}
    else:
        spread, same = np.linspace(-0.01, 0.01, count), (0, count // 2, count - 1)
        spread[list(same)] = 0.0
        if {"singular", "near-singular"} & set(case.tags):
            spread[:] = 0.0
        start, places = tuple(x * (1 + spread) for x in case.start), dict.fromkeys(same, 0)
    motions = integrate(case.model, case.span, start, rtol, method)
    answers = {}
    for place, k in places.items():
        end = tuple(float(x[place, -1]) for x in motions.states.values())
        estimate = None if motions.error is None else float(np.asarray(motions.error)[place])
        if k not in answers or not _same(answers[k][0], end):
            answers[k] = _worse(answers.get(k), (end, estimate, None, None), truths[k])
    return answers, motions.method.name


def _worse(a, b, truth):
    if a is None or not truth.states:
        return b
    about = truth.states[-1], truth.sizes, truth.natural
    return max(a, b, key=lambda answer: true_error(answer[0], *about))


def _same(a, b):
    return len(a) == len(b) and all(
        x == y or (x != x and y != y) for x, y in zip(a, b, strict=True)
    )


# -- whether it depends on what ran before or beside it


@dataclass(frozen=True)
class Change:
    """A call that gave another answer than before: the ``case``, how it was asked, how many
    ``answers`` of ``calls`` differ from the first.

    moved : by how much, relative to the sizes; ``methods`` : the names of those that were taken
    """

    case: str
    way: str
    rtol: float
    answers: int
    calls: int
    moved: float
    methods: tuple

    @property
    def gross(self):
        """True if they differ by more than twice what was asked for."""
        return self.moved > 2 * self.rtol


def repeated(case, truth, first, calls=REPEATS, seconds=REPEAT_SECONDS, integrate=integrate):
    """The same calls again and again, for so many seconds: a :class:`Change` for each tolerance.

    first : by tolerance the last state and the method of the first call of all
    """
    for rtol, before in first.items():
        found, begun = [before], perf_counter()
        while len(found) < 2 or (
            len(found) <= calls and perf_counter() - begun < seconds / len(first)
        ):
            found.append(answer(case, rtol, integrate))
        found = [pair for pair in found if pair[1] != "timeout"]  # which is not an answer
        if len(found) < 2:
            continue
        ends, methods = zip(*found, strict=True)
        yield _change(case, truth, "repeated", rtol, ends, methods)


def answer(case, rtol, integrate=integrate):
    """The last state and the method by ``auto``; an exception is an answer too."""
    try:
        with limited(SECONDS):
            motion = integrate(case.model, case.span, case.start, rtol, events=case.events)
    except TimeUp:
        return (), "timeout"
    except Exception as error:
        return (), type(error).__name__
    return tuple(motion.end.values()), motion.method.name


def _change(case, truth, way, rtol, answers, methods):
    first, *rest = answers
    others = [a for a in rest if not _same(a, first)]
    finite = truth.sizes and all(map(math.isfinite, first))

    def moved(a):
        if not finite or len(a) != len(first):
            return math.inf
        return true_error(a, first, truth.sizes, truth.natural)

    worst = max(map(moved, others), default=0.0)
    taken = tuple(dict.fromkeys(methods))
    return Change(case.name, way, rtol, len(others), len(answers), worst, taken)


def in_two_threads(
    case, truth, rtol=1e-9, calls=THREAD_RUNS, seconds=1.0, prepare=prepare, integrate=integrate
):
    """Answers that differ from those of each thread alone: a :class:`Change` a way to ask."""
    other = tuple(x * (1 + 2.0**-10) for x in case.start)
    motion = lambda start: integrate(case.model, case.span, start, rtol, events=case.events)
    ways = {
        "prepared, two threads": _by_prepare(case, rtol, prepare),
        "two threads": lambda start: tuple(motion(start).end.values()),
    }
    for way, ask in ways.items():
        found = ask and _threads(case, truth, way, rtol, calls, seconds, ask, other)
        if found:
            yield found


def _by_prepare(case, rtol, prepare):
    if case.t0 or case.events:
        return None
    try:
        run = prepare(case.model, rtol)
    except ModelError:
        return None
    return lambda start: tuple(run(case.t_end, start))


def _threads(case, truth, way, rtol, calls, seconds, ask, other):
    def asked(start):
        try:
            return ask(start)
        # an answer as well: it must be the same alone and beside another
        except Exception as error:
            return (type(error).__name__,)

    starts = case.start, other
    try:
        with limited(SECONDS):
            alone = [asked(s) for s in starts]  # they may compile, and take another method
            begun = perf_counter()
            alone = [asked(s) for s in starts]
    except TimeUp:
        return None
    calls = max(2, min(calls, int(seconds / (perf_counter() - begun + 1e-9))))
    found = ([], [])
    barrier = threading.Barrier(2)

    def work(n):
        barrier.wait()
        for _ in range(calls):
            found[n].append(asked(starts[n]))

    threads = [threading.Thread(target=work, args=(n,)) for n in range(2)]
    with frequent_switches():
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
    wrong, moved = 0, 0.0
    for first, rest in zip(alone, found, strict=True):
        if first and type(first[0]) is float:
            change = _change(case, truth, way, rtol, [first, *rest], ())
            wrong, moved = wrong + change.answers, max(moved, change.moved)
        else:  # a refusal
            wrong += sum(a != first for a in rest)
    return Change(case.name, way, rtol, wrong, 2 * calls, moved, ())
