"""Practice: problems with numbers as often as wanted, every step checked at once."""

from .files import PracticeFileError
from .practice import Practice, practice
from .problems import Checked, PracticeProblem, Said
