"""A rigid body on which no moment acts, by its body rates, (8.14) with M = 0: exact everywhere.

Along principal axes fixed in the body I_x w_x' = (I_y - I_z) w_y w_z and cyclic. The solution is
Jacobi's: with b the intermediate axis and a the one that the motion circles, w_a is a dn, w_b a sn,
w_c a cn. Near the separatrix k^2 is 1 within round-off, and formulas in k^2 lose all digits. Here 1
- k^2 comes from a difference of two squares, in twice the digits where these cancel, and the state
from that of the start by :func:`newton_euler.scenes.closed_forms.elliptic.coupled`.
"""

from ...algebra.scalars import Scalar, is_finite, is_numeric, max_abs, sqrt, where
from ...algebra.vectors import dot3
from ...motion.model import Model, ModelError, Neglected, comparable
from ..catalogue import scene
from ..closed_forms.double_double import doubled
from ..closed_forms.elliptic import coupled
from ..closed_forms.harmonic import circular_or_hyperbolic, rotated
from ..ladders import Ladder, Rung, observed_states

RATES = "angular velocity, rad/s"
STATES = "w_x", "w_y", "w_z"


@scene(
    "10.8", "free body", "a spin about the intermediate axis, which is unstable",
    50.0, (0.01, 1.0, 0.01), I_x=1.0, I_y=2.0, I_z=3.0,
)  # fmt: skip
@scene(
    "10.8", "free body, calm", "a spin near the axis of the least moment",
    20.0, (1.0, 0.1, 0.4), I_x=1.0, I_y=1.5, I_z=2.2,
)  # fmt: skip
def free_body(I_x: Scalar, I_y: Scalar, I_z: Scalar) -> Model:
    """The Model of the free body: states w_x, w_y, w_z along its principal axes (rad/s); invariants
    ``energy`` and ``momentum``, the size of H.

    The exact solution takes the numbers given as exact, and is right to a few round-offs of t times
    the rate of the motion, wherever it starts. t, and the states, may be arrays; expressions raise
    :class:`~newton_euler.motion.model.ModelError`.

    >>> body = free_body(1.0, 2.0, 3.0)
    >>> [round(w, 6) for w in body.solution(20.0, (1e-7, 1.0, 1e-7))]
    [-0.003787, 0.999993, 0.002187]
    """
    return Model("free body", locals(), STATES, _rates, _INVARIANTS, _exact)


def _rates(s, p, t):
    return (
        (p.I_y - p.I_z) * (s.w_y * s.w_z) / p.I_x,
        (p.I_z - p.I_x) * (s.w_z * s.w_x) / p.I_y,
        (p.I_x - p.I_y) * (s.w_x * s.w_y) / p.I_z,
    )


def _momentum(s, p, t):
    H = p.I_x * s.w_x, p.I_y * s.w_y, p.I_z * s.w_z
    return sqrt(dot3(H, H))


_INVARIANTS = {
    "energy": lambda s, p, t: (p.I_x * s.w_x**2 + p.I_y * s.w_y**2 + p.I_z * s.w_z**2) / 2,
    "momentum": _momentum,
}


def _exact(s, p, t):
    *I, w_x, w_y, w_z, t = comparable("free body", p.I_x, p.I_y, p.I_z, s.w_x, s.w_y, s.w_z, t)
    _check(I, (w_x, w_y, w_z), t)
    k = (I[1] - I[2]) / I[0], (I[2] - I[0]) / I[1], (I[0] - I[1]) / I[2]
    # is the intermediate axis, to be put second in the cycle x, y, z
    y, z = k[2] * k[0] >= 0, k[0] * k[1] >= 0

    def in_cycle(of_x, of_y, of_z):
        return (
            where(y, of_x, where(z, of_y, of_z)),
            where(y, of_y, where(z, of_z, of_x)),
            where(y, of_z, where(z, of_x, of_y)),
        )

    k, w = in_cycle(*k), in_cycle(w_x, w_y, w_z)
    a, b, c, _ = coupled(k, w, _gap(k, in_cycle(*I), w), t)
    return where(y, a, where(z, c, b)), where(y, b, where(z, a, c)), where(y, c, where(z, b, a))


