"""Takes students' work from a zip archive, as a learning platform exports it, into the course:
without nbgrader's exchange.

Students control every name and every byte in an archive: a name is only compared with the roster
and never used as a path, links are not followed, and sizes are counted while reading.
"""

import contextlib
import lzma
import re
import stat
import unicodedata
import zipfile
import zlib
from collections.abc import Mapping
from dataclasses import dataclass, field
from datetime import UTC, datetime
from itertools import takewhile
from pathlib import Path, PurePosixPath
from typing import TypedDict

from .files import write_bytes, write_text
from .folder import Course
from .identity import CourseError, same_student

MAX_BYTES = 64 * 2**20  # of one notebook, the most that the grader reads
MAX_TOTAL = 4 * 2**30  # bytes of all notebooks
MAX_ENTRIES = 20_000
# what zipfile raises; NotImplementedError for a compression that it does not know
UNREADABLE = zipfile.BadZipFile, NotImplementedError, EOFError, zlib.error, lzma.LZMAError, OSError
# folders into which platforms and nbgrader pack all work; besides, that of the assignment
PACKED = ["submissions"], ["submitted"], ["work"]
OF_ONE = re.compile(r"_\d+_assignsubmission_")  # the folder of one student's work, from Moodle


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

    A file is a student's if the folder that a platform gave it, or where it has none its name,
    holds their id or their whole name, and nobody else's. Platforms number the work: what comes
    after the numbers is a name that a student chose, and nobody's.
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


def owners(name: str, students: Mapping[str, Names], shared: int = 0) -> list[str]:
    """The students whose id or whole name is in the name of a file's folders, or of the file where
    it has no folder of its own. In a folder of nobody no file is anybody's.

    shared : how many of its folders all files of the archive have
    """
    *folders, own = PurePosixPath(name.removesuffix(".ipynb")).parts
    if folders[shared:] and not _named_in(folders[shared], students):
        return []
    places = folders if folders[shared:] else [*folders, own]
    return list(dict.fromkeys(s for place in places for s in _named_in(place, students)))


def _named_in(place, students):
    words = _numbered(place)
    return [s for s, own in students.items() if _is_named(own, words)]


def _numbered(part):
    """The words up to the numbers that a platform wrote, two at the most: not what follows them, as
    "_assignsubmission_file_" and the name that a student gave the file.
    """
    words = _words(part)
    first = next((n for n, word in enumerate(words) if word.isdigit()), len(words))
    second = first + 1 < len(words) and words[first + 1].isdigit()
    return words[: first + 1 + second]


def _shared(names):
    """How many folders all of these files have, as far as these may hold the work of several."""
    folders = [PurePosixPath(name).parts[:-1] for name in names]
    levels = zip(*folders, strict=False)
    return sum(1 for _ in takewhile(lambda x: len({*x}) == 1 and not OF_ONE.search(x[0]), levels))


def _identifying(names, students, packed, shared):
    """The students without ids that are words of a folder of all, or stand in the names of the work
    of several others: common words, which say nothing of an owner.
    """
    beside: dict[str, set[str]] = {s: set() for s in students}
    for name in names:
        fits = owners(name, students, shared)
        for s in fits:
            beside[s].update(fits)
    common = {s for s, others in beside.items() if len(others - {s}) > 1}
    return {
        s: {**own, "ids": [i for i in own["ids"] if s not in common and i not in packed]}
        for s, own in students.items()
    }


def _owned(names, assignment, students):
    """{name of a file: the students whose it may be}."""
    packed, shared = (*PACKED, _words(assignment)), _shared(names)
    students = _identifying(names, students, packed, shared)
    found = {name: owners(name, students, shared) for name in names}
    lead = PurePosixPath(names[0]).parts[:shared] if names else ()
    if any(_words(part) not in packed and not _named_in(part, students) for part in lead):
        # the folder of all files may be that of one student who is not on the roster
        loose = [name for name in names if len(PurePosixPath(name).parts) == shared + 1]
        whose = {s for name in loose for s in found[name]}
        if len(whose) < 2:
            inside = {s for part in lead for s in _named_in(part, students)}
            found |= {name: [s for s in found[name] if s in inside] for name in loose}
    return found


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
    files = [(e, _refusal(e)) for e in entries if not e.is_dir()]
    owned = _owned([e.filename for e, why in files if not why], assignment, students)
    for entry, why in files:
        fits = owned.get(entry.filename, [])
        if len(fits) == 1 and not why:
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
        try:
            with archive.open(entry) as f:
                content = f.read(MAX_BYTES + 1)  # the size stated in an archive may be wrong
        except UNREADABLE as error:
            result.refused.append((entry.filename, f"it is damaged: {error}"))
            continue
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
