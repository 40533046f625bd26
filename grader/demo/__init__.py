"""An example course with six students, up to the feedback pages: ``python -m grader demo``."""

from .run import run_demo
