"""Steps of a traced computation as a student types them: products with their factors collected,
short enough for a sentence.
"""

from fractions import Fraction
from typing import Any

from newton_euler.algebra.language import Words
from newton_euler.algebra.scalars import to_plain
from newton_euler.algebra.trace import Step

FUNCTIONS = {"sqrt", "sin", "cos", "tan", "asin", "acos", "atan", "atan2", "exp", "log", "abs"}
SHORT = 24  # letters of a formula that is named in a sentence
NAMES = 4  # givens, at most, that are named where a formula is too long


class Product:
    """A coefficient and powers of steps, {step: power}, that are not products themselves, without
    those that cancel.
    """

    def __init__(self, x: Any):
        self.coefficient, self.powers = Fraction(1), dict[Step, int]()
        self.cancelled = dict[Step, None]()
        self.is_exact = True
        self._take(x, 1)

    def _take(self, x, power):
        x = without_zeros(x)
        if not isinstance(x, Step):
            self._constant(x, power)
        elif x.op in ("*", "/"):
            self._take(x.args[0], power)
            self._take(x.args[1], power if x.op == "*" else -power)
        elif len(found := _collected(x)) == 1:
            ((s, c),) = found.items()
            self.coefficient *= c**power
            self._put(s, power)
        elif x.op == "neg":
            self.coefficient *= (-1) ** power
            self._take(x.args[0], power)
        elif x.op == "+" and x.args[0] is x.args[1]:
            self.coefficient *= 2**power if power > 0 else Fraction(1, 2**-power)
            self._take(x.args[0], power)
        elif x.op == "sqrt" and _under_root(x) and _under_root(x)[0] < 0:
            self._put(x, power)
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
            self.cancelled[s] = None

    def _constant(self, x, power):
        exact = Fraction(to_plain(x))
        near = exact.limit_denominator(999)
        if near and abs(near - exact) < 1e-12 * abs(near):
            self.coefficient *= near**power
        else:
            self.is_exact = False

    @property
    def is_square(self) -> bool:
        """True of v^2 and a^2*b^2, whose root is a product again."""
        even = all(p % 2 == 0 for p in self.powers.values())
        return self.is_exact and self.coefficient == 1 and even


def typed(x: Any) -> str:
    """An expression as it is typed; "" for one that is too long to be named, or a mere number."""
    written = _sum(x) if isinstance(x, Step) else ""
    return written if len(written) <= SHORT else ""


NOUNS = {  # {noun: (with a formula, with the givens that are in it)}
    "": ("{formula}", Words("an expression in {names}")),
    "the term": (Words("the term {formula}"), Words("the term in {names}")),
    "the factor": (Words("the factor {formula}"), Words("the factor in {names}")),
    "of the product": (Words(" of the product {formula}"), Words(" of the product in {names}")),
}


def described(x: Any, noun: str = "") -> str:
    """An expression in words: as it is typed, after the ``noun`` if there is one, or by the givens
    that are in it; "" for a number.
    """
    whole, parts = NOUNS[noun]
    meant = x.trace.meant.get(x.number) if isinstance(x, Step) else ""
    written = typed(x)
    if written and not (meant and "(" in written):  # a name reads better than a sum inside
        return Words(whole, formula=written)
    if meant:
        return Words(" of {product}", product=meant) if noun == "of the product" else meant
    names = list(_names(x, {}))
    return Words(parts, names=", ".join(names)) if 0 < len(names) <= NAMES else ""


def is_given(x: Any) -> bool:
    """True of an expression with a given in it, False of a number, as pi/2."""
    return next(_names(x, {}), None) is not None


def _names(x, seen):
    if isinstance(x, Step) and x.number not in seen:
        seen[x.number] = True
        name = x.args[0] if x.op == "argument" else x.trace.called.get(x.number)
        if name:
            yield name
        for a in () if name else x.args:
            yield from _names(a, seen)


