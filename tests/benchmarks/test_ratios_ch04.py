"""What chapter 4 costs, as ratios measured side by side in one run: rounds interleaved, medians, so
that a busy machine slows all alike.

``pytest -m benchmark -s tests/benchmarks`` prints the tables. The bounds asserted are about half of
what is measured on a quiet machine. Run as a script with an argument it is the server for cold
derivations: imports done, SymPy's caches emptied before each case.
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
    import sympy.physics.vector  # noqa: F401

    # case by case, not interleaved: after a round of SymPy the processor's caches hold none of the
    # engine's code
    rounds = {n: [cold(case) for _ in range(3 * ROUNDS)] for n, case in DERIVATIONS.items()}
    print(json.dumps({name: statistics.median(seconds) for name, seconds in rounds.items()}))


# -- measuring and reporting


def medians(cases, repeat):
    """Seconds a call of each case: they take turns, and ``repeat`` calls are one measurement."""
    times = {name: [] for name in cases}
    for case in cases.values():
        case()
    for _ in range(ROUNDS):
        for name, case in cases.items():
            start = time.perf_counter()
            for _ in range(repeat[name]):
                case()
            times[name].append((time.perf_counter() - start) / repeat[name])
    return {name: statistics.median(t) for name, t in times.items()}


def table(title, times, unit, scale):
    front = min(times.values())
    print(f"\n{title}")
    for name, t in times.items():
        print(f"  {name:<40} {t * scale:10.4g} {unit:<12} x {t / front:.3g}")


@pytest.mark.benchmark
def test_deriving_is_faster_than_physics_vector():
    pytest.importorskip("symengine")
    environment = {**os.environ, "PYTHONPATH": str(Path(__file__).parents[2])}
    command = [sys.executable, __file__, "derive"]
    out = subprocess.run(command, capture_output=True, text=True, check=True, env=environment)
    t = json.loads(out.stdout)
    for scene in ("disk", "chain"):
        own = {n: x for n, x in t.items() if n.startswith(scene)}
        table(f"{scene}: derivation, cold", own, "ms", 1e3)
    assert t["disk, physics.vector"] > 3 * t["disk, engine on SymPy"]
    assert t["disk, physics.vector"] > 15 * t["disk, engine on SymEngine"]
    assert t["chain, physics.vector"] > 3 * t["chain, engine on SymPy"]
    assert t["chain, physics.vector"] > 25 * t["chain, engine on SymEngine"]
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
    by_numpy, by_heyoka = compiled(formula, backend="numpy"), compiled(formula, backend="heyoka")
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
    t = medians(cases, dict.fromkeys(cases, 1))
    table(f"{scene}: 1e5 instants", t, "ns/instant", 1e4)
    slow = t["lambdify(cse=True) of physics.vector"]
    assert slow > numpy_gains * t["compiled, NumPy in blocks"]
    assert slow > heyoka_gains * t["compiled, heyoka"]


def disk_by_numpy(phi, omega, domega, p, dp, R, r):
    """As one writes it with arrays of three: np.cross for every product."""
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
    t = medians(cases, dict(zip(cases, (5000, 3000, 200, 100), strict=True)))
    table("disk: one instant on floats", t, "us", 1e6)
    assert t["np.cross"] > 20 * t["compiled, floats"]
    assert t["np.cross"] > 1.5 * t["formula directly (frames and points)"]


if __name__ == "__main__":
    cold_derivations()
