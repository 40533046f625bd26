"""The engine's own order: what every module of newton_euler must obey."""

import ast
import subprocess
import sys
from collections import Counter
from pathlib import Path

import pytest

ENGINE = Path(__file__).parents[2] / "newton_euler"
MODULES = [str(path.relative_to(ENGINE)) for path in sorted(ENGINE.rglob("*.py"))]


def defined(statement):
    """The names that a statement at the top of a module defines; an item of a dictionary, as ``EQUATIONS[...] = ...``, is none."""
    if isinstance(statement, (ast.FunctionDef, ast.ClassDef)):
        return [statement.name]
    targets = statement.targets if isinstance(statement, ast.Assign) else []
    return [name.id for target in targets for name in getattr(target, "elts", [target]) if isinstance(name, ast.Name)]


@pytest.mark.parametrize("module", MODULES)
def test_no_module_defines_a_name_twice(module):
    body = ast.parse((ENGINE / module).read_text(encoding="utf-8")).body
    assert [name for name, count in Counter(n for s in body for n in defined(s)).items() if count > 1] == []


def test_scenes_are_loaded_when_one_is_asked_for():
    program = """if True:
        import sys
        import newton_euler, newton_euler.scenes
        from newton_euler import Ladder, Model, ladder, smallest
        print([name for name in sys.modules if name.startswith("newton_euler.scenes.")])
        ladder("top")
        print("newton_euler.scenes.spatial.top" in sys.modules)
    """
    told = subprocess.run([sys.executable, "-c", program], cwd=ENGINE.parent, check=True, capture_output=True, text=True).stdout
    assert told.splitlines() == ["['newton_euler.scenes.catalogue']", "True"]
