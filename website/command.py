"""The command ``python -m website``."""

import os
from collections.abc import Iterator
from contextlib import contextmanager
from functools import partial
from pathlib import Path

import click

from grader.commands.shared import FOLDER, PROBLEMS_FROM, progress_bar
from newton_euler.algebra.language import VARIABLE, speaking
from newton_euler.algebra.language import languages as known_languages

SETTINGS = {"help_option_names": ["-h", "--help"], "max_content_width": 100, "show_default": True}


@click.group(context_settings=SETTINGS, invoke_without_command=True)
@click.option(
    "--out",
    default="_site",
    type=FOLDER,
    help="Folder for the pages, empty or written by an earlier build.",
)
@click.option(
    "--chapters",
    "names",
    multiple=True,
    metavar="NAME",
    show_default="all",
    help="Only this chapter, e.g. ch04; may be repeated.",
)
@click.option(
    "--no-run", is_flag=True, help="Run no notebook: those without cached outputs have none."
)
@click.option("--engine/--no-engine", default=True, help="Add Python and the engine to the pages.")
@click.option(
    "--packages",
    default="",
    metavar="URL",
    help="Folder of Pyodide's other packages, from which readers may load NumPy, if its "
    "server lets this site read it (CORS).",
)
@click.option(
    "--course",
    type=click.Path(path_type=Path, exists=True, file_okay=False),
    show_default="none",
    help="A course: practice stays away from its graded numbers.",
)
@click.option(
    "--language",
    default="en",
    type=click.Choice(known_languages()),
    help="Language of the site; what is not translated stays in English.",
)
@click.option(
    "--beside",
    multiple=True,
    metavar="LANGUAGE=ADDRESS",
    help="Link the same pages in another language, as en=../ from _site/de; may be repeated.",
)
@PROBLEMS_FROM
@click.pass_context
def main(
    context: click.Context,
    out: Path,
    names: tuple[str, ...],
    no_run: bool,
    engine: bool,
    packages: str,
    course: Path | None,
    language: str,
    beside: tuple[str, ...],
) -> None:
    """Build the course as static pages, readable in a browser without network or Python.

    The pages are the chapters with the outputs of their cells, films included; the statements of
    the problems, without answers; and the reference of the engine. Open _site/index.html, or put
    the folder on any web server.

    Notebooks run in a kernel that sees only the engine of this checkout. Outputs are cached in
    .site_cache until the notebook or the engine changes. The first build takes some minutes, most
    of them for speed_and_accuracy; the next one less than one.

    \b
    Examples:
      python -m website
      python -m website --chapters ch04 --out _ch04     one chapter and its problems
      python -m website --no-run                        the present texts, at once
      python -m website --language de --out _site/de --beside en=../
      python -m website translations de                 what is missing or stale

    Python for the browser (Pyodide, 14 MB) is fetched from npm once; readers load it at their first
    computation, from a web server only.

    An error in a cell or a broken link stops the build and is reported with its place.
    """
    from . import build as steps
    from .execution import WebsiteError
    from .notebooks import chapters

    if context.invoked_subcommand:
        return
    known = [c.name for c in chapters()]
    if unknown := {*names} - {*known, *(c.stem for c in chapters())}:
        raise click.UsageError(f"there is no chapter {min(unknown)}; there are {', '.join(known)}")
    if wrong := [x for x in beside if not all(x.partition("="))]:
        raise click.UsageError(f"--beside {wrong[0]}: expected LANGUAGE=ADDRESS, as en=../")
    try:
        with progress_bar() as bar, in_every_process(language):
            left = steps.build(
                out,
                names,
                lambda c: not no_run,
                progress=lambda step, number: partial(
                    bar.advance, bar.add_task(step, total=number)
                ),
                with_engine=engine,
                packages=packages,
                course=course,
                beside=dict(x.split("=", 1) for x in beside),
            )
    except WebsiteError as error:
        raise click.ClickException(str(error)) from None
    files = [path for path in out.rglob("*") if path.is_file()]
    pages = sum(path.suffix == ".html" for path in files)
    size = sum(path.stat().st_size for path in files) / 1e6
    click.echo(f"{pages} pages, {size:.0f} MB; open {out / 'index.html'}")
    if left:
        click.echo(f"left out: {', '.join(left)}")


@contextmanager
def in_every_process(name: str) -> Iterator[None]:
    """Make this the current language, here and in kernels that are started."""
    before = os.environ.get(VARIABLE, "")
    os.environ[VARIABLE] = name
    try:
        with speaking(name):
            yield
    finally:
        os.environ[VARIABLE] = before


@main.command()
@click.argument("language", metavar="LANGUAGE")
@click.option("--write", is_flag=True, help="Update the sentences in its catalogues.")
@click.option(
    "--done",
    multiple=True,
    metavar="FILE",
    type=click.Path(path_type=Path, exists=True, dir_okay=False),
    help="Mark the translation in this file as current; may be repeated.",
)
@click.option(
    "--problem",
    "begun",
    multiple=True,
    metavar="NUMBER",
    help="Begin the translation of this problem with its English texts; may be repeated.",
)
@click.option("--all", "every", is_flag=True, help="List every missing text.")
def translations(
    language: str, write: bool, done: tuple[Path, ...], begun: tuple[str, ...], every: bool
) -> None:
    """Show what is missing or stale in LANGUAGE, as de.

    Sentences are in newton_euler/algebra/languages/de.po, the texts of a problem in
    exercises/ch09/de/p01.yaml, a chapter in chapters/de/ch09_rotors.ipynb and its predictions in
    ch09_rotors.po. A translation is stale when its source has changed, until --done marks it as
    current.
    """
    from exercises.catalogue.sources import begin

    from . import translations as found

    if write:
        for path in found.write_catalogues(language):
            click.echo(f"written: {path}")
    for number in begun:
        click.echo(f"to translate: {begin(number, language)}")
    found.mark(done)
    for part in found.report(language):
        lacks = [f"{len(part.missing)} missing"] * bool(part.missing)
        stale = [f"stale: {', '.join(part.stale)}"] * bool(part.stale)
        click.echo(f"{part.percent:3} % of {part.all:4}  {part.name}  {'; '.join(lacks + stale)}")
        for text in part.missing if every else ():
            click.echo(f"       {text}")
