"""A course folder: its paths, its students, its secret, and from the secret each student's numbers.

COURSE/nbgrader_config.py   nbgrader's configuration for this course
COURSE/.course_secret       32 random bytes, from which every student's numbers are derived. Back it
up; never publish it COURSE/gradebook.db         nbgrader's gradebook; its students are the roster
COURSE/source/ release/ submitted/ autograded/ feedback/     nbgrader's folders
COURSE/scores/              result and diagnosis of every answer, as JSON
COURSE/personal/            each student's own copy of an assignment, as fetched
COURSE/student/             configuration for the students' side of the exchange; holds no secret
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

HERE = Path(__file__).resolve().parent


class CourseError(ValueError):
    """Something in a course folder is missing or invalid; the message says what to do."""


class Course:
    """A course in a folder: ``Course.create(path)`` makes a new one, ``Course(path)`` opens an
    existing one.
    """

    def __init__(self, path):
        self.path = Path(path).resolve()
        if not (self.path / "nbgrader_config.py").exists():
            raise CourseError(
                f"{path} is not a course folder: it has no nbgrader_config.py. Make one "
                f"with: python -m grader build ch04 --course {path}"
            )

    @classmethod
    def create(cls, path, name=None):
        """Make a new course without students or assignments, in a folder that is empty or does not
        exist yet.
        """
        cls.refuse_existing(path)
        path = Path(path).resolve()
        path.mkdir(parents=True, exist_ok=True)
        name = name or path.name.replace(" ", "-")
        _write(path / ".course_secret", secrets.token_hex(32), 0o600)
        student = path / "student"
        student.mkdir()
        shutil.copy(HERE / "assignment" / "fetch.py", student / "newton_euler_fetch.py")
        _write(student / "nbgrader_config.py", _template("student_config.py.in", name=name), 0o644)
        _write(
            path / "nbgrader_config.py",
            _template("nbgrader_config.py.in", repository=str(HERE.parent), name=name),
            0o644,
        )
        return cls(path)

    @staticmethod
    def refuse_existing(path):
        """Raise :class:`CourseError` if the folder holds anything."""
        if Path(path).exists() and any(Path(path).iterdir()):
            raise CourseError(
                f"{path} exists and is not empty; name a new folder, or add to the course in "
                "it with build --update"
            )

    name = property(lambda self: self.path.name, doc="The name of the folder.")

    @cached_property
    def secret(self):
        """The bytes from which every student's numbers are derived."""
        path = self.path / ".course_secret"
        if not path.exists():
            raise CourseError(
                f"{path} is missing; without it no student's numbers can be derived. "
                "Restore it from a backup; a new one changes all numbers"
            )
        try:
            return bytes.fromhex(path.read_text().strip())
        except ValueError:
            raise CourseError(
                f"{path} is damaged: expected one line of hexadecimal digits. Restore it "
                "from a backup; a new one changes all numbers"
            ) from None

    def config(self):
        """The traitlets configuration that the course's nbgrader_config.py sets, including the
        instructor's own settings.
        """
        from traitlets.config.loader import PyFileConfigLoader

        return PyFileConfigLoader("nbgrader_config.py", path=str(self.path)).load_config()

    # -- assignments

    def source(self, assignment):
        """The path of an assignment's source notebook."""
        return self.path / "source" / assignment / f"{assignment}.ipynb"

    def released_path(self, assignment):
        """The path of the notebook that nbgrader generated for release."""
        return self.path / "release" / assignment / f"{assignment}.ipynb"

    def released(self, assignment):
        """The notebook that nbgrader generated for release, as a dict."""
        path = self.released_path(assignment)
        if not path.exists():
            where = (
                "generate it with: nbgrader generate_assignment"
                if self.source(assignment).exists()
                else "build it with: python -m grader build"
            )
            raise CourseError(
                f"there is no released {assignment} in {self.path}; {where} {assignment}"
            )
        return _read_once(path, path.stat().st_mtime_ns)

    def personal_path(self, assignment, student):
        """The path of a student's own copy of an assignment."""
        return self.path / "personal" / assignment / student / f"{assignment}.ipynb"

    def values(self, assignment, student, problems):
        """One student's numbers, derived from the secret alone: {problem id: {name: number}}."""
        return {
            p.id: variants.draw(p, variants.seed(self.secret, assignment, student, p.id))
            for p in problems
        }

    def submissions(self, assignment):
        """{student: path of the submitted notebook} of an assignment, including students who are
        not on the roster.
        """
        found = {}
        for folder in sorted((self.path / "submitted").glob(f"*/{assignment}")):
            found[folder.parent.name] = folder / f"{assignment}.ipynb"
        return found

    # -- students

    db_url = property(
        lambda self: f"sqlite:///{self.path / 'gradebook.db'}",
        doc="The URL of nbgrader's gradebook.",
    )

    def gradebook(self):
        """nbgrader's gradebook, as a context manager."""
        from nbgrader.api import Gradebook

        # nbgrader runs `alembic` by name; it is installed beside the running Python
        own = os.path.dirname(sys.executable)
        if own not in os.environ.get("PATH", "").split(os.pathsep):
            os.environ["PATH"] = own + os.pathsep + os.environ.get("PATH", "")
        return Gradebook(self.db_url, self.name)

    def roster(self):
        """The sorted ids of the students in the gradebook."""
        with self.gradebook() as book:
            return sorted(s.id for s in book.students)

    def enrol(self, students):
        """Add students to the roster: ids, or dicts with id, first_name, last_name, email."""
        with self.gradebook() as book:
            for s in students:
                s = dict(s) if isinstance(s, dict) else {"id": s}
                student_id = check_id(s.pop("id"))
                book.update_or_create_student(student_id, **{k: v for k, v in s.items() if v})


