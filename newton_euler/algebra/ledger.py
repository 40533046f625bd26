"""Sums that keep their terms by name: the equation they come from, the ledger of a vector, amounts
of work and energy.

A result that theory writes as a sum knows its terms (``a.terms``), can be written out
(``a.explain()``) and summed again with some of them left out or weighted
(``a.without("coriolis")``), which is what a wrong model would give.
"""

from dataclasses import dataclass, field
from types import MappingProxyType

from .errors import NewtonEulerError
from .scalars import ZERO, is_numeric, plain, scalar, short, size


class TermError(NewtonEulerError, ValueError):
    """A term that a sum does not have."""


@dataclass(frozen=True, eq=False)
class Equation:
    """The equation of a sum with named terms.

    kind : what the sum is; number, symbol : its number in the book, and its LaTeX symbol
    terms : each term by name as (text, LaTeX), where the name does not say it
    """

    kind: str
    number: str
    symbol: str
    terms: dict


def equations(table):
    """{kind: :class:`Equation`} of a table {kind: (number, symbol, terms)}; read-only.

    >>> equations({"weight": ("5.26", "W", {})})["weight"].number
    '5.26'
    """
    return MappingProxyType({kind: Equation(kind, *entry) for kind, entry in table.items()})


class NamedTerms:
    """What is a sum whose ``terms`` are known by name."""

    __slots__ = ()

    def without(self, *names):
        """The sum without the terms named: ``a.without("coriolis")``."""
        return self.reweighted(**dict.fromkeys(names, 0))

    def _weighted(self, factors, error):
        """Pairs of the factor named for a term (1 for others) and the term; an ``error`` if there
        is none of that name.
        """
        unknown = [n for n in factors if n not in self.terms]
        if unknown:
            raise error(f"no term {unknown[0]!r}; the terms are {', '.join(self.terms) or 'none'}")
        return [(scalar(factors.get(name, 1)), term) for name, term in self.terms.items()]


class Ledger:
    """The named terms of a sum. ``subject`` says what of what."""

    __slots__ = ("_make", "_terms", "equation", "subject")

    def __init__(self, equation, subject, make):
        self.equation, self.subject, self._make, self._terms = equation, subject, make, None

    @property
    def terms(self):
        """The vectors by name, computed when first asked for."""
        if self._terms is None:
            self._terms = self._make()
        return self._terms

    def mapped(self, change):
        """The ledger with every term changed in the same way."""
        return Ledger(
            self.equation, self.subject, lambda: {name: change(v) for name, v in self.terms.items()}
        )


class Explanation:
    """A vector written out as the sum it is. ``str()`` gives text, ``latex`` the formulas; Jupyter
    shows the latter.
    """

    def __init__(self, vector, ledger, unit=""):
        self.ledger, self.unit = ledger, unit
        self.equation = ledger.equation
        terms = {n: t.expressed_in(vector.frame) for n, t in vector.terms.items()}
        noise = 1e-14 * max(
            (size(x) for t in (vector, *terms.values()) for x in t.c if is_numeric(x)), default=0.0
        )
        self.vector, self.terms = (
            vector.rounded(noise),
            {n: t.rounded(noise) for n, t in terms.items()},
        )

    def __str__(self):
        unit = f" {self.unit}" if self.unit else ""
        terms = self.terms
        names = [f"{n}  {self.equation.terms.get(n, ('',))[0]}".rstrip() for n in terms]
        width = max(map(len, [*names, "sum"]))
        lines = [
            f"{self.equation.kind} {self.ledger.subject}, equation ({self.equation.number}), "
            f"components in {self.vector.frame.name}"
        ]
        for name, term in zip(names, terms.values(), strict=True):
            lines.append(f"  {name:<{width}}  [{', '.join(short(x) for x in term)}]{unit}")
        lines.append(f"  {'sum':<{width}}  [{', '.join(short(x) for x in self.vector)}]{unit}")
        return "\n".join(lines)

    __repr__ = __str__

    @property
    def latex(self):
        """The formula and the value of each term, as an align* environment."""
        subject = r"_{\text{" + self.ledger.subject.replace("_", r"\_") + "}}"
        unit = rf"\ \text{{{self.unit}}}" if self.unit else ""
        terms = self.terms
        formulas = [
            self.equation.terms[n][1]
            if n in self.equation.terms
            else _product(n, self.equation.symbol)
            for n in terms
        ]
        rows = [
            rf"{self.equation.symbol}{subject} &= {' + '.join(formulas)} "
            rf"\tag{{{self.equation.number}}}"
        ]
        for (name, term), formula in zip(terms.items(), formulas, strict=True):
            rows.append(rf"{formula} &= {term.latex()}{unit} && \text{{{name}}}")
        rows.append(
            rf"{self.equation.symbol}{subject} &= {self.vector.latex()}{unit} && \text{{sum}}"
        )
        return r"\begin{align*}" + r" \\ ".join(rows) + r"\end{align*}"

    def _repr_latex_(self):
        return self.latex

    def _repr_mimebundle_(self, **_):
        return {"text/plain": str(self), "text/latex": self.latex}


