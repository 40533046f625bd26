"""Sums that keep their terms by name: of vectors, and amounts of work and energy.

A result that theory writes as a sum has its ``terms`` by name; ``explain()`` writes the sum with
the number of its equation, and ``without("coriolis")`` is the sum of a model without this term.
"""

import itertools
import operator
import re
from collections import Counter
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from functools import cache
from types import MappingProxyType
from typing import Any, Generic, NoReturn, TypeVar

from . import scalars
from .names import Guided, did_you_mean, guided
from .pickles import Computed
from .scalars import ZERO, Scalar, clipped, real_scalar, scalar, short, short_repr, to_plain


class TermError(scalars.NewtonEulerError, ValueError, KeyError):
    """A sum does not have the term that is named."""

    __str__ = Exception.__str__  # KeyError.__str__ would add quotation marks


@dataclass(frozen=True, eq=False)
class Equation:
    """The equation of a sum with named terms.

    kind, number, symbol : what the sum is, as "acceleration"; its number in the book; in LaTeX
    unit : of the sum in SI, "" where it has none of its own
    terms : by name, a term as (text, LaTeX), for those whose name is not enough
    other : (text, LaTeX) of a term that is not listed; its name becomes the subscript

    >>> from newton_euler import Frame
    >>> ground = Frame("ground"); arm = ground.rotate("arm", "z", rate=2.0)
    >>> arm.point("P", 1.0, 0, 0).acceleration(ground).equation.number
    '4.18'
    """

    kind: str
    number: str
    symbol: str
    terms: dict
    other: tuple[str, str]
    unit: str = ""


@cache
def equation(kind: str) -> Equation:
    """The :class:`Equation` of this kind of sum, from ``equations.toml``."""
    import tomllib  # here, since few programs explain a sum
    from pathlib import Path

    with Path(__file__).with_name("equations.toml").open("rb") as file:
        row = tomllib.load(file)[kind]
    terms = {name: tuple(texts) for name, texts in row.get("terms", {}).items()}
    other = row.get("other", ("", f"{{{row['symbol']}}}"))  # braces: it may have a subscript
    return Equation(kind, row["number"], row["symbol"], terms, tuple(other), row.get("unit", ""))


T = TypeVar("T")
NOISE = 1e-14  # share of the largest component; anything smaller is round-off and printed as 0


class Crossed(str):
    """The name of the cross product of two terms, "arm x rod"; ``factors`` are their names."""

    factors: tuple[str, str]

    def __new__(cls, first: str, second: str) -> "Crossed":
        name = super().__new__(cls, f"{first} x {second}")
        name.factors = (first, second)
        return name

    def __reduce__(self):
        return Crossed, self.factors


class Chosen(str):
    """A name that a caller chose for a term: it is written by its name, even if a term of the
    equation is called so too.
    """

    __slots__ = ()


class Terms(Guided, dict[str, T], Generic[T]):
    """The terms of a sum, in order, by name. Names are for people: two terms may be called "arm".
    They are then listed as "arm 1" and "arm 2", and "arm" names both of them to ``without`` and
    ``reweighted``; ``terms["arm"]`` raises a :class:`TermError`.

    terms : a dict, or pairs (name, term), of which several may have the same name
    shared : the name that was given, by each name that was made distinct

    >>> terms = Terms([("arm", 1.0), ("arm", 2.0), ("rod", 4.0)])
    >>> terms, sum(terms.values())
    ({'arm 1': 1.0, 'arm 2': 2.0, 'rod': 4.0}, 7.0)
    """

    shared: Mapping[str, str] = MappingProxyType({})

    def __init__(self, terms: "Mapping[str, T] | Iterable[tuple[str, T]]" = ()):
        if isinstance(terms, dict):  # its names are distinct already
            super().__init__(terms)
            if isinstance(terms, Terms):
                self.shared = terms.shared
            return
        pairs = list(terms.items() if isinstance(terms, Mapping) else terms)
        given = [name for name, _ in pairs]
        names = distinct(given)
        super().__init__(zip(names, (term for _, term in pairs), strict=True))
        self.shared = {new: old for new, old in zip(names, given, strict=True) if new != old}

    def __missing__(self, name: str) -> NoReturn:
        if alike := [new for new, old in self.shared.items() if old == name]:
            raise TermError(f"{len(alike)} terms are named {name!r}; ask for one of {alike}")
        near = did_you_mean(name, self)
        listed = f"; the terms are {', '.join(self)}" if self else "; there are no terms"
        raise TermError(f"no term {name!r}{listed}{near}")

    def __or__(self, other: Mapping[str, T]) -> "Terms[T]":  # type: ignore[override]
        """The terms of both, in order: those whose names they share are all kept."""
        more = other if isinstance(other, Terms) else Terms(other)
        return Terms([*self.named(), *more.named()])

    def __ior__(self, other: Mapping[str, T]) -> "Terms[T]":  # type: ignore[override,misc]
        """As ``|``: a dict would replace a term of the same name."""
        return self | other

    def __ror__(self, other: Mapping[str, T]) -> "Terms[T]":  # type: ignore[override]
        return Terms(other) | self

    def update(self, other: Mapping[str, T]) -> None:  # type: ignore[override]
        """Add terms: ``|`` in place."""
        both = self | other
        self.clear()
        super().update(both)
        self.shared = both.shared

    def copy(self) -> "Terms[T]":
        """The same terms in another dict."""
        return Terms(self)

    def get(self, name: str, default: Any = None) -> Any:
        """The term of this name, or the ``default``."""
        return self[name] if name in self or name in self.shared.values() else default

    def named(self) -> Iterator[tuple[str, T]]:
        """Pairs (name as given, term)."""
        return ((self.shared.get(name, name), term) for name, term in self.items())

    def mapped(self, change: Callable[[T], T]) -> "Terms[T]":
        """The terms with ``change`` applied to each."""
        changed = Terms({name: change(term) for name, term in self.items()})
        if self.shared:
            changed.shared = self.shared
        return changed

    def weighted(self, factors: Mapping[str, Scalar]) -> list[tuple[Scalar, T]]:
        """Pairs (factor, term): the factor by the distinct name, else by the shared one, else 1."""
        for name in factors:
            if name not in self.shared.values():
                self[name]  # raises a TermError for an unknown name
        usual = {new: factors.get(old, 1) for new, old in self.shared.items()}
        return [(real_scalar(factors.get(n, usual.get(n, 1))), term) for n, term in self.items()]