def without_zeros(x: Any) -> Any:
    """An expression without terms that are zero for every student, as c - c."""
    while isinstance(x, Step) and x.op in ("+", "-"):
        a, b = x.args
        if is_nothing(b):
            x = a
        elif is_nothing(a) and x.op == "+":
            x = b
        else:
            break
    return x


def is_nothing(x: Any) -> bool:
    """True for an expression that is zero for every student, such as c - c."""
    if not isinstance(x, Step):
        return x == 0
    if x.op == "*":
        return any(map(is_nothing, x.args))
    return (x.op == "-" and x.args[0] is x.args[1]) or (x.op == "/" and is_nothing(x.args[0]))


def terms_of(x: Any, sign: int = 1) -> list[tuple[int, Any]]:
    """[(sign, term)] of nested sums."""
    x = without_zeros(x)
    if root := _under_root(x):
        return terms_of(root[1], sign * root[0])
    if not isinstance(x, Step) or x.op not in ("+", "-"):
        return [(sign, x)]
    a, b = x.args
    return [*terms_of(a, sign), *terms_of(b, sign if x.op == "+" else -sign)]


def _under_root(x):
    """(sign, sum) of the root of the square of a sum whose terms all have this sign, or None: that
    of (-a - b)^2 is a + b.
    """
    square = x.args[0] if isinstance(x, Step) and x.op == "sqrt" else None
    if not isinstance(square, Step) or square.op != "*" or square.args[0] is not square.args[1]:
        return None
    signs = {c > 0 for c in _collected(square.args[0]).values()}
    return (1 if signs == {True} else -1, square.args[0]) if len(signs) == 1 else None


def repeats(x: Any) -> bool:
    """True for a sum of givens that contains one twice, such as 2*a - a or R - (R + d): a student
    would simplify it.
    """
    return 0 < len(_collected(x)) < len(terms_of(x))


def _collected(x):
    """{given: its coefficient} in a sum of multiples of givens; {} of any other step."""
    if not isinstance(x, Step) or (x.op not in ("+", "-") and not _under_root(x)):
        return {}
    found: dict[Step, Fraction] = {}
    for sign, term in terms_of(x):
        product = Product(term)
        (s, power), *others = product.powers.items() or [(x, 0)]
        if others or power != 1 or s.op != "argument" or not product.is_exact:
            return {}
        found[s] = found.get(s, Fraction(0)) + sign * product.coefficient
    return {s: c for s, c in found.items() if c}


def _in_full(found):
    written = ""
    for s, c in found.items():
        one = _power(s, 1) if abs(c) == 1 else f"{abs(c)}*{_power(s, 1)}"
        sign = (" - ", "-") if c < 0 else (" + ", "")
        written += sign[not written] + one
    return written


def _sum(x):
    x = without_zeros(x)
    if not isinstance(x, Step) or x.op not in ("+", "-"):
        return _product(x)
    if repeats(x):
        return _in_full(_collected(x))
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


def _acute(x):
    """The angle x of pi - x, which has the same sine; any other step as it is."""
    if isinstance(x, Step) and x.op == "-" and getattr(x.args[0], "op", "") == "pi":
        return x.args[1]
    return x


def _power(s, power):
    base = _atom(s)
    return base if power == 1 or not base else f"{base}^{power}"


def _atom(s):
    if s.op == "argument":
        return s.args[0]
    if s.number in s.trace.called:
        return s.trace.called[s.number]
    if s.op in ("+", "-"):
        return f"({inside})" if (inside := _sum(s)) else ""
    if s.op == "pi":
        return "pi"
    if _under_root(s):
        return f"({_in_full(_collected(s))})"
    if s.op not in FUNCTIONS or not any(_names(s, {})):
        return ""  # sin(pi) is a number
    inside = [_sum(_acute(a) if s.op == "sin" else a) for a in s.args]
    return f"{s.op}({', '.join(inside)})" if all(inside) else ""
