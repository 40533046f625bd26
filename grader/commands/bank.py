"""The command ``bank``: questions for a learning platform."""

import hashlib
import hmac
from pathlib import Path
from typing import TYPE_CHECKING

import click

from .shared import FILE, ONLY, amount, class_numbers, count_option, course_option, progress_bar

if TYPE_CHECKING:
    from ..course import Course


@click.command()
@click.argument("assignment")
@click.argument("more", nargs=-1, metavar="")
@ONLY
@click.option(
    "--format", "form", required=True, type=click.Choice(["moodle", "qti", "canvas"]),
    help="Moodle's XML; a package of QTI 2.1; Canvas' package, of QTI 1.2.",
)  # fmt: skip
@count_option("--variants", 10, "Sets of numbers for each problem, from which the platform draws.")
@click.option(
    "-o",
    "--to",
    "path",
    type=FILE,
    help="Default: NAME-FORMAT.xml or .zip, here, readable by you alone.",
)
@course_option(
    "A course: its present assignment; no answer in the bank is near one of its students', "
    "and the numbers come from its secret."
)
@click.option("--seed", type=int, help="Draw other numbers.")
def bank(
    assignment: str,
    more: tuple[str, ...],
    only: tuple[str, ...],
    form: str,
    variants: int,
    path: Path | None,
    course: "Course | None",
    seed: int | None,
) -> None:
    """Write a bank of questions that a learning platform imports.

    Each has variants with numbers and figures of their own, the tolerance of our grading, and each
    listed mistake as a wrong answer with its diagnosis as feedback. Problems in symbols are asked
    with numbers. Whatever the platform cannot ask is listed, also in FILE.txt.

    \b
    bank hw3 --course ~/mechanics --format moodle --variants 20
    bank ch04 --format canvas -o ch04.zip
    bank hw3 --problems 4/3 11/1-11/6 --format qti

    \b
    Moodle:  Question bank > Import > Moodle XML; a category for each problem
    Canvas:  Settings > Import Course Content > QTI .zip file; a group for each number asked for
    """
    from ..assignment.chosen import chosen
    from ..course.files import write_text
    from ..lms import FORMATS, write_bank

    spec = chosen(assignment, (*only, *more), (), course)
    path = path or Path(f"{spec.name}-{form}{FORMATS[form][1]}")
    text = f"bank {spec.name} {'' if seed is None else seed}"
    if course:  # so that students with this program cannot derive the numbers
        text = hmac.new(course.secret, text.encode(), hashlib.sha256).hexdigest()
    with progress_bar() as bar:
        graded = class_numbers(bar, course)
        task = bar.add_task("solving and drawing", total=len(spec.problems))
        made = write_bank(path, spec, form, variants, text, graded, done=lambda: bar.advance(task))
    for note in made.notes:
        click.echo(note, err=True)
    write_text(path.with_name(path.name + ".txt"), "\n".join([*made.notes, ""]))
    made_of = f"{amount(made.questions, 'question')} of {amount(made.problems, 'problem')}"
    click.echo(f"{path}: {made_of}")
