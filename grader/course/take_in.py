"""Students' work from a zip archive of a learning platform, without nbgrader's exchange.

Students control every name and every byte in an archive: a name is only compared with the roster
and never used as a path, links are not followed, and sizes are counted while reading.
"""

import contextlib
import stat
import zipfile
from dataclasses import dataclass, field
from datetime import UTC, datetime
from pathlib import Path, PurePosixPath

from .files import write_bytes, write_text
from .folder import Course
from .identity import CourseError, seen_as
from .owners import Person, owners, words_of

# zipfile bounds what these methods unpack; with others 600 bytes may become a gigabyte
METHODS = zipfile.ZIP_STORED, zipfile.ZIP_DEFLATED
MAX_BYTES = 64 * 2**20  # the largest notebook that the grader reads
MAX_TOTAL = 4 * 2**30  # bytes of all notebooks
MAX_ENTRIES = 20_000
LONGEST_NAME = 500  # characters; the patterns of platforms take quadratic time


@dataclass
class TakeInResult:
    """The outcome for the files of an archive: {student: name} taken, [(student, name)] where
    earlier work was kept, [(name, reason)] refused.
    """

    taken: dict[str, str] = field(default_factory=dict)
    kept: list[tuple[str, str]] = field(default_factory=list)
    refused: list[tuple[str, str]] = field(default_factory=list)


def take_in(
    course: Course, assignment: str, archive: str | Path, replace: bool = False, times: bool = False
) -> TakeInResult:
    """Put each notebook of a zip archive into COURSE/submitted, as its student's work; returns
    :class:`TakeInResult`.

    A file is a student's if the name of its folder, or without one its own, has their id or whole
    name and no word that may be someone else's, see :mod:`.owners`. Names chosen by students do not
    count: those inside a folder of theirs, or what follows a platform's numbers.
    replace : also replace earlier work. times : use the times in the archive, as UTC, as times of
    submission; otherwise the times are unknown, and nobody is late.
    """
    course.require_released(assignment)
    with course.gradebook() as book:
        people = {s.id: Person.read(s) for s in book.students}
    if not people:
        raise CourseError("nobody is on the roster to whom a file could belong; enrol first")
    result = TakeInResult()
    with _opened(archive) as z:
        entries = z.infolist()
        if len(entries) > MAX_ENTRIES:
            raise CourseError(f"{archive} has {len(entries)} entries, more than a class has")
        if lost := _listed(archive, z.start_dir) - len(entries):
            why = f"its list of contents is damaged, and hides {lost} more; get the archive again"
            result.refused.append((Path(archive).name, why))
        chosen = _chosen(entries, assignment, people, result)
        _write(course, assignment, z, chosen, replace, times, result)
    return result


def _opened(archive):
    try:
        return zipfile.ZipFile(archive)
    except Exception as error:  # zipfile raises a dozen types for damaged archives
        raise CourseError(f"{archive} is not a zip archive that can be read ({error})") from error


def _listed(archive, start):
    """The number of entries in the list of contents; a wrong length in one hides later ones."""
    with open(archive, "rb") as f:
        f.seek(start)
        return f.read().count(b"PK\x01\x02")


def _chosen(entries, assignment, people, result):
    """{student: their notebook}; files that fit no one, and several that fit one student, are
    refused: a file named after another student must not replace that one's work.
    """
    found = {}
    files = [(e, _refusal(e)) for e in entries if not e.filename.endswith("/")]
    owned = owners([e.filename for e, why in files if not why], assignment, people)
    for entry, why in files:
        fits = owned.get(entry.filename, [])
        if len(fits) == 1 and not why:
            found.setdefault(fits[0], []).append(entry)
            continue
        whose = f"several students: {', '.join(fits)}" if fits else "nobody on the roster"
        result.refused.append((entry.filename, why or f"its name fits {whose}"))
    chosen = {}
    for student, own in found.items():
        named = [e for e in own if {*words_of(assignment)} <= {*words_of(e.filename)}]
        candidates = named or own
        why = f"one of {len(candidates)} that fit {student}; leave the right one in the archive"
        if len(candidates) == 1:
            chosen[student] = candidates[0]
            why = f"{candidates[0].filename} was taken for {student}"
        rest = [e for e in own if e is not chosen.get(student)]
        result.refused += [(e.filename, why) for e in rest]
    return chosen


def _refusal(entry):
    kind = stat.S_IFMT(entry.external_attr >> 16)
    if kind not in (0, stat.S_IFREG):
        return "a link or a special file"
    if not entry.filename.lower().endswith(".ipynb"):
        return "not a notebook"
    if len(entry.filename) > LONGEST_NAME:
        return f"its name has more than {LONGEST_NAME} characters"
    path = PurePosixPath(entry.filename.replace("\\", "/"))
    if path.is_absolute() or ".." in path.parts or ":" in path.parts[0]:
        return "its name leads out of the archive"
    if "__MACOSX" in path.parts or any(part.startswith(".") for part in path.parts):
        return "not a notebook"  # companion files of macOS, checkpoints of Jupyter
    if entry.flag_bits & 1:
        return "it is encrypted"
    if entry.compress_type not in METHODS:
        return "it is compressed by an unusual method; pack it again as a plain zip archive"
    if entry.file_size > MAX_BYTES:
        return f"it has more than the {MAX_BYTES / 1e6:.0f} MB that are read"
    return ""


def _write(course, assignment, archive, chosen, replace, times, result):
    total = 0
    present = {seen_as(s): s for s in course.submissions(assignment)}
    for student, entry in sorted(chosen.items()):
        if seen_as(student) in present and not replace:
            result.kept.append((student, entry.filename))
            continue
        try:
            with archive.open(entry) as f:
                content = f.read(MAX_BYTES + 1)  # the size stated in an archive may be wrong
        except Exception as error:  # a damaged notebook must not stop the others
            result.refused.append((entry.filename, f"it is damaged: {error}"))
            continue
        total += len(content)
        if len(content) > MAX_BYTES or total > MAX_TOTAL:
            why = "it is larger than it says, or all together are too large"
            result.refused.append((entry.filename, why))
            continue
        try:
            _put(course, assignment, student, content, entry.date_time if times else None)
        except OSError as error:
            result.refused.append((entry.filename, f"it cannot be written: {error}"))
            continue
        result.taken[student] = entry.filename


def _put(course, assignment, student, content, date):
    folder = course.path / "submitted" / student / assignment
    folder.mkdir(parents=True, exist_ok=True, mode=0o700)
    for earlier in ("timestamp.txt", "submission_secret.txt"):
        (folder / earlier).unlink(missing_ok=True)
    if date:
        with contextlib.suppress(ValueError):  # a careless archive, as with month 0
            when = datetime(*date, tzinfo=UTC)
            write_text(folder / "timestamp.txt", f"{when:%Y-%m-%d %H:%M:%S} UTC\n")
    write_bytes(folder / f"{assignment}.ipynb", content)
