"""Grading all submissions of an assignment: only what has changed, in one transaction."""

import contextlib
import gc
from collections.abc import Callable, Iterable
from concurrent.futures import ThreadPoolExecutor, as_completed

from ..assignment.released import released
from ..course import Course, CourseError
from ..course.exam import is_exam, judged
from ..sandbox import Harvester
from ..submission import read_timestamp
from .cluster import cluster
from .gradebook import Total, instructors_cells, save
from .lock import alone
from .student import GradingRun, Result


def grade(
    course: Course,
    assignment: str,
    students: Iterable[str] | None = None,
    force: bool = False,
    workers: int | None = None,
    sandbox: bool = True,
    progress: Callable[[Result], object] = lambda result: None,
    scheduler: str | None = None,
    report: Callable[[str], object] | None = None,
) -> list[Result]:
    """Grade the submissions of an assignment; writes gradebook and annotated notebooks.

    students : ids to grade; default: all who submitted. force : run unchanged submissions, too.
    workers : number of processes; default: one per processor. scheduler : the address of a Dask
        cluster instead (see :mod:`grader.grading.cluster`); ``report`` is called with a line about
        each of its workers. progress : called with each Result.

    A submission that cannot be graded is reported in its Result; its earlier grade, and all other
    submissions, are unaffected.
    """
    submitted = course.submissions(assignment)
    missing = [s for s in students or () if s not in submitted]
    if missing:
        raise CourseError(
            f"no submission of {assignment} by {', '.join(missing)}; there are "
            f"{', '.join(submitted) or 'none'} in {course.path / 'submitted'}"
        )
    # these raise CourseError early if nothing is released, or the secret is missing
    names = list(released(course, assignment))
    course.secret  # noqa: B018
    wanted = [s for s in submitted if not students or s in students]
    with _rare_collections(), alone(course), contextlib.ExitStack() as stack:
        harvester = None if scheduler else stack.push(Harvester(workers, sandbox))
        new = force or not all(course.record_path(assignment, s).exists() for s in wanted)
        if new and harvester:
            harvester.__enter__()  # imports in parallel with those of the gradebook
        book = stack.enter_context(course.gradebook())
        sources, roster = instructors_cells(book, assignment), {s.id for s in book.students}
        timed = wanted if is_exam(course, assignment) else ()
        times = {s: read_timestamp(submitted[s].parent) for s in timed}
        remarks, refused = judged(course, book, assignment, times)
        run = GradingRun(course, assignment, force, names, sources, roster, remarks)
        late = {s: (Result(s, problem=why), None) for s, why in refused.items()}
        wanted = [s for s in wanted if s not in late]
        if scheduler:
            on_workers = cluster(scheduler, course, run, wanted, sandbox, report)
            graded = stack.enter_context(on_workers)(progress)
        else:
            graded = _on_threads(run, harvester, wanted, progress)
        graded |= late
        results = [graded[s][0] for s in sorted(graded, key=list(submitted).index)]
        totals = save(course, book, assignment, [e for _, e in graded.values() if e])
    for result in results:
        for name, value in vars(totals.get(result.student, Total())).items():
            setattr(result, name, value)
    return results


@contextlib.contextmanager
def _rare_collections():
    """Leave out of garbage collection what is held now, libraries and problems that stay, and
    collect the rest rarely: that took a seventh of the time of this process.
    """
    thresholds = gc.get_threshold()
    gc.freeze()
    gc.set_threshold(100_000, *thresholds[1:])
    try:
        yield
    finally:
        gc.set_threshold(*thresholds)
        gc.unfreeze()


def _on_threads(run, harvester, students, progress):
    """{student: (result, entry)}; threads prepare and score while workers run code."""
    found = {}
    with ThreadPoolExecutor(harvester.count + 1) as pool:
        started = {pool.submit(run.grade, s, harvester): s for s in students}
        try:
            for done in as_completed(list(started)):
                student = started.pop(done)
                found[student] = done.result()
                progress(found[student][0])
        except BaseException:  # such as an interrupt: do not wait for the others
            pool.shutdown(wait=False, cancel_futures=True)
            harvester.abandon()
            raise
    return found
