"""What the engine costs, as ratios measured side by side in one run, in interleaved rounds with the
least of several taken, so that a busy machine slows all alike: scenes of chapter 4, equations of
motion of the heavy top, and the import.

``pytest -m benchmark -s tests/benchmarks`` prints the tables. The bounds asserted are about half of
what is measured on a quiet machine. Run as a script it is the server for cold derivations: imports
done, SymPy's caches emptied before each case.
"""

import gc
import json
import os
import statistics
import subprocess
import sys
import time
from importlib import import_module
from pathlib import Path

import numpy as np
import pytest

from newton_euler import Frame, compiled, moving
from newton_euler.accuracy.measurements.measure import timed
from tests.kinds import compiled_by

ROOT = Path(__file__).parents[2]
NAMES = ("phi", "omega", "domega", "p", "dp", "R", "r")
ROUNDS = 7


# -- the scenes, by the engine


def disk_acceleration(phi, omega, domega, p, dp, R, r):
    """Example 4.11: disk on an inclined shaft; a_A in components of the disk."""
    ground = Frame("ground")
    shaft = ground.rotate("shaft", "z", rate=omega, acceleration=domega)
    tilted = shaft.rotate("tilted", "x", angle=-phi)
    disk = tilted.rotate("disk", "y", rate=p, acceleration=dp, origin=tilted.point("B", 0, R, 0))
    return disk.point("A", 0, 0, r).acceleration(ground)


def chain_acceleration(angles, L):
    """Five links about z and x by turns: the tip's acceleration along the last one."""
    frame = ground = Frame("ground")
    for n, angle in enumerate(angles):
        origin = frame.point("O", L, 0, 0) if n else None
        frame = frame.rotate(f"link {n}", "zx"[n % 2], angle, origin=origin)
    return frame.point("P", L, 0, 0).acceleration(ground)


# -- the same by sympy.physics.vector


def disk_by_physics_vector():
    import sympy
    from sympy.physics.vector import Point, ReferenceFrame, dynamicsymbols

    phi, R, r = sympy.symbols("phi R r")
    turn, spin = dynamicsymbols("turn spin")
    N = ReferenceFrame("N")
    shaft = N.orientnew("shaft", "Axis", (turn, N.z))
    tilted = shaft.orientnew("tilted", "Axis", (-phi, shaft.x))
    disk = tilted.orientnew("disk", "Axis", (spin, tilted.y))
    O = Point("O")
    B = O.locatenew("B", R * tilted.y)
    A = B.locatenew("A", r * disk.z)
    O.set_vel(N, 0)
    O.set_acc(N, 0)
    for point, base, frame in ((B, O, tilted), (A, B, disk)):
        point.v2pt_theory(base, N, frame)
        point.a2pt_theory(base, N, frame)
    return A.acc(N).to_matrix(disk), (turn, spin)


def chain_by_physics_vector():
    import sympy
    from sympy.physics.vector import Point, ReferenceFrame, dynamicsymbols

    L = sympy.Symbol("L")
    N = frame = ReferenceFrame("N")
    point = Point("O")
    point.set_vel(N, 0)
    point.set_acc(N, 0)
    for n, q in enumerate(dynamicsymbols("q:5")):
        frame = frame.orientnew(f"link{n}", "Axis", (q, frame.z if n % 2 == 0 else frame.x))
        tip = point.locatenew(f"P{n}", L * frame.x)
        tip.v2pt_theory(point, N, frame)
        tip.a2pt_theory(point, N, frame)
        point = tip
    return point.acc(N).to_matrix(frame)


# -- derivation with cold caches


def disk_on(library):
    return disk_acceleration(*map(import_module(library).Symbol, NAMES))


def chain_on_sympy():
    import sympy
    from sympy.physics.vector import dynamicsymbols

    return chain_acceleration(dynamicsymbols("q:5"), sympy.Symbol("L"))


def chain_on_symengine():
    import symengine

    return chain_of_numbers(*map(symengine.Symbol, [*CHAIN, "L"]))


def chain_of_numbers(*x):
    return chain_acceleration([moving(*x[n : n + 3]) for n in range(0, 15, 3)], x[15])


