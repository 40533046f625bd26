"""Commands that hand out, take in and grade work."""

import sys
from pathlib import Path
from typing import TYPE_CHECKING

import click
from rich.panel import Panel

from .shared import COURSE, PROBLEMS, STUDENTS, console, progress_bar, step_counter

if TYPE_CHECKING:
    from ..course import Course

UNSANDBOXED = 3  # exit code
GOES_ON = (
    "These are kept; the next run continues from there (unless --force), and writes the gradebook."
)


@click.command()
@click.argument("assignment")
@COURSE
@STUDENTS
@click.option(
    "--exchange",
    is_flag=True,
    help="Also copy them to nbgrader's exchange, for students who were added after the release.",
)
@click.option(
    "--right-or-wrong",
    is_flag=True,
    help="Let the receipts in these copies say whether an answer is right, from a salted slow hash "
    "of it: for practice and homework, where a student who is wrong should go on. From the seventh "
    "wrong answer on, the time until the next check doubles, up to ten minutes. Wrong answers "
    "are counted in the notebook, and the note on the graded problem says how many they were. That "
    "stops guessing by hand, but not a program, which finds a number in 20 s and a vector in "
    "hours; and a count of zero proves nothing. Leave it out for an exam. Copies written later "
    "need the option again.",
)
def personal(
    assignment: str,
    course: "Course",
    students: tuple[str, ...],
    exchange: bool,
    right_or_wrong: bool,
) -> None:
    """Write each student's own copy of an assignment.

    The assignment must be generated for release; each copy has its student's own numbers and
    figures.

    Without an exchange, give COURSE/personal/ASSIGNMENT/STUDENT/ASSIGNMENT.ipynb to that student
    only.
    """
    from ..assignment import make_personal_copies

    with step_counter("figures", 1.0) as done:
        paths = make_personal_copies(
            course, assignment, students or None, done, right_or_wrong=right_or_wrong
        )
    if exchange:
        _put_into_exchange(course, assignment, paths)
    for student, path in paths.items():
        click.echo(f"{student}: {path}")


@click.command()
@click.argument("assignment")
@COURSE
@STUDENTS
@click.option("--force", is_flag=True, help="Also grade submissions again that have not changed.")
@click.option(
    "--workers",
    type=click.IntRange(1),
    help="Processes that run student code; default: one per processor.",
)
@click.option(
    "--scheduler",
    metavar="tcp://HOST:8786",
    help="Spread the work over the workers of this Dask cluster (pip install -e '.[cluster]'). "
    "They must have the same version of this checkout, reach the course folder under the same "
    "path, and allow the cage. If one dies, another does its work; the gradebook is written here.",
)
@click.option(
    "--unsandboxed",
    is_flag=True,
    help="Run student code without isolation, with resource limits only; only for code that you "
    "trust.",
)
@click.option("--verbose", "-v", is_flag=True, help="Also print every diagnosis.")
def grade(
    assignment: str,
    course: "Course",
    students: tuple[str, ...],
    force: bool,
    workers: int | None,
    scheduler: str | None,
    unsandboxed: bool,
    verbose: bool,
) -> None:
    """Grade the submissions of an assignment.

    Runs the answers of the notebooks in COURSE/submitted in a sandbox, scores them, and writes the
    gradebook and annotated notebooks.

    \b
    Exit codes:  0  all submissions are graded
                 1  some could not be graded; the others are
                 2  wrong use, or a course that is not in order; nothing was graded
                 3  --unsandboxed was given, and all submissions are graded
               130  stopped by Ctrl-C; the next run goes on
    """
    from ..grading import grade as grade_submissions
    from ..reports import diagnosis_table, gradebook_table, in_cell

    if scheduler and workers:
        raise click.UsageError("--workers is for this machine; a cluster has its own")
    if unsandboxed:
        _warn_unsandboxed()
    with progress_bar(then=GOES_ON) as bar:
        task = bar.add_task("grading", total=len(students) or len(course.submissions(assignment)))
        results = grade_submissions(
            course, assignment, students, force, workers, not unsandboxed,
            lambda r: bar.advance(task), scheduler, bar.console.print,
        )  # fmt: skip
    if not results:
        click.echo(
            f"Nothing to grade: {course.path / 'submitted'} holds no {assignment}. Collect "
            f"first: nbgrader collect {assignment}"
        )
        return
    console.print(gradebook_table(results))
    if verbose:
        console.print(diagnosis_table(results))
    for r in results:
        if r.problem:
            console.print(
                f"[red]Not graded:[/] {in_cell(r.student)} {in_cell(r.problem)}.", soft_wrap=True
            )
    click.echo(f"Feedback pages: cd {course.path} && nbgrader generate_feedback {assignment}")
    if any(r.problem for r in results):
        sys.exit(1)
    if unsandboxed:
        _warn_unsandboxed()
        sys.exit(UNSANDBOXED)


