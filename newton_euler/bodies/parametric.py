"""Bodies given by a formula: mass, centre of mass and inertia as integrals over curves, surfaces
and volumes (5.12), (5.13), (7.10).

Floats are integrated by SciPy's adaptive cubature, with an error estimate; arrays, mpf, dimensions
and traced numbers by Gauss rules; with symbols, or ``exact=True``, SymPy finds the formulas.
"""

from collections.abc import Callable
from functools import partial
from itertools import product

from ..algebra.errors import Accuracy, checked
from ..algebra.integrals import NEAR_MIDDLE, over_cube
from ..algebra.jets import Moving, as_moving
from ..algebra.late import is_here, np, sympy
from ..algebra.places import raised_by_the_caller
from ..algebra.quadrature import cubature
from ..algebra.scalars import (
    ZERO,
    Scalar,
    SingularError,
    Triple,
    epsilon,
    is_expression,
    is_numeric,
    is_positive,
    max_abs,
    scalar,
    sqrt,
    to_plain,
)
from ..algebra.vectors import cross3, dot3
from ..kinematics.frames import Frame, PointLike
from .admissibility import MassError, positive
from .body import Body
from .inertia import SECOND_MOMENTS, Inertia, from_second_moments


class IntegratedBody(Body):
    """A :class:`newton_euler.bodies.body.Body` found by integration.

    content : its length, area or volume
    error : estimated, of mass, first and second moments, relative to mass and size
    """

    content: Scalar = None
    error: float = 0.0


@checked
def integrated(
    position: Callable[..., Triple],
    *limits: tuple,
    frame: Frame,
    mass: Scalar = None,
    density: Scalar | Callable[..., Scalar] | None = None,
    exact: bool = False,
    rtol: Accuracy = 1e-10,
    name: str = "body",
) -> IntegratedBody:
    """The body of the points ``position(u)``, ``position(u, v)`` or ``position(u, v, w)``: a wire,
    a shell or plate, or a solid.

    position : function of the parameters that returns (x, y, z) in ``frame``, with functions of
        this package (sin, sqrt …)
    limits : for each parameter a pair (from, to), numbers or functions of the parameters before
    mass, density : the mass, or the density per length, area or volume, a number or a function of
        x, y, z; if both are given the density is relative
    exact : by SymPy, with symbols taken as positive; a parametrisation that folds back is refused
    rtol : required accuracy, :class:`MassError` if it is not reached; roots at the limits, as in y
        = -sqrt(r^2 - x^2), do no harm

    >>> from newton_euler import Frame, cos, sin
    >>> import math
    >>> half_disk = integrated(
    ...     lambda r, a: (r*cos(a), r*sin(a), 0), (0.0, 3.0), (0.0, math.pi),
    ...     frame=Frame("sheet"), density=1.0,
    ... )
    >>> round(half_disk.centre.position(half_disk.frame).y * math.pi, 9)  # 4 r/(3 pi)
    4.0
    """
    _check_given(limits, mass, density, name)
    weigh = density if callable(density) else lambda x, y, z: 1 if density is None else density
    middle = _middle(position, limits, weigh, name)
    kinds = {_kind(x) for x in middle}
    exact, numeric = exact or "symbols" in kinds, partial(_numeric, rtol=rtol)
    find = _exact if exact else numeric if kinds == {"floats"} else _of_any_kind
    reference, values, error = find(position, limits, weigh, name)
    content, total, first, second = values[0], values[1], values[2:5], values[5:]
    if is_numeric(total) and not is_positive(total):
        raise MassError(f"the mass of {name} is {total}, not positive: look at limits and density")
    factor = 1 if mass is None else scalar(mass) / total
    m = total * factor
    d = [x / total for x in first]
    place = [r + x for r, x in zip(reference, d, strict=True)]
    G = frame.point(f"G of {name}", *(sympy.cancel(x) if is_expression(x) else x for x in place))
    about: PointLike = frame
    # numbers go to G at once: their reference is near G, so that the subtraction cancels little
    if not exact:
        about = G
        second = [s - total * d[a] * d[b] for s, (a, b) in zip(second, SECOND_MOMENTS, strict=True)]
    moments, products = from_second_moments([factor * s for s in second])
    body = IntegratedBody(name, m, G, Inertia(about, moments, products, m, G, frame, None))
    body.content, body.error = content, error
    return body


