"""SymPy formulas in readable form."""

import math
from collections.abc import Collection, Sequence
from functools import lru_cache
from itertools import combinations
from typing import Any

from newton_euler.algebra.late import sympy

LONGEST = 30  # operations of a formula that a reader can follow
ROUND_OFF = 1e-15  # smaller constants are zero
HOPELESS = 150  # operations above which simplifying is not worth it


def readable(formula: Any) -> Any:
    """The formula, with integrals in denominators evaluated, and sin^2 + cos^2 = 1 if shorter."""
    formula = sympy.sympify(formula)
    formula = formula.xreplace({x: constant(x) for x in formula.atoms(sympy.Float)})
    formula = formula.replace(_is_double, integrated)
    if sympy.fraction(sympy.together(formula))[1].has(sympy.Integral):
        formula = formula.doit()
    if formula.has(sympy.sin) and formula.has(sympy.cos) and not is_long(formula):
        other = sympy.trigsimp(sympy.expand(formula))
        shorter = other.count_ops() < formula.count_ops() and not _doubles_angles(other, formula)
        return other if shorter else formula
    formula = without_conjugates(formula)
    if not LONGEST / 2 < formula.count_ops() < HOPELESS:
        return formula
    other = sympy.simplify(formula)
    # a readable formula is kept: the order of its terms shows its origin
    return other if is_long(formula) or other.count_ops() < formula.count_ops() / 2 else formula


def _doubles_angles(formula, other):
    """True if a formula has twice an angle, as in sin(2 x), and the other has not."""
    angles = [{y.args[0] for y in x.atoms(sympy.sin, sympy.cos)} for x in (formula, other)]
    return any(x / 2 in angles[1] for x in angles[0] - angles[1])


def _is_double(x):
    """True for an integral with the factor t - u, which stands for a double integral."""
    if not isinstance(x, sympy.Integral):
        return False
    variable, _, end = x.limits[0]
    return end - variable in sympy.Mul.make_args(x.function)


def integrated(formula: Any) -> Any:
    """The formula with integrals of polynomials evaluated."""
    return formula.replace(
        lambda x: isinstance(x, sympy.Integral) and x.function.is_polynomial(x.limits[0][0]),
        lambda x: sympy.expand(x.doit()),
    )


def without_conjugates(formula: Any) -> Any:
    """The formula with a^2 - b^2 for (a + b)*(a - b), also under one power, 1/sqrt(x) for
    sqrt(1/x), and tan for sin/cos.
    """

    def is_root(x):
        return x.is_Pow and x.base.is_Pow and (x.exp, x.base.exp) == (sympy.S.Half, -1)

    formula = formula.replace(is_root, lambda x: 1 / sympy.sqrt(x.base.base))
    return formula.replace(lambda x: x.is_Mul, _joined)


def _joined(product):
    powers = dict(x.as_base_exp() for x in product.args)
    for a, n in powers.items():
        cosine = sympy.cos(*a.args) if isinstance(a, sympy.sin) else None
        if powers.get(cosine) == -n:
            return product * (sympy.tan(*a.args) * cosine / a) ** n
    factors = [(a, n) for a, n in powers.items() if a.is_Add]
    for (a, n), (b, m) in combinations(factors, 2):
        whole = sympy.expand(a * b)
        if n == m and len(whole.args) == 2:
            return product / (a**n * b**n) * whole**n
    return product


def without_unknown(rows: Sequence[tuple[Any, Any]], unknown: Any) -> tuple[list, dict]:
    """Linear equations with one unknown eliminated by the shortest of them, and {unknown: formula},
    empty if no equation contains it.
    """
    differences = [left - right for left, right in rows]
    slopes = [d.diff(unknown) for d in differences]
    found = {
        n: readable(-d.subs(unknown, 0) / slope)
        for n, (d, slope) in enumerate(zip(differences, slopes, strict=True)) if slope
    }  # fmt: skip
    if not found:
        return [*rows], {}
    shortest = min(found, key=lambda n: found[n].count_ops())
    replaced = {unknown: found[shortest]}
    others = [row for n, row in enumerate(rows) if n != shortest]
    return [_without_divisor([x.subs(replaced) for x in row]) for row in others], replaced


def _without_divisor(row):
    """The two sides of an equation, without denominators."""
    above, below = sympy.fraction(sympy.together(row[0] - row[1]))
    return tuple(row) if below.is_number else (sympy.expand(above), sympy.Integer(0))


def two_sides(row: tuple[Any, Any], unknowns: Collection[str] = ()) -> tuple[Any, Any]:
    """The two sides of an equation, with negative terms moved to the other side if both keep one,
    and without common factors that are sums or roots of sums; if a side is zero, without positive
    factors but the ``unknowns``.
    """
    difference = row[0] - row[1]
    expanded = sympy.expand(difference)
    shorter = _names_in(expanded) <= _names_in(difference)
    terms = sympy.Add.make_args(expanded if shorter else difference)
    shared = set.intersection(*({x for x in t.args if x.is_Pow and x.base.is_Add} for t in terms))
    terms = [_signed(t / sympy.Mul(*shared)) for t in terms]
    if shared:  # such as the sides of a triangle
        terms = [t / sympy.gcd_list(terms) for t in terms]
    left = sympy.Add(*(x for x in terms if not x.could_extract_minus_sign()))
    right = sympy.Add(*(-x for x in terms if x.could_extract_minus_sign()))
    if left and right:
        return left, right
    factors = [
        x for x in sympy.Mul.make_args(difference)
        if not (x.is_positive and (x.is_number or (x.is_Symbol and x.name not in unknowns)))
    ]  # fmt: skip
    return row if row[1] != 0 else (sympy.Mul(*factors), row[1])


