"""Figures are drawn by several processes at once."""

import multiprocessing
from concurrent.futures import ProcessPoolExecutor

from exercises import problem
from grader.assignment import figure_png
from newton_euler.drawing import label_placement as labels

DRAWN = ["4/16", "4/10", "4/28", "4/7"]


def _drawn(problem_id):
    p = problem(problem_id)
    return figure_png(p, p.book_values)


def _kept(_):
    return len(labels._parsers)


def test_a_forked_process_reads_fonts_of_its_own_and_draws_the_same():
    """A parsed formula holds an open font file. Two processes that read one file get each other's
    bytes: FT_Load_Glyph fails now and then.
    """
    here = {i: _drawn(i) for i in DRAWN}
    assert labels._parsers
    with ProcessPoolExecutor(2, mp_context=multiprocessing.get_context("fork")) as pool:
        assert set(pool.map(_kept, range(2))) == {0}
        assert [
            here[i] == there for i, there in zip(DRAWN, pool.map(_drawn, DRAWN), strict=True)
        ] == [True] * len(DRAWN)
