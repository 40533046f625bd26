"""Notebooks run in clean kernels, several at a time, with cached outputs."""

import os
import subprocess
import tempfile
from collections.abc import Callable, Collection
from concurrent.futures import ProcessPoolExecutor
from pathlib import Path

import nbformat

from newton_euler.classroom.widgets.on_pages import ASKED

from .kept import ROOT, fingerprint, kept_name, store
from .notebooks import Chapter

LONGEST = 600  # seconds for one cell, on a busy machine


class WebsiteError(Exception):
    """The site cannot be built; the message says where."""


def with_outputs(
    chapters: Collection[Chapter],
    cache: Path,
    run: Callable[[Chapter], bool],
    done: Callable[[str], object],
) -> dict[str, nbformat.NotebookNode | None]:
    """{stem: executed notebook}; None for a chapter that may not be run and has no cached outputs.

    run : whether a chapter may be run
    done : called with the stem of each finished chapter
    """
    names = {c.stem: cache / _name(c) for c in chapters}
    jobs = [c for c in chapters if not names[c.stem].exists() and run(c)]
    with ProcessPoolExecutor(os.cpu_count() or 1) as pool:
        texts = pool.map(_executed, [c.path for c in jobs])
        for c in chapters:
            if names[c.stem].exists() or c not in jobs:
                done(c.stem)
        for c, text in zip(jobs, texts, strict=True):
            keep(c, text, cache)
            done(c.stem)
    return {stem: _read(path) if path.exists() else None for stem, path in names.items()}


def keep(chapter: Chapter, text: str, cache: Path) -> None:
    """Cache the text of an executed notebook; the tests of the chapters do so too."""
    store(cache / _name(chapter), text.encode())


def _name(chapter):
    return kept_name(chapter.stem, ".ipynb", chapter.path.read_text("utf-8"), fingerprint())


def _read(path):
    return nbformat.read(path, as_version=4)


def _executed(path):
    """The text of the notebook with its outputs, run with nothing but the engine."""
    from nbclient import NotebookClient
    from nbclient.exceptions import CellExecutionError, CellTimeoutError

    notebook = _read(path)
    with tempfile.TemporaryDirectory() as folder:
        (Path(folder) / "newton_euler").symlink_to(ROOT / "newton_euler")
        resources = {"metadata": {"path": folder}}
        client = NotebookClient(
            notebook,
            timeout=LONGEST,
            kernel_name="python3",
            resources=resources,
            coalesce_streams=True,  # MyST would separate the pieces of a text
        )
        try:
            # the kernel's own messages
            client.execute(env=_environment(folder), stderr=subprocess.DEVNULL)
        except (CellExecutionError, CellTimeoutError) as error:
            raise WebsiteError(f"{path.name}, {_place(notebook, error)}") from None
    return nbformat.writes(notebook)


def _environment(folder):
    return {
        **os.environ,
        "PYTHONPATH": folder,
        "IPYTHONDIR": f"{folder}/ipython",
        ASKED: "yes",
        "MPLBACKEND": "module://matplotlib_inline.backend_inline",
    }


def _place(notebook, error):
    """The cell that failed, and its error."""
    for n, cell in enumerate(notebook.cells, 1):
        for output in cell.get("outputs", ()):
            if output.output_type == "error":
                return f"cell {n} ({cell.id}): {output.ename}: {output.evalue}"
    return str(error)
