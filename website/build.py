"""The steps of a build: run the notebooks, draw the figures, write Sphinx's source, call Sphinx."""

import io
import re
import shutil
import tempfile
import warnings
from collections.abc import Callable, Collection, Mapping
from pathlib import Path

import nbformat

from newton_euler.algebra.language import language

from . import (
    chapter_pages,
    contents,
    engine,
    formulas,
    landing,
    languages,
    pictures,
    practice_sets,
    problem_index,
    problem_pages,
    reference,
)
from .execution import WebsiteError, with_outputs
from .kept import ROOT
from .notebooks import FOLDER, Chapter, chapters, translation

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
    beside: Mapping[str, str] | None = None,
) -> list[str]:
    """Build the site in the folder ``out``; return what was left out: the engine, the outputs of
    chapters.

    names : of chapters, as "ch04"; by default all
    run : whether the notebook of a chapter may be run if its outputs are not cached
    folder : of the notebooks
    cache : folder of cached outputs and figures
    progress : called with a step, the number done, and the number in all
    with_engine : add Python and the engine, if Pyodide is in ``cache`` or npm provides it
    packages : address of Pyodide's other packages, from which readers may load NumPy
    practised : the chapters with practice on their problem pages; by default all
    course : the folder of a course; practice stays away from its graded numbers
    beside : {other language: address of its site from the root of this one}

    The site is in the current language; what is not translated is in English.
    """
    cache = Path(cache)
    python = engine.pyodide(cache / "npm") if with_engine else None
    wanted = problem_pages.names(names)
    found = [translation(c, language()) or c for c in chapters(names, folder)]
    ran = with_outputs(found, cache / "executed", run, _counter(progress, "notebooks", len(found)))
    count = sum(bool(p.figure) for name in wanted for p in problem_pages.problems(name))
    figures = problem_pages.figures(wanted, cache / "figures", _counter(progress, "figures", count))
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
        _write_source(source, found, ran, wanted, figures, pages / "moving" if python else None)
        shown = languages.settings(found, wanted, beside or {})
        _sphinx(source, pages, bool(names), progress, ["engine"] if python else [], shown)
        languages.write_words(pages)
        pictures.take_out(pages)
        formulas.typeset(pages, cache / "npm")
        if python:
            engine.write(pages, python, packages)
            (pages / "practice").mkdir()
            for name, data in found_sets.items():
                (pages / "practice" / name).write_bytes(data)
        (pages / ".nojekyll").touch()  # without it GitHub leaves out folders like _static
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


def _write_source(source, found, ran, wanted, figures, moving):
    _write_chapters(source / "chapters", found, ran, moving)
    _write_problems(source / "problems", wanted, found, figures)
    pages = reference.pages()
    for name, text in pages.items():
        _write(source / "reference" / f"{name}.rst", text)
    question = landing.question() if "ch04" in wanted else ""
    _write(source / "index.md", contents.page(found, wanted, reference.titles(pages), question))


def _emptied(folder):
    """The folder, emptied if this command has written it; refused if it holds other files."""
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


def _write_problems(folder, names, found, figures):
    notebooks = {c.name: c.path.name for c in found}
    for name in names:
        _write(folder / f"{name}.md", problem_pages.page(name, notebooks.get(name, "")))
        for file, text in problem_pages.own_pages(name).items():
            _write(folder / file, text)
    _write(folder / "index.md", problem_index.page(names))
    _write(folder / "own.md", problem_pages.taken())
    for name, svg in figures.items():
        (folder / "figures").mkdir(exist_ok=True)
        (folder / "figures" / name).write_bytes(svg)


def _sphinx(source, out, partial, progress, tags, changed):
    """Call Sphinx, with warnings as errors, except for links out of a partial site."""
    from sphinx.application import Sphinx
    from sphinx.util.docutils import docutils_namespace

    output = io.StringIO()
    if partial:
        changed = {**changed, "suppress_warnings": ["myst.xref_missing", "toc.not_readable"]}
    progress("pages", 0, 1)
    # so that Sphinx's registrations with docutils do not reach the next site of this process
    with warnings.catch_warnings(), docutils_namespace():
        warnings.simplefilter("ignore")  # Sphinx's extensions warn about each other
        trees = out.parent / "doctrees"
        app = Sphinx(source, THEME, out, trees, "html", changed, None, output, tags=tags)
        app.build(force_all=True)
    progress("pages", 1, 1)
    warned = re.sub(r"\x1b\[[\d;]*m", "", output.getvalue()).replace(f"{source}/", "").strip()
    if warned or app.statuscode:
        raise WebsiteError(f"Sphinx does not accept the pages:\n{warned}")
