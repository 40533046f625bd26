"""The worked examples of 5.5, 5.6, 7.3, 7.5, 7.9 and 7.10: a thin rod, three rods, a machine part."""

import numpy as np
import sympy

from newton_euler import Frame
from newton_euler.bodies.solids import rod
from newton_euler.chapters.examples.ch07 import machine_part, thin_rod, three_rods
from tests.kinds import close, every_kind, numbers


def matrix_of(cloud, about):
    """(7.9), (7.13) typed out over mass points (m, (x, y, z))."""
    shifted = [(m, [u - v for u, v in zip(r, about, strict=True)]) for m, r in cloud]
    xx, yy, zz = (sum(m * r[n] * r[n] for m, r in shifted) for n in range(3))
    xy, yz, zx = (sum(m * r[n] * r[k] for m, r in shifted) for n, k in ((0, 1), (1, 2), (2, 0)))
    return ((yy + zz, -xy, -zx), (-xy, zz + xx, -yz), (-zx, -yz, xx + yy))


M, L = sympy.symbols("m l", positive=True)
UNIT = M * L**2 / 12


def test_example_5_5_body_of_three_rods():
    body, bare = three_rods(M, L), thin_rod(M, L, exact=True)
    assert body.centre.position(body.frame).components() == (0, L / 6, L / 6)
    assert bare.centre.position(bare.frame).components() == (L / 2, 0, 0)


def test_example_5_6_machine_part_of_sheet():
    r, h, s, t, rho = sympy.symbols("r h s t rho", positive=True)
    part = machine_part(r, h, s, t, rho)
    expected = (-sympy.Rational(2, 3) * r**3 + r * h**2 - sympy.pi * s**2 * h / 2) / (
        sympy.pi * r**2 / 2 + 2 * r * h - sympy.pi * s**2
    )
    x, y, z = part.centre.position(part.frame)
    assert (x, y) == (0, 0)
    assert sympy.simplify(z - expected) == 0  # independent of t and rho


def test_example_7_3_thin_rod_about_its_middle_and_its_end():
    bare, found = thin_rod(M, L, exact=True), thin_rod(3.0, 1.6)
    assert bare.about(bare.frame).moments == (0, 4 * UNIT, 4 * UNIT)
    assert bare.about(bare.frame).products == (0, 0, 0)
    assert bare.inertia.moments == (0, UNIT, UNIT)
    assert close(found.about(found.frame).moments, (0, 2.56, 2.56), 1e-14)


def test_example_7_3_three_rod_assembly():
    body = three_rods(12, 1)
    assert close(body.about(body.frame).matrix, ((8, -3, 3), (-3, 11, 0), (3, 0, 11)), 0)
    symbols = three_rods(M, L)
    expected = sympy.Matrix([[8, -3, 3], [-3, 11, 0], [3, 0, 11]]) * UNIT
    assert sympy.Matrix(symbols.about(symbols.frame).matrix) == expected


@every_kind
def test_example_7_5_principal_axes_of_the_three_rods(kind):
    body = three_rods(numbers(kind, 12), numbers(kind, 1))
    p = body.about(body.frame).principal()
    scale = np.array([1.0, 1.0625, 0.875]) ** 3 if kind == "array" else 1
    small = 1e-13 if kind in ("float", "array") else 1e-25
    assert close(p.moments, (5 * scale, 11 * scale, 14 * scale), small)
    for axis, printed in zip(p.axes, ((2, 1, -1), (0, 1, 1), (1, -1, 1)), strict=True):
        length = sum(x * x for x in printed)
        assert close([x * abs(x) * length for x in axis], [x * abs(x) for x in printed], 20 * small)


def test_example_7_5_in_symbols_is_exact():
    body = three_rods(M, L)
    p, root = body.about(body.frame).principal(), sympy.sqrt
    assert p.moments == (5 * UNIT, 11 * UNIT, 14 * UNIT)
    assert [v.components() for v in p.axes] == [
        (root(6) / 3, root(6) / 6, -root(6) / 6), (0, root(2) / 2, root(2) / 2), (root(3) / 3, -root(3) / 3, root(3) / 3)]  # fmt: skip


def test_example_7_9_radii_of_gyration():
    body, bare = three_rods(M, L), rod(L, Frame("rod"), "x", mass=M).inertia
    of_three = body.about(body.frame).radius_of_gyration("x")
    assert sympy.simplify(of_three - sympy.sqrt(2) * L / 3) == 0
    assert sympy.simplify(bare.radius_of_gyration("y") - L / (2 * sympy.sqrt(3))) == 0


def test_example_7_10_three_rods_about_their_centre_with_the_whole_mass():
    """The book transfers with the mass of one rod; 3 m is right, and mass points say so."""
    I = three_rods(M, L).inertia
    assert I.moments == (6 * UNIT, 10 * UNIT, 10 * UNIT)
    assert I.products == (3 * UNIT, -UNIT, -3 * UNIT)
    n = 400
    s = [(k + 0.5) / n for k in range(n)]
    places = [p for x in s for p in ((-0.5, 0.0, x), (x - 0.5, 0.0, 0.0), (0.5, x, 0.0))]
    expected = matrix_of([(1 / n, place) for place in places], (0, 1 / 6, 1 / 6))
    assert close(three_rods(1.0, 1.0).inertia.matrix, expected, 1.0 / n**2)


def test_example_7_10_machine_part():
    r, h, s, t, rho = sympy.symbols("r h s t rho", positive=True)
    part = machine_part(r, h, s, t, rho)
    I = part.about(part.frame)
    pi, R = sympy.pi, sympy.Rational
    expected = (
        pi * r**4 / 4 + R(2, 3) * (r**2 + h**2) * r * h - pi * s**2 * (s**2 / 2 + h**2 / 4),
        pi * r**4 / 8 + R(2, 3) * r * h**3 - pi * s**2 * (s**2 / 4 + h**2 / 4),
        pi * r**4 / 8 + R(2, 3) * r**3 * h - pi * s**4 / 4,
    )
    assert all(sympy.expand(a - rho * t * b) == 0 for a, b in zip(I.moments, expected, strict=True))
    assert I.products == (0, 0, 0)
