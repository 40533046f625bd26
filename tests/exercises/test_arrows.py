"""Who imports whom in exercises: the catalogue knows no problem, a device no chapter, a chapter no
other chapter.
"""

import ast
import re

from exercises.catalogue.places import EXERCISES
from tests.imports import circle, imports, modules

FILES = modules(EXERCISES)
# chapters are above
FLOORS = "exercises.catalogue", "exercises.annotations", "exercises.tools", "exercises.devices"


def floor(module):
    """The layer of a module: the catalogue is 0, the chapters are the highest."""
    below = (n for n, name in enumerate(FLOORS) if f"{module}.".startswith(f"{name}."))
    return next(below, len(FLOORS))


def climbing(module, source=None):
    """The imports of a module from a higher floor, or from another chapter."""
    targets = [target for target, _ in imports(module, FILES, source)]
    beside = lambda t: floor(t) == floor(module) == len(FLOORS) and t != module
    return [t for t in targets if floor(t) > floor(module) or beside(t)]


def test_imports_go_down_only():
    up = {module: climbing(module) for module in FILES.keys() - {"exercises"}}
    assert {module: targets for module, targets in up.items() if targets} == {}


def test_an_import_that_climbs_is_seen():
    to_a_device = "from ..devices import crane"
    assert climbing("exercises.catalogue.steps", to_a_device) == ["exercises.devices.crane"]
    to_a_problem = "def f():\n    from exercises.ch04 import p16"
    assert climbing("exercises.devices.crane", to_a_problem) == ["exercises.ch04.p16"]
    assert climbing("exercises.ch04.p17", to_a_problem) == ["exercises.ch04.p16"]
    assert climbing("exercises.ch04.p17", to_a_device.replace("..", "exercises.")) == []


def test_no_modules_import_each_other_in_a_circle():
    """Through a package's __init__ too: a file of the catalogue imports the module that it needs."""
    graph = {m: {t for t, _ in imports(m, FILES) if t in FILES and t != m} for m in FILES}
    assert circle(graph) is None


def test_every_device_is_used_by_a_problem_or_another_device():
    used = {target for m in FILES for target, _ in imports(m, FILES) if target != m}
    assert {m for m in FILES if m.startswith("exercises.devices.")} <= used


def unused(path):
    """The names that a module imports from devices and does not use."""
    tree = ast.parse(path.read_text())
    found = [n for n in ast.walk(tree) if isinstance(n, ast.ImportFrom)]
    names = {a.asname or a.name for n in found if "devices" in (n.module or "") for a in n.names}
    return names - {n.id for n in ast.walk(tree) if isinstance(n, ast.Name)}


def test_what_a_problem_only_imports_is_a_function_of_its_own():
    """From a device, where ruff lets an unused import pass."""
    own = {"solve", "steps", "prove", "mistakes", "draw", "follows"}
    left = {
        m: unused(path) - (own if re.search(r"\.p\d+$", m) else set()) for m, path in FILES.items()
    }
    assert {m: names for m, names in left.items() if names} == {}
