"""The steps of a build: run the notebooks, draw the figures, write Sphinx's source, call Sphinx."""

import io
import re
import shutil
import tempfile
import warnings
from collections.abc import Callable, Collection, Mapping
from functools import partial
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
from .notebooks import FOLDER, Chapter, chapters, translation
from .rendering import rendered

THEME = Path(__file__).with_name("theme")


def build(
    out: str | Path,
    names: Collection[str] = (),
    run: Callable[[Chapter], bool] = lambda chapter: True,
    folder: Path = FOLDER,
    progress: Callable[[str, int], Callable[..., object]] = lambda *_: lambda done=1: None,
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
    progress : takes a step and the number of things to do in it; what it returns is called with the
    number done, by default 1
    with_engine : add Python and the engine, if Pyodide is cached or npm provides it
    packages : address of Pyodide's other packages, from which readers may load NumPy
    practised : the chapters with practice on their problem pages; by default all
    course : the folder of a course; practice stays away from its graded numbers
    beside : {other language: address of its site from the root of this one}

    The site is in the current language; what is not translated is in English.
    """
    python = engine.PYODIDE.files(*engine.FILES) if with_engine else None
    wanted = problem_pages.names(names)
    found = [translation(c, language()) or c for c in chapters(names, folder)]
    ran = with_outputs(found, run, partial(progress, "notebooks"))
    figures = problem_pages.figures(wanted, partial(progress, "figures"))
    practised = [name for name in wanted if practised is None or name in practised]
    sets = practice_sets.sets(practised if python else (), partial(progress, "practice"), course)
    with tempfile.TemporaryDirectory() as work:
        source, pages = Path(work) / "source", Path(work) / "pages"
        moving = pages / "moving" if python else None
        for name, text in _sources(found, ran, wanted, figures, moving):
            path = source / name
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text, encoding="utf-8")
        shown = languages.settings(found, wanted, beside or {})
        done = progress("pages", 1)
        _sphinx(source, pages, bool(names), ["engine"] if python else [], shown)
        done()
        languages.write_words(pages)
        pictures.take_out(pages)
        formulas.typeset(pages)
        if python:
            engine.write(pages, python, packages)
            (pages / "practice").mkdir()
            for name, data in sets.items():
                (pages / "practice" / name).write_bytes(data)
        (pages / ".nojekyll").touch()  # without it GitHub leaves out folders like _static
        shutil.copytree(pages, _emptied(Path(out)), dirs_exist_ok=True)
    without = [f"outputs of {c.stem}" for c in found if ran[c.stem] is None]
    return without + ["engine (npm cannot reach Pyodide)"] * (with_engine and not python)


def _emptied(folder):
    """The folder, emptied if this command has written it; refused if it holds other files."""
    mark = folder / ".newton-euler-site"
    if folder.exists() and any(folder.iterdir()) and not mark.exists():
        raise WebsiteError(f"{folder} holds other files; choose an empty or a new folder")
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    mark.touch()
    return folder


def _sources(found, ran, wanted, figures, moving):
    """(name, text) of the files that Sphinx reads."""
    for c in found:
        notebook = ran[c.stem] or nbformat.read(c.path, as_version=4)
        page = chapter_pages.page(notebook, ran[c.stem] is not None, moving)
        yield f"chapters/{c.path.name}", nbformat.writes(page)
    notebooks = {c.name: c.path.name for c in found}
    for name in wanted:
        yield f"problems/{name}.md", problem_pages.page(name, notebooks.get(name, ""))
        for file, text in problem_pages.own_pages(name):
            yield f"problems/{file}", text
    for name, svg in figures.items():
        yield f"problems/figures/{name}", svg
    yield "problems/index.md", problem_index.page(wanted)
    yield "problems/own.md", rendered("taken.md")
    described = reference.pages()
    for name, text in described.items():
        yield f"reference/{name}.rst", text
    titles = {name: text.partition("\n")[0] for name, text in described.items()}
    question = landing.question() if "ch04" in wanted else ""
    yield "index.md", contents.page(found, wanted, titles, question)


def _sphinx(source, out, partial, tags, changed):
    """Call Sphinx, with warnings as errors, except for links out of a partial site."""
    from sphinx.application import Sphinx
    from sphinx.util.docutils import docutils_namespace

    output = io.StringIO()
    if partial:
        changed = {**changed, "suppress_warnings": ["myst.xref_missing", "toc.not_readable"]}
    # so that Sphinx's registrations with docutils do not reach the next site of this process
    with warnings.catch_warnings(), docutils_namespace():
        warnings.simplefilter("ignore")  # Sphinx's extensions warn about each other
        trees = out.parent / "doctrees"
        app = Sphinx(source, THEME, out, trees, "html", changed, None, output, tags=tags)
        app.build(force_all=True)
    warned = re.sub(r"\x1b\[[\d;]*m", "", output.getvalue()).replace(f"{source}/", "").strip()
    if warned or app.statuscode:
        raise WebsiteError(f"Sphinx does not accept the pages:\n{warned}")
