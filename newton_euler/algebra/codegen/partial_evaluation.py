"""Partial evaluation: what a right-hand side computes from its parameters alone is computed once
before a motion and not at every step.

To heyoka a parameter inside a product is a series like any other; a constant in its place makes the
product cheap. A division is a recurrence of its own, where a product by the inverse is not.
"""

import math

from .compile import Compiled
from .source import unused, uses
from .trace import Step, Trace


def folded(formula, count):
    """A :class:`~newton_euler.algebra.codegen.compile.Compiled` formula in two: one that takes
    constants, and the formula of the parameters that returns these.

    count : the number of its first arguments that are no parameters; the first of the two takes
        these and then the constants

    >>> from newton_euler import compiled
    >>> rest, constants = folded(compiled(lambda x, m, g, l: -m*g*l*x/(m*l*l)), 1)
    >>> print(rest.source, constants.source, sep="", end="")
    def formula(x, h0, h1):
        s0 = -((h0 * x) * h1)
        return s0,
    def formula(m, g, l):
        s0 = (m * g) * l
        s1 = (1.0) / ((m * l) * l)
        return s0, s1,
    """
    arguments, parameters = formula.parameters[:count], formula.parameters[count:]
    needed, rest, early = uses(formula.trace, formula.leaves), Trace(), Trace()
    chooses = any(s.op == "where" for s in formula.trace.steps if s.number in needed)
    # the new steps by the numbers of the old ones
    moving, fixed, constants, letter = {}, {}, {}, unused("h", formula.parameters)

    def constant(x):
        """The argument of the rest in the place of this step of the other formula."""
        if x.number not in constants:
            constants[x.number] = x, rest.new("argument", f"{letter}{len(constants)}")
        return constants[x.number][1]

    def in_rest(x):
        return (
            x
            if not isinstance(x, Step)
            else moving[x.number]
            if x.number in moving
            else constant(fixed[x.number])
        )

    for s in formula.trace.steps:
        if s.op == "argument":
            own, trace = (moving, rest) if s.args[0] in arguments else (fixed, early)
            own[s.number] = trace.new("argument", s.args[0])
        elif s.number not in needed or chooses:
            continue
        elif not any(isinstance(a, Step) and a.number in moving for a in s.args):
            fixed[s.number] = early.step(
                s.op, *(fixed[a.number] if isinstance(a, Step) else a for a in s.args)
            )
        elif s.op == "/" and isinstance(s.args[1], Step) and s.args[1].number in fixed:
            moving[s.number] = rest.step(
                "*", in_rest(s.args[0]), constant(early.step("/", 1.0, fixed[s.args[1].number]))
            )
        # a power of two, whose inverse is exact
        elif s.op == "/" and type(s.args[1]) in (int, float) and math.frexp(s.args[1])[0] == 0.5:
            moving[s.number] = rest.step("*", in_rest(s.args[0]), 1.0 / s.args[1])
        else:
            moving[s.number] = rest.step(s.op, *map(in_rest, s.args))
    if chooses:  # what one side of a choice computes may have no value on the other
        return formula, Compiled(formula.name, parameters, early, list(fixed.values()))
    leaves = [in_rest(leaf) for leaf in formula.leaves]
    names = [*arguments, *(step.args[0] for _, step in constants.values())]
    return Compiled(formula.name, names, rest, leaves), Compiled(
        formula.name, parameters, early, [x for x, _ in constants.values()]
    )
