"""Forms in which students hand in right answers: {name: a function of the right answer}."""

import array
import collections
from decimal import Decimal
from fractions import Fraction

import mpmath
import numpy as np
import scipy.sparse
import sympy
from sympy.polys.polyerrors import BasePolynomialError

from newton_euler import Frame, moving

try:
    import symengine
except ImportError:
    symengine = None
try:
    import pandas
except ImportError:
    pandas = None

I, PI = sympy.I, sympy.pi
t, k = sympy.symbols("t_ k_")  # symbols that no problem has
GROUND = Frame("ground")
ARM = GROUND.rotate("arm", "z", angle=0.7, rate=1.1)
ROD = ARM.rotate("rod", "-x", angle=2.1, rate=0.4)
LONE = Frame("lone")


def significant(digits):
    return lambda x: float(f"{x:.{digits}g}")


# -- one number, from a float

NUMBERS = {
    "float": lambda x: x,
    "float64": np.float64,
    "float32": np.float32,
    "longdouble": np.longdouble,
    "complex": lambda x: complex(x, 0),
    "complex128": lambda x: np.complex128(x),
    "complex64": lambda x: np.complex64(x),
    "complex with round-off": lambda x: complex(x, 1e-16 * x),
    "mpf": mpmath.mpf,
    "mpc": lambda x: mpmath.mpc(x, 0),
    "interval-free mpf of 50 digits": lambda x: mpmath.mpf(repr(x)) * 1,
    "Fraction": Fraction,
    "Decimal": lambda x: Decimal(repr(x)),
    "SymPy Float": sympy.Float,
    "SymPy Float of 30 digits": lambda x: sympy.Float(repr(x), 30),
    "SymPy Rational": lambda x: sympy.Rational(repr(x)),
    "SymPy nsimplified": lambda x: sympy.nsimplify(x, rational=True),
    "SymPy product": lambda x: sympy.Mul(x, sympy.sqrt(4), sympy.Rational(1, 2), evaluate=False),
    "SymPy with pi": lambda x: PI * sympy.Float(x) / PI,
    "SymPy integral": lambda x: sympy.Integral(2 * x * t, (t, 0, 1)),
    "SymPy derivative": lambda x: sympy.Subs(sympy.Derivative(x * t**2 / 2, t), t, 1),
    "SymPy sum": lambda x: sympy.Sum(x * k / 10, (k, 1, 4)),
    "SymPy substitution": lambda x: sympy.Subs(x * t, t, 1),
    "SymPy Piecewise": lambda x: sympy.Piecewise((x, sympy.pi > 3), (0, True)),
    "SymPy Max": lambda x: sympy.Max(x, x - 1),
    "SymPy sign": lambda x: sympy.sign(x) * sympy.Abs(x),
    "SymPy exponentials of i": lambda x: x * sympy.exp(I * PI / 5) * sympy.exp(-I * PI / 5),
    "SymPy cosine by exponentials": lambda x: (
        x * (sympy.cos(PI / 7).rewrite(sympy.exp) / sympy.cos(PI / 7))
    ),
    "SymPy unevaluated": lambda x: sympy.UnevaluatedExpr(sympy.Float(x)),
    "SymPy with I*I": lambda x: -x * I * I,
    "array of no axis": np.array,
    "array of one": lambda x: np.array([x]),
    "array of one by one": lambda x: np.array([[x]]),
    "matrix of one": lambda x: np.matrix([[x]]),
    "object array": lambda x: np.array([sympy.Float(x)], dtype=object),
    "object array of no axis": lambda x: np.array(sympy.Float(x), dtype=object),
    "masked array": lambda x: np.ma.array([x]),
    "SymPy matrix": lambda x: sympy.Matrix([x]),
    "list": lambda x: [x],
    "tuple": lambda x: (x,),
    "iterator": lambda x: iter([x]),
    "moving": lambda x: moving(x, rate=3.0),
    "moving with acceleration": lambda x: moving(x, rate=3.0, acceleration=-1.0),
    "three figures": significant(3),
}


# -- a vector, from three floats


def _vector_in(frame):
    return lambda v: GROUND.vector(*v).expressed_in(frame)


