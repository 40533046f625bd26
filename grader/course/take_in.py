"""Takes students' work from a zip archive, as a learning platform exports it, into the course:
without nbgrader's exchange.

Students control every name and every byte in an archive: a name is only compared with the roster
and never used as a path, links are not followed, and sizes are counted while reading.
"""

import contextlib
import re
import stat
import unicodedata
import zipfile
from collections.abc import Mapping
from dataclasses import dataclass, field
from datetime import UTC, datetime
from pathlib import Path, PurePosixPath
from typing import TypedDict

from .files import write_bytes, write_text
from .folder import Course
from .identity import CourseError, same_student

MAX_BYTES = 64 * 2**20  # of one notebook, the most that the grader reads
MAX_TOTAL = 4 * 2**30  # bytes of all notebooks
MAX_ENTRIES = 20_000
# what zipfile raises; NotImplementedError for a compression that it does not know
UNREADABLE = zipfile.BadZipFile, NotImplementedError, EOFError


class Names(TypedDict):
    """The words of a student's ids and name, in lower case."""

    ids: list[list[str]]
    name: set[str]


WORDS = re.compile(r"[^\W_]+")


@dataclass
class TakenIn:
    """What became of the files of an archive: {student: name} of those taken, [(student, name)]
    where earlier work was kept, [(name, reason)] of those refused.
    """

    taken: dict[str, str] = field(default_factory=dict)
    kept: list[tuple[str, str]] = field(default_factory=list)
    refused: list[tuple[str, str]] = field(default_factory=list)


def take_in(
    course: Course, assignment: str, archive: str | Path, replace: bool = False, times: bool = False
) -> TakenIn:
    """Put each notebook of a zip archive into COURSE/submitted, as its student's work; returns
    :class:`TakenIn`.

    A file is a student's if its name, or that of its folder, holds their id or their whole name,
    and nobody else's.
    replace : also where the student has already handed in. times : the times of the files in the
        archive, read as UTC, are those of submission; otherwise none is kept, and nobody is late.
    """
    course.require_released(assignment)
    with course.gradebook() as book:
        students = {s.id: _names(s) for s in book.students}
    if not students:
        raise CourseError("nobody is on the roster to whom a file could belong; enrol first")
    result = TakenIn()
    try:
        with zipfile.ZipFile(archive) as z:
            entries = z.infolist()
            if len(entries) > MAX_ENTRIES:
                raise CourseError(f"{archive} has {len(entries)} entries, more than a class has")
            chosen = _chosen(entries, assignment, students, result)
            _write(course, assignment, z, chosen, replace, times, result)
    except UNREADABLE as error:
        raise CourseError(f"{archive} is not a zip archive that can be read ({error})") from error
    return result


def _names(student):
    """The words of a student's name, and the id, as :func:`_words` gives them."""
    name = f"{student.first_name or ''} {student.last_name or ''}"
    mail = (student.email or "").partition("@")[0]
    return {
        "ids": [w for w in map(_words, (student.id, student.lms_user_id or "", mail)) if w],
        "name": set(_words(name)) if student.first_name and student.last_name else set(),
    }


def _words(text):
    """Words in lower case without accents: ["jane", "doe", "4711"] of "Doé_Jane-4711"."""
    plain = unicodedata.normalize("NFKD", text)
    plain = "".join(c for c in plain if not unicodedata.combining(c))
    return WORDS.findall(plain.casefold())


def owners(name: str, students: Mapping[str, Names]) -> list[str]:
    """The students whose id or whole name is in the name of a file or of its folder."""
    # Canvas joins the parts of a name: doejane_4711_815_work.ipynb
    places = [_words(part) for part in PurePosixPath(name.removesuffix(".ipynb")).parts]
    return [s for s, own in students.items() if any(_is_named(own, place) for place in places)]


def _is_named(own, words):
    return any(_holds(words, i) for i in own["ids"]) or (
        own["name"] and (own["name"] <= set(words) or any(_joins(w, own["name"]) for w in words))
    )


def _holds(words, wanted):
    n = len(wanted)
    return any(words[k : k + n] == wanted for k in range(len(words) - n + 1))


def _joins(word, name):
    return len(word) == sum(map(len, name)) and all(part in word for part in name)


def _chosen(entries, assignment, students, result):
    """{student: their notebook}; a file that fits nobody, or one of several that fit a student, is
    refused: one named after another student must not replace that one's work.
    """
    found = {}
    for entry in entries:
        if entry.is_dir():
            continue
        why = _refusal(entry)
        fits = [] if why else owners(entry.filename, students)
        if len(fits) == 1:
            found.setdefault(fits[0], []).append(entry)
            continue
        whose = f"several students: {', '.join(fits)}" if fits else "nobody on the roster"
        result.refused.append((entry.filename, why or f"its name fits {whose}"))
    chosen = {}
    for student, own in found.items():
        named = [e for e in own if _holds(_words(e.filename), _words(assignment))]
        if len(candidates := named or own) == 1:
            chosen[student] = candidates[0]
        rest = [e for e in own if e is not chosen.get(student)]
        why = (
            f"{chosen[student].filename} was taken for {student}"
            if student in chosen
            else f"one of {len(candidates)} that fit {student}; leave the right one in the archive"
        )
        result.refused += [(e.filename, why) for e in rest]
    return chosen


def _refusal(entry):
    kind = stat.S_IFMT(entry.external_attr >> 16)
    if kind not in (0, stat.S_IFREG):
        return "a link or a special file"
    if not entry.filename.endswith(".ipynb"):
        return "not a notebook"
    path = PurePosixPath(entry.filename.replace("\\", "/"))
    if path.is_absolute() or ".." in path.parts or ":" in path.parts[0]:
        return "its name leads out of the archive"
    if "__MACOSX" in path.parts or path.name.startswith("."):
        return "not a notebook"  # macOS writes such companions
    if entry.flag_bits & 1:
        return "it is encrypted"
    if entry.file_size > MAX_BYTES:
        return f"it has more than the {MAX_BYTES / 1e6:.0f} MB that are read"
    return ""


def _write(course, assignment, archive, chosen, replace, times, result):
    total = 0
    present = {same_student(s): s for s in course.submissions(assignment)}
    for student, entry in sorted(chosen.items()):
        if same_student(student) in present and not replace:
            result.kept.append((student, entry.filename))
            continue
        with archive.open(entry) as f:
            content = f.read(MAX_BYTES + 1)  # the size stated in an archive may be wrong
        total += len(content)
        if len(content) > MAX_BYTES or total > MAX_TOTAL:
            why = "it is larger than it says, or all together are too large"
            result.refused.append((entry.filename, why))
            continue
        _put(course, assignment, student, content, entry.date_time if times else None)
        result.taken[student] = entry.filename


def _put(course, assignment, student, content, date):
    folder = course.path / "submitted" / student / assignment
    folder.mkdir(parents=True, exist_ok=True, mode=0o700)
    for earlier in ("timestamp.txt", "submission_secret.txt"):
        (folder / earlier).unlink(missing_ok=True)
    if date:
        with contextlib.suppress(ValueError):  # month 0 in a careless archive
            when = datetime(*date, tzinfo=UTC)
            write_text(folder / "timestamp.txt", f"{when:%Y-%m-%d %H:%M:%S} UTC\n")
    write_bytes(folder / f"{assignment}.ipynb", content)
