"""Devices belong to no chapter, and chapters share nothing but devices."""

import ast

import pytest

from exercises.catalogue import chapters, reading

MODULES = {
    path.relative_to(reading.EXERCISES).as_posix(): path for path in reading.EXERCISES.rglob("*.py")
}


def imported(path):
    """The modules of exercises that a file imports: "devices.crane"."""
    nodes = list(ast.walk(ast.parse(path.read_text(encoding="utf-8"))))
    names = [a.name for node in nodes if isinstance(node, ast.Import) for a in node.names]
    names += [
        f"{node.module}.{a.name}"
        for node in nodes
        if isinstance(node, ast.ImportFrom) and not node.level
        for a in node.names
    ]
    return {name.partition(".")[2] for name in names if name.startswith("exercises.")}


@pytest.mark.parametrize(
    "name", [name for name in MODULES if name.startswith(("devices/", *chapters()))]
)
def test_a_device_or_a_problem_imports_no_chapter(name):
    assert not [module for module in imported(MODULES[name]) if module.startswith(chapters())]


def test_every_device_is_used_by_a_problem_or_another_device():
    used = {
        ".".join(module.split(".")[:2]) for path in MODULES.values() for module in imported(path)
    }
    assert {
        f"devices.{path.stem}" for name, path in MODULES.items() if name.startswith("devices/")
    } - {"devices.__init__"} <= used
