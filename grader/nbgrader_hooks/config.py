"""nbgrader's configuration for a course, with the steps and pages of the hooks."""

import atexit
import json
import warnings
from pathlib import Path

import nbgrader
from traitlets.config import Config

from ..course.shared import open_to

# the names that are also in each course's nbgrader_config.json
PINNED = Path(__file__).parents[1] / "course" / "templates" / "nbgrader_config.json"
STUB = {"python": ""}
PREPROCESSORS = "grader.nbgrader_hooks.preprocessors"


def configure(c: Config, course: str) -> None:
    """Set nbgrader's configuration ``c`` for the course with this ``nbgrader_config.py``."""
    # nbgrader 0.9 on SQLAlchemy 2.1 gives three warnings without consequence
    warnings.filterwarnings("ignore", module="sqlalchemy")
    root = Path(course).resolve().parent
    c.CourseDirectory.root = str(root)
    c.CourseDirectory.db_url = f"sqlite:///{root / 'gradebook.db'}"
    if (root / "course.json").exists():  # earlier versions have the id in the configuration
        settings = json.loads((root / "course.json").read_text(encoding="utf-8"))
        c.CourseDirectory.course_id = settings["id"]
        if group := settings.get("group"):  # set by: python -m grader share
            c.CourseDirectory.groupshared = True
            atexit.register(open_to, root, group)
        if "late_share_per_day" in settings:  # set by: python -m grader late
            c.AssignLatePenalties.plugin_class = "grader.nbgrader_hooks.late.LatePolicy"
            c.LatePolicy.share_per_day = settings["late_share_per_day"]

    c.ClearSolutions.code_stub = STUB
    c.ExchangeFactory.fetch_assignment = "grader.assignment.fetch.PersonalFetch"
    for section, names in json.loads(PINNED.read_text()).items():
        for trait, name in names.items():
            setattr(c[section], trait, name)

    c.GenerateAssignment.exporter_class = "grader.nbgrader_hooks.generate.SourceReader"
    c.Autograde.create_student = False  # unknown students are reported, not graded
    c.Autograde.sanitize_preprocessors = [f"{PREPROCESSORS}.RebuildFromSource"]
    c.Autograde.autograde_preprocessors = [f"{PREPROCESSORS}.HarvestExecute"]
    # always, to follow every change and complete a killed run; finished runs are kept
    c.Autograde.force = True
    for name in (
        "RebuildFromSource", "HarvestExecute", "GradesAndFigures", "SubmissionReader",
        "FeedbackPage", "WorkedSolutions", "SourceReader", "SaveChangedCells",
    ):  # fmt: skip
        c[name].course_path = str(root)

    # manual grading is anonymous ("Submission #1"), so the introduction must not name the student
    c.HTMLExporter.preprocessors = ["grader.nbgrader_hooks.grading_page.WithoutName"]
    c.HTMLExporter.filters = {"markdown2html": "grader.nbgrader_hooks.grading_page.markdown2html"}
    # our feedback template has the name of nbgrader's, requested by the formgrader; its other
    # templates remain available
    c.HTMLExporter.extra_template_basedirs = [
        str(Path(__file__).with_name("templates")),
        str(Path(nbgrader.__file__).parent / "server_extensions/formgrader/templates"),
    ]
    c.GenerateFeedback.preprocessors = [
        f"{PREPROCESSORS}.GradesAndFigures",
        "grader.nbgrader_hooks.feedback_page.Sections",
        "grader.nbgrader_hooks.solutions.WorkedSolutions",
    ]
