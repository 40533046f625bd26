"""What the rest of the engine costs, as ratios in one run: equations of motion of the heavy top
against Kane's method, and the import.

``pytest -m benchmark -s tests/benchmarks`` prints the tables. The bounds are those that the project
asks for.
"""

import gc
import json
import statistics
import subprocess
import sys
import time

import pytest

ROUNDS = 5


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


def top_by_kane(_):
    import sympy
    from sympy.physics.mechanics import KanesMethod, Point, ReferenceFrame, RigidBody, inertia
    from sympy.physics.vector import dynamicsymbols

    I0, I, m, g, r = sympy.symbols("I0 I m g r")
    q, u = dynamicsymbols("psi theta phi"), dynamicsymbols("u1:4")
    N = ReferenceFrame("N")
    B = N.orientnew("B", "Body", q, "313")
    O, G = Point("O"), Point("G")
    O.set_vel(N, 0)
    B.set_ang_vel(N, B.ang_vel_in(N).subs(dict(zip([x.diff() for x in q], u, strict=True))))
    G.set_pos(O, r * B.z)
    G.v2pt_theory(O, N, B)
    body = RigidBody("top", G, B, m, (inertia(B, I0 - m * r**2, I0 - m * r**2, I), G))
    kinematic = [a.diff() - b for a, b in zip(q, u, strict=True)]
    kane = KanesMethod(N, q_ind=q, u_ind=u, kd_eqs=kinematic)
    kane.kanes_equations([body], [(G, -m * g * N.z)])
    return list(kane.mass_matrix.LUsolve(kane.forcing))


def cold(case, symbols):
    """Seconds of one derivation with SymPy's caches empty (the engine and SymEngine keep none)."""
    from sympy.core.cache import clear_cache

    clear_cache()
    gc.collect()
    start = time.perf_counter()
    case(symbols)
    return time.perf_counter() - start


def serve():
    """All cases in turn, from a lean process that has its imports done; prints {case: [seconds]}."""
    import symengine
    import sympy.physics.mechanics

    import newton_euler

    # on floats, to have all rooms imported
    top_by_engine(lambda names: [0.3 + 0.1 * n for n, _ in enumerate(names.split())])
    newton_euler.sin(symengine.Symbol("x")), newton_euler.sin(sympy.Symbol("x"))
    cases = {"KanesMethod": (top_by_kane, None, ROUNDS)}
    for library in (sympy, symengine):
        cases[f"engine, {library.__name__}"] = top_by_engine, library.symbols, 5 * ROUNDS
    print(json.dumps({n: [cold(f, x) for _ in range(k)] for n, (f, x, k) in cases.items()}))


@pytest.mark.benchmark
def test_heavy_top_is_derived_5_times_faster_than_by_kane_on_sympy_and_80_times_on_symengine():
    pytest.importorskip("symengine")
    command = [sys.executable, __file__]
    out = subprocess.run(command, capture_output=True, text=True, check=True).stdout
    typical = {name: statistics.median(s) for name, s in json.loads(out).items()}
    for name, s in typical.items():
        print(f"  {name:<20} {1e3 * s:8.2f} ms   x {s / min(typical.values()):.1f}")
    assert typical["KanesMethod"] > 5 * typical["engine, sympy"]
    assert typical["KanesMethod"] > 80 * typical["engine, symengine"]


def test_both_derivations_of_the_top_agree():
    import sympy
    from sympy.physics.vector import dynamicsymbols

    ours, kanes = top_by_engine(sympy.symbols), top_by_kane(None)
    inertias, angles, rates = {"I0": 1.5, "I": 1.0}, (0.3, 0.6, 0.2), (0.7, -0.4, 8.0)
    names = "psi theta phi", "dpsi dtheta dphi"
    turned = dict(zip(" ".join(names).split(), angles + rates, strict=True))
    mine = [float(x.subs({**inertias, "mgr": 5.0, **turned})) for x in ours]
    q, u = dynamicsymbols(names[0]), dynamicsymbols("u1:4")
    there = dict(zip((*q, *u), angles + rates, strict=True))
    there |= inertias | {"m": 1.0, "r": 0.5, "g": 10.0}
    at_rest = {a.diff(): 0 for a in u}
    theirs = [float(x.subs(at_rest).subs(there)) for x in kanes]
    assert mine == pytest.approx(theirs, rel=1e-9)


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
    serve()
