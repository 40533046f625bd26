"""A course folder: where things are, who is in it, and its secret.

COURSE/nbgrader_config.py   nbgrader, set up for this course
COURSE/.course_secret       32 random bytes; every student's numbers follow from it. Never hand it out, never lose it
COURSE/gradebook.db         nbgrader's gradebook; its students are the roster
COURSE/source/ release/ submitted/ autograded/ feedback/     nbgrader's folders
COURSE/scores/              verdict and diagnosis of every part, as JSON
COURSE/personal/            each student's own copy of an assignment, as fetched
COURSE/student/             what goes to the students' side of the exchange: a configuration without secrets
"""

import csv
import json
import os
import re
import secrets
import shutil
import sys
from functools import cached_property, lru_cache
from pathlib import Path

from exercises import variants

from .assignment import notebook as nb

REPOSITORY = Path(__file__).resolve().parent.parent
CONFIG = '''\
"""nbgrader, set up for this course; written by python -m grader build. Add your own settings below."""

import sys

sys.path.insert(0, {repository!r})  # where grader/ and exercises/ are

from grader.nbgrader_config import configure

c = get_config()  # noqa: F821
configure(c, course=__file__)
c.CourseDirectory.course_id = {name!r}
'''


class CourseError(ValueError):
    """Something in a course folder is missing or not what it should be; the message says what to do."""


class Course:
    """The course in a folder. ``Course.create(path)`` starts one, ``Course(path)`` opens it."""

    def __init__(self, path):
        self.path = Path(path).resolve()
        if not (self.path / "nbgrader_config.py").exists():
            raise CourseError(
                f"{path} is not a course folder: it has no nbgrader_config.py. Make one with: python -m grader build ch04 --course {path}"
            )

    @classmethod
    def create(cls, path, name=None):
        """A new, empty course in a folder that does not exist yet or is empty."""
        cls.refuse_existing(path)
        path = Path(path).resolve()
        path.mkdir(parents=True, exist_ok=True)
        name = name or path.name.replace(" ", "-")
        _write(path / ".course_secret", secrets.token_hex(32), 0o600)
        student = path / "student"
        student.mkdir()
        shutil.copy(Path(__file__).with_name("assignment") / "fetch.py", student / "newton_euler_fetch.py")
        _write(student / "nbgrader_config.py", _STUDENT_CONFIG.format(name=name), 0o644)
        _write(path / "nbgrader_config.py", CONFIG.format(repository=str(REPOSITORY), name=name), 0o644)
        return cls(path)

    @staticmethod
    def refuse_existing(path):
        """Raise :class:`CourseError` if there is something in the folder."""
        if Path(path).exists() and any(Path(path).iterdir()):
            raise CourseError(f"{path} exists and is not empty; name a new folder, or add to the course in it with build --update")

    name = property(lambda self: self.path.name, doc="the name of the folder")

    @cached_property
    def secret(self):
        """The bytes that every student's numbers are derived from."""
        path = self.path / ".course_secret"
        if not path.exists():
            raise CourseError(
                f"{path} is missing; without it no student's numbers can be derived. Restore it from a backup; a new one changes all numbers"
            )
        try:
            return bytes.fromhex(path.read_text().strip())
        except ValueError:
            raise CourseError(
                f"{path} is damaged: expected one line of hexadecimal digits. Restore it from a backup; a new one changes all numbers"
            ) from None

    db_url = property(lambda self: f"sqlite:///{self.path / 'gradebook.db'}", doc="nbgrader's gradebook")

    # -- assignments

    def source(self, assignment):
        """The source notebook of an assignment."""
        return self.path / "source" / assignment / f"{assignment}.ipynb"

    def released(self, assignment):
        """The notebook as generated for release, as a dict."""
        path = self.path / "release" / assignment / f"{assignment}.ipynb"
        if not path.exists():
            where = "generate it with: nbgrader generate_assignment" if self.source(assignment).exists() else "build it with: python -m grader build"
            raise CourseError(f"there is no released {assignment} in {self.path}; {where} {assignment}")
        return _read_once(path, path.stat().st_mtime_ns)

    def personal_path(self, assignment, student):
        """Where a student's own copy of an assignment is kept."""
        return self.path / "personal" / assignment / student / f"{assignment}.ipynb"

    def master(self, assignment, student):
        """The trusted notebook that a submission is rebuilt from: the student's own copy if one was made, else made now, without figures."""
        path = self.personal_path(assignment, student)
        released = self.released(assignment)
        if path.exists():
            own = read_json(path)
            if [c["id"] for c in own["cells"]] == [c["id"] for c in released["cells"]]:
                return own
        return nb.personal(released, student, self.values(assignment, student, nb.problems_of(released)), {})

    def master_bytes(self, assignment, student):
        """What :meth:`master` reads, unread: to see whether anything changed."""
        path = self.personal_path(assignment, student)
        return (path if path.exists() else self.path / "release" / assignment / f"{assignment}.ipynb").read_bytes()

    def values(self, assignment, student, problems):
        """Each problem's numbers for one student: {problem id: {name: number}}, from the secret alone."""
        return {p.id: variants.draw(p, variants.seed(self.secret, assignment, student, p.id)) for p in problems}

    # -- people

    def gradebook(self):
        """nbgrader's gradebook, to be used in a with statement."""
        from nbgrader.api import Gradebook

        own = os.path.dirname(sys.executable)  # nbgrader runs `alembic` by name; it stands beside the Python in use
        if own not in os.environ.get("PATH", "").split(os.pathsep):
            os.environ["PATH"] = own + os.pathsep + os.environ.get("PATH", "")
        return Gradebook(self.db_url, self.name)

    def roster(self):
        """The ids of the students in the gradebook."""
        with self.gradebook() as book:
            return sorted(s.id for s in book.students)

    def enrol(self, students):
        """Put students on the roster: ids, or dicts with id, first_name, last_name, email."""
        with self.gradebook() as book:
            for s in students:
                s = dict(s) if isinstance(s, dict) else {"id": s}
                student_id = check_id(s.pop("id"))
                book.update_or_create_student(student_id, **{k: v for k, v in s.items() if v})

    def submissions(self, assignment):
        """{student: path of the submitted notebook} of an assignment, also of students who are not on the roster."""
        found = {}
        for folder in sorted((self.path / "submitted").glob(f"*/{assignment}")):
            found[folder.parent.name] = folder / f"{assignment}.ipynb"
        return found


