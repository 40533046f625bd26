"""The notebook of an assignment, and each student's copy with their own numbers and figures.
``fetch`` is not imported here: it imports nbgrader, which takes two seconds.
"""

from .build import build_assignment
from .figures import contact_sheet, figure_faults, figure_png
from .notebook import build_notebook, personal_notebook
from .personal import copy_to_exchange, exchange_outbound, make_personal_copies
from .released import master_notebook
from .sheet import problems_of
