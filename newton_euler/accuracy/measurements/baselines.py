"""Textbook methods, numerically poor on purpose, those of the engine, and exact results."""

import math
from collections.abc import Callable, Sequence
from functools import cache, partial, reduce, wraps
from itertools import repeat
from operator import mul

from ...algebra.compile import compiled
from ...algebra.jets import moving
from ...algebra.late import Rotation, np
from ...algebra.late import mpmath as mp
from ...algebra.scalars import Rows, Scalar, Triple, cos, sin, sqrt
from ...applications.gyroscopes import steady_precession
from ...bodies.body import composite
from ...bodies.parametric import integrated
from ...bodies.solids import half_disk, simplex
from ...kinematics import rotations
from ...kinematics.frames import Frame
from ...kinematics.paths import Path
from ...kinematics.rotations import Matrix
from .measure import relative_error

DIGITS = 40  # digits of the references


def _in_digits(f):
    """The function that computes ``f`` in 40 digits, once for each set of arguments."""

    @cache
    @wraps(f)
    def found(*arguments):
        with mp.workdps(DIGITS):
            return f(*arguments)

    return found


# -- derivatives

INSTANT = 1.3  # s
# first and second differences: (steps away, weight)
FORWARD, CENTRAL = ((0, -1), (1, 1)), ((-1, -0.5), (1, 0.5))
FORWARD_SECOND, CENTRAL_SECOND = ((0, 1), (1, -2), (2, 1)), ((-1, 1), (0, -2), (1, 1))


def boom_end(t: Scalar) -> Triple:
    """The position (x, y, z), m, of the end of a boom that turns, rises and lengthens, at t (s)."""
    length, elevation, turned = 20 + 3 * sin(2 * t), 0.5 + 0.3 * cos(3 * t), 0.4 * t * t
    across = length * cos(elevation)
    return across * cos(turned), across * sin(turned), length * sin(elevation)


def difference(
    f: Path, t: Scalar, h: Scalar, weights: Sequence[tuple[int, float]], order: int
) -> tuple[Scalar, ...]:
    """The difference quotient of f(t), several numbers: sum of weight f(t + n h), over h^order."""
    values = [[weight * x for x in f(t + n * h)] for n, weight in weights]
    return tuple(sum(column) / h**order for column in zip(*values, strict=True))


def complex_step(f: Path, t: float, h: float) -> tuple[float, ...]:
    """f'(t) as Im f(t + i h)/h: no difference, hence no cancellation (Squire and Trapp 1998)."""
    return tuple(x.imag / h for x in f(t + 1j * h))


def complex_step_second(f: Path, t: float, h: float) -> tuple[float, ...]:
    """f''(t) as 2 (f(t) - Re f(t + i h))/h^2, a difference with cancellation."""
    return tuple(2 * (x - z.real) / (h * h) for x, z in zip(f(t), f(t + 1j * h), strict=True))


def _derivatives(order, forward, central, by_complex_step, rate):
    def engine(t):
        # the position at a time that carries its rates
        return tuple(getattr(x, rate) for x in boom_end(moving(t, rate=1.0)))

    traced = compiled(engine)
    methods = {
        "forward difference": lambda h: difference(boom_end, INSTANT, h, forward, order),
        "central difference": lambda h: difference(boom_end, INSTANT, h, central, order),
        "complex step": lambda h: by_complex_step(boom_end, INSTANT, h),
        "engine, no step": lambda h: engine(INSTANT),
        "engine, traced": lambda h: traced(INSTANT),
    }
    return methods, lambda found, h: relative_error(found, _derivative(order))


# pairs, as PASSES, INERTIAS, ANGLES and PRECESSIONS: the methods, functions of the setting, and
# the error of a result
VELOCITIES = _derivatives(1, FORWARD, CENTRAL, complex_step, "rate")
ACCELERATIONS = _derivatives(2, FORWARD_SECOND, CENTRAL_SECOND, complex_step_second, "acceleration")


@_in_digits
def _derivative(order):
    return tuple(mp.diff(lambda t, n=n: boom_end(t)[n], mp.mpf(INSTANT), order) for n in range(3))


# -- products of rotations

AXIS, SMALL = (0.36, 0.48, 0.8), 0.01


@_in_digits
def _rotation(axis, angle, times=1):
    """The matrix of a rotation, repeated ``times`` times, by the exponential series."""
    x, y, z = (mp.mpf(c) / mp.norm(list(axis)) for c in axis)
    return mp.expm(mp.matrix([[0, -z, y], [z, 0, -x], [-y, x, 0]]) * mp.mpf(angle) * times)


def _matrix_error(R, exact):
    """The Frobenius norm of R - exact, relative to that of a rotation, sqrt(3)."""
    return math.sqrt(sum(float(R[n][m] - exact[n, m]) ** 2 for n in range(3) for m in range(3)) / 3)


MATRIX, QUATERNION = rotations.rotation_matrix(AXIS, SMALL), rotations.quaternion(AXIS, SMALL)


