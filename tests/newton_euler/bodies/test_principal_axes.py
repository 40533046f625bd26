"""Principal moments and axes (7.15)-(7.21): numbers against NumPy, order and sign, what equal and
nearly equal moments leave open, symmetry.
"""

import math

import numpy as np
import pytest
import sympy
from hypothesis import given, settings
from hypothesis import strategies as st

from newton_euler import Frame, Inertia, compiled, composite, particle, rotation_matrix
from newton_euler.bodies import MassError, box, cylinder, disk, sphere
from newton_euler.kinematics import determinant
from tests.kinds import close, every_kind, numbers

laws = settings(max_examples=80)


def tilted(moments, axis, angle, noise=0.0, seed=0):
    """The matrix with these principal moments, turned about an axis, with relative noise."""
    R = np.array(rotation_matrix(axis, angle))
    shake = np.random.default_rng(seed).uniform(-1, 1, (3, 3)) * noise * max(moments)
    I = R @ np.diag(moments) @ R.T + shake
    I = (I + I.T) / 2
    products = -I[0, 1], -I[1, 2], -I[0, 2]
    return Inertia(Frame("body"), np.diag(I).tolist(), products, tolerance=None), R


def angle_between(axis, vector):
    return math.atan2(np.linalg.norm(np.cross(axis, vector)), abs(np.dot(axis, vector)))


@every_kind
def test_eqn_7_15_to_7_19_about_a_principal_axis_H_is_parallel_to_omega(kind):
    I = Inertia(Frame("body"), numbers(kind, 8, 11, 11), numbers(kind, 3, 0, -3))
    p = I.principal()
    small = 1e-13 if kind in ("float", "array") else 1e-25
    for moment, axis in zip(p.moments, p.axes, strict=True):
        assert close(I.times(axis), moment * axis, small)  # (7.15), (7.16), (7.18)
        assert close(axis.norm(), 1, small)
    (e, f, g) = p.axes
    assert close(e.cross(f), g, small)  # right-handed and at right angles
    assert I.expressed_in(I.frame) is I


@every_kind
def test_eqn_7_20_the_moments_are_the_roots_of_the_characteristic_equation(kind):
    I = Inertia(Frame("body"), numbers(kind, 5, 4, 3), numbers(kind, 1, -1, "0.5"))
    (a, d, f), (_, b, e), (_, _, c) = I.matrix
    for x in I.principal().moments:
        rows = (a - x, d, f), (d, b - x, e), (f, e, c - x)
        assert close(determinant(rows), 0, 1e-12 if kind in ("float", "array") else 1e-24)


def test_eqn_7_21_pairs_of_masses_opposite_an_axis():
    """Pairs across k, at any height, make k principal; three or more make two moments equal."""
    frame, parts = Frame("body"), []
    for n, (m, r, z) in enumerate([(2.0, 0.5, 0.3), (1.0, 1.5, -0.8)]):
        for a in (n + k * math.pi / 2 for k in range(4)):
            P = frame.point("P", r * math.cos(a), r * math.sin(a), z)
            parts.append(particle(m, P))
    s = composite("body", parts).about(frame).symmetry()
    assert (s.kind, s.axes) == ("top", ("x", "y", "z"))
    assert close(s.axis, (0, 0, 1), 1e-15)
    pair = [particle(1.0, frame.point("P", x, 2 * x, 0.4)) for x in (-1.0, 1.0)]
    # one pair: only k is principal
    assert composite("pair", pair).about(frame).symmetry().axes == ("z",)


moments = st.tuples(*[st.floats(0.1, 10)] * 3).filter(lambda m: max(m) <= 0.99 * (sum(m) - max(m)))
axes = st.tuples(*[st.floats(-1, 1)] * 3).filter(lambda v: sum(x * x for x in v) > 1e-3)


@laws
@given(moments, axes, st.floats(-4, 4))
def test_moments_and_axes_of_any_body(given_moments, axis, angle):
    I, _ = tilted(given_moments, axis, angle)
    p, size = I.principal(), max(given_moments)
    assert np.allclose(p.moments, sorted(given_moments), rtol=0, atol=1e-13 * size)
    V = np.array(p.rotation)
    assert np.allclose(V.T @ V, np.eye(3), atol=1e-14)
    assert abs(np.linalg.det(V) - 1) < 1e-14  # eigh alone is left-handed half of the time
    for diagonal in (V.T @ I.to_array() @ V, I.expressed_in(p.frame()).to_array()):
        assert np.allclose(diagonal, np.diag(p.moments), rtol=0, atol=2e-12 * size)