def _warn_unsandboxed():
    words = (
        "Students' code runs WITHOUT A CAGE, as you: it can read and change all that you can, "
        'this course\'s secret and gradebook too. Every grade says "unsandboxed".'
    )
    console.print(Panel(words, title="UNSANDBOXED", border_style="red"))


@click.command()
@click.argument("assignment")
@COURSE
@click.option("--student", required=True, help="Who may try again.")
@click.option(
    "--back", type=click.IntRange(1), metavar="N", help="Let the earlier attempt N count again."
)
@click.option("--exchange", is_flag=True, help="Also copy the new sheet to nbgrader's exchange.")
def retry(
    assignment: str, course: "Course", student: str, back: int | None, exchange: bool
) -> None:
    """Give a student another sheet, with fresh numbers.

    The earlier attempt is set aside in COURSE/attempts; its grade stands until the new sheet is
    handed in and graded. With --back the earlier one counts again: grade afterwards.
    """
    from ..assignment.attempts import new_attempt, put_back

    if back:
        put_back(course, assignment, student, back)
        click.echo(f"Attempt {back} counts again: python -m grader grade {assignment} --course …")
        return
    number, path = new_attempt(course, assignment, student)
    if exchange:
        _put_into_exchange(course, assignment, {student: path})
    click.echo(f"Attempt {number} of {student}: {path}")


def _put_into_exchange(course, assignment, paths):
    """Copy personal notebooks to the exchange, and warn if others can read them."""
    from ..assignment.personal import copy_to_exchange, exchange_outbound, warning

    outbound = exchange_outbound(course, assignment)
    if words := warning(copy_to_exchange(course, assignment, outbound, paths)):
        click.echo(words, err=True)


@click.command("take-in")
@click.argument("assignment")
@click.argument("archive", type=click.Path(exists=True, dir_okay=False, path_type=Path))
@COURSE
@click.option("--replace", is_flag=True, help="Also where a student has already handed in.")
@click.option(
    "--times",
    is_flag=True,
    help="Take the times of the files in the archive, as UTC, for the times of submission.",
)
def take_in(assignment: str, archive: Path, course: "Course", replace: bool, times: bool) -> None:
    """Take students' work from a zip archive, without nbgrader's exchange.

    ARCHIVE is a learning platform's "download all submissions". A notebook is a student's if the
    name of its folder, or without one its own, has their id or whole name and no word that may be
    someone else's; in names numbered by a platform, only the part before the numbers counts. The
    table lists the matches. Exit code 1 if a file was left out.
    """
    from ..course import take_in as take
    from ..reports import taken_in_table

    taken = take(course, assignment, archive, replace, times)
    console.print(taken_in_table(taken))
    click.echo(
        f"{len(taken.taken)} taken in, {len(taken.kept)} kept as they were, "
        f"{len(taken.refused)} left out"
    )
    if taken.refused:
        sys.exit(1)


@click.command()
@click.option(
    "--course",
    "course_path",
    default=Path("demo-course"),
    type=click.Path(path_type=Path),
    show_default=True,
    help="A folder that does not exist yet, or holds an earlier demo, which is replaced.",
)
@PROBLEMS
def demo(course_path: Path, only: tuple[str, ...]) -> None:
    """Run all steps on an example course, of chapter 4 or of the named problems.

    Builds and releases an assignment, plays six students who fetch and submit it, grades them, and
    writes their feedback pages.
    """
    from ..demo import run_demo

    run_demo(course_path, _chapter_of(only), only, console, progress_bar, step_counter)


def _chapter_of(only):
    """The chapter of these problems; by default chapter 4."""
    from exercises.catalogue import select

    found = list(dict.fromkeys(p.chapter for p in select(only))) or ["ch04"]
    if len(found) > 1:
        raise click.UsageError(
            f"a demo hands out problems of one chapter, not of {' and '.join(found)}"
        )
    return found[0]
