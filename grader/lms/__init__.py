"""Banks of questions for learning platforms, of numeric and choice answers, with each listed
mistake as a wrong answer that has its diagnosis.
"""

from .write import FORMATS, Bank, write_bank
