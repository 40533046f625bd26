"""The files of assignments that ``build --help`` shows."""

EXAMPLE = """\
title: Homework 3
due: 2027-01-31 23:59 Europe/Berlin
tolerance: 1%            # of all problems; without it 0.5 %, that is three digits
help: hints              # the most that students are shown: none, check, hints or solution
problems:
  - 4/3: {points: 10, weights: {a: 2}, follow_through: 0.5, tolerance: 2%, help: none}
  - text: Friction is neglected from here on.
  - 4/16: 5              # points; without them one for each answer
  - 11/1-11/6
"""
EXAM_EXAMPLE = """\
title: Midterm
mode: exam               # one attempt, other numbers, no hints, feedback after it has closed
opens: 2027-01-31 09:00 Europe/Berlin
closes: 2027-01-31 11:00 Europe/Berlin
late: refuse             # or mark: what comes later is graded with a remark
problems: [4/3, 7/5]
"""


def indented(text: str) -> str:
    """A text as click leaves it: a block of lines."""
    return "".join(f"  {line}\n" for line in text.splitlines())
