"""Takes one submitted notebook to its points: reads it, puts the student's work into the trusted
notebook, runs it in the sandbox, scores it, annotates the notebook.
"""

from .annotation import annotate
from .execute import RunResults, execute
from .files import UnreadableError, parse_notebook, read_notebook
from .pipeline import NotebookGrade, feedback_comment, grade_notebook
from .rebuild import Work, rebuild
from .sheet import Sheet, student_sheet
from .timestamps import read_timestamp
