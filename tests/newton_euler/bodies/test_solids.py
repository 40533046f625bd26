"""Appendix B and related solids, each against Gauss-Legendre quadrature over a parametrisation
with its own area or volume element.
"""

import math

import numpy as np
import pytest
import sympy

from newton_euler import Frame, pi
from newton_euler.algebra import FrameError
from newton_euler.bodies import MassError
from newton_euler.bodies import solids as B
from tests.kinds import close, every_kind, numbers

R, L, A, C, W = 0.7, 1.6, 0.5, 0.9, 0.8  # radius, length, edges, half angle


def gauss(*limits):
    """Points (one array for each parameter) and weights of a tensor rule of 20 points each."""
    x, w = np.polynomial.legendre.leggauss(20)
    axes = [((a + b) / 2 + (b - a) / 2 * x, (b - a) / 2 * w) for a, b in limits]
    grids = np.meshgrid(*(nodes for nodes, _ in axes), indexing="ij")
    weights = np.meshgrid(*(w for _, w in axes), indexing="ij")
    return [g.ravel() for g in grids], np.prod([w.ravel() for w in weights], axis=0)


TURN = (-math.pi, math.pi)


def fan(radii, angles, length=None):
    """Ring, disk or sector normal to x, toward y; a curve for one radius, thick by ``length``."""
    others = ([radii] if isinstance(radii, tuple) else []) + ([side(length)] if length else [])
    (a, *others), w = gauss(angles, *others)
    r = others[0] if isinstance(radii, tuple) else radii
    return others[-1] if length else 0 * a, r * np.cos(a), r * np.sin(a), w * r


def blocks(x, y, z):
    limits = [p for p in (x, y, z) if p]
    grids, w = gauss(*limits)
    grids = iter(grids)
    return (*(next(grids) if p else 0 * w for p in (x, y, z)), w)


def ball(radii, angles=(0, math.pi)):
    limits = [angles, TURN] + ([radii] if isinstance(radii, tuple) else [])
    (a, b, *r), w = gauss(*limits)
    r = r[0] if r else radii
    across = r * np.sin(a)
    return r * np.cos(a), across * np.cos(b), across * np.sin(b), w * r * across


def solid_cone():
    (x, b, s), w = gauss((0, L), TURN, (0, 1))
    r = R * x / L
    return x, s * r * np.cos(b), s * r * np.sin(b), w * s * r * r


def egg():
    x, y, z, w = ball((0, 1))
    return A * x, R * y, L * z, A * R * L * w


def side(n):
    return (-n / 2, n / 2)


# name: (sizes, the points of the body along x); the first seven rows are Appendix B
HALF = math.pi / 2
TABLE = {
    "rod": ((L,), lambda: blocks(side(L), None, None)),
    "plate": ((A, L), lambda: blocks(None, side(A), side(L))),
    "box": ((R, A, L), lambda: blocks(side(R), side(A), side(L))),
    "disk": ((R,), lambda: fan((0, R), TURN)),
    "cylinder": ((R, L), lambda: fan((0, R), TURN, L)),
    "cone": ((R, L), solid_cone),
    "sphere": ((R,), lambda: ball((0, R))),
    "ring": ((R,), lambda: fan(R, TURN)),
    "arc": ((R, C), lambda: fan(R, (-C, C))),
    "half ring": ((R,), lambda: fan(R, (-HALF, HALF))),
    "annulus": ((A, R), lambda: fan((A, R), TURN)),
    "sector": ((R, C), lambda: fan((0, R), (-C, C))),
    "half disk": ((R,), lambda: fan((0, R), (-HALF, HALF))),
    "tube": ((A, R, L), lambda: fan((A, R), TURN, L)),
    "wedge": ((R, C, L), lambda: fan((0, R), (-C, C), L)),
    "hemisphere": ((R,), lambda: ball((0, R), (0, HALF))),
    "ellipsoid": ((A, R, L), egg),
    "cylindrical shell": ((R, L), lambda: fan(R, TURN, L)),
    "spherical shell": ((R,), lambda: ball(R)),
}


