"""The notebooks: stored clean, complete, readable without the figures, and running from top to
bottom for a student who has only the wheel.
"""

import ast
import os
import re
import warnings
from copy import deepcopy
from datetime import datetime
from itertools import pairwise

import nbformat
import pytest
from nbformat.v4 import new_code_cell, new_notebook

from newton_euler.classroom.widgets.on_pages import ASKED
from tests.chapters.notebooks import (
    CHAPTERS,
    COMPANION,
    CONTENTS,
    ROOT,
    code,
    each_chapter,
    number,
    prose,
    read,
    sections_of,
)
from website.execution import keep
from website.notebooks import Chapter

NOTES = sorted((ROOT / "chapters" / "instructors").glob("*.ipynb"))
DEADLINE_S, CELL_S = 60, 10

each_notebook = pytest.mark.parametrize("path", CHAPTERS + NOTES, ids=lambda path: path.stem)


def test_there_are_chapters():
    assert [p.name for p in CHAPTERS if number(p) == "ch04"] == ["ch04_relative_motion.ipynb"]


@each_notebook
def test_a_notebook_is_valid_and_stored_without_outputs(path):
    notebook = read(path)
    nbformat.validate(notebook)
    assert (notebook.nbformat, notebook.nbformat_minor) == (4, 5)
    assert notebook.metadata.kernelspec.name == "python3"
    assert len({cell.id for cell in notebook.cells}) == len(notebook.cells)
    for cell in code(notebook):
        assert not cell.outputs, cell.id
        assert cell.execution_count is None, cell.id


@each_notebook
def test_code_comes_in_short_cells_without_magics(path):
    for cell in code(read(path)):
        lines = cell.source.splitlines()
        assert len(lines) <= 12, cell.id
        assert max(map(len, lines)) <= 110, cell.id  # what fits a notebook without a scroll bar
        ast.parse(cell.source)  # %magic and !shell are not Python


@each_notebook
def test_a_notebook_uses_nothing_that_holds_keys(path):
    for cell in code(read(path)):
        for node in ast.walk(ast.parse(cell.source)):
            names = [a.name for a in node.names] if isinstance(node, ast.Import) else []
            names += [node.module] if isinstance(node, ast.ImportFrom) else []
            assert not {"exercises", "grader"} & {name.partition(".")[0] for name in names}, cell.id


def headings(text):
    """The headings of a notebook, without the # signs."""
    return re.findall(r"^#+ (.+)$", text, re.M)


@each_chapter
def test_the_sections_of_the_book_appear_in_order(path):
    assert list(sections_of(path)) == CONTENTS[number(path)]["sections"]


@each_chapter
def test_every_worked_example_of_the_book_has_a_heading(path):
    titles = [h.lower() for h in headings(prose(read(path))) if "example" in h.lower()]
    for words in CONTENTS[number(path)].get("examples", []):
        assert any(words.lower() in heading for heading in titles), (words, titles)


@each_chapter
def test_every_numbered_equation_of_the_chapter_is_quoted(path):
    text, chapter = prose(read(path)), number(path)[2:].lstrip("0").removeprefix("p")
    wanted = {f"{chapter}.{n}" for n in range(1, CONTENTS[number(path)]["equations"] + 1)}
    quoted = set(re.findall(r"[({]((?:\d+|[AB])\.\d+)[)}]", text))
    assert not wanted - quoted, sorted(wanted - quoted)


@each_chapter
def test_the_opening_says_what_you_will_learn_what_you_need_and_how_long_it_takes(path):
    opening = prose(read(path)).partition("\n## ")[0]
    for words in ("you will be able to do", "need before", "How long"):
        assert words in opening, words


def is_prediction(cell):
    return cell.cell_type == "code" and (is_asked(cell) or cell.source.startswith(EMPTY))


def is_asked(cell):
    """True for a prediction that a reader makes by clicking or typing."""
    return cell.cell_type == "code" and re.search(r"^(\w+ = )?predict\(", cell.source, re.M)


EMPTY = "# Your prediction:"


@each_chapter
def test_each_section_asks_for_a_prediction(path):
    for section, parts in sections_of(path).items():
        assert any(not isinstance(part, str) and is_prediction(part) for part in parts), section


@each_chapter
def test_a_prediction_is_a_question_an_empty_cell_and_a_folded_answer(path):
    for before, cell, after in zip(*(read(path).cells[n:] for n in range(3)), strict=False):
        if is_prediction(cell) and not is_asked(cell):
            assert cell.source.strip() == EMPTY, cell.id
            assert re.search(r"\*\*Predict( \d)?\.\*\*[^#]+$", before.source), cell.id
            assert after.source.startswith("<details><summary>"), cell.id


