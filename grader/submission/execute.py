"""Runs the code of a rebuilt notebook in the sandbox, in the order of its cells."""

from dataclasses import dataclass, field

from newton_euler.algebra.language import Words, _, relayed

from ..assignment import notebook as nb
from ..assignment.cells import Notebook, kind, nbgrader_metadata, own_metadata
from ..assignment.sheet import Task
from ..sandbox import CAGED, Harvester
from ..sandbox.receipts import Outcome, RawReceipt
from ..sandbox.worker import Job
from .rebuild import is_untouched
from .recognition import OWN, cell_names
from .sheet import Sheet

RUN = ("setup", "locked", "plain", "solution", OWN)


ENDINGS = (  # the sentences of the cage
    Words("stopped after {n} s"), Words("stopped at {n} GB of memory"),
    Words("stopped from outside"), Words("stopped after {n} bytes of output"),
)  # fmt: skip
PROCESS_ENDED = Words(
    "the end of its process: the cell ended Python, crashed it, or closed its files"
)


@dataclass
class RunResults:
    """The results of a run: receipts by problem, outcomes of the instructor's tests, errors in
    other cells by their id, how the code was isolated, a note if it ended early.
    """

    receipts: dict[str, RawReceipt] = field(default_factory=dict)
    tests: dict[str, Outcome] = field(default_factory=dict)
    errors: dict[str, str] = field(default_factory=dict)
    sandbox: str = CAGED
    note: str = ""


def _cells_to_run(sheet: Sheet, notebook: Notebook) -> list[Job]:
    """The cells as :meth:`~grader.sandbox.Harvester.run` takes them; [] without any work."""
    worked = _worked_at(sheet, notebook)
    if not worked:
        return []
    cells: list[Job] = []
    given = waiting = ""  # the problem whose givens ran last, and that whose answer is to be read
    for cell in notebook["cells"]:
        what, problem = kind(cell), own_metadata(cell).get("problem", "")
        if waiting and what != OWN:
            cells.append(_harvest(sheet.tasks[waiting]))
            waiting = ""
        if (problem and problem not in worked) or cell["cell_type"] != "code":
            continue
        if what == "givens":
            cells.append(_givens(sheet.tasks.get(problem), problem, cell["source"]))
            given = problem
        elif what == "answer":
            if given != problem:  # its givens are missing, or another problem's ran since
                lines = nb.definitions(sheet.tasks[problem].exercise, sheet.values[problem])
                cells.append(_givens(sheet.tasks[problem], problem, "\n".join(lines)))
            cells.append({"role": "answer", "problem": problem, "text": cell["source"]})
            given = waiting = problem
        elif what in RUN:
            cells.append({"role": "run", "name": cell["id"], "text": cell["source"]})
        elif what == "test":
            name, seen = nbgrader_metadata(cell)["grade_id"], _master(sheet, cell)["source"]
            full = sheet.sources.get(name, (seen, ""))[0]
            cells.append({"role": "test", "name": name, "text": seen, "hidden": full})
    return [*cells, _harvest(sheet.tasks[waiting])] if waiting else cells


def _master(sheet, cell):
    places = sheet.places
    return sheet.master["cells"][next(places[n] for n in cell_names(cell) if n in places)]


def _worked_at(sheet, notebook):
    """The problems on which the student worked; all of them if there is a test of the instructor's,
    or work in other cells, since it may be for any problem.
    """
    worked = set()
    for cell in notebook["cells"]:
        what = kind(cell)
        if cell["cell_type"] != "code":
            continue
        if what in (OWN, "test"):
            return {*sheet.tasks, None}
        if what in ("answer", "plain", "solution") and not is_untouched(
            _master(sheet, cell), cell["source"]
        ):
            if what != "answer":
                return {*sheet.tasks, None}
            worked.add(own_metadata(cell)["problem"])
    return worked


def _givens(task: Task | None, problem: str, text: str) -> Job:
    clear = list(_forms(task)) if task else []
    return {"role": "givens", "problem": problem, "text": text, "clear": clear}


def _harvest(task: Task) -> Job:
    symbols = {n: s.unit for n, s in task.exercise.symbols.items()}
    problem, forms = task.problem, _forms(task)
    return {"role": "harvest", "problem": problem, "forms": forms, "symbols": symbols}


def _forms(task: Task) -> dict[str, str]:
    return task.forms or {a.key: str(a.form) for a in task.exercise.answers}


def execute(harvester: Harvester, sheet: Sheet, notebook: Notebook) -> RunResults:
    """Run the work in a rebuilt notebook in the sandbox."""
    cells = _cells_to_run(sheet, notebook)
    if not cells:
        return RunResults()
    result = harvester.run(cells)
    receipts, note = result["receipts"], ""
    asked = [c["problem"] for c in cells if c["role"] == "harvest"]
    unread = [i for i in asked if i not in receipts]
    if result["ended"] != "done":
        how = relayed(result["ended"])
        note = _("the notebook was {how}; answers that came later were not read", how=how)
    elif unread:
        note = _(
            "the notebook ended by itself in the cell of {problem}; answers that came later "
            "were not read",
            problem=unread[0],
        )
        ended = _(PROCESS_ENDED)
        lost: RawReceipt = {"id": unread[0], "answers": None, "faults": None, "error": ended}
        receipts[unread[0]] = lost
    return RunResults(receipts, result["tests"], result["errors"], result["sandbox"], note)