_BAD_IN_ID = re.compile(r"[/\\+*?\[\]{}%<>:\"|\x00-\x1f\x7f]|^[.\s-]|\s$")


def check_id(student_id):
    """The id, if folders and nbgrader's exchange can be named by it; otherwise raises
    :class:`CourseError`.
    """
    if not student_id or _BAD_IN_ID.search(student_id):
        raise CourseError(
            f"{student_id!r} cannot be a student id: folders are named by it, and nbgrader "
            "splits names at '+'. "
            "Use letters, digits and . _ - @, beginning with a letter or digit; a number "
            "or a login name is best"
        )
    return student_id


def read_roster(path):
    """The students in a CSV file, as dicts; its header names ``id`` and optionally first_name,
    last_name, email, as nbgrader's own format does.
    """
    try:
        with open(path, newline="", encoding="utf-8-sig") as f:
            rows = list(csv.DictReader(f))
    except (UnicodeDecodeError, csv.Error) as error:
        raise CourseError(
            f"{path} cannot be read as CSV in UTF-8 ({error}); save it again as 'CSV UTF-8', "
            "separated by commas"
        ) from error
    if not rows or "id" not in rows[0]:
        got = list(rows[0]) if rows else "no rows"
        raise CourseError(
            f"{path}: expected a CSV file, separated by commas, whose first line names a "
            f"column id, and a line for each student; got {got}"
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
    """A notebook that this package or nbgrader wrote, as a plain dict with each cell's source as
    one string.
    """
    with open(path, encoding="utf-8") as f:
        notebook = json.load(f)
    for cell in notebook["cells"]:
        cell["source"] = "".join(cell["source"])  # nbgrader writes lists of lines
    return notebook


@lru_cache(maxsize=2)
def _read_once(path, changed):
    """:func:`read_json` with a cache, since a run reads the released notebook for every student;
    the result must not be modified.
    """
    return read_json(path)


def write_json(path, content, indent=1):
    """Write a dict as JSON, atomically; ``indent=None`` is 20 times faster."""
    path.parent.mkdir(parents=True, exist_ok=True)
    _write(path, json.dumps(content, ensure_ascii=False, indent=indent) + "\n", 0o644)


def _template(file, **values):
    return (HERE / "templates" / file).read_text(encoding="utf-8").format(**values)


def _write(path, text, mode):
    partial = path.with_name(f".{path.name}.partial")
    partial.write_text(text, encoding="utf-8")
    os.chmod(partial, mode)
    os.replace(partial, path)
