"""What a motion costs beside SciPy as a user writes it and heyoka by itself, at equal true error, measured side by side in one run.

``pytest -m benchmark -s tests/benchmarks/test_ratios_motion.py`` prints the tables. Every competitor gets the loosest tolerance (a power of ten)
with which its true error is small enough. The bounds asserted are about half of what is measured.
"""

import math
import subprocess
import sys

import numpy as np
import pytest

from newton_euler.accuracy import timed
from newton_euler.motion import integrate
from newton_euler.scenes import top
from tests.motions import SCENES, SPIN, reference, top_start

ERRORS = (1e-6, 1e-10)


# -- as a user writes it: np.cross, arrays, rtol = atol


I_FREE, I_TOP = np.array([1.0, 2.0, 3.0]), np.array([1.0, 1.0, 1.5])


def user_free(t, w):
    return -np.cross(w, I_FREE * w) / I_FREE


def user_top(t, y):
    """Quaternion and body rates of the top, the weight 5 along -Z at the unit distance along z."""
    q, w = y[:4], y[4:]
    v = q[1:]
    dq = 0.5 * np.concatenate(([-v @ w], q[0] * w + np.cross(v, w)))
    down = np.array([0.0, 0.0, -5.0])
    weight = down - 2 * q[0] * np.cross(v, down) + 2 * np.cross(v, np.cross(v, down))  # in the body
    return np.concatenate((dq, (np.cross([0.0, 0.0, 1.0], weight) - np.cross(w, I_TOP * w)) / I_TOP))


def scipy_user(rhs, t, y):
    from scipy.integrate import solve_ivp

    return lambda tolerance: solve_ivp(rhs, (0, t), y, method="DOP853", rtol=tolerance, atol=tolerance).y[:, -1]


# -- heyoka by itself, on the full model


def heyoka_alone(equations, t, y):
    import heyoka as hy

    made = {}

    def run(tolerance):
        if tolerance not in made:
            made[tolerance] = hy.taylor_adaptive(equations, y, tol=tolerance)
        ta = made[tolerance]
        ta.time = 0.0
        ta.state[:] = y
        ta.propagate_until(t)
        return ta.state

    return run


def heyoka_free():
    import heyoka as hy

    x, y, z = hy.make_vars("x", "y", "z")
    return [(x, -y * z), (y, z * x), (z, -x * y / 3.0)]


def heyoka_top():
    """Quaternion and three body rates, as of a body without symmetry."""
    import heyoka as hy

    a, b, c, d, x, y, z = hy.make_vars(*"abcdxyz")
    kx, ky = 2.0 * (b * d - a * c), 2.0 * (c * d + a * b)
    return [(a, -0.5 * (b * x + c * y + d * z)), (b, 0.5 * (a * x + c * z - d * y)), (c, 0.5 * (a * y + d * x - b * z)),
            (d, 0.5 * (a * z + b * y - c * x)), (x, 5.0 * ky - 0.5 * y * z), (y, 0.5 * z * x - 5.0 * kx), (z, 0.0 * z)]  # fmt: skip


def loosest(run, error, wanted):
    """The loosest power of ten with which the run is accurate enough."""
    for n in range(3, 16):
        if error(run(10.0**-n)) <= wanted:
            return 10.0**-n
    return None


def table(title, times):
    best = min(times.values())
    print(f"\n{title}")
    for name, t in sorted(times.items(), key=lambda item: item[1]):
        print(f"  {name:44s} {1e6 * t:10.1f} us {t / best:9.1f}")


def heights(x):
    """cos(theta) and the tilting rate squared, which all models of the top have: of (q0..q3, w_x, w_y, ...)."""
    return np.array([x[0] ** 2 + x[3] ** 2 - x[1] ** 2 - x[2] ** 2, (x[4] ** 2 + x[5] ** 2) / 64])


@pytest.mark.benchmark
@pytest.mark.parametrize("wanted", ERRORS)
def test_the_nutating_top(wanted):
    pytest.importorskip("heyoka")
    exact = heights(reference("top"))

    def error(x):
        return abs(heights(x) - exact).max()

    start = [*top_start()[:4], 0.0, 0.0, SPIN]
    model, t, state = SCENES["top"]
    nodding, _, low = SCENES["top, nutation"]
    theirs, alone = scipy_user(user_top, t, start), heyoka_alone(heyoka_top(), t, start)
    a, b = loosest(theirs, error, wanted), loosest(alone, error, wanted)
    for method in ("dop853", "taylor"):
        assert error(list(integrate(model, t, state, wanted, method).end.values())) <= wanted
        assert abs(math.cos(integrate(nodding, t, low, wanted, method).end["theta"]) - exact[0]) <= wanted
    cases = {
        "SciPy DOP853, np.cross": lambda: theirs(a),
        "heyoka alone, full model": lambda: alone(b),
        "dop853, six states": lambda: integrate(model, t, state, wanted, "dop853"),
        "heyoka, six states": lambda: integrate(model, t, state, wanted, "taylor"),
        "dop853, nutation alone": lambda: integrate(nodding, t, low, wanted, "dop853"),
        "heyoka, nutation alone": lambda: integrate(nodding, t, low, wanted, "taylor"),
    }
    times = dict(zip(cases, timed(*cases.values(), runs=5), strict=True))
    table(f"nutating top, error {wanted:g}", times)
    slow = times["SciPy DOP853, np.cross"]
    assert slow > 8 * times["dop853, six states"]
    assert slow > 150 * times["heyoka, six states"]


