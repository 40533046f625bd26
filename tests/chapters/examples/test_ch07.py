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


def test_example_5_5_body_of_three_rods():
    m, length = sympy.symbols("m l", positive=True)
    body = three_rods(m, length)
    assert body.centre.position(body.frame).components() == (0, length / 6, length / 6)
    bare = thin_rod(m, length, exact=True)
    assert bare.centre.position(bare.frame).components() == (length / 2, 0, 0)


def test_example_5_6_machine_part_of_sheet():
    r, h, s, t, rho = sympy.symbols("r h s t rho", positive=True)
    part = machine_part(r, h, s, t, rho)
    expected = (-sympy.Rational(2, 3) * r**3 + r * h**2 - sympy.pi * s**2 * h / 2) / (
        sympy.pi * r**2 / 2 + 2 * r * h - sympy.pi * s**2
    )
    x, y, z = part.centre.position(part.frame)
    assert (x, y) == (0, 0)
    assert sympy.simplify(z - expected) == 0  # independent of t and rho


def test_example_5_5_and_7_3_the_rod_in_numbers_and_symbols():
    m, length = sympy.symbols("m l", positive=True)
    exact, found = thin_rod(m, length, exact=True), thin_rod(3.0, 1.6)
    assert exact.about(exact.frame).moments == (0, m * length**2 / 3, m * length**2 / 3)
    assert close(found.about(found.frame).moments, (0, 2.56, 2.56), 1e-14)


def test_example_7_3_thin_rod_about_its_middle_and_its_end():
    m, length = sympy.symbols("m l", positive=True)
    bare = thin_rod(m, length, exact=True)
    third = m * length**2 / 3
    assert bare.about(bare.frame).moments == (0, third, third)
    assert bare.about(bare.frame).products == (0, 0, 0)
    assert bare.inertia.moments == (0, third / 4, third / 4)


def test_example_7_3_three_rod_assembly():
    m, length = sympy.symbols("m l", positive=True)
    body = three_rods(m, length)
    unit = m * length**2 / 12
    assert body.about(body.frame).matrix == (
        (8 * unit, -3 * unit, 3 * unit),
        (-3 * unit, 11 * unit, 0),
        (3 * unit, 0, 11 * unit),
    )


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
    m, length = sympy.symbols("m l", positive=True)
    body = three_rods(m, length)
    p = body.about(body.frame).principal()
    unit = m * length**2 / 12
    assert p.moments == (5 * unit, 11 * unit, 14 * unit)
    root = sympy.sqrt
    assert [v.components() for v in p.axes] == [
        (root(6) / 3, root(6) / 6, -root(6) / 6), (0, root(2) / 2, root(2) / 2), (root(3) / 3, -root(3) / 3, root(3) / 3)]  # fmt: skip


def test_example_7_9_radii_of_gyration():
    m, length = sympy.symbols("m l", positive=True)
    body = three_rods(m, length)
    assert (
        sympy.simplify(body.about(body.frame).radius_of_gyration("x") - sympy.sqrt(2) * length / 3)
        == 0
    )
    assert (
        sympy.simplify(
            rod(length, Frame("rod"), "x", mass=m).inertia.radius_of_gyration("y")
            - length / (2 * sympy.sqrt(3))
        )
        == 0
    )


def test_example_7_10_three_rods_about_their_centre_with_the_whole_mass():
    """The book transfers with the mass of one rod; 3 m is right, and mass points say so."""
    m, length = sympy.symbols("m l", positive=True)
    unit = m * length**2
    I = three_rods(m, length).inertia
    assert I.moments == (unit / 2, 5 * unit / 6, 5 * unit / 6)
    assert I.products == (unit / 4, -unit / 12, -unit / 4)
    n = 400
    s = [(k + 0.5) / n for k in range(n)]
    cloud = (
        [(1 / n, (-0.5, 0.0, x)) for x in s]
        + [(1 / n, (x - 0.5, 0.0, 0.0)) for x in s]
        + [(1 / n, (0.5, x, 0.0)) for x in s]
    )
    assert close(
        three_rods(1.0, 1.0).inertia.matrix, matrix_of(cloud, (0, 1 / 6, 1 / 6)), 1.0 / n**2
    )


def test_example_7_10_machine_part():
    r, h, s, t, rho = sympy.symbols("r h s t rho", positive=True)
    part = machine_part(r, h, s, t, rho)
    I = part.about(part.frame)
    pi, R = sympy.pi, sympy.Rational
    expected = (
        pi * rho * r**4 * t / 4
        + R(2, 3) * rho * (r**2 + h**2) * r * h * t
        - pi * rho * s**2 * t * (s**2 / 2 + h**2 / 4),
        pi * rho * r**4 * t / 8
        + R(2, 3) * rho * r * h**3 * t
        - pi * rho * s**2 * t * (s**2 / 4 + h**2 / 4),
        pi * rho * r**4 * t / 8 + R(2, 3) * rho * r**3 * h * t - pi * rho * s**4 * t / 4,
    )
    assert all(sympy.expand(a - b) == 0 for a, b in zip(I.moments, expected, strict=True))
    assert I.products == (0, 0, 0)
