"""A Dask cluster of several worker processes on this machine: the same scores, even when a worker
is killed; what is unfit is refused, and nothing is left running.
"""

import contextlib
import os
import pickle
import signal
import socket
import subprocess
import sys
import threading
import time
from unittest import mock

import pytest

from grader.course import Course, CourseError
from grader.grading import Result, grade
from grader.grading import cluster as grading
from tests.grader.courses import command, environment, gradebook_rows, ran, submit
from tests.grader.grading.test_histories import notebooks
from tests.grader.submissions import DAMAGED

pytest.importorskip("distributed")
psutil = pytest.importorskip("psutil")  # comes with Dask
pytestmark = [
    pytest.mark.integration,
    pytest.mark.filterwarnings("ignore::ResourceWarning"),
    pytest.mark.filterwarnings("ignore::DeprecationWarning"),
]


PLAIN = {"DASK_DISTRIBUTED__COMM__COMPRESSION": "null"}


def dask_process(*arguments, **more):
    return subprocess.Popen(
        [sys.executable, "-m", "dask", *map(str, arguments), "--no-dashboard"],
        env=environment(DASK_DISTRIBUTED__COMM__TIMEOUTS__CONNECT="20", **more),
        stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, start_new_session=True,
    )  # fmt: skip


class Cluster:
    def __init__(self, folder):
        self.file, self.workers = folder / "scheduler.json", []
        place = "--host", "127.0.0.1", "--port", 0, "--scheduler-file", self.file
        self.scheduler = dask_process("scheduler", *place, **PLAIN)
        self.wait(self.file.exists)
        self.address = self.client(lambda c: c.scheduler.address)

    @staticmethod
    def wait(done, seconds=60):
        until = time.monotonic() + seconds
        while not done():
            assert time.monotonic() < until
            time.sleep(0.05)

    def client(self, ask):
        from distributed import Client

        with Client(scheduler_file=str(self.file), set_as_default=False) as client:
            return ask(client)

    def living(self):
        return [worker for worker in self.workers if worker.poll() is None]

    def at_least(self, count):
        """Set the number of workers."""
        self.workers += [
            dask_process("worker", "--scheduler-file", self.file, "--nthreads", 1, "--no-nanny")
            for _ in range(count - len(self.living()))
        ]
        self.client(lambda c: c.wait_for_workers(count, timeout=60))
        return self

    def below(self):
        """The processes that the workers have started."""
        found = []
        for worker in self.workers:
            with contextlib.suppress(psutil.NoSuchProcess):
                found += psutil.Process(worker.pid).children(recursive=True)
        return found

    def end(self):
        for process in (*self.workers, self.scheduler):
            process.kill()
            process.wait()


@pytest.fixture(scope="module")
def cluster(tmp_path_factory):
    cluster = Cluster(tmp_path_factory.mktemp("cluster"))
    yield cluster
    cluster.end()


@pytest.fixture
def two_workers(cluster):
    return cluster.at_least(2)


def test_no_scheduler_and_no_workers_are_reported(fresh, cluster, monkeypatch):
    with monkeypatch.context() as changed:
        changed.setattr("grader.grading.cluster.ANSWER_SECONDS", 1)
        with pytest.raises(CourseError, match=r"no scheduler of Dask answers at tcp://127.0.0.1:9"):
            grade(fresh, "ch04", scheduler="tcp://127.0.0.1:9")
    assert not cluster.workers  # the other tests start them
    with pytest.raises(CourseError, match=r"has no workers; start some with: dask worker tcp:"):
        grade(fresh, "ch04", scheduler=cluster.address)


def test_a_cluster_gives_the_same_scores_and_leaves_nothing_running(fresh, two_workers, course):
    output = []
    results = grade(fresh, "ch04", scheduler=two_workers.address, report=output.append)
    assert not [r.problem for r in results if r.problem]
    assert {r.sandbox for r in results} == {"namespaces"}
    assert gradebook_rows(fresh) == gradebook_rows(course)
    assert notebooks(fresh) == notebooks(course)
    assert [line.split(": ")[1] for line in output] == ["1 at a time, namespaces"] * 2
    two_workers.wait(lambda: not two_workers.below())
    assert not list(fresh.path.glob("scores/.plan*"))
    again = grade(fresh, "ch04", scheduler=two_workers.address)
    assert all(r.unchanged for r in again)


