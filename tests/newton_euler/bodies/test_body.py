"""Chapters 5 and 7: centre of mass, rigid bodies, angular momentum, inertia matrix, parallel axes.

The oracles are sums over mass points, typed out in plain numbers.
"""

import math
import random
from fractions import Fraction

import numpy as np
import pytest
import sympy
from hypothesis import example, given, settings
from hypothesis import strategies as st

from newton_euler import (
    Body,
    Dimension,
    Frame,
    Inertia,
    Vector,
    centre_of_mass,
    compiled,
    composite,
    cos,
    moving,
    particle,
    sin,
)
from newton_euler.algebra import FrameError, TermError
from newton_euler.bodies import MassError, disk, plate, rod, sphere
from newton_euler.kinematics import along, apply, product, transpose
from tests.kinds import KINDS, close, every_kind, number, numbers, within

laws = settings(max_examples=60)
EPS = 2.0**-52
small = within(40 * EPS, 26)


# -- the oracle: mass points


def points(seed=1, count=7):
    """Masses and positions, exact fractions, without symmetry."""
    dice = random.Random(seed)
    place = lambda: tuple(Fraction(dice.randint(-20, 20), 10) for _ in range(3))
    return [(Fraction(dice.randint(1, 30), 10), place()) for _ in range(count)]


def of_kind(kind, cloud):
    return [(numbers(kind, m), tuple(KINDS[kind](x) for x in r)) for m, r in cloud]


def bodies(cloud, frame):
    return [particle(m, frame.point(f"P{n}", *r), f"P{n}") for n, (m, r) in enumerate(cloud)]


def summed(cloud, f):
    total = 0
    for m, (x, y, z) in cloud:
        total = total + m * f(x, y, z)
    return total


def products_of(cloud):
    return tuple(summed(cloud, lambda *r, n=n: r[n] * r[(n + 1) % 3]) for n in range(3))


def matrix_of(cloud, about=(0, 0, 0)):
    """(7.9), (7.13) typed out over the points."""
    a, b, c = about
    shifted = [(m, (x - a, y - b, z - c)) for m, (x, y, z) in cloud]
    xx, yy, zz = (summed(shifted, lambda *r, n=n: r[n] * r[n]) for n in range(3))
    xy, yz, zx = products_of(shifted)
    return ((yy + zz, -xy, -zx), (-xy, zz + xx, -yz), (-zx, -yz, xx + yy))


def cloud_in(kind, seed=1):
    """A body frame at rest, the points in it, and their composite."""
    cloud, frame = of_kind(kind, points(seed)), Frame("body")
    return frame, cloud, composite("whole", bodies(cloud, frame))


def spinning(kind):
    """Ground, and a body that turns three ways about a moving origin, with its point B."""
    a, b, c, d = numbers(kind, "0.4", "-0.7", "1.1", "0.5")
    ground = Frame("ground")
    seat = ground.point("B", moving(a, b, c), moving(b, d, a), moving(c, a, -d))
    yaw = ground.rotate("yaw", "z", moving(a, b, c), origin=seat)
    body = yaw.rotate("pitch", "x", moving(c, d, a)).rotate("body", "y", moving(b, c, d))
    return ground, body, body.point("B", 0, 0, 0)


# -- 5.1, 5.2


@every_kind
def test_eqn_5_1_to_5_3_force_is_the_rate_of_momentum(kind):
    m, t = numbers(kind, "2.5", "0.3")
    ground = Frame("ground")
    P = ground.point("P", *along(lambda t: (t**3, sin(2 * t), 1 / (1 + t)), t))
    momentum, force = particle(m, P).momentum(ground), m * P.acceleration(ground)
    tiny = small(kind, 20)
    assert close(momentum, (m * 3 * t * t, 2 * m * cos(2 * t), -m / (1 + t) ** 2), tiny)
    assert close(momentum.rate(ground), force, tiny)
    assert close(force, (6 * m * t, -4 * m * sin(2 * t), 2 * m / (1 + t) ** 3), tiny)


