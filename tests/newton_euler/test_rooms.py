"""The rooms of the engine: which may import which, and what a newcomer finds in the listing."""

import ast
import importlib
import inspect
import re
import subprocess
import sys
import tomllib
from collections import defaultdict
from functools import cache
from pathlib import Path

import pytest

import newton_euler
from tests.imports import circle, imports, modules, taken_privately

ENGINE = Path(__file__).parents[2] / "newton_euler"
MECHANICS = ("algebra", "kinematics", "bodies", "dynamics", "applications")
BELOW = {room: set(MECHANICS[:n]) for n, room in enumerate(MECHANICS)} | {
    "motion": {"algebra"},
    "answers": {"algebra"},
    "drawing": {"algebra", "kinematics"},
    "classroom": {"algebra", "answers", "drawing"},
    "scenes": {*MECHANICS, "motion"},
    "accuracy": {*MECHANICS, "motion", "scenes", "classroom"},
}
FILES = modules(ENGINE)
DEFINITIONS = ast.FunctionDef, ast.ClassDef


@cache
def tree_of(module):
    """The syntax tree of a module."""
    return ast.parse(FILES[module].read_text(encoding="utf-8"))


def faulty(check):
    """{module: what the check finds wrong with it}."""
    found = {module: check(module) for module in FILES}
    return {module: wrong for module, wrong in found.items() if wrong}


def room_of(module):
    """The room of a module, "" for the files outside of the rooms."""
    parts = module.split(".")
    return parts[1] if len(parts) > 1 and parts[1] in BELOW else ""


def climbing(module, source=None):
    """The imports of a module that its room may not make."""
    room = room_of(module)
    if not room:
        return []
    allowed = {room, *BELOW[room]}
    found = [target for target, _ in imports(module, FILES, source)]
    return [target for target in found if room_of(target) not in allowed]


def test_the_rooms_are_those_of_the_plan():
    found = {path.name for path in ENGINE.iterdir() if path.is_dir()}
    assert found - {"__pycache__", "chapters"} == set(BELOW)


def test_no_private_name_is_taken_and_imports_go_down_only():
    assert faulty(climbing) == {}
    assert faulty(lambda m: taken_privately(m, FILES, room_of)) == {}


def test_an_import_that_climbs_is_seen():
    found = climbing("newton_euler.algebra.vectors", "from ..kinematics.frames import Frame")
    assert found == ["newton_euler.kinematics.frames"]
    inside = "def f():\n    from newton_euler.scenes import catalogue"
    assert climbing("newton_euler.motion.run", inside) == ["newton_euler.scenes.catalogue"]


def test_neither_modules_nor_folders_import_each_other_in_a_circle():
    whole = {name for name, path in FILES.items() if path.name != "__init__.py"}
    graph = {m: {t for t, _ in imports(m, FILES)} & whole - {m} for m in FILES}
    assert circle(graph) is None
    assert circle({"a": {"b"}, "b": {"c"}, "c": {"b"}}) == ["b", "c"]
    # A folder inside a room is a floor: the files above use it, and it uses none of the files
    found = [(m, target) for m in FILES for target, _ in imports(m, FILES) if target in FILES]
    gathering = {m for m in FILES if FILES[m].name == "__init__.py"}
    assert circle(folder_graph(e for e in found if not gathering & {*e})) is None
    climbing = [("a.run", "a.methods.table"), ("a.methods.verlet", "a.model")]
    assert circle(folder_graph(climbing)) == ["a", "a.methods"]


def folder_graph(edges):
    """{folder: folders that its modules import}, from pairs (module, imported module)."""
    graph = defaultdict(set)
    for module, target in edges:
        above, below = (name.rpartition(".")[0] for name in (module, target))
        graph[above] |= {below} - {above}
    return graph


PACKAGES = [m for m in sorted(FILES) if FILES[m].name == "__init__.py" and "chapters" not in m]
EVERY = [m for m in sorted(FILES) if not m.endswith("__main__")]


@pytest.mark.parametrize(
    "first", [PACKAGES, pytest.param(EVERY, marks=pytest.mark.slow)], ids=["packages", "all"]
)
def test_every_module_can_be_imported_first(first):
    """Each is imported in a fork of a process that has imported none, so no order of imports hides
    an error. A module always comes after its package.
    """
    program = f"""
import os, sys
import matplotlib.figure, mpmath, numpy, scipy.integrate, sympy  # once, and not in every fork
for name in {first!r}:
    if not os.fork():
        try:
            __import__(name)
        except BaseException as error:
            print(name, repr(error), flush=True)
        os._exit(0)
    os.wait()
"""
    command = [sys.executable, "-W", "error", "-c", program]
    done = subprocess.run(command, cwd=ENGINE.parent, capture_output=True, text=True, timeout=600)
    assert (done.stdout, done.stderr) == ("", "")


def public_names(package):
    """The names that the __init__ of a package gives to its users."""
    names = {name for _, name in imports(package, FILES) if name}
    names |= {n.name for n in tree_of(package).body if isinstance(n, DEFINITIONS)}
    if (stub := FILES[package].with_suffix(".pyi")).exists():
        names |= {*re.findall(r"import \w+ as (\w+)", stub.read_text())}
    names -= {"guide", "unknown"}  # they answer for names that the package lacks
    return {n for n in names if not n.startswith("_")}


