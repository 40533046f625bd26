"""What a student's notebook imports: does an answer have the right form, and what is handed in.

``expect`` says what a problem asks for, ``receipt`` checks the *form* of the answers (kind, shape, finite, known symbols, and for formulas the
dimension) and writes them down as one JSON record: numbers, or trees of a few operators. Neither holds nor needs the key.
"""

import json
import os
import re
from dataclasses import dataclass

from .scalars import FUNCTIONS, function, pi
from .units import Dimension, DimensionError, UnitError, unit
from .vectors import Vector

NODES = 4000  # the largest formula that is taken, in operations
SHAPES = {"number": 1, "vector": 3, "matrix": 9, "interval": 2, "expression": 1, "vector_expression": 3, "matrix_expression": 9}
_WORDS = {
    "number": "one number",
    "vector": "a vector, three numbers as in [1.0, 0, -2.5]",
    "matrix": "a 3 x 3 matrix of numbers, as in [[1, 0, 0], [0, 1, 0], [0, 0, 1]]",
    "interval": "an interval, two numbers as in [low, high]",
    "count": "a whole number",
    "choice": "one of the words",
    "expression": "a formula in the problem's symbols",
    "vector_expression": "a vector of three formulas, as in [r*omega, 0, 0]",
    "matrix_expression": "a 3 x 3 matrix of formulas",
}


class AnswerError(ValueError):
    """An answer that cannot be read: what was expected, what came, what to do."""


@dataclass(frozen=True)
class Form:
    """What one answer must look like: its kind, its unit, and for a choice the words."""

    kind: str
    unit: str
    of: tuple = ()

    @classmethod
    def read(cls, text):
        """From the text in a notebook: "vector, mm/s", "choice: stable | unstable"."""
        kind, _, rest = (part.strip() for part in text.partition(":" if text.startswith("choice") else ","))
        if kind not in _WORDS:
            raise AnswerError(f"no such kind of answer: {kind!r}; there are {', '.join(_WORDS)}")
        return cls("choice", "1", tuple(w.strip() for w in rest.split("|"))) if kind == "choice" else cls(kind, rest or "1")

    def __str__(self):
        if self.kind == "choice":
            return f"choice: {' | '.join(self.of)}"
        return f"{self.kind}, {self.unit}"

    @property
    def words(self):
        """The same for a reader."""
        if self.kind == "choice":
            return f"one of {', '.join(map(repr, self.of))}"
        return _WORDS[self.kind] + ("" if self.kind == "count" or self.unit == "1" else f", in {self.unit}")


_expected, receipts = {}, {}


def expect(problem, symbols=None, **forms):
    """Announce what ``problem`` asks for: ``expect("4/16", v_D="vector, mm/s")``; ``symbols`` maps the symbols of formulas to their units."""
    _expected[problem] = ({key: Form.read(text) for key, text in forms.items()}, dict(symbols or {}))


def receipt(problem, **answers):
    """Check the form of the answers to ``problem`` and keep them as one JSON record; answers that are None are still open.

    Returns a :class:`Receipt` that says, for each answer, what was read. Raises :class:`AnswerError` naming every answer that cannot be read.

    >>> expect("0/1", v="vector, mm/s")
    >>> receipt("0/1", v=[1, 2.5, 0])
    0/1: v = [1, 2.5, 0] mm/s. Form checked only; the key is not here.
    """
    if problem not in _expected:
        raise AnswerError(f"nothing is known of problem {problem!r}; run the cells of the notebook from the top, and use the numbers written there")
    forms, symbols = _expected[problem]
    unknown = [key for key in answers if key not in forms]
    if unknown:
        raise AnswerError(f"problem {problem} does not ask for {unknown[0]!r}; it asks for {', '.join(forms)}")
    read, faults = record(forms, symbols, answers)
    receipts[problem] = {"problem": problem, "answers": read, "faults": faults}
    if faults:
        raise AnswerError("\n".join(f"{problem}, {key}: {fault}" for key, fault in faults.items()))
    if os.environ.get("NBGRADER_EXECUTION") == "autograde":
        raise AnswerError(
            f"{problem} is not graded here: nbgrader runs without this course's configuration, so every part counts 0. "
            "Instructors: grade with the course's nbgrader_config.py, or with python -m grader grade"
        )
    return Receipt(problem, read, forms, symbols)


