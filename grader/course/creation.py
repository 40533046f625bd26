"""The creation of a course folder, completely or not at all."""

import contextlib
import hashlib
import os
import secrets
import shutil
from collections.abc import Iterator
from pathlib import Path

from newton_euler.algebra.language import ENGLISH, language

from .files import write_json, write_text
from .folder import SECRET_BYTES, UNFINISHED, Course
from .identity import CourseError, course_id

TEMPLATES = Path(__file__).with_name("templates")
ASSIGNMENT = Path(__file__).parents[1] / "assignment"
FOR_STUDENTS = ("fetch", "validate")  # files that run on the students' side
MADE = {  # the files that a build writes
    UNFINISHED, ".course_secret", ".gitignore", "course.json", "gradebook.db",
    "built", "gradebook.db-journal", "nbgrader_config.json", "nbgrader_config.py", "source",
    "student",
}  # fmt: skip


def refuse_existing(path: str | Path) -> None:
    """Raise :class:`CourseError` if the folder has more than the remains of a killed build."""
    path = Path(path)
    names = {p.name for p in path.iterdir()} if path.exists() else set()
    if UNFINISHED in names:
        names = {n for n in names if not _is_made(n)}
    if names:
        raise CourseError(
            f"{path} exists and is not empty; name a new folder, or add to the course in "
            "it with build --update"
        )


@contextlib.contextmanager
def new_course(
    path: str | Path, name: str | None = None, exchange: str | Path | None = None
) -> Iterator[Course]:
    """A context with a new course, in an empty or new folder; if the block raises, nothing remains.
    Its id follows from ``name``, by default that of the folder; its language is the current one.

    The folder is marked as unfinished until the block has ended, so that the next build replaces
    what a killed one has left.
    """
    refuse_existing(path)
    path = Path(path).resolve()
    if bad := sorted(set("%?#+") & set(str(path))):
        raise CourseError(f"{path}: nbgrader cannot work in a folder with {bad[0]!r} in its path")
    existed = path.exists()
    path.mkdir(parents=True, exist_ok=True)
    _empty(path)
    try:
        _write_all(path, course_id(name or path.name), exchange)
        course = object.__new__(Course)  # Course(path) refuses unfinished courses
        course.path = path
        yield course
        (path / UNFINISHED).unlink()
    except BaseException:
        _empty(path)
        if not existed:
            path.rmdir()
        raise


def _write_all(path, name, exchange):
    (path / UNFINISHED).touch()
    path.chmod(0o700)  # personal copies, submissions and the secret are private
    secret = secrets.token_bytes(SECRET_BYTES)
    write_text(path / ".course_secret", secret.hex() + "\n")
    made = {"id": name, "secret_sha256": hashlib.sha256(secret).hexdigest()}
    spoken = {} if language() == ENGLISH else {"language": language()}
    write_json(path / "course.json", made | spoken)
    write_text(path / ".gitignore", _template("gitignore.in"), 0o644)
    student = path / "student"
    student.mkdir(mode=0o755)
    root = f"c.Exchange.root = {str(Path(exchange).resolve())!r}\n" if exchange else ""
    write_for_students(student, f"c.CourseDirectory.course_id = {name!r}\n{root}")
    if exchange:
        _make_exchange(Path(exchange))
    write_pinned(path)
    write_text(path / "nbgrader_config.py", _template("nbgrader_config.py.in") + root, 0o644)


def write_for_students(folder: Path, settings: str) -> None:
    """Write what runs on the students' side of the exchange, configured with ``settings``."""
    for file in FOR_STUDENTS:
        shutil.copy(ASSIGNMENT / f"{file}.py", folder / f"newton_euler_{file}.py")
    text = _template("student_config.py.in") + settings
    write_text(folder / "nbgrader_config.py", text, 0o644)


def write_pinned(path: Path) -> None:
    """Write nbgrader_config.json: the classes without which nbgrader must not run."""
    write_text(path / "nbgrader_config.json", _template("nbgrader_config.json"), 0o644)


def _make_exchange(folder):
    if not folder.exists():
        folder.mkdir(parents=True)
        folder.chmod(0o777)  # as nbgrader requires: everybody submits there
    elif not os.access(folder, os.W_OK | os.X_OK):
        raise CourseError(f"the exchange {folder} cannot be written; name a folder of your own")


def _is_made(name):
    """True for the name of a file that a build writes, or of one that is half written."""
    return name in MADE or (name.startswith(".") and name.endswith(".partial"))


def _empty(path):
    made = [p for p in path.iterdir() if _is_made(p.name)]
    for place in sorted(made, key=lambda p: p.name == UNFINISHED):  # the mark last
        if place.is_dir():
            shutil.rmtree(place)
        else:
            place.unlink(missing_ok=True)


def _template(file):
    return (TEMPLATES / file).read_text(encoding="utf-8")