@every_kind
def test_eqn_5_4_centre_of_mass_of_particles(kind):
    cloud, ground = of_kind(kind, points()), Frame("ground")
    total = summed(cloud, lambda x, y, z: 1)
    expected = [summed(cloud, lambda *r, n=n: r[n]) / total for n in range(3)]
    for given_as in (bodies(cloud, ground), [(m, ground.point("P", *r)) for m, r in cloud]):
        assert close(centre_of_mass(given_as).position(ground), expected, small(kind, 5))


@every_kind
def test_eqn_5_5_to_5_8_internal_forces_cancel_and_G_moves_under_the_external_ones(kind):
    """Three particles on springs under a field."""
    ground, cloud, moved = Frame("ground"), of_kind(kind, points(3, 3)), []
    stiffness, g = numbers(kind, "3.5", "9.8")
    total = outside = ground.vector(0, 0, 0)
    # (5.5): external force, and internal ones along the joining lines
    for m, r in cloud:
        pulls = [stiffness * sum(q[k] - r[k] for _, q in cloud) for k in range(3)]
        force, external = ground.vector(*pulls) - m * g * ground.k, -m * g * ground.k
        total, outside = total + force, outside + external
        P = ground.point("P", *(moving(x, x / 2, f / m) for x, f in zip(r, force, strict=True)))
        moved.append(particle(m, P))
    assert close(total, outside, small(kind, 200))  # (5.6)
    mass, G = sum(p.mass for p in moved), centre_of_mass(moved)
    assert close(mass * G.acceleration(ground), outside, small(kind, 500))  # (5.7)
    momentum = sum(p.momentum(ground) for p in moved)
    assert close(momentum, mass * G.velocity(ground), small(kind, 100))  # (5.8)
    assert close(particle(mass, G).momentum(ground).rate(ground), outside, small(kind, 500))


@every_kind
def test_eqn_5_9_and_5_11_collections_count_as_particles_in_their_centres(kind):
    ground, tiny = Frame("ground"), small(kind, 20)
    parts = bodies(of_kind(kind, points()), ground)
    place = lambda G: G.position(ground)
    halves = [composite("first", parts[:3]), composite("second", parts[3:])]
    whole, hole = composite("whole", parts), composite("hole", parts[5:])
    expected = place(centre_of_mass(parts))
    assert close(place(centre_of_mass(halves)), expected, tiny)
    assert close(place(composite("both", halves).centre), expected, tiny)
    rest = composite("rest", [whole], removed=[hole])
    assert close(place(rest.centre), place(centre_of_mass(parts[:5])), tiny)
    assert close(rest.mass, whole.mass - hole.mass, tiny)
    assert close(rest.inertia.matrix, composite("kept", parts[:5]).inertia.matrix, small(kind, 200))


# -- 5.4 to 5.9: rigid bodies


@every_kind
def test_eqn_5_10_and_5_14_to_5_17_centre_in_the_body_frame_and_positions_from_it(kind):
    ground, body, B = spinning(kind)
    cloud = of_kind(kind, points(2))
    parts = bodies(cloud, body)
    G = centre_of_mass(parts)
    assert G.frame is body
    total = summed(cloud, lambda x, y, z: 1)
    d = [summed(cloud, lambda *r, n=n: r[n]) / total for n in range(3)]
    assert close(G.position(body), d, small(kind, 5))
    r_G = B.position(ground) + ground.vector(*apply(body.rotation(ground), d))
    assert close(G.position(ground), r_G, small(kind, 10))  # (5.17)
    assert close(centre_of_mass(parts, ground).position(ground), r_G, small(kind, 10))  # (5.4)


