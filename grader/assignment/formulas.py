"""SymPy formulas for readers, in LaTeX or as text, with symbols or with numbers of six digits."""

import math
import re
from collections.abc import Collection, Mapping
from functools import cache
from typing import Any

from newton_euler.algebra.late import np, sympy
from newton_euler.algebra.units import unit
from newton_euler.answers.notation import number_symbol, six_digits, symbol, unit_symbol

from .layout import laid_out

Quantity = tuple[Any, str]  # a number and its unit
_WORD = r"\\text\{[^{}]*\}(?:_(?:\w|\{(?:[^{}]|\{[^{}]*\})*\}))?(?:\^\{[^{}]*\})?"
# a space between a word and another factor, which LaTeX omits
_BESIDE_WORD = re.compile(rf"(?P<word>{_WORD}) (?=[\\\w])|(?<=[\w}}]) (?=\\text)")


def formula_text(
    formula: Any,
    names: Mapping[str, str],
    latex: bool,
    numbers: bool = False,
    degrees: bool = False,
) -> str:
    """A formula in LaTeX or as text, its symbols replaced by ``names`` and in the order of these,
    which may be ``numbers``; with ``degrees``, right angles in a sum are not written as pi/2.
    """
    formula, called = laid_out(formula, names)
    names = {**names, **{placed: names[name] for placed, name in called.items()}}
    printer = (_latex_printer() if latex else _text_printer())(names, numbers)
    printer.degrees = degrees
    text = printer.doprint(formula)
    return _BESIDE_WORD.sub(lambda m: (m["word"] or "") + r"\, ", text) if latex else text


def numerals(quantities: Mapping[str, Quantity], bare: bool, latex: bool) -> dict:
    """{name: number as text}, ``bare`` without units, except for degrees."""
    return {n: _numeral(*q, bare, latex) for n, q in quantities.items()}


def coherent(units: Collection[str]) -> bool:
    """True if a formula needs no factor for numbers in these units, as mm and mm/s^2; degrees,
    which are always marked, are ignored.

    >>> coherent(["m", "s", "m/s"]), coherent(["mm", "m/s^2", "s"])
    (True, False)
    """
    found = [unit(u) for u in units if u != "deg"]
    powers = np.array([[float(x) for x in u.dimension.powers] for u in found]).reshape(-1, 3)
    factors = np.array([math.log(u.to_base(1.0)) for u in found])
    scales, *_ = np.linalg.lstsq(powers, factors, rcond=None)
    return bool(np.allclose(powers @ scales, factors, rtol=0, atol=1e-9))


def _numeral(x, stated_in, bare, latex):
    bare = (bare and stated_in != "deg") or stated_in == "1"
    if latex:
        return number_symbol(float(x)) + ("" if bare else unit_symbol(stated_in))
    return six_digits(float(x)) + ("" if bare else f" {stated_in}")


def _one_root(product):
    """A product with its square roots combined into one: h sqrt(h/g) for h^(3/2)/sqrt(g), and
    sqrt(2 g/3) for sqrt(6 g)/3.
    """
    half = sympy.Rational(1, 2)
    roots = [
        x for x in product.args if x.is_Pow and x.exp.is_Rational and x.exp.q == 2
        and (abs(x.exp) == half or x.base.is_Symbol)
    ]  # fmt: skip
    if len(roots) < 2:
        return product
    inside = sympy.Mul(*(x.base ** sympy.sign(x.exp) for x in roots))
    others = [x for x in product.args if x not in roots]
    others += [x.base ** (x.exp - sympy.sign(x.exp) * half) for x in roots if abs(x.exp) != half]
    number, square = product.as_coeff_Mul()[0], inside.as_coeff_Mul()[0]
    if number.is_Rational and abs(number.p) == 1 and square % number.q == 0:
        others = [sympy.sign(number), *(x for x in others if x != number)]
        inside = inside / number.q**2
    others = [x for x in others if x != 1]
    over, under = sympy.fraction(inside)
    root = sympy.Pow(under if over == 1 else inside, half, evaluate=False)
    root = sympy.Pow(root, -1, evaluate=False) if over == 1 else root
    return sympy.Mul(*others, root, evaluate=False) if others else root


