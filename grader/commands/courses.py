"""Commands that make a course and run it."""

import shlex
import sys
from dataclasses import replace
from datetime import timedelta
from pathlib import Path
from textwrap import indent
from typing import TYPE_CHECKING

import click
from rich.panel import Panel

from newton_euler.algebra.language import choose_language, languages

from .shared import (
    COURSE,
    FILE,
    FOLDER,
    NEW_COURSE,
    ONLY,
    POINTS,
    PROBLEMS,
    console,
    counted,
    progress_bar,
    remember_problems,
)

if TYPE_CHECKING:
    from ..course import Course

UNSANDBOXED = 3  # exit code
GOES_ON = (
    "These are kept; the next run goes on from there (but with --force), and writes the gradebook."
)
ID_COLUMN = click.option(
    "--id-column",
    metavar="HEADER",
    help="The column of the roster that holds the ids; they must be the names under which the "
    "students log in, if they use nbgrader's exchange. Default: the first of the usual ones.",
)
STUDENTS = click.option(
    "--student", "students", multiple=True, help="Only this student; may be repeated."
)


def _example(name):
    """The file of an assignment, as click leaves it: a block of lines."""
    path = Path(__file__).parent / "templates" / f"{name}.yaml"
    return indent(path.read_text(encoding="utf-8"), "  ")


BUILD = f"""Make an nbgrader assignment: of a chapter, of problems, or as a file describes it.

The course folder is new, or with --update an existing one.

\b
build ch04 --course ~/mechanics                 all of chapter 4
build hw3 --problems 4/3 4/16 11/1-11/6 --points 4/3=10 --course ~/mechanics
build hw3.yaml --course ~/mechanics             as the file says
python -m grader problems, preview 4/16         what there is to choose from
python -m grader spec hw3 --course ~/mechanics  the file of what was built

A file with all that it may hold, hw3.yaml:

\b
{_example("hw3")}
and midterm.yaml:

\b
{_example("midterm")}"""


@click.command(help=BUILD)
@click.argument("assignment")
@click.argument("more", nargs=-1, metavar="")
@NEW_COURSE
@click.option(
    "--students",
    type=click.Path(exists=True, dir_okay=False),
    help="The roster: a CSV file as Canvas, Moodle, Gradescope or a registrar exports it.",
)
@ID_COLUMN
@ONLY
@POINTS
@click.option(
    "--due",
    "--closes",
    metavar="'2027-01-31 23:59 Europe/Berlin'",
    help="The due date; of an exam when it closes.",
)
@click.option(
    "--exam",
    is_flag=True,
    help="Make it an exam: receipts say nothing but whether an answer can be read, the first work "
    "in the window counts, no other sheet has its numbers, feedback waits until it has closed for "
    "everybody. Late work is refused; give a student another date by python -m grader due.",
)
@click.option("--opens", metavar="'2027-01-31 09:00 Europe/Berlin'", help="When an exam opens.")
@click.option("--name", help="The name of a new course; default: that of the folder.")
@click.option(
    "--exchange",
    type=FOLDER,
    help="nbgrader's exchange for a new course: a folder that students reach. It is made where it "
    "does not exist. Default: nbgrader's own.",
)
@click.option(
    "--language",
    type=click.Choice(languages()),
    help="Of a new course: of its sheets, receipts and feedback. What is not given in it stays in "
    "English. Default: en.",
)
@click.option(
    "--chapters",
    metavar="URL|FOLDER",
    help="What the sections that a sheet names link to, from now on in this course: the address "
    "of the site (python -m website), or the folder of the notebooks as seen from an assignment "
    "(../chapters, where students have run python -m newton_euler chapters). Default: no links.",
)
@click.option(
    "--update",
    is_flag=True,
    help="Add the assignment to a course that exists, or bring one that is there up to date: what "
    "you changed in its source notebook stays, and a copy of it is kept in COURSE/backup.",
)
def build(
    assignment: str,
    more: tuple[str, ...],
    course_path: Path,
    students: str | None,
    id_column: str | None,
    only: tuple[str, ...],
    points: tuple[str, ...],
    due: str | None,
    exam: bool,
    opens: str | None,
    name: str | None,
    exchange: Path | None,
    language: str | None,
    chapters: str | None,
    update: bool,
) -> None:
    from ..assignment import build_assignment
    from ..assignment.spec import Spec, read_spec, spec_of
    from ..course.due import due_date, set_due
    from ..course.exam import LATE

    if update and (name or exchange or language):
        raise click.UsageError(
            "--name, --exchange and --language are for a new course; those of this one are in "
            "course.json and nbgrader_config.py"
        )
    if language:
        choose_language(language)
    only = (*only, *more)
    what: str | Spec = assignment
    if Path(assignment).suffix in (".yaml", ".yml"):
        if only or points or exam or opens:
            raise click.UsageError(f"{assignment} says what the assignment is; write it there")
        what = read_spec(Path(assignment))
        due = due or what.due
    elif only or points or exam:
        what = spec_of(assignment, only, points)
    if (exam and not due) or (opens and not exam):
        raise click.UsageError("an exam says when it closes: --exam --opens … --closes …")
    if exam and isinstance(what, Spec):
        what = replace(what, due=due or "", opens=opens or "", late=LATE[0])
    when = due_date(due) if due else None
    with progress_bar() as bar:
        built = build_assignment(
            course_path, what, students, (), update, bar, name, exchange, id_column, chapters
        )
    course, name = built.course, built.spec.name
    remember_problems(course)
    _warn_of_closed(exchange)
    if when:
        set_due(course, name, when)
        click.echo(f"Due {when:%Y-%m-%d %H:%M} UTC")
    if students:
        click.echo(f"Enrolled {built.enrolled} students ({built.read_as})")
    click.echo(f"Wrote {built.path}")
    for words in built.spec.warnings:
        click.echo(words)
    if built.merged:
        _report_merge(built.merged, built.backup, course.built(name))
    click.echo(
        f"Next:  cd {shlex.quote(str(course.path))} && nbgrader generate_assignment {name} && "
        f"nbgrader release_assignment {name}"
    )
    if not (enrolled := len(course.roster())):
        click.echo(
            "The roster is empty: add students first (python -m grader enrol roster.csv), since "
            "every student gets different numbers."
        )
    else:
        click.echo(f"{enrolled} students are on the roster of the course {course.name}.")


