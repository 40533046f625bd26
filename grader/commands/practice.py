"""The commands ``practice`` and ``sets``: practice files."""

from pathlib import Path
from typing import TYPE_CHECKING

import click

from .shared import (
    FILE,
    FOLDER,
    amount,
    class_numbers,
    console,
    count_option,
    course_option,
    progress_bar,
    step_counter,
)

if TYPE_CHECKING:
    from ..course import Course


@click.command()
@click.argument("names", nargs=-1, required=True, metavar="ch04 | 4/16 | 11/1-11/6 | hw3 …")
@click.option(
    "-o", "--to", "path", required=True, type=FILE, help="The file to write, e.g. ch04.practice."
)
@count_option("--variants", 10, "Sets of numbers for each problem, the book's first.")
@click.option(
    "--help-level",
    "level",
    default="solution",
    show_default=True,
    type=click.Choice(["check", "hints", "solution"]),
    help="The most that a student is shown: whether an answer is right, and its mistake; then "
    "every step, with hints; then the solution.",
)
@course_option(
    "A course that grades such problems: no answer in the file is near one of its students', and "
    "problems whose answers are formulas, or the same for everybody, are left out."
)
def practice(
    names: tuple[str, ...], path: Path, variants: int, level: str, course: "Course | None"
) -> None:
    """Write a practice file for students.

    A student needs only the engine: practice("ch04.practice")["4/16"] shows text and figure, with
    new numbers on request, and checks answers and every step at once. Problems in symbols are asked
    with numbers. A tolerance, or less help than --help-level, on a sheet of the course or in the
    file of an assignment takes precedence. The file holds the answers for its own numbers only.
    """
    from ..assignment.chosen import named
    from ..practice import rules_of, write_practice

    chosen = named(names, course)
    problems, rules = list(chosen), {p.id: dict(own) for p, own in chosen.items()}
    with progress_bar() as bar:
        graded = class_numbers(bar, course)
        rules |= rules_of(course.path) if course else {}
        task = bar.add_task("solving and drawing", total=len(problems))
        left = write_practice(
            path, problems, variants, level, graded, done=lambda: bar.advance(task), rules=rules
        )
    for x in left:
        console.print(f"[yellow]{x.problem}[/] left out: {x.why}")
    click.echo(
        f"{path}: {amount(len(problems) - len(left), 'problem')}, at most {variants} sets of "
        f"numbers each, {path.stat().st_size / 1000:.0f} kB"
    )
    if not course:
        click.echo("Some of its answers may be graded ones; with --course COURSE none is near one.")
    click.echo(
        f'Students: from newton_euler.classroom import practice; practice("{path.name}")'
        f'["{next(p.id for p in problems if p.id not in {x.problem for x in left})}"]'
    )


@click.command()
@click.option("-o", "--to", "folder", type=FOLDER, help="The folder; default: in the engine.")
@click.option(
    "--course",
    type=click.Path(path_type=Path, exists=True, file_okay=False),
    help="A course: stay away from its graded numbers.",
)
def sets(folder: Path | None, course: Path | None) -> None:
    """Write the public practice files, one per chapter.

    They go into the engine of this checkout, where try_problem and practice() find them, and into
    its wheel. Their numbers are from a seed that no course uses.
    """
    from exercises.catalogue import select

    from ..practice.public import SETS, write_public

    folder = folder or SETS
    with step_counter("solving and drawing", len(select(["all"]))) as done:
        left = write_public(folder, course=course, done=done)
    for x in left:
        console.print(f"[yellow]{x.problem}[/] left out: {x.why}")
    size = sum(path.stat().st_size for path in folder.glob("*.practice"))
    click.echo(f"{folder}: {size / 1e6:.1f} MB")
