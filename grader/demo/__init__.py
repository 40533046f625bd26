"""An example course with six students, from the build to the feedback pages:
``python -m grader demo``.
"""

from .run import run_demo

__all__ = ["run_demo"]
