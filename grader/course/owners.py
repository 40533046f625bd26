"""The owners of the files in an archive, by names that a learning platform or a teacher gave. A
file is a student's only if every significant word in the name is theirs: "Ada Smith" matches no one
if the roster has only an Ada Lovelace, even with the id "ada".
"""

import re
import unicodedata
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from itertools import permutations, takewhile
from pathlib import PurePosixPath
from typing import TYPE_CHECKING

if TYPE_CHECKING:  # importing it takes longer than most commands
    from nbgrader.api import Student


# names of work by platforms: ``who`` handed it in, perhaps with the ``title`` of the assignment;
# ``number`` is the platform's for that person; the rest was chosen by the student
PLATFORMS = tuple(map(re.compile, (
    r"(?P<who>.+?)_\d+_assignsubmission_",  # Moodle
    r"(?P<who>.+?)(_LATE)?_(?P<number>\d+)_\d+_",  # Canvas
    r"(?P<who>(?P<title>.+?)_.+?)_attempt_\d{4}-",  # Blackboard
    r"\d+-\d+ - (?P<who>.+?) - ",  # Brightspace
    r"(?P<who>[^,(]+, [^(]+\([^()]+\))$",  # Sakai
)))  # fmt: skip
Words = tuple[str, ...]
WORDS = re.compile(r"[^\W_]+")
# words that describe a file, not its owner
SILENT = frozenset(WORDS.findall("""
    answer answers archive assignment assignments attachment attachments attempt code copy copies
    corrected download draft exercise exercises export exports file files final finished folder
    homework hw ipynb jupyter late my nb new notebook notebooks of old part problem problems set
    sheet solution solutions student students submission submissions submit submitted task tasks
    the upload uploads version week work works zip s v v1 v2 v3 v4 v5
"""))  # fmt: skip
_BEFORE_DIGITS = re.compile(r"(?<=[^\W\d_])[-_. ]+(?=\d)")
_SUFFIX = re.compile(r"(?i)\.ipynb$")
LONGEST_NAME = 6  # words of a name that are tried in any order


@dataclass(frozen=True)
class Person:
    """The words that identify a student: ids, the whole name, the name joined to one word in any
    order, and other words that are theirs.
    """

    ids: tuple[Words, ...]
    name: Words
    joined: frozenset[str]
    own: frozenset[str]
    number: str  # the platform's number of the student, or ""

    @classmethod
    def read(cls, student: "Student") -> "Person":
        """The words of a student on the roster."""
        mail, number = student.email or "", student.lms_user_id or ""
        ids = tuple(w for x in (student.id, number, mail.partition("@")[0]) if (w := words_of(x)))
        both = student.first_name and student.last_name
        name = words_of(f"{student.first_name} {student.last_name}") if both else ()
        joined = permutations(name) if 0 < len(name) <= LONGEST_NAME else ()
        names = frozenset(map("".join, joined))
        own = names.union(words_of(mail), name, *ids)
        return cls(ids, name, names, own, number)

    def is_named(self, found: Words, silent: frozenset[str]) -> bool:
        """True if these words identify this student, and none is foreign."""
        telling = [i for i in self.ids if not all(_is_silent(w, silent, 2) for w in i)]
        return all(w in self.own or _is_silent(w, silent) for w in found) and (
            any(_holds(found, i) for i in telling)
            or (bool(self.name) and {*self.name} <= {*found})
            or not self.joined.isdisjoint({*found} - silent)
        )


def _is_silent(word, silent, digits=4):
    """True for a word that identifies no one, or a short number, as in a date or after a copy."""
    return word in silent or (word.isdigit() and len(word) <= digits)


def words_of(text: str) -> Words:
    """Words in lower case without accents: ("jane", "doe", "4711") of "Doé_Jane-4711"."""
    plain = unicodedata.normalize("NFKD", text)
    plain = "".join(c for c in plain if not unicodedata.combining(c))
    return tuple(WORDS.findall(plain.casefold()))


def _holds(found, wanted):
    n = len(wanted)
    return any(found[k : k + n] == wanted for k in range(len(found) - n + 1))


