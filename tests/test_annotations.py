"""Every public function and method says what it takes and returns, so that a reader knows what
crosses a room, and mypy checks it. The functions of a problem are as the Protocol ``Code`` says.
"""

import ast
from pathlib import Path

from tests.imports import modules

ROOT = Path(__file__).parent.parent
EXERCISES = "exercises/catalogue", "exercises/devices"
PACKAGES = "newton_euler", "chapters", *EXERCISES, "grader", "website"
OF_CLASSES = ("__post_init__",)  # called by their decorators alone
FILES = [path for package in PACKAGES for path in modules(ROOT / package).values()]


def is_public(name, takes=()):
    """True for a name without an underscore, and for an operator: a method that takes more, or
    that not every object has, as -a.
    """
    is_everybodys = hasattr(object, name) or name in OF_CLASSES
    is_operator = len(takes) > (1 if is_everybodys else 0)
    return name[0] != "_" or (name[:2] == name[-2:] == "__" and is_operator)


def bare(body, inside=""):
    """What the public functions in a body do not annotate, as "Vector.dot: other, return"."""
    for node in body:
        if isinstance(node, ast.ClassDef) and is_public(node.name):
            yield from bare(node.body, f"{inside}{node.name}.")
        elif isinstance(node, ast.FunctionDef):
            a = node.args
            takes = [*a.posonlyargs, *a.args, *a.kwonlyargs, *filter(None, (a.vararg, a.kwarg))]
            is_method = inside and "staticmethod" not in map(ast.unparse, node.decorator_list)
            missing = [x.arg for x in takes[bool(is_method) :] if not x.annotation]
            missing += ["return"] * (not node.returns and node.name != "__init__")
            if missing and is_public(node.name, takes if inside else ()):
                yield f"{inside}{node.name}: {', '.join(missing)}"


def test_public_functions_are_annotated():
    found = {
        f"{path.relative_to(ROOT)}": missing
        for path in FILES
        if (missing := [*bare(ast.parse(path.read_text(encoding="utf-8")).body)])
    }
    assert found == {}


def test_a_missing_annotation_is_seen():
    source = """
def size(x: float) -> float: ...
def scaled(x: float, by=2) -> float: ...
def _own(x): ...
class Vector:
    def __init__(self, x: float): ...
    def __repr__(self): ...
    def __add__(self, other): ...
    def __neg__(self): ...
    @staticmethod
    def of(x) -> "Vector": ...
"""
    found = [*bare(ast.parse(source).body)]
    assert found == [
        "scaled: by",
        "Vector.__add__: other, return",
        "Vector.__neg__: return",
        "Vector.of: x",
    ]
