"""What an attack is: how its submission is made, and what must hold of it besides what must hold
of every one.
"""

import json
import textwrap
import tomllib
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

from grader.assignment import master_notebook
from tests.grader.courses import REPOSITORY, released_sheet


@dataclass(frozen=True)
class Attack:
    """An entry of a table.

    make : writes the submission, given a :class:`Scene`
    shown : words that the gradebook's comments or the run's output must hold
    readable : False if there is no notebook to be graded: the run says so
    caged : True if only the cage stops it; it is not tried where the instructor asks for none
    check : more that must hold, given the scene after the run
    """

    make: Callable
    shown: str = ""
    readable: bool = True
    caged: bool = False
    check: Callable = lambda scene: None


@dataclass(frozen=True)
class Scene:
    """The course, a student, a folder outside, the mark in the name of what it makes, an open port."""

    course: object
    student: str
    outside: Path
    mark: str
    port: int

    @property
    def folder(self):
        return self.course.path / "submitted" / self.student / "ch04"

    @property
    def honest(self):
        """The notebook that an honest student handed in."""
        return next(self.course.path.glob("submitted/honest-*/ch04/ch04.ipynb"))

    def sheet(self):
        """The student's notebook as it was handed out."""
        return json.loads(json.dumps(master_notebook(self.course, "ch04", self.student)))

    def hand_in(self, notebook):
        """Write a notebook (dict, text, or bytes) as the submission."""
        if isinstance(notebook, dict):
            notebook = json.dumps(notebook)
        content = notebook if isinstance(notebook, bytes) else notebook.encode()
        self.folder.mkdir(parents=True, exist_ok=True)
        (self.folder / "ch04.ipynb").write_bytes(content)


def cell_of(notebook, cell_id):
    return next(c for c in notebook["cells"] if c["id"] == cell_id)


def cells(module):
    """The tables of cells in the TOML file beside a module."""
    return tomllib.loads(Path(module).with_suffix(".toml").read_text(encoding="utf-8"))


def code(text, **flags):
    """Python in the answer cell of 4/1; $COURSE, $OUTSIDE, $MARK, $PORT and others stand for themselves."""

    def change(notebook, scene):
        cell_of(notebook, "answer-4-1")["source"] = filled(text, scene)

    return edited(change, **flags)


def lie(text, **flags):
    """Python that defines ``Lie``, an instance of which is the answer to everything asked."""
    both = {
        "answer-4-1": f"{text}\nspeed = acc_mag = Lie()",
        "answer-4-16": f"{text}\nalpha_CD = v_D = a_D = Lie()",
    }
    return edited(lambda notebook, scene: put(notebook, both), **flags)


def edited(change, **flags):
    """``change(notebook, scene)`` of the sheet, in place or returned."""

    def make(scene):
        notebook = scene.sheet()
        scene.hand_in(change(notebook, scene) or notebook)

    return Attack(make, **flags)


def added(text, cell_type="code", **flags):
    """A cell that the student added at the end."""

    def change(notebook, scene):
        cell = {"cell_type": cell_type, "id": "mine", "metadata": {},
                "source": filled(text, scene)}  # fmt: skip
        notebook["cells"].append(
            cell | ({"outputs": [], "execution_count": None} if cell_type == "code" else {})
        )

    return edited(change, **flags)


def filled(text, scene):
    values = {
        "$COURSE": scene.course.path, "$OUTSIDE": scene.outside, "$MARK": scene.mark,
        "$PORT": scene.port, "$REPOSITORY": REPOSITORY, "$HONEST": scene.honest,
    }  # fmt: skip
    for name, value in values.items():
        text = text.replace(name, str(value))
    return textwrap.dedent(text)


def put(notebook, texts):
    for cell_id, text in texts.items():
        cell_of(notebook, cell_id)["source"] = text


def right_texts(course, student):
    """{answer cell: Python with the right answers of this student}."""
    from grader.assignment import problems_of
    from grader.demo import sample_students as sample

    problems = problems_of(released_sheet(course))
    values = course.values("ch04", student, problems)
    return {
        f"answer-{p.id.replace('/', '-')}": sample.cell_text(
            p, sample.right_answers(p, values[p.id])
        )
        for p in problems
    }
