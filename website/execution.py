"""Notebooks run in clean kernels, several at a time, with cached outputs."""

import os
import subprocess
import tempfile
from collections.abc import Callable, Collection
from pathlib import Path

import nbformat

from newton_euler.classroom.widgets.on_pages import ASKED

from .kept import CACHE, ROOT, Start, complete, fingerprint, kept_name, store
from .notebooks import Chapter

LONGEST = 600  # seconds for one cell, on a busy machine


class WebsiteError(Exception):
    """The site cannot be built; the message says where."""


def with_outputs(
    chapters: Collection[Chapter], run: Callable[[Chapter], bool], start: Start
) -> dict[str, nbformat.NotebookNode | None]:
    """{stem: executed notebook}; None for a chapter that may not be run and has no cached outputs.

    run : whether a chapter may be run
    """
    files = {c: _kept(c) for c in chapters}
    wanted = {c.path: file for c, file in files.items() if file.exists() or run(c)}
    complete(wanted, _executed, start)
    return {c.stem: nbformat.read(files[c], 4) if c.path in wanted else None for c in chapters}


def keep(chapter: Chapter, text: str) -> None:
    """Cache the text of an executed notebook; the tests of the chapters do so too."""
    store(_kept(chapter), text.encode())


def _kept(chapter):
    text = chapter.path.read_text("utf-8")
    return CACHE / "executed" / kept_name(chapter.stem, ".ipynb", text, fingerprint())


def _executed(path):
    """The notebook with its outputs, run with nothing but the engine; as bytes."""
    from nbclient import NotebookClient
    from nbclient.exceptions import CellExecutionError, CellTimeoutError

    notebook = nbformat.read(path, 4)
    with tempfile.TemporaryDirectory() as folder:
        (Path(folder) / "newton_euler").symlink_to(ROOT / "newton_euler")
        environment = {
            **os.environ,
            "PYTHONPATH": folder,
            "IPYTHONDIR": f"{folder}/ipython",
            ASKED: "yes",
            "MPLBACKEND": "module://matplotlib_inline.backend_inline",
        }
        client = NotebookClient(
            notebook,
            timeout=LONGEST,
            kernel_name="python3",
            resources={"metadata": {"path": folder}},
            coalesce_streams=True,  # MyST would separate the pieces of a text
        )
        try:
            # the kernel's own messages
            client.execute(env=environment, stderr=subprocess.DEVNULL)
        except (CellExecutionError, CellTimeoutError) as error:
            raise WebsiteError(f"{path.name}, {_place(notebook, error)}") from None
    return nbformat.writes(notebook).encode()


def _place(notebook, error):
    """The cell that failed, and its error."""
    for n, cell in enumerate(notebook.cells, 1):
        for output in cell.get("outputs", ()):
            if output.output_type == "error":
                return f"cell {n} ({cell.id}): {output.ename}: {output.evalue}"
    return str(error)