def top_by_engine(symbols):
    """psi'', theta'', phi'' of the heavy top from M = mgr sin(theta) i, in the library's symbols."""
    from newton_euler import Frame, euler_frame, moving, sin, solve_rates
    from newton_euler.applications import gyro_moment

    I0, I, mgr, *x = symbols("I0 I mgr psi theta phi dpsi dtheta dphi")
    angles, rates = x[:3], x[3:]

    def conditions(*accelerations):
        ground = Frame("ground")
        turned = map(moving, angles, rates, accelerations)
        M = gyro_moment(euler_frame(ground, "top", *turned), ground, I0, I)
        return M.x - mgr * sin(angles[1]), M.y, M.z

    return list(solve_rates(conditions, 3))


def top_by_kane():
    from tests.benchmarks.peers import kanes_method

    kane, _ = kanes_method(weight=True)
    return kane.mass_matrix.LUsolve(kane.forcing)


CHAIN = [f"{d}q{n}" for n in range(5) for d in ("", "d", "dd")]
FORMULAS = {
    "disk": disk_acceleration,
    "chain": eval(
        f"lambda {', '.join(CHAIN)}, L: tip({', '.join(CHAIN)}, L)", {"tip": chain_of_numbers}
    ),
}
DERIVATIONS = {
    "disk, physics.vector": disk_by_physics_vector,
    "disk, engine on SymPy": lambda: disk_on("sympy"),
    "disk, engine on SymEngine": lambda: disk_on("symengine"),
    "chain, physics.vector": chain_by_physics_vector,
    "chain, engine on SymPy": chain_on_sympy,
    "chain, engine on SymEngine": chain_on_symengine,
    "chain, engine traced": lambda: compiled(FORMULAS["chain"]),
    "top, KanesMethod": top_by_kane,
    "top, engine on SymPy": lambda: top_by_engine(import_module("sympy").symbols),
    "top, engine on SymEngine": lambda: top_by_engine(import_module("symengine").symbols),
}


def cold(case):
    """Seconds that the case takes with SymPy's caches empty (the engine and SymEngine keep none)."""
    from sympy.core.cache import clear_cache

    clear_cache()
    gc.collect()
    start = time.perf_counter()
    case()
    return time.perf_counter() - start


def cold_derivations():
    import symengine  # noqa: F401
    import sympy.physics.mechanics  # noqa: F401

    # on floats, to have all rooms imported
    top_by_engine(lambda names: [0.3 + 0.1 * n for n, _ in enumerate(names.split())])
    # case by case, not interleaved: after a round of SymPy the processor's caches hold none of the
    # engine's code
    many = lambda name: 5 if "Kane" in name else 3 * ROUNDS
    rounds = {n: [cold(case) for _ in range(many(n))] for n, case in DERIVATIONS.items()}
    print(json.dumps({name: statistics.median(seconds) for name, seconds in rounds.items()}))


# -- measuring and reporting


def medians(cases):
    """Seconds per call of each case; the cases take turns."""
    return dict(zip(cases, timed(*cases.values(), runs=ROUNDS), strict=True))


def table(title, times, unit, scale):
    front = min(times.values())
    print(f"\n{title}")
    for name, t in times.items():
        print(f"  {name:<40} {t * scale:10.4g} {unit:<12} x {t / front:.3g}")


@pytest.mark.benchmark
def test_deriving_is_faster_than_by_sympy_physics():
    """Than physics.vector for accelerations, than Kane's method for equations of motion."""
    pytest.importorskip("symengine")
    command = [sys.executable, __file__]
    environment = {**os.environ, "PYTHONPATH": str(ROOT)}
    out = subprocess.run(command, capture_output=True, text=True, check=True, env=environment)
    t = json.loads(out.stdout)
    for scene, peer, sympy, symengine in (
        ("disk", "physics.vector", 3, 15),
        ("chain", "physics.vector", 3, 25),
        ("top", "KanesMethod", 5, 35),
    ):
        own = {n: x for n, x in t.items() if n.startswith(scene)}
        table(f"{scene}: derivation, cold", own, "ms", 1e3)
        assert t[f"{scene}, {peer}"] > sympy * t[f"{scene}, engine on SymPy"]
        assert t[f"{scene}, {peer}"] > symengine * t[f"{scene}, engine on SymEngine"]
    assert t["chain, physics.vector"] > 10 * t["chain, engine traced"]


