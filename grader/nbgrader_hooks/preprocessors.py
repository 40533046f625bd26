"""What nbgrader runs in place of its own steps: rebuild, harvest, and saving the scores."""

import atexit
import copy

from nbformat import from_dict
from nbgrader import utils
from nbgrader.preprocessors import GetGrades, NbGraderPreprocessor, SaveAutoGrades
from traitlets import Unicode

from ..assignment import notebook as nb
from ..course import Course
from ..sandbox.harvester import Harvester
from ..submission import pipeline

_harvester = None


def harvester():
    """One harvester for the life of the process; nbgrader makes its preprocessors anew for every notebook."""
    global _harvester
    if _harvester is None:
        _harvester = Harvester(1).__enter__()
        atexit.register(_harvester.__exit__)
    return _harvester


class _OfCourse(NbGraderPreprocessor):
    course_path = Unicode("", help="The course folder; set by grader.nbgrader_config.configure").tag(config=True)

    def _sheet(self, resources):
        ours = resources["nbgrader"]
        return pipeline.sheet(Course(self.course_path), ours["assignment"], ours["student"])


class RebuildFromSource(_OfCourse):
    """First of ``Autograde.sanitize_preprocessors``: of the submission, only the texts of the answer cells go on."""

    def preprocess(self, nb_, resources):
        own = self._sheet(resources)
        answers = nb.answers(nb_, own.problems)
        rebuilt = copy.deepcopy(nb.rebuilt(own.master, answers))
        rebuilt["metadata"]["newton_euler"] = {**rebuilt["metadata"]["newton_euler"], "notes": {i: a.note for i, a in answers.items() if a.note}}
        return from_dict(rebuilt), resources


class HarvestExecute(_OfCourse):
    """In place of ``Execute``: the answers run in the cage, the scores go into the outputs and on to :class:`SaveScores`."""

    def preprocess(self, nb_, resources):
        own = self._sheet(resources)
        notes = nb_["metadata"]["newton_euler"].pop("notes", {})
        answers = {i: nb.Answer(a.text, notes.get(i, "")) for i, a in nb.answers(nb_, own.problems).items()}
        receipts, note = pipeline.harvested(harvester(), own, answers)
        scores = pipeline.scored(own, answers, receipts)
        resources["newton_euler"] = scores
        if note:
            self.log.warning("%s: %s", own.student, note)
        return from_dict(pipeline.annotated(nb_, scores, note)), resources


class SaveScores(SaveAutoGrades):
    """Writes the scores, and the diagnosis as the comment, into the gradebook."""

    def _score_of(self, cell, resources):
        return resources["newton_euler"].get(cell.metadata.get("newton_euler", {}).get("problem"))

    def _add_score(self, cell, resources):
        grade = self.gradebook.find_grade(cell.metadata["nbgrader"]["grade_id"], self.notebook_id, self.assignment_id, self.student_id)
        result = self._score_of(cell, resources)
        grade.auto_score = result.points if result and utils.is_solution(cell) else 0
        grade.needs_manual_grade = grade.manual_score is not None
        self.gradebook.db.commit()

    def _add_comment(self, cell, resources):
        found = self.gradebook.find_comment(cell.metadata["nbgrader"]["grade_id"], self.notebook_id, self.assignment_id, self.student_id)
        result = self._score_of(cell, resources)
        found.auto_comment = pipeline.comment(result) if result else None
        self.gradebook.db.commit()


class GradesAndFigures(GetGrades):
    """For the feedback page: scores, what a human grader wrote, and each figure inside its text."""

    def _get_comment(self, cell, resources):
        super()._get_comment(cell, resources)
        found = self.gradebook.find_comment(cell.metadata["nbgrader"]["grade_id"], self.notebook_id, self.assignment_id, self.student_id)
        cell.metadata.nbgrader["manual_comment"] = found.manual_comment

    def preprocess_cell(self, cell, resources, index):
        for name, kinds in cell.pop("attachments", {}).items():
            for kind, data in kinds.items():
                cell.source = cell.source.replace(f"attachment:{name}", f"data:{kind};base64,{data}")
        return super().preprocess_cell(cell, resources, index)