def distinct(names: list[str]) -> list[str]:
    """The names, numbered where they occur several times; no result equals a name that was given.

    >>> distinct(["arm", "rod", "arm", "arm 1"])
    ['arm 2', 'rod', 'arm 3', 'arm 1']
    """
    if len(set(names)) == len(names):
        return names
    counts = Counter(names)
    numbers = {name: _free_numbers(name, counts) for name, n in counts.items() if n > 1}
    return [_numbered(name, next(numbers[name])) if name in numbers else name for name in names]


def _free_numbers(name, taken):
    return (n for n in itertools.count(1) if f"{name} {n}" not in taken)


def _numbered(name, n):
    if isinstance(name, Crossed):
        first, second = name.factors
        return Crossed(first, f"{second} {n}")
    return f"{name} {n}"


class NamedTerms:
    """Base of sums whose ``terms`` are known by name."""

    __slots__ = ()
    terms: Any
    reweighted: Any

    def without(self, *names: str) -> Scalar:
        """The sum without all terms of these names: ``a.without("coriolis")``."""
        for n in names:
            if not isinstance(n, str):
                raise TermError(f"a term is named by a text, as 'coriolis'; got {clipped(n)}")
        return self.reweighted(**dict.fromkeys(names, 0))


class Ledger:
    """The named terms of a sum, found when first asked for.

    kind : of the equation, see :func:`equation`
    subject : the things it is about, as "P/ground"
    make : a function that returns the terms, a dict or pairs (name, Vector); None for a vector that
        is not a sum, whose kind alone is known: its ledger is false
    scaled : whether the sum was multiplied, so that its unit is not that of the equation
    """

    __slots__ = ("_make", "_terms", "kind", "scaled", "subject")

    def __init__(self, kind: str, subject: str, make: Callable | None, scaled: bool = False):
        self.kind, self.subject, self._make, self.scaled = kind, subject, make, scaled
        self._terms: Terms | None = None

    def __bool__(self) -> bool:
        return self._make is not None

    def __reduce__(self):
        made = self._make and Computed(lambda: self.terms)
        return Ledger, (self.kind, self.subject, made, self.scaled)

    @property
    def equation(self) -> Equation:
        """The :class:`Equation` of this kind of sum."""
        return equation(self.kind)

    @property
    def terms(self) -> Terms:
        """The vectors by name."""
        if self._terms is None:
            made = self._make() if self._make else {}
            self._terms = made if isinstance(made, Terms) else Terms(made)
        return self._terms

    def mapped(self, change: Callable, scaled: bool = False) -> "Ledger | None":
        """The ledger with ``change`` applied to every term; None where nothing is known then."""
        if self._make is None:
            return None if scaled else self
        made = lambda: self.terms.mapped(change)  # noqa: E731
        return Ledger(self.kind, self.subject, made, scaled or self.scaled)

    @property
    def unit(self) -> str:
        """The SI unit of the sum, "" where it is not known."""
        return "" if self.scaled else self.equation.unit


