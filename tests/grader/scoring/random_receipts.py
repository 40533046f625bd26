"""Receipts that nobody would hand in: random JSON, random formulas, right answers changed a little,
and what is meant to cost the scorer its time.
"""

import math

NAMES = ("omega", "theta", "r", "pi", "P", "b", "d", "nu", "+", "*", "^", "/", "sin", "where", "Max",
         "<", "Abs", "atan2", "exp", "log", "", "__class__", "\ud800", "\0", "a" * 500)  # fmt: skip
ONE = ("sin", "cos", "tan", "asin", "acos", "atan", "sinh", "cosh", "exp", "log", "sqrt", "Abs")
TWO = ("^", "/", "atan2", "<", "<=", "Max", "Min", "Mod")
NUMBERS = (0, 1, -1, 2, 0.5, -0.5, 1e-300, 1e300, -1e308, 9**99, 10**4000, -(2**63), 1e-9, 3.1416,
           math.nan, math.inf, -math.inf)  # fmt: skip


def receipt(rng, p, key):
    """A random receipt for problem ``p``; ``key`` maps its answers to right trees."""
    if rng.random() < 0.05:
        return anything(rng, 4)
    answers = {a: _answer(rng, p, tree) for a, tree in key.items()}
    faults = {rng.choice(list(key)): anything(rng, 2)} if rng.random() < 0.1 else {}
    error = anything(rng, 2) if rng.random() < 0.1 else None
    found = {"id": p.id, "answers": answers, "faults": faults, "error": error}
    if rng.random() < 0.05:
        found[rng.choice(("answers", "faults"))] = anything(rng, 3)
    return found


def _answer(rng, p, right):
    kind = rng.random()
    if kind < 0.2:
        return anything(rng, 5)
    if kind < 0.3:
        return _changed(rng, right)
    if kind < 0.302:
        return costly(rng)
    one = (lambda: formula(rng, list(p.symbols), rng.randint(0, 5))) if p.symbolic else (
        lambda: rng.choice(NUMBERS) if rng.random() < 0.5 else rng.uniform(-9, 9) * 10.0**rng.randint(-3, 5)
    )  # fmt: skip
    tree = [one() for _ in range(3)] if rng.random() < 0.7 else one()
    return {"arm": tree, "ground": anything(rng, 1)} if rng.random() < 0.1 else tree


def anything(rng, depth):
    """Whatever JSON can hold."""
    kind = rng.randrange(8 if depth else 5)
    if kind == 0:
        return rng.choice((None, True, False))
    if kind in (1, 2):
        return rng.choice(NUMBERS)
    if kind in (3, 4):
        return rng.choice(NAMES)
    inner = [anything(rng, depth - 1) for _ in range(rng.randrange(4))]
    return {rng.choice(NAMES): x for x in inner} if kind == 5 else inner


def formula(rng, symbols, depth):
    """A tree of the operators that are read."""
    if depth == 0 or rng.random() < 0.1:
        return rng.choice(symbols if symbols and rng.random() < 0.6 else (*NUMBERS, "pi"))
    inner = lambda: formula(rng, symbols, depth - 1)
    kind = rng.random()
    if kind < 0.35:
        return [rng.choice(ONE), inner()]
    if kind < 0.6:
        return [rng.choice(TWO), inner(), inner()]
    if kind < 0.65:
        return ["where", inner(), inner(), inner()]
    return [rng.choice("+*"), *(inner() for _ in range(rng.randint(1, 3)))]


def _changed(rng, tree):
    """A right answer with one thing changed; sometimes it is still right."""
    if isinstance(tree, (int, float)):
        return tree * rng.choice((-1, 2, 1.01, 0.99, 1e3)) + rng.choice((0, 0, 1, -1e-9))
    if not isinstance(tree, list):
        return rng.choice((["*", 1.01, tree], ["+", tree, 1], ["sin", tree], [tree]))
    tree = list(tree)
    n = rng.randrange(len(tree))
    tree[n] = rng.choice((_changed, lambda rng, x: anything(rng, 1)))(rng, tree[n])
    return tree


def costly(rng):
    """What would take long if it were not bounded."""
    n = rng.choice((300, 1600, 2400, 4900, 5000, 20000))
    part = rng.choice(("r", "omega", 1.5, ["sin", "omega"], ["^", -1, 0.5], ["^", "omega", "r"]))
    kind = rng.randrange(6)
    if kind == 0:
        return ["+", *[part] * n]
    if kind == 1:
        tree = part
        for _ in range(n):
            tree = [rng.choice(("sin", "sqrt", "Abs")), tree]
        return tree
    if kind == 2:
        tree = part
        for _ in range(12):
            tree = [rng.choice(("+", "*", "^", "Max")), tree, tree]
        return [tree] * 3
    if kind == 3:
        return ["^", 9, ["^", 9, ["^", 9, ["^", 9, 9]]]]
    if kind == 4:
        return [10**4000] * n
    return {str(m): [0, 0, 0] for m in range(n)}
