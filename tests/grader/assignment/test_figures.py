"""The figure of every problem can be read, and figures are drawn by several processes at once."""

import multiprocessing
from concurrent.futures import ProcessPoolExecutor

import pytest

from exercises.catalogue import problem, select
from exercises.catalogue.checks import values
from grader.assignment import figure_faults, figure_png
from newton_euler.drawing.page import on_axes

by_id = pytest.mark.parametrize(
    "p", [p for p in select(["all"]) if p.figure], ids=lambda p: f"figure_{p.id.replace('/', '_')}"
)


@pytest.mark.one_in(3)
@pytest.mark.parametrize("draws", [2, pytest.param(60, marks=pytest.mark.slow)])
@by_id
def test_it_can_be_read_for_the_book_and_for_students(p, draws):
    for seed in range(draws):
        assert figure_faults(p, values(p, seed)) == []


DRAWN = ["4/16", "4/10", "4/28", "4/7"]


def _drawn(problem_id):
    p = problem(problem_id)
    return figure_png(p, p.book_values)


def _kept(_):
    return len(on_axes._parsers)


def test_a_forked_process_reads_fonts_of_its_own_and_draws_the_same():
    """Two processes that read one open font file get each other's bytes."""
    here = {i: _drawn(i) for i in DRAWN}
    assert on_axes._parsers
    with ProcessPoolExecutor(2, mp_context=multiprocessing.get_context("fork")) as pool:
        assert set(pool.map(_kept, range(2))) == {0}
        assert dict(zip(DRAWN, pool.map(_drawn, DRAWN), strict=True)) == here
