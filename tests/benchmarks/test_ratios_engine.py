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
    """psi'', theta'', phi'' of the heavy top from M = mgr sin(theta) i, in symbols of the library
    given.
    """
    from newton_euler import Frame, euler_frame, moving, sin, solve_rates
    from newton_euler.applications import gyro_moment

    I0, I, mgr, psi, theta, phi, dpsi, dtheta, dphi = symbols(
        "I0 I mgr psi theta phi dpsi dtheta dphi"
    )

    def conditions(ddpsi, ddtheta, ddphi):
        ground = Frame("ground")
        top = euler_frame(
            ground,
            "top",
            moving(psi, dpsi, ddpsi),
            moving(theta, dtheta, ddtheta),
            moving(phi, dphi, ddphi),
        )
        M = gyro_moment(top, ground, I0, I)
        return M.x - mgr * sin(theta), M.y, M.z

    return list(solve_rates(conditions, 3))


def top_by_kane(_):
    import sympy
    from sympy.physics.mechanics import (
        KanesMethod,
        Point,
        ReferenceFrame,
        RigidBody,
        dynamicsymbols,
        inertia,
    )

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
    kane = KanesMethod(
        N, q_ind=q, u_ind=u, kd_eqs=[a.diff() - b for a, b in zip(q, u, strict=True)]
    )
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
    engine = {
        f"engine, {library.__name__}": (top_by_engine, library.symbols)
        for library in (sympy, symengine)
    }
    cases = {"KanesMethod": (top_by_kane, None), **engine}
    rounds = {top_by_kane: ROUNDS, top_by_engine: 5 * ROUNDS}
    print(
        json.dumps(
            {name: [cold(*case) for _ in range(rounds[case[0]])] for name, case in cases.items()}
        )
    )


@pytest.mark.benchmark
def test_heavy_top_is_derived_5_times_faster_than_by_kane_on_sympy_and_80_times_on_symengine():
    pytest.importorskip("symengine")
    seconds = json.loads(
        subprocess.run(
            [sys.executable, __file__], capture_output=True, text=True, check=True
        ).stdout
    )
    typical = {name: statistics.median(s) for name, s in seconds.items()}
    for name, s in typical.items():
        print(f"  {name:<20} {1e3 * s:8.2f} ms   x {s / min(typical.values()):.1f}")
    assert typical["KanesMethod"] > 5 * typical["engine, sympy"]
    assert typical["KanesMethod"] > 80 * typical["engine, symengine"]


def test_both_derivations_of_the_top_agree():
    import sympy

    ours, kanes = top_by_engine(sympy.symbols), top_by_kane(None)
    at = {
        "I0": 1.5,
        "I": 1.0,
        "mgr": 5.0,
        "psi": 0.3,
        "theta": 0.6,
        "phi": 0.2,
        "dpsi": 0.7,
        "dtheta": -0.4,
        "dphi": 8.0,
    }
    mine = [float(x.subs(at)) for x in ours]
    from sympy.physics.mechanics import dynamicsymbols

    q, u, names = dynamicsymbols("psi theta phi"), dynamicsymbols("u1:4"), ("psi", "theta", "phi")
    there = {
        **{x: at[n] for x, n in zip(q, names, strict=True)},
        **{x: at["d" + n] for x, n in zip(u, names, strict=True)},
    }
    there |= {
        sympy.Symbol("I0"): 1.5,
        sympy.Symbol("I"): 1.0,
        sympy.Symbol("m"): 1.0,
        sympy.Symbol("r"): 0.5,
        sympy.Symbol("g"): 10.0,
    }
    assert mine == pytest.approx(
        [float(x.subs({a.diff(): 0 for a in u}).subs(there)) for x in kanes], rel=1e-9
    )


@pytest.mark.benchmark
def test_the_import_costs_at_most_1_3_times_that_of_numpy():
    def seconds(code):
        start = time.perf_counter()
        subprocess.run([sys.executable, "-c", code], check=True)
        return time.perf_counter() - start

    rounds = [
        [seconds(code) for code in ("pass", "import numpy", "import newton_euler")]
        for _ in range(7)
    ]
    bare, numpy, ours = (min(column) for column in zip(*rounds, strict=True))
    print(
        f"  over the bare interpreter: numpy {1e3 * (numpy - bare):.0f} ms, newton_euler "
        f"{1e3 * (ours - bare):.0f} ms"
    )
    assert ours - bare < 1.3 * (numpy - bare)


if __name__ == "__main__":
    serve()
