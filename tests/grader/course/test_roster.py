"""Rosters as registrars and learning platforms export them."""

import pytest

from grader.course import CourseError, read_roster
from tests.grader.courses import command, refused

ADA = {"id": "ada", "first_name": "Ada", "last_name": "Lovelace", "email": "ada@uni.edu"}
ZOE = {"id": "zoe", "first_name": "Zoë", "last_name": "Müller", "email": "zoe@uni.edu"}
PLAIN = "id,first_name,last_name,email\nada,Ada,Lovelace,ada@uni.edu\nzoe,Zoë,Müller,zoe@uni.edu\n"
CANVAS = (
    "Student,ID,SIS User ID,SIS Login ID,Section,ch04 (815)\n"
    '"    Points Possible",,,,,11\n'
    '"Lovelace, Ada",4711,s1,ada,M 1,\n'
    '"Müller, Zoë",4712,s2,zoe,M 1,3\n'
    '"Student, Test",4713,,8a7f,M 1,\n'
)
MOODLE = (
    "First name,Surname,ID number,Email address,Groups\n"
    'Ada,Lovelace,ada,ada@uni.edu,"A, B"\n'
    "Zoë,Müller,zoe,zoe@uni.edu,\n"
)
MOODLE_GERMAN = (
    "Vorname;Nachname;Matrikelnummer;E-Mail-Adresse\n"
    "Ada;Lovelace;ada;ada@uni.edu\n"
    "Zoë;Müller;zoe;zoe@uni.edu\n"
)
GRADESCOPE = (
    "First Name,Last Name,SID,Email,Role\n"
    "Ada,Lovelace,ada,ada@uni.edu,Student\n"
    "Zoë,Müller,zoe,zoe@uni.edu,Student\n"
)
REGISTRAR = (
    "Name\tStudent ID\tE-mail\nAda Lovelace\tada\tada@uni.edu\nMüller, Zoë\tzoe\tzoe@uni.edu\n\n"
)
SPREADSHEET = "sep=;\n" + MOODLE_GERMAN.replace("\n", "\r\n")
FRENCH = (
    "Nom;Prénom;Numéro étudiant;Courriel\r"
    "Lovelace;Ada;ada;ada@uni.edu\rMüller;Zoë;zoe;zoe@uni.edu\r"
)
DIALECTS = {
    "nbgrader": PLAIN, "Canvas": CANVAS, "Moodle": MOODLE, "Moodle in German": MOODLE_GERMAN,
    "Gradescope": GRADESCOPE, "a registrar, tabs": REGISTRAR, "a spreadsheet": SPREADSHEET,
    "French, old Macintosh lines": FRENCH,
}  # fmt: skip
ENCODINGS = ("utf-8", "utf-8-sig", "utf-16", "utf-16-le", "utf-16-be", "cp1252", "latin-1")


@pytest.mark.parametrize("encoding", ENCODINGS)
@pytest.mark.parametrize("dialect", DIALECTS)
def test_every_dialect_in_every_encoding_gives_the_same_students(tmp_path, dialect, encoding):
    path = tmp_path / "roster.csv"
    path.write_bytes(DIALECTS[dialect].encode(encoding))
    found = read_roster(path).students
    platform = [s.pop("lms_user_id", None) for s in found]
    if dialect == "Canvas":  # has no addresses
        expected = [{k: v for k, v in s.items() if k != "email"} for s in (ADA, ZOE)]
        assert platform == ["4711", "4712"]
    else:
        expected = [ADA, ZOE]
    assert found == expected


def test_how_a_roster_was_read_is_reported_and_a_spreadsheet_refused(tmp_path):
    path = tmp_path / "roster.csv"
    path.write_bytes(MOODLE_GERMAN.encode("cp1252"))
    assert read_roster(path).read_as == (
        "ids from the column 'Matrikelnummer', Windows-1252, separated by semicolons"
    )
    path.write_text(MOODLE)
    assert read_roster(path, "Email address").students[0]["id"] == "ada@uni.edu"
    with pytest.raises(CourseError, match=r"has no column 'Login'; it has \['First name'"):
        read_roster(path, "Login")
    path = tmp_path / "roster.csv"
    path.write_text("Name,Email\nAda Lovelace,ada@uni.edu\n")
    assert read_roster(path).students == [
        {"id": "ada@uni.edu", "first_name": "Ada", "last_name": "Lovelace", "email": "ada@uni.edu"}
    ]
    (tmp_path / "r.xlsx").write_bytes(b"PK\3\4 and so on")
    with pytest.raises(CourseError, match="is a spreadsheet; save it as CSV and name that file"):
        read_roster(tmp_path / "r.xlsx")


WRONG = {
    "no id": ("colour,shape\nred,round\n", r"expected a CSV file whose first .*got the columns \['colour', 'shape'\]"),
    "empty": ("", "got no rows"),
    "only a header": ("id,first_name\n", r"got no rows below the header \['id', 'first_name'\]"),
    "a blank id": ("id,first_name\nada,Ada\n,Ben\n", "line 3: no id in the column 'id'"),
    "twice": ("id\nada\nada\n", "line 3: the id 'ada' occurs twice"),
    "case only": ("id\nada\nben\nAda\n", "line 4: the id 'Ada' differs from 'ada' in line 2 only by"),
    "encoding only": ("id\nm\u00fcller\nmu\u0308ller\n", "line 3: .* how a letter is encoded:"),
    "a dot at the end": ("id\nada\nada.\n", "line 3: the id .ada.. differs from .ada. in line 2 only by"),
    "two spaces": ("id\na b\na  b\n", "in line 2 only by .* spaces, .*: in a list they are taken for one"),
    "a slash": ("id\na/b\n", r"line 2: 'a/b' cannot be a student id: folders are named by it"),
    "a plus": ("id\na+b\n", r"nbgrader splits names at '\+'"),
    "dots": ("id\n..\n", "cannot be a student id"),
    "an open quotation mark": (
        'id,first_name\nada,"Ada\nben,Ben\n',
        "line 2: unexpected end of data; a quotation mark that is never closed takes the",
    ),
    "a quotation mark that closes in another line": (
        'id,first_name\nada,"Ada\nben,Ben"\ncleo,Cleo\n',
        "line 2: a field continues in line 3; a quotation mark that is never closed",
    ),
    "a quotation mark that meets another": (
        'id,first_name\nzoe,Zoe\nada,"Ada\nben,"Ben"\n',
        "line 3: .* a quotation mark that is never closed",
    ),
    "a name with a comma": (
        "id,name,email\nada,Lovelace, Ada,ada@uni.edu\n",
        "line 2: 4 fields under a header of 3; put a name that holds the separator into quotation",
    ),
}  # fmt: skip


@pytest.mark.parametrize("how", WRONG)
def test_a_roster_that_cannot_be_used_is_reported_and_no_course_is_made(tmp_path, how):
    path = tmp_path / "roster.csv"
    path.write_text(WRONG[how][0])
    with pytest.raises(CourseError, match=WRONG[how][1]):
        read_roster(path)
    course = "--course", tmp_path / "c"
    refused(command("build", "ch04", *course, "--students", path, "--problem", "4/1"))
    assert not (tmp_path / "c").exists()