CONTAINERS = {
    "list": list,
    "tuple": tuple,
    "array": np.array,
    "column": lambda v: np.array([[x] for x in v]),
    "row": lambda v: np.array([list(v)]),
    "matrix row": lambda v: np.matrix([list(v)]),
    "matrix column": lambda v: np.matrix([list(v)]).T,
    "object array": lambda v: np.array(list(v), dtype=object),
    "list of arrays": lambda v: [np.array(x) for x in v],
    "list of lists": lambda v: [[x] for x in v],
    "iterator": iter,
    "generator": lambda v: (x for x in v),
    "map": lambda v: map(sympy.sympify, v),
    "values of a dict": lambda v: dict(zip("xyz", v, strict=True)).values(),
    "deque": collections.deque,
    "named tuple": lambda v: collections.namedtuple("V", "x y z")(*v),
    "SymPy column": sympy.Matrix,
    "SymPy row": lambda v: sympy.Matrix([list(v)]),
    "SymPy immutable": sympy.ImmutableMatrix,
    "SymPy Array": sympy.Array,
    "SymPy Tuple": lambda v: sympy.Tuple(*v),
    "SymPy product of matrices": lambda v: sympy.MatMul(
        sympy.eye(3), sympy.Matrix(v), evaluate=False
    ),
    "SymPy sum of matrices": lambda v: sympy.MatAdd(
        sympy.Matrix(v), sympy.zeros(3, 1), evaluate=False
    ),
    "SymPy transposed": lambda v: sympy.Transpose(sympy.ImmutableMatrix([list(v)])),
    "Vector": lambda v: GROUND.vector(*v),
    "Vector of a lone frame": lambda v: LONE.vector(*v),
    "sum of unit Vectors": lambda v: v[0] * GROUND.i + v[1] * GROUND.j + v[2] * GROUND.k,
    "position of a Point": lambda v: GROUND.point("P", *v).position(GROUND),
}

VECTORS = {
    **CONTAINERS,
    "array of float32": lambda v: np.array(v, dtype=np.float32),
    "array of longdouble": lambda v: np.array(v, dtype=np.longdouble),
    "complex array": lambda v: np.array(v, dtype=complex),
    "complex array with round-off": lambda v: np.array(v) * (1 + 1e-16j),
    "Fortran order": lambda v: np.asfortranarray([list(v)]),
    "view of an array": lambda v: np.repeat(v, 2)[::2],
    "masked array": lambda v: np.ma.array(v, mask=[0, 0, 0]),
    "array.array": lambda v: array.array("d", v),
    "memoryview": lambda v: memoryview(array.array("d", v)),
    "sparse matrix": lambda v: scipy.sparse.csr_matrix(np.array([v])),
    "sparse array": lambda v: scipy.sparse.coo_array(np.array([v])),
    "mpmath matrix": mpmath.matrix,
    "mpmath row": lambda v: mpmath.matrix([list(v)]),
    "turned Vector": _vector_in(ARM),
    "twice turned Vector": _vector_in(ROD),
    "Vector of mixed frames": lambda v: _vector_in(ARM)(v) / 2 + _vector_in(ROD)(v) / 2,
    "moving Vector": lambda v: GROUND.vector(*(moving(x, rate=1.0) for x in v)),
    "turned moving Vector": lambda v: GROUND.vector(*(moving(x, rate=1.0) for x in v)).expressed_in(
        ARM
    ),
    "half floats": lambda v: [v[0], np.float32(v[1]), mpmath.mpf(v[2])],
    "arrays of one": lambda v: [np.array([x]) for x in v],
    "a nested tuple": lambda v: ((v[0],), (v[1], v[2])),
    "three figures": lambda v: [significant(3)(x) for x in v],
    **{
        f"{container} of {name}": (lambda c, n: lambda v: c([n(x) for x in v]))(
            CONTAINERS[container], NUMBERS[name]
        )
        for container in ("list", "object array", "SymPy column")
        for name in ("SymPy Float", "SymPy Rational", "SymPy integral", "SymPy Max", "SymPy sum",
                     "SymPy exponentials of i", "SymPy Piecewise", "SymPy sign")
    },
    **{
        f"list of {name}": (lambda n: lambda v: [n(x) for x in v])(NUMBERS[name])
        for name in ("Fraction", "Decimal", "mpf", "mpc", "complex", "complex64", "float32",
                     "moving", "array of no axis", "object array of no axis", "SymPy unevaluated")
    },
}  # fmt: skip

if pandas:
    NUMBERS["pandas cell"] = lambda x: pandas.DataFrame({"a": [x]})["a"].iloc[0]
    VECTORS |= {
        "pandas Series": lambda v: pandas.Series(v),
        "DataFrame column": lambda v: pandas.DataFrame({"a": v})["a"],
        "DataFrame": lambda v: pandas.DataFrame({"a": v}),
        "DataFrame row": lambda v: pandas.DataFrame([v]).iloc[0],
        "pandas Index": lambda v: pandas.Index(v),
    }


def _poly(e, *symbols):
    """As a Poly; unchanged where it is not one but has a root or quotient of its symbols."""
    try:
        return sympy.Poly(e, *symbols)
    except (BasePolynomialError, KeyError):
        return e


# -- formulas, from an expression and a symbol in it (all symbols are positive where compared)

