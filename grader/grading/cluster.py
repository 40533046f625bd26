"""Grading a class on a Dask cluster.

The workers reach the course folder under the same path as the grader, on a shared file system, and
have the same version of the checkout installed. Whatever else a run needs, and what each submission
came to, is in that folder while it lasts, readable by its owner alone: what passes the scheduler
is the path of the folder, a fingerprint and numbers that stand for submissions. A worker does
everything for a submission but write the gradebook, which the grader does. When a worker dies, Dask
reassigns its submissions; when one hangs, the grader does.
"""

import atexit
import contextlib
import json
import pickle
import secrets
import shutil
import threading
import time
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path

from ..course import Course, CourseError, write_json
from ..course.files import write_bytes
from ..sandbox import RUN_SECONDS, Harvester, HarvestError
from .gradebook import Entry
from .records import fingerprint, run_state, score_state
from .student import GradingRun, Result

AHEAD = 4  # submissions per thread held by the scheduler at a time
ANSWER_SECONDS = 10  # limit for a scheduler to answer
READY_SECONDS = 60  # limit for a worker to import the grader and start its harvester
WATCH_SECONDS = 1  # between checks of the workers
SLACK = 2  # the whole of a worker's time for a submission, relative to the limits of its runs

PLAN = "plan.json"
KEPT = "grade again: finished runs are kept and not repeated"
NEW_WORKERS = "see their messages, and start others"
OTHERS = "and the others do its work"
END_IT = "end its process"
HUNG = "could not be graded: two workers hung on it. An earlier grade stays as it is"


# grades the students: {student: (result, what to write into the gradebook)}
GradeStudents = Callable[[Callable[[Result], object]], dict[str, tuple[Result, Entry | None]]]


@dataclass(frozen=True)
class SharedData:
    """Where workers find the data common to all submissions, and hashes that must equal their own;
    they write the results into ``folder``, which is in the course folder.
    """

    course: str
    folder: str
    code: str
    secret: str
    sandbox: bool


@contextlib.contextmanager
def cluster(
    address: str,
    course: Course,
    run: GradingRun,
    students: Sequence[str],
    sandbox: bool,
    report: Callable[[str], object] | None = None,
) -> Iterator[GradeStudents]:
    """A context with a function that grades on the workers of a scheduler; raises
    :class:`CourseError` if there is no answer or a worker cannot grade. ``report`` gets a line
    about each worker.
    """
    folder = course.path / "scores" / ".plan"
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(mode=0o700)
    common = {k: v for k, v in vars(run).items() if k not in ("course", "roster")}
    write_json(folder / PLAN, {"students": list(students), "common": common}, indent=None)
    plan = fingerprint(course.secret, (folder / PLAN).read_bytes())
    shared = SharedData(str(course.path), str(folder), _code(), plan, sandbox)
    try:
        with _connected(address) as client:
            threads, hung = _examined(client, address, shared, report)
            patience = SLACK * len(run.names) * RUN_SECONDS
            spread = _Spread(client, shared, threads, hung, patience, report)
            try:
                yield lambda progress: _graded(spread, run.roster, students, progress)
            finally:
                with contextlib.suppress(Exception):  # a dead worker needs no stopping
                    client.run(_stop, workers=list(spread.able()))
    finally:
        shutil.rmtree(folder)


def _code():
    return fingerprint(run_state(), score_state())


@contextlib.contextmanager
def _connected(address):
    try:
        from distributed import Client
    except ImportError as error:
        raise CourseError(
            "a cluster needs Dask: pip install -e '.[cluster]', here and for its workers"
        ) from error
    try:
        client = Client(address, timeout=ANSWER_SECONDS, set_as_default=False)
    except (OSError, ValueError) as error:
        raise CourseError(
            f"no scheduler of Dask answers at {address} ({error}); start one with: dask scheduler"
        ) from error
    with client, client.as_current():  # for functions without a client argument
        yield client


