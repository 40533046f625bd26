"""The folders of the grader, and the files of the website, import downwards only, in the order in
which the docstrings of the packages name them.
"""

import ast
import re
import subprocess
import sys
from pathlib import Path

import pytest

import grader
import website
from tests.imports import circle, imports, modules, taken_privately

ROOT = Path(grader.__file__).parents[1]
FILES = {
    name: path
    for package in ("grader", "website", "exercises", "newton_euler")
    for name, path in modules(ROOT / package).items()
}
OURS = sorted(name for name in FILES if name.split(".")[0] in ("grader", "website"))
BELOW = ("newton_euler", "exercises")
ORDER = (  # lowest first; the website's own list has the highest first
    *BELOW,
    *(f"grader.{name}" for name in re.findall(r"(?m)^    (\w+) ", grader.__doc__)),
    "grader.nbgrader_config",
    "grader.__main__",
    *reversed([f"website.{name}" for name in re.findall(r"(?m)^    (\w+) ", website.__doc__)]),
    "website.__main__",
)
# they run where grader and exercises are not to be imported
ALONE = ("grader.sandbox.cage", "website.browser")
COPIED = ["grader.assignment.fetch", *(n for n in OURS if n.startswith(ALONE))]


def place(module):
    """The part of ORDER to which a module belongs; "" for the packages themselves."""
    package, name = (*module.split("."), "")[:2]
    return package if package in BELOW else f"{package}.{name}" if name else ""


def climbing(module, source=None):
    """The imports of a module from a higher part."""
    found = [target for target, _ in imports(module, FILES, source)]
    return [t for t in found if place(t) and ORDER.index(place(t)) > ORDER.index(place(module))]


def by_text(source):
    """Our modules that a text imports by a name in a string, which no search for imports finds."""
    calls = [node for node in ast.walk(ast.parse(source)) if isinstance(node, ast.Call)]
    named = [c.args[0] for c in calls if ast.unparse(c.func).endswith("import_module") and c.args]
    texts = [a.value for a in named if isinstance(a, ast.Constant)]
    return [text for text in texts if re.match(r"\.|grader|website|exercises", text)]


def test_the_docstrings_name_every_folder_and_file():
    rooms = [*(ROOT / "grader").glob("*/__init__.py"), *(ROOT / "website").glob("*/__init__.py")]
    folders = {".".join(p.parent.relative_to(ROOT).parts) for p in rooms}
    files = {f"website.{p.stem}" for p in (ROOT / "website").glob("[a-z]*.py")}
    assert folders | files | {*BELOW, "grader.nbgrader_config", "grader.__main__",
                              "website.__main__"} == set(ORDER)  # fmt: skip


@pytest.mark.parametrize("module", [m for m in OURS if place(m) in ORDER])
def test_imports_go_down_only_and_take_no_private_name(module):
    assert climbing(module) == []
    assert taken_privately(module, FILES, place) == []
    assert by_text(FILES[module].read_text(encoding="utf-8")) == []


def test_no_files_import_each_other_in_a_circle():
    # a folder's __init__ imports its modules, and Python runs it before any of them: within a
    # folder modules import modules
    assert circle({m: {t for t, _ in imports(m, FILES)} & set(OURS) - {m} for m in OURS}) is None


def test_what_is_copied_or_caged_imports_nothing_of_grader_or_exercises():
    for module in COPIED:
        found = {target for target, _ in imports(module, FILES)}
        assert [t for t in found if not t.startswith(("newton_euler", *ALONE))] == []


def test_the_checks_see_what_they_forbid():
    source = (
        "def f():\n    from grader.scoring.score import _score_part\n"
        "    from grader.assignment import notebook\n    import_module('.run', __package__)\n"
    )
    assert climbing("grader.course.due", source) == [
        "grader.scoring.score", "grader.assignment.notebook",
    ]  # fmt: skip
    assert taken_privately("grader.course.due", FILES, place, source) == [
        "grader.scoring.score._score_part"
    ]
    assert by_text(source) == [".run"]


def test_problems_and_a_course_are_there_without_nbgrader_and_pictures():
    """Their imports take longer than most commands."""
    needed = "grader.__main__, grader.course, exercises.catalogue.sections"
    program = f"import sys, {needed}; print(*sys.modules)"
    done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    heavy = {"nbgrader", "matplotlib", "sympy", "newton_euler.accuracy"}
    assert heavy & set(done.stdout.split()) == set()