def by_lambdify(scene, library):
    """The result of physics.vector as a function of the same numbers as the engine's formula."""
    import sympy
    from sympy.physics.vector import dynamicsymbols

    t = dynamicsymbols._t
    if scene == "disk":
        a, (turn, spin) = disk_by_physics_vector()
        symbols = sympy.symbols(NAMES)
        _, omega, domega, p, dp, *_ = symbols
        values = {turn.diff(t, 2): domega, spin.diff(t, 2): dp}
        values |= {turn.diff(t): omega, spin.diff(t): p, turn: 0, spin: 0}
    else:
        a, symbols = chain_by_physics_vector(), (*sympy.symbols(CHAIN), sympy.Symbol("L"))
        values = {
            q.diff(t, m): sympy.Symbol(f"{'d' * m}q{n}")
            for m in (2, 1, 0)
            for n, q in enumerate(dynamicsymbols("q:5"))
        }
    return sympy.lambdify(symbols, [c.subs(values) for c in a], library, cse=True)


@pytest.mark.benchmark
@pytest.mark.parametrize(
    ("scene", "numpy_gains", "heyoka_gains"), [("disk", 0.5, 1.8), ("chain", 1.5, 5)]
)
def test_many_instants_are_faster_than_lambdify(scene, numpy_gains, heyoka_gains):
    pytest.importorskip("heyoka")
    formula, theirs = FORMULAS[scene], by_lambdify(scene, "numpy")
    by_numpy, by_heyoka = (compiled_by(name, formula) for name in ("numpy", "heyoka"))
    x = np.random.default_rng(4).uniform(0.2, 1.5, (len(by_numpy.parameters), 100_000))
    cases = {
        "compiled, heyoka": lambda: by_heyoka(*x),
        "compiled, NumPy in blocks": lambda: by_numpy(*x),
        "formula on whole arrays": lambda: formula(*x).components(),
        "lambdify(cse=True) of physics.vector": lambda: theirs(*x),
    }
    expected = np.array(theirs(*x))
    for name, case in cases.items():
        assert np.allclose(np.array(case()), expected, rtol=1e-10, atol=1e-10), name
    t = medians(cases)
    table(f"{scene}: 1e5 instants", t, "ns/instant", 1e4)
    slow = t["lambdify(cse=True) of physics.vector"]
    assert slow > numpy_gains * t["compiled, NumPy in blocks"]
    assert slow > heyoka_gains * t["compiled, heyoka"]


def disk_by_numpy(phi, omega, domega, p, dp, R, r):
    """As a user writes it with arrays of three: np.cross for every product."""
    s, c = np.sin(phi), np.cos(phi)
    k = np.array([0.0, -s, c])  # the vertical, in components of the disk
    e = np.array([0.0, 1.0, 0.0])
    to_B, to_A = R * e, np.array([0.0, 0.0, r])
    w2, w3 = omega * k, omega * k + p * e
    a2, a3 = domega * k, domega * k + dp * e + np.cross(omega * k, p * e)
    a_B = np.cross(a2, to_B) + np.cross(w2, np.cross(w2, to_B))
    return a_B + np.cross(a3, to_A) + np.cross(w3, np.cross(w3, to_A))


@pytest.mark.benchmark
def test_one_instant_is_faster_than_np_cross():
    x = (0.4, 1.2, 0.3, 4.0, 0.7, 2.0, 0.5)
    f, theirs = compiled(disk_acceleration), by_lambdify("disk", "math")
    cases = {
        "compiled, floats": lambda: f(*x),
        "lambdify(math, cse=True)": lambda: theirs(*x),
        "formula directly (frames and points)": lambda: disk_acceleration(*x),
        "np.cross": lambda: disk_by_numpy(*x),
    }
    expected, close = disk_by_numpy(*x), {"rtol": 1e-12, "atol": 1e-13}
    for name in list(cases)[:3]:
        assert np.allclose([float(c) for c in cases[name]()], expected, **close), name
    t = medians(cases)
    table("disk: one instant on floats", t, "us", 1e6)
    assert t["np.cross"] > 20 * t["compiled, floats"]
    assert t["np.cross"] > 1.5 * t["formula directly (frames and points)"]


@pytest.mark.benchmark
def test_the_import_costs_at_most_1_3_times_that_of_numpy():
    def seconds(code):
        start = time.perf_counter()
        subprocess.run([sys.executable, "-c", code], check=True)
        return time.perf_counter() - start

    codes = "pass", "import numpy", "import newton_euler"
    rounds = [[seconds(code) for code in codes] for _ in range(7)]
    bare, *others = (min(column) for column in zip(*rounds, strict=True))
    numpy, ours = (x - bare for x in others)
    print(f"  over bare Python: numpy {1e3 * numpy:.0f} ms, newton_euler {1e3 * ours:.0f} ms")
    assert ours < 1.3 * numpy


if __name__ == "__main__":
    cold_derivations()