class _Names:
    """Prints symbols by ``names``, and floats with six digits."""

    names: Mapping[str, str]
    numbers: bool
    degrees = False
    latex = False

    def _as_ordered_terms(self, expr, order=None):
        """Terms in order, positive ones first, and of these a number, as in 1 + n but n^2 + 1, then
        those of one name before products; beside decimals only the first positive one, as in
        3.5 t^2 - 1.8 t + 2.
        """
        terms = super()._as_ordered_terms(expr, "lex")
        others = [x for x in terms if not x.is_Rational]
        powers = [x.as_coeff_Mul()[1].as_base_exp() for x in others]
        square = len(expr.free_symbols) == 1 and any(b.is_Symbol and n != 1 for b, n in powers)
        if all(x.free_symbols for x in others) and not square:
            terms = [x for x in terms if x.is_Rational] + others
        if self.degrees:
            terms = [self._in_degrees(x) for x in terms]
        numbers = [x.as_coeff_Mul()[0] for x in terms]
        in_front = [n for n, x in enumerate(numbers) if not x < 0]
        if any(x.is_Float for x in numbers):
            in_front = in_front[:1]
        places = {x: (n not in in_front, len(x.free_symbols) > 1) for n, x in enumerate(terms)}
        return sorted(terms, key=lambda x: places[x])

    def _in_degrees(self, x):
        turns = x / sympy.pi
        if not turns.is_Rational:
            return x
        mark = r"^\circ" if self.latex else " deg"
        return sympy.sign(turns) * sympy.Symbol(f"{float(abs(turns) * 180):.6g}{mark}")

    def _print_Symbol(self, expr, style="plain"):
        is_name = self.latex and expr.name.isidentifier()  # and no number
        return self.names.get(expr.name) or (symbol(expr.name) if is_name else expr.name)

    def _print_Add(self, expr, order=None):
        text = super()._print_Add(expr, order)
        return text.replace("+ -", "- ").replace("- -", "+ ") if self.numbers else text

    def _print_Mul(self, expr):
        f = -expr
        if isinstance(f, (sympy.asin, sympy.atan)):  # an angle without a sign
            inside = [-x if x.is_Add else x for x in sympy.Mul.make_args(f.args[0])]
            if inside != [*sympy.Mul.make_args(f.args[0])]:
                return self._print(f.func(sympy.Mul(*inside, evaluate=False), evaluate=False))
        joined = _one_root(expr) if expr.is_Mul else expr  # SymPy prints 1/x here, too
        alone = expr.is_Mul and not joined.is_Mul
        minus = "- " * (self.latex and joined.is_Mul and joined.could_extract_minus_sign())
        in_order = self._in_order(-joined if minus else joined)
        text = minus + (self._print(joined) if alone else super()._print_Mul(in_order))
        return text[3:] if self.numbers and text.startswith("- -") else text.removeprefix("--")

    def _in_order(self, product):
        """A product in LaTeX with its sines and other functions behind its sums."""
        if not (self.latex and product.is_Mul):
            return product
        factors = product.as_ordered_factors()
        factors.sort(key=lambda x: self._is_function(x) or x.as_base_exp()[0].is_Function)
        return sympy.Mul(*factors, evaluate=False)

    def _is_apart(self, expr):
        """True for a symbol whose text needs parentheses: -3, 2 x 10^3, 25 km/h, l/r."""
        if not expr.is_Symbol:
            return False
        text = self._print_Symbol(expr)
        return "/" in text or (text[:1] in "-0123456789" and not text.replace(".", "").isdigit())

    def _is_function(self, expr):
        r"""True for a symbol whose text would take in a following power or factor: \cos b."""
        starts = (r"\sin ", r"\cos ", r"\tan ")
        return expr.is_Symbol and self._print_Symbol(expr).startswith(starts)

    def _print_Pow(self, expr):
        text = self._print(expr.base) if self._is_function(expr.base) else ""
        if text and expr.exp.is_Integer and expr.exp > 0:
            return re.sub(r"^\\\w+", rf"\g<0>^{{{expr.exp}}}", text)
        return super()._print_Pow(expr)


@cache
def _latex_printer():
    from sympy.printing.latex import LatexPrinter

    class Printer(_Names, LatexPrinter):
        latex = True

        def __init__(self, names, numbers):
            dots = {"mul_symbol": "dot"} if numbers else {}
            brackets = {"fold_func_brackets": True, "inv_trig_style": "full"}
            super().__init__({**brackets, "order": "none", **dots})
            self.names, self.numbers = names, numbers

        def _print_Float(self, expr):
            return number_symbol(float(expr))

        def _print_atan2(self, expr, **_):
            y, x = map(self._print, expr.args)
            return rf"\operatorname{{atan2}}\left({y},\ {x}\right)"

        def _needs_mul_brackets(self, expr, first=False, last=False):
            return self._is_apart(expr) or super()._needs_mul_brackets(expr, first, last)

        def _needs_function_brackets(self, expr):
            factors = self.numbers and expr.is_Mul and not any(x.is_Pow for x in expr.args)
            return self._is_apart(expr) or factors or super()._needs_function_brackets(expr)

        def parenthesize_super(self, s):
            return s  # no symbol of ours has a power of its own

        def parenthesize(self, item, level, is_neg=False, strict=False):
            if self._is_apart(item) or self._is_function(item):
                return rf"\left({self._print(item)}\right)"
            return super().parenthesize(item, level, is_neg, strict)

    return Printer


@cache
def _text_printer():
    from sympy.printing.str import StrPrinter

    class Printer(_Names, StrPrinter):
        latex = False

        def __init__(self, names, numbers):
            super().__init__()
            self.names, self.numbers = names, numbers

        def _print_Float(self, expr):
            return six_digits(float(expr))

        def stringify(self, args, sep, level=0):
            """The arguments of a function, without further brackets."""
            if level:
                return super().stringify(args, sep, level)
            return sep.join(map(self._print, args))

        def parenthesize(self, item, level, strict=False):
            if self._is_apart(item):
                return f"({self._print(item)})"
            return super().parenthesize(item, level, strict)

    return Printer