class Receipt:
    """What was handed in for one problem; ``json`` is the record."""

    def __init__(self, problem, answers, forms, symbols):
        self.problem, self.answers, self.forms, self.symbols = problem, answers, forms, symbols

    @property
    def json(self):
        """The record that is handed in, as JSON text."""
        return json.dumps({"problem": self.problem, "answers": self.answers})

    def __repr__(self):
        given = [f"{key} = {_shown(tree)}{_behind(self.forms[key].unit)}" for key, tree in self.answers.items() if tree is not None]
        blank = [key for key in self.forms if self.answers.get(key) is None]
        text = f"{self.problem}: {'; '.join(given)}. Form checked only; the key is not here." if given else f"{self.problem}: no answer yet."
        if given and blank:
            text += f" Still open: {', '.join(blank)}."
        return "\n".join([text, *self.hints()])

    def hints(self):
        """What can be said about formulas without the key: answers whose dimension does not fit the unit asked for."""
        hints = []
        for key, tree in self.answers.items():
            if tree is not None and self.forms[key].kind.endswith("expression"):
                hints += [f"  look again at {key}: {hint}" for hint in dimension_hints(tree, self.forms[key], self.symbols)]
        return hints


def record(forms, symbols, answers):
    """({key: tree or None}, {key: fault}) of the answers, read according to their forms."""
    read, faults = {}, {}
    for key, form in forms.items():
        try:
            value = answers.get(key)
            read[key] = None if value is None else _tree(value, form, symbols)
        except AnswerError as error:
            faults[key] = str(error)
        except Exception as error:  # objects of any library may fail in any way; the student is told, the rest goes on
            faults[key] = f"expected {form.words}; the value given cannot be read: {type(error).__name__}: {error}"[:500]
    return read, faults


def _tree(value, form, symbols):
    if form.kind == "choice":
        if value not in form.of:
            raise AnswerError(f"expected {form.words}; got {str(value)[:80]!r}")
        return value
    if form.kind == "count":
        if isinstance(value, bool) or int(value) != value:
            raise AnswerError(f"expected {form.words}; got {value!r}")
        return int(value)
    formula = form.kind.endswith("expression")
    parts = _flat(value, form)
    if len(parts) != SHAPES[form.kind]:
        raise AnswerError(f"expected {form.words}; got {_counted(len(parts))}: {_clipped(value)}")
    read = [_formula(x, form, symbols, [NODES]) if formula else _number(x, form) for x in parts]
    return read[0] if len(read) == 1 else read


def _without_unit(value, form):
    """A pint quantity as a number in the unit that is asked for."""
    if not hasattr(value, "magnitude") or not hasattr(value, "to"):
        return value
    try:
        return value.to(_pints_name(form.unit)).magnitude
    except Exception as error:
        raise AnswerError(f"expected {form.words}; the quantity {value} cannot be converted: {error}") from None


def _pints_name(unit_text):
    """A unit of the problems as pint writes it; pint's lb and oz are masses."""
    names = {"rev": "revolution", "lb": "lbf", "oz": "force_ounce", "1": "dimensionless", "%": "percent"}
    return re.sub(r"[A-Za-z%]+|(?<!\^)\b1\b", lambda m: names.get(m[0], m[0]), unit_text).replace("^", "**")


def _flat(value, form):
    value = _without_unit(value, form)
    if isinstance(value, str):
        raise AnswerError(f"expected {form.words}; got the text {_clipped(value)}; write it without quotation marks")
    if isinstance(value, Vector):
        return list(value.components())
    if isinstance(value, dict | set):
        raise AnswerError(f"expected {form.words}; got a {type(value).__name__}, which has no order")
    if getattr(value, "shape", None) == ():
        return [value]
    if hasattr(value, "__iter__") or hasattr(value, "shape"):
        return [x for part in value for x in _flat(part, form)]
    return [value]


def _counted(n):
    return "1 number" if n == 1 else f"{n} numbers"


def _clipped(value):
    text = repr(value)
    return text if len(text) < 80 else text[:77] + "..."


def _number(x, form):
    if isinstance(x, bool) or x is None or isinstance(x, complex):
        raise AnswerError(f"expected {form.words}; got {x!r}")
    free = getattr(x, "free_symbols", None)
    if free:
        raise AnswerError(f"expected {form.words}; {_clipped(x)} still contains {', '.join(sorted(map(str, free)))}; put in the numbers")
    try:
        number = float(x)
    except (TypeError, ValueError):
        raise AnswerError(f"expected {form.words}; cannot make a number of {_clipped(x)}") from None
    if number != number or number in (float("inf"), float("-inf")):
        raise AnswerError(f"expected {form.words}; got {number}, which comes from a division by zero or the root of a negative number")
    return number


# -- formulas