@dataclass(frozen=True)
class Candidates:
    """The people to whom work may belong, and the words of the assignment's title."""

    people: Mapping[str, Person]
    title: frozenset[str]

    @property
    def silent(self) -> frozenset[str]:
        """The words that identify no one."""
        return SILENT | self.title

    def tells(self, part: str) -> bool:
        """True if the name of a folder or file identifies an owner."""
        silent = all(_is_silent(w, self.silent) for w in words_of(part))
        return not silent or bool(_of_platform(part) or self.named_in(part))

    def named_in(self, part: str, common: frozenset[str] = frozenset()) -> list[str]:
        """The students identified by the name of a folder or file, without ``common`` words."""
        match = _of_platform(part)
        who, number, titled = _who(part, match)
        if number and (known := [s for s, p in self.people.items() if p.number == number]):
            return known
        found = tuple(w for w in words_of(who) if w not in common)

        def named(silent):
            spelled = found, words_of(_BEFORE_DIGITS.sub("", who))  # "ada 2" may be of ada2
            return [s for s, p in self.people.items() if not (number and p.number)
                    if any(p.is_named(x, silent) for x in spelled)]  # fmt: skip

        exact = named(self.title) if match else []
        return exact or (named(self.silent) if titled else [])

    def owners(self, folders: Sequence[str], own: str, common: frozenset[str]) -> list[str]:
        """The owners by the outermost folder that identifies one, or else by the file's own name,
        and other students named by folders inside it.
        """
        telling = [part for part in folders if self.tells(part)] or [own]
        first, *inner = telling
        found = self.named_in(first) or self.named_in(first, common)
        if not self.tells(first):
            # the name of the assignment identifies no one, even if it is also an id
            parts = {
                w for part in (*folders, own) if not self.title.issuperset(w := words_of(part))
            }
            found = [s for s, p in self.people.items() if not parts.isdisjoint(p.ids)]
        others = [s for part in inner if found for s in self.named_in(part)]
        return list(dict.fromkeys([*found, *others]))


def _of_platform(part):
    """The match of the platform pattern that ends first: what follows is the student's."""
    found = [match for p in PLATFORMS if (match := p.match(part))]
    return min(found, key=lambda match: match.end(), default=None)


def _who(part, match):
    """(who handed a part in, their number or None, whether they may be named)."""
    if not match:
        return part, None, True
    found = match.groupdict()
    return found["who"], found.get("number"), "title" in found


def owners(
    names: Sequence[str], assignment: str, people: Mapping[str, Person]
) -> dict[str, list[str]]:
    """{name of a file: its possible owners}.

    A folder of all files holds the work of a class if its name is not a platform's for one student
    and identifies no one, and its content belongs to two or more students.
    """
    candidates = Candidates(people, frozenset(words_of(assignment)))
    paths = {n: PurePosixPath(_SUFFIX.sub("", n).replace("\\", "/")).parts for n in names}
    lead = _shared(path[:-1] for path in paths.values())
    inside = _owners({n: path[len(lead) :] for n, path in paths.items()}, candidates)
    whose = {found[0] for found in inside.values() if len(found) == 1}
    of_one = any(_of_platform(part) or candidates.named_in(part) for part in lead)
    return inside if len(whose) > 1 and not of_one else _owners(paths, candidates)


def _owners(paths, candidates):
    telling = {next(filter(candidates.tells, folders), own) for *folders, own in paths.values()}
    common = _common({words_of(_who(part, _of_platform(part))[0]) for part in telling})
    return {n: candidates.owners(folders, own, common) for n, (*folders, own) in paths.items()}


def _shared(folders: Iterable[Sequence[str]]) -> list[str]:
    """The folders that contain all files."""
    return [level[0] for level in takewhile(lambda x: len({*x}) == 1, zip(*folders, strict=False))]


def _common(found: set[Words]) -> frozenset[str]:
    """The words common to several names, as the title of the course."""
    return frozenset.intersection(*map(frozenset, found)) if len(found) > 1 else frozenset()
