"""A course folder: its paths, its students, its secret, and from the secret each student's numbers.

COURSE/nbgrader_config.py   nbgrader's configuration for this course, with the instructor's settings
COURSE/nbgrader_config.json the classes without which nbgrader must stop
COURSE/course.json          the id of the course, a hash of its secret, what commands have set
COURSE/.course_secret       32 random bytes, from which every student's numbers are derived. Back it
                            up; never publish it
COURSE/gradebook.db         nbgrader's gradebook; its students are the roster
COURSE/source/ release/ submitted/ autograded/ feedback/     nbgrader's folders
COURSE/numbers/             the numbers that each student was given
COURSE/scores/              result and diagnosis of every answer, as JSON
COURSE/personal/            each student's own copy of an assignment, as fetched
COURSE/student/             configuration for the students' side of the exchange; holds no secret
"""

import contextlib
import hashlib
import hmac
import json
from collections.abc import Iterable, Iterator, Mapping
from functools import cache, cached_property
from pathlib import Path
from shlex import quote
from typing import Any

from exercises.catalogue import Problem, variants
from exercises.catalogue.places import use
from newton_euler.algebra.errors import NewtonEulerError
from newton_euler.algebra.language import choose_language

from .files import write_json
from .identity import ONLY_BY, TAKEN_FOR_ONE, CourseError, check_id, seen_as

SECRET_BYTES = 32
UNFINISHED = ".unfinished_build"  # marks a folder in which a course is being made

_ADVICE = {  # advice by SQLite's primary error code
    "SQLITE_BUSY": "another program is writing to it; wait until it has ended, then run this "
    "again. Nothing was lost",
    "SQLITE_READONLY": "it cannot be written; give yourself write permission for it and for its "
    "folder",
    "SQLITE_FULL": "the disk is full; make room, then run this again",
    "SQLITE_CANTOPEN": "it cannot be opened; give yourself permission for it and for its folder",
    "SQLITE_NOTADB": "it is damaged; restore it from a backup",
    "SQLITE_CORRUPT": "it is damaged; restore it from a backup",
    "SQLITE_ERROR": "it is of another version of nbgrader; back it up, then run: nbgrader db "
    "upgrade",
}


