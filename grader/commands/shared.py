"""What the commands share: the console, the progress bar, the option that names a course."""

import contextlib
from collections.abc import Iterator
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

STOPPED = 130  # exit code after Ctrl-C, as of a shell
BEGINS_ANEW = "The same command begins anew."

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


class Stopped(KeyboardInterrupt):
    """Ctrl-C, with how far the run came and what the next one does."""


@contextlib.contextmanager
def progress_bar(*columns: ProgressColumn, then: str = BEGINS_ANEW) -> Iterator[Progress]:
    """A progress bar on the shared console, with how many of how many and the time. Ctrl-C within
    is :class:`Stopped`, with how far it came and what follows ``then``.
    """
    bar = Progress(
        TextColumn("{task.description}"),
        BarColumn(),
        MofNCompleteColumn(),
        *columns,
        TimeElapsedColumn(),
        console=console,
        transient=not console.is_terminal,
    )
    try:
        with bar:
            yield bar
    except KeyboardInterrupt:
        far = "; ".join(map(_how_far, bar.tasks)) or "Nothing was done"
        raise Stopped(f"{far}. {then}") from None


def _how_far(task):
    """How much of a task is done: a count, or a share where the whole is 1."""
    done = f"{task.completed:g} of {task.total or '?'}"
    return f"{task.description}: {f'{task.percentage:.0f} %' if task.total == 1.0 else done}"
