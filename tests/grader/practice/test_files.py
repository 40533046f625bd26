"""Practice files that are damaged, or made to do harm."""

import copy
import json
import random
import re
import subprocess
import sys
import zipfile

import pytest

from newton_euler import NewtonEulerError
from newton_euler.classroom import PracticeFileError, practice
from tests.grader.courses import environment

MEMBER = "4-16.json"


@pytest.fixture(scope="module")
def whole(hints_file):
    """{member: bytes} of a sound file."""
    with zipfile.ZipFile(hints_file) as archive:
        return {n: archive.read(n) for n in archive.namelist()}


def written(path, members):
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED, compresslevel=1) as archive:
        for name, content in members.items():
            archive.writestr(name, content)
    return path


def everything(path):
    """Walk through a problem as a student does."""
    problems = practice(path, progress=None)
    assert repr(problems)
    p = problems["4/16"]
    for _ in range(2):
        for part in (p, p.next_step(), p.next_step(), p.next_step(), p.solution(), p.figure):
            assert part is None or repr(part)
        for check, names in ((p.check_step, p.steps), (p.check, p.answers)):
            for value in ([1.0, 2.0, 3.0], 1.0):
                repr(check(**dict.fromkeys(names, value)))
        p.new()


BAD = (None, "", "\x07", [], {}, [[]], -1, 10**400, 1e999, True, "x", ["x"], {"x": 1}, [1, 2, 3])


def spots(x, path=()):
    """The paths of everything that a JSON text holds."""
    yield path
    inner = x.items() if isinstance(x, dict) else enumerate(x) if isinstance(x, list) else ()
    for name, part in inner:
        yield from spots(part, (*path, name))


def changed(data, path, bad):
    """The same with one part replaced; removed where the bad value is a deletion."""
    data = copy.deepcopy(data)
    at = data
    for name in path[:-1]:
        at = at[name]
    if bad is KeyError:
        del at[path[-1]]
    else:
        at[path[-1]] = bad
    return data


@pytest.mark.parametrize("member", ["practice.json", pytest.param(MEMBER, marks=pytest.mark.slow)])
def test_whatever_part_of_a_file_is_broken_is_refused_in_words(whole, tmp_path, member):
    data, rng = json.loads(whole[member]), random.Random(1)
    places = [path for path in spots(data) if path]
    by_kind = {tuple(n for n in path if isinstance(n, str)): path for path in places}
    refused = 0
    for path in {*by_kind.values(), *rng.sample(places, min(10, len(places)))}:
        for bad in rng.sample((*BAD, KeyError), 2):
            made = json.dumps(changed(data, path, bad))
            made = written(tmp_path / "p", {**whole, member: made})
            try:
                everything(made)
            except NewtonEulerError as error:
                refused += bool(str(error))
    assert refused > len(by_kind) / 2


@pytest.mark.parametrize("content", [
    b"", b"[", b"{}", b"null", b"[" * 10**5, b"\xff", b"9" * 5000, b'{"format": 2}',
    *(b"[" * n + b"]" * n for n in (50, 400, 700)), b'{"a":' * 600 + b"1" + b"}" * 600,
])  # fmt: skip
@pytest.mark.parametrize("member", ["practice.json", MEMBER])
def test_what_is_not_a_page_is_refused(whole, tmp_path, member, content):
    with pytest.raises(PracticeFileError):
        everything(written(tmp_path / "p", {**whole, member: content}))


@pytest.mark.parametrize(("number", "missing"), [(6, 0), (5, 2), (4, 3)])
def test_files_of_earlier_formats_are_read(whole, tmp_path, number, missing):
    head, page = json.loads(whole["practice.json"]), json.loads(whole[MEMBER])
    assert any(row[-2] for row in page["slips"])  # what a slip does
    for name in ("labels", "slips") if missing else ():
        page[name] = [row[:-missing] for row in page[name]]
    made = {"practice.json": json.dumps(head | {"format": number}), MEMBER: json.dumps(page)}
    everything(written(tmp_path / "p", whole | made))