@every_kind
def test_eqn_5_12_and_5_13_centre_of_a_continuum_is_that_of_its_cells(kind):
    """Richardson's extrapolation of n particles gives the rod's centre and moment."""
    m, length = numbers(kind, 3, "1.6")
    frame = Frame("rod")

    def cells(n):
        places = (length * (2 * k + 1) / (2 * n) for k in range(n))
        return composite("cells", [particle(m / n, frame.point("c", x, 0, 0)) for x in places])

    whole = rod(length, frame.point("middle", length / 2, 0, 0), "x", mass=m)
    assert close(cells(8).centre.position(frame), whole.centre.position(frame), small(kind, 5))
    coarse, fine = (cells(n).about(frame).moments[1] for n in (6, 12))
    assert close((4 * fine - coarse) / 3, whole.about(frame).moments[1], small(kind, 20))


@every_kind
def test_eqn_5_18_and_5_19_all_frames_fixed_in_a_body_turn_alike(kind):
    ground, body, _ = spinning(kind)
    a, b, c = numbers(kind, "0.7", "-0.2", "1.3")
    P, O1, O2 = body.point("P", b, c, a), body.point("O1", 0, 0, 0), body.point("O2", a, b, c)
    omega, tiny = body.angular_velocity(ground), small(kind, 10)
    assert close(body.rotate("other", "y", a, origin=O2).angular_velocity(ground), omega, tiny)
    for O in (O1, O2):
        assert close(P.velocity(ground), O.velocity(ground) + omega.cross(P - O), tiny)


# -- 7.1, 7.2: angular momentum and inertia matrix


@every_kind
def test_eqn_7_1_to_7_8_angular_momentum_of_particles_is_I_omega(kind):
    ground, body, B = spinning(kind)
    parts = bodies(of_kind(kind, points()), body)
    tiny, whole = small(kind, 200), composite("whole", parts)
    # (7.3) to (7.5)
    assert close(sum(p.momentum(ground) for p in parts), whole.momentum(ground), tiny)
    relative = [(p, p.centre - B, p.centre.velocity(ground) - B.velocity(ground)) for p in parts]
    H = sum(d.cross(p.mass * v) for p, d, v in relative)  # (7.6)
    omega = body.angular_velocity(ground)
    expanded = sum(p.mass * (d.dot(d) * omega - omega.dot(d) * d) for p, d, _ in relative)
    assert close(H, expanded, tiny)  # (7.7)
    assert close(H, whole.about(B).times(omega), tiny)  # (7.8), (7.12), (7.17)
    assert close(H, whole.angular_momentum(ground, about=B), tiny)


@every_kind
def test_eqn_7_9_to_7_13_the_signs_of_the_matrix(kind):
    body, cloud, whole = cloud_in(kind)
    I = whole.about(body)
    assert close(I.matrix, matrix_of(cloud), small(kind, 50))
    xy, yz, zx = products_of(cloud)
    assert close(I.products, (xy, yz, zx), small(kind, 50))  # without a minus sign
    omega = body.vector(*numbers(kind, 1, -2, "0.5"))
    (x, y, z), (xx, yy, zz) = omega, I.moments
    H = (xx * x - xy * y - zx * z, -xy * x + yy * y - yz * z, -zx * x - yz * y + zz * z)  # (7.11)
    assert close(I.times(omega), H, small(kind, 200))


@every_kind
def test_eqn_7_14_the_matrix_of_parts_is_their_sum(kind):
    body, cloud, whole = cloud_in(kind)
    parts, tiny = bodies(cloud, body), small(kind, 100)
    first, second = composite("first", parts[:4]), composite("second", parts[4:])
    total = first.about(body) + second.about(body)
    assert close(total.matrix, whole.about(body).matrix, tiny)
    assert close(total.mass, first.mass + second.mass, tiny)
    assert close(total.about(total.centre).matrix, whole.inertia.matrix, tiny)
    both = composite("both", [first, second]).about(body)
    assert set(both.terms) == {"first", "second"}
    assert close(both.without("second").matrix, first.about(body).matrix, tiny)


# -- 7.7, 7.8: other points