@each_chapter
def test_the_code_of_a_prediction_is_folded_since_it_has_the_answer(path):
    for cell in filter(is_asked, read(path).cells):
        assert cell.metadata.get("jupyter", {}).get("source_hidden"), cell.id


@each_notebook
def test_a_prediction_has_a_right_answer_so_that_it_is_judged(path):
    for cell in filter(is_asked, read(path).cells):
        for call in ast.walk(ast.parse(cell.source)):
            if isinstance(call, ast.Call) and getattr(call.func, "id", "") == "predict":
                assert len(call.args) > 2 or "answer" in {k.arg for k in call.keywords}, cell.id


@each_notebook
def test_folded_answers_are_closed_and_leave_a_line_for_markdown(path):
    text = prose(read(path))
    assert text.count("<details>") == text.count("</details>")
    for answer in re.findall(r"</summary>(.*?)</details>", text, re.S):
        assert answer.startswith("\n\n")
        assert re.search(r"\n[ ]*\n[ ]*$", answer), answer


@each_chapter
def test_a_chapter_ends_with_what_to_remember_five_questions_and_the_dictionary(path):
    titles = re.findall(r"^## (.+)$", prose(read(path)), re.M)
    last = [title for title in titles if not re.match(r"[\dAB]+\.", title)][-3:]
    assert last[0] == "What to remember"
    assert last[1] == "Five questions to test yourself"
    assert last[2].startswith("Appendix: from the book's symbols to calls")
    questions = prose(read(path)).partition(f"## {last[1]}")[2].partition("\n## ")[0]
    assert len(re.findall(r"^\d\. ", questions, re.M)) == 5
    assert questions.count("<details>") == 5


@each_chapter
def test_every_problem_of_the_chapter_is_offered_once_at_the_end_of_a_section(path):
    files = (ROOT / "exercises" / number(path)).glob("p*.yaml")
    texts = "\n".join(file.read_text(encoding="utf-8") for file in files)
    wanted = re.findall(r'^id: "(\w+/\d+)"', texts, re.M)
    offers = re.findall(r"^\*\*Practice\.\*\*(.+?)(?:\n\n|\Z)", prose(read(path)), re.M | re.S)
    offered = {problem for offer in offers for problem in re.findall(r"\b\w+/\d+\b", offer)}
    assert not set(wanted) - offered, sorted(set(wanted) - offered)
    tries = [c for c in code(read(path)) if "try_problem(" in c.source]
    assert bool(wanted) == bool(tries)


@each_notebook
def test_every_formula_is_closed(path):
    for cell in read(path).cells:
        if cell.cell_type == "markdown":
            bare = cell.source.replace(r"\{", "").replace(r"\}", "").replace(r"\$", "")
            assert bare.count("$") % 2 == 0, cell.id
            for formula in re.findall(r"\$\$(.+?)\$\$|\$(.+?)\$", bare, re.S):
                text = "".join(formula)
                assert text.count("{") == text.count("}"), (cell.id, text)


def executed(notebook, where, missing=(), afterwards=lambda client, notebook: None):
    """The notebook, run in a clean kernel that finds the engine and nothing else, and what
    ``afterwards`` returns, which is called while the kernel is alive.
    """
    client = pytest.importorskip("nbclient").NotebookClient
    (where / "newton_euler").symlink_to(ROOT / "newton_euler", target_is_directory=True)
    absent = "".join(f"sys.modules[{name!r}] = None\n" for name in missing)
    (where / "sitecustomize.py").write_text(f"import sys\n{absent}")
    kernel = {"kernel_name": "python3", "resources": {"metadata": {"path": str(where)}}}
    # seconds for a cell, on a machine that is busy; streams are joined as the site shows them
    runner = client(notebook, timeout=10 * DEADLINE_S, coalesce_streams=True, **kernel)
    environment = {**os.environ, "PYTHONPATH": str(where)}
    environment["MPLBACKEND"] = "module://matplotlib_inline.backend_inline"
    environment[ASKED] = "yes"  # the outputs are kept for the site
    with warnings.catch_warnings():
        warnings.filterwarnings("ignore", module=r"zmq|jupyter_client|nbclient|asyncio|traitlets")
        with runner.setup_kernel(env=environment):
            for n, cell in enumerate(notebook.cells):
                runner.execute_cell(cell, n)
            runner.set_widgets_metadata()
            return notebook, afterwards(runner, notebook)