@cache
def unlike(kind: str, other: str) -> bool:
    """True if sums by these two kinds of equations have different dimensions."""
    here, there = (_dimension(equation(k).unit) for k in (kind, other))
    return here is not None and there is not None and here != there


def _dimension(text):
    """The dimension of a unit, None if there is none or it is unknown."""
    from .units import UnitError
    from .units import unit as unit_of

    try:
        return unit_of(text).dimension
    except UnitError:
        return None


def _check_unit(text, what, own):
    """Raises :class:`TermError` for a unit that a sum in its ``own`` unit cannot have."""
    if not isinstance(text, str):
        raise TermError(f"the unit is a text, as 'm/s^2'; got {clipped(text)}")
    here, asked = _dimension(own), _dimension(text)
    if None not in (here, asked) and here != asked:
        raise TermError(f"this is the {what}, in {own}: it cannot be explained in {text!r}")


class Explanation:
    """A vector as a sum of terms: ``str()`` gives text, ``latex`` what Jupyter shows.

    >>> from newton_euler import Frame, moving
    >>> ground = Frame("ground"); arm = ground.rotate("arm", "z", rate=2.0)
    >>> print(arm.i.rate(ground).explain())
    rate arm/ground, equation (4.15), components in arm
      relative  dQ/dt      [0, 0, 0]
      rotation  omega x Q  [0, 2, 0]
      sum                  [0, 2, 0]
    """

    def __init__(self, vector: Any, ledger: Ledger, unit: str = ""):
        _check_unit(unit, f"{ledger.equation.kind} {ledger.subject}", ledger.unit)
        self.ledger, self.equation, self.unit = ledger, ledger.equation, unit
        terms = vector.terms.mapped(lambda t: t.expressed_in(vector.frame))
        noise = NOISE * scalars.largest_abs(x for t in (vector, *terms.values()) for x in t.c)
        self.vector = vector.rounded(noise)
        self.terms = terms.mapped(lambda t: t.rounded(noise))

    def __str__(self):
        unit = f" {self.unit}" if self.unit else ""
        names = [f"{self._label(n)}  {self._texts(n)[0]}".rstrip() for n in self.terms]
        rows = zip([*names, _sum_of(self.terms)], [*self.terms.values(), self.vector], strict=True)
        heading = (
            f"{self.equation.kind} {self.ledger.subject}, equation ({self.equation.number}), "
            f"components in {self.vector.frame.name}"
        )
        return in_columns(heading, [(n, f"[{', '.join(map(short, v))}]{unit}") for n, v in rows])

    __repr__ = __str__

    def _texts(self, name):
        """The (text, LaTeX) of a term of the equation, or that of any other."""
        own = self.terms.shared.get(name, name)
        known = {} if isinstance(own, Chosen) else self.equation.terms
        return known.get(own, self.equation.other)

    def _label(self, name):
        """The name of a term, with "minus" where the sum takes away what has the name."""
        other = self.equation.other
        return f"minus {name}" if self._texts(name) is other and other[0][:1] == "-" else name

    @property
    def latex(self) -> str:
        """The formula and the value of each term, as an align* environment."""
        symbol, other = self.equation.symbol, self.equation.other
        # braces, since a symbol such as M_B already has a subscript
        total = f"{{{symbol}}}" + f"_{{{latex_text(self.ledger.subject)}}}"
        unit = rf"\ \text{{{self.unit}}}" if self.unit else ""
        texts = {n: self._texts(n) for n in self.terms}
        formulas = [_product(n, x[1]) if x is other else x[1] for n, x in texts.items()]
        joined = " + ".join(formulas).replace(" + -", " - ")
        rows = [rf"{total} &= {joined} \tag{{{self.equation.number}}}"]
        names = [*map(self._label, self.terms), _sum_of(self.terms)]
        values = [*self.terms.values(), self.vector]
        for formula, name, v in zip([*formulas, total], names, values, strict=True):
            rows.append(rf"{formula} &= {v.latex()}{unit} && {latex_text(name)}")
        return r"\begin{align*}" + r" \\ ".join(rows) + r"\end{align*}"

    def _repr_mimebundle_(self, **_):
        return {"text/plain": str(self), "text/latex": self.latex}


def _sum_of(terms):
    """What a table of these terms calls their sum: "sum", or longer if a term is called so."""
    name = "sum"
    while name in terms:
        name += " of all"
    return name


def in_columns(heading: str, rows: Sequence[tuple[str, str]]) -> str:
    """A heading, and below it names and texts in two columns."""
    width = max(len(name) for name, _ in rows)
    return "\n".join([heading, *(f"  {name:<{width}}  {text}" for name, text in rows)])


def _product(name, symbol):
    """LaTeX of a term named after frames: "arm" is a subscript, two names make a cross product."""
    if not isinstance(name, Crossed):
        return rf"{symbol}_{{{latex_text(name)}}}"
    return r"\times".join(rf"\boldsymbol{{\omega}}_{{{latex_text(n)}}}" for n in name.factors)