@pytest.mark.parametrize("package", PACKAGES)
def test_public_names_exist_and_none_is_also_a_module(package):
    loaded = importlib.import_module(package)
    for name in public_names(package):
        assert getattr(loaded, name) is not None
        assert not (FILES[package].parent / f"{name}.py").exists(), f"{name} is a module too"


def test_the_stub_names_what_the_top_gives_and_from_where():
    stub = (ENGINE / "__init__.pyi").read_text(encoding="utf-8")
    lines = re.findall(r"from \.(\w+) import (?:\w+) as (\w+)", stub)
    written = {name: room for room, name in lines[: len(newton_euler.__all__)]}
    assert written == newton_euler._ROOM_OF
    assert sorted(written) == newton_euler.__all__


def test_a_name_that_is_not_at_the_top_is_looked_for_in_the_rooms():
    words = r"no 'frenet_along': write from newton_euler\.kinematics import"
    with pytest.raises(AttributeError, match=words):
        _ = newton_euler.frenet_along
    assert newton_euler.kinematics.frenet_along.__name__ == "frenet_along"
    assert {"Frame", "dynamics"} <= set(dir(newton_euler))


def test_the_wheel_takes_every_folder_with_code_and_nothing_beside_the_engine():
    """Setuptools finds packages by their __init__.py; newton_euler/chapters is a link to chapters."""
    pyproject = tomllib.loads((ENGINE.parent / "pyproject.toml").read_text(encoding="utf-8"))
    found = pyproject["tool"]["setuptools"]["packages"]["find"]
    assert found == {"namespaces": False, "include": ["newton_euler*"]}
    for folder in {*(path.parent for path in FILES.values()), ENGINE / "chapters" / "figures"}:
        assert (folder / "__init__.py").exists(), folder
    assert not list((ENGINE / "chapters" / "instructors").glob("*.py"))


def test_all_errors_of_the_engine_have_one_base():
    classes = [(m, x.name) for m in FILES for x in tree_of(m).body if isinstance(x, ast.ClassDef)]
    named = [(m, name) for m, name in classes if name.endswith("Error")]
    errors = [getattr(importlib.import_module(module), name) for module, name in named]
    assert len(errors) > 20
    assert [e for e in errors if not issubclass(e, newton_euler.NewtonEulerError)] == []


def shown(body):
    """The public functions and classes that a body defines."""
    return [n for n in body if isinstance(n, DEFINITIONS) and n.name[0] != "_"]


def bare(module):
    """The public functions, classes and methods without a docstring, of their own or inherited;
    answers override documented ones. What a Protocol asks for is documented where it is made.
    """
    public = shown(tree_of(module).body)
    found = [n.name for n in public if not ast.get_docstring(n)]
    classes = [n for n in public if isinstance(n, ast.ClassDef) and room_of(module) != "answers"]
    for block in (b for b in classes if "Protocol" not in map(ast.unparse, b.bases)):
        owner = getattr(importlib.import_module(module), block.name)
        found += [n.name for n in shown(block.body) if not inspect.getdoc(getattr(owner, n.name))]
    return found


def test_public_functions_classes_and_methods_have_docstrings():
    assert faulty(bare) == {}


HEAVY = "sympy scipy matplotlib.pyplot matplotlib heyoka mpmath numpy symengine numba IPython PIL"
A_FIGURE = """import io
from matplotlib.figure import Figure; from newton_euler import Frame, drawing
s = drawing.Sketch(Figure().add_subplot(), Frame('ground')); s.rod((0, 0, 0), (1, 2, 3)); s.label((0, 0, 0), 'O')
s.ax.figure.savefig(io.BytesIO())"""


@pytest.mark.parametrize(("program", "needed"), [
    ("import newton_euler, newton_euler.drawing.animation, newton_euler.drawing.sketch", ""),
    ("from newton_euler.motion import integrate; from tests.models import oscillator; "
     "assert integrate(oscillator(), 1.0, (1.0, 0.0)).error < 1e-9", ""),
    ("import numpy as np; from newton_euler import *; f = compiled(lambda w: "
     "Frame('g').rotate('a', 'z', rate=w).i.norm()); f(1.0); f(np.zeros(5))", "numpy"),
    (A_FIGURE, "matplotlib numpy PIL"),
], ids=["importing the engine", "a motion", "floats, arrays and tracing", "a figure"])  # fmt: skip
def test_none_of_the_heavy_libraries_is_loaded_before_it_is_needed(program, needed):
    """Students wait while the imports run."""
    program = f"import sys\n{program}\nprint(*(m for m in {HEAVY.split()} if m in sys.modules))"
    out = subprocess.run(
        [sys.executable, "-c", program], capture_output=True, text=True, check=True
    )
    assert out.stdout.strip() == needed


def test_notebooks_released_before_the_rooms_still_find_expect_and_receipt():
    """Their locked setup cell says: from newton_euler.answers import expect, receipt."""
    today = importlib.import_module("newton_euler.classroom")
    for before in ("newton_euler.answers", "newton_euler.classroom.answers"):
        module = importlib.import_module(before)
        assert (module.expect, module.receipt) == (today.expect, today.receipt)
