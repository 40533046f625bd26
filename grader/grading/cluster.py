"""Spreads the grading of a class over a Dask cluster.

The workers reach the course folder under the same path as the grader, on a shared file system, and
have the same version of the checkout installed. Whatever else a run needs is in that folder while
it lasts, readable by its owner alone; no key, secret or student work passes the scheduler. A worker
does everything for a submission but write the gradebook, which the grader does. When a worker dies,
Dask reassigns its submissions.
"""

import atexit
import contextlib
import json
import threading
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path

from ..course import Course, CourseError, write_json
from ..sandbox import Harvester, HarvestError
from .gradebook import Entry
from .records import fingerprint, run_state, score_state
from .student import Result, Run

AHEAD = 4  # submissions per thread that the scheduler holds at a time
ANSWER_SECONDS = 10  # for a scheduler to answer
READY_SECONDS = 60  # for a worker to import the grader and to start its harvester


# grades these students: {student: (result, what to write into the gradebook)}
GradeStudents = Callable[
    [Iterable[str], Callable[[Result], object] | None], dict[str, tuple[Result, Entry | None]]
]


@dataclass(frozen=True)
class Shared:
    """Where the workers find what is common to all submissions, and what must equal theirs."""

    course: str
    plan: str
    code: str
    secret: str
    sandbox: bool


@contextlib.contextmanager
def cluster(
    address: str,
    course: Course,
    run: Run,
    sandbox: bool,
    report: Callable[[str], object] | None = None,
) -> Iterator[GradeStudents]:
    """A context with a function that grades on the workers of a scheduler; raises
    :class:`CourseError` if it does not answer or a worker cannot grade. ``report`` gets a line
    about each worker.
    """
    plan = course.path / "scores" / ".plan.json"
    common = {k: v for k, v in vars(run).items() if k not in ("course", "roster")}
    write_json(plan, common, indent=None)
    shared = Shared(
        str(course.path), plan.name, _code(), fingerprint(course.secret, plan.read_bytes()), sandbox
    )
    try:
        with _connected(address) as client:
            threads = _examined(client, address, shared, report)
            try:
                yield lambda students, progress: _graded(
                    client, shared, run.roster, students, AHEAD * threads, progress
                )
            finally:
                with contextlib.suppress(Exception):  # a worker that dies now has stopped, too
                    client.run(_stop)
    finally:
        plan.unlink(missing_ok=True)


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
    with client:
        yield client


def _examined(client, address, shared, report):
    """The number of threads of the workers, all of which must be able to grade."""
    workers = client.nthreads()
    if not workers:
        raise CourseError(f"the cluster has no workers; start some with: dask worker {address}")
    asked = {w: client.submit(_examine, shared, workers=[w], pure=False) for w in sorted(workers)}
    for worker, future in asked.items():
        try:
            able, state = future.result(timeout=READY_SECONDS)
        except TimeoutError:
            able, state = False, f"it has not answered for {READY_SECONDS} s"
        if not able:
            raise CourseError(f"the worker {worker} cannot grade: {state}")
        if report:
            report(f"{worker}: {workers[worker]} at a time, {state}")
    return sum(workers.values())


def _graded(client, shared, roster, students, ahead, progress):
    """{student: (result, what to write)}; the scheduler never holds more than ``ahead``
    submissions, so that its memory does not grow with the class.
    """
    from distributed import as_completed

    found, waiting, started = {}, iter(students), {}

    def next_ones(count):
        for _, student in zip(range(count), waiting, strict=False):
            if student in roster:
                future = client.submit(_grade, shared, student, pure=False)
                started[future.key] = student
                yield future
            else:
                found[student] = Run.not_on_roster(student)

    finished = as_completed(next_ones(ahead), loop=client.loop)
    for future in finished:
        student = started.pop(future.key)
        found[student] = _outcome(client, future, student)
        future.release()
        if progress:
            progress(found[student][0])
        for more in next_ones(1):
            finished.add(more)
    return found


def _outcome(client, future, student):
    if future.status == "cancelled":
        raise CourseError(
            "the scheduler of the cluster is gone; grade again: finished runs are kept and not "
            "repeated"
        )
    try:
        return future.result()
    except Exception as error:  # Dask gives up after several workers have died with a submission
        why = f"could not be graded: its worker failed ({type(error).__name__}: {error})"
        return Result(student, problem=why), None


# -- on a worker

_harvesters: dict[bool, Harvester] = {}  # of this process, by whether they cage
_starting = threading.Lock()


def _examine(shared):
    """(True, how this worker isolates students' code), or (False, why it cannot grade)."""
    try:
        _run_of(shared)
        return True, _harvester(shared).sandbox_state
    except (CourseError, HarvestError) as error:
        return False, str(error)


def _grade(shared, student):
    return _run_of(shared).grade(student, _harvester(shared))


@lru_cache(maxsize=1)
def _run_of(shared):
    """The run from the course folder; raises :class:`CourseError` if it is not the grader's."""
    if _code() != shared.code:
        raise CourseError(
            "it has another version of the checkout than the grader; install the same and start "
            "it again"
        )
    course = Course(shared.course)
    path = Path(shared.course, "scores", shared.plan)
    if not path.exists() or fingerprint(course.secret, path.read_bytes()) != shared.secret:
        raise CourseError(
            f"{shared.course} is not the course's folder there; let the workers reach it under the "
            "same path"
        )
    common = json.loads(path.read_bytes())
    return Run(course, roster=None, **common)


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
    """Leave nothing running on a worker."""
    with _starting:
        while _harvesters:
            _, harvester = _harvesters.popitem()
            atexit.unregister(harvester.__exit__)
            harvester.__exit__()
    _run_of.cache_clear()