def _check_given(limits, mass, density, name):
    if len(limits) not in (1, 2, 3):
        raise MassError(
            f"{name} has {len(limits)} parameters; a curve has one, a surface two, a volume three"
        )
    if mass is None and density is None:
        raise MassError(f"{name} needs mass=... or density=... (per length, area or volume)")
    if mass is not None:
        positive(mass, f"the mass of {name}")


def _tangents(position, parameters):
    """The position and its derivatives by each parameter, each a triple."""
    jets = [
        [as_moving(x) for x in position(*parameters[:n], Moving(u, 1), *parameters[n + 1 :])]
        for n, u in enumerate(parameters)
    ]
    return [x.value for x in jets[0]], [tuple(x.rate for x in c) for c in jets]


def _spanned(tangents):
    """The vector whose length is the content: a tangent, a cross or a triple product."""
    if len(tangents) == 3:
        return dot3(tangents[0], cross3(tangents[1], tangents[2]))
    return tangents[0] if len(tangents) == 1 else cross3(*tangents)


# -- kinds of number


def _middle(position, limits, weigh, name):
    """What is integrated, near the middle of the body; it has the kind of number of the body."""
    half = [NEAR_MIDDLE] * len(limits)
    try:
        place = position(*_parameters(limits, half)[0])
        middle = _moments(position, limits, weigh, (ZERO,) * 3, half)
    except SingularError as error:
        if raised_by_the_caller(error):
            raise
        raise MassError(
            f"{name} has points without a value: {error}; look at limits and divisions"
        ) from None
    if any(isinstance(x, Moving) for x in (*(x for pair in limits for x in pair), *place)):
        raise MassError(f"the points of {name} move: put in the values at the instant")
    return middle


def _kind(x):
    if is_expression(x):
        return "symbols"
    floats = is_numeric(x) and not getattr(x, "shape", ()) and epsilon(x) >= 2.0**-53
    return "floats" if floats else "others"


def _of_any_kind(position, limits, weigh, name):
    middle, _ = _parameters(limits, [0.5] * len(limits))
    reference = [scalar(x) for x in position(*middle)]
    try:
        moments = partial(_moments, position, limits, weigh, reference)
        values = over_cube(lambda *unit: moments(unit), len(limits))
    except SingularError as error:
        raise MassError(f"{name}: {error}") from None
    return reference, values, 0.0


# -- floats


# relative: Gauss's rules of two orders agree so far, and the one of the higher order is better
GAUSS = 1.5e-10


def _numeric(position, limits, weigh, name, rtol):
    if not is_here("scipy"):
        reference, values, _ = _of_any_kind(position, limits, weigh, name)
        return reference, [float(to_plain(x)) for x in values], GAUSS
    n = len(limits)
    with np.errstate(all="ignore"):  # _scales and cubature refuse values that are not finite
        middle, _ = _parameters(limits, [np.array([0.5])] * n)
        reference = [float(np.reshape(to_plain(x), -1)[0]) for x in _tangents(position, middle)[0]]

    def moments(points):
        with np.errstate(all="ignore"):
            rows = _moments(position, limits, weigh, reference, points.T)
        return np.stack([np.broadcast_to(row, len(points)) for row in rows], axis=-1).astype(float)

    coarse = np.array(list(product(np.linspace(0.05, 0.95, 10), repeat=n)))
    scale = _scales(moments(coarse), name)
    values, error = cubature(lambda points: moments(points) / scale, n, rtol, name, MassError)
    return reference, (values * scale).tolist(), error


def _parameters(limits, unit):
    """The parameters for t in (0, 1), by 3 t^2 - 2 t^3, whose rate vanishes at both ends, which
    makes roots at the limits smooth; and their step per step of t.
    """
    parameters, step = [], 1
    for (a, b), t in zip(limits, unit, strict=True):
        a, b = [limit(*parameters) if callable(limit) else limit for limit in (a, b)]
        step = step * abs(b - a) * (6 * t * (1 - t))
        parameters.append(a + (b - a) * (t * t * (3 - 2 * t)))
    return parameters, step


