"""Partial evaluation: the parts of a right-hand side that depend on its parameters alone are
computed once before a motion; in series of heyoka, products by constants are cheap.
"""

import math

from .compile import Compiled
from .source import unused, uses
from .trace import Step, Trace


def folded(formula: Compiled, count: int) -> tuple[Compiled, Compiled]:
    """A :class:`~newton_euler.algebra.compile.Compiled` formula in two: one that takes the first
    ``count`` arguments, no parameters, and constants; and the formula of these from the parameters.

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
    new: dict[int, Step] = {}  # keys: numbers of the old ones
    constants: dict[int, tuple[Step, Step]] = {}  # keys: numbers of the early ones
    letter = unused("h", formula.parameters)

    def renewed(x):
        return new[x.number] if isinstance(x, Step) else x

    def in_rest(x):
        """A renewed step or number in the rest, where an early step is an argument."""
        if not isinstance(x, Step) or x.trace is rest:
            return x
        if x.number not in constants:
            constants[x.number] = x, rest.new("argument", f"{letter}{len(constants)}")
        return constants[x.number][1]

    for s in formula.trace.steps:
        if s.op == "argument":
            new[s.number] = (rest if s.args[0] in arguments else early).new("argument", s.args[0])
        elif s.number in needed and not chooses:
            op, args = s.op, [renewed(a) for a in s.args]
            if not any(isinstance(a, Step) and a.trace is rest for a in args):
                new[s.number] = early.step(op, *args)
                continue
            if op == "/" and isinstance(args[1], Step) and args[1].trace is early:
                op, args[1] = "*", early.step("/", 1.0, args[1])
            # a power of two, whose inverse is exact
            elif op == "/" and type(args[1]) in (int, float) and math.frexp(args[1])[0] == 0.5:
                op, args[1] = "*", 1.0 / args[1]
            new[s.number] = rest.step(op, *map(in_rest, args))
    if chooses:  # what one side of a choice computes may have no value on the other
        values = [x for x in new.values() if x.trace is early]
        return formula, Compiled(formula.name, parameters, early, values)
    leaves = [in_rest(renewed(leaf)) for leaf in formula.leaves]
    names = [*arguments, *(step.args[0] for _, step in constants.values())]
    values = [x for x, _ in constants.values()]
    constants_of = Compiled(formula.name, parameters, early, values)
    return Compiled(formula.name, names, rest, leaves), constants_of
