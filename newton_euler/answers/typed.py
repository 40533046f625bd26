"""Steps of a traced computation as a student types them: products with their factors collected, of
a size that fits into a sentence.
"""

from fractions import Fraction
from typing import Any

from ..algebra.trace import Step

FUNCTIONS = {"sqrt", "sin", "cos", "tan", "asin", "acos", "atan", "atan2", "exp", "log", "abs"}
SHORT = 24  # letters of a formula that is named in a sentence
NAMES = 4  # of givens that are named where a formula is too long


class Product:
    """A coefficient and powers of steps, {step: power}, that are no products themselves."""

    def __init__(self, x: Any):
        self.coefficient, self.powers = Fraction(1), dict[Step, int]()
        self.is_exact = True
        self._take(x, 1)

    def _take(self, x, power):
        if not isinstance(x, Step):
            self._constant(x, power)
        elif x.op in ("*", "/"):
            self._take(x.args[0], power)
            self._take(x.args[1], power if x.op == "*" else -power)
        elif x.op == "neg":
            self.coefficient *= (-1) ** power
            self._take(x.args[0], power)
        elif x.op == "sqrt" and (inside := Product(x.args[0])).is_square:
            for s, p in inside.powers.items():
                self._put(s, power * p // 2)
        elif x.op == "**" and x.args[1] in (-3, -2, -1, 3, 4):
            self._take(x.args[0], power * int(x.args[1]))
        else:
            self._put(x, power)

    def _put(self, s, power):
        self.powers[s] = self.powers.get(s, 0) + power
        if not self.powers[s]:
            del self.powers[s]

    def _constant(self, x, power):
        near = Fraction(x).limit_denominator(999)
        if near and abs(near - Fraction(x)) < 1e-12 * abs(near):
            self.coefficient *= near**power
        else:
            self.is_exact = False

    @property
    def is_square(self) -> bool:
        """True of v^2 and a^2*b^2, whose root is a product again."""
        even = all(p % 2 == 0 for p in self.powers.values())
        return self.is_exact and self.coefficient == 1 and even


def typed(x: Any, most: int = SHORT) -> str:
    """An expression as it is typed; "" for one that is too long to be named, or a mere number."""
    written = _sum(x) if isinstance(x, Step) else ""
    return written if len(written) <= most else ""


def described(x: Any, noun: str = "") -> str:
    """An expression in words: as it is typed, after the ``noun`` if there is one, or by the givens
    that are in it; "" for a number.
    """
    if written := typed(x):
        return f"{noun} {written}".strip()
    names = list(_names(x, {}))
    return f"{noun or 'an expression'} in {', '.join(names)}" if 0 < len(names) <= NAMES else ""


def _names(x, seen):
    if isinstance(x, Step) and x.number not in seen:
        seen[x.number] = True
        if x.op == "argument":
            yield x.args[0]
        for a in x.args if x.op != "argument" else ():
            yield from _names(a, seen)


def _sum(x):
    if not isinstance(x, Step) or x.op not in ("+", "-"):
        return _product(x)
    a, b = map(_sum, x.args)
    if a and a == b and " " not in a:
        return f"2*{a}" if x.op == "+" else ""
    if b and x.op == "-" and isinstance(x.args[1], Step) and x.args[1].op in ("+", "-"):
        b = f"({b})"
    sign, b = (" - ", b[1:]) if (b.startswith("-") and x.op == "+") else (f" {x.op} ", b)
    return f"{a}{sign}{b}" if a and b else ""


def _product(x):
    if not isinstance(x, Step):
        return f"{x:g}" if isinstance(x, (int, float)) and len(f"{x:g}") < 5 else ""
    product = Product(x)
    over = [_power(s, p) for s, p in product.powers.items() if p > 0]
    under = [_power(s, -p) for s, p in product.powers.items() if p < 0]
    c = product.coefficient
    over[:0] = [str(abs(c.numerator))] * (abs(c.numerator) != 1 or not over)
    under[:0] = [str(c.denominator)] * (c.denominator != 1)
    if not (product.is_exact and all(over) and all(under) and abs(c.numerator) < 1000):
        return ""
    below = f"/({'*'.join(under)})" if len(under) > 1 else "".join(f"/{u}" for u in under)
    return ("-" if c < 0 else "") + "*".join(over) + below


def _power(s, power):
    base = _atom(s)
    return base if power == 1 or not base else f"{base}^{power}"


def _atom(s):
    if s.op == "argument":
        return s.args[0]
    if s.op in ("+", "-"):
        return f"({inside})" if (inside := _sum(s)) else ""
    if s.op == "pi":
        return "pi"
    if s.op not in FUNCTIONS:
        return ""
    inside = [_sum(a) for a in s.args]
    return f"{s.op}({', '.join(inside)})" if all(inside) else ""