def test_a_damaged_submission_and_a_stranger_are_reported_as_without_a_cluster(fresh, two_workers):
    submit(fresh, "ada", DAMAGED["truncated"][0])
    submit(fresh, "zoe", DAMAGED["empty"][0])
    here = {r.student: r.problem for r in grade(fresh, "ch04")}
    there = grade(fresh, "ch04", scheduler=two_workers.address, force=True)
    assert {r.student: r.problem for r in there} == here
    assert "is damaged" in here["ada"]
    assert "is not on the roster" in here["zoe"]


def test_the_command_names_the_workers(fresh, two_workers):
    out = ran(command("grade", "ch04", "--course", fresh.path, "--scheduler", two_workers.address))
    assert out.count("1 at a time, namespaces") == 2


class Wire:
    """Passes on what is sent to the scheduler and what it answers, and records both."""

    def __init__(self, address):
        host, port = address.removeprefix("tcp://").split(":")
        self.there, self.seen = (host, int(port)), bytearray()
        self.socket = socket.create_server(("127.0.0.1", 0))
        self.address = "tcp://127.0.0.1:{1}".format(*self.socket.getsockname())
        threading.Thread(target=self.accept, daemon=True).start()

    def accept(self):
        with contextlib.suppress(OSError):  # it is closed at the end
            while True:
                ends = self.socket.accept()[0], socket.create_connection(self.there)
                for ours, theirs in (ends, ends[::-1]):
                    threading.Thread(target=self.pass_on, args=(ours, theirs), daemon=True).start()

    def pass_on(self, ours, theirs):
        with contextlib.suppress(OSError), ours, theirs:
            try:
                while data := ours.recv(2**16):
                    self.seen += data
                    theirs.sendall(data)
            finally:  # to close a socket on which the other thread waits would not end it
                for end in (ours, theirs):
                    with contextlib.suppress(OSError):
                        end.shutdown(socket.SHUT_RDWR)


@pytest.fixture(scope="module")
def wired(cluster):
    """A wire with one worker."""
    import dask.config

    wire = Wire(cluster.address)
    worker = dask_process("worker", wire.address, "--nthreads", 1, "--no-nanny", **PLAIN)
    cluster.workers.append(worker)
    cluster.client(lambda c: c.wait_for_workers(len(cluster.living()), timeout=60))
    with wire.socket, dask.config.set({"distributed.comm.compression": None}):
        yield wire


def test_nothing_of_a_student_and_no_secret_passes_the_scheduler(fresh, wired):
    submit(fresh, "zoe", DAMAGED["empty"][0])
    results = grade(fresh, "ch04", scheduler=wired.address, force=True)
    read = {p.read.encode() for r in results for s in r.scores.values() for p in s.parts}
    notes = {p.message.encode()[:30] for r in results for s in r.scores.values() for p in s.parts}
    ids = [r.student.encode() for r in results]
    assert len(ids) == 7
    assert len(read) > 10
    assert b"_grade" in wired.seen
    assert str(fresh.path).encode() in wired.seen
    private = {fresh.secret, fresh.secret.hex().encode(), b"SyntaxError", b"not on the roster"}
    private |= {b"\x8c%c%b" % (len(i), i) for i in ids} | {b"mallory", b"cleo"} | notes
    private |= {x for x in read if len(x) > 5}
    assert not [x for x in private if x in wired.seen]


def test_a_worker_that_sees_another_course_is_refused(fresh, two_workers, monkeypatch):
    monkeypatch.setattr(grading, "_code", lambda: "another version")
    with pytest.raises(CourseError, match=r"tcp://.* cannot grade: .* another version of the che"):
        grade(fresh, "ch04", scheduler=two_workers.address)
    monkeypatch.undo()
    monkeypatch.setattr(Course, "secret", b"another secret" * 3)
    with pytest.raises(CourseError, match=r"cannot grade: .* is not the course's folder there"):
        grade(Course(fresh.path), "ch04", scheduler=two_workers.address)


def raising(grade, _):
    """A worker's ``_grade`` where each submission raises an error that names it."""

    def raise_there(shared, n):
        with mock.patch.object(
            grading.GradingRun, "grade", lambda run, who, _: open(f"submitted/{who}")
        ):
            return grade(shared, n)

    return raise_there


def lying(_, file):
    """A worker's ``_grade`` that names someone else's file as its result."""
    return lambda shared, n: str(file)


