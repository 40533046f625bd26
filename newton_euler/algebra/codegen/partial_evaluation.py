"""Partial evaluation: what a right-hand side computes from its parameters alone is computed once
before a motion and not at every step.

To heyoka a parameter inside a product is a series like any other; a constant in its place makes the
product cheap. A division is a recurrence of its own, where a product by the inverse is not.
"""

import ast
import math

from .source import unused


def folded(text, count):
    """A :class:`~newton_euler.algebra.codegen.compiled.Compiled` formula in two: one that takes
    constants, and the formula of the parameters that returns these.

    count : the number of its first arguments that are no parameters; the first of the two takes
        these and then the constants

    >>> from newton_euler import compiled
    >>> rest, constants = folded(compiled(lambda x, m, g, l: -m*g*l*x/(m*l*l)), 1)
    >>> print(rest.source, constants.source, sep="", end="")
    def formula(x, h0, h1):
        s0 = -(h0 * x * h1)
        return (s0,)
    def formula(m, g, l):
        return (m * g * l, 1.0 / (m * l * l),)
    """
    function = ast.parse(text.source).body[0]
    names = [a.arg for a in function.args.args]
    if "where(" in text.source:  # what one side of a choice computes may have no value on the other
        return text, _like(text, names[count:], [], names[count:])
    split = _Split(names[:count], names[count:])
    lines = [line for line in function.body[:-1] if split.keeps(line)]
    results = [ast.unparse(split.visit(x)) for x in function.body[-1].value.elts]
    return _like(text, [*names[:count], *split.constants.values()], lines, results), _like(
        text, names[count:], split.early, split.constants
    )


def _like(text, names, lines, results):
    """A formula like this one with other arguments, lines and results."""
    body = "".join(f"    {ast.unparse(ast.fix_missing_locations(line))}\n" for line in lines)
    return text.rewritten(
        f"def formula({', '.join(names)}):\n{body}    return "
        f"({''.join(f'{x}, ' for x in results).rstrip()})\n"
    )


class _Split(ast.NodeTransformer):
    """Replaces each largest part of an expression that depends on parameters alone by a name;
    ``constants`` : the names, by the text of the part.
    """

    def __init__(self, moving, parameters):
        self.moving, self.fixed, self.early, self.constants = set(moving), set(parameters), [], {}
        self.letter = unused("h", {n: n for n in (*moving, *parameters)})

    def keeps(self, line):
        """True for a line that depends on more, which is changed in place; others go to ``early``."""
        fixed = self._is_fixed(line.value)
        if fixed:
            self.early.append(line)
        else:
            line.value = self.visit(line.value)
        (self.fixed if fixed else self.moving).add(line.targets[0].id)
        return not fixed

    def visit(self, node):
        """The expression with constants in the places of its fixed parts."""
        if isinstance(node, ast.expr) and self._is_fixed(node):
            return self._constant(ast.unparse(node))
        if isinstance(node, ast.BinOp) and isinstance(node.op, ast.Div):
            if self._is_fixed(node.right):
                return ast.BinOp(
                    self.visit(node.left),
                    ast.Mult(),
                    self._constant(f"1.0 / ({ast.unparse(node.right)})"),
                )
            # a power of two, whose inverse is exact
            if isinstance(node.right, ast.Constant) and math.frexp(node.right.value)[0] == 0.5:
                return ast.BinOp(
                    self.visit(node.left), ast.Mult(), ast.Constant(1.0 / node.right.value)
                )
        return self.generic_visit(node)

    def _constant(self, expression):
        return ast.Name(
            self.constants.setdefault(expression, f"{self.letter}{len(self.constants)}"), ast.Load()
        )

    def _is_fixed(self, node):
        names = {n.id for n in ast.walk(node) if isinstance(n, ast.Name)}
        return not names & self.moving and bool(names & self.fixed)
