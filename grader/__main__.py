"""The command line of the grader: ``python -m grader --help``."""

import json
import math
import sys
from pathlib import Path

import click
from rich.console import Console
from rich.markup import escape
from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn, TimeElapsedColumn

console = Console(highlight=False)
COURSE = click.option(
    "--course",
    "course_path",
    required=True,
    type=click.Path(path_type=Path, file_okay=False),
    help="The course folder.",
)


class _Commands(click.Group):
    """Prints an error that the user can correct as one sentence, with exit code 2, instead of a
    traceback.
    """

    def list_commands(self, context):
        return list(self.commands)

    def invoke(self, context):
        from exercises.catalogue import CatalogueError
        from newton_euler.algebra.units import UnitError

        from .course import CourseError
        from .sandbox import HarvestError

        try:
            return super().invoke(context)
        except (CatalogueError, CourseError, HarvestError, UnitError) as error:
            raise click.UsageError(str(error)) from error
        except OSError as error:  # no permission, no room, a file where a folder should be
            raise click.UsageError(
                f"{error.filename or 'the system'}: {error.strerror or error}"
            ) from error


def _bar(*columns):
    return Progress(
        TextColumn("{task.description}"),
        BarColumn(),
        MofNCompleteColumn(),
        *columns,
        TimeElapsedColumn(),
        console=console,
        transient=not console.is_terminal,
    )


@click.group(
    cls=_Commands,
    context_settings={"help_option_names": ["-h", "--help"], "max_content_width": 110},
)
def main():
    """Build nbgrader assignments from the exercises and grade what students submit.

    \b
    Try it:          python -m grader demo
    See an answer:   python -m grader solve 4/16
    Make a course:   python -m grader build ch04 --course mechanics --students roster.csv
                     cd mechanics; nbgrader generate_assignment ch04; nbgrader release_assignment
                     ch04
    Grade it:        nbgrader collect ch04; python -m grader grade ch04 --course .
    """


@main.command()
@click.argument("names", nargs=-1, required=True, metavar="4/16 | ch04 | all …")
@click.option("--seed", type=int, help="Draw a variant of the numbers instead of the book's.")
@click.option(
    "--given",
    "changed",
    multiple=True,
    metavar="NAME=VALUE",
    help="Replace a given, in the unit of the text: --given omega=0.9. May be repeated.",
)
@click.option("--json", "as_json", is_flag=True, help="Print JSON and nothing else.")
@click.option("--explain", is_flag=True, help="Also print the terms of every answer that is a sum.")
def solve(names, seed, changed, as_json, explain):
    """Print the answers of problems.

    The numbers are those of the book, of a variant (--seed), or your own (--given). Formulas are
    printed in the symbols of the text; --given also replaces a symbol by a number.
    """
    from exercises.catalogue import select

    from .reports import answers_json, answers_text, solve_problem, terms_text

    problems = select(names)
    changes = dict(_pair(c) for c in changed)
    for name in changes:
        if not any(name in p.units for p in problems):
            raise click.UsageError(
                f"none of these problems has a given {name!r}; {problems[0].id} has "
                f"{', '.join(problems[0].units) or 'none'}"
            )
    out = {}
    for p in problems:
        try:
            results = solve_problem(p, seed, {n: v for n, v in changes.items() if n in p.units})
        except (ArithmeticError, ValueError) as error:
            if not changes:
                raise
            raise click.UsageError(
                f"{p.id} has no answer for {', '.join(changed)}: {error}"
            ) from error
        out[p.id] = answers_json(p, results)
        if not as_json:
            console.print(answers_text(p, results))
            if explain:
                console.print(terms_text(p, results))
    if as_json:
        click.echo(json.dumps(out, indent=1))


def _pair(text):
    name, _, value = text.partition("=")
    try:
        number = float(value)
    except ValueError:
        number = math.nan
    if not math.isfinite(number):
        raise click.UsageError(
            f"--given {text}: expected NAME=VALUE with a number, as in --given omega=0.9"
        )
    return name.strip(), number


@main.command()
@click.argument("names", nargs=-1, metavar="[4/16 | ch04 | all …]")
@click.option(
    "--seeds",
    default=3,
    show_default=True,
    type=click.IntRange(1),
    help="How many sets of numbers to check: the book's and drawn ones.",
)
def prove(names, seeds):
    """Check the keys, units and mistakes of problems.

    Every key must agree with its independent proof, every formula with its unit, and every listed
    mistake must differ from the key; exit code 1 if a check fails.
    """
    from exercises.catalogue import select
    from exercises.checks import AGREEMENT, check

    problems, failed = select(names or ("all",)), 0
    with _bar() as bar:
        task = bar.add_task("proving", total=len(problems))
        for p in problems:
            faults = check(p, seeds)
            failed += bool(faults)
            for fault in faults:
                bar.console.print(f"[red]{p.id}[/]: {escape(fault)}")
            bar.advance(task)
    mistakes = sum(len(p.mistakes) for p in problems)
    click.echo(f"{len(problems) - failed} passed, {failed} failed")
    if failed:
        sys.exit(1)
    click.echo(
        f"Every key agrees with its proof to {AGREEMENT:g} (floats) and {AGREEMENT**2:g} (50 "
        f"digits) for {seeds} sets of numbers;"
    )
    click.echo(
        f"all units are right; {mistakes} listed mistakes give answers that differ from the key."
    )