FORMULAS = {
    "as it is": lambda e, s: e,
    "expanded": lambda e, s: sympy.expand(e),
    "expanded in angles": lambda e, s: sympy.expand_trig(e),
    "together": lambda e, s: sympy.together(e),
    "factored": lambda e, s: sympy.factor(e),
    "collected": lambda e, s: sympy.collect(sympy.expand(e), s),
    "powers joined": lambda e, s: sympy.powsimp(e),
    "by exponentials of i": lambda e, s: e.rewrite(sympy.exp),
    "by cosines": lambda e, s: e.rewrite(sympy.cos),
    "by sines": lambda e, s: e.rewrite(sympy.sin),
    "by half angles": lambda e, s: e.rewrite(sympy.tan),
    "by cotangents": lambda e, s: e.rewrite(sympy.cot),
    "by secants": lambda e, s: e.rewrite(sympy.sec),
    "by cosecants": lambda e, s: e.rewrite(sympy.csc),
    "by sinc": lambda e, s: e.rewrite(sympy.sinc),
    "in floats": lambda e, s: sympy.N(e),
    "in floats of six digits": lambda e, s: sympy.N(e, 6),
    "in rationals": lambda e, s: sympy.nsimplify(e),
    "times 1.0": lambda e, s: 1.0 * e,
    "plus 0.0": lambda e, s: e + 0.0,
    "with 3.1416 for pi": lambda e, s: e * PI / 3.1416,
    "with 0.33333 for 1/3": lambda e, s: e * 3 * 0.33333,
    "symbols without assumptions": lambda e, s: e.xreplace(
        {x: sympy.Symbol(x.name) for x in e.free_symbols}
    ),
    "positive symbols": lambda e, s: e.xreplace(
        {x: sympy.Symbol(x.name, positive=True) for x in e.free_symbols}
    ),
    "sine and cosine squared": lambda e, s: e * (sympy.sin(s) ** 2 + sympy.cos(s) ** 2),
    "sech cosh": lambda e, s: e * sympy.sech(s) * sympy.cosh(s),
    "csch sinh": lambda e, s: e * sympy.csch(s) * sympy.sinh(s),
    "coth tanh": lambda e, s: e * sympy.coth(s) * sympy.tanh(s),
    "acot": lambda e, s: e * sympy.acot(1 / s) / sympy.atan(s),
    "acot of a cotangent": lambda e, s: e * sympy.acot(sympy.cot(s / 2)) / (s / 2),
    "asec": lambda e, s: e * sympy.asec(1 / sympy.cos(s)) / s,
    "acsc": lambda e, s: e * sympy.acsc(1 / sympy.sin(s / 2)) / (s / 2),
    "asinh": lambda e, s: e * sympy.asinh(sympy.sinh(s)) / s,
    "acosh": lambda e, s: e * sympy.acosh(1 + s) / sympy.log(1 + s + sympy.sqrt(s) * sympy.sqrt(s + 2)),
    "atanh": lambda e, s: e * sympy.atanh(sympy.tanh(s)) / s,
    "acoth": lambda e, s: e * sympy.acoth(1 + s) / (sympy.log((2 + s) / s) / 2),
    "atan2": lambda e, s: e * sympy.atan2(s, 1) / sympy.atan(s),
    "sign of a symbol": lambda e, s: e * sympy.sign(s),
    "sign of a negative": lambda e, s: -e * sympy.sign(-s * 2),
    "absolute value of a symbol": lambda e, s: e * sympy.Abs(s) / s,
    "root of a square": lambda e, s: e * sympy.sqrt(s**2) / s,
    "sign and size": lambda e, s: sympy.sign(e) * sympy.Abs(e),
    "Heaviside": lambda e, s: e * sympy.Heaviside(s),
    "Max": lambda e, s: sympy.Max(e, e - s),
    "Max of three": lambda e, s: sympy.Max(e - 1, e, e - s),
    "Min": lambda e, s: sympy.Min(e, e + s),
    "Max of a symbol and zero": lambda e, s: e * sympy.Max(s, 0) / s,
    "Piecewise": lambda e, s: sympy.Piecewise((e, s > 0), (0, True)),
    "Piecewise turned round": lambda e, s: sympy.Piecewise((0, s < 0), (e, True)),
    "Piecewise of three": lambda e, s: sympy.Piecewise((0, s < 0), (e, s < 100), (1, True)),
    "Piecewise with And": lambda e, s: sympy.Piecewise((e, (s > 0) & (s <= 100)), (0, True)),
    "Piecewise with Or": lambda e, s: sympy.Piecewise((0, (s < 0) | (s >= 100)), (e, True)),
    "Piecewise with Ne": lambda e, s: sympy.Piecewise((e, sympy.Ne(s, 0)), (0, True)),
    "Piecewise with Eq": lambda e, s: sympy.Piecewise((0, sympy.Eq(s, 0)), (e, True)),
    "Piecewise without a last case": lambda e, s: sympy.Piecewise((e, s > 0)),
    "unevaluated derivative": lambda e, s: sympy.Derivative(e * t, t),
    "derivative by a symbol": lambda e, s: e * sympy.Derivative(s**2, s) / (2 * s),
    "derivative substituted": lambda e, s: sympy.Subs(sympy.Derivative(e * t**2 / 2, t), t, 1),
    "unevaluated integral": lambda e, s: sympy.Integral(e, (t, 0, 1)),
    "integral in a factor": lambda e, s: e * sympy.Integral(2 * t, (t, 0, s)) / s**2,
    "unevaluated sum": lambda e, s: sympy.Sum(e * k / 10, (k, 1, 4)),
    "unevaluated product": lambda e, s: e * sympy.Product(k, (k, 1, 4)) / 24,
    "unevaluated substitution": lambda e, s: sympy.Subs(e * t, t, 1),
    "unevaluated limit": lambda e, s: sympy.Limit(e * t, t, 1),
    "UnevaluatedExpr": lambda e, s: sympy.UnevaluatedExpr(e),
    "UnevaluatedExpr in a factor": lambda e, s: e * sympy.UnevaluatedExpr(s) / s,
    "unevaluated Mul": lambda e, s: sympy.Mul(e, s, 1 / s, evaluate=False),
    "unevaluated Add": lambda e, s: sympy.Add(e, e, -e, evaluate=False),
    "unevaluated Pow": lambda e, s: sympy.Pow(e, 1, evaluate=False),
    "Poly": lambda e, s: _poly(e, *e.free_symbols),
    "Poly in one symbol": lambda e, s: _poly(e, s),
    "turned by i and back": lambda e, s: e * sympy.exp(I * s) * sympy.exp(-I * s),
    "real part of a rotation": lambda e, s: e
    * (sympy.exp(I * s) + sympy.exp(-I * s))
    / (2 * sympy.cos(s)),
    "imaginary part of a rotation": lambda e, s: e
    * (sympy.exp(I * s) - sympy.exp(-I * s))
    / (2 * I * sympy.sin(s)),
    "minus i squared": lambda e, s: sympy.Mul(-1, e, I, I, evaluate=False),
    "real part": lambda e, s: sympy.re(e + I * s, evaluate=False),
    "conjugate": lambda e, s: sympy.conjugate(e, evaluate=False),
    "exp of log": lambda e, s: e * sympy.exp(sympy.log(s)) / s,
    "log of exp": lambda e, s: e * sympy.log(sympy.exp(s)) / s,
    "cube root": lambda e, s: e * sympy.cbrt(s) ** 3 / s,
    "determinant": lambda e, s: sympy.Determinant(sympy.Matrix([[e, 0], [s, 1]])),
    "trace": lambda e, s: sympy.Trace(sympy.Matrix([[e, 0], [s, 0]])),
    "list of one": lambda e, s: [e],
    "SymPy matrix of one": lambda e, s: sympy.Matrix([e]),
    "object array of one": lambda e, s: np.array([e]),
    "object array of no axis": lambda e, s: np.array(e),
    "moving": lambda e, s: moving(e, rate=s),
}  # fmt: skip
if symengine:
    FORMULAS["SymEngine"] = lambda e, s: symengine.sympify(e)

