"""A Dask cluster of several worker processes on this machine: the same scores, also when a worker
is killed; what is not fit is refused, and nothing is left running.
"""

import contextlib
import os
import signal
import subprocess
import sys
import time

import pytest

from grader.course import Course, CourseError
from grader.grading import grade
from tests.grader.courses import command, environment, gradebook_rows, ran, submit
from tests.grader.grading.test_histories import notebooks
from tests.grader.submissions import DAMAGED

pytest.importorskip("distributed")
psutil = pytest.importorskip("psutil")  # comes with it
pytestmark = [
    pytest.mark.integration,
    pytest.mark.filterwarnings("ignore::ResourceWarning"),
    pytest.mark.filterwarnings("ignore::DeprecationWarning"),
]


def dask(*arguments, **more):
    return subprocess.Popen(
        [sys.executable, "-m", "dask", *map(str, arguments), "--no-dashboard"],
        env=environment(DASK_DISTRIBUTED__COMM__TIMEOUTS__CONNECT="20", **more),
        stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, start_new_session=True,
    )  # fmt: skip


class Cluster:
    def __init__(self, folder):
        self.file, self.workers = folder / "scheduler.json", []
        self.scheduler = dask(
            "scheduler", "--host", "127.0.0.1", "--port", 0, "--scheduler-file", self.file
        )
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

    def add_workers(self, count, living=None, **more):
        start = len(self.workers) if living is None else living
        self.workers += [
            dask("worker", "--scheduler-file", self.file, "--nthreads", 1, "--no-nanny", **more)
            for _ in range(count)
        ]
        self.client(lambda c: c.wait_for_workers(start + count, timeout=60))

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
def two_workers(tmp_path_factory):
    cluster = Cluster(tmp_path_factory.mktemp("cluster"))
    cluster.add_workers(2)
    yield cluster
    cluster.end()


@pytest.fixture
def three_workers(tmp_path):
    cluster = Cluster(tmp_path)
    cluster.add_workers(3)
    yield cluster
    cluster.end()


def test_a_cluster_gives_the_same_scores_and_leaves_nothing_running(fresh, two_workers, course):
    said = []
    results = grade(fresh, "ch04", scheduler=two_workers.address, report=said.append)
    assert not [r.problem for r in results if r.problem]
    assert {r.sandbox for r in results} == {"namespaces"}
    assert gradebook_rows(fresh) == gradebook_rows(course)
    assert notebooks(fresh) == notebooks(course)
    assert [line.split(": ")[1] for line in said] == ["1 at a time, namespaces"] * 2
    two_workers.wait(lambda: not two_workers.below())
    assert not list(fresh.path.glob("scores/.plan*"))
    again = grade(fresh, "ch04", scheduler=two_workers.address)
    assert all(r.unchanged for r in again)


def test_what_a_killed_worker_had_is_done_by_another(fresh, three_workers, course):
    started = []

    def kill(_):
        if not started:
            started.extend(three_workers.below())
            os.kill(three_workers.workers[0].pid, signal.SIGKILL)

    results = grade(fresh, "ch04", scheduler=three_workers.address, progress=kill)
    assert not [r.problem for r in results if r.problem]
    assert gradebook_rows(fresh) == gradebook_rows(course)
    assert len(started) >= 3
    three_workers.wait(lambda: not [p for p in started if p.is_running()])


def test_a_damaged_submission_and_somebody_unknown_are_told_as_without_a_cluster(
    fresh, two_workers
):
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


def test_no_secret_and_no_work_passes_the_scheduler(fresh, two_workers):
    """What is sent for a submission is its student's name and where the course is."""
    import pickle

    from grader.grading import cluster

    sent = []
    original = cluster._graded

    def spy(client, *rest):
        submit = client.submit
        client.submit = lambda *a, **k: sent.append(pickle.dumps(a[1:])) or submit(*a, **k)
        return original(client, *rest)

    cluster._graded = spy
    try:
        grade(fresh, "ch04", scheduler=two_workers.address, force=True)
    finally:
        cluster._graded = original
    assert len(sent) == len(fresh.roster())
    for data in sent:
        assert len(data) < 1000
        assert fresh.secret not in data
        assert fresh.secret.hex().encode() not in data


def test_no_scheduler_and_no_workers_are_reported(fresh, tmp_path, monkeypatch):
    with monkeypatch.context() as changed:
        changed.setattr("grader.grading.cluster.ANSWER_SECONDS", 1)
        with pytest.raises(CourseError, match=r"no scheduler of Dask answers at tcp://127.0.0.1:9"):
            grade(fresh, "ch04", scheduler="tcp://127.0.0.1:9")
    cluster = Cluster(tmp_path)
    try:
        with pytest.raises(CourseError, match=r"has no workers; start some with: dask worker tcp:"):
            grade(fresh, "ch04", scheduler=cluster.address)
    finally:
        cluster.end()


def test_a_worker_that_sees_another_course_is_refused(fresh, two_workers, monkeypatch):
    from grader.grading import cluster

    monkeypatch.setattr(cluster, "_code", lambda: "another version")
    with pytest.raises(CourseError, match=r"tcp://.* cannot grade: .* another version of the che"):
        grade(fresh, "ch04", scheduler=two_workers.address)
    monkeypatch.undo()
    monkeypatch.setattr(Course, "secret", b"another secret" * 3)
    with pytest.raises(CourseError, match=r"cannot grade: .* is not the course's folder there"):
        grade(Course(fresh.path), "ch04", scheduler=two_workers.address)


def dying(cluster, count, monkeypatch):
    """The next run's first check kills the first ``count`` of these workers."""
    from grader.grading import cluster as grading

    victims = [worker.pid for worker in cluster.workers[:count]]

    def examine(shared):
        if os.getpid() in victims:
            os.kill(os.getpid(), signal.SIGKILL)
        return original(shared)

    original = grading._examine
    monkeypatch.setattr(grading, "_examine", examine)


def test_a_worker_that_dies_in_its_first_check_does_not_stop_the_others(
    fresh, tmp_path, course, monkeypatch
):
    cluster, said = Cluster(tmp_path), []
    try:
        cluster.add_workers(2)
        dying(cluster, 1, monkeypatch)
        results = grade(fresh, "ch04", scheduler=cluster.address, report=said.append)
        assert not [r.problem for r in results if r.problem]
        assert gradebook_rows(fresh) == gradebook_rows(course)
        died = "it died in its first check, and the others do its work"
        assert sorted(line.split(": ")[1] for line in said) == ["1 at a time, namespaces", died]

        dying(cluster, 2, monkeypatch)
        with pytest.raises(CourseError, match="every worker of the cluster died in its first che"):
            grade(fresh, "ch04", scheduler=cluster.address)

        monkeypatch.undo()
        cluster.add_workers(1, living=0)
        kill = [lambda _: os.kill(cluster.workers[-1].pid, signal.SIGKILL)]
        with pytest.raises(CourseError, match=r"all workers of the cluster have died; .* are kept"):
            grade(
                fresh, "ch04", scheduler=cluster.address, force=True,
                progress=lambda r: kill and kill.pop()(r),
            )  # fmt: skip
    finally:
        cluster.end()