def _examined(client, address, shared, report):
    """(the number of threads of all workers, each of which must be able to grade, those that hang);
    those that die or hang are left out.
    """
    workers = client.nthreads()
    if not workers:
        raise CourseError(f"the cluster has no workers; start some with: dask worker {address}")
    asked = {w: client.submit(_examine, shared, workers=[w], pure=False) for w in sorted(workers)}
    threads, hung, until = 0, set(), time.monotonic() + READY_SECONDS
    for worker, future in asked.items():
        able, state = _answer(client, worker, future, until)
        if able is False:
            raise CourseError(f"the worker {worker} cannot grade: {state}")
        if able:
            threads += workers[worker]
            state = f"{workers[worker]} at a time, {state}"
        elif worker in _living(client):
            hung.add(worker)
        if report:
            report(f"{worker}: {state}")
    if not threads:
        raise CourseError(f"no worker of the cluster has passed its first check; {NEW_WORKERS}")
    return threads, hung


def _living(client):
    """The workers; none if the scheduler does not answer."""
    try:
        return client.nthreads()
    except OSError:
        return {}


def _answer(client, worker, future, until):
    """The result of :func:`_examine` on a worker, with None in place of True if it has died or
    does not answer.
    """
    while True:
        try:
            return future.result(timeout=WATCH_SECONDS)
        except TimeoutError:
            if worker not in _living(client):
                return None, f"it died in its first check, {OTHERS}"
            if time.monotonic() > until:
                return None, f"it has not answered for {READY_SECONDS} s, {OTHERS}; {END_IT}"
        except Exception as error:  # no grader in its Python, or no scheduler
            return False, f"{type(error).__name__}: {error}"


class _Spread:
    """The submissions that the scheduler holds: few for each thread, so that its memory does not
    grow with the class, and those on a worker that hangs are given to others.

    threads : of all workers that can grade. hung : the workers that get nothing
    patience : seconds without any result after which all that still work hang
    """

    def __init__(self, client, shared, threads, hung, patience, report):
        self.client, self.shared, self.hung = client, shared, hung
        self.patience, self.report = patience, report or (lambda line: None)
        self.started = {}  # {future: number of the submission}
        self.most = AHEAD * threads

    def able(self):
        """{worker: its threads} of those that live and do not hang."""
        return {w: n for w, n in _living(self.client).items() if w not in self.hung}

    def fill(self, waiting):
        """Start as many of the ``waiting`` as there is room for."""
        only = list(self.able()) if self.hung else None
        while waiting and len(self.started) < self.most:
            n = waiting.pop()
            future = self.client.submit(_grade, self.shared, n, pure=False, workers=only)
            self.started[future] = n

    def finished(self):
        """[(future, number)] of the next results; [] if there was none for too long."""
        done = _finished(self.client, list(self.started), self.patience)
        return [(future, self.started.pop(future)) for future in done]

    def taken_back(self):
        """The numbers of all that were started. From now on only workers that hold none get any,
        and one for each thread: what hangs holds up no other.
        """
        for worker, held in self.client.processing().items():
            if held and worker not in self.hung:
                self.hung.add(worker)
                waited = f"it has finished nothing for {self.patience:g} s"
                self.report(f"{worker}: {waited}, {OTHERS}; {END_IT}")
        self.most = sum(self.able().values())
        if not self.most:
            why = f"all workers of the cluster hang or have died; {NEW_WORKERS}, then {KEPT}"
            raise CourseError(why)
        back = list(self.started.values())
        self.client.cancel(list(self.started), force=True)
        self.started = {}
        return back


def _graded(spread, roster, students, progress):
    """{student: (result, entry)}."""
    found = {s: GradingRun.not_on_roster(s) for s in students if s not in roster}
    waiting, tried = [n for n, s in enumerate(students) if s in roster][::-1], set()

    def note(n, outcome):
        found[students[n]] = outcome
        progress(outcome[0])

    while waiting or spread.started:
        spread.fill(waiting)
        finished = spread.finished()
        for future, n in finished:
            note(n, _outcome(future, n, students[n], spread.shared))
        for n in () if finished else spread.taken_back():
            if n in tried:
                note(n, (Result(students[n], problem=HUNG), None))
            else:
                tried.add(n)
                waiting.append(n)
    return found


