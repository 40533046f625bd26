"""Practice as a page calls it: JSON in and out, without NumPy, Matplotlib and SymPy."""

import json
import subprocess
import sys
import zipfile
from base64 import b64encode

import pytest

from exercises.catalogue import problem
from grader.practice.build import page_of, svg
from tests.grader.courses import environment
from website.browser import answer, practice

SECRETS = "__import__('os').system('x')", "9**9**9**9", "(" * 400, "1+" * 400
SECRETS += "b" * 10**5, "[" * 250


def call(function, **arguments):
    return json.loads(answer(f"practice.{function}", json.dumps(arguments)))


@pytest.fixture(scope="module")
def opened(practice_file):
    """The problems of a file that a page has passed in."""
    return call("load", name="some", data=b64encode(practice_file.read_bytes()).decode())["value"]


@pytest.fixture
def apart(monkeypatch):
    """Files that a test opens are no longer open in the next."""
    monkeypatch.setattr(practice, "_books", {})


def shown(number, **more):
    return call("show", problem=number, **more)["value"]


def test_a_problem_has_a_field_for_each_component_and_other_numbers_when_asked(opened):
    assert [*opened] == ["4/1", "4/2", "4/16", "2/18", "5/16", "8/8"]
    first, second = shown("4/16"), shown("4/16", new=True)
    assert [len(q["parts"]) for q in first["answers"]] == [3, 3, 3]
    assert {q["key"] for q in first["steps"]} >= {"omega_CD", "v_r"}
    assert (first["number"], second["number"], first["sets"]) == (1, 2, 3)
    assert first["names"] != second["names"]
    assert first["figure"].startswith("data:image/png;base64,")
    for _ in range(2):
        shown("4/16", new=True)
    assert shown("4/16")["names"] == first["names"]
    assert "error" in call("show", problem="9/99")


def test_wrong_answers_are_named_and_progress_is_handed_back(opened):
    while shown("4/16")["number"] != 1:
        shown("4/16", new=True)
    fields = {"a_D": ["0", "-7.38", "-2.80592"], "omega_CD": ["-b_dot", "0", "omega"]}
    fields["v_D"] = ["1", "", ""]
    found = call("check", problem="4/16", fields=fields)["value"]
    verdicts = {key: x["verdict"] for key, x in found["found"].items()}
    assert verdicts == {"a_D": "wrong", "omega_CD": "right", "v_D": "unreadable"}
    assert "leaves out the Coriolis term" in found["found"]["a_D"]["text"]
    assert "second component" in found["found"]["v_D"]["text"]
    kept = json.loads(found["kept"])["problems"]["4/16"]["0"]
    assert kept["a_D"]["cause"][:2] == ["listed", "no_coriolis"]
    titles = {p: ["", "4.10"] for p in opened}
    assert call("advice", titles=titles)["value"]["problem"] == "4/16"
    for help in ("hint", "solution"):
        assert "kept" in call(help, problem="4/16")["value"]
    assert call("advice", titles=titles, now="4/16")["value"]["problem"] != "4/16"
    assert call("take_in", progress=found["kept"])["value"]
    assert "cannot be read" in call("take_in", progress="{}")["error"]


def test_what_is_typed_is_shown_as_it_is_read(opened):
    read = lambda *texts: call("read", problem="4/16", key="a_D", texts=texts)["value"]
    number = shown("4/16")["names"]["omega"]
    assert read("-2*omega*b", "0", "1/2")["latex"].startswith(
        r"\left[{-2 \omega b},\ 0,\ \frac{1}{2}\right] = "
    )
    assert read("[1, 2, 3]", "", "")["latex"] == r"\left[1,\ 2,\ 3\right]\ \text{mm/s}^2"
    assert read("", "", "") == {"latex": "", "fault": ""}
    assert f"{number:g}" in read("omega", "0", "0")["latex"]
    assert "given name" in read("speed", "0", "0")["fault"]
    for text in ("-2,5", "−2,5", "1,234.5"):
        assert "write a decimal point" in read(text, "0", "0")["fault"]
    assert "too large" in read("1e999", "0", "0")["fault"]