@main.command()
@click.argument("names", nargs=-1, required=True, metavar="4/16 | ch04 …")
@click.option("--seed", type=int, help="Draw a variant of the numbers instead of the book's.")
@click.option(
    "--to",
    "folder",
    default=Path("."),
    type=click.Path(path_type=Path, file_okay=False),
    help="Folder to write to; default: here.",
)
def figure(names, seed, folder):
    """Write the figure of each problem as a PNG file."""
    from exercises.catalogue import select

    from .assignment import figure_png
    from .reports import given_values

    folder.mkdir(parents=True, exist_ok=True)
    for p in select(names):
        path = folder / f"{p.id.replace('/', '_')}.png"
        path.write_bytes(figure_png(p, given_values(p, seed, {})))
        click.echo(path)


@main.command()
@click.argument("chapter")
@COURSE
@click.option(
    "--students",
    type=click.Path(exists=True, dir_okay=False),
    help="The roster, a CSV file with the columns id, first_name, last_name, email.",
)
@click.option(
    "--problem",
    "only",
    multiple=True,
    metavar="4/16",
    help="Only these problems of the chapter; may be repeated.",
)
@click.option(
    "--update",
    is_flag=True,
    help="Add the assignment to a course that exists; replaces a source notebook of the same name.",
)
def build(chapter, course_path, students, only, update):
    """Make an nbgrader assignment from a chapter.

    The course folder is new, or with --update an existing one.
    """
    from .assignment import build_assignment

    with _bar() as bar:
        course, path = build_assignment(course_path, chapter, students, only, update, bar)
    click.echo(f"Wrote {path}")
    click.echo(
        f"Next:  cd {course.path} && nbgrader generate_assignment {chapter} && nbgrader "
        f"release_assignment {chapter}"
    )
    if not course.roster():
        click.echo(
            "The roster is empty: add students first (nbgrader db student import roster.csv), "
            "since every student gets different numbers."
        )


@main.command()
@click.argument("assignment")
@COURSE
@click.option(
    "--student",
    "students",
    multiple=True,
    help="Only for this student; may be repeated. Default: all on the roster.",
)
@click.option(
    "--exchange",
    is_flag=True,
    help="Also copy them to nbgrader's exchange, for students who were added after the release.",
)
def personal(assignment, course_path, students, exchange):
    """Write each student's own copy of an assignment.

    The assignment must be generated for release; each copy has its student's own numbers and
    figures.

    Without an exchange, hand out COURSE/personal/ASSIGNMENT/STUDENT/ASSIGNMENT.ipynb yourself: to
    that student only.
    """
    from .assignment import copy_to_exchange, exchange_outbound, make_personal_copies
    from .course import Course

    course = Course(course_path)
    with _bar() as bar:
        task = bar.add_task("figures", total=1.0)
        paths = make_personal_copies(
            course, assignment, students or None, lambda share: bar.advance(task, share)
        )
    if exchange:
        copy_to_exchange(course, assignment, exchange_outbound(course, assignment), paths)
    for student, path in paths.items():
        click.echo(f"{student}: {path}")


@main.command()
@click.argument("assignment")
@COURSE
@click.option("--student", "students", multiple=True, help="Only this student; may be repeated.")
@click.option("--force", is_flag=True, help="Also grade submissions again that have not changed.")
@click.option(
    "--workers",
    type=click.IntRange(1),
    help="Processes that run student code; default: one per processor.",
)
@click.option(
    "--unsandboxed",
    is_flag=True,
    help="Run student code without isolation, with resource limits only; only for code that you "
    "trust.",
)
@click.option("--verbose", "-v", is_flag=True, help="Also print every diagnosis.")
def grade(assignment, course_path, students, force, workers, unsandboxed, verbose):
    """Grade the submissions of an assignment.

    Runs the answers of the notebooks in COURSE/submitted in a sandbox, scores them, and writes
    gradebook and annotated notebooks.
    """
    from .course import Course
    from .grading import grade as grade_submissions
    from .reports import diagnosis_table, gradebook_table

    course = Course(course_path)
    with _bar() as bar:
        task = bar.add_task("grading", total=len(students) or len(course.submissions(assignment)))
        results = grade_submissions(
            course,
            assignment,
            students,
            force,
            workers,
            not unsandboxed,
            lambda r: bar.advance(task),
        )
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
                f"[red]Not graded:[/] {escape(r.student)} {escape(r.problem)}.", soft_wrap=True
            )
    click.echo(f"Feedback pages: cd {course.path} && nbgrader generate_feedback {assignment}")
    if any(r.problem for r in results):
        sys.exit(1)


@main.command()
@click.option(
    "--course",
    "course_path",
    default=Path("demo-course"),
    type=click.Path(path_type=Path),
    show_default=True,
    help="A folder that does not exist yet.",
)
@click.option(
    "--problem",
    "only",
    multiple=True,
    metavar="4/16",
    help="Only these problems, which is faster; may be repeated.",
)
def demo(course_path, only):
    """Run all steps on an example course.

    Builds and releases an assignment, plays six students who fetch and submit it, grades them, and
    writes their feedback pages.
    """
    from .demo import run_demo

    run_demo(course_path, only, console, _bar)


if __name__ == "__main__":
    main(prog_name="python -m grader")
