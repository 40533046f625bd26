"""What a right-hand side computes from its parameters alone, done once before a motion and not at every step.

To heyoka a parameter inside a product is a series like any other; a single number in its place makes the product cheap. A division is a recurrence
of its own, where a product by the inverse is not.
"""

import ast
import math
from copy import copy

from .straight_line import unused


def folded(text, count):
    """A :class:`~newton_euler.tracing.Compiled` formula in two: the rest, which takes numbers, and the formula of the parameters that gives these.

    count : the first so many of its arguments are no parameters
    Returns the rest, with these arguments and then the numbers, and the formula of the others, whose result is a tuple of numbers.

    >>> from newton_euler import compiled
    >>> rest, numbers = folded(compiled(lambda x, m, g, l: -m*g*l*x/(m*l*l)), 1)
    >>> print(rest.source, numbers.source, sep="", end="")
    def formula(x, h0, h1):
        s0 = -(h0 * x * h1)
        return (s0,)
    def formula(m, g, l):
        return (m * g * l, 1.0 / (m * l * l),)
    """
    function = ast.parse(text.source).body[0]
    names = [a.arg for a in function.args.args]
    if text._lazy != text.source:  # it chooses, and what one side computes may have no value on the other
        return text, _formula(text, names[count:], [], names[count:])
    split = _Split(names[:count], names[count:])
    kept = [line for line in function.body[:-1] if split.keeps(line)]
    results = [ast.unparse(split.visit(x)) for x in function.body[-1].value.elts]
    return _formula(text, [*names[:count], *split.numbers.values()], kept, results), _formula(text, names[count:], split.early, split.numbers)


def _formula(text, names, lines, results):
    """A formula like this one with another text."""
    body = "".join(f"    {ast.unparse(ast.fix_missing_locations(line))}\n" for line in lines)
    new = copy(text)
    new.source = new._lazy = f"def formula({', '.join(names)}):\n{body}    return ({''.join(f'{x}, ' for x in results).rstrip()})\n"
    return new


class _Split(ast.NodeTransformer):
    """Puts a name in the place of each largest part of an expression that depends on parameters alone."""

    def __init__(self, moving, parameters):
        self.moving, self.fixed, self.early, self.numbers = set(moving), set(parameters), [], {}
        self.letter = unused("h", {n: n for n in (*moving, *parameters)})

    def keeps(self, line):
        """True for a line that moves, changed in place; a fixed one goes before."""
        if self._is_fixed(line.value):
            self.early.append(line)
            self.fixed.add(line.targets[0].id)
            return False
        line.value = self.visit(line.value)
        self.moving.add(line.targets[0].id)
        return True

    def visit(self, node):
        """An expression with numbers in the places of its fixed parts."""
        if isinstance(node, ast.expr) and self._is_fixed(node):
            return self._number(ast.unparse(node))
        if isinstance(node, ast.BinOp) and isinstance(node.op, ast.Div):
            if self._is_fixed(node.right):
                return ast.BinOp(self.visit(node.left), ast.Mult(), self._number(f"1.0 / ({ast.unparse(node.right)})"))
            if isinstance(node.right, ast.Constant) and math.frexp(node.right.value)[0] == 0.5:  # a power of two: exact
                return ast.BinOp(self.visit(node.left), ast.Mult(), ast.Constant(1.0 / node.right.value))
        return self.generic_visit(node)

    def _number(self, expression):
        return ast.Name(self.numbers.setdefault(expression, f"{self.letter}{len(self.numbers)}"), ast.Load())

    def _is_fixed(self, node):
        names = {n.id for n in ast.walk(node) if isinstance(n, ast.Name)}
        return not names & self.moving and bool(names & self.fixed)
