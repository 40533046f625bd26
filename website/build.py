"""The steps of a build: run the notebooks, draw the figures, write Sphinx's source, call Sphinx."""

import io
import re
import shutil
import tempfile
import warnings
from collections.abc import Callable, Collection
from pathlib import Path

import nbformat

from . import (
    chapter_pages,
    contents,
    engine,
    landing,
    practice_sets,
    problem_index,
    problem_pages,
    reference,
)
from .execution import WebsiteError, with_outputs
from .kept import ROOT
from .notebooks import FOLDER, Chapter, chapters

THEME = Path(__file__).with_name("theme")
CACHE = ROOT / ".site_cache"


def build(
    out: str | Path,
    names: Collection[str] = (),
    run: Callable[[Chapter], bool] = lambda chapter: True,
    folder: Path = FOLDER,
    cache: Path = CACHE,
    progress: Callable[[str, int, int], object] = lambda step, done, number: None,
    with_engine: bool = True,
    packages: str = "",
    practised: Collection[str] | None = None,
    course: Path | None = None,
) -> list[str]:
    """Build the site in the folder ``out``; returns what is not in it: the engine, the outputs of
    chapters.

    names : of chapters, as "ch04"; by default all
    run : function of a chapter, whether its notebook may be run where no outputs are kept
    folder : of the notebooks
    cache : folder of the outputs and figures that are kept
    progress : called with a step, and how much of it is done of how much
    with_engine : puts Python and the engine beside the pages, where npm or ``cache`` has Pyodide
    packages : address of Pyodide's other packages, of which a reader may ask for NumPy
    practised : the chapters whose problems are checked on their pages; by default all
    course : the folder of a course, near whose graded numbers nobody practises
    """
    python = engine.pyodide(cache / "npm") if with_engine else None
    found, wanted = chapters(names, folder), problem_pages.names(names)
    ran = with_outputs(found, cache / "executed", run, _counter(progress, "notebooks", len(found)))
    count = sum(bool(p.figure) for name in wanted for p in problem_pages.problems(name))
    pictures = problem_pages.figures(
        wanted, cache / "figures", _counter(progress, "figures", count)
    )
    practised = [name for name in wanted if practised is None or name in practised]
    count = sum(len(problem_pages.problems(name)) for name in practised if python)
    found_sets = practice_sets.sets(
        practised if python else (),
        cache / "practice",
        _counter(progress, "practice", count),
        course,
    )
    with tempfile.TemporaryDirectory() as work:
        source, pages = Path(work) / "source", Path(work) / "pages"
        _write_source(source, found, ran, wanted, pictures, pages / "moving" if python else None)
        _sphinx(source, pages, bool(names), progress, ["engine"] if python else [])
        if python:
            engine.write(pages, python, packages)
            (pages / "practice").mkdir()
            for name, data in found_sets.items():
                (pages / "practice" / name).write_bytes(data)
        (pages / ".nojekyll").touch()  # else GitHub leaves out folders like _static
        shutil.copytree(pages, _emptied(Path(out)), dirs_exist_ok=True)
    without = [f"outputs of {c.stem}" for c in found if ran[c.stem] is None]
    return without + ["engine (npm does not reach Pyodide)"] * (with_engine and not python)


def _counter(progress, step, number):
    done = 0

    def count(more=1):
        nonlocal done
        done += more if isinstance(more, int) else 1
        progress(step, done, number)

    return count


def _write_source(source, found, ran, wanted, pictures, moving):
    _write_chapters(source / "chapters", found, ran, moving)
    _write_problems(source / "problems", wanted, found, pictures)
    pages = reference.pages()
    for name, text in pages.items():
        _write(source / "reference" / f"{name}.rst", text)
    question = landing.question() if "ch04" in wanted else ""
    _write(source / "index.md", contents.page(found, wanted, reference.titles(pages), question))


def _emptied(folder):
    """The folder, empty. Only one that this command has written is emptied."""
    mark = folder / ".newton-euler-site"
    if folder.exists() and any(folder.iterdir()) and not mark.exists():
        raise WebsiteError(f"{folder} holds other files; choose an empty or a new folder")
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    mark.touch()
    return folder


def _write(path, text):
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(text, encoding="utf-8")


def _write_chapters(folder, found, ran, moving):
    for c in found:
        notebook = ran[c.stem] or nbformat.read(c.path, as_version=4)
        page = chapter_pages.page(notebook, ran[c.stem] is not None, moving)
        _write(folder / c.path.name, nbformat.writes(page))


def _write_problems(folder, names, found, pictures):
    notebooks = {c.name: c.path.name for c in found}
    for name in names:
        _write(folder / f"{name}.md", problem_pages.page(name, notebooks.get(name, "")))
        for file, text in problem_pages.own_pages(name).items():
            _write(folder / file, text)
    _write(folder / "index.md", problem_index.page(names))
    for name, png in pictures.items():
        (folder / "figures").mkdir(exist_ok=True)
        (folder / "figures" / name).write_bytes(png)


def _sphinx(source, out, partial, progress, tags):
    """Call Sphinx; every warning is an error, except for links out of a part of the site."""
    from sphinx.application import Sphinx

    output = io.StringIO()
    changed = {"suppress_warnings": ["myst.xref_missing", "toc.not_readable"]} if partial else {}
    progress("pages", 0, 1)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # Sphinx's extensions warn about each other
        trees = out.parent / "doctrees"
        app = Sphinx(source, THEME, out, trees, "html", changed, None, output, tags=tags)
        app.build(force_all=True)
    progress("pages", 1, 1)
    warned = re.sub(r"\x1b\[[\d;]*m", "", output.getvalue()).replace(f"{source}/", "").strip()
    if warned or app.statuscode:
        raise WebsiteError(f"Sphinx does not accept the pages:\n{warned}")
