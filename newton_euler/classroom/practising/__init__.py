"""Practice: problems with numbers as often as wanted, every step checked at once."""

from .collection import Practice, practice, try_problem
from .files import PracticeFileError
from .problems import CheckResult, Message, PracticeProblem
