"""Banks of questions for learning platforms, with numbers and choices as answers, and each listed
mistake as a wrong answer with its diagnosis.
"""

from .write import FORMATS, Bank, write_bank
