"""The workers: they serve one job after another, are replaced when they die, and do not wait for
each other.
"""

import os
import sys
import time
from concurrent.futures import ThreadPoolExecutor

import pytest

from grader.assignment.notebook import SETUP
from grader.sandbox import Harvester, HarvestError
from grader.sandbox import harvester as harvester_module
from grader.sandbox.worker import Worker
from tests.grader.sandbox.jobs import (
    answer,
    caged,
    descendants,
    job,
    own,
    problem,
    run_caged,
    still_serves,
    wait_until,
)
from tests.grader.sandbox.test_cage import ENDINGS

pytestmark = pytest.mark.skipif(sys.platform != "linux", reason="the cage is Linux")


def test_many_jobs_in_a_row_leave_no_process_and_no_file_open(harvester):
    caged(harvester, "x = 1")
    worker = harvester._all[-1].process.pid
    files, before = len(os.listdir(f"/proc/{worker}/fd")), descendants()
    for _ in range(20):
        assert still_serves(harvester)
    # what is opened once, when it is needed, may stay open; not one for each job
    assert wait_until(lambda: len(os.listdir(f"/proc/{worker}/fd")) < files + 10)
    assert wait_until(lambda: descendants() <= before)


def test_a_worker_that_dies_between_jobs_is_replaced(harvester):
    with Harvester(1) as one:
        assert still_serves(one)
        one._all[-1].settle()  # it dies without a word
        one._all[-1].process.kill()
        one._all[-1].process.wait()
        assert still_serves(one)
        assert len(one._all) == 1


def test_a_worker_that_cannot_start_is_an_error_that_says_what_to_check(monkeypatch, tmp_path):
    script = tmp_path / "broken.py"
    script.write_text("import sys; sys.exit('no such module')")
    monkeypatch.setattr("grader.sandbox.worker._SCRIPT", script)
    words = "the process that runs student code is gone .*Check that newton_euler is installed"
    with Harvester(1) as one, pytest.raises(HarvestError, match=words):
        one.run(job("x = 1"))


@pytest.mark.slow
def test_a_fork_bomb_beside_leaves_another_worker_its_processes():
    with Harvester(2) as two, ThreadPoolExecutor(2) as pool:
        bomb = pool.submit(two.run, job(ENDINGS["fork bomb"]), 3, 2)
        time.sleep(1.5)
        threads = (
            "import threading\nts = [threading.Thread(target=int) for _ in range(20)]\n"
            "for t in ts: t.start()\nfor t in ts: t.join()\nx = 1"
        )
        assert answer(two, threads) == 1.0
        bomb.result()


def test_a_busy_worker_delays_no_other():
    """The long job ends only when its worker is killed, after the other jobs have come back."""
    with ThreadPoolExecutor(1) as pool, Harvester(2) as two:
        long = pool.submit(two.run, job("while True: pass"), 600, 600)
        while two._idle.qsize() == 2:
            time.sleep(0.01)
        assert all(still_serves(two) for _ in range(3))
        assert not long.done()
        two._all[0].process.kill()
        with pytest.raises(HarvestError):
            long.result()


def test_no_submission_imports_what_the_worker_could_have_imported_for_all(harvester):
    known = "import sys\nknown = set(sys.modules)"
    new = "assert not set(sys.modules) - known, sorted(set(sys.modules) - known)"
    of, text = {"problem": "0/2"}, 'a = symbols("a", real=True)\nf = 2 * a'
    answer, harvest = {"role": "answer", "text": text, **of}, {"role": "harvest", **of}
    harvest |= {"forms": {"f": "expression, m"}, "symbols": {"a": "m"}}
    cells = [own(known), own(SETUP, "setup"), *problem("0/1", "x = sqrt(2.0)", 'given("0/1", y=2)')]
    cells += [answer, harvest, own(new, "new")]
    assert run_caged(harvester, cells)["errors"] == {}


def test_a_notebook_with_millions_of_characters_or_many_small_cells_is_not_run(harvester):
    reply = harvester.run([own("[]\n" * 400_000), *job("x = 1")])
    assert reply["receipts"] == {}
    words = "not run: its 4 cells hold 1.2 million characters; the limit is 1.0 million"
    assert reply["ended"] == words
    tests = [{"role": "test", "name": "t", "text": "", "hidden": "1"}]
    reply = harvester.run([*[own("[]")] * 20_000, *job("x = 1"), *tests])
    assert "not run: its 20004 cells" in reply["ended"]
    assert "was not run" in reply["tests"]["t"]["error"]


def test_a_notebook_with_more_tests_than_can_be_run_is_an_error_of_the_course(harvester):
    tests = [{"role": "test", "name": str(n), "text": "", "hidden": ""} for n in range(201)]
    with pytest.raises(HarvestError, match="the notebook has 201 cells with tests; at most 200"):
        harvester.run(tests)


@pytest.mark.slow
def test_as_many_tests_as_allowed_are_run(harvester):
    tests = [{"role": "test", "name": str(n), "text": "", "hidden": str(n)} for n in range(200)]
    reply = run_caged(harvester, tests, seconds=60)
    assert [o["value"] for o in reply["tests"].values()] == list(range(200))


def test_the_state_of_the_sandbox_is_known_before_any_job_and_empty_cells_cost_nothing(harvester):
    assert harvester.sandbox_state == run_caged(harvester, [])["sandbox"]
    reply = run_caged(harvester, [*[own("\n \n")] * 50_000, *job("x = 1")])
    assert reply["receipts"]["0/1"]["answers"] == {"x": 1.0}


@pytest.mark.parametrize(("setting", "forbidden", "allowed"), harvester_module.SETTINGS)
def test_a_refusal_names_the_setting(monkeypatch, tmp_path, harvester, setting, forbidden, allowed):
    """Which forbids the cage, and its value that allows it."""
    file = tmp_path / setting.replace(".", "/")
    file.parent.mkdir()
    file.write_text(forbidden + "\n")
    monkeypatch.setattr(harvester_module, "KERNEL", tmp_path)
    monkeypatch.setattr(Worker, "run", lambda *_: ({"refused": "no", "ended": "x"}, b"", []))
    with pytest.raises(HarvestError) as error:
        harvester.run(job("x = 1"))
    assert str(error.value) == (
        "this machine refuses the cage for student code (no), so nothing was run. Grade on a machine "
        f"that allows user namespaces (to allow them here: sudo sysctl {setting}={allowed}), or run the code "
        "without a cage, at your own risk: python -m grader grade --unsandboxed"
    )


NEEDS = {
    "%time x = 1": "IPython",
    "x = 1\n  !ls": "IPython",
    "files = !ls": "IPython",
    "np.cross?": "IPython",
    ">>> x = 1": "IPython",
    "from IPython.display import Math": "IPython",
    "from scipy.optimize import fsolve": "scipy",
    "m = integrate(model, 0, 3)": "scipy",
    "x = 7 % 3 != 1": None,
    "print('a % b'); integrated = 3": None,
}


@pytest.mark.parametrize("text", NEEDS)
def test_rare_libraries_are_imported_for_notebooks_that_may_need_them(monkeypatch, harvester, text):
    asked = []

    def run(worker, cells, texts, limits):
        asked.extend(limits["libraries"])
        return {"sandbox": "namespaces", "ended": "done"}, b"", []

    monkeypatch.setattr(Worker, "run", run)
    harvester.run(job("x = 1", text))
    assert asked == list(filter(None, [NEEDS[text]]))
