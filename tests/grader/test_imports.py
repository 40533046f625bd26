"""The folders of the grader import downwards only, in the order in which the docstring of the
package names them.
"""

import ast
import re
from graphlib import TopologicalSorter
from pathlib import Path

import grader

ROOT = Path(grader.__file__).parent
LAYERS = (
    "newton_euler",
    "exercises",
    *re.findall(r"(?m)^    (\w+) ", grader.__doc__),
    "nbgrader_config",
    "__main__",
)
# they run where grader and exercises are not to be imported
COPIED = (
    ROOT / "assignment/fetch.py",
    *sorted((ROOT / "sandbox/cage").glob("*.py")),
)


def name_of(path):
    """The name of a module, relative to the package: ``scoring.score``; of an ``__init__`` the name
    of its folder.
    """
    return ".".join(p for p in path.relative_to(ROOT).with_suffix("").parts if p != "__init__")


MODULES = {name_of(p): p for p in ROOT.rglob("*.py")}


def imports(path):
    """[(module, name or None)] of all imports in a file, also those inside functions; modules of
    the grader relative to the package.
    """
    found = []
    for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
        if isinstance(node, ast.Import):
            found += [(a.name.removeprefix("grader."), None) for a in node.names]
        elif isinstance(node, ast.ImportFrom):
            base = (node.module or "").removeprefix("grader.")
            if node.level:
                parent = path.relative_to(ROOT).parts[: -node.level]
                base = ".".join((*parent, *filter(None, [node.module])))
            found += [
                (f"{base}.{a.name}".strip("."), None)
                if f"{base}.{a.name}".strip(".") in MODULES
                else (base, a.name)
                for a in node.names
            ]
    return found


def layer(module):
    return LAYERS.index(module.partition(".")[0])


def climbing(name, found):
    return [m for m, _ in found if m.partition(".")[0] in LAYERS and layer(m) > layer(name)]


def private(name, found):
    folder = name.partition(".")[0]
    return [
        (m, n)
        for m, n in found
        if n
        and n.startswith("_")
        and m.partition(".")[0] in LAYERS
        and m.partition(".")[0] != folder
    ]


def test_the_docstring_of_the_package_names_every_folder():
    folders = {p.name for p in ROOT.iterdir() if (p / "__init__.py").exists()}
    assert folders <= set(LAYERS)
    assert set(LAYERS) <= {"newton_euler", "exercises"} | folders | set(MODULES)


def test_no_import_climbs():
    assert {n: up for n, p in MODULES.items() if n and (up := climbing(n, imports(p)))} == {}


def test_no_imports_form_a_circle():
    # a folder's __init__ imports its modules, and Python runs it before any of them: within a
    # folder modules import modules
    graph = {
        n: {m for m, _ in imports(p) if m in MODULES and m != n} for n, p in MODULES.items() if n
    }
    order = list(TopologicalSorter(graph).static_order())  # CycleError names a circle
    assert set(order) == {n for n in MODULES if n}


def test_no_private_name_is_taken_from_another_folder():
    assert {n: taken for n, p in MODULES.items() if n and (taken := private(n, imports(p)))} == {}


def test_what_is_copied_or_caged_imports_nothing_of_grader_or_exercises():
    for file in COPIED:
        assert not [
            m
            for m, _ in imports(file)
            if m.partition(".")[0] in {*LAYERS, "grader"} and not m.startswith("sandbox.cage")
        ], file


def test_the_check_sees_what_it_forbids(tmp_path):
    file = tmp_path / "course.py"
    file.write_text(
        "def f():\n    from grader.scoring.score import _score_part\n    from "
        "grader.assignment import notebook\n"
    )
    found = imports(file)
    assert climbing("course", found) == ["scoring.score", "assignment.notebook"]
    assert private("course", found) == [("scoring.score", "_score_part")]