def latex_text(words: str) -> str:
    """Words in a formula; there MathJax takes a bare _, # or & for an error, % for a comment."""
    return r"\text{" + re.sub("([_#&%])", r"\\\1", words) + "}"


def latex_number(x: Scalar, digits: int) -> str:
    """A number to ``digits`` digits, or an expression, as LaTeX."""
    if scalars.is_numeric(x) and not getattr(x, "shape", ()):
        mantissa, e, power = f"{float(x):.{digits}g}".partition("e")
        return rf"{mantissa}\times10^{{{int(power)}}}" if e else mantissa
    try:
        import sympy

        if scalars.operations(x) > scalars.LONGEST:
            return r"\text{" + short_repr(x).strip("<>") + "}"
        body = sympy.latex(sympy.sympify(x))
    except Exception:  # heyoka, traced and array components have no LaTeX of their own
        body = latex_text(str(x)[:40])
    return body if body.replace("\\", "").isalnum() else rf"\left({body}\right)"


_UNITS = {"work": "J", "kinetic energy": "J", "power": "W", "rate of kinetic energy": "W"}


def _operation(f):
    return lambda self, other: to_plain(f(scalar(self.value), value_of(other)))


def _comparison(f):
    return lambda self, other: f(
        self.value, to_plain(other.value if isinstance(other, Amount) else other)
    )


@guided
@dataclass(frozen=True, eq=False)
class Amount(NamedTerms):
    """An amount of work, energy or power with its terms by name. It acts as its ``value`` in sums,
    products and comparisons, and in ``float(U)``.

    what, number : the name of the quantity, and its equation in the book
    error : estimated error of ``value`` where it comes from an integral, in the same unit

    >>> T, V = Amount(7.0, {"translation": 5.0, "rotation": 2.0}), Amount(3.0)
    >>> T + V, 2 * T, T > V, T == 7.0
    (10.0, 14.0, True, True)
    """

    value: Scalar
    terms: Terms = field(default_factory=Terms)
    what: str = "work"
    number: str = "11.1"
    error: float = 0.0

    __array_ufunc__ = None

    def __post_init__(self):
        if not isinstance(self.terms, Terms):
            object.__setattr__(self, "terms", Terms(self.terms))

    def __repr__(self):
        terms = ", ".join(f"{n!r}: {short_repr(x)}" for n, x in self.terms.items())
        return (
            f"Amount(value={short_repr(self.value)}, terms={{{terms}}}, what={self.what!r}, "
            f"number={self.number!r}, error={self.error!r})"
        )

    def __float__(self) -> float:
        return float(self.value)

    def __neg__(self) -> Scalar:
        return -self.value

    __add__ = __radd__ = _operation(operator.add)
    __sub__ = _operation(operator.sub)
    __rsub__ = _operation(lambda a, b: b - a)
    __mul__ = __rmul__ = _operation(operator.mul)
    __truediv__ = _operation(operator.truediv)
    __eq__, __lt__, __le__, __gt__, __ge__ = map(
        _comparison, (operator.eq, operator.lt, operator.le, operator.gt, operator.ge)
    )

    def explain(self, unit: str = "") -> str:
        """The equation, terms and sum as a text, in this ``unit`` (default: J; W of a power)."""
        own = _UNITS.get(self.what, "")
        _check_unit(unit, self.what, own)
        unit = unit or own or "J"
        values = {**self.terms, _sum_of(self.terms): self.value}
        rows = [(n, f"{short(x)} {unit}") for n, x in values.items()]
        return in_columns(f"{self.what}, equation ({self.number})", rows)

    @scalars.in_range
    def reweighted(self, /, **factors: Scalar) -> Scalar:
        """The sum of its terms, each times the factor named for it (others once).

        >>> Amount(7.0, {"translation": 5.0, "rotation": 2.0}).reweighted(rotation=0)
        5.0
        """
        terms = self.terms.weighted(factors)
        return to_plain(sum((factor * x for factor, x in terms), ZERO) if terms else self.value)


def value_of(x: "Amount | Scalar") -> Any:
    """The value of ``x``, an :class:`Amount` or a number, as a scalar."""
    return real_scalar(x.value if isinstance(x, Amount) else x)


def summed(
    terms: Mapping[str, Any] | Iterable[tuple[str, Any]],
    what: str = "work",
    number: str = "11.1",
    error: float = 0.0,
) -> Amount:
    """The :class:`Amount` that is the sum of numbers or amounts, by name or in pairs (name, x)."""
    parts = Terms(terms).mapped(value_of)
    total = to_plain(sum(parts.values(), ZERO))
    return Amount(total, parts.mapped(to_plain), what, number, error)
