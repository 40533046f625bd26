"""What the commands share: the console, the progress bar, the option that names a course."""

from pathlib import Path

import click
from rich.console import Console
from rich.progress import (
    BarColumn,
    MofNCompleteColumn,
    Progress,
    ProgressColumn,
    TextColumn,
    TimeElapsedColumn,
)

console = Console(highlight=False)
FOLDER = click.Path(path_type=Path, file_okay=False)
FILE = click.Path(path_type=Path, dir_okay=False)
COURSE = click.option(
    "--course", "course_path", required=True, type=FOLDER, help="The course folder."
)

PROBLEMS = click.option(
    "--problem", "only", multiple=True, metavar="4/16", help="Only these problems; may be repeated."
)
SEED = click.option("--seed", type=int, help="Draw a variant of the numbers, not the book's.")


def progress_bar(*columns: ProgressColumn) -> Progress:
    """A progress bar on the shared console, with how many of how many and the time."""
    return Progress(
        TextColumn("{task.description}"),
        BarColumn(),
        MofNCompleteColumn(),
        *columns,
        TimeElapsedColumn(),
        console=console,
        transient=not console.is_terminal,
    )
