"""A test of each problem, as one test for each chapter. Nearly 300 tests that take a millisecond
each would be collected by each process of a run, in more time than they take themselves.
"""

from functools import update_wrapper

import pytest

from exercises.catalogue import chapters, problems


def by_chapter(test):
    """``test(p)`` for all problems of a chapter; a failure names each problem that fails."""

    @pytest.mark.parametrize("chapter", chapters())
    def of_chapter(chapter):
        failed = []
        for p in problems(chapter):
            try:
                test(p)
            except Exception as error:
                error.add_note(f"problem {p.id}")
                failed.append(error)
        if failed:
            raise ExceptionGroup(f"{len(failed)} problems of {chapter}", failed)

    update_wrapper(of_chapter, test)
    del of_chapter.__wrapped__  # pytest would ask it for the name of the argument
    return of_chapter