def make(name, frame, *sizes, **matter):
    """The solid of this name in the frame; its last size may be an axis."""
    axis = sizes[-1:] if isinstance(sizes[-1], str) else ()
    sizes = sizes[: len(sizes) - len(axis)]
    return getattr(B, name.replace(" ", "_"))(*sizes, frame, *axis, **matter)


every_solid = pytest.mark.parametrize("name", TABLE)


def integrals(points):
    """Content, centre, inertia matrix about the origin for unit density."""
    x, y, z, w = points
    content = w.sum()
    moments = [(w * s).sum() for s in (y * y + z * z, z * z + x * x, x * x + y * y)]
    xy, yz, zx = ((w * s).sum() for s in (x * y, y * z, z * x))
    matrix = (moments[0], -xy, -zx), (-xy, moments[1], -yz), (-zx, -yz, moments[2])
    return content, [(w * s).sum() / content for s in (x, y, z)], matrix


@every_solid
def test_appendix_B_by_quadrature(name):
    """Content, centre and matrix for unit density; for the cone about its apex, as in the book."""
    given, sample = TABLE[name]
    frame = Frame("solid")
    body = make(name, frame, *given, density=1.0)
    content, centre, matrix = integrals(sample())
    assert close(body.mass, content, 1e-12)
    assert close(body.centre.position(frame), centre, 1e-12)
    assert close(body.about(frame).matrix, matrix, 1e-12)
    assert body.check() is body


@every_solid
@every_kind
def test_appendix_B_on_every_kind_of_number(name, kind):
    given, _ = TABLE[name]
    frame = Frame("solid")
    m, *sizes = numbers(kind, "2.5", *given)
    body = make(name, frame, *sizes, mass=m)
    known = make(name, frame, *map(float, given), mass=2.5)
    if kind != "array":
        assert close(body.about(frame).matrix, known.about(frame).matrix, 1e-14)
        assert close(body.centre.position(frame), known.centre.position(frame), 1e-14)
    elif name not in ("arc", "sector", "wedge"):  # mass and lengths scale together, angles do not
        cubes = np.array([1.0, 1.0625, 0.875]) ** 3
        scaled = [[x * cubes for x in row] for row in known.about(frame).matrix]
        assert close(body.about(frame).matrix, scaled, 1e-13)
    if kind == "mpmath":
        exact = make(name, frame, *numbers("sympy", *given, 1)[:-1], mass=sympy.Rational(5, 2))
        assert close(body.inertia.moments, exact.inertia.moments, 1e-27)


ROUND = ("sphere", "spherical shell")  # these have no axis
FANS = ("arc", "sector", "half ring", "half disk", "wedge")  # these point along another axis


@pytest.mark.parametrize("name", [n for n in TABLE if n not in ROUND])
@pytest.mark.parametrize("n", [1, 2], ids=["along y", "along z"])
def test_other_axes_follow_each_other(name, n):
    given, _ = TABLE[name]
    F = Frame("F")
    straight, body = make(name, F, *given, mass=2.0), make(name, F, *given, "xyz"[n], mass=2.0)
    turned = lambda c: tuple(c[(k - n) % 3] for k in range(3))
    assert close(body.inertia.moments, turned(straight.inertia.moments), 0)
    r = straight.centre.position(F).components()
    assert close(body.centre.position(F), turned(r), 0)


@pytest.mark.parametrize("name", [n for n in TABLE if n not in ROUND + FANS])
def test_a_minus_sign_turns_the_body_back_to_front(name):
    given, _ = TABLE[name]
    F = Frame("F")
    straight, body = make(name, F, *given, mass=2.0), make(name, F, *given, "-x", mass=2.0)
    x, y, z = straight.centre.position(F)
    assert close(body.centre.position(F), (-x, y, z), 0)
    assert body.inertia.moments == straight.inertia.moments


