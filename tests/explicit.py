"""An oracle: a motion written out in rectangular coordinates, differentiated by SymPy, and
evaluated in any kind of number.

v = explicit(about_z, 1)
v(kind, (r, theta, z), (r', theta', z'), (r'', theta'', z''))  # the three rectangular components
"""

import functools

import sympy

from newton_euler import cos, sin
from tests.kinds import numbers

_MODULES = {"float": "numpy", "array": "numpy", "mpmath": "mpmath"}


@functools.cache
def _formulas(position, order):
    t = sympy.Symbol("t")
    q, rates, second = (sympy.symbols(f"{letter}1:4") for letter in "qde")
    at_t = [x + d * t + e * t**2 / 2 for x, d, e in zip(q, rates, second, strict=True)]
    derivatives = [sympy.diff(sympy.sympify(x), t, order).subs(t, 0) for x in position(*at_t)]
    made = lambda module: sympy.lambdify([q, rates, second], derivatives, module, cse=True)
    values = lambda x: dict(zip((*q, *rates, *second), (*x[0], *x[1], *x[2]), strict=True))
    formulas = {kind: made(module) for kind, module in _MODULES.items()}
    return formulas | {"sympy": lambda *x: [d.subs(values(x)) for d in derivatives]}


def explicit(position, order):
    """A derivative of the position as a function of kind, coordinates, first and second rates."""

    def evaluated(kind, q, rates, second):
        return tuple(_formulas(position, order)[kind](q, rates, second))

    return evaluated


def about_z(r, theta, z):
    """The place of cylindrical coordinates, of any kind."""
    return r * cos(theta), r * sin(theta), z


def in_space(R, theta, phi):
    """The place of spherical coordinates, of any kind."""
    return R * cos(phi) * cos(theta), R * cos(phi) * sin(theta), R * sin(phi)


def motion(kind):
    """Coordinates, rates and second rates, all different and none small."""
    rows = ("1.3", "0.7", "0.4"), ("0.5", "-0.9", "1.1"), ("0.3", "0.8", "-0.6")
    return [numbers(kind, *row) for row in rows]


def by_scipy(model, start, end, **options):
    """SciPy's solution of the model from its start, without rounding to speak of."""
    from scipy.integrate import solve_ivp

    rhs = model.compiled_rhs()
    options = {"rtol": 1e-12, "atol": 1e-13} | options
    return solve_ivp(lambda t, y: rhs(t, *y.tolist()), (0.0, end), start, "DOP853", **options)


def integrated(model, start, end):
    """States by name as functions of time, by SciPy in short steps."""
    run = by_scipy(model, start, end, max_step=0.05, dense_output=True)
    return lambda t: dict(zip(model.states, run.sol(t).tolist(), strict=True))


def curve(kind):
    """A plane curve with its first and second derivative written out by hand, and the instant."""
    a, t = numbers(kind, "0.3", "0.7")
    return (
        lambda t: (t * t, a * t**3 + t, 0), lambda t: (2 * t, 3 * a * t**2 + 1, 0), lambda t: (2, 6 * a * t, 0), t,
    )  # fmt: skip