def _product(name, symbol):
    """LaTeX for a term named after frames: "arm" is the symbol's, "arm x rod" the cross product of
    two rates.
    """
    if " x " in name:
        return r"\times".join(
            rf"\boldsymbol{{\omega}}_{{\text{{{part}}}}}" for part in name.split(" x ")
        )
    return rf"{symbol}_{{\text{{{name}}}}}"


def latex_number(x, digits):
    """A number with so many digits, or an expression, as LaTeX."""
    if is_numeric(x) and not (hasattr(x, "shape") and x.shape):
        text = f"{float(x):.{digits}g}"
        mantissa, e, power = text.partition("e")
        return rf"{mantissa}\times10^{{{int(power)}}}" if e else mantissa
    try:
        import sympy

        body = sympy.latex(sympy.sympify(x))
    except Exception:  # heyoka, traced and array components have no LaTeX of their own
        body = r"\text{" + str(x)[:40].replace("_", r"\_") + "}"
    return body if body.replace("\\", "").isalnum() else rf"\left({body}\right)"


@dataclass(frozen=True, eq=False)
class Amount(NamedTerms):
    """An amount of work, energy or power with its terms by name: ``U.value``,
    ``T.terms["rotation"]``, ``T.explain()``.

    what, number : what it is, and its equation in the book
    error : estimated error of ``value`` where it comes from an integral, in the same unit
    It stands for its value in sums and products with numbers and with its like: ``float(U)``,
    ``T + V``, ``2*U``.
    """

    value: object
    terms: dict = field(default_factory=dict)
    what: str = "work"
    number: str = "11.1"
    error: float = 0.0

    __array_ufunc__ = None

    def __float__(self):
        return float(self.value)

    def __add__(self, other):
        return plain(scalar(self.value) + value_of(other))

    __radd__ = __add__

    def __neg__(self):
        return -self.value

    def __sub__(self, other):
        return plain(scalar(self.value) - value_of(other))

    def __rsub__(self, other):
        return plain(value_of(other) - scalar(self.value))

    def __mul__(self, other):
        return plain(scalar(self.value) * value_of(other))

    __rmul__ = __mul__

    def __truediv__(self, other):
        return plain(scalar(self.value) / value_of(other))

    def explain(self, unit="J"):
        """The sum in words: its equation in the book, each term, and their sum."""
        rows = [*self.terms.items(), ("sum", self.value)]
        width = max(len(name) for name, _ in rows)
        return "\n".join(
            [
                f"{self.what}, equation ({self.number})",
                *(f"  {name:<{width}}  {short(x)} {unit}" for name, x in rows),
            ]
        )

    def reweighted(self, **factors):
        """The sum of its terms, each times the factor named for it (others once): what a wrong
        model would give.

        >>> Amount(7.0, {"translation": 5.0, "rotation": 2.0}).reweighted(rotation=0)
        5.0
        """
        return plain(sum((factor * x for factor, x in self._weighted(factors, TermError)), ZERO))


def value_of(x):
    """The scalar that ``x``, an :class:`Amount` or a number, stands for."""
    return scalar(x.value if isinstance(x, Amount) else x)


def summed(terms, what="work", number="11.1", error=0.0):
    """The :class:`Amount` that is the sum of these terms, numbers by name."""
    terms = {n: value_of(x) for n, x in terms.items()}
    return Amount(
        plain(sum(terms.values(), ZERO)),
        {n: plain(x) for n, x in terms.items()},
        what,
        number,
        error,
    )
