"""What modules import, read from their text: for tests of who may import whom."""

import ast
import re
from collections.abc import Callable
from functools import cache
from pathlib import Path


def modules(folder: Path) -> dict[str, Path]:
    """{module: its file} of the package in ``folder``: "exercises.catalogue.steps"."""
    names = {p: p.relative_to(folder.parent).with_suffix("").parts for p in folder.rglob("*.py")}
    return {".".join(parts).removesuffix(".__init__"): p for p, parts in names.items()}


def imports(
    module: str, files: dict[str, Path], source: str | None = None
) -> list[tuple[str, str | None]]:
    """[(module, name or None)] that a module imports anywhere; ``source`` for its text."""
    path = files[module]
    parts = [*module.split("."), *(["__init__"] if path.name == "__init__.py" else [])]
    tops = {name.split(".")[0] for name in files}
    found: list[tuple[str, str | None]] = []
    for node in _import_statements(source or path.read_text(encoding="utf-8")):
        if isinstance(node, ast.Import):
            found += [(a.name, None) for a in node.names]
        elif isinstance(node, ast.ImportFrom):
            base = parts[: len(parts) - node.level] if node.level else []
            target = ".".join([*base, *([node.module] if node.module else [])])
            named = [(f"{target}.{a.name}", target, a.name) for a in node.names]
            found += [(full, None) if full in files else (of, name) for full, of, name in named]
    return [(target, name) for target, name in found if target.split(".")[0] in tops]


@cache  # for the tests ask each module several times
def _import_statements(source: str) -> list[ast.Import | ast.ImportFrom]:
    return [n for n in ast.walk(ast.parse(source)) if isinstance(n, ast.Import | ast.ImportFrom)]


def taken_privately(
    module: str, files: dict[str, Path], room_of: Callable[[str], str], source: str | None = None
) -> list[str]:
    """The private names that a module takes from another room."""
    return [
        f"{target}.{name}"
        for target, name in imports(module, files, source)
        if name and re.match("_[^_]", name) and room_of(target) != room_of(module)
    ]


def circle(graph: dict[str, set[str]]) -> list[str] | None:
    """A list of nodes that lead to each other in a circle, or None."""
    done: set[str] = set()
    trail: list[str] = []

    def visit(node: str) -> list[str] | None:
        if node in trail:
            return trail[trail.index(node) :]
        if node in done:
            return None
        trail.append(node)
        found = next((c for c in map(visit, sorted(graph.get(node, ()))) if c), None)
        trail.pop()
        done.add(node)
        return found

    return next((c for c in map(visit, sorted(graph)) if c), None)