class Course:
    """A course in a folder that :func:`grader.course.creation.new_course` made."""

    def __init__(self, path: str | Path) -> None:
        self.path = Path(path).resolve()
        if (self.path / UNFINISHED).exists():
            raise CourseError(
                f"{path} is a course that was being made when its build was interrupted; run "
                "the same build again, without --update: it begins afresh"
            )
        if not (self.path / "nbgrader_config.py").exists():
            raise CourseError(
                f"{path} is not a course folder: it has no nbgrader_config.py. Make one "
                f"with: python -m grader build ch04 --course {path}"
            )
        prepare(self.path)

    @property
    def settings(self) -> dict[str, Any]:
        """The content of course.json; {} for a course of an earlier version, without that file."""
        path = self.path / "course.json"
        if not path.exists():
            return {}
        try:
            found = json.loads(path.read_text(encoding="utf-8"))
            return {**found, "id": str(found["id"]), "secret_sha256": str(found["secret_sha256"])}
        except (ValueError, LookupError, TypeError) as error:
            raise CourseError(
                f"{path} is damaged ({error}); restore it from a backup: it holds the id of the "
                "course, under which students fetch and submit"
            ) from error

    @property
    def exams(self) -> dict[str, dict[str, str]]:
        """The exams: {assignment: its opening time and the rule for late work}."""
        return self.settings.get("exams", {})

    def set(self, **settings: Any) -> None:
        """Change settings in course.json."""
        write_json(self.path / "course.json", {**self.settings, "id": self.name, **settings})

    @cached_property
    def name(self) -> str:
        """The course's id in exchange and gradebook; it does not follow the folder's name."""
        if known := self.settings:
            return known["id"]
        return str(self.config().CourseDirectory.get("course_id", "")) or self.path.name

    @cached_property
    def secret(self) -> bytes:
        """The bytes from which every student's numbers are derived."""
        path = self.path / ".course_secret"
        if not path.exists():
            raise CourseError(
                f"{path} is missing; without it no student's numbers can be derived. "
                "Restore it from a backup; a new one changes all numbers"
            )
        try:
            secret = bytes.fromhex(path.read_text(encoding="ascii").strip())
        except ValueError:
            secret = b""
        if len(secret) < SECRET_BYTES:
            raise CourseError(
                f"{path} is damaged: expected one line of {2 * SECRET_BYTES} hexadecimal digits. "
                "Restore it from a backup; a new one changes all numbers"
            )
        made_with = self.settings.get("secret_sha256")
        if made_with and made_with != hashlib.sha256(secret).hexdigest():
            raise CourseError(
                f"{path} is not the secret that the course was made with: every student's numbers "
                "would change, and right answers become wrong. Restore it from a backup"
            )
        return secret

    def config(self) -> Any:
        """The traitlets configuration of the course, with the instructor's own settings."""
        from traitlets.config.loader import PyFileConfigLoader

        try:
            return PyFileConfigLoader("nbgrader_config.py", path=str(self.path)).load_config()
        except Exception as error:  # the file is a program
            line = getattr(error, "lineno", None)
            where = f", line {line}" if line else ""
            raise CourseError(
                f"{self.path / 'nbgrader_config.py'}{where} does not run "
                f"({type(error).__name__}: {error}); correct it first: without the settings in it "
                "nothing is graded"
            ) from error

    @property
    def exchange(self) -> str:
        """The root of nbgrader's exchange in the configuration, "" for nbgrader's own."""
        root = self.config().Exchange.get("root", "")
        return root if isinstance(root, str) else ""

    # -- assignments

    def source(self, assignment: str) -> Path:
        """The path of an assignment's source notebook."""
        return self.path / "source" / assignment / f"{assignment}.ipynb"

    def require(self, assignment: str) -> None:
        """Raise :class:`CourseError` unless there is a source folder of the assignment."""
        if not self.source(assignment).parent.is_dir():
            known = ", ".join(sorted(p.name for p in (self.path / "source").glob("*/")))
            raise CourseError(
                f"{self.path} has no assignment {assignment}; it has {known or 'none'}"
            )

    def built(self, assignment: str) -> Path:
        """The path of a copy of the source notebook as newly written by the last build."""
        return self.path / "built" / f"{assignment}.ipynb"

    def released_path(self, assignment: str) -> Path:
        """The path of the notebook that nbgrader generated for release."""
        return self.path / "release" / assignment / f"{assignment}.ipynb"

    def require_released(self, assignment: str) -> None:
        """Raise :class:`CourseError` unless nbgrader has generated the assignment for release."""
        if self.released_path(assignment).exists():
            return
        where = "build it with: python -m grader build"
        if self.source(assignment).exists():
            where = "generate it with: nbgrader generate_assignment"
        raise CourseError(f"there is no released {assignment} in {self.path}; {where} {assignment}")

    def personal_path(self, assignment: str, student: str) -> Path:
        """The path of a student's own copy of an assignment."""
        return self.path / "personal" / assignment / student / f"{assignment}.ipynb"

    def record_path(self, assignment: str, student: str) -> Path:
        """The path of the recorded result of a student's submission."""
        # not in autograded/: nbgrader copies that to the students
        return self.path / "scores" / assignment / f"{student}.json"

    def values(
        self, assignment: str, student: str, problems: Iterable[Problem]
    ) -> dict[str, dict[str, Any]]:
        """One student's numbers, derived from the secret alone: {problem id: {name: number}}. Those
        of an exam are derived from a secret of their own.
        """
        secret = self.secret
        if assignment in self.exams:
            secret = hmac.digest(secret, b"exams", "sha256")
        return {
            p.id: variants.draw(p, variants.seed(secret, assignment, student, p.id))
            for p in problems
        }

    def submissions(self, assignment: str) -> dict[str, Path]:
        """{student: path of the submitted notebook}, even for students not on the roster."""
        folders = sorted((self.path / "submitted").glob(f"*/{assignment}"))
        return {f.parent.name: f / f"{assignment}.ipynb" for f in folders}

    # -- students

    def require_students(self, students: Iterable[str]) -> None:
        """Raise :class:`CourseError` unless all of them are on the roster."""
        if unknown := sorted(set(students) - set(self.roster())):
            raise CourseError(
                f"{', '.join(unknown)}: not on the roster; add the student first: "
                f"python -m grader enrol roster.csv --course {self.path}"
            )

    @contextlib.contextmanager
    def gradebook(self) -> Iterator[Any]:
        """nbgrader's gradebook, as a context manager; raises :class:`CourseError` if unusable."""
        from nbgrader import api
        from sqlalchemy.exc import DatabaseError

        api.get_alembic_version = newest_schema  # nbgrader's starts a process: 3 s
        try:
            with api.Gradebook(f"sqlite:///{self.path / 'gradebook.db'}", self.name) as book:
                yield book
        except DatabaseError as error:
            code = getattr(error.orig, "sqlite_errorname", "")  # SQLITE_READONLY_DIRECTORY …
            advice = _ADVICE.get("_".join(code.split("_")[:2]), "")
            raise CourseError(
                f"the gradebook {self.path / 'gradebook.db'} could not be used ({error.orig})"
                + (f": {advice}" if advice else "")
            ) from error

    def roster(self) -> list[str]:
        """The sorted ids of the gradebook; two that would share a folder are an error."""
        with self.gradebook() as book:
            ids = sorted(s.id for s in book.students)
        known: dict[str, str] = {}
        for i in ids:  # ids added by nbgrader have not been compared
            if (other := known.setdefault(seen_as(i), i)) != i:
                raise CourseError(
                    f"the students {other!r} and {i!r} on the roster differ {ONLY_BY}: "
                    f"{TAKEN_FOR_ONE}. Remove one with: nbgrader db student remove {quote(i)}"
                )
        return ids

    def students(self) -> list[dict[str, str]]:
        """The roster with names, as from :func:`~grader.course.roster.read_roster`."""
        asked, named = self.roster(), ("first_name", "last_name")
        with self.gradebook() as book:
            found = {s.id: {n: getattr(s, n) or "" for n in named} for s in book.students}
        return [{"id": i, **found[i]} for i in asked]

    def enrol(self, students: Iterable[str | Mapping[str, str]]) -> int:
        """Add students to the roster: ids, or dicts with id, first_name, last_name, email,
        lms_user_id; returns how many are new.
        """
        new = 0
        with self.gradebook() as book:
            before = {s.id for s in book.students}
            enrolled = {seen_as(i): i for i in before}
            for s in students:
                details = {"id": s} if isinstance(s, str) else dict(s)
                student_id = check_id(details.pop("id"))
                present = enrolled.setdefault(seen_as(student_id), student_id)
                if present != student_id:
                    raise CourseError(
                        f"{student_id!r} differs from {present!r}, who is on the roster, "
                        f"{ONLY_BY}: {TAKEN_FOR_ONE}. Write {present!r} if it is the same "
                        "student, else give one another id"
                    )
                new += student_id not in before
                known = {k: v for k, v in details.items() if v}
                book.update_or_create_student(student_id, **known)
        return new


@cache
def newest_schema() -> str:
    """The version of the tables in a new gradebook of nbgrader."""
    import nbgrader
    from alembic.script import ScriptDirectory

    return str(ScriptDirectory(Path(nbgrader.__file__).parent / "alembic").get_current_head())


def prepare(path: Path) -> None:
    """Add a course's own problems, from the folders in course.json, and switch to its language."""
    known: dict[str, Any] = {}
    with contextlib.suppress(OSError, ValueError):  # reported on opening the course
        known = dict(json.loads((path / "course.json").read_bytes()))
    for folder in known.get("problems_from", []):
        use(path / folder)
    if spoken := known.get("language"):
        try:
            choose_language(spoken)
        except NewtonEulerError as error:
            raise CourseError(f"{path / 'course.json'}: {error}") from None
