"""The last form of a formula before it is printed: the order of names in its products and sums, and
the places of its signs and of the fractions of its sums.
"""

from collections.abc import Iterable, Mapping
from itertools import combinations
from typing import Any

from newton_euler.algebra.late import sympy
from newton_euler.algebra.units import unit

FUNCTIONS = "sin_", "cos_", "tan_"


def in_reading_order(units: Mapping[str, str]) -> list[str]:
    """Names in the order of a product in a book, such as k x^2/2, m g h, m r omega^2 and v_0 t:
    without a unit, then with a mass, g, lengths, rates, velocities, accelerations, times, angles;
    within a kind in the order of ``units``, {name: its unit}. A sine, as sin_phi, comes last.

    >>> in_reading_order({"h": "m", "g": "m/s^2", "t": "s", "omega": "rpm", "m": "g", "mu": "1"})
    ['mu', 'm', 'g', 'h', 'omega', 't']
    """
    return sorted(units, key=lambda name: _place(name, units[name]))


def _place(name, stated):
    mass, length, time = unit(stated).dimension.powers
    if _function(name):
        return 10, 0, 0
    if mass:
        return 1, -length, time
    if (length, time) == (0, 0):
        return (0 if stated == "1" else 9), 0, 0
    if name == "g":
        return 2, 0, 0
    kinds = {(1, 0): 3, (0, -1): 4, (0, -2): 4, (1, -1): 5, (1, -2): 6, (0, 1): 7}
    return kinds.get((length, time), 3), 0, 0


def laid_out(formula: Any, names: Iterable[str]) -> tuple[Any, dict[Any, str]]:
    """A formula with symbols that SymPy prints in the order of ``names`` and then of other names,
    and {such a symbol: its name}; its signs and fractions are where a reader expects them.

    >>> from sympy import sin, sqrt, symbols
    >>> a, b, c, d = symbols("a b c d")
    >>> [laid_out(x, "abcd")[0] for x in (-c * (b - a) / d, a / (b / 2 + c / 2), (-a - b) ** 2 * c)]
    [002*(000 - 001)/003, 2*000/(001 + 002), 002*(000 + 001)**2]
    """
    places = {name: n for n, name in enumerate(names)}
    called = {
        x: sympy.Symbol(f"{places[x.name]:03}{_function(x.name)}", **x.assumptions0)
        for x in formula.free_symbols
        if x.name in places
    }
    formula = _tidy(formula.xreplace(called))
    if all(x.as_coeff_Mul()[1].is_Symbol for x in sympy.Add.make_args(formula)):
        formula = _over_one_number(formula)
    return formula, {placed.name: x.name for x, placed in called.items()}


def as_drawn(formula: Any, sheets: Iterable[Mapping[str, float]]) -> Any:
    """A formula without bars around what is positive, and with positive denominators, for all
    ``sheets`` of numbers of its symbols.

    >>> from sympy import Abs, symbols
    >>> r, R = symbols("r R")
    >>> as_drawn(Abs(r) / (r**2 - R**2), [{"r": 1.0, "R": 2.0}])
    -r/(R**2 - r**2)
    """
    sheets = [*sheets]

    def signs(x):
        numbers = ({s: sheet.get(s.name, s) for s in x.free_symbols} for sheet in sheets)
        return {x.subs(values).is_positive for values in numbers}

    formula = formula.replace(
        lambda x: x.is_Pow and x.base.is_Add and x.exp == -1 and signs(x.base) == {False},
        lambda x: -1 / -x.base,
    )
    return formula.xreplace(
        {x: x.args[0] for x in formula.atoms(sympy.Abs) if signs(x.args[0]) == {True}}
    )


def _function(name):
    return next((f for f in FUNCTIONS if name.startswith(f)), "")


def _tidy(x, is_term=False):
    """``is_term``: of a sum, before which a minus sign may stay."""
    args = [_tidy(a, x.is_Add) for a in x.args]
    if x.is_Add:
        x, args = _with_common_factors(x.func(*args)), []
    elif x.is_Function:
        args = [_over_one_number(a) for a in args]
    if args and args != [*x.args]:
        x = x.func(*args, evaluate=False) if x.is_Function else x.func(*args)
    return _turned(x, is_term) if x.is_Mul or x.is_Pow else x


