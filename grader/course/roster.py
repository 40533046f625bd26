"""Lists of students, as exported by Canvas, Moodle, Gradescope, spreadsheets and registrars, with
various separators, encodings and names of columns.
"""

import codecs
import csv
import io
import re
from dataclasses import dataclass
from pathlib import Path

from .identity import ONLY_BY, TAKEN_FOR_ONE, CourseError, check_id, seen_as

SEPARATORS = ",;\t|"
MAX_BYTES = 10 * 2**20

# names of columns, in lower case and without signs; the first one present is used.
# nbgrader's own `id` comes first; a login name precedes a number, since the exchange uses logins;
# an e-mail address is the last resort
COLUMNS = {
    "id": (
        "sisloginid", "loginid", "username", "login", "netid", "benutzername", "anmeldename",
        "identifiant", "studentid", "sid", "sisuserid", "sisid", "idnumber", "studentnumber",
        "matrikelnummer", "matriculationnumber", "matrikelnr", "matrnr", "numeroetudiant",
        "numéroétudiant", "orgdefinedid", "userid", "uid", "id",
        "email", "emailaddress", "mail", "emailadresse", "courriel", "adressedecourriel",
    ),
    "first_name": (
        "firstname", "givenname", "givennames", "forename", "vorname", "prénom", "prenom",
    ),
    "last_name": ("lastname", "surname", "familyname", "nachname", "familienname", "nom"),
    "email": (
        "email", "emailaddress", "mail", "emailadresse", "courriel", "adressedecourriel",
    ),
    "full_name": ("student", "name", "fullname", "studentname", "students", "nomcomplet"),
}  # fmt: skip
PLATFORM_ID = "id"  # beside a login name: Canvas' number of the student
# rows of an exported gradebook that are not students
NOT_A_STUDENT = re.compile(r"points possible|student, test|test student", re.I)


@dataclass(frozen=True)
class Roster:
    """The students of a file, as dicts for :meth:`Course.enrol`, and how it was read."""

    students: list[dict[str, str]]
    read_as: str


def read_roster(path: str | Path, id_column: str | None = None) -> Roster:
    """The students in a CSV file; errors (:class:`CourseError`) name the line. ``id_column``: the
    header of the ids; default: the first of the usual names.
    """
    content, encoding = _decoded(path)
    first, *_ = content.split("\n", 1)
    if first.strip().lower().startswith("sep="):  # a spreadsheet's hint
        content = content[len(first) + 1 :]
    header = content.split("\n", 1)[0]
    separator = max(SEPARATORS, key=lambda s: len(_recognised(_fields(header, s))))
    if not _recognised(_fields(header, separator)):
        separator = max(SEPARATORS, key=header.count)
    rows = _rows(path, content, separator)
    if not rows:
        raise CourseError(f"{path}: {_EXPECTED}; got no rows")
    (_, names), *rows = rows
    columns = _columns(path, names, id_column)
    students = [
        _student(path, line, row, names, columns)
        for line, row in rows
        if not any(map(NOT_A_STUDENT.fullmatch, row))
    ]
    if not students:
        raise CourseError(f"{path}: {_EXPECTED}; got no rows below the header {names}")
    _refuse_doubles(path, students)
    words = {"\t": "tabs", ";": "semicolons", ",": "commas", "|": "bars"}[separator]
    return Roster(
        [s for _, s in students],
        f"ids from the column {names[columns['id']]!r}, {encoding}, separated by {words}",
    )


_EXPECTED = (
    "expected a CSV file whose first line names the columns, one of them the ids of the students "
    "(as id, username, SIS Login ID, Student ID, Email address), and a line for each student"
)


def _decoded(path):
    """The text of a file and the name of its encoding."""
    with open(path, "rb") as f:
        raw = f.read(MAX_BYTES + 1)
    if len(raw) > MAX_BYTES:
        raise CourseError(f"{path} has more than {MAX_BYTES / 1e6:.0f} MB; is it the roster?")
    if raw[:4] == b"PK\3\4":
        raise CourseError(f"{path} is a spreadsheet; save it as CSV and name that file")
    if raw.startswith((codecs.BOM_UTF16_LE, codecs.BOM_UTF16_BE)):
        tried = (("utf-16", "UTF-16"),)
    elif b"\0" in raw[:100]:  # every other byte of a Latin text
        tried = (("utf-16-le" if raw[1:2] == b"\0" else "utf-16-be", "UTF-16"),)
    else:
        tried = (("utf-8-sig", "UTF-8"), ("cp1252", "Windows-1252"), ("latin-1", "Latin-1"))
    for encoding, name in tried:
        try:
            text = raw.decode(encoding)
        except UnicodeDecodeError:
            continue
        return text.replace("\r\n", "\n").replace("\r", "\n"), name
    raise CourseError(f"{path} cannot be read as text; save it again as 'CSV UTF-8'")