@every_kind
def test_eqn_7_22_and_7_23_angular_momentum_about_B_and_about_G(kind):
    ground, body, B = spinning(kind)
    whole, tiny = composite("whole", bodies(of_kind(kind, points()), body)), small(kind, 100)
    H, G = whole.angular_momentum(ground, about=B), whole.centre
    rate = G.velocity(ground) - B.velocity(ground)
    assert close(H.terms["orbital"], (G - B).cross(whole.mass * rate), tiny)
    assert close(H.terms["own"], whole.angular_momentum(ground), tiny)
    assert close(H, H.terms["orbital"] + H.terms["own"], tiny)
    assert "(7.23)" in str(H.explain()) or kind == "array"


@every_kind
def test_eqn_7_24_to_7_26_parallel_axes_between_any_two_points(kind):
    body, cloud, whole = cloud_in(kind)
    tiny, m, G = small(kind, 500), whole.mass, whole.centre
    places = [numbers(kind, *r) for r in ((1, -2, "0.5"), ("-0.3", "0.7", 2))]
    P, Q = (body.point(n, *r) for n, r in zip("PQ", places, strict=True))
    for point, r in zip((P, Q), places, strict=True):
        assert close(whole.inertia.about(point).matrix, matrix_of(cloud, r), tiny)
        assert close(whole.about(point).matrix, matrix_of(cloud, r), tiny)
    I = Inertia(P, whole.about(P).moments, whole.about(P).products, m, G)
    moved = I.about(Q)  # neither P nor Q is G
    assert close(moved.matrix, matrix_of(cloud, places[1]), tiny)
    assert close(moved.about(P).matrix, I.matrix, tiny)
    d2, d1 = G - Q, G - P
    shift = m * (d2.y**2 - d1.y**2 + d2.z**2 - d1.z**2)
    assert close(moved.moments[0] - I.moments[0], shift, tiny)
    assert close(moved.products[0] - I.products[0], m * (d2.x * d2.y - d1.x * d1.y), tiny)
    assert close(moved.without("transfer").matrix, I.matrix, 0)


def test_going_far_away_and_back_loses_no_more_than_the_far_matrix_has():
    """Entries of order 1 keep only the round-off of m d^2 = 1e6, which is 1e-10."""
    body, _, whole = cloud_in("float")
    far = whole.inertia.about(body.point("far", 200.0, 200.0, 200.0))
    assert close(far.about(whole.centre).matrix, whole.inertia.matrix, 4 * EPS * max(far.moments))


@every_kind
def test_eqn_7_27_radius_of_gyration(kind):
    m, length = numbers(kind, 3, "1.6")
    frame = Frame("rod")
    body = rod(length, frame, "x", mass=m)
    k = body.inertia.radius_of_gyration("y")
    assert close(12 * k * k, length * length, small(kind, 5))
    about = body.about(frame.point("end", length / 2, 0, 0)).radius_of_gyration(frame.k)
    assert close(3 * about * about, length * length, small(kind, 5))


# -- axes


@every_kind
def test_a_matrix_in_turned_axes_is_that_of_the_turned_points(kind):
    body, cloud, whole = cloud_in(kind)
    turned = body.rotate("turned", numbers(kind, 1, 2, 2), numbers(kind, "-1.1"))
    if kind != "sympy":  # SymPy's evalf takes minutes for nested turns
        turned = turned.rotate("twice", "z", numbers(kind, "0.7"))
    I, R, tiny = whole.about(body), turned.rotation(body), small(kind, 200)
    there = I.expressed_in(turned)
    assert close(there.matrix, matrix_of([(m, apply(transpose(R), r)) for m, r in cloud]), tiny)
    assert close(there.matrix, product(transpose(R), I.matrix, R), tiny)
    if kind != "sympy":
        assert close(there.expressed_in(body).matrix, I.matrix, tiny)


def test_a_body_of_revolution_keeps_its_matrix_exactly_when_it_spins():
    phi, A, C = sympy.symbols("phi A C", positive=True)
    body = Frame("body")
    spun, turned = body.rotate("spun", "z", phi), body.rotate("q", "z", 0.7)
    assert Inertia(body, (A, A, C)).expressed_in(spun).matrix == ((A, 0, 0), (0, A, 0), (0, 0, C))
    ball = Inertia(body, (A, A, A)).expressed_in(spun.rotate("tilted", "x", phi))
    assert ball.matrix == ((A, 0, 0), (0, A, 0), (0, 0, A))
    assert Inertia(body, (0.1, 0.1, 0.15)).expressed_in(turned).moments == (0.1, 0.1, 0.15)