def _with_common_factors(x):
    """A sum as a product with the factors that all its terms share, which are then two at least,
    or one or a number beside squares, or a sine or a sum: m (a^2 + b^2)/12, (n - p) tan b, but
    m g + m a; of many terms as a product of sums if that has half the names.
    """
    product = sympy.factor(x) if len(x.args) > 3 else x
    if 2 * _names_in(product) <= _names_in(x):
        return product
    x = _collected(x)
    terms = [term.as_coeff_Mul() for term in sympy.Add.make_args(x)]
    number = abs(terms[0][0]) if any(n > 0 for n, _ in terms) else terms[0][0]
    if len(terms) < 2 or any(abs(n) != abs(number) for n, _ in terms):
        return x
    powers = [term.as_powers_dict() for _, term in terms]
    shared = [
        base**power
        for base, power in powers[0].items()
        if power.is_Rational and all(other.get(base) == power for other in powers)
    ]
    rest = [sympy.sign(n / number) * term / sympy.Mul(*shared) for n, term in terms]
    squares = all(y.as_coeff_Mul()[1].is_Pow for y in rest) and (shared or abs(number) != 1)
    bases = [y.as_base_exp()[0] for y in shared]
    sines = any(y.is_Add or y.is_Function or str(y).endswith(FUNCTIONS) for y in bases)
    many = number.is_Rational and number.q > 1 and len(rest) > 3
    enough = len(shared) + (not number.is_Integer) >= 2 or squares or sines or many
    if not enough or any(sympy.fraction(y)[1] != 1 for y in rest):
        return x
    return sympy.Mul(number, *shared, sympy.Add(*rest), evaluate=bool(shared))


def _collected(x):
    """A sum with the terms that share a sum as a factor, but not all do, in one, and those of which
    :func:`_with_common_factors` makes a product: I + m (a^2 + b^2).
    """
    for factor in sorted((y for term in x.args for y in term.args if y.is_Add), key=str):
        those = [term for term in x.args if factor in term.args]
        if 1 < len(those) < len(x.args):
            shared = sympy.Add(*(term / factor for term in those))
            sign = -1 if _is_other_way_round(shared, False) else 1
            collected = sympy.Mul(sign, factor, sign * shared)
            return collected + sympy.Add(*(y for y in x.args if y not in those))
    kinds: dict[Any, list[Any]] = {}  # terms by the size of their number and by shared factors
    for y in (y for y in x.args if not any(factor.is_Add for factor in y.args)):
        number, factors = y.as_coeff_mul()
        for shared in (*combinations(factors, 2), *combinations(factors, 1), ()):
            kinds.setdefault((-len(shared), str((*shared, abs(number)))), []).append(y)
    for _, those in sorted(kinds.items(), key=lambda kind: kind[0]):
        part = _with_common_factors(sympy.Add(*those)) if 1 < len(those) < len(x.args) else x
        if part.is_Mul:
            return _collected(part + sympy.Add(*(y for y in x.args if y not in those)))
    return x


def _names_in(x):
    return sum(y.is_Symbol for y in sympy.preorder_traversal(x))


def _turned(x, is_term):
    """A product or power with its sums in the form of :func:`laid_out`."""
    number, factors, changed = sympy.Integer(1), [], False
    negative = x.as_coeff_Mul()[0].could_extract_minus_sign()
    for a in sympy.Mul.make_args(x):
        base, power = a.as_base_exp()
        if base.is_Add and power.is_Rational and (power < 0 or sympy.fraction(x)[1] != 1):
            above, below = _without_fractions(base, power)
            base, changed = above, changed or below != 1
            factors.append(below**-power)
        if not base.is_Add or not power.is_Integer:
            factors.append(base**power)
            continue
        divided = power < 0 or sympy.fraction(x)[1].free_symbols
        part, whole = base.primitive()
        if not divided and not (part.is_Integer and part > 1):
            part, whole = _one_fraction(base)
        if _is_other_way_round(whole, negative and power > 0 and power % 2 and not is_term):
            part, whole, negative = -part, -whole, negative != bool(power % 2)
        number *= part**power
        factors.append(whole**power)
        changed = changed or part != 1
    return sympy.Mul(number, *factors) if changed else x


def _without_fractions(x, power):
    """A sum as a fraction without fractions in it, unless its denominator would be a root."""
    above, below = sympy.fraction(sympy.together(x))
    is_plain = all(y.exp.is_Integer for y in (below**power).atoms(sympy.Pow))
    return (_collected(above), below) if below != 1 and is_plain else (x, sympy.Integer(1))


def _is_other_way_round(whole, has_minus):
    """True if a sum reads better with opposite signs and a minus sign before it, or without one."""
    minus = sum(term.could_extract_minus_sign() for term in whole.args)
    return minus == len(whole.args) or (has_minus and 2 * minus >= len(whole.args))


def _over_one_number(x):
    """A sum whose terms all have the same denominator, as (a + b)/2."""
    below = {sympy.fraction(term)[1].as_coeff_Mul()[1] for term in sympy.Add.make_args(x)}
    if len(below) == 1 and below != {1}:
        return sympy.together(x)
    number, whole = _one_fraction(x)
    return x if number == 1 else sympy.Mul(number, whole, evaluate=False)


def _one_fraction(x):
    """The factor 1/n of all terms of a sum, or 1, and the sum without it."""
    numbers = [term.as_coeff_Mul()[0] for term in sympy.Add.make_args(x)]
    below = {n.q for n in numbers if n.is_Rational}
    if not x.is_Add or len(below) != 1 or not all(n.is_Rational for n in numbers):
        return sympy.Integer(1), x
    n = below.pop()
    return sympy.Rational(1, n), sympy.Add(*(n * term for term in x.args))
