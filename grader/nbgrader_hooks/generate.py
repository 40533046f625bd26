"""Generating an assignment again after work was handed in: nbgrader itself refuses added or removed
cells, and deletes the release.
"""

import shutil
import tempfile
from pathlib import Path
from typing import Any

from nbconvert.exporters import NotebookExporter
from nbformat import NotebookNode
from nbgrader import api
from nbgrader.preprocessors import SaveCells

from ..course.by_hand import give, given_by_hand
from ..course.files import load_json, write_json
from .guards import Configured
from .shared import OfCourse

KINDS = ("grade", "solution", "task", "source")  # kinds of cells in the gradebook


class SourceReader(Configured, NotebookExporter):
    """Reads the source notebooks for ``nbgrader generate_assignment``, which saves their cells by
    :class:`SaveChangedCells`. An existing release stays until the new one is complete.
    """

    def __init__(self, **kwargs: Any) -> None:
        super().__init__(**kwargs)
        converter: Any = self.parent
        steps = converter.preprocessors
        converter.preprocessors = [SaveChangedCells if s is SaveCells else s for s in steps]
        convert = converter.convert_notebooks
        converter.convert_notebooks = lambda: self._keep(converter.coursedir, convert)

    def _keep(self, coursedir, convert):
        release = self.course.released_path(coursedir.assignment_id).parent
        with tempfile.TemporaryDirectory() as folder:
            kept = Path(folder) / "release"
            if release.is_dir():
                shutil.copytree(release, kept)
            try:
                convert()
            except BaseException:
                if kept.is_dir() and not release.exists():
                    shutil.copytree(kept, release)
                    self.log.error("The release that was there is kept as it was: %s", release)
                raise


class SaveChangedCells(OfCourse, SaveCells):
    """Writes the cells to the gradebook, including those added or removed since work was handed in.

    The points of a removed cell are lost. Its manual grades are kept in COURSE/backup, and restored
    when the cell comes back.
    """

    def _create_notebook(self, nb: NotebookNode) -> None:
        assignment = self.gradebook.find_assignment(self.assignment_id)
        for notebook in assignment.notebooks:
            if notebook.name == self.notebook_id and notebook.submissions:
                self._change(notebook)
        super()._create_notebook(nb)

    def _change(self, notebook):
        """Delete removed cells and add new ones, for every submission."""
        path = self.course.path / "backup" / f"{self.assignment_id}.by_hand.json"
        kept = load_json(path.read_bytes()) if path.exists() else {}
        by_hand, db, back = kept.setdefault(self.notebook_id, {}), self.gradebook.db, set()
        for kind in KINDS:
            wanted = getattr(self, f"new_{kind}_cells")
            there = {cell.name: cell for cell in getattr(notebook, f"{kind}_cells")}
            for name in there.keys() - wanted.keys():
                cell = there[name]
                for row in (*getattr(cell, "grades", ()), *getattr(cell, "comments", ())):
                    given = by_hand.setdefault(name, {}).setdefault(row.notebook.student.id, {})
                    given.update(given_by_hand([row]))
                    db.delete(row)
                db.delete(cell)
            db.commit()
            for name in wanted.keys() - there.keys():
                add = getattr(self.gradebook, f"add_{kind}_cell")
                cell = add(name, self.notebook_id, self.assignment_id, **wanted[name])
                for submission in notebook.submissions:
                    _add_rows(cell, submission, by_hand.get(name, {}))
                back.add(name)
        db.commit()
        kept[self.notebook_id] = {
            name: given for name, given in by_hand.items() if name not in back
        }
        write_json(path, kept)


def _add_rows(cell, submission, by_hand):
    """Add the rows of a new cell to an ungraded submission."""
    given, rows = by_hand.get(submission.student.id, {}), []
    if isinstance(cell, (api.GradeCell, api.TaskCell)):
        submission.grades.append(api.Grade(cell=cell))
        rows.append(submission.grades[-1])
    if isinstance(cell, (api.SolutionCell, api.TaskCell)):
        submission.comments.append(api.Comment(cell=cell))
        rows.append(submission.comments[-1])
    for row in rows:
        give(row, given)