# -- laws

floats = st.floats(-3, 3, allow_subnormal=False).map(lambda x: round(x, 6))
clouds = st.lists(
    st.tuples(st.floats(0.1, 5), st.tuples(floats, floats, floats)), min_size=1, max_size=6
)
places = st.tuples(floats, floats, floats)
turns = st.tuples(st.sampled_from("xyz"), st.floats(-4, 4))


def body_of(cloud):
    frame = Frame("body")
    return frame, composite("cloud", bodies(cloud, frame))


@laws
@given(clouds, turns, places)
@example([(1.0, (0.0, 0.0, 0.0))], ("x", 1e-100), (0.0, 0.0, 1.0))
def test_every_cloud_of_masses_passes_the_check_in_any_axes_about_any_point(cloud, turn, r):
    frame, body = body_of(cloud)
    I = body.about(frame.point("P", *r)).expressed_in(frame.rotate("a", *turn))
    assert I.check() is I
    a, b, c = I.moments
    assert min(a + b - c, b + c - a, c + a - b) >= -1e-12 * max(I.moments)


# -- the other kinds of number


def test_formulas_can_be_compiled_and_have_the_dimension_of_m_r_squared():
    def about(m, a, x, y):
        frame = Frame("body")
        parts = [disk(a, frame, "z", mass=m), rod(a, frame.point("C", x, y, a), "y", mass=2 * m)]
        return composite("both", parts).about(frame.point("P", y, x, a)).matrix

    given = (1.5, 0.4, 0.3, -0.7)
    assert close(compiled(about)(*given), about(*given), 4 * EPS)
    mass, length = Dimension(1), Dimension(0, 1)
    entries = [x for row in about(mass, length, length, length) for x in row]
    assert all(x == 0 or x == mass * length**2 for x in entries)
    heights = np.linspace(0.0, 1.0, 5)
    many = compiled(about)(1.5, 0.4, heights, -0.7)
    assert close(many[0][0][3], about(1.5, 0.4, heights[3], -0.7)[0][0], 1e-14)


def test_a_matrix_of_many_instants_is_an_array_and_shows_as_a_matrix():
    frame = Frame("body")
    I = sphere(np.array([1.0, 2.0]), frame.point("C", 1.0, 0, 0), mass=5.0).about(frame)
    assert I.to_array().shape == (3, 3, 2)
    assert close(I.to_array()[1, 1], np.array([7.0, 13.0]), 1e-14)
    assert disk(1.0, frame, "z", mass=12.0).inertia.to_array().shape == (3, 3)
    I = Inertia(Frame("b"), (2.0, 3.0, 4.0), (1.0, 0, 0))
    assert r"\begin{bmatrix}2&" in I._repr_latex_().replace(" ", "")
    shown = repr(Inertia(Frame("b"), (2.0, 3.0, 4.0)))
    assert shown == "Inertia(((2.0, 0, 0), (0, 3.0, 0), (0, 0, 4.0)) about origin of b in b)"


# -- refusals, and their words


UNIT = (1.0, 1.0, 1.0)
FAR = lambda body: body.point("Q", 1.0, 0, 0)