@pytest.mark.benchmark
@pytest.mark.parametrize("wanted", ERRORS)
def test_the_free_body(wanted):
    pytest.importorskip("heyoka")
    exact = np.array(reference("free body"))

    def error(x):
        return abs(np.array(x) - exact).max()

    model, t, state = SCENES["free body"]
    theirs, alone = scipy_user(user_free, t, state), heyoka_alone(heyoka_free(), t, state)
    a, b = loosest(theirs, error, wanted), loosest(alone, error, wanted)
    assert error(list(integrate(model, t, state, wanted, "taylor").end.values())) <= wanted
    cases = {
        "SciPy DOP853, np.cross": lambda: theirs(a),
        "heyoka alone": lambda: alone(b),
        "dop853": lambda: integrate(model, t, state, wanted, "dop853"),
        "heyoka": lambda: integrate(model, t, state, wanted, "taylor"),
        "lie-poisson6": lambda: integrate(model, t, state, wanted, "lie-poisson6"),
    }
    times = dict(zip(cases, timed(*cases.values(), runs=5), strict=True))
    table(f"free body, error {wanted:g}", times)
    slow = times["SciPy DOP853, np.cross"]
    assert slow > 8 * times["dop853"]
    assert slow > 100 * times["heyoka"]


@pytest.mark.benchmark
def test_samples_and_sweeps():
    """1001 samples against heyoka's own grid; 1000 tops of different spin against heyoka one by one."""
    hy = pytest.importorskip("heyoka")
    model, t, state = SCENES["top"]
    grid = np.linspace(0.0, t, 1001)
    start = [*top_start()[:4], 0.0, 0.0, SPIN]
    ta = hy.taylor_adaptive(heyoka_top(), start, tol=1e-11)
    wide = hy.taylor_adaptive_batch(heyoka_top(), np.zeros((7, 8)), tol=1e-11)
    spins = np.linspace(6.0, 10.0, 1000)
    tops = top.rolled_out(1.0, 1.5, 5.0, spins)

    def own_grid():
        ta.time = 0.0
        ta.state[:] = start
        return ta.propagate_grid(grid)[-1]

    def own_batches():
        for n in range(0, 1000, 8):
            wide.set_time(0.0)
            wide.state[:] = np.array(start)[:, None]
            wide.state[6] = spins[n : n + 8]
            wide.propagate_until(t)

    cases = {
        "1001 samples, heyoka's grid, full model": own_grid,
        "1001 samples, ours": lambda: integrate(model, t, state, 1e-9, "taylor", samples=grid).states,
        "1000 tops, heyoka's batches, full model": own_batches,
        "1000 tops, ours": lambda: integrate(tops, t, state, 1e-9),
    }
    times = dict(zip(cases, timed(*cases.values(), runs=5), strict=True))
    for name, seconds in times.items():
        print(f"  {name:44s} {1e6 * seconds:10.1f} us")
    assert times["1001 samples, ours"] < 3 * times["1001 samples, heyoka's grid, full model"]
    assert times["1000 tops, ours"] < 2.4 * times["1000 tops, heyoka's batches, full model"]


@pytest.mark.benchmark
def test_a_first_top_from_a_fresh_interpreter():
    ours = (
        "from newton_euler.motion import integrate; from newton_euler.scenes.top import rolled_out;"
        "integrate(rolled_out(1., 1.5, 5., 8.), 10., (.955, .2955, 0., 0., 0., 0.), 1e-6)"
    )
    theirs = "import numpy, sympy.physics.mechanics, scipy.integrate"  # without deriving or integrating anything
    cases = [lambda code=code: subprocess.run([sys.executable, "-c", code], check=True) for code in (ours, theirs)]
    us, them = timed(*cases, runs=5)
    print(f"\nfresh interpreter to a first top: {1e3 * us:.0f} ms; imports of SymPy mechanics and SciPy alone: {1e3 * them:.0f} ms")
    assert us < 0.5 * them
