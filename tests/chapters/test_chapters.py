"""The notebooks: stored clean, complete, readable without the figures, and running from top to
bottom for a student who has only the wheel.
"""

import ast
import os
import re
import time
import warnings
from itertools import pairwise
from pathlib import Path

import nbformat
import pytest

ROOT = Path(__file__).parents[2]
CHAPTERS = sorted((ROOT / "chapters").glob("*.ipynb"))
EQUATIONS = {"ch04": 29}  # how many numbered equations each chapter of the book has
DEADLINE_S = 60

each_chapter = pytest.mark.parametrize("path", CHAPTERS, ids=lambda path: path.stem)


def read(path):
    return nbformat.read(path, as_version=nbformat.NO_CONVERT)


def number(path):
    """Of ch04_relative_motion: "ch04"."""
    return path.stem.partition("_")[0]


def code(notebook):
    return [cell for cell in notebook.cells if cell.cell_type == "code"]


def prose(notebook):
    return "\n".join(cell.source for cell in notebook.cells if cell.cell_type == "markdown")


def test_there_are_chapters():
    assert [path.name for path in CHAPTERS if number(path) == "ch04"] == [
        "ch04_relative_motion.ipynb"
    ]


@each_chapter
def test_a_notebook_is_valid_and_stored_without_outputs(path):
    notebook = read(path)
    nbformat.validate(notebook)
    assert (notebook.nbformat, notebook.nbformat_minor) == (4, 5)
    assert notebook.metadata.kernelspec.name == "python3"
    assert len({cell.id for cell in notebook.cells}) == len(notebook.cells)
    for cell in code(notebook):
        assert not cell.outputs, cell.id
        assert cell.execution_count is None, cell.id


@each_chapter
def test_code_comes_in_short_cells_without_magics(path):
    for cell in code(read(path)):
        lines = cell.source.splitlines()
        assert len(lines) <= 25, cell.id
        assert max(map(len, lines)) <= 110, cell.id  # what a notebook shows without a scroll bar
        ast.parse(cell.source)  # %magic and !shell are no Python


@each_chapter
def test_a_notebook_uses_nothing_that_holds_keys(path):
    for cell in code(read(path)):
        for node in ast.walk(ast.parse(cell.source)):
            names = (
                [a.name for a in node.names]
                if isinstance(node, ast.Import)
                else [node.module]
                if isinstance(node, ast.ImportFrom)
                else []
            )
            assert not {"exercises", "grader"} & {name.partition(".")[0] for name in names}, cell.id


@each_chapter
def test_every_numbered_equation_of_the_chapter_is_quoted(path):
    if number(path) not in EQUATIONS:
        pytest.skip("a companion to the chapters")
    text, chapter = prose(read(path)), int(number(path)[2:])
    wanted = {f"{chapter}.{n}" for n in range(1, EQUATIONS[number(path)] + 1)}
    quoted = set(re.findall(r"\((\d+\.\d+)\)|\\tag\{(\d+\.\d+)\}", text))
    missing = wanted - {n for pair in quoted for n in pair}
    assert not missing, sorted(missing)


@each_chapter
def test_every_formula_is_closed(path):
    for cell in read(path).cells:
        if cell.cell_type == "markdown":
            bare = cell.source.replace(r"\{", "").replace(r"\}", "").replace(r"\$", "")
            assert bare.count("$") % 2 == 0, cell.id
            for formula in re.findall(r"\$\$(.+?)\$\$|\$(.+?)\$", bare, re.S):
                assert "".join(formula).count("{") == "".join(formula).count("}"), (
                    cell.id,
                    formula,
                )


@each_chapter
def test_the_exercises_named_are_those_of_the_chapter(path):
    texts = [
        file.read_text(encoding="utf-8")
        for file in (ROOT / "exercises" / number(path)).glob("p*.yaml")
    ]
    if not texts:
        pytest.skip(f"{number(path)} has no exercises")
    wanted = re.findall(r'^id: "(\d+/\d+)"', "\n".join(texts), re.M)
    table = [
        row
        for row in prose(read(path)).partition("## Exercises")[2].splitlines()
        if row.startswith("|")
    ]
    assert sorted(re.findall(r"\d+/\d+", "\n".join(table))) == sorted(wanted)


def executed(path, where, missing=()):
    """The notebook, run in a clean kernel that finds the engine and, of this repository, nothing
    else; and the seconds that it took.
    """
    client = pytest.importorskip("nbclient").NotebookClient
    (where / "newton_euler").symlink_to(ROOT / "newton_euler", target_is_directory=True)
    absent = "".join(f"sys.modules[{name!r}] = None\n" for name in missing)
    (where / "sitecustomize.py").write_text(f"import sys\n{absent}")
    notebook = read(path)
    runner = client(
        notebook,
        timeout=DEADLINE_S,
        kernel_name="python3",
        resources={"metadata": {"path": str(where)}},
    )
    started = time.perf_counter()
    with warnings.catch_warnings():
        warnings.filterwarnings("ignore", module=r"zmq|jupyter_client|nbclient|asyncio|traitlets")
        runner.execute(
            env={
                **os.environ,
                "PYTHONPATH": str(where),
                "MPLBACKEND": "module://matplotlib_inline.backend_inline",
            }
        )
    return notebook, time.perf_counter() - started


@pytest.fixture(scope="module", params=CHAPTERS, ids=lambda path: path.stem)
def run(request, tmp_path_factory):
    return executed(request.param, tmp_path_factory.mktemp(request.param.stem))


def is_picture(output):
    return "image/png" in output.get("data", {})


def captioned(outputs):
    """True if a chart comes with a caption of its own, generated from what was measured."""
    return any("<figcaption>" in output.get("data", {}).get("text/html", "") for output in outputs)


def test_a_notebook_runs_from_a_clean_kernel_in_time(run):
    assert run[1] < DEADLINE_S


def test_a_run_prints_no_warnings(run):
    for cell in code(run[0]):
        told = [
            output.text
            for output in cell.outputs
            if output.output_type == "stream" and output.name == "stderr"
        ]
        assert not told, (cell.id, told)


def test_every_figure_is_followed_by_a_caption_that_says_what_it_shows(run):
    captions, generated = 0, 0
    for cell, after in pairwise(run[0].cells):
        if cell.cell_type != "code" or not any(map(is_picture, cell.outputs)):
            continue
        if captioned(cell.outputs):
            generated += 1
            continue
        captions += 1
        caption = re.match(r"\*Figure (\d+)\. (.+?)\*(\s|$)", after.source, re.S)
        assert caption, (cell.id, after.source[:60])
        assert int(caption[1]) == captions
        assert len(caption[2].split()) >= 15, caption[2]
    assert captions + generated


@pytest.mark.slow
@each_chapter
def test_a_notebook_runs_where_widgets_and_heyoka_are_missing(path, tmp_path):
    notebook, _ = executed(path, tmp_path, missing=("ipywidgets", "heyoka", "symengine"))
    assert any(is_picture(output) for cell in code(notebook) for output in cell.outputs)
