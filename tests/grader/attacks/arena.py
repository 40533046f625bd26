"""A class of honest students with attackers among them, graded together by one route in one mode,
and what is found afterwards.
"""

import contextlib
import copy
import hashlib
import json
import os
import re
import shutil
import socket
import subprocess
import sys
import tempfile
import uuid
from dataclasses import dataclass, field
from pathlib import Path

from grader.assignment import build_assignment
from grader.course import Course
from tests.grader.attacks.attack import Scene, put, right_texts
from tests.grader.attacks.tables import answers, folders, machine, metadata, receipts, texts
from tests.grader.courses import change_source, copy_of, environment, points
from tests.grader.instructors_cells import ESSAY, SQUARE, TEST
from tests.grader.sandbox.jobs import as_ordinary_user

FAMILIES = {
    module.__name__.rpartition(".")[2]: module.ATTACKS
    for module in (answers, receipts, metadata, machine, folders, texts)
}
ATTACKS = {f"{f}: {name}": a for f, table in FAMILIES.items() for name, a in table.items()}
STUDENTS = {name: f"m{n:03}" for n, name in enumerate(ATTACKS)}
EVERY = 9  # attackers between one honest student and the next
SECONDS, CELL_SECONDS = 2.0, 1.0
SECRET = "5e" * 32
TOKEN = "the-token-of-the-instructor"
SQUARED = "def square(x):\n    return x * x"
REFUSED = (  # root without any rights, as in a container: no namespaces
    "import ctypes; ctypes.CDLL(None).prctl(24, 21, 0, 0, 0); "
    "ctypes.CDLL(None).capset((ctypes.c_uint32 * 2)(0x20080522, 0), (ctypes.c_uint32 * 6)())"
)


def build(folder):
    """The course as released, with a secret that makes it the same each time."""
    course = build_assignment(folder / "mechanics", "ch04", None, ("4/1", "4/16")).course
    course.path.joinpath(".course_secret").write_text(SECRET + "\n")
    identity = json.loads(course.path.joinpath("course.json").read_text())
    identity["secret_sha256"] = hashlib.sha256(bytes.fromhex(SECRET)).hexdigest()
    course.path.joinpath("course.json").write_text(json.dumps(identity))
    course = Course(course.path)
    course.enrol([*STUDENTS.values(), *honest_students()])
    change_source(
        course, lambda cells: cells.extend(copy.deepcopy((ESSAY, SQUARE, TEST))), copies=False
    )
    return course


def honest_students():
    """One before all attackers, one after each few of them, and so one after all."""
    return ["honest-first", *(f"m{n:03}-honest" for n in range(EVERY - 1, len(ATTACKS), EVERY)),
            "zz-honest"]  # fmt: skip


@dataclass
class Arena:
    """What a run left: course, {student: points}, output, seconds a job, files before and after."""

    course: Course
    outside: Path
    mark: str
    host: object = None
    before: dict = field(default_factory=dict)
    output: str = ""
    code: int = 0
    visitors: list = field(default_factory=list)
    jobs: list = field(default_factory=list)

    def scene(self, student):
        return Scene(self.course, student, self.outside, self.mark, self.host.port)


class _Host:
    """Two addresses of this machine, outside any cage, that an attack could reach."""

    def __init__(self, mark):
        self.sockets = [socket.socket(), socket.socket(socket.AF_UNIX)]
        for listener, address in zip(
            self.sockets, [("127.0.0.1", 0), f"\0host-{mark}"], strict=True
        ):
            listener.bind(address)
            listener.listen()
            listener.setblocking(False)
        self.port = self.sockets[0].getsockname()[1]

    def visitors(self):
        """The addresses that were contacted."""
        found = []
        for listener in self.sockets:
            with contextlib.suppress(BlockingIOError):
                visitor, address = listener.accept()
                visitor.close()
                found.append(address)
        return found

    def close(self):
        for listener in self.sockets:
            listener.close()


