"""Runs the code of a rebuilt notebook in the sandbox, in the order of its cells."""

from dataclasses import dataclass, field

from ..assignment import notebook as nb
from ..assignment.sheet import kind, own_metadata
from .rebuild import OWN, cell_names, is_untouched

RUN = ("setup", "locked", "plain", "solution", OWN)


@dataclass
class Executed:
    """What came out of the sandbox: the receipt of each problem, the outcome of each of the
    instructor's tests, errors in other cells by their id, how the code was isolated, and a note if
    the run did not come to its end.
    """

    receipts: dict = field(default_factory=dict)
    tests: dict = field(default_factory=dict)
    errors: dict = field(default_factory=dict)
    sandbox: str = "namespaces"
    note: str = ""


def cells_to_run(sheet, notebook):
    """The cells of a rebuilt notebook as :meth:`~grader.sandbox.Harvester.run` takes them; [] if
    there is no work in it.
    """
    asked, cells, masters = sheet.tasks, [], _by_name(sheet.master)
    worked = _worked_at(asked, masters, notebook)
    if not worked:
        return []
    given = waiting = None  # whose givens ran last, and whose answer is to be read
    for cell in notebook["cells"]:
        what, problem = kind(cell), own_metadata(cell).get("problem")
        if waiting and what != OWN:
            cells.append(_harvest(asked[waiting], waiting))
            waiting = None
        if (problem and problem not in worked) or cell["cell_type"] != "code":
            continue
        if what == "givens":
            cells.append(_givens(asked.get(problem), problem, cell["source"]))
            given = problem
        elif what == "answer":
            if given != problem:  # its own are missing, or another problem's ran since
                lines = nb.definitions(asked[problem].exercise, sheet.values[problem])
                text = "\n".join(lines)
                cells.append(_givens(asked[problem], problem, text))
                given = problem
            cells.append({"role": "answer", "problem": problem, "text": cell["source"]})
            waiting = problem
        elif what in RUN:
            cells.append({"role": "run", "name": cell["id"], "text": cell["source"]})
        elif what == "test":
            name = cell["metadata"]["nbgrader"]["grade_id"]
            seen = _master(masters, cell)["source"]
            full, _ = sheet.sources.get(name, (seen, ""))
            cells.append({"role": "test", "name": name, "text": seen, "hidden": full})
    if waiting:
        cells.append(_harvest(asked[waiting], waiting))
    return cells


def _by_name(master):
    return {name: cell for cell in reversed(master["cells"]) for name in cell_names(cell)}


def _master(masters, cell):
    return next(masters[name] for name in cell_names(cell) if name in masters)


def _worked_at(asked, masters, notebook):
    """The problems at which the student worked; all of them if there is work in other cells, since
    it may be for any, or an instructor's test.
    """
    worked = set()
    for cell in notebook["cells"]:
        what = kind(cell)
        if cell["cell_type"] != "code":
            continue
        if what in (OWN, "test"):
            return {*asked, None}
        if what in ("answer", "plain", "solution") and not is_untouched(
            _master(masters, cell), cell["source"]
        ):
            if what != "answer":
                return {*asked, None}
            worked.add(own_metadata(cell)["problem"])
    return worked


def _givens(task, problem, text):
    clear = list(_forms(task)) if task else []
    return {"role": "givens", "problem": problem, "text": text, "clear": clear}


def _harvest(task, problem):
    symbols = {n: s.unit for n, s in task.exercise.symbols.items()}
    return {"role": "harvest", "problem": problem, "forms": _forms(task), "symbols": symbols}


def _forms(task):
    return task.forms or {a.key: nb.form(a) for a in task.exercise.answers}


def run_cells(harvester, cells):
    """Run the cells; returns :class:`Executed`."""
    if not cells:
        return Executed()
    result = harvester.run(cells)
    receipts, notes = result["receipts"], []
    asked = [c["problem"] for c in cells if c["role"] == "harvest"]
    unread = [i for i in asked if i not in receipts]
    if result["ended"] != "done":
        notes.append(f"the notebook was {result['ended']}; answers that came later were not read")
    elif unread:
        notes.append(
            f"the notebook ended by itself in the cell of {unread[0]}; answers that came later "
            "were not read"
        )
        receipts = {
            **receipts,
            unread[0]: {
                "error": "the end of its process: the cell ended Python, crashed it, or closed its "
                "files"
            },
        }
    return Executed(
        receipts, result["tests"], result["errors"], result["sandbox"], "; ".join(notes)
    )
