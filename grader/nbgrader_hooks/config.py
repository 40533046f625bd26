"""nbgrader's configuration for a course: replaces three of its steps, the exchange's fetch,
collect and release, and the feedback page.
"""

import json
import warnings
from pathlib import Path

import nbgrader

# the names that each course's nbgrader_config.json holds, too
PINNED = Path(__file__).parents[1] / "course" / "templates" / "nbgrader_config.json"
STUB = {"python": ""}
PREPROCESSORS = "grader.nbgrader_hooks.preprocessors"


def configure(c, course):
    """Set nbgrader's configuration object ``c`` for the course whose ``nbgrader_config.py`` has the
    path ``course``.
    """
    # nbgrader 0.9 on SQLAlchemy 2.1: three warnings without effect
    warnings.filterwarnings("ignore", module="sqlalchemy")
    root = Path(course).resolve().parent
    c.CourseDirectory.root = str(root)
    c.CourseDirectory.db_url = f"sqlite:///{root / 'gradebook.db'}"
    if (root / "course.json").exists():  # in an earlier version the id stood in the configuration
        c.CourseDirectory.course_id = json.loads((root / "course.json").read_text())["id"]

    c.ClearSolutions.code_stub = STUB
    c.ExchangeFactory.fetch_assignment = "grader.assignment.fetch.PersonalFetch"
    for section, names in json.loads(PINNED.read_text()).items():
        for trait, name in names.items():
            setattr(c[section], trait, name)

    c.Autograde.create_student = False  # a folder of an unknown student is reported, not graded
    c.Autograde.sanitize_preprocessors = [f"{PREPROCESSORS}.RebuildFromSource"]
    c.Autograde.autograde_preprocessors = [f"{PREPROCESSORS}.HarvestExecute"]
    # always: it follows what changed, and completes what a killed run left; what was run is kept
    c.Autograde.force = True
    for name in (
        "RebuildFromSource", "HarvestExecute", "GradesAndFigures", "SubmissionReader",
        "FeedbackPage", "WorkedSolutions",
    ):  # fmt: skip
        c[name].course_path = str(root)

    # grading by hand shows "Submission #1": the student's name in the introduction stays out
    c.HTMLExporter.preprocessors = ["grader.nbgrader_hooks.grading_page.WithoutName"]
    c.HTMLExporter.filters = {"markdown2html": "grader.nbgrader_hooks.grading_page.markdown2html"}
    # the feedback page has the name of nbgrader's own, which the formgrader asks for; the
    # formgrader's other templates stay reachable
    c.HTMLExporter.extra_template_basedirs = [
        str(Path(__file__).with_name("templates")),
        str(Path(nbgrader.__file__).parent / "server_extensions/formgrader/templates"),
    ]
    c.GenerateFeedback.preprocessors = [
        f"{PREPROCESSORS}.GradesAndFigures",
        "grader.nbgrader_hooks.feedback_page.Sections",
        "grader.nbgrader_hooks.solutions.WorkedSolutions",
    ]
