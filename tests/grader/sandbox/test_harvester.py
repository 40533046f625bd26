"""The workers: they serve one job after the other, are replaced when they die, and do not wait for
each other.
"""

import os
import sys
import time
from concurrent.futures import ThreadPoolExecutor

import pytest

from grader.sandbox import Harvester, HarvestError
from tests.grader.sandbox.jobs import caged, descendants, job, still_serves
from tests.grader.sandbox.test_cage import ENDINGS

pytestmark = pytest.mark.skipif(sys.platform != "linux", reason="the cage is Linux")


def test_many_jobs_in_a_row_leave_no_process_and_no_file_open(harvester):
    caged(harvester, "x = 1")
    worker = harvester._all[-1].pid
    files, before = len(os.listdir(f"/proc/{worker}/fd")), descendants()
    for _ in range(20):
        assert still_serves(harvester)
    assert len(os.listdir(f"/proc/{worker}/fd")) == files
    assert descendants() <= before


def test_a_worker_that_dies_is_replaced(harvester):
    with Harvester(1) as one:
        assert still_serves(one)
        one._all[-1].kill()
        with pytest.raises(
            HarvestError,
            match=r"the process that runs student code is gone .*Check that newton_euler is "
            r"installed",
        ):
            one.run("", job("x = 1"))
        assert still_serves(one)


@pytest.mark.slow
def test_a_fork_bomb_beside_leaves_another_worker_its_processes():
    with Harvester(2) as two, ThreadPoolExecutor(2) as pool:
        bomb = pool.submit(two.run, "", job(ENDINGS["fork bomb"]), 3, 2)
        time.sleep(1.5)
        threads = (
            "import threading\nts = [threading.Thread(target=int) for _ in range(20)]\nfor t "
            "in ts: t.start()\nfor t in ts: t.join()\nx = 1"
        )
        other = two.run("", job(threads), 10, 5)
        bomb.result()
    assert other["receipts"]["0/1"]["answers"] == {"x": 1.0}, other


def test_a_worker_that_is_busy_delays_no_other():
    """The long job ends only when its worker is killed, after the other jobs have come back."""
    with ThreadPoolExecutor(1) as pool, Harvester(2) as two:
        long = pool.submit(two.run, "", job("while True: pass"), 600, 600)
        while two._idle.qsize() == 2:
            time.sleep(0.01)
        assert all(still_serves(two) for _ in range(3))
        assert not long.done()
        two._all[0].kill()
        with pytest.raises(HarvestError):
            long.result()
