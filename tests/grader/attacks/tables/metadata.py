"""Tags, metadata, points, ids and versions that are edited; cells that are copied, deleted, merged."""

import copy

from tests.grader.attacks.attack import added, cell_of, edited

OUTPUT = {"output_type": "execute_result", "execution_count": 1, "metadata": {},
          "data": {"text/plain": "1000.0"}}  # fmt: skip
CODE = {"cell_type": "code", "outputs": [], "execution_count": None}


def tags(notebook, scene):
    for c in notebook["cells"]:
        c["metadata"]["tags"] = ["skip-execution", "raises-exception", "hide-cell"]
        if c["cell_type"] == "code":
            c["outputs"] = [OUTPUT]


def points(notebook, scene):
    for c in notebook["cells"]:
        c["metadata"].get("nbgrader", {}).update(points=1000, locked=False, grade=True)
    cell_of(notebook, "receipt-4-1")["source"] = "1000.0"


def every_cell(key, value):
    """Metadata of ours or nbgrader's, set in every cell."""

    def change(notebook, scene):
        for c in notebook["cells"]:
            for name in ("nbgrader", "newton_euler"):
                c["metadata"].setdefault(name, {})[key] = value

    return change


def metadata(value):
    def change(notebook, scene):
        for c in notebook["cells"]:
            c["metadata"] = value

    return change


def nested(depth, last=1):
    value = last
    for _ in range(depth):
        value = {"a": [value]}
    return value


def own_terms(notebook, scene):
    cell_of(notebook, "answer-4-1")["metadata"]["newton_euler"] |= {
        "asked": {"speed": "choice, right"}, "weights": {"speed": 0, "acc_mag": 0},
        "follow_through": 1,
    }  # fmt: skip
    cell_of(notebook, "answer-4-1")["source"] = "speed = 'right'"


def merged(notebook, scene):
    text = "\n".join(c["source"] for c in notebook["cells"] if c["cell_type"] == "code")
    notebook["cells"] = [{**cell_of(notebook, "answer-4-1"), "source": text}]


def no_cells(notebook, scene):
    notebook["cells"] = []


def many_copies(notebook, scene):
    cell = cell_of(notebook, "answer-4-1") | {"source": "speed = 1"}
    notebook["cells"] += [copy.deepcopy(cell) | {"id": f"copy-{n}"} for n in range(1000)]


def many_cells(notebook, scene):
    notebook["cells"] += [{**CODE, "id": f"c{n}", "metadata": {}, "source": "x = 1"}
                          for n in range(20_000)]  # fmt: skip


def exchanged_ids(notebook, scene):
    one, other = (cell_of(notebook, f"answer-{n}") for n in ("4-1", "4-16"))
    one["metadata"], other["metadata"] = other["metadata"], one["metadata"]
    one["id"], other["id"] = other["id"], one["id"]
    one["source"] = "speed = acc_mag = 1"


def role(what, problem="4/16"):
    """A cell of the student's own that claims another role."""

    def change(notebook, scene):
        marks = {"newton_euler": {"role": what, "problem": problem}}
        cell = {**CODE, "id": "mine", "metadata": marks, "source": "v_D = [1, 2, 3]"}
        notebook["cells"].insert(0, cell)
        notebook["cells"].append(copy.deepcopy(cell))

    return change


def the_instructors_test_edited(notebook, scene):
    cell_of(notebook, "test_square")["source"] = "4.0"
    notebook["cells"].append(copy.deepcopy(cell_of(notebook, "test_square")) | {"id": "again"})


def strange_cells(notebook, scene):
    notebook["cells"] += [
        None, 3, [], "x", {}, {"cell_type": ["code"], "source": 3}, {"cell_type": "raw"},
        {**CODE, "source": {"a": nested(300)}, "metadata": {}},
        {**CODE, "source": [["x"] * 10, None, 3], "metadata": None, "id": 7},
        {**CODE, "source": "x = 1", "metadata": {"nbgrader": "x", "newton_euler": 4}},
        {"cell_type": "markdown", "source": None, "attachments": 3, "metadata": []},
        {"cell_type": "code", "source": "x\x00y = 1", "metadata": {}},
    ]  # fmt: skip


