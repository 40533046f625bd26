"""Answers to problems and results of grading as text, JSON, tables, pictures and CSV.

answers      the answers of problems
catalogue    the problems to choose from; measured: what students earned in them
preview      one problem as an instructor sees it, as a page or text
tables       the results of a run of the grader, for the terminal
records      the scores that the grader has kept, part by part
statistics   difficulty, discrimination and mistakes of each part
export       CSV of every part, and the files that learning platforms import
diagnoses    how often the mistakes of the exercises are recognised
unlisted     the same of unlisted slips (slips_made makes them, setups_made those in a set-up)
"""

from .answers import answers_json, answers_text, as_json, given_values, solution_text, solve_problem
from .catalogue import problems_table
from .diagnoses import diagnosis_shares, shares_table
from .export import FORMATS, export
from .measured import measured
from .preview import preview, preview_page, preview_text
from .statistics import part_statistics, statistics_csv, statistics_figure, statistics_table
from .tables import diagnosis_table, gradebook_table, in_cell, taken_in_table
from .unlisted import RANDOM, SLIP_OUTCOMES, slip_shares