def test_a_slip_of_unknown_effect_and_a_text_without_breaks_are_refused(whole, tmp_path):
    page = json.loads(whole[MEMBER])
    page["slips"][0][-2] = "burns"
    with pytest.raises(PracticeFileError, match="damaged"):
        everything(written(tmp_path / "p", whole | {MEMBER: json.dumps(page)}))
    page = json.loads(whole[MEMBER])
    page["variants"][0]["text"] = "a" * 4_000_000
    with pytest.raises(PracticeFileError, match="has a text of 4000000 characters"):
        everything(written(tmp_path / "p", whole | {MEMBER: json.dumps(page)}))


def test_a_damaged_archive_is_refused(whole, tmp_path):
    path = written(tmp_path / "p", whole)
    raw, rng, refused = path.read_bytes(), random.Random(2), 0
    for _ in range(60):
        n = rng.randrange(len(raw))
        path.write_bytes(raw[:n] + (rng.random() >= 0.3) * (b"\xff\x00\xee" + raw[n + 3 :]))
        try:
            everything(path)
        except PracticeFileError as error:
            refused += bool(str(error))
    assert refused > 40  # the rest is in bytes of the archive that carry nothing


@pytest.mark.parametrize("code", ["\x1b[31m", "\x07", "\x9b2J", "\u202e", "\r"])
@pytest.mark.parametrize("place", ["title", "text", "help", "problems", "format"])
def test_codes_for_a_terminal_are_not_written_to_it(whole, tmp_path, capsys, place, code):
    head, page = json.loads(whole["practice.json"]), json.loads(whole[MEMBER])
    if place == "title":
        head["titles"]["4/16"][0] += code
    elif place == "text":
        page["variants"][0]["text"] += code
    else:
        head[place] = [code] if place == "problems" else code
    made = {"practice.json": json.dumps(head), MEMBER: json.dumps(page)}
    with pytest.raises(PracticeFileError) as refused:
        everything(written(tmp_path / "p", whole | made))
    assert code not in str(refused.value)


def test_no_text_of_a_file_is_html_in_a_notebook(whole, tmp_path):
    html = "<img src=x onerror=alert(1)><!-- $a<b$ </p>![seen](https://example.org/x.png)"
    page = json.loads(whole[MEMBER])
    head = json.loads(whole["practice.json"])
    head["titles"]["4/16"][0] = page["variants"][0]["statement"] = html
    page["variants"][0]["solution"] = page["quantities"][0]["means"] = html
    made = {"practice.json": json.dumps(head), MEMBER: json.dumps(page | {"preamble": html})}
    problems = practice(written(tmp_path / "p", whole | made), progress=None)
    p = problems["4/16"]
    for shown in (problems, p, p.next_step(), p.next_step()):
        assert "< img" in (text := shown._repr_markdown_()) or "img" not in text
        assert not re.search(r"<[a-z/!]|!\[", text)


BOMB = """
import resource, sys
from newton_euler.classroom import PracticeFileError, practice
resource.setrlimit(resource.RLIMIT_AS, (1 << 30,) * 2)
try:
    practice(sys.argv[1], progress=None)["4/16"]
except PracticeFileError as error:
    print(error)
"""


@pytest.mark.one_in(2)
@pytest.mark.parametrize(("part", "times", "method", "words"), [
    (" " * 10**6, 1100, zipfile.ZIP_DEFLATED, "4-16.json has more than 8 MB"),
    ("[]," * 1000, 2000, zipfile.ZIP_DEFLATED, "is damaged"),
    (" " * 10**6, 110, zipfile.ZIP_BZIP2, "compressed by a method that is not used here"),
    (" " * 10**6, 110, zipfile.ZIP_LZMA, "compressed by a method that is not used here"),
], ids=["a long text", "many lists", "bzip2", "lzma"])  # fmt: skip
def test_a_bomb_takes_less_than_a_gigabyte(whole, tmp_path, part, times, method, words):
    path = written(tmp_path / "p", {n: x for n, x in whole.items() if n != MEMBER})
    archive = zipfile.ZipFile(path, "a", method)
    with archive, archive.open(MEMBER, "w") as member:
        member.write(b"[")
        for _ in range(times):
            member.write(part.encode())
        member.write(b"0]")
    assert path.stat().st_size < 3e6
    done = subprocess.run([sys.executable, "-c", BOMB, path], env=environment(), timeout=60,
                          capture_output=True, text=True, check=False)  # fmt: skip
    assert (done.returncode, done.stderr) == (0, "")
    assert words in done.stdout