def by_quaternions(n: int) -> Rows:
    """n small rotations as a product of quaternions, normalised at the end."""
    product = reduce(rotations.quaternion_product, repeat(QUATERNION, n))
    return rotations.matrix_from_quaternion(product)


def by_scipy(n: int) -> list[list[float]]:
    """The same as a product of SciPy's rotations."""
    q0, *v = QUATERNION
    return reduce(mul, repeat(Rotation.from_quat([*v, q0]), n)).as_matrix().tolist()


def by_euler_angles(n: int) -> Rows:
    """The same with Euler angles 3-1-3 after each rotation."""
    angles = rotations.euler_from_quaternion(QUATERNION)
    for _ in range(n - 1):
        q = rotations.quaternion_product(rotations.quaternion_from_euler(*angles), QUATERNION)
        angles = rotations.euler_from_quaternion(q)
    return rotations.euler_matrix(*angles)


TURNS = {
    "3 x 3 matrices": lambda n: reduce(rotations.product, repeat(MATRIX, n)),
    "matrices, NumPy": lambda n: reduce(np.matmul, repeat(np.array(MATRIX), n)),
    "Euler angles": by_euler_angles,
    "quaternions": by_quaternions,
    "SciPy's Rotation": by_scipy,
}


def turn_error(R: Matrix, n: int) -> float:
    """The relative error of the attitude after n small rotations."""
    return _matrix_error(R, _rotation(AXIS, SMALL, n))


def drift(R: Matrix, n: int | None = None) -> float:
    """The largest entry of R^T R - 1, which is zero for a rotation."""
    gram = rotations.product(rotations.transpose(R), R)
    return max(abs(float(gram[n][m]) - (n == m)) for n in range(3) for m in range(3))


# -- near the singularity of Euler's angles: a body turns about the x axis at 1 rad/s; at t = 0 its
# z axis has its least angle to the vertical

STEPS, BEFORE, AFTER = 200, -0.9, 1.1  # s; a step ends at t = 0


def runge_kutta(rate: Callable[[Triple], Triple], s: Triple, step: float, steps: int) -> Triple:
    """The state after ``steps`` steps of the classical Runge-Kutta method for ds/dt = rate(s)."""

    def moved(by, k):
        return tuple(x + by * d for x, d in zip(s, k, strict=True))

    for _ in range(steps):
        a = rate(s)
        b = rate(moved(step / 2, a))
        c = rate(moved(step / 2, b))
        d = rate(moved(step, c))
        total = [w + 2 * x + 2 * y + z for w, x, y, z in zip(a, b, c, d, strict=True)]
        s = moved(step / 6, total)
    return s


def _passing(start, rate, matrix):
    """The function of the least angle to the vertical that integrates to the final matrix."""

    def final(least):
        omega = math.cos(least), 0.0, math.sin(least)  # components in the body's axes
        about_x = rotations.rotation_matrix((1, 0, 0), BEFORE)
        s = start(rotations.product(about_x, rotations.rotation_matrix((0, 1, 0), least)))
        return matrix(runge_kutta(lambda s: rate(s, omega), s, (AFTER - BEFORE) / STEPS, STEPS))

    return final


PASSES = (
    {
        "rates of Euler's angles": _passing(
            rotations.euler_angles,
            lambda s, omega: rotations.euler_rates(s[0], s[1], s[2], omega),  # (10.12)
            lambda s: rotations.euler_matrix(*s),
        ),
        "rate of a quaternion": _passing(
            rotations.quaternion_from_matrix,
            rotations.quaternion_rate,
            rotations.matrix_from_quaternion,
        ),
    },
    lambda R, least: _matrix_error(R, _rotation((1, 0, 0), AFTER) * _rotation((0, 1, 0), least)),
)


# -- inertia: a flat sheet, a triangle with a half disk on its base, about the apex; x is its axis
# of symmetry, z normal to it

RADIUS, HEIGHT, DENSITY = 0.3, 0.8, 5.0  # m, m, kg/m^2


def _of_points(u, v):
    """The moments of equal point masses at those (u, v) of the unit square that hit the sheet."""
    cell = DENSITY * (HEIGHT + RADIUS) * 2 * RADIUS / len(u)
    x, y = u * (HEIGHT + RADIUS), (2 * v - 1) * RADIUS
    inside = ((x <= HEIGHT) & (abs(y) <= RADIUS * x / HEIGHT)) | (
        (x > HEIGHT) & (y * y + (x - HEIGHT) ** 2 <= RADIUS**2)
    )
    xx, yy = (float(cell * (c[inside] ** 2).sum()) for c in (x, y))
    return yy, xx, xx + yy


def by_random_points(n: int) -> Triple:
    """The moments of n random mass points."""
    return _of_points(*np.random.default_rng(1).random((2, n)))


def by_grid(n: int) -> Triple:
    """The moments of about n mass points in a rectangular grid."""
    middles = (np.arange(k := round(n**0.5)) + 0.5) / k
    return _of_points(*(c.ravel() for c in np.meshgrid(middles, middles)))