def test_a_fan_may_be_directed_anywhere_in_its_plane_and_thin_walls_keep_their_digits():
    F = Frame("F")
    up = B.half_disk(1.0, F, "x", "-z", mass=1.0)
    assert close(up.centre.position(F), (0, 0, -4 / (3 * math.pi)), 1e-16)
    assert close(up.about(F).moments, (0.5, 0.25, 0.25), 1e-15)
    F = Frame("F")
    thin, limit = B.tube(1 - 1e-9, 1.0, L, F, mass=1.0), B.cylindrical_shell(1.0, L, F, mass=1.0)
    assert close(thin.inertia.moments, limit.inertia.moments, 2e-9)


@every_kind
@pytest.mark.parametrize("corners", [2, 3, 4], ids=["rod", "triangle", "tetrahedron"])
def test_simplex_between_points_anywhere(kind, corners):
    """Moments of a simplex are polynomials of degree two, so Gauss is exact."""
    places = [(0.5, -0.25, 1), (2, 0.5, 0.25), (-1, 1.5, 0.5), (0.25, 0.75, -2)][:corners]
    F = Frame("F")
    P = [F.point(f"P{n}", *numbers(kind, *r)) for n, r in enumerate(places)]
    body = B.simplex(*P, density=numbers(kind, 2))
    first, *edges = (np.array(r) for r in places)
    edges = [e - first for e in edges]
    u, w = gauss(*[(0, 1)] * len(edges))
    for n in range(len(edges)):  # Duffy: the unit cube folded to the simplex
        w = w * np.prod([1 - u[k] for k in range(n)], axis=0) if n else w
    shares, left = [], 1.0
    for t in u:
        shares.append(left * t)
        left = left * (1 - t)
    r = first[:, None] + sum(e[:, None] * s for e, s in zip(edges, shares, strict=True))
    size = math.sqrt(np.linalg.det(np.array(edges) @ np.transpose(edges)))  # by Gram
    content, centre, matrix = integrals((*r, 2 * size * w))
    if kind == "array":
        points = (F.point("P", *(np.array([float(x)] * 2) for x in p)) for p in places)
        body = B.simplex(*points, density=2.0)
    assert close(body.mass, content, 1e-12)
    assert close(body.centre.position(F), centre, 1e-12)
    assert close(body.about(F).matrix, matrix, 1e-11)


@pytest.mark.parametrize(("make", "error", "words"), [
    (lambda F: B.disk(-1.0, F, mass=1.0), MassError, "the radius of disk must be positive, got -1.0; to cut something out"),
    (lambda F: B.tube(1.0, 0.5, 1.0, F, mass=1.0), MassError, "the wall of tube must be positive"),
    (lambda F: B.disk(1.0, F), MassError, "disk needs either mass= or density= .* got none"),
    (lambda F: B.disk(1.0, F, mass=1.0, density=1.0), MassError, "disk needs either mass= or density= .* not both"),
    (lambda F: B.disk(1.0, F, mass=0), MassError, "the mass of disk must be positive, got 0"),
    (lambda F: B.rod(math.nan, F, mass=1.0), MassError, "the length of rod must be positive, got nan"),
    (lambda F: B.disk(1.0, F, "q", mass=1.0), MassError, "an axis is 'x', 'y', 'z' or one of them with a minus sign, got 'q'"),
    (lambda F: B.half_disk(1.0, F, "x", "-x", mass=1.0), MassError,
     "half disk, normal to 'x', cannot point toward '-x'"),
    (lambda F: B.simplex(F.origin, mass=1.0), MassError, "a simplex has two to four corners, all Points; got "),
    (lambda F: B.simplex(*(F.point("P", x, 0, 0) for x in (0.0, 1.0, 2.0)), density=1.0), MassError,
     "the mass of triangle must be positive, got 0"),
    (lambda F: B.disk(1.0, (0, 0, 0), mass=1.0), FrameError, r"place of disk is a Point or a Frame, .*; got \(0, 0, 0\)"),
])  # fmt: skip
def test_solids_that_do_not_exist_are_refused(make, error, words):
    with pytest.raises(error, match=words):
        make(Frame("F"))


def test_expressions_are_taken_as_positive():
    r, rho = sympy.symbols("r rho")
    assert B.disk(r, Frame("F"), density=rho).mass == sympy.pi * rho * r**2 == pi(r) * rho * r**2
