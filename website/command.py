"""The command ``python -m website``."""

from pathlib import Path

import click
from rich.console import Console
from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn, TimeElapsedColumn

from grader.commands.shared import PROBLEMS_FROM

SETTINGS = {"help_option_names": ["-h", "--help"], "max_content_width": 100, "show_default": True}


@click.command(context_settings=SETTINGS)
@click.option(
    "--out",
    default="_site",
    type=click.Path(path_type=Path, file_okay=False),
    help="Folder of the pages. One that holds other files is refused.",
)
@click.option(
    "--chapters",
    "names",
    multiple=True,
    metavar="NAME",
    show_default="all",
    help="Only this chapter, as ch04; may be repeated.",
)
@click.option(
    "--no-run",
    is_flag=True,
    help="Run no notebook: one whose outputs are not kept is shown without them.",
)
@click.option("--engine/--no-engine", default=True, help="Put Python and the engine beside them.")
@click.option(
    "--packages",
    default="",
    metavar="URL",
    help="Folder with Pyodide's other packages: readers may then fetch NumPy from there.",
)
@click.option(
    "--course",
    type=click.Path(path_type=Path, exists=True, file_okay=False),
    show_default="none",
    help="Nobody practises near the numbers that this course grades.",
)
@PROBLEMS_FROM
def main(
    out: Path,
    names: tuple[str, ...],
    no_run: bool,
    engine: bool,
    packages: str,
    course: Path | None,
) -> None:
    """Build the course as static pages, to read in a browser without network and without Python.

    The pages are the chapters with all that their cells print and draw, films included; the
    statements of the problems, without answers; and the reference of the engine. Open
    _site/index.html, or put the folder on any web server.

    A notebook is run in a kernel that finds the engine and nothing else of this checkout. What
    comes out is kept in .site_cache, and run again when the notebook or the engine has changed. The
    first build takes some minutes, most of them for speed_and_accuracy; the next one less than one.

    \b
    Examples:
      python -m website
      python -m website --chapters ch04 --out _ch04     one chapter with its problems
      python -m website --no-run                        the texts as they are now, at once

    Python for the browser (Pyodide, 14 MB) comes from npm, once; readers load it when they touch
    what computes, and it works from a web server only.

    An error in a cell or a broken link ends the build; its place is reported.
    """
    from . import build as steps
    from .execution import WebsiteError
    from .notebooks import chapters

    known = {c.name for c in chapters()} | {c.stem for c in chapters()}
    if unknown := [n for n in names if n not in known]:
        raise click.UsageError(f"there is no chapter {unknown[0]}; there are {_list(chapters())}")
    try:
        with _bar() as bar:
            left = steps.build(
                out,
                names,
                lambda c: not no_run,
                progress=_shown(bar),
                with_engine=engine,
                packages=packages,
                course=course,
            )
    except WebsiteError as error:
        raise click.ClickException(str(error)) from None
    pages = sum(1 for _ in out.rglob("*.html"))
    click.echo(f"{pages} pages, {_megabytes(out):.0f} MB; open {out / 'index.html'}")
    if left:
        click.echo(f"left out: {', '.join(left)}")


def _list(found):
    return ", ".join(
        c.name if c.name[-1].isdigit() or c.name[:3] == "app" else c.stem for c in found
    )


def _megabytes(folder):
    return sum(path.stat().st_size for path in folder.rglob("*") if path.is_file()) / 1e6


def _bar():
    console = Console(stderr=True)
    columns = TextColumn("{task.description:10}"), BarColumn(), MofNCompleteColumn()
    return Progress(*columns, TimeElapsedColumn(), console=console, disable=not console.is_terminal)


def _shown(bar):
    tasks = {}

    def progress(step, done, number):
        if step not in tasks:
            tasks[step] = bar.add_task(step, total=number)
        bar.update(tasks[step], completed=done)

    return progress