def by_quadrature(n: int | None = None) -> Triple:
    """The moments by the engine's integrals, in coordinates that follow the edges."""
    sheet, slope, right = Frame("sheet"), RADIUS / HEIGHT, math.pi / 2
    of = partial(integrated, frame=sheet, density=DENSITY)
    parts = (
        of(lambda x, k: (x, k * x, 0), (0, HEIGHT), (-slope, slope), name="triangle"),
        of(lambda r, a: (HEIGHT + r * cos(a), r * sin(a), 0), (0, RADIUS), (-right, right)),
    )
    return composite("sheet", parts).about(sheet.origin).moments


def by_composition(n: int | None = None) -> Triple:
    """The moments by the engine's closed forms of the two parts."""
    sheet = Frame("sheet")
    base = sheet.point("A", HEIGHT, RADIUS, 0), sheet.point("B", HEIGHT, -RADIUS, 0)
    middle = sheet.point("M", HEIGHT, 0, 0)
    parts = (
        simplex(sheet.origin, *base, density=DENSITY),
        half_disk(RADIUS, middle, "z", "x", density=DENSITY),
    )
    return composite("sheet", parts).about(sheet.origin).moments


@_in_digits
def exact_inertia() -> Triple:
    """The moments in 40 digits, over strips of half the breadth b(x) and the mass 2 rho b dx."""
    r, h = mp.mpf(RADIUS), mp.mpf(HEIGHT)

    def total(f):
        sloping = mp.quad(lambda x: f(x, r * x / h), [0, h])
        rounded = mp.quad(lambda x: f(x, mp.sqrt(r**2 - (x - h) ** 2)), [h, h + r])
        return 2 * DENSITY * (sloping + rounded)

    xx, yy = total(lambda x, b: b * x * x), total(lambda x, b: b**3 / 3)
    return yy, xx, xx + yy


INERTIAS = (
    {"random points": by_random_points, "grid of points": by_grid,
     "engine, quadrature": by_quadrature, "engine, composition": by_composition},
    lambda found, n: relative_error(found, exact_inertia()),
)  # fmt: skip


# -- the angle of a rotation


def by_arc_cosine(R: Matrix) -> float:
    """The angle as arccos of (trace - 1)/2, which loses half of the digits at 0 and at pi."""
    # clipped because round-off can push it out of [-1, 1]
    return math.acos(min(1.0, max(-1.0, (R[0][0] + R[1][1] + R[2][2] - 1) / 2)))


def _angles(from_pi):
    def exact(angle):
        return mp.pi - angle if from_pi else mp.mpf(angle)

    @_in_digits
    def matrix(angle):
        # right to the last digit of each entry
        R = _rotation(AXIS, exact(angle))
        return tuple(tuple(float(R[n, m]) for m in range(3)) for n in range(3))

    ways = {
        "arc cosine of the trace": by_arc_cosine,
        "SciPy's Rotation": lambda R: float(Rotation.from_matrix(R).magnitude()),
        "engine, atan2": lambda R: rotations.axis_angle(R)[1],
    }
    methods = {name: lambda angle, by=by: by(matrix(angle)) for name, by in ways.items()}
    return methods, _in_digits(lambda found, angle: abs(found / exact(angle) - 1))


ANGLES, ANGLES_NEAR_PI = _angles(False), _angles(True)


# -- steady precession

I0, I, SPIN, MGR = 0.02, 0.01, 100.0, 0.5  # kg m^2, kg m^2, rad/s, N m


def printed_roots(a: Scalar, h: Scalar, c: Scalar) -> tuple[Scalar, Scalar]:
    """Both roots of a x^2 - h x + c = 0, the smaller first, as the book prints them (10.33)."""
    root = sqrt(h * h - 4 * a * c)
    return (h - root) / (2 * a), (h + root) / (2 * a)


def _theta(a):
    return math.acos(a / (I0 - I))


def _coefficients(a):
    return (I0 - I) * math.cos(_theta(a)), I * SPIN, MGR


def by_companion_matrix(a: float, h: float, c: float) -> list[float]:
    """The same roots by NumPy: eigenvalues of the companion matrix."""
    return sorted(np.roots([a, -h, c]).tolist())


def precessions(a: float) -> tuple[float, float]:
    """Both rates by the engine."""
    found = steady_precession(I0, I, _theta(a), spin=SPIN, mgr=MGR)
    return found.slow, found.fast


def precession_error(found: Sequence[float], a: float) -> float:
    """The larger relative error of the two, against the printed formula with more digits."""
    with mp.workdps(2 * DIGITS):
        exact = printed_roots((mp.mpf(I0) - I) * mp.cos(_theta(a)), mp.mpf(I) * SPIN, MGR)
        return max(float(abs(x / y - 1)) for x, y in zip(found, exact, strict=True))


PRECESSIONS = (
    {
        "printed root": lambda a: printed_roots(*_coefficients(a)),
        "NumPy's roots": lambda a: by_companion_matrix(*_coefficients(a)),
        "engine": precessions,
    },
    precession_error,
)
