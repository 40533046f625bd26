"""Commands that make courses and change their settings."""

import shlex
from dataclasses import replace
from datetime import timedelta
from pathlib import Path
from textwrap import indent
from typing import TYPE_CHECKING

import click

from newton_euler.algebra.language import choose_language, languages

from .shared import (
    COURSE,
    FILE,
    FOLDER,
    NEW_COURSE,
    ONLY,
    POINTS,
    STUDENTS,
    amount,
    progress_bar,
    remember_problems,
)

if TYPE_CHECKING:
    from ..assignment.build import BuildResult
    from ..assignment.spec import Spec
    from ..course import Course

ID_COLUMN = click.option(
    "--id-column",
    metavar="HEADER",
    help="The column of the roster that holds the ids; they must be the names under which the "
    "students log in, if they use nbgrader's exchange. Default: the first of the usual ones.",
)


def _example(name):
    """An example of an assignment's file, indented as a block for click."""
    path = Path(__file__).parent / "templates" / f"{name}.yaml"
    return indent(path.read_text(encoding="utf-8"), "  ")


BUILD = f"""Make an nbgrader assignment from a chapter, from problems, or from a file.

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
    help="The language of a new course's sheets, receipts and feedback. What is not translated "
    "stays in English. Default: en.",
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
    from ..course.due import due_date, set_due

    if update and (name or exchange or language):
        raise click.UsageError(
            "--name, --exchange and --language are for a new course; those of this one are in "
            "course.json and nbgrader_config.py"
        )
    if language:
        choose_language(language)
    what, due = _asked_for(assignment, (*only, *more), points, due, exam, opens)
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
        click.echo(f"Enrolled {amount(built.enrolled, 'student')} ({built.read_as})")
    _report_built(built)


def _asked_for(
    assignment: str,
    only: tuple[str, ...],
    points: tuple[str, ...],
    due: str | None,
    exam: bool,
    opens: str | None,
) -> "tuple[str | Spec, str | None]":
    """What to build, and when it is due, by a file or by options."""
    from ..assignment.spec import Spec, read_spec, spec_of
    from ..course.exam import LATE

    what: str | Spec = assignment
    if Path(assignment).suffix in (".yaml", ".yml"):
        if only or points or exam or opens:
            raise click.UsageError(f"{assignment} says what the assignment is; write it there")
        what = read_spec(Path(assignment))
        due = due or what.due
    elif only or points or exam:
        what = spec_of(assignment, only, points)
    if (exam and not due) or (opens and not exam):
        raise click.UsageError("an exam needs --exam and --closes …; --opens … is for exams only")
    if exam and isinstance(what, Spec):
        what = replace(what, due=due or "", opens=opens or "", late=LATE[0])
    return what, due


def _report_built(built: "BuildResult") -> None:
    """Say what was written, and what to do next."""
    course, name = built.course, built.spec.name
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
        click.echo(f"The roster of the course {course.name} has {amount(enrolled, 'student')}.")


@click.command()
@click.argument("assignment")
@COURSE
@click.option("-o", "--to", "path", type=FILE, help="The file to write; default: print it.")
def spec(assignment: str, course: "Course", path: Path | None) -> None:
    """Write the file of an assignment from its source notebook in a course.

    It has the problems and texts in order, with the present points, weights, tolerances and help
    levels, and the dates: build makes the same assignment from it, in another course or next year.
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

    They can grade, comment and export as you do, and can read everything in the course, including
    the secret of its numbers. One account, yours, releases and collects.
    """
    from ..course.shared import share as open_course

    open_course(course, group)
    click.echo(f"The group {group} reads and writes {course.path}.")


@click.command()
@click.argument("courses", nargs=-1, required=True, type=FOLDER, metavar="COURSE COURSE …")
@click.option("--to", required=True, type=FOLDER, help="Folder to write to, e.g. /etc/jupyter.")
def hub(courses: tuple[Path, ...], to: Path) -> None:
    """Write one configuration for the students of several courses on one machine.

    They share an exchange. Students see the courses side by side, and in a terminal name one:
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
    help="Move the due dates this many days later: 364 keeps the day of the week.",
)
def next_year(
    last: Path, course_path: Path, name: str | None, exchange: Path | None, later: int | None
) -> None:
    """Make a course from last year's, in the folder LAST.

    It keeps the notebooks as you edited them, the settings and the course's own problems, and has a
    new secret, hence new numbers for every student; no students, no submissions, due dates by
    --later.
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
    if exams := Course(last).exams:
        click.echo(f"Build these anew, with their new dates: {', '.join(sorted(exams))} (exams)")


@click.command()
@click.argument("roster", type=click.Path(exists=True, dir_okay=False))
@COURSE
@ID_COLUMN
def enrol(roster: str, course: "Course", id_column: str | None) -> None:
    """Add the students of a roster to a course, and change nothing else.

    Enrolled students keep their numbers and scores. Those who join after an assignment was released
    get their copies by: personal ASSIGNMENT --student ID --exchange
    """
    from ..course import read_roster

    read = read_roster(roster, id_column)
    new = course.enrol(read.students)
    click.echo(f"Enrolled {amount(new, 'student')} ({read.read_as})")
    click.echo(
        f"The roster of the course {course.name} has {amount(len(course.roster()), 'student')}."
    )


@click.command()
@click.argument("assignment")
@click.argument("when", metavar="'2027-01-31 23:59 Europe/Berlin'|none")
@COURSE
@STUDENTS
def due(assignment: str, when: str, course: "Course", students: tuple[str, ...]) -> None:
    """Set the due date of an assignment, and change nothing else.

    With --student it is for this student alone; "none" removes it. Grade again afterwards, to
    update lateness and penalties (python -m grader late).
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
    """Set the penalty for late work: none, all, or a share of its points for each day begun.

    It holds for all assignments of the course; grade again for work graded before. A policy of your
    own in nbgrader_config.py takes precedence.
    """
    from ..course.due import set_late_share

    lost = set_late_share(course, share)
    click.echo(
        f"Late work loses {100 * lost:g} % of its points for each day begun. Next: python -m "
        "grader grade ASSIGNMENT --course …"
    )
