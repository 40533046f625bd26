"""What several hooks share."""

from typing import Any

from nbformat import NotebookNode
from traitlets import Unicode

Processed = tuple[NotebookNode, dict[str, Any]]  # what a preprocessor returns

# key in the resources of nbconvert: the path of the annotated notebook that grading has written
WRITTEN = "newton_euler_written"


def course_path() -> Any:
    """The trait of a hook that holds the course folder."""
    return Unicode("", help="The course folder; set by grader.nbgrader_config.configure").tag(
        config=True
    )