@pytest.mark.parametrize("text", SECRETS, ids=range(len(SECRETS)))
def test_what_is_not_a_formula_is_refused_in_words(opened, text):
    found = call("read", problem="4/16", key="a_D", texts=[text, "0", "0"])["value"]
    assert found["latex"] == ""
    assert 0 < len(found["fault"]) < 300
    checked = call("check", problem="4/16", fields={"a_D": [text, "0", "0"]})["value"]
    assert checked["found"]["a_D"]["verdict"] == "unreadable"


def rewritten(sound, path, change=lambda page: None, **members):
    """A practice file as one of 4/16 alone, its page changed by a function, with other members."""
    with zipfile.ZipFile(sound) as archive, zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as out:
        head, page = (json.loads(archive.read(f"{n}.json")) for n in ("practice", "4-16"))
        change(page)
        files = {"practice.json": json.dumps(head | {"problems": ["4/16"]}),
                 "4-16.json": json.dumps(page), **members}  # fmt: skip
        for name, content in files.items():
            out.writestr(name, content)
    return path


def refusal(data):
    """Why a file, or its problem 4/16, is refused."""
    found = call("load", name="x", data=b64encode(data).decode())
    return found.get("error") or call("show", problem="4/16")["error"]


@pytest.mark.parametrize(
    "data", [b"", b"import os\nos.abort()", b"\x80\x04\x95\x00cos\nabort\n(tR."]
)
def test_files_that_are_not_practice_files_are_refused_in_words(data):
    assert refusal(data).startswith("x is not a practice file")  # as the reader calls it


LONG, DEEP = b" " * 2**25, b"[" * 700 + b"]" * 700


@pytest.mark.parametrize(("members", "words"), [
    ({"practice.json": LONG}, "practice.json has more than 8 MB"),
    ({"4-16.json": LONG}, "4-16.json has more than 8 MB"),
    ({"practice.json": DEEP}, "is not a practice file"),
    ({"4-16.json": DEEP}, "is not a practice file"),
])  # fmt: skip
def test_a_practice_file_that_is_a_bomb_is_refused(practice_file, tmp_path, members, words, apart):
    assert words in refusal(rewritten(practice_file, tmp_path / "x", **members).read_bytes())


@pytest.mark.parametrize("first", [("+", [0], 1.0), ("neg", [5]), ("__import__", "os")])
def test_a_program_that_refers_to_itself_or_calls_is_refused(practice_file, tmp_path, first, apart):
    def change(page):
        page["variants"][0]["program"]["operations"][0] = first

    data = rewritten(practice_file, tmp_path / "x", change).read_bytes()
    assert "problem 4/16 cannot be read" in refusal(data)


HIDDEN = """
import json, sys
from base64 import b64encode
for name in ("numpy", "scipy", "matplotlib", "sympy", "mpmath", "click", "IPython", "ipywidgets"):
    sys.modules[name] = None
from website.browser import answer
def call(function, **arguments):
    found = json.loads(answer(f"practice.{function}", json.dumps(arguments)))
    assert "error" not in found, (function, arguments, found)
    return found["value"]
with open(sys.argv[1], "rb") as file:
    data = b64encode(file.read()).decode()
for number in call("load", name="x", data=data):
    for new in (False, True):
        p = call("show", problem=number, new=new)
        for q in p["answers"] + p["steps"]:
            for value in ("1.5", "-2e3"):
                texts = [value] * len(q["parts"])
                call("check", problem=number, fields={q["key"]: texts})
                call("read", problem=number, key=q["key"], texts=texts)
        call("hint", problem=number), call("solution", problem=number)
print("done")
"""


def test_all_of_it_works_where_there_is_no_numpy(practice_file):
    done = subprocess.run(
        [sys.executable, "-c", HIDDEN, practice_file],
        env=environment(), capture_output=True, text=True, timeout=300, check=False,
    )  # fmt: skip
    assert (done.stdout, done.stderr) == ("done\n", "")


@pytest.mark.parametrize("number", ["4/2", "4/16", "7/14", "11/6", "A/19"])
def test_public_sets_hold_the_answers_of_their_own_numbers_and_no_code(number):
    page, figures = page_of(number, 3, "solution", draw=svg)
    text = json.dumps(page)
    assert all(name.endswith(".svg") and b"<script" not in x for name, x in figures.items())
    p = problem(number)
    assert not any(sign in text for sign in ("def ", "lambda", "import ", p.code.__name__))
    for v in page["variants"]:
        for step in (v["program"] or {"operations": []})["operations"]:
            assert all(isinstance(a, (float, int, list)) for a in step[1:]), step