def prepare(course, folder, names, honest=None):
    """A copy of the course in which ``names`` of the attackers and the honest have handed in."""
    folder.chmod(0o755)
    outside = folder / "outside"
    outside.mkdir()
    outside.joinpath("home").mkdir()
    arena = Arena(copy_of(course, folder / "mechanics"), outside, f"attack-{uuid.uuid4().hex}")
    arena.host = _Host(arena.mark)
    for student in honest or honest_students():
        scene = arena.scene(student)
        notebook = scene.sheet()
        put(notebook, {**right_texts(arena.course, student), "square": SQUARED})
        scene.hand_in(notebook)
    for name in names:
        ATTACKS[name].make(arena.scene(STUDENTS[name]))
    arena.before = files(arena.course.path)
    return arena


def run(arena, route, ordinary=False, sandbox=True, before="", students="*", timeout=900):
    """Run a route, and record its output."""
    log = arena.outside.parent / "jobs.txt"
    log.touch()
    request = {"route": route, "course": str(arena.course.path), "log": str(log),
               "limits": [SECONDS, CELL_SECONDS], "sandbox": sandbox, "before": before,
               "students": students, "workers": 1 if ordinary else 2}  # fmt: skip
    command = [sys.executable, str(Path(__file__).with_name("child.py")), json.dumps(request)]
    if ordinary:
        command = as_ordinary_user(command)
        if command[0] == "setpriv":  # any other command keeps the owners of the files
            folder = str(arena.outside.parent)
            subprocess.run(["chown", "-hR", "54321:54321", folder], check=True)
    done = subprocess.run(
        command,
        env=environment(HOME=str(arena.outside / "home"), SOME_SECRET_TOKEN=TOKEN),
        cwd="/", capture_output=True, timeout=timeout, check=False,
    )  # fmt: skip
    arena.visitors = arena.host.visitors()
    arena.code = done.returncode
    arena.output = (done.stdout + done.stderr).decode(errors="surrogateescape")
    arena.jobs = [float(line) for line in log.read_text().split()]
    return arena


def scores(arena):
    """{student: {cell: automatic points}} of the gradebook."""
    return {s: {n: p[0] for n, p in cells.items()} for s, cells in points(arena.course).items()}


def files(folder):
    """{path: its type and content} of all files below a folder; links are not followed."""
    found = {}
    for place, names, others in os.walk(folder):
        for name in [*names, *others]:
            path = os.path.join(place, name)
            status = os.lstat(path)
            content = ""
            if os.path.stat.S_ISREG(status.st_mode) and status.st_size < 10**6:
                with open(path, "rb") as f:
                    content = hashlib.sha256(f.read()).hexdigest()
            found[os.path.relpath(path, folder)] = (status.st_mode, content)
    return found


def processes(home):
    """The processes that began in this home: what a run started, and what that started."""
    found = []
    for entry in Path("/proc").glob("[0-9]*"):
        try:
            if f"HOME={home}\0".encode() in (entry / "environ").read_bytes():
                found.append((entry.name, (entry / "cmdline").read_bytes()))
        except OSError:
            continue
    return found


def left_behind(mark):
    """Where the mark appears by which an attack names everything it makes."""
    places = ["/tmp", "/var/tmp", "/dev/shm", "/dev/mqueue", "/run"]
    found = [f"{p}/{n}" for p in places if os.path.isdir(p) for n in os.listdir(p) if mark in n]
    for table in ("/proc/net/unix", "/proc/keys", "/proc/sysvipc/shm", "/proc/sysvipc/msg",
                  "/proc/sysvipc/sem"):  # fmt: skip
        if os.path.exists(table):
            text = Path(table).read_text(errors="replace")
            lines = [x for x in text.splitlines() if mark in x and "host-" not in x]
            found += [f"{table}: {line}" for line in lines]
            found += [f"{table}: {k}" for k in re.findall(r"(?m)^ +(50\d{5}) ", text)
                      if 0x4D2000 <= int(k) < 0x4D2040]  # fmt: skip
    return found


def temporary_folder():
    """A folder that every user of the machine can enter, unlike pytest's."""
    return Path(tempfile.mkdtemp(prefix="arena-"))


def remove(folder):
    shutil.rmtree(folder, ignore_errors=True)
