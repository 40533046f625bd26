"""nbgrader's configuration for a course: replaces three of its steps, the exchange's fetch and
release, and the feedback page.
"""

import warnings
from pathlib import Path

import nbgrader

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

    c.ClearSolutions.code_stub = STUB
    c.ExchangeFactory.release_assignment = "grader.nbgrader_hooks.release.ReleaseWithPersonal"
    c.ExchangeFactory.fetch_assignment = "grader.assignment.fetch.PersonalFetch"

    c.Autograde.create_student = False  # a folder of an unknown student is reported, not graded
    c.Autograde.sanitize_preprocessors = [
        f"{PREPROCESSORS}.RebuildFromSource",
        "nbgrader.preprocessors.OverwriteCells",
        "nbgrader.preprocessors.CheckCellMetadata",
    ]
    c.Autograde.autograde_preprocessors = [
        f"{PREPROCESSORS}.HarvestExecute",
        f"{PREPROCESSORS}.SaveScores",
        "nbgrader.preprocessors.AssignLatePenalties",
    ]
    for name in ("RebuildFromSource", "HarvestExecute"):
        c[name].course_path = str(root)

    # the feedback page has the name of nbgrader's own, which the formgrader asks for; the
    # formgrader's other templates stay reachable
    c.HTMLExporter.extra_template_basedirs = [
        str(Path(__file__).with_name("templates")),
        str(Path(nbgrader.__file__).parent / "server_extensions/formgrader/templates"),
    ]
    c.GenerateFeedback.preprocessors = [f"{PREPROCESSORS}.GradesAndFigures"]
