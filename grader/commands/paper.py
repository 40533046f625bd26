"""The command ``paper``: sheets and keys as PDF."""

from pathlib import Path
from typing import TYPE_CHECKING

import click

from .courses import ID_COLUMN
from .shared import FOLDER, ONLY, POINTS, amount, course_option, step_counter

if TYPE_CHECKING:
    from ..course import Course


@click.command()
@click.argument("assignment")
@click.argument("more", nargs=-1, metavar="")
@click.option(
    "--students",
    type=click.Path(exists=True, dir_okay=False),
    help="The roster, as for build. Default: that of the course.",
)
@ID_COLUMN
@course_option("A course: its present assignment, its students, the numbers of their sheets.")
@ONLY
@POINTS
@click.option(
    "--key-for",
    multiple=True,
    metavar="LOGIN|all",
    help="Write only the keys of these students, again.",
)
@click.option(
    "-o", "--to", "folder", type=FOLDER, help="Default: COURSE/paper/NAME, or NAME-paper here."
)
def paper(
    assignment: str,
    more: tuple[str, ...],
    students: str | None,
    id_column: str | None,
    course: "Course | None",
    only: tuple[str, ...],
    points: tuple[str, ...],
    key_for: tuple[str, ...],
    folder: Path | None,
) -> None:
    """Write PDFs for printing: a sheet for each student, with own numbers and figures, and keys.

    A sheet has room for answers and the same code as its key. A key has the student's numbers, the
    answers with their tolerance, and their derivation; keys/overview.pdf has all answers.
    ASSIGNMENT is one of the course, a file as hw3.yaml, or a chapter.

    \b
    paper hw3 --course ~/mechanics                      the numbers of their notebooks
    paper ch04 --students roster.csv                    numbers from a secret in ch04-paper/
    paper hw3 --problems 4/3 4/16 --students roster.csv
    paper hw3 --course ~/mechanics --key-for ada        one key again
    """
    from ..assignment.chosen import chosen
    from ..course import read_roster
    from ..paper import PaperError, write_papers

    spec = chosen(assignment, (*only, *more), points, course)
    if students:
        class_ = read_roster(students, id_column).students
    else:
        class_ = course.students() if course else []
    if not class_:
        raise PaperError(
            "there are no students: name a roster (--students roster.csv), or a course that has "
            "some (--course)"
        )
    home = course.path / "paper" / spec.name if course else Path(f"{spec.name}-paper")
    folder = folder or home
    with step_counter("writing", len(set(key_for) or class_)) as done:
        written = write_papers(folder, spec, class_, course, key_for, done=done)
    if written.sheets:
        click.echo(f"{amount(len(written.sheets), 'sheet')} in {folder / 'sheets'}")
    click.echo(f"{amount(len(written.keys), 'key')} in {folder / 'keys'}: not for students")
    if spec.left_out:
        click.echo(f"Left out, since paper does not run it: {', '.join(spec.left_out)}", err=True)