def kernel(notebook, scene):
    notebook["metadata"] = {
        "kernelspec": {"name": "../../evil", "display_name": "x", "language": "sh",
                       "argv": ["touch", f"{scene.outside}/kernel"]},
        "language_info": {"name": "sh", "file_extension": "/../../x"},
        "newton_euler_changed": {"a": 1}, "authors": nested(300), "title": "<script>",
    }  # fmt: skip


def versions(notebook, scene):
    notebook.update(nbformat="4", nbformat_minor=999, orig_nbformat=-1)


def pictures(notebook, scene):
    """Small files that become large pages: a picture that is shown many times."""
    data = "A" * 10**6
    notebook["cells"].append({
        "cell_type": "markdown", "id": "m", "metadata": {},
        "source": "attachment:a.png " * 20_000,
        "attachments": {"a.png": {"image/png": data, "text/html": "<script>"}, "../x": {"a": data}},
    })  # fmt: skip


def long_ids(notebook, scene):
    for n, c in enumerate(notebook["cells"]):
        c["id"] = "x" * 10**6
        if n < 10:
            c["metadata"] = {"nbgrader": {"grade_id": "y" * 10**6, "solution": True}}
    notebook["cells"].append({**CODE, "id": "z" * 10**7, "metadata": {}, "source": "x = 1"})


def newest_schema(notebook, scene):
    for c in notebook["cells"]:
        if "nbgrader" in c["metadata"]:
            c["metadata"]["nbgrader"]["schema_version"] = 99


ATTACKS = {
    "tags and outputs": edited(tags),
    "points": edited(points),
    "the points as text": edited(every_cell("points", "1e9")),
    "one id for all cells": edited(every_cell("grade_id", "answer-4-1")),
    "an id that is a list": edited(every_cell("grade_id", ["answer-4-1"])),
    "an id that is a path": edited(every_cell("grade_id", "../../gradebook.db")),
    "ids of ten million letters": edited(long_ids),
    "the ids of each other": edited(exchanged_ids),
    "one problem for all cells": edited(every_cell("problem", "4/1")),
    "a problem that is a dict": edited(every_cell("problem", {"4/1": 1})),
    "a problem that nobody asks": edited(role("answer", "4/99")),
    "everything is an answer": edited(every_cell("role", "answer")),
    "everything is the student's own": edited(every_cell("role", "own")),
    "a role that is a list": edited(every_cell("role", ["answer"])),
    "a cell that says it is a receipt": edited(role("receipt")),
    "a cell that says it holds the givens": edited(role("givens")),
    "a cell that says it is the introduction": edited(role("introduction", None)),
    "a cell that says it is the setup": edited(role("setup", None)),
    "a cell that says it is a test": edited(role("test")),
    "the instructor's test, edited and copied": edited(the_instructors_test_edited),
    "its own terms": edited(own_terms),
    "metadata that is nested": edited(metadata(nested(400))),
    "metadata that is a list": edited(metadata([1])),
    "metadata that is text": edited(metadata("nbgrader")),
    "the newest schema": edited(newest_schema),
    "a thousand copies": edited(many_copies),
    "twenty thousand cells": edited(many_cells),
    "one cell": edited(merged),
    "no cell": edited(no_cells),
    "things that are not cells": edited(strange_cells),
    "a kernel of its own": edited(kernel),
    "versions": edited(versions),
    "a picture in many places": edited(pictures),
    "a cell that reads and clears the answers": added(
        "for name in list(globals()):\n    if not name.startswith('_'): del globals()[name]"
    ),
    "a cell that never ends": added("while True: pass"),
}