def _moments(position, limits, weigh, reference, unit):
    """Content, mass, three first and six second moments about the reference, per unit of t."""
    parameters, step = _parameters(limits, list(unit))
    place, tangents = _tangents(position, parameters)
    spanned = _spanned(tangents)
    dV = step * (abs(spanned) if len(limits) == 3 else sqrt(dot3(spanned, spanned)))
    dm = dV * scalar(weigh(*place))
    r = [p - q for p, q in zip(place, reference, strict=True)]
    return dV, dm, *(dm * x for x in r), *(dm * r[a] * r[b] for a, b in SECOND_MOMENTS)


def _scales(sample, name):
    """Rough content, mass, mass times length and mass times length squared, for relative errors."""

    if not np.isfinite(sample).all():
        raise MassError(
            f"{name} has points without a finite value; look at limits, divisions and roots"
        )
    content, mass, second = (np.abs(sample[:, columns]).mean() for columns in ([0], [1], [5, 6, 7]))
    if not content > 0 or not mass > 0:
        raise MassError(f"{name} has no extent: look at its parameters, limits and density")
    length = (second / mass) ** 0.5
    return np.array([content, mass] + [mass * length] * 3 + [mass * length**2] * 6)


# -- formulas


def _exact(position, limits, weigh, name):
    symbols = sympy.symbols(f"u0:{len(limits)}", real=True, cls=sympy.Dummy)
    bounds = [
        [sympy.sympify(x(*symbols[:n]) if callable(x) else x) for x in pair]
        for n, pair in enumerate(limits)
    ]
    place = [sympy.sympify(to_plain(scalar(x))) for x in position(*symbols)]
    dV = _exact_content([tuple(x.diff(u) for x in place) for u in symbols])
    dV *= _sense(dV, symbols, bounds, name)

    def total(f):
        f = sympy.expand(f * dV)
        for u, pair in reversed(list(zip(symbols, bounds, strict=True))):
            f = sympy.integrate(f, (u, *pair))
        if f.has(sympy.Integral):
            raise MassError(
                f"SymPy finds no formula for {name}: take other coordinates, or exact=False"
            )
        return f

    rho = sympy.sympify(weigh(*place))
    first, second = (rho * x for x in place), (rho * place[a] * place[b] for a, b in SECOND_MOMENTS)
    return (ZERO,) * 3, [total(f) for f in (1, rho, *first, *second)], 0.0


def _exact_content(tangents):
    """The content per unit of the parameters, up to its sign."""
    spanned = _spanned(tangents)
    if len(tangents) == 3:
        return sympy.trigsimp(sympy.expand(spanned))
    left = [c for c in spanned if c != 0]
    if len(left) <= 1:
        return sympy.trigsimp(left[0]) if left else sympy.Integer(0)
    root = sympy.sqrt(sympy.factor(sympy.trigsimp(sympy.expand(dot3(spanned, spanned)))))
    return root.replace(sympy.Abs, lambda x: x)


def _sense(dV, symbols, bounds, name):
    """The sign of the content, +1 or -1, from sample points and sample values of the symbols."""
    free = dV.free_symbols.union(*(x.free_symbols for pair in bounds for x in pair))
    others = sorted(free - set(symbols), key=str)
    # unequal fractions, so that no sample point lies on an axis or plane of symmetry
    given = {s: sympy.Rational(7 + 3 * n, 10 + n) for n, s in enumerate(others)}
    signs = set()
    for fractions in product((0.11, 0.37, 0.62, 0.93), repeat=len(symbols)):
        at = dict(given)
        for u, (a, b), t in zip(symbols, bounds, fractions, strict=True):
            low, high = a.subs(at), b.subs(at)
            at[u] = low + (high - low) * sympy.Float(t)
        value = float(dV.subs(at))
        if max_abs(value) > 0:
            signs.add(value > 0)
    if len(signs) != 1:
        raise MassError(
            f"{name} folds back on itself, or its points rest: divide it, or leave exact=True out"
        )
    return 1 if signs.pop() else -1
