"""nbgrader's configuration for a course: our steps in place of three of its own, and our feedback page."""

import warnings
from pathlib import Path

import nbgrader

STUB = {"python": ""}


def configure(c, course):
    """Set up nbgrader's configuration object ``c`` for the course whose ``nbgrader_config.py`` is ``course``."""
    warnings.filterwarnings("ignore", module="sqlalchemy")  # nbgrader 0.9 on SQLAlchemy 2.1: three warnings, no harm
    root = Path(course).resolve().parent
    c.CourseDirectory.root = str(root)
    c.CourseDirectory.db_url = f"sqlite:///{root / 'gradebook.db'}"

    c.ClearSolutions.code_stub = STUB
    c.ExchangeFactory.release_assignment = "grader.assignment.personal.ReleaseWithPersonal"
    c.ExchangeFactory.fetch_assignment = "grader.assignment.fetch.PersonalFetch"

    ours = "grader.nbgrader_hooks.preprocessors"
    c.Autograde.create_student = False  # a folder of somebody unknown is reported, not graded
    c.Autograde.sanitize_preprocessors = [
        f"{ours}.RebuildFromSource",
        "nbgrader.preprocessors.OverwriteCells",
        "nbgrader.preprocessors.CheckCellMetadata",
    ]
    c.Autograde.autograde_preprocessors = [f"{ours}.HarvestExecute", f"{ours}.SaveScores", "nbgrader.preprocessors.AssignLatePenalties"]
    for name in ("RebuildFromSource", "HarvestExecute"):
        c[name].course_path = str(root)

    # our page has the name of nbgrader's own, which the formgrader asks for; its other templates stay reachable
    c.HTMLExporter.extra_template_basedirs = [
        str(Path(__file__).with_name("templates")),
        str(Path(nbgrader.__file__).parent / "server_extensions/formgrader/templates"),
    ]
    c.GenerateFeedback.preprocessors = [f"{ours}.GradesAndFigures"]