@click.command()
@click.argument("assignment")
@COURSE
@click.option("-o", "--to", "path", type=FILE, help="The file to write; default: print it.")
def spec(assignment: str, course: "Course", path: Path | None) -> None:
    """Write the file of an assignment from the source notebook that is in a course.

    It has the problems and texts in their order, with the points, weights, tolerances and help
    levels that are in the notebook now, and the dates: build makes the same assignment of it, in
    another course or the next year.
    """
    from ..assignment.written import spec_of_course
    from ..course.files import write_text

    found = spec_of_course(course, assignment)
    left = [*(i.question for i in found.items if i.question), *found.left_out]
    left += [f"your text of {i.problem.id}" for i in found.items if i.problem and i.text]
    if path:
        write_text(path, found.as_yaml, 0o644)
        click.echo(f"Wrote {path}")
    else:
        click.echo(found.as_yaml, nl=False)
    if left:
        click.echo(f"A file cannot say these, which are left out: {', '.join(left)}", err=True)


def _report_merge(merged, backup, written):
    click.echo(f"What was there before is in {backup}")
    for names, what in (
        (merged.kept, "Kept as you changed it: "),
        (merged.conflicts, f"Changed by you and by the exercises (their text is in {written}): "),
        (merged.removed, "Taken out, since it is not among the problems now: "),
    ):
        if names:
            click.echo(what + ", ".join(names))


@click.command()
@click.argument("group", metavar="GROUP")
@COURSE
def share(group: str, course: "Course") -> None:
    """Let the users of a group work on a course: assistants, and an account that grades.

    They can grade, comment and export as you do, and can read all that is in the course, the secret
    of its numbers too. One account, yours, releases and collects.
    """
    from ..course.shared import share as open_course

    open_course(course, group)
    click.echo(f"The group {group} reads and writes {course.path}.")


@click.command()
@click.argument("courses", nargs=-1, required=True, type=FOLDER, metavar="COURSE COURSE …")
@click.option("--to", required=True, type=FOLDER, help="Folder to write to, as /etc/jupyter.")
def hub(courses: tuple[Path, ...], to: Path) -> None:
    """Write one configuration for the students of several courses on one machine.

    They share an exchange. A student sees the courses side by side, and in a terminal names one:
    nbgrader fetch_assignment ch04 --course COURSE
    """
    from ..course import Course
    from ..course.hub import write_hub

    root = write_hub([Course(path) for path in courses], to)
    click.echo(f"Wrote nbgrader_config.py and what it needs to {to}")
    _warn_of_closed(root)


def _warn_of_closed(exchange):
    from ..course.hub import closed_to_others

    if exchange and (shut := closed_to_others(exchange)):
        click.echo(
            f"Others cannot enter {shut}, so students with accounts of their own do not reach the "
            f"exchange {exchange}: name one such as /srv/nbgrader/exchange, or chmod o+x {shut}",
            err=True,
        )


@click.command("next-year")
@click.argument("last", type=FOLDER)
@NEW_COURSE
@click.option("--name", help="The name of the new course; default: that of its folder.")
@click.option("--exchange", type=FOLDER, help="Its exchange; default: last year's.")
@click.option(
    "--later",
    type=click.IntRange(0),
    metavar="DAYS",
    help="Carry the due dates on, this many days later: 364 keeps the day of the week.",
)
def next_year(
    last: Path, course_path: Path, name: str | None, exchange: Path | None, later: int | None
) -> None:
    """Make a course from last year's, in the folder LAST.

    It has its notebooks as you edited them, its settings and own problems, and a secret of its own,
    so that every student has other numbers; no students, no submissions, due dates by --later.
    """
    from ..course import Course
    from ..course.due import due_dates
    from ..course.next_year import next_year as made

    days = None if later is None else timedelta(later)
    course, assignments = made(Course(last), course_path, name, exchange, days)
    click.echo(f"The course {course.name}, in {course.path}, has {', '.join(assignments)}.")
    click.echo(f"Next: python -m grader enrol roster.csv --course {shlex.quote(str(course.path))}")
    for assignment, due in due_dates(course).items():
        click.echo(f"{assignment} is due {due:%Y-%m-%d %H:%M} UTC")
    if without := [a for a in assignments if a not in due_dates(course)]:
        click.echo(
            f"Without a due date: {', '.join(without)}; python -m grader due ASSIGNMENT DATE "
            "--course … sets one"
        )
    if exams := Course(last).settings.get("exams"):
        click.echo(f"Build these anew, with their new dates: {', '.join(sorted(exams))} (exams)")