def _finished(client, futures, patience):
    """The finished futures, empty after ``seconds`` without any; raises
    :class:`CourseError` if the cluster is gone.
    """
    from distributed import CancelledError, wait

    alive = start = time.monotonic()
    while time.monotonic() - alive < ANSWER_SECONDS:
        try:
            return wait(futures, WATCH_SECONDS, "FIRST_COMPLETED").done
        except TimeoutError:
            if _living(client):
                alive = time.monotonic()
            if alive - start > patience:
                return ()
        except CancelledError:
            raise CourseError(f"the scheduler of the cluster is gone; {KEPT}") from None
    raise CourseError(f"all workers of the cluster have died; {NEW_WORKERS}, then {KEPT}")


def _outcome(future, n, student, shared):
    path = Path(shared.folder, str(n))  # never a name from the worker, which could be any file's
    try:
        future.result()
        outcome = pickle.loads(path.read_bytes())
        path.unlink()
    except Exception as error:  # Dask gives up after several workers have died with a submission
        outcome = f"{type(error).__name__}: {error}"
    if isinstance(outcome, str):
        why = f"could not be graded: its worker failed ({outcome})"
        return Result(student, problem=why), None
    return outcome


# -- on a worker

_harvesters: dict[bool, Harvester] = {}  # harvesters of this process, with and without a cage
_starting = threading.Lock()


def _examine(shared):
    """(True, the isolation of students' code on this worker), or (False, why it cannot grade)."""
    try:
        _run_of(shared)
        return True, _harvester(shared).sandbox_state
    except (CourseError, HarvestError) as error:  # they name the course's path, no student
        return False, str(error)
    except Exception as error:
        return False, type(error).__name__


def _grade(shared, n):
    """Write the result of the ``n``-th submission, or the text of an error, into the shared folder;
    Dask would send an exception with its text, which may name a student, through the scheduler.
    """
    try:
        run, students = _run_of(shared)
        data = pickle.dumps(run.grade(students[n], _harvester(shared)))
    except Exception as error:
        data = pickle.dumps(f"{type(error).__name__}: {error}")
    own = Path(shared.folder, secrets.token_hex())  # Dask may have given ``n`` to another, too
    write_bytes(own, data)
    own.replace(own.with_name(str(n)))


@lru_cache(maxsize=1)
def _run_of(shared):
    """The run and its students from the course folder; raises :class:`CourseError` if it is not the
    grader's.
    """
    if _code() != shared.code:
        raise CourseError(
            "it has another version of the checkout than the grader; install the same and start "
            "it again"
        )
    course = Course(shared.course)
    path = Path(shared.folder, PLAN)
    if not path.exists() or fingerprint(course.secret, path.read_bytes()) != shared.secret:
        raise CourseError(
            f"{shared.course} is not the course's folder there; let the workers reach it under the "
            "same path"
        )
    plan = json.loads(path.read_bytes())
    return GradingRun(course, roster=None, **plan["common"]), plan["students"]


def _harvester(shared):
    with _starting:
        if shared.sandbox not in _harvesters:
            from distributed import get_worker

            threads = get_worker().state.nthreads
            harvester = Harvester(threads, shared.sandbox).__enter__()
            _harvesters[shared.sandbox] = harvester
            atexit.register(harvester.__exit__)
        return _harvesters[shared.sandbox]


def _stop():
    """Stop everything on a worker."""
    with _starting:
        while _harvesters:
            _, harvester = _harvesters.popitem()
            atexit.unregister(harvester.__exit__)
            harvester.__exit__()
    _run_of.cache_clear()