def printed(cell):
    """What a cell printed."""
    return "".join(o.text for o in cell.outputs if o.output_type == "stream")


def printed_again(client, notebook):
    """What the printing cells print when run again in reverse order, so that none finds what the
    cells above it would have made afresh: {id: text}.
    """
    found = {}
    client.allow_errors = True
    for n, cell in reversed(list(enumerate(notebook.cells))):
        if cell.cell_type == "code" and printed(cell):
            again = client.execute_cell(deepcopy(cell), n, store_history=False)
            errors = [o.ename for o in again.outputs if o.output_type == "error"]
            found[cell.id] = printed(again) + "".join(errors)
    return found


@pytest.fixture(scope="module", params=CHAPTERS, ids=lambda path: path.stem)
def run(request, tmp_path_factory):
    """The executed notebook. It is kept, so that the site need not run it."""
    path = request.param
    notebook, _ = executed(read(path), tmp_path_factory.mktemp(path.stem))
    keep(Chapter(path), nbformat.writes(notebook))
    return notebook


@pytest.mark.slow
@pytest.mark.parametrize("path", CHAPTERS, ids=lambda path: path.stem)
def test_a_cell_that_is_run_again_prints_the_same(path, tmp_path):
    notebook, again = executed(read(path), tmp_path, afterwards=printed_again)
    other = [c.id for c in code(notebook) if c.id in again and printed(c) != again[c.id]]
    assert other == CONTENTS.get(number(path), {}).get("changed", [])


def is_picture(output):
    data = output.get("data", {})
    return "image/png" in data or "<img" in data.get("text/html", "")


def stderr_of(notebook):
    """What cells wrote to stderr, by the id of the cell."""
    streams = ((c.id, o) for c in code(notebook) for o in c.outputs if o.output_type == "stream")
    return {cell: output.text for cell, output in streams if output.name == "stderr"}


def test_a_run_prints_no_warnings(run):
    assert not stderr_of(run)


def test_every_picture_has_an_alternative_text(run):
    pictures = [o for cell in code(run) for o in cell.outputs if is_picture(o)]
    assert pictures
    for output in pictures:
        alt = re.search(r'alt="([^"]*)"', output.data.get("text/html", ""))
        assert alt, output.data.keys()
        assert len(alt[1].split()) >= 8, alt[1]


def test_every_picture_is_followed_by_a_caption_or_has_one(run):
    for cell, after in pairwise(run.cells):
        if cell.cell_type == "code" and any(map(is_picture, cell.outputs)):
            shown = "".join(o.get("data", {}).get("text/html", "") for o in cell.outputs)
            captioned = re.search(r"<figcaption>.{40,}</figcaption>", shown, re.S)
            below = re.match(r"\*(Figure [\dAB]+\.\d+\.|A film:) .{40,}", after.source, re.S)
            assert captioned or below, (cell.id, after.source[:60])


def test_the_figures_of_a_chapter_are_numbered_in_order(run):
    numbers = re.findall(r"^\*Figure (?:\d+|[AB])\.(\d+)\.", prose(run), re.M)
    assert numbers == [str(n + 1) for n in range(len(numbers))]


def seconds(cell):
    """How long a cell of code took."""
    times = cell.metadata.execution
    begun, ended = times["iopub.execute_input"], times["shell.execute_reply"]
    return (datetime.fromisoformat(ended) - datetime.fromisoformat(begun)).total_seconds()


@pytest.mark.benchmark
def test_a_notebook_runs_in_a_minute_and_no_cell_takes_ten_seconds(run):
    took = [seconds(cell) for cell in code(run)]
    assert max(took) < CELL_S
    assert sum(took) < DEADLINE_S


def test_every_chapter_has_notes_for_instructors():
    chapters = {number(path) for path in CHAPTERS if path.stem != COMPANION}
    assert {path.stem for path in NOTES} == chapters


def test_the_notes_for_instructors_run_without_warnings(tmp_path):
    """In one kernel, where each begins without the names of the one before."""
    cells = [c for path in NOTES for c in (new_code_cell("%reset -f"), *read(path).cells)]
    notebook, _ = executed(new_notebook(cells=cells), tmp_path)
    assert not stderr_of(notebook)


@pytest.mark.slow
@pytest.mark.parametrize("path", CHAPTERS, ids=lambda path: path.stem)
def test_a_notebook_runs_where_widgets_and_heyoka_are_missing(path, tmp_path):
    notebook, _ = executed(read(path), tmp_path, missing=("ipywidgets", "heyoka", "symengine"))
    assert any(is_picture(output) for cell in code(notebook) for output in cell.outputs)
