"""What the commands share: the console, the progress bar, the option that names a course."""

from pathlib import Path

import click
from rich.console import Console
from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn, TimeElapsedColumn

console = Console(highlight=False)
COURSE = click.option(
    "--course",
    "course_path",
    required=True,
    type=click.Path(path_type=Path, file_okay=False),
    help="The course folder.",
)


def progress_bar(*columns):
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
