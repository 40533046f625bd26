"""Nothing that a submission started outlives it, a killed worker, or a killed grader; and all its
processes together share a memory limit.
"""

import os
import signal
import subprocess
import sys
import time
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import pytest

from grader.sandbox import Harvester
from grader.sandbox.cage.watch import descendants
from tests.grader.courses import REPOSITORY, environment
from tests.grader.sandbox import jobs

pytestmark = pytest.mark.skipif(sys.platform != "linux", reason="the cage is Linux")

SLEEPER = """
import ctypes, os, signal, time
for n in range(1, 65):
    try: signal.signal(n, signal.SIG_IGN)
    except (OSError, ValueError): pass
for _ in range(3):
    if os.fork() == 0:
        try: os.setsid()
        except OSError: pass
        ctypes.CDLL(None).prctl(1, 0, 0, 0, 0)
ctypes.CDLL(None).prctl(1, 0, 0, 0, 0)
while True:
    try: time.sleep(1000)
    except BaseException: pass
"""
GRADER = f"""
import sys
sys.path.insert(0, {str(REPOSITORY)!r})
from grader.sandbox import Harvester
with Harvester(1) as h:
    print(h.sandbox_state, flush=True)
    h.run({jobs.job(SLEEPER)!r}, 600, 600)
"""
PROCESSES = 2 + 8  # worker and first process; and what three forks in a row make of one


def is_alive(pid):
    try:
        return Path(f"/proc/{pid}/stat").read_text().rpartition(")")[2].split()[0] != "Z"
    except OSError:
        return False


def test_a_process_is_seen_whatever_bytes_it_is_named():
    named = "import ctypes; ctypes.CDLL(None).prctl(15, bytes([255])); print(flush=True); input('')"
    command, pipe = [sys.executable, "-c", named], subprocess.PIPE
    with subprocess.Popen(command, stdin=pipe, stdout=pipe, stderr=subprocess.DEVNULL) as process:
        process.stdout.readline()
        assert process.pid in descendants()


@pytest.mark.parametrize("killed", ["grader", "worker"])
def test_no_sleeper_outlives_a_killed(killed):
    command = [sys.executable, "-c", GRADER]
    grader = subprocess.Popen(
        command, env=environment(), stdout=subprocess.PIPE, stderr=subprocess.DEVNULL
    )
    try:
        if grader.stdout.readline() != b"namespaces\n":
            pytest.skip("this kernel refuses the cage")
        assert jobs.wait_until(lambda: len(jobs.descendants(grader.pid)) == PROCESSES)
        started = jobs.descendants(grader.pid)
        worker = min(started)
        os.kill(grader.pid if killed == "grader" else worker, signal.SIGKILL)
        assert jobs.wait_until(lambda: not any(map(is_alive, started)))
    finally:
        grader.kill()
        grader.wait()
        grader.stdout.close()


MANY_CHILDREN = """
import os, time
for _ in range(12):
    if os.fork() == 0:
        hold = bytearray(2**29)
        for i in range(0, len(hold), 4096): hold[i] = 1
        time.sleep(1000)
time.sleep(1000)
"""


def test_the_memory_of_all_children_together_is_limited(harvester):
    """Twelve children of half a gigabyte each, within the limit of each process."""
    reply = jobs.run_caged(harvester, jobs.job("x = 1", MANY_CHILDREN), seconds=30, cell_seconds=30)
    assert reply["ended"] == "stopped at 3 GB of memory"
    assert reply["receipts"]["0/1"]["answers"] == {"x": 1.0}
    assert jobs.still_serves(harvester)


def test_children_that_share_what_they_hold_are_not_counted_twice(harvester):
    text = """
    import os, time
    hold = bytearray(2**29)
    for i in range(0, len(hold), 4096): hold[i] = 1
    for _ in range(12):
        if os.fork() == 0:
            time.sleep(1)
            os._exit(0)
    for _ in range(12): os.wait()
    x = 1
    """
    assert jobs.answer(harvester, text, seconds=30, cell_seconds=20) == 1.0


def test_the_number_of_files_is_limited(harvester):
    text = """
    x = 0
    try:
        while True:
            open(f"/tmp/{x}", "w").close()
            x += 1
    except OSError:
        pass
    """
    assert 10_000 < jobs.answer(harvester, text) < 20_000


HOG = """
import os
for _ in range(50):
    if os.fork() == 0:
        try: os.setsid()
        except OSError: pass
        while True: pass
while True: pass
"""
SHARE = """
import time
wall, own = time.monotonic(), time.process_time()
while time.process_time() - own < 0.3: pass
x = 0.3 / (time.monotonic() - wall)
"""


@pytest.mark.benchmark
def test_fifty_busy_processes_leave_a_neighbour_its_share_of_the_processor():
    """One submission is one session, among which the scheduler shares the processor."""
    setting = Path("/proc/sys/kernel/sched_autogroup_enabled")
    if not setting.exists() or setting.read_text() != "1\n":
        pytest.skip("this machine does not share by session")
    with Harvester(2) as two, ThreadPoolExecutor(1) as pool:
        hog = pool.submit(two.run, jobs.job(HOG), 6, 5)
        time.sleep(2)
        assert jobs.answer(two, SHARE, seconds=60, cell_seconds=60) > 0.2  # and not 1/25
        hog.result()


LEFT = "left-by-another"
SCAN = """
import ctypes, os
needle = b"left-by-" + b"another"
libc, page = ctypes.CDLL(None), 4096
libc.sbrk.restype = ctypes.c_void_p
ends = os.pipe()

def content(at):
    # the kernel reads the page: where there is none this is an error, not a crash
    return os.read(ends[0], page) if libc.write(ends[1], ctypes.c_void_p(at), page) == page else None

def found_near(at, pages=20_000):
    hits, at = 0, at & -page
    for first, step in ((at, page), (at - page, -page)):
        missing = 0
        for place in range(first, first + step * pages, step):
            data = content(place)
            hits += data.count(needle) if data else 0
            missing = 0 if data else missing + 1
            if missing > 256:
                break
    return hits

own = ctypes.create_string_buffer(needle)
assert found_near(ctypes.addressof(own))  # it does find what is there
del own
x = found_near(id(object())) + found_near(libc.sbrk(0) - page) + found_near(id(bytes(10**6)))
"""


def test_nothing_of_another_submission_is_in_the_memory_of_a_process(harvester):
    """Its answers, its receipts, the texts of tests: a search where Python and C keep objects."""
    before = jobs.answer(harvester, SCAN)  # copies of its own needle
    test = {"role": "test", "name": "t", "text": "", "hidden": f"'{LEFT}'"}
    cells = [jobs.own(f"a = '{LEFT}'\n1 / 0 # {LEFT}"), *jobs.job(f"x = 1  # {LEFT}"), test]
    for _ in range(5):
        jobs.run_caged(harvester, cells)
    assert jobs.answer(harvester, SCAN) == before