@pytest.mark.parametrize(
    ("worker", "problem"), [(raising, "submitted/ada"), (lying, "FileNotFoundErr")]
)
def test_a_worker_that_fails_sends_no_text_and_names_no_file(
    fresh, wired, monkeypatch, tmp_path, worker, problem
):
    other = tmp_path / "other"
    other.write_bytes(pickle.dumps((Result("ada"), None)))
    monkeypatch.setattr(grading, "_grade", worker(grading._grade, other))
    results = grade(fresh, "ch04", scheduler=wired.address, force=True)
    assert all("its worker failed" in r.problem for r in results)
    assert problem in results[0].problem
    assert not [r.student for r in results if f"submitted/{r.student}".encode() in wired.seen]
    assert other.exists()


def dying(victims, monkeypatch):
    """The next run's first check kills these workers."""
    pids = [worker.pid for worker in victims]

    def examine(shared):
        if os.getpid() in pids:
            os.kill(os.getpid(), signal.SIGKILL)
        return original(shared)

    original = grading._examine
    monkeypatch.setattr(grading, "_examine", examine)


@pytest.mark.slow
def test_others_do_a_dead_workers_work_until_all_have_died(fresh, cluster, course, monkeypatch):
    """Killed at its work, in its first check, and as the last one."""
    address, started, output = cluster.at_least(3).address, [], []
    first, *others = cluster.living()

    def kill_first(_):
        if not started:
            started.extend(cluster.below())
            first.kill()

    results = grade(fresh, "ch04", scheduler=address, progress=kill_first)
    assert not [r.problem for r in results if r.problem]
    assert gradebook_rows(fresh) == gradebook_rows(course)
    assert len(started) >= 3
    cluster.wait(lambda: not [p for p in started if p.is_running()])

    dying(others[:1], monkeypatch)
    results = grade(fresh, "ch04", scheduler=address, force=True, report=output.append)
    assert not [r.problem for r in results if r.problem]
    assert gradebook_rows(fresh) == gradebook_rows(course)
    died = "it died in its first check, and the others do its work"
    assert sorted(line.split(": ")[1] for line in output) == ["1 at a time, namespaces", died]

    dying(others, monkeypatch)
    with pytest.raises(CourseError, match="no worker of the cluster has passed its first che"):
        grade(fresh, "ch04", scheduler=address, report=output.append)
    assert [line.split(": ")[1] for line in output].count(died) == len(others)

    monkeypatch.undo()
    (last,) = cluster.at_least(1).living()
    with pytest.raises(CourseError, match=r"all workers of the cluster have died; .* are kept"):
        grade(fresh, "ch04", scheduler=address, force=True, progress=lambda _: last.kill())


def hanging(pids, monkeypatch):
    """These workers hang at whatever they grade, and every worker at the first submission."""

    def grade_there(shared, n):
        while n == 0 or os.getpid() in pids:
            time.sleep(0.1)
        return original(shared, n)

    original = grading._grade
    monkeypatch.setattr(grading, "_grade", grade_there)


@pytest.mark.slow  # waits for what hangs, and busy processes beside it hang as well
def test_others_do_what_hung_once_and_what_hung_twice_is_named(fresh, cluster, course, monkeypatch):
    """The second time the workers have imported everything, and nothing has to be run."""
    address, output = cluster.at_least(4).address, []
    first, *_ = workers = cluster.living()
    grade(fresh, "ch04", scheduler=address)
    hanging([first.pid], monkeypatch)
    monkeypatch.setattr(grading, "RUN_SECONDS", 10)
    try:
        results = grade(fresh, "ch04", scheduler=address, report=output.append)
        assert [r.student for r in results if "two workers hung on it" in r.problem] == ["ada"]
        assert not [r.problem for r in results[1:] if r.problem]
        assert gradebook_rows(fresh) == gradebook_rows(course)
        hung = [x.split(": ")[0] for x in output if "finished nothing for 20 s, and the oth" in x]
        assert len({*hung}) == len(hung)
        assert len(hung) in (2, 3)  # the worker that always hangs may be one of the two
        monkeypatch.setattr(grading, "READY_SECONDS", 5)
        with pytest.raises(CourseError, match=r"all workers .* hang or have died; .* are kept"):
            grade(fresh, "ch04", ["ada"], scheduler=address, report=output.append)
        late = [x.split(": ")[0] for x in output if "not answered for 5 s, and the oth" in x]
        assert sorted(late) == sorted(hung)
    finally:
        for worker in workers:
            worker.kill()