def test_order_and_sign_are_reproducible():
    frame, tilted_axes = Frame("body"), set()
    for x in (0.0, -0.0):
        axis = Inertia(frame, (8.0, 11.0, 11.0), (3.0, x, -3.0)).principal().axes[1]
        tilted_axes.add(tuple(round(c, 12) for c in axis.components()))
    assert len(tilted_axes) == 1
    p = Inertia(frame, (3.0, 1.0, 2.5)).principal()
    assert p.moments == (1.0, 2.5, 3.0)
    assert [v.components() for v in p.axes] == [(0.0, 1.0, 0.0), (0.0, 0.0, 1.0), (1.0, 0.0, 0.0)]


@pytest.mark.slow  # SymPy's exact roots of a cubic
def test_thirty_digits():
    data = (
        [numbers(kind, *v) for v in ((5, 4, 3), (1, -1, "0.5"))] for kind in ("mpmath", "sympy")
    )
    p, exact = (Inertia(Frame("body"), *given).principal() for given in data)
    assert close(p.moments, exact.moments, 1e-27)
    assert not any(m.has(sympy.I) for m in exact.moments)  # no complex cube roots
    assert close([tuple(a) for a in p.axes], [tuple(a) for a in exact.axes], 1e-26)


def test_an_array_of_matrices_is_each_of_them():
    stiff = np.array([8.0, 9.0, 12.0])
    principal = lambda x: Inertia(Frame("body"), (x, 11.0, 11.0), (3.0, 0.2, -3.0)).principal()
    many = principal(stiff)
    for n, x in enumerate(stiff):
        one = principal(float(x))
        assert close([m[n] for m in many.moments], one.moments, 1e-14)
        assert close([[c[n] for c in a] for a in many.axes], [tuple(a) for a in one.axes], 1e-13)
    assert many.turns[0].shape == (3,)


@pytest.mark.parametrize("where", [0, 1], ids=["two low", "two high"])
def test_a_tilted_body_of_revolution_has_a_right_handed_frame_of_principal_axes(where):
    I, R = tilted(((2.0, 2.0, 3.0), (2.0, 3.0, 3.0))[where], (1.0, 2.0, 0.5), 0.8)
    p = I.principal()
    distinct = 2 if where == 0 else 0
    assert angle_between(p.axes[distinct].components(), R[:, distinct]) < 1e-14
    V = np.array(p.rotation)
    assert np.allclose(V.T @ V, np.eye(3), atol=1e-15)
    assert abs(np.linalg.det(V) - 1) < 1e-15
    assert np.allclose(V.T @ I.to_array() @ V, np.diag(p.moments), atol=1e-14)
    assert [line[:9] for line in str(p).splitlines()[1:4]] == [
        "  axis 1:",
        "  axis 2:",
        "  axis 3:",
    ]
    assert f"axes {('1 and 2', '2 and 3')[where]} are not determined by" in str(p)
    assert "only their plane is" in str(p)


def test_equal_moments_keep_the_axes_of_the_frame():
    I, _ = tilted((2.0, 2.0, 2.0), (1.0, 2.0, 0.5), 0.8)
    p = I.principal()
    assert [v.components() for v in p.axes] == [(1, 0, 0), (0, 1, 0), (0, 0, 1)]
    assert p.determined == (False, False, False)
    assert "any axis is a principal axis" in str(p)
    assert I.symmetry().kind == "sphere"
    a, b, c = sympy.symbols("a b c", positive=True)
    p = Inertia(Frame("body"), (a, b, c)).principal()
    assert p.moments == (a, b, c)
    assert p.axes[1].components() == (0, 1, 0)
    assert "principal moments about origin of body: a, b, c" in str(p)
    q = sympy.Rational
    # about (1, 1, 1)
    I = Inertia(Frame("body"), (q(7, 3), q(7, 3), q(7, 3)), (q(1, 3), q(1, 3), q(1, 3)))
    p = I.principal()
    assert p.moments == (q(5, 3), q(8, 3), q(8, 3))
    for moment, axis in zip(p.moments, p.axes, strict=True):
        assert all(sympy.simplify(x) == 0 for x in (I.times(axis) - moment * axis).components())
    assert sympy.simplify(determinant(p.rotation)) == 1


@pytest.mark.parametrize("axis", [(1, 1, 1), (1, 2, 0.5), (0.36, -0.48, 0.8)])
@pytest.mark.parametrize("moments", [(2.0, 2.0, 3.0), (2.0, 3.0, 3.0), (2.0, 2.0, 2.0)])
def test_axes_of_equal_moments_do_not_move_when_last_digits_do(moments, axis):
    """The axes of a general routine would turn by more than 20 degrees."""
    axes = [a.components() for a in tilted(moments, axis, 0.8)[0].principal().axes]
    for seed in range(6):
        again = tilted(moments, axis, 0.8, noise=4e-16, seed=seed)[0].principal()
        assert close([a.components() for a in again.axes], axes, 1e-14)