def _signed(term):
    """A product with the minus sign of a sum of negative terms before it."""
    sums = [x for x in sympy.Mul.make_args(term) if x.is_Add
            and all(y.could_extract_minus_sign() for y in x.args)]  # fmt: skip
    return term.xreplace({x: -x for x in sums}) * (-1) ** len(sums)


def is_forced(name: Any, value: Any, formula: Any) -> bool:
    """True if a formula uses a name in an unusual power, or times a number that only undoes one in
    its value: 4 I_1 for m a^2, where I_1 = m a^2/4.
    """
    usual = (1, 2, sympy.Rational(1, 2))
    if any(p.base == name and abs(p.exp) not in usual for p in formula.atoms(sympy.Pow)):
        return True
    products = formula.atoms(sympy.Mul) if abs(value.as_coeff_Mul()[0]) != 1 else ()
    return any(x.has(name) and abs(x.as_coeff_Mul()[0]) != 1 for x in products)


def factored(formula: Any) -> Any:
    """The formula with fractions cancelled and with common factors of nested sums taken out; its
    own terms are kept apart.
    """
    return sympy.Add(*(_cancelled(x) for x in sympy.Add.make_args(formula)))


def _cancelled(term):
    if term.has(sympy.Integral) or not term.has(sympy.Add):
        return term
    below = sympy.fraction(term)[1]
    nested = (x.exp.is_negative and x.base.free_symbols for x in below.atoms(sympy.Pow))
    if any(nested) and below.is_rational_function():
        term = sympy.cancel(sympy.together(term))
    shorter = sympy.factor_terms(term, clear=False)
    return shorter if _names_in(shorter) < _names_in(term) else term


def _names_in(formula):
    """The number of names and of numbers in a formula."""
    atoms = [x for x in sympy.preorder_traversal(formula) if x.is_Atom]
    return sum(x.is_Symbol for x in atoms), sum(not x.is_Symbol and bool(abs(x) > 1) for x in atoms)


def is_itself_shorter(formula: Any, other: Any) -> bool:
    """True if a formula has at most half the operations of another."""
    return formula.count_ops() <= other.count_ops() / 2


def is_atom(formula: Any) -> bool:
    """True if a formula is a name, perhaps with a minus sign."""
    return formula.is_Symbol or (-formula).is_Symbol


def is_root(formula: Any) -> bool:
    """True if a formula is a square root."""
    return formula.is_Pow and formula.exp == sympy.S.Half


def is_long(formula: Any) -> bool:
    """True if a formula is too long to follow."""
    return formula.count_ops() > LONGEST


def constant(x: Any) -> Any:
    """A number as it is usually written: 1/3 for 0.333..., pi/2 for 1.5707..."""
    x = float(x) if abs(float(x)) > ROUND_OFF else 0.0
    if x.is_integer():
        return sympy.Integer(int(x))
    pi, root = (math.pi, sympy.pi), (math.sqrt(2), sympy.sqrt(2))
    for unit, name in ((1.0, 1), pi, (1 / math.pi, 1 / sympy.pi), root):
        near = sympy.Rational(x / unit).limit_denominator(60) if math.isfinite(x) else 0
        if near and math.isclose(float(near) * unit, x, rel_tol=1e-13):
            return near * name
    return sympy.Float(x)


def _rooted(root):
    """A root with common factors cancelled under it."""
    inside = sympy.factor(root.base)
    return inside**root.exp if _names_in(inside) < _names_in(root.base) else root


@lru_cache(maxsize=4000)  # results are often the same for all students
def simplest(formula: Any) -> Any:
    """A result as the shortest of its usual forms."""
    if formula.count_ops() > HOPELESS:
        return formula
    if formula.has(sympy.Float):  # beside rounded numbers, pi and sqrt(2) are rounded too
        formula = formula.replace(lambda x: x.is_number and not x.is_Rational, sympy.N)
    formula = formula.replace(lambda x: x.is_Pow and not x.exp.is_Integer, _rooted)
    ways = factored, sympy.factor, sympy.expand, sympy.together
    forms = [formula, *(way(formula) for way in ways)]
    if formula.has(sympy.sin) and formula.count_ops() < 60:
        forms.append(sympy.trigsimp(formula))
    shortest = min(forms, key=lambda f: f.count_ops())
    if shortest.count_ops() > LONGEST and any(
        not x.exp.is_Integer for x in shortest.atoms(sympy.Pow)
    ):
        shortest = min(
            shortest, sympy.factor(sympy.simplify(shortest)), key=lambda f: f.count_ops()
        )
    shortest = without_conjugates(shortest)
    return shortest.xreplace(
        {x: sympy.Integer(1) for x in shortest.atoms(sympy.Float) if float(x) == 1}
    )
