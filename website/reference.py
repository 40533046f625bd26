"""The reference of the engine from its docstrings: the names of each room, and a dictionary from
symbols and equations of the book to names in code.
"""

import ast
import importlib
import inspect
import re
import tomllib

from newton_euler.answers.notation import symbol

from .kept import ROOT

ENGINE = ROOT / "newton_euler"
# examples of printed names: letters, dots, indices
NAMES = ("omega", "theta_dot", "rddot", "alpha_CD", "omega_2_dot", "l_OA", "x1", "v_max", "lead")


def pages() -> dict[str, str]:
    """{name of the page: its text in reStructuredText}, in reading order."""
    return {
        "newton_euler": _top(),
        **{room: _room(room) for room in rooms()},
        "symbols": _symbols(),
    }


def rooms() -> list[str]:
    """The rooms of the engine."""
    return sorted(
        p.parent.name for p in ENGINE.glob("*/__init__.py") if p.parent.name != "chapters"
    )


def public(room: str) -> dict[str, list[str]]:
    """{file of the room: its public names}, from the imports and definitions in ``__init__``."""
    tree = ast.parse((ENGINE / room / "__init__.py").read_text(encoding="utf-8"))
    functions = (node.name for node in tree.body if isinstance(node, ast.FunctionDef))
    defined = [name for name in functions if not name.startswith("_")]
    return {**_imported(tree), **({"": defined} if defined else {})}


def _imported(tree):
    """{module: public names} that a file imports from its own package."""
    found = {}
    for node in tree.body:
        if isinstance(node, ast.ImportFrom) and node.level == 1 and node.module:
            names = [alias.asname or alias.name for alias in node.names]
            if shown := [name for name in names if not name.startswith("_")]:
                found.setdefault(node.module, []).extend(shown)
    return found


def _title(text, line="="):
    return [text, line * len(text), ""]


def _top():
    lines = [*_title("Names at the top"), ".. automodule:: newton_euler", ""]
    lines += ["Each is described with its room.", ""]
    tree = ast.parse((ENGINE / "__init__.pyi").read_text(encoding="utf-8"))
    for room, names in _imported(tree).items():
        links = (_link(room, name) for name in sorted(names))
        lines += [f":doc:`{room} <{room}>`", f"    {', '.join(links)}", ""]
    return "\n".join(lines)


def _link(room, name):
    return f":py:obj:`{name} <newton_euler.{room}.{name}>`"


def _room(room):
    module = f"newton_euler.{room}"
    lines = [*_title(f"Room {room}"), f".. automodule:: {module}", "   :no-members:", ""]
    for file, names in public(room).items():
        lines += _title(file or "in the room itself", "-")
        for name in names:
            lines += _entry(module, name)
    return "\n".join(lines)


def _entry(module, name):
    value = getattr(importlib.import_module(module), name)
    if inspect.isclass(value):
        members = ["   :members:", "   :member-order: bysource"]
        shown = [] if issubclass(value, Exception) else members
        return [f".. autoclass:: {module}.{name}", *shown, ""]
    if callable(value) and hasattr(value, "__name__"):
        return [f".. autofunction:: {module}.{name}", ""]
    shown = [f"   :value: {value!r}"] if isinstance(value, float) else []
    return [f".. py:data:: {name}", f"   :module: {module}", *shown, ""]


def _symbols():
    lines = [*_title("Symbols and equations"), *_title("How a name is printed", "-")]
    lines += _table(("in code", "in print"), [(f"``{n}``", f":math:`{symbol(n)}`") for n in NAMES])
    lines += _title("Sums that keep their terms by name", "-")
    words = "The names of the terms are those of ``explain``, ``without`` and ``reweighted``."
    lines += [words, "", *_table(("sum", "equation", "symbol", "terms"), _sums())]
    lines += _title("Equations of the book", "-")
    lines += ["What quotes an equation in its description.", ""]
    lines += _table(("equation", "names"), _equations())
    return "\n".join(lines)


def _sums():
    with (ENGINE / "algebra" / "equations.toml").open("rb") as file:
        known = tomllib.load(file)
    for name, entry in known.items():
        terms = (f"``{t}`` :math:`{latex}`" for t, (_, latex) in entry.get("terms", {}).items())
        yield name, f"({entry['number']})", f":math:`{entry['symbol']}`", ", ".join(terms)


def _equations():
    found = {}
    for room in rooms():
        module = importlib.import_module(f"newton_euler.{room}")
        for name in (n for names in public(room).values() for n in names):
            text = inspect.getdoc(getattr(module, name)) or ""
            for number in set(re.findall(r"\((\d+\.\d+)\)", text)):
                found.setdefault(number, []).append(_link(room, name))
    for number in sorted(found, key=lambda n: [int(x) for x in n.split(".")]):
        yield f"({number})", ", ".join(found[number])


def _table(head, rows):
    lines = [".. list-table::", "   :header-rows: 1", ""]
    for row in (head, *rows):
        cells = (f"{'*' if not n else ' '} - {cell}" for n, cell in enumerate(row))
        lines += [f"   {cell}" for cell in cells]
    return [*lines, ""]