def _check(moments, w, t):
    if not all(map(is_finite, (*moments, *w, t))):
        raise ModelError(
            f"the free body cannot start with {w}, {moments} and go to t = {t}: all must be finite"
        )
    if any(is_numeric(I) and max_abs(where(I > 0, 0, 1)) for I in moments):
        raise ModelError(f"the principal moments are three positive numbers, got {moments}")


def _gap(k, I, w):
    """H^2 - 2 T I_b, b the axis between: > 0 if it circles the first axis, < 0 if the third."""

    def difference(Ia, Ib, Ic, wa, wc):
        return Ia * (Ia - Ib) * (wa * wa) - Ic * (Ib - Ic) * (wc * wc)

    p, r = k[1] * k[2] * (w[0] * w[0]), k[0] * k[1] * (w[2] * w[2])
    rough = r - p
    cancelled = abs(rough) < abs(p + r) / 16
    return where(cancelled, -k[1] / (I[0] * I[2]) * doubled(difference, *I, w[0], w[2]), rough)


def symmetric_wobble(I_x: Scalar, I_y: Scalar, I_z: Scalar, spin: Scalar) -> Model:
    """The Model with the mean of I_x and I_y (10.36): states w_x, w_y; constant ``spin`` about z.

    >>> symmetric_wobble(1.0, 3.0, 3.0, 10.0).derivative((0.5, 0.1))
    (-0.5, 2.5)
    """
    name, given = "wobble of a symmetric body", locals()
    return Model(name, given, STATES[:2], _symmetric, {}, _symmetric_exact, (ASYMMETRY,))


def small_wobble(I_x: Scalar, I_y: Scalar, I_z: Scalar, spin: Scalar) -> Model:
    """The Model to first order in its states w_x and w_y: on an ellipse, or running away where z is
    the intermediate axis.

    >>> small_wobble(1.0, 2.0, 3.0, 10.0).derivative((0.5, 0.1))
    (-1.0, 5.0)
    """
    return Model("small wobble", locals(), STATES[:2], _small, {}, _small_exact, (PRODUCT,))


@scene("10.8", "free body", "a symmetric body, a small wobble, any motion", ladder=True)
def ladder(
    I_x: Scalar = 1.0, I_y: Scalar = 1.02, I_z: Scalar = 1.5,
    start: tuple[Scalar, ...] = (0.1, 0.0, 5.0), t: Scalar = 10.0,
) -> Ladder:  # fmt: skip
    """The models symmetric body, small wobble and free body, for w_x, w_y, w_z.

    >>> from newton_euler import smallest
    >>> [smallest(ladder(), rate).model.name for rate in (0.01, 1e-4, 1e-5)]
    ['wobble of a symmetric body', 'small wobble', 'free body']
    """
    *across, spin = start
    wobbles = symmetric_wobble(I_x, I_y, I_z, spin), small_wobble(I_x, I_y, I_z, spin)
    rungs = [Rung(model, tuple(across), _with_spin) for model in wobbles]
    rungs += [Rung(free_body(I_x, I_y, I_z), start, observed_states(*STATES))]
    return Ladder("free body", RATES, t, tuple(rungs))


def _with_spin(s, p, t):
    return s.w_x, s.w_y, p.spin


def _turning(p):
    I0 = (p.I_x + p.I_y) / 2
    return (p.I_z - I0) / I0 * p.spin


def _symmetric(s, p, t):
    rate = _turning(p)
    return -rate * s.w_y, rate * s.w_x


def _symmetric_exact(s, p, t):
    return rotated(s.w_x, s.w_y, _turning(p) * t)


def _factors(p):
    """w_x' = -a w_y, w_y' = b w_x."""
    return (p.I_z - p.I_y) / p.I_x * p.spin, (p.I_z - p.I_x) / p.I_y * p.spin


def _small(s, p, t):
    a, b = _factors(p)
    return -a * s.w_y, b * s.w_x


def _small_exact(s, p, t):
    a, b = _factors(p)
    c, S = circular_or_hyperbolic(a * b, t)
    return s.w_x * c - a * s.w_y * S, s.w_y * c + b * s.w_x * S


ASYMMETRY = Neglected("the difference of I_x and I_y", None, RATES)
PRODUCT = Neglected("the change of the rate about z", None, RATES)
