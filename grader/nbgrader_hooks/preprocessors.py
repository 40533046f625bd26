"""Preprocessors that replace nbgrader's own: rebuild the submission, run and score its answers,
save the scores, prepare the feedback page.
"""

import atexit
import copy

from nbformat import from_dict
from nbgrader import utils
from nbgrader.preprocessors import GetGrades, NbGraderPreprocessor, SaveAutoGrades
from traitlets import Unicode

from ..assignment.notebook import own_metadata
from ..course import Course
from ..sandbox import Harvester
from ..submission import pipeline
from ..submission.rebuild import SubmittedAnswer, read_answers, rebuild_notebook

_harvester = None


def shared_harvester():
    """The harvester of this process, started at the first call; nbgrader makes new preprocessors
    for every notebook.
    """
    global _harvester
    if _harvester is None:
        _harvester = Harvester(1).__enter__()
        atexit.register(_harvester.__exit__)
    return _harvester


class _CoursePreprocessor(NbGraderPreprocessor):
    course_path = Unicode(
        "", help="The course folder; set by grader.nbgrader_config.configure"
    ).tag(config=True)

    def _student_assignment(self, resources):
        names = resources["nbgrader"]
        return pipeline.student_assignment(
            Course(self.course_path), names["assignment"], names["student"]
        )


class RebuildFromSource(_CoursePreprocessor):
    """The first of ``Autograde.sanitize_preprocessors``: keeps only the texts of the answer cells
    of a submission.
    """

    def preprocess(self, notebook, resources):
        own = self._student_assignment(resources)
        answers = read_answers(notebook, own.problems)
        rebuilt = copy.deepcopy(rebuild_notebook(own.master, answers))
        rebuilt["metadata"]["newton_euler"] = {
            **rebuilt["metadata"]["newton_euler"],
            "notes": {i: a.note for i, a in answers.items() if a.note},
        }
        return from_dict(rebuilt), resources


class HarvestExecute(_CoursePreprocessor):
    """Replaces ``Execute``: runs the answers in the sandbox, writes the scores into the outputs and
    passes them on to :class:`SaveScores`.
    """

    def preprocess(self, notebook, resources):
        own = self._student_assignment(resources)
        notes = notebook["metadata"]["newton_euler"].pop("notes", {})
        answers = {
            i: SubmittedAnswer(a.text, notes.get(i, ""))
            for i, a in read_answers(notebook, own.problems).items()
        }
        receipts, note = pipeline.run_answers(shared_harvester(), own, answers)
        scores = pipeline.score_answers(own, answers, receipts)
        resources["newton_euler"] = scores
        if note:
            self.log.warning("%s: %s", own.student, note)
        return from_dict(pipeline.annotate(notebook, scores, note)), resources


class SaveScores(SaveAutoGrades):
    """Writes the points, and the feedback as a comment, into the gradebook."""

    def _score_of(self, cell, resources):
        return resources["newton_euler"].get(own_metadata(cell).get("problem"))

    def _add_score(self, cell, resources):
        grade = self.gradebook.find_grade(
            cell.metadata["nbgrader"]["grade_id"],
            self.notebook_id,
            self.assignment_id,
            self.student_id,
        )
        score = self._score_of(cell, resources)
        grade.auto_score = score.points if score and utils.is_solution(cell) else 0
        grade.needs_manual_grade = grade.manual_score is not None
        self.gradebook.db.commit()

    def _add_comment(self, cell, resources):
        comment = self.gradebook.find_comment(
            cell.metadata["nbgrader"]["grade_id"],
            self.notebook_id,
            self.assignment_id,
            self.student_id,
        )
        score = self._score_of(cell, resources)
        comment.auto_comment = pipeline.feedback_comment(score) if score else None
        self.gradebook.db.commit()


class GradesAndFigures(GetGrades):
    """For the feedback page: adds points and comments, also those of a human grader, and puts each
    figure into its text.
    """

    def _get_comment(self, cell, resources):
        super()._get_comment(cell, resources)
        comment = self.gradebook.find_comment(
            cell.metadata["nbgrader"]["grade_id"],
            self.notebook_id,
            self.assignment_id,
            self.student_id,
        )
        cell.metadata.nbgrader["manual_comment"] = comment.manual_comment

    def preprocess_cell(self, cell, resources, index):
        for name, kinds in cell.pop("attachments", {}).items():
            for kind, data in kinds.items():
                cell.source = cell.source.replace(
                    f"attachment:{name}", f"data:{kind};base64,{data}"
                )
        return super().preprocess_cell(cell, resources, index)
