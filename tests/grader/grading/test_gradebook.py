"""What nbgrader's gradebook holds after grading: all or nothing, with what a person graded, and
penalties for late submissions.
"""

from grader.grading import grade
from tests.grader.courses import give, points, submit, total
from tests.grader.submissions import work


def test_what_a_human_grader_gave_and_wrote_survives_grading_again(fresh):
    grade(fresh, "ch04", ["ben"])
    give(fresh, "ben", "answer-4-16", 2.5, None, "a good attempt")
    submit(fresh, "ben", work(fresh, "ben", p4_1="speed = 1.0\nacc_mag = 2.0"))
    (result,) = grade(fresh, "ch04", ["ben"])
    assert not result.unchanged
    with fresh.gradebook() as book:
        given = book.find_grade("answer-4-16", "ch04", "ch04", "ben")
        assert (given.auto_score, given.manual_score, given.score) == (3, 2.5, 2.5)
        comment = book.find_comment("answer-4-16", "ch04", "ch04", "ben")
        assert comment.manual_comment == "a good attempt"


def test_scores_that_another_grader_overwrote_are_put_right(fresh):
    grade(fresh, "ch04", ["ada"])
    with fresh.gradebook() as book:
        for g in book.find_submission_notebook("ch04", "ch04", "ada").grades:
            g.auto_score = 0
        book.db.commit()
    grade(fresh, "ch04", ["ada"])
    assert total(points(fresh)["ada"]) == 11
