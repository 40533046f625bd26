"""Shared by the commands: the console, the progress bar, common options."""

import contextlib
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import TYPE_CHECKING, Any

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

if TYPE_CHECKING:  # its import takes longer than most commands
    from ..course import Course

STOPPED = 130  # exit code after Ctrl-C, as of a shell
BEGINS_ANEW = "Running the command again starts over."

console = Console(highlight=False)
FOLDER = click.Path(path_type=Path, file_okay=False)
FILE = click.Path(path_type=Path, dir_okay=False)
ONLY = click.option(
    "--problems",
    "--problem",
    "only",
    multiple=True,
    metavar="4/3 4/16 11/1-11/6",
    help="These problems, of any chapters.",
)
POINTS = click.option(
    "--points",
    multiple=True,
    metavar="4/3=10",
    help="The points of a problem; may be repeated. Default: one for each answer.",
)
PROBLEMS = click.option(
    "--problem", "only", multiple=True, metavar="4/16", help="Only these problems; may be repeated."
)
STUDENTS = click.option(
    "--student", "students", multiple=True, help="Only this student; may be repeated."
)
SEED = click.option(
    "--seed", type=int, help="Draw a variant of the numbers in place of the book's."
)

# keys in the context of a command: chapters of own problems, and their folders
OWN_PROBLEMS, FOLDERS = "own problems", "problems from"


def _use(context, _, folders):
    from exercises.catalogue.places import use

    context.meta[OWN_PROBLEMS] = [name for folder in folders for name in use(folder)]
    context.meta[FOLDERS] = folders


def _know(context, _, course_path):
    from ..course.folder import prepare

    if course_path:
        prepare(course_path)
        context.call_on_close(lambda: _reopen(course_path))
    return course_path


def _open(context, _, course_path):
    from ..course import Course

    return Course(_know(context, _, course_path)) if course_path else None


def _reopen(course_path):
    """Open files that a command has made to the group of a shared course."""
    from ..course import Course, CourseError
    from ..course.shared import open_to

    with contextlib.suppress(CourseError, OSError, KeyError):
        course = Course(course_path)
        if group := course.settings.get("group"):
            open_to(course.path, group)


def course_option(help: str, required: bool = False) -> Callable[[Any], Any]:
    """The option --course: the command gets the Course or None, with its problems and language in
    effect.
    """
    return click.option(
        "--course", required=required, type=FOLDER, is_eager=True, callback=_open, help=help
    )


COURSE = course_option("The course folder.", required=True)
NEW_COURSE = click.option(  # a folder that need not have a course yet
    "--course", "course_path", required=True, type=FOLDER, is_eager=True, callback=_know,
    help="The course folder.",
)  # fmt: skip


def count_option(name: str, default: int, help: str) -> Callable[[Any], Any]:
    """An option for a number of at least one."""
    return click.option(name, default=default, show_default=True, type=click.IntRange(1), help=help)


PROBLEMS_FROM = click.option(
    "--problems-from",
    multiple=True,
    type=FOLDER,
    is_eager=True,
    expose_value=False,
    callback=_use,
    help="A folder with chapters of your own problems: bridge/p03.yaml and p03.py for bridge/3. "
    "A course built with it remembers it.",
)


def remember_problems(course: "Course") -> None:
    """Write the folders of --problems-from into course.json, those in the course as relative."""
    folders = [p.resolve() for p in click.get_current_context().meta.get(FOLDERS) or ()]
    here = [str(p.relative_to(course.path) if course.path in p.parents else p) for p in folders]
    known = course.settings.get("problems_from", [])
    if set(here) - set(known):
        course.set(problems_from=[*known, *(h for h in here if h not in known)])


def names_or_all(names: tuple[str, ...]) -> tuple[str, ...]:
    """The names, or by default all problems, of --problems-from if given."""
    own = click.get_current_context().meta.get(OWN_PROBLEMS)
    return names or tuple(own or ("all",))


class Stopped(KeyboardInterrupt):
    """Ctrl-C, with the progress so far and what the next run does."""


@contextlib.contextmanager
def progress_bar(*columns: ProgressColumn, then: str = BEGINS_ANEW) -> Iterator[Progress]:
    """A progress bar on the shared console, with counts and time. Ctrl-C raises :class:`Stopped`,
    with the progress so far and the sentence ``then``.
    """
    from ..course.processes import ctrl_c_not_ignored

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
        with ctrl_c_not_ignored(), bar:
            yield bar
    except KeyboardInterrupt:
        far = "; ".join(map(_how_far, bar.tasks)) or "Nothing was done"
        raise Stopped(f"{far}. {then}") from None


def amount(n: int, what: str) -> str:
    """ "1 student", "2 students"."""
    return f"{n} {what}{'s' * (n != 1)}"


@contextlib.contextmanager
def step_counter(what: str, total: float) -> Iterator[Callable[..., None]]:
    """A function to call after each of ``total`` steps, or with the amount done, shown by a
    :func:`progress_bar`.
    """
    with progress_bar() as bar:
        task = bar.add_task(what, total=total)
        yield lambda share=1: bar.advance(task, share)


def class_numbers(bar: Progress, course: "Course | None") -> dict[str, list[dict[str, Any]]] | None:
    """The numbers that a course grades, None without one; ``bar`` shows how many are read."""
    from ..practice import graded_numbers

    if course is None:
        return None
    task = bar.add_task("reading the course's numbers", total=None)
    return graded_numbers(course.path, lambda n, of: bar.update(task, completed=n, total=of))


def _how_far(task):
    """The progress of a task: a count, or a percentage if the total is 1."""
    done = f"{task.completed:g} of {task.total or '?'}"
    return f"{task.description}: {f'{task.percentage:.0f} %' if task.total == 1.0 else done}"