# -- vectors of formulas, from three expressions and a symbol

VECTORS_OF_FORMULAS = {
    **{
        f"list, {name}": (lambda f: lambda v, s: [f(e, s) for e in v])(form)
        for name, form in FORMULAS.items()
    },
    **{
        f"{name} of formulas": (lambda c: lambda v, s: c(v))(container)
        for name, container in CONTAINERS.items()
    },
    "matrix expanded": lambda v, s: sympy.Matrix(v).expand(),
    "matrix differentiated": lambda v, s: (sympy.Matrix(v) * t).diff(t),
    "matrix with an unevaluated derivative": lambda v, s: sympy.Derivative(sympy.Matrix(v) * t, t),
    "matrix times a scalar": lambda v, s: s * (sympy.Matrix(v) / s),
    "array times a scalar": lambda v, s: s * (np.array(v) / s),
    "cross product of matrices": lambda v, s: (
        sympy.Matrix([1, 0, 0]).cross(sympy.Matrix([0, v[2], -v[1]])) + sympy.Matrix([v[0], 0, 0])
    ),
    "turned Vector": lambda v, s: GROUND.vector(*v).expressed_in(
        GROUND.rotate("arm", "z", angle=s, rate=1)
    ),
    "moving Vector": lambda v, s: GROUND.vector(*(moving(e, rate=s) for e in v)),
    "turned array": lambda v, s: sympy.rot_axis3(s).T * (sympy.rot_axis3(s) * sympy.Matrix(v)),
}
