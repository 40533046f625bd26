"""From the source notebook to the feedback page, with problems of every kind from several
chapters in one notebook, as an instructor may mix them.
"""

import pytest

from exercises.catalogue import problem
from grader.assignment import build_notebook, make_personal_copies
from grader.course import read_json, write_json
from grader.course.creation import new_course
from grader.demo.sample_students import STUDENTS, submission
from grader.grading import grade
from tests.grader.courses import nbgrader, ran, submit

KINDS = {
    "without numbers, a word, symbols with givens, no figure": ("A/7", "A/9", "A/15"),
    "integrals, of which one has symbols": ("A/24", "A/25"),
    "intervals, and a word with a number": ("2/4", "2/5", "2/18"),
    "matrices": ("3/27",),
    "counts, and a word": ("5/16", "5/20", "5/26"),
}


@pytest.mark.slow
@pytest.mark.integration
def test_six_students_earn_what_they_should(tmp_path, harvester, one_harvester_for_all):
    """All right, one listed mistake a problem, half, blank, a syntax error, hostile."""
    problems = [problem(number) for numbers in KINDS.values() for number in numbers]
    with new_course(tmp_path / "kinds") as course:
        write_json(course.source("all"), build_notebook(problems, "All kinds", 10, 60))
        course.enrol(STUDENTS)
    ran(nbgrader("generate_assignment", "all", cwd=course.path))
    expected = {}
    for student, path in make_personal_copies(course, "all", workers=1).items():
        values = course.values("all", student, problems)
        notebook, expected[student] = submission(student, read_json(path), problems, values)
        submit(course, student, notebook, "all")
    results = grade(course, "all")
    assert {r.student: r.problem or r.points for r in results} == expected
    ran(nbgrader("generate_feedback", "all", "--student=ben", cwd=course.path))