@click.command()
@click.argument("roster", type=click.Path(exists=True, dir_okay=False))
@COURSE
@ID_COLUMN
def enrol(roster: str, course: "Course", id_column: str | None) -> None:
    """Add the students of a roster to a course, and change nothing else.

    Students who are in the course already keep their numbers and scores. Those who join after an
    assignment was released get their copies by: personal ASSIGNMENT --student ID --exchange
    """
    from ..course import read_roster

    read = read_roster(roster, id_column)
    new = course.enrol(read.students)
    click.echo(f"Enrolled {new} students ({read.read_as})")
    click.echo(f"{len(course.roster())} students are on the roster of the course {course.name}.")


@click.command()
@click.argument("assignment")
@click.argument("when", metavar="'2027-01-31 23:59 Europe/Berlin'|none")
@COURSE
@STUDENTS
def due(assignment: str, when: str, course: "Course", students: tuple[str, ...]) -> None:
    """Set the due date of an assignment, and change nothing else.

    With --student it is the date of this student alone; "none" takes it away again. Grade after it:
    what is late, and the penalty (python -m grader late), follow.
    """
    from ..course.due import due_date, set_due, set_own_due

    found = None if when == "none" else due_date(when)
    if students:
        set_own_due(course, assignment, students, found)
    else:
        set_due(course, assignment, found)
    who = f" for {', '.join(students)}" if students else ""
    click.echo(f"Due{who}: {f'{found:%Y-%m-%d %H:%M} UTC' if found else 'no date'}")


@click.command()
@click.argument("share", metavar="none|zero|10%")
@COURSE
def late(share: str, course: "Course") -> None:
    """Set what late work loses: nothing, all, or a share of its points for each day begun.

    It holds for all assignments of the course, also for work that was graded before: grade again. A
    policy of your own in nbgrader_config.py comes first.
    """
    from ..course.due import set_late_share

    lost = set_late_share(course, share)
    click.echo(
        f"Late work loses {100 * lost:g} % of its points for each day begun. Next: python -m "
        "grader grade ASSIGNMENT --course …"
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
    "wrong answer on the time until the next check doubles, up to ten minutes; how many there were "
    "stands in the notebook, and in the note on the problem when it is graded. That stops guessing "
    "by hand. It does not stop a program, which finds a number in 20 s and a vector in hours, nor "
    "does a count of zero prove anything: for an exam leave it out. Copies written later need the "
    "option again.",
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

    Without an exchange, hand out COURSE/personal/ASSIGNMENT/STUDENT/ASSIGNMENT.ipynb yourself: to
    that student only.
    """
    from ..assignment import make_personal_copies

    with counted("figures", 1.0) as done:
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

    Runs the answers of the notebooks in COURSE/submitted in a sandbox, scores them, and writes
    gradebook and annotated notebooks.

    \b
    Exit codes:  0  all submissions are graded
                 1  some could not be graded; the others are
                 2  wrong use, or a course that is not in order; nothing was graded
                 3  --unsandboxed was given, and all submissions are graded
               130  stopped by Ctrl-C; the next run goes on
    """
    from ..grading import grade as grade_submissions
    from ..reports import diagnosis_table, gradebook_table, shown

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
                f"[red]Not graded:[/] {shown(r.student)} {shown(r.problem)}.", soft_wrap=True
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
    handed in and graded, which then counts. With --back the earlier one counts again: grade after
    it.
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
    """Copy personal notebooks to the exchange, and warn where others can read them."""
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

    ARCHIVE is what a learning platform gives as "download all submissions". A notebook is a
    student's if its folder, or where it has none its name, holds their id or their whole name and
    no word that may be of anybody else's: of a name that a platform numbered, what comes before the
    numbers. The table lists the matches. Exit code 1 if a file was left out.
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
    """Run all steps on an example course, of chapter 4 or of that of the problems that are named.

    Builds and releases an assignment, plays six students who fetch and submit it, grades them, and
    writes their feedback pages.
    """
    from ..demo import run_demo

    run_demo(course_path, _chapter_of(only), only, console, progress_bar, counted)


def _chapter_of(only):
    """The chapter of these problems; chapter 4 where none is named."""
    from exercises.catalogue import select

    found = list(dict.fromkeys(p.chapter for p in select(only))) or ["ch04"]
    if len(found) > 1:
        raise click.UsageError(
            f"a demo hands out problems of one chapter, not of {' and '.join(found)}"
        )
    return found[0]
