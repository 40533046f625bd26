"""Slips in the set-up of a problem, by random edits of the text of its code: a point elsewhere, a
turn about another axis or left out, a velocity for an acceleration, a body left out.
"""

import ast
import copy
import inspect
import random
from collections.abc import Iterator, Mapping
from itertools import combinations
from types import ModuleType
from typing import Any

import exercises.devices
from exercises.catalogue import Problem
from exercises.catalogue.variants import flat, symbol_points
from newton_euler.algebra.scalars import ZERO, NewtonEulerError

OF_NO_ANSWER = {"prove", "draw", "mistakes", "steps", "figure", "follows"}
COORDINATES = {"point": slice(1, 4), "vector": slice(0, 3)}
RATES = {"acceleration": "velocity", "angular_acceleration": "angular_velocity"}
AXES = ("x", "y", "z", "-x", "-y", "-z")

Place = tuple[ModuleType, int, int]  # a module, a node in it, and which of the node's other forms


def of_setups(
    p: Problem, values: Mapping[str, float], rng: random.Random, most: int
) -> Iterator[dict[str, tuple]]:
    """The answers, {key: components}, of ``p`` with random slips in its set-up."""
    places = list(_places(p))
    g = p.base({**values, **symbol_points(p)})
    asked = [a for a in p.answers if not a.kind.is_word]
    for place in rng.sample(places, min(most, len(places))):
        try:
            found = p.in_units(_solve(p, *place)(g))
            made = {
                a.key: tuple(0.0 if s is ZERO else s for s in flat(found[a.key])) for a in asked
            }
        except (NewtonEulerError, ArithmeticError, ValueError, TypeError, LookupError):
            continue  # this is not set up
        if all(len(made[a.key]) == a.kind.length for a in asked):  # no entry of the answer is gone
            yield made


def _modules(p):
    """The code of a problem, and the devices that it names."""
    code: Any = p.code
    yield code
    prefix = exercises.devices.__name__
    known = {inspect.getmodule(x) for x in vars(code).values() if hasattr(x, "__module__")}
    known |= {x for x in vars(code).values() if isinstance(x, ModuleType)}
    yield from sorted(
        (m for m in known if m and m.__name__.startswith(prefix)), key=lambda m: m.__name__
    )


def _places(p: Problem) -> Iterator[Place]:
    for module in _modules(p):
        for n, node in enumerate(_nodes(ast.parse(inspect.getsource(module)))):
            yield from ((module, n, k) for k, _ in enumerate(_others(node)))


def _nodes(tree):
    """The nodes of functions that the answers may need."""
    for part in tree.body:
        if not (isinstance(part, ast.FunctionDef) and part.name in OF_NO_ANSWER):
            yield from ast.walk(part)


def _solve(p, module, n, k):
    """The function that solves the problem, with the k-th other form of the n-th node."""
    tree = ast.parse(inspect.getsource(module))
    node = [*_nodes(tree)][n]
    node.__dict__.update(vars([*_others(node)][k]))
    changed = ModuleType(module.__name__)
    exec(compile(ast.fix_missing_locations(tree), module.__name__, "exec"), vars(changed))
    code: Any = p.code
    if module is code:
        return changed.solve
    own = ModuleType(code.__name__)
    exec(compile(inspect.getsource(code), code.__name__, "exec"), vars(own))
    there = {id(module): changed}
    there |= {id(x): vars(changed)[name] for name, x in vars(module).items() if name[0] != "_"}
    vars(own).update({name: there.get(id(x), x) for name, x in vars(own).items()})
    return own.solve


def _others(node: ast.AST) -> Iterator[ast.AST]:
    """The other forms of a node."""
    if isinstance(node, ast.List) and len(node.elts) > 1:
        for n in range(len(node.elts)):
            yield ast.List([x for m, x in enumerate(node.elts) if m != n], node.ctx)
    if not (isinstance(node, ast.Call) and isinstance(node.func, ast.Attribute)):
        return
    if other := RATES.get(node.func.attr):
        called = copy.copy(node)
        called.func = ast.Attribute(node.func.value, other, ast.Load())
        yield called
    where = COORDINATES.get(node.func.attr)
    if where and len(node.args[where]) == 3:
        for there in _elsewhere(node.args[where]):
            called = copy.copy(node)
            called.args = [*node.args[: where.start], *there]
            yield called
    if node.func.attr == "rotate":
        yield from _turned(node)


def _elsewhere(x):
    for n, m in combinations(range(3), 2):
        if not (_is_zero(x[n]) and _is_zero(x[m])):
            moved = [*x]
            moved[n], moved[m] = x[m], x[n]
            yield moved
    for n in range(3):
        if not _is_zero(x[n]):
            yield [ast.UnaryOp(ast.USub(), y) if m == n else y for m, y in enumerate(x)]


def _is_zero(x):
    return isinstance(x, ast.Constant) and x.value == 0


def _turned(node):
    axis = node.args[1] if len(node.args) > 1 else None
    for other in AXES if isinstance(axis, ast.Constant) else ():
        if other != axis.value:
            called = copy.copy(node)
            called.args = [node.args[0], ast.Constant(other), *node.args[2:]]
            yield called
    if any(k.arg == "rate" for k in node.keywords):
        called = copy.copy(node)
        called.keywords = [k for k in node.keywords if k.arg != "rate"]
        yield called