def _formula(x, form, symbols, budget):
    """A SymPy or SymEngine expression as nested lists: numbers, names of symbols, and [operator, ...]."""
    budget[0] -= 1
    if budget[0] < 0:
        raise AnswerError(f"expected {form.words}; this one has more than {NODES} operations. Simplify it, or put in fewer intermediate results")
    if not hasattr(x, "args") or isinstance(x, (int, float)):
        return _number(x, form)
    if str(type(x).__module__).startswith("symengine"):  # SymPy's f(t) has a type without a module
        x = x._sympy_()
    if x.is_Symbol:
        if x.name not in symbols:
            raise AnswerError(f"expected {form.words}; it contains {x.name!r}, but the symbols of the problem are {', '.join(symbols)}")
        return x.name
    if x.is_Integer:
        return int(x) if abs(int(x)) < 2**53 else float(x)
    if x.is_Rational:
        return ["/", float(x.p), float(x.q)]
    if x.is_Number or not x.args:
        return "pi" if str(x) == "pi" else _number(x, form)
    name = {"Add": "+", "Mul": "*", "Pow": "^"}.get(x.func.__name__, x.func.__name__)
    if name not in ("+", "*", "^", "atan2", "Abs", "exp", *FUNCTIONS):
        raise AnswerError(f"expected {form.words}; {name} is not among the functions that are read: {', '.join(FUNCTIONS)}, atan2, Abs")
    return [name, *(_formula(a, form, symbols, budget) for a in x.args)]


class TreeError(ValueError):
    """A tree that is not one: an unknown operator or symbol, or too deep."""


def evaluate(tree, values, depth=0):
    """The value of a formula tree over scalars of any kind; ``values`` maps symbols to scalars. Reads data, runs nothing of it."""
    if depth > 200:
        raise TreeError("the formula is nested more than 200 deep")
    if isinstance(tree, bool) or tree is None:
        raise TreeError(f"not a formula: {tree!r}")
    if isinstance(tree, (int, float)):
        return float(tree)  # never a Python integer: 9^9^9 would not end
    if isinstance(tree, str):
        if tree == "pi":
            return pi()
        if tree not in values:
            raise TreeError(f"unknown symbol {tree[:40]!r}")
        return values[tree]
    if not isinstance(tree, list) or not tree or not isinstance(tree[0], str):
        raise TreeError("a formula is a number, a symbol or a list that begins with an operator")
    name, *args = tree[0], *(evaluate(a, values, depth + 1) for a in tree[1:])
    if not args:
        raise TreeError(f"the operator {name[:40]!r} has no arguments")
    if name in ("+", "*"):
        out = args[0]
        for a in args[1:]:
            out = out + a if name == "+" else out * a
        return out
    if name == "^" and len(args) == 2:
        return _power(*args)
    if name == "/" and len(args) == 2:
        return args[0] / args[1]
    if name == "Abs" and len(args) == 1:
        return abs(args[0])
    if (name in FUNCTIONS and len(args) == 1) or (name == "atan2" and len(args) == 2):
        return function(name, *args)
    raise TreeError(f"unknown operator {name[:40]!r} with {len(args)} arguments")


def _power(base, exponent):
    if isinstance(exponent, Dimension):
        if isinstance(base, Dimension) and any(base.powers):
            raise DimensionError(f"a quantity with {base} is raised to a power that is not a number")
        return Dimension()
    if isinstance(exponent, float) and float(exponent).is_integer():
        exponent = int(exponent)
    return base**exponent


def dimension_hints(tree, form, symbols):
    """What is wrong with the dimension of a formula, as sentences; needs no key, only the units of the symbols."""
    try:
        asked, dimensions = unit(form.unit).dimension, {n: unit(u).dimension for n, u in symbols.items()}
    except UnitError:
        return []
    hints, parts = [], tree if SHAPES[form.kind] > 1 else [tree]
    for n, part in enumerate(parts):
        where = f"component {n + 1}" if len(parts) > 1 else "it"
        try:
            got = evaluate(part, dimensions)
        except DimensionError as error:
            hints.append(f"{where} adds unlike quantities ({error})")
            continue
        got = got if isinstance(got, Dimension) else Dimension()
        if got != asked and part not in (0, 0.0):
            hints.append(f"{where} has {got}, but {form.unit} has {asked}")
    return hints


def _behind(unit_text):
    return "" if unit_text == "1" else f" {unit_text}"


def _shown(tree):
    if isinstance(tree, list) and not (tree and isinstance(tree[0], str) and tree[0] in ("+", "*", "^", "/", *FUNCTIONS, "Abs", "atan2")):
        return "[" + ", ".join(_shown(t) for t in tree) + "]"
    if isinstance(tree, list):
        if tree[0] in "+*^/":
            return "(" + f" {tree[0]} ".join(_shown(t) for t in tree[1:]) + ")"
        return f"{tree[0]}({', '.join(_shown(t) for t in tree[1:])})"
    return f"{tree:.6g}" if isinstance(tree, float) else str(tree)