_BAD_IN_ID = re.compile(r"[/\\+*?\[\]{}%<>:\"|\x00-\x1f\x7f]|^[.\s-]|\s$")


def check_id(student_id):
    """The id, if folders and nbgrader's exchange can be named by it; otherwise :class:`CourseError`."""
    if not student_id or _BAD_IN_ID.search(student_id):
        raise CourseError(
            f"{student_id!r} cannot be a student id: folders are named by it, and nbgrader splits names at '+'. "
            "Use letters, digits and . _ - @, beginning with a letter or digit; a number or a login name is best"
        )
    return student_id


def read_roster(path):
    """Students from a CSV file with a header that has ``id``, and perhaps first_name, last_name, email (nbgrader's own format)."""
    try:
        with open(path, newline="", encoding="utf-8-sig") as f:
            rows = list(csv.DictReader(f))
    except (UnicodeDecodeError, csv.Error) as error:
        raise CourseError(f"{path} cannot be read as CSV in UTF-8 ({error}); save it again as 'CSV UTF-8', separated by commas") from error
    if not rows or "id" not in rows[0]:
        got = list(rows[0]) if rows else "no rows"
        raise CourseError(
            f"{path}: expected a CSV file, separated by commas, whose first line names a column id, and a line for each student; got {got}"
        )
    known = ("id", "first_name", "last_name", "email")
    students = [{k: (r[k] or "").strip() for k in known if r.get(k)} for r in rows]
    seen = set()
    for n, s in enumerate(students, 2):
        if not s.get("id"):
            raise CourseError(f"{path}, line {n}: no id")
        try:
            check_id(s["id"])
        except CourseError as error:
            raise CourseError(f"{path}, line {n}: {error}") from None
        if s["id"] in seen:
            raise CourseError(f"{path}, line {n}: the id {s['id']!r} is there twice")
        seen.add(s["id"])
    return students


def read_json(path):
    """A notebook that we or nbgrader wrote, as a plain dict with each cell's source as one text."""
    with open(path, encoding="utf-8") as f:
        notebook = json.load(f)
    for cell in notebook["cells"]:
        cell["source"] = "".join(cell["source"])  # nbgrader writes lists of lines
    return notebook


@lru_cache(maxsize=2)
def _read_once(path, changed):
    """A notebook that a run reads for every student; not to be modified."""
    return read_json(path)


def write_json(path, content, indent=1):
    """Write a notebook whole or not at all; without an indent 20 times faster."""
    path.parent.mkdir(parents=True, exist_ok=True)
    _write(path, json.dumps(content, ensure_ascii=False, indent=indent) + "\n", 0o644)


def _write(path, text, mode):
    partial = path.with_name(f".{path.name}.partial")
    partial.write_text(text, encoding="utf-8")
    os.chmod(partial, mode)
    os.replace(partial, path)


_STUDENT_CONFIG = '''\
"""For the students' side: put this file and newton_euler_fetch.py where Jupyter reads nbgrader_config.py (a hub's /etc/jupyter, or ~/.jupyter)."""

import os
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))

c = get_config()  # noqa: F821
c.ExchangeFactory.fetch_assignment = "newton_euler_fetch.PersonalFetch"
c.CourseDirectory.course_id = {name!r}
'''