@pytest.mark.parametrize(("make", "words"), [
    (lambda f: Inertia(f, (1.0, 1.0, 3.0)), r"I_zz = 3 is larger than I_xx \+ I_yy = 2, by 1 \(triangle inequality\)"),
    (lambda f: Inertia(f, (-1.0, 1.0, 1.0)), r"I_xx = -1.0 is larger|no body has these moments"),
    (lambda f: Inertia(f, UNIT, (0, 2.0, 0)), r"product I_yz = 2.0 .* at most 0.25.*y\^2 and z\^2"),
    (lambda f: Inertia(f, (2.0, 2.0, 2.0), (0.8, 0.8, -0.8)), "principal moments break the triangle inequality"),
    (lambda f: Inertia(f, (1.0, 1.0, math.nan)), "not finite"),
    (lambda f: Inertia(f, UNIT, mass=-2.0), r"the mass must be positive, got -2.0"),
    (lambda f: Inertia(f, UNIT, mass=3.0, centre=FAR(f)),
     r"about origin of body the moments are smaller than mass and distance of Q alone make them"),
    (lambda f: Inertia(f, (np.array([1.0, 3.0]), 1.0, 1.0)), "no body has these moments"),
    (lambda f: Inertia(f, UNIT).about(FAR(f)),
     r"going from origin of body to Q needs the mass of the body; make it Inertia\(origin of body, moments, .*, centre=G\)"),
    (lambda f: Inertia(f, UNIT, mass=1.0).about(FAR(f)), "needs the place of its centre of mass"),
    (lambda f: Inertia(f, UNIT).radius_of_gyration("x"), "the radius of gyration needs the mass"),
    (lambda f: centre_of_mass([]), "give a body or a pair"),
    (lambda f: Inertia(f, UNIT).moment(0.0 * f.i), "zero vector"),
    (lambda f: Inertia(f, UNIT) + 3, "can only be added to one, got 3"),
    (lambda f: composite("part", [disk(1.0, f, "z", mass=1.0)], removed=[disk(1.0, f, "z", mass=2.0)]),
     r"total mass -1 must be positive: the removed parts"),
    (lambda f: composite("part", [disk(1.0, f, "z", mass=1.0)], removed=[disk(0.5, f.point("P", 3.0, 0, 0), "z", mass=0.5)]),
     r"part: do the removed parts lie inside of it, and only once"),
    (lambda f: particle(-1.0, f.origin), r"the mass of particle must be positive, got -1.0"),
])  # fmt: skip
def test_what_no_body_has_and_what_is_missing_is_refused_in_words(make, words):
    with pytest.raises(MassError, match=words):
        make(Frame("body"))


def test_a_matrix_with_the_other_sign_exists_and_its_terms_have_names():
    """A rod along (1, 1, 1) with some thickness."""
    body = Frame("body")
    assert Inertia(body, (2.0, 2.0, 2.0), (0.8, 0.8, 0.8))
    with pytest.raises(TermError, match="no term 'coriolis'; the terms are own, transfer"):
        plate(1.0, 1.0, body, mass=1.0).about(FAR(body)).without("coriolis")


def test_the_origin_of_a_turning_frame_is_not_taken_for_a_point_of_its_parent():
    ground = Frame("ground")
    C = ground.point("C", 1.0, 0, 0)
    rotor = ground.rotate("rotor", "z", rate=2.0, origin=C)
    for place in (rotor.origin, C):
        words = "C is a point of ground, and the origin of rotor: along whose axes"
        with pytest.raises(FrameError, match=words):
            Body("disk", 1.0, place, (1.0, 1.0, 2.0))
    words = "origin of tilted is a point of rotor, and the origin of tilted"
    with pytest.raises(FrameError, match=words):
        disk(1.0, rotor.rotate("tilted", "x", 0.1).origin, mass=1.0)
    body = Body("disk", 1.0, rotor, (1.0, 1.0, 2.0))
    assert body.frame is rotor
    assert body.angular_momentum(ground).components() == (0, 0, 4.0)
    assert Body("disk", 1.0, C, (1.0, 1.0, 2.0), frame=rotor).angular_momentum(ground).z == 4.0


def test_vectors_and_inertias_do_not_mix_silently():
    body = Frame("body")
    assert isinstance(Inertia(body, (1.0, 1.0, 1.0)).times(body.i), Vector)
    with pytest.raises(TypeError):
        Inertia(body, (1.0, 1.0, 1.0)) * body.i
    assert number(2 * Inertia(body, (1.0, 1.0, 1.0), mass=3.0, centre=body.origin).mass) == 6
