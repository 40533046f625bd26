"""Commands that report on graded assignments."""

from pathlib import Path
from typing import TYPE_CHECKING

import click

from .shared import COURSE, FILE, amount, console

if TYPE_CHECKING:
    from ..course import Course


@click.command()
@click.argument("assignment")
@COURSE
@click.option("--csv", "csv_path", type=FILE, help="Also write them to this file.")
@click.option("--png", "png_path", type=FILE, help="Also draw them into this file.")
def stats(assignment: str, course: "Course", csv_path: Path | None, png_path: Path | None) -> None:
    """Print statistics of a graded assignment, part by part.

    Difficulty is the mean share of the points (1 is easy); discrimination is the correlation with
    the points of all other parts. The file of --csv has the frequency of every mistake.
    """
    from ..reports import part_statistics, statistics_csv, statistics_figure, statistics_table

    parts = part_statistics(course, assignment)
    console.print(statistics_table(parts))
    if csv_path:
        statistics_csv(parts, csv_path)
        click.echo(f"Wrote {csv_path}")
    if png_path:
        statistics_figure(parts, png_path)
        click.echo(f"Wrote {png_path}")


@click.command()
@click.argument("assignment")
@COURSE
@click.option(
    "--format",
    "form",
    type=click.Choice(["parts", "canvas", "moodle", "gradescope"]),
    default="parts",
    show_default=True,
    help="A line for every part of every student, or the file that a learning platform imports.",
)
@click.option(
    "--to", "path", type=FILE, help="The file to write; default: ASSIGNMENT-FORMAT.csv, here."
)
@click.option(
    "--penalties/--no-penalties",
    default=True,
    help="Subtract the penalties for lateness, or leave them to the platform.",
    show_default=True,
)
def export(
    assignment: str, course: "Course", form: str, path: Path | None, penalties: bool
) -> None:
    """Write the results of a graded assignment as CSV.

    The points are those of the gradebook: with manual grades and extra credit, minus the penalty
    for lateness. The lines of --format parts have the points before any penalty.

    \b
    Canvas:      Gradebook > Import
    Moodle:      Grades > Import > CSV file; map from "Email address", or from "Username" or
                 "ID number", which hold the ids of the roster
    Gradescope:  has no import; these are the columns of its own download
    """
    from ..reports import export as write

    path = path or Path(f"{assignment}-{form}.csv")
    waiting, late = write(course, assignment, form, path, penalties)
    click.echo(f"Wrote {path}")
    if late and form != "parts":
        what = "subtracted; see --no-penalties" if penalties else "not subtracted"
        click.echo(f"The penalties of {amount(late, 'student')} for lateness are {what}.")
    if waiting:
        click.echo(
            f"{amount(waiting, 'student')} with cells that wait for a person (nbgrader's "
            "formgrader): these points are not final."
        )
