"""Cases in processes of their own: nothing that ran for one case can help or hurt another, and a
call that hangs is ended.

Every case gets up to three processes, one after the other: one that finds its references, one that
judges it with heyoka, one without. They are forked from a server that has imported everything, so
that each starts in milliseconds.
"""

import multiprocessing
import sys
import threading
import time
import warnings
from concurrent.futures import ThreadPoolExecutor, as_completed
from dataclasses import dataclass, field
from itertools import chain

from tests.honesty import judge
from tests.honesty.cases import draw
from tests.honesty.references import SECONDS as REFERENCE_SECONDS
from tests.honesty.references import NoReferenceError, reference

GRACE = 10.0  # seconds beyond the limit of a call after which its process is ended
RESTARTS = 3
LOOK = 0.5  # seconds between two looks whether to stop
OURS = "tests.honesty.judge", "tests.honesty.families", "tests.honesty.holdout"
PRELOADED = *OURS, "numpy", "scipy.integrate", "mpmath", "heyoka"


@dataclass(frozen=True)
class Plan:
    """What is done with each case.

    methods, tolerances : as in :func:`~tests.honesty.judge.runs_of`
    heyoka : "both", "with" or "without"; for "both" only ``auto`` is repeated without
    seconds : that one call may take; ``reference_seconds`` : that a reference may take; ``cache`` :
        the folder of the references
    changes : True to repeat calls and to run them in two threads
    """

    methods: tuple = ("auto", *judge.METHODS)
    tolerances: tuple = judge.TOLERANCES
    heyoka: str = "both"
    seconds: float = judge.SECONDS
    reference_seconds: float = REFERENCE_SECONDS
    cache: str = ""
    changes: bool = True


@dataclass
class CaseResult:
    """``runs``, ``changes``, condition and ways of references; ``dropped``: why there is none."""

    case: str
    runs: list = field(default_factory=list)
    changes: list = field(default_factory=list)
    condition: float = 0.0
    ways: tuple = ()
    dropped: str = ""


def results(cases, plan, jobs=2):
    """A :class:`CaseResult` a case as they are finished; who stops asking ends the processes."""
    stopped = threading.Event()
    with ThreadPoolExecutor(jobs) as pool:
        waiting = [pool.submit(run_case, case, plan, stopped) for case in cases]
        try:
            for finished in as_completed(waiting):
                yield finished.result()
        finally:
            stopped.set()
            pool.shutdown(cancel_futures=True)


def run_case(case, plan, stopped=None):
    """One case, in processes of its own, which are ended when the event ``stopped`` is set."""
    stopped = stopped or threading.Event()
    found, drawn = CaseResult("/".join(map(str, case))), draw(*case)
    patience = len(judge.members(drawn)) * plan.reference_seconds + GRACE
    for kind, *message in _messages(_reference_process, (case, plan), patience, stopped):
        if kind == "reference":
            condition, found.ways = message
            found.condition = max(found.condition, condition)
        elif kind == "dropped":
            (found.dropped,) = message
        else:
            found.dropped = "the process that looked for the reference did not end"
    if not found.dropped:
        for without in {"both": (False, True), "with": (False,), "without": (True,)}[plan.heyoka]:
            _judge_in_processes(case, drawn.tags, plan, without, found, stopped)
    return found


def _judge_in_processes(case, tags, plan, without, found, stopped):
    """All calls; after a process that hangs another goes on."""
    skipped, patience = [], plan.seconds + GRACE
    for _ in range(RESTARTS + 1):
        current = killed = None
        given = case, plan, without, tuple(skipped)
        for kind, *message in _messages(_judge_process, given, patience, stopped):
            if kind == "start":
                (current,) = message
                skipped.append(current)
            elif kind == "killed":
                killed = current
            else:
                (found.runs if kind == "run" else found.changes).extend(message)
        if killed is None or stopped.is_set():
            return
        if killed != "changes":
            outcome = {"outcome": "timeout", "words": "it had to be killed", "seconds": patience}
            found.runs.append(judge.Run(found.case, tags, *killed, **outcome))


def _messages(work, args, patience, stopped):
    """The messages of a process; the last is ("killed",) if it was silent for too long or died."""
    context = _context()
    ours, theirs = context.Pipe(duplex=False)
    process = context.Process(target=work, args=(*args, theirs), daemon=True)
    process.start()
    theirs.close()
    try:
        while (message := _received(ours, patience, stopped)) != ("done",):
            yield message
            if message == ("killed",):
                return
    finally:
        process.kill()
        process.join()
        ours.close()


def _received(pipe, patience, stopped):
    limit = time.monotonic() + patience
    while not pipe.poll(LOOK):
        if stopped.is_set() or time.monotonic() > limit:
            return ("killed",)
    try:
        return pipe.recv()
    except EOFError:
        return ("killed",)


def _context():
    if "forkserver" not in multiprocessing.get_all_start_methods():
        return multiprocessing.get_context("spawn")
    context = multiprocessing.get_context("forkserver")
    context.set_forkserver_preload(list(PRELOADED))
    return context


# -- in the process of a case


def _reference_process(case, plan, pipe):
    made = _drawn(case)
    try:
        for k in judge.members(made):
            truth = reference(made.member(k), plan.cache, plan.reference_seconds)
            pipe.send(("reference", truth.condition, truth.ways))
    except NoReferenceError as error:
        pipe.send(("dropped", str(error)))
    pipe.send(("done",))


def _drawn(case):
    import tests.honesty.families
    import tests.honesty.holdout  # noqa: F401

    return draw(*case)


def _judge_process(case, plan, without, skipped, pipe):
    made = _drawn(case)
    warnings.simplefilter("ignore")  # of SciPy, which repeats in words what its status says
    if without:
        sys.modules["heyoka"] = None  # what looks for it finds that it is not there
    truths = {k: reference(made.member(k), plan.cache) for k in judge.members(made)}
    aside = without and plan.heyoka == "both"
    methods = [m for m in plan.methods if m == "auto"] if aside else plan.methods
    first, unfit = {}, set()
    for call in judge.runs_of(made, methods, plan.tolerances, without):
        method, way, _ = call
        if call in skipped or method in unfit or (aside and "batch" in way and made.count == 1):
            continue
        pipe.send(("start", call))
        run = judge.judged(made, truths, *call, seconds=plan.seconds)
        if run.outcome == "unfit":
            unfit.add(method)
        else:
            pipe.send(("run", run))
        if call[:2] == ("auto", ""):
            first[run.rtol] = run.end, run.taken
    repeats = plan.changes and made.count == 1 and not without and "auto" in methods
    if repeats and "changes" not in skipped:
        pipe.send(("start", "changes"))
        changes = judge.repeated(made, truths[0], first), judge.in_two_threads(made, truths[0])
        for change in chain(*changes):
            pipe.send(("change", change))
    pipe.send(("done",))