def _fields(line, separator):
    try:
        return next(csv.reader([line], delimiter=separator), [])
    except csv.Error:
        return []


def _rows(path, content, separator):
    """[(number of the line, fields)] without empty rows; an unclosed quotation mark is an error."""
    reader = csv.reader(
        io.StringIO(content), delimiter=separator, strict=True, skipinitialspace=True
    )
    rows, line = [], 1
    try:
        for fields in reader:
            if any("\n" in field for field in fields):
                raise csv.Error(f"a field continues in line {reader.line_num}")
            if any(field.strip() for field in fields):
                rows.append((line, [field.strip() for field in fields]))
            line = reader.line_num + 1
    except csv.Error as error:
        raise CourseError(
            f"{path}, line {line}: {error}; a quotation mark that is never closed takes the "
            "following students with it. Close it, or remove it"
        ) from error
    return rows


def _key(header):
    return re.sub(r"[\W_]+", "", header).casefold()


def _recognised(names):
    known = {name for group in COLUMNS.values() for name in group}
    return [n for n in names if _key(n) in known]


def _columns(path, names, id_column):
    """{field: number of its column}."""
    keys = [_key(n) for n in names]
    columns = {
        what: keys.index(name)
        for what, usual in COLUMNS.items()
        for name in reversed(usual)
        if name in keys
    }
    if id_column is not None:
        if id_column not in names:
            raise CourseError(f"{path} has no column {id_column!r}; it has {names}")
        columns["id"] = names.index(id_column)
    elif "id" in names:  # nbgrader's own format, lower case
        columns["id"] = names.index("id")
    if "id" not in columns:
        raise CourseError(f"{path}: {_EXPECTED}; got the columns {names}")
    if PLATFORM_ID in keys and keys.index(PLATFORM_ID) != columns["id"]:
        columns["lms_user_id"] = keys.index(PLATFORM_ID)
    if "first_name" in columns and "last_name" not in columns and "full_name" in columns:
        columns["last_name"] = columns["full_name"]  # Vorname and Name
    if "first_name" in columns:
        columns.pop("full_name", None)
    return columns


def _student(path, line, row, names, columns):
    """(line, student) of one row."""
    if any(row[len(names) :]):
        raise CourseError(
            f"{path}, line {line}: {len(row)} fields under a header of {len(names)}; put a name "
            f"that holds the separator into quotation marks. Got {row}"
        )
    row = row + [""] * (len(names) - len(row))
    student = {what: row[n] for what, n in columns.items() if row[n]}
    if "full_name" in student:
        student.update(_split_name(student.pop("full_name")))
    if not student.get("id"):
        raise CourseError(f"{path}, line {line}: no id in the column {names[columns['id']]!r}")
    try:
        check_id(student["id"])
    except CourseError as error:
        raise CourseError(f"{path}, line {line}: {error}") from None
    return line, student


def _split_name(name):
    """First and last name of "Doe, Jane" or "Jane Doe"."""
    last, comma, first = name.partition(",")
    if not comma:
        first, _, last = name.rpartition(" ")
    return {k: v.strip() for k, v in (("first_name", first), ("last_name", last)) if v.strip()}


def _refuse_doubles(path, students):
    seen = {}
    for line, student in students:
        earlier = seen.setdefault(seen_as(student["id"]), (line, student["id"]))
        if earlier[0] == line:
            continue
        if earlier[1] == student["id"]:
            raise CourseError(f"{path}, line {line}: the id {student['id']!r} occurs twice")
        raise CourseError(
            f"{path}, line {line}: the id {student['id']!r} differs from {earlier[1]!r} in line "
            f"{earlier[0]} {ONLY_BY}: {TAKEN_FOR_ONE}"
        )