def test_nearly_equal_moments_are_reported_against_the_noise_of_the_data():
    I, _ = tilted((2.0, 2.001, 3.0), (0.0, 0.0, 1.0), 0.3)
    assert all(I.principal().determined)
    doubtful = I.principal(noise=5e-4)
    assert doubtful.determined == (False, False, True)
    assert "axes 1 and 2 are not determined by data with a relative error of 0.0005" in str(
        doubtful
    )
    assert "all axes are determined" in str(I.principal())
    assert close(doubtful.gaps[0], 1e-3, 1e-12)


def test_block_of_two_in_symbols_without_cube_roots():
    a, b, c, d = sympy.symbols("a b c d", positive=True)
    values = {a: 5.0, b: 3.0, c: 4.0, d: 0.8}
    for n in range(3):
        products = [d if k == n else 0 for k in range(3)]
        I = Inertia(Frame("body"), (a, b, c), products)
        p = I.principal()
        roots = {x.exp for m in p.moments for x in m.atoms(sympy.Pow) if not x.exp.is_Integer}
        assert roots == {sympy.Rational(1, 2)}
        V, matrix, found = (
            np.array(sympy.Matrix(x).subs(values), dtype=float)
            for x in ([tuple(axis) for axis in p.axes], I.matrix, p.moments)
        )
        assert np.allclose(V @ matrix @ V.T, np.diag(found.ravel()), atol=1e-14)
        assert abs(np.linalg.det(V) - 1) < 1e-14
        free = (n + 2) % 3
        assert p.axes[free].components() == tuple(int(k == free) for k in range(3))


@pytest.mark.parametrize(
    "given",
    [
        (8.0, 11.2, 11.0, 3.0, 0.1, -3.0),
        (2.0, 2.0, 2.0, 0.0, 0.0, 0.0),
        (2.0, 2.0, 3.0, 0.0, 0.0, 0.0),
        (3.0, 2.0, 4.0, 0.0, 0.0, 0.0),
        (3.0, 3.0, 3.0, 1.0, 1.0, 1.0),
    ],
)
def test_a_full_matrix_is_turned_by_a_compiled_formula_even_where_moments_are_equal(given):
    """Ascending and right-handed, on floats and on arrays. A closed form once had no value, or gave
    the same axis twice.
    """

    def formula(a, b, c, d, e, f):
        I = Inertia(Frame("body"), (a, b, c), (d, e, f))
        found = I.principal()
        rows = *(axis.components() for axis in found.axes), *I.matrix
        return *found.moments, *(x for row in rows for x in row)

    run = compiled(formula)
    for values in (run(*given), run(*np.transpose([given, given]))):
        values = np.array([np.broadcast_to(x, 2)[-1] for x in values])
        moments, axes, matrix = values[:3], *values[3:].reshape(2, 3, 3)
        assert moments == pytest.approx(np.linalg.eigvalsh(matrix), rel=1e-14)
        assert matrix @ axes.T == pytest.approx(axes.T * moments, abs=2e-14)
        assert np.linalg.det(axes) == pytest.approx(1.0, rel=1e-14)


def test_symmetry_finds_itself():
    F = Frame("F")
    whole = box(1.0, 2.0, 3.0, F, mass=1.0)
    own = whole.inertia.symmetry()
    assert (own.kind, own.planes) == ("none", ("yz", "zx", "xy"))
    aside = whole.about(F.point("P", 0.5, 0.5, 0)).symmetry()
    assert (aside.axes, aside.planes) == (("z",), ("xy",))
    corner = whole.about(F.point("P", 0.5, 1.0, 1.5)).symmetry()
    assert (corner.axes, corner.planes) == ((), ())
    assert sphere(1.0, F, mass=1.0).inertia.symmetry().kind == "sphere"
    top = disk(1.0, F, "y", mass=1.0).inertia.symmetry()
    assert (top.kind, top.axis.components()) == ("top", (0, 1, 0))
    assert "a body of revolution about [0, 1, 0] in F" in str(top)
    assert "possible planes of symmetry: xy" in str(aside)


def test_symmetry_is_only_dynamic_seen_by_form_and_of_one_matrix():
    """A cylinder of the right length moves like a sphere: the matrix cannot tell."""
    F = Frame("F")
    assert cylinder(1.0, math.sqrt(3), F, mass=1.0).inertia.symmetry().kind == "sphere"
    m, r, h = sympy.symbols("m r h", positive=True)
    F = Frame("F")
    s = cylinder(r, h, F, "z", mass=m).inertia.symmetry()
    assert (s.kind, s.axis.components(), s.axes) == ("top", (0, 0, 1), ("x", "y", "z"))
    assert box(m, r, h, F, mass=m).inertia.symmetry().kind == "none"
    assert cylinder(r, h, F, "z", mass=m).about(F.point("P", r, 0, h)).symmetry().planes == ("zx",)
    with pytest.raises(MassError, match="a symmetry at each instant: ask for one"):
        Inertia(Frame("body"), (np.array([8.0, 9.0]), 11.0, 11.0)).symmetry()
