"""Chapter 6, (6.11)-(6.34): weight, projectiles and wind on the rotating Earth.

The oracle: (6.20) is linear with constant coefficients, and the exponential of its matrix solves it.
"""

import math

import mpmath as mp
import numpy as np
import pytest
import sympy

from newton_euler import Dimension, Frame, at, compiled, cos, moving, radians, sin, sqrt
from newton_euler.applications import earth as e
from newton_euler.dynamics.gravity import K, gravitational_field
from newton_euler.dynamics.newton import relative_acceleration
from newton_euler.kinematics import along
from tests.kinds import close, every_kind, first, numbers, within

BOOK_RATE, BOOK_RADIUS = 0.727e-4, 6.378e6  # rad/s, m: as in the book
LENGTH, SPEED, GRAVITY = (Dimension(0, 1, -n) for n in range(3))
RATE = Dimension(0, 0, -1)

small = within(1e-13, 26)


def site(kind, latitude="0.8"):
    """Ground axes, latitude, rate (so large that its square shows), radius, g."""
    latitude, rate, radius, g = numbers(kind, latitude, "0.01", 2000, "9.81")
    ground = e.ground_frame(e.earth_frame(Frame("stars"), rate), latitude, radius=radius)
    return ground, latitude, rate, radius, g


def test_constants_agree_with_each_other_and_with_the_book():
    assert pytest.approx(2 * math.pi / 86164.0989, rel=1e-7) == e.EARTH_RATE
    assert pytest.approx(BOOK_RATE, rel=4e-3) == e.EARTH_RATE
    assert pytest.approx(9.82, abs=1e-3) == e.EARTH_GM / e.EARTH_RADIUS**2


def test_ground_axes_point_east_north_and_up():
    """Against longitude and latitude on a sphere, in axes with z toward the north pole."""
    stars, latitude, longitude = Frame("stars"), 0.7, 2.1
    ground = e.ground_frame(e.earth_frame(stars), latitude, longitude, radius=2.0)
    c, s, C, S = math.cos(longitude), math.sin(longitude), math.cos(latitude), math.sin(latitude)
    z_up = stars.k, stars.i, stars.j  # x through longitude 0, y 90 degrees to the east, z north
    known = (-s, c, 0), (-S * c, -S * s, C), (C * c, C * s, S)
    for axis, wanted in zip((ground.i, ground.j, ground.k), known, strict=True):
        assert close([axis.dot(u) for u in z_up], wanted, 1e-15)
    assert close(ground.origin.position(stars), 2.0 * ground.k, 1e-15)


DEGREES = r"a latitude is from -pi/2 to pi/2 rad"


@pytest.mark.parametrize(("ask", "words"), [
    (lambda: e.ground_frame(e.earth_frame(Frame("stars")), 45.0), DEGREES + r", as radians\(45\); got 45.0"),
    (lambda: e.projectile(1.0, 1.0, 0.0, 0.0, np.array([0.1, 30.0]), 9.81), DEGREES),
    (lambda: e.flight_time(1e5, 0.0, 0.3, 0.0, 9.81), "at this speed the Coriolis acceleration outweighs gravity"),
    (lambda: e.gradient_wind(1e-3, 1e5, 0.0), r"on the equator.* nothing turns a wind aside"),
    (lambda: e.gradient_wind(-1e-3, 1e5, 0.8), r"no steady wind: at radius 100000.0 .* not 0.001; a high has a flat middle"),
    (lambda: e.gradient_wind(np.array([1e-3, -1e-3]), 1e5, 0.8), "no steady wind"),
])  # fmt: skip
def test_latitudes_shots_and_winds_that_do_not_exist_are_refused(ask, words):
    with pytest.raises(e.EarthError, match=words):
        ask()


@every_kind
def test_eqns_6_11_and_6_13_force_of_the_ground(kind):
    ground, latitude, rate, radius, g = site(kind)
    m, small_ = numbers(kind, 3), small(kind, 10)
    N, s, c = e.support_force(m, g, ground), sin(latitude), cos(latitude)
    pull = m * radius * rate**2
    assert close(N, (0, pull * s * c, m * g - pull * c**2), small_)
    assert close(N - m * g * ground.k, m * e.ground_acceleration(ground), small_)
    assert close(N, -m * e.effective_gravity(g, ground), small_)


@every_kind
def test_eqn_6_12_acceleration_of_a_place_on_the_earth(kind):
    """Against the printed components, and the second rates of its coordinates."""
    ground, latitude, rate, radius, _ = site(kind)
    s, c = sin(latitude), cos(latitude)
    a = e.ground_acceleration(ground)
    assert close(a, (0, radius * rate**2 * s * c, -radius * rate**2 * c**2), small(kind))
    round_it = lambda t: (radius * c * sin(rate * t), 0, radius * c * cos(rate * t))
    second = [x.acceleration for x in along(round_it, 0 * rate)]
    assert close(a.components(ground.tree[0]), second, small(kind))


def test_eqn_6_14_the_rotation_neglected_and_the_error_of_it():
    """The error is at most 0.35 % of the weight, at the equator: 0.344 % with the book's data."""
    still = e.ground_frame(e.earth_frame(Frame("stars"), 0), 0.7)
    assert e.support_force(2.0, 9.81, still).components() == (0, 0, 19.62)
    earth, errors = e.earth_frame(Frame("stars"), BOOK_RATE), []
    for latitude in (0.0, 0.5, -0.5, 1.2, math.pi / 2):
        ground = e.ground_frame(earth, latitude, radius=BOOK_RADIUS)
        errors.append(1 - e.support_force(1.0, 9.81, ground).z / 9.81)
    assert errors[0] == max(errors)
    assert round(100 * errors[0], 3) == 0.344
    assert errors[1] == pytest.approx(errors[2])


def test_section_6_8_apparent_g_and_the_plumb_line():
    """Half of 9.832 - 9.780 between pole and equator is rotation, half the shape of the Earth."""
    stars = Frame("stars")
    g = e.EARTH_GM / e.EARTH_RADIUS**2
    latitude = np.linspace(-1.5, 1.5, 31)
    down = e.effective_gravity(g, e.ground_frame(e.earth_frame(stars), latitude))
    assert np.all(np.diff(np.abs(latitude)) * np.diff(down.norm()) > 0)
    assert close(-down.z, g - e.EARTH_RADIUS * e.EARTH_RATE**2 * np.cos(latitude) ** 2, 1e-14)
    assert down.norm()[15] == pytest.approx(9.786, abs=1e-3)
    ground = e.ground_frame(e.earth_frame(stars), radians(45.0))
    plumb = e.effective_gravity(g, ground)
    assert plumb.y < 0  # toward the equator
    assert math.degrees(plumb.angle_to(-ground.k)) == pytest.approx(0.099, abs=1e-3)


@every_kind
def test_eqn_6_15_only_terms_in_the_square_of_the_rate_are_left_out(kind):
    """F/m - 2 omega x v_r against the whole of (6.10): what remains is -a_O - omega x (omega x r)."""
    ground, _, _, _, g = site(kind)
    r, v = numbers(kind, 3, -4, 5), numbers(kind, 7, 2, -3)
    P = ground.point("P", *(moving(a, rate=b) for a, b in zip(r, v, strict=True)))
    whole = relative_acceleration(1, P, ground.tree[0], gravity=-g * ground.k)
    omega = e.earth_rate(ground)
    apparent = e.apparent_acceleration(ground.vector(*v), -g * ground.k, omega)
    left = -e.ground_acceleration(ground) - omega.cross(omega.cross(ground.vector(*r)))
    assert close(whole - apparent, left, small(kind, 10))
    plumb = e.apparent_acceleration(ground.vector(*v), e.effective_gravity(g, ground), omega)
    assert close(plumb - apparent, -e.ground_acceleration(ground), small(kind, 10))
    assert close(whole.terms["coriolis"], apparent.terms["coriolis"], small(kind))


@every_kind
def test_eqn_6_15_the_force_that_a_motion_needs_gives_that_motion(kind):
    ground, _, _, _, _ = site(kind)
    v, a = (ground.vector(*numbers(kind, *x)) for x in ((7, 2, -3), (1, -2, "0.5")))
    omega, m = e.earth_rate(ground), numbers(kind, 3)
    F = e.force_near_earth(m, v, a, omega)
    assert close(e.apparent_acceleration(v, F / m, omega), a, small(kind, 10))
    assert close(F, m * a + 2 * m * omega.cross(v), small(kind, 10))
    assert close(sum(F.terms.values()), F, small(kind, 10))


def angles(kind):
    """Speed, azimuth, elevation, latitude, g, rate."""
    return numbers(kind, 100, "0.6", "0.7", "0.8", "9.81", "0.0001")


@every_kind
def test_eqns_6_16_to_6_19_launch_and_rotation_along_ground_axes(kind):
    v0, theta, phi, latitude, g, rate = angles(kind)
    ground = e.ground_frame(e.earth_frame(Frame("stars"), rate), latitude)
    launch, omega = e.launch_velocity(ground, v0, theta, phi), e.earth_rate(ground)
    c, s, C, S, cl, sl = cos(theta), sin(theta), cos(phi), sin(phi), cos(latitude), sin(latitude)
    assert close(launch, (v0 * c * C, v0 * s * C, v0 * S), small(kind, 100))  # 6.17
    assert close(omega, (0, rate * cl, rate * sl), small(kind))  # 6.18
    assert close(omega, e.earth_rate3(latitude, rate), small(kind))
    turned = cl * S - sl * s * C, sl * c * C, -cl * c * C
    assert close(omega.cross(launch), [rate * v0 * x for x in turned], small(kind))  # 6.19
    a = e.apparent_acceleration(launch, -g * ground.k, omega)
    pull = zip(turned, (0, 0, 1), strict=True)
    assert close(a, [-2 * rate * v0 * x - g * k for x, k in pull], small(kind))  # 6.16


def by_exponential(t, r, v, g, omega):
    """Position and velocity at t by the exponential of the matrix of (6.20), in mpf."""
    A, g, omega = mp.zeros(7), tuple(g), tuple(omega)  # r, v, 1
    spin = ((0, -omega[2], omega[1]), (omega[2], 0, -omega[0]), (-omega[1], omega[0], 0))
    for n in range(3):
        A[n, 3 + n] = 1
        A[3 + n, 6] = g[n]
        for m in range(3):
            A[3 + n, 3 + m] = -2 * spin[n][m]
    out = mp.expm(A * t) * mp.matrix([*r, *v, 1])
    return tuple(out[:3]), tuple(out[3:6])


def launched(kind, rate=None):
    """Launch, gravity and omega of a shot, and the time 12 s."""
    v0, theta, phi, latitude, g, default = angles(kind)
    ground = e.ground_frame(e.earth_frame(Frame("stars"), rate or default), latitude)
    launch = e.launch_velocity(ground, v0, theta, phi)
    return launch, -g * ground.k, e.earth_rate(ground), numbers(kind, 12)


def shot(rate="0.0001"):
    """Launch, gravity and omega of a shot, as mpf; gravity leans a little."""
    launch, g, omega, _ = launched("mpmath", numbers("mpmath", rate))
    return launch, g + g.frame.vector(0, mp.mpf("-0.02"), 0), omega


def test_eqn_6_20_6_21_the_series_solves_to_30_digits_and_has_the_first_integral():
    launch, g, omega = shot()
    for t in (mp.mpf(1), mp.mpf(60), mp.mpf(3600)):
        r, v = by_exponential(t, (0, 0, 0), launch, g, omega)
        scale = g.norm() * t * t
        found = e.projectile_to_order(t, launch, g, omega, 24)
        rate = e.projectile_velocity(t, launch, g, omega, 24)
        assert close(found, r, scale * mp.mpf(10) ** -28)
        assert close(rate, v, scale * mp.mpf(10) ** -28)
        # 6.21, with A the velocity of launch
        assert close(rate + 2 * omega.cross(found), t * g + launch, scale * mp.mpf(10) ** -28)


@every_kind
def test_eqns_6_22_to_6_24_integrals_to_first_order(kind):
    launch, g, omega, t = launched(kind)
    big, rate = small(kind, 1e4), small(kind, 100)
    v, r = (f(t, launch, g, omega) for f in (e.projectile_velocity, e.projectile_position))
    turned, third = omega.cross(launch), t * t * t / 3 * omega.cross(g)
    # 6.22, B = v_r0
    assert close(v + t * t * omega.cross(g) + 2 * t * turned, t * g + launch, rate)
    # 6.23, C = 0, and 6.24
    assert close(r + third + t * t * turned - t * t / 2 * g, t * launch, big)
    assert close(r, -third - t * t * turned + t * t / 2 * g + t * launch, big)
    assert close(r, sum(r.terms.values()), big)
    assert close(r.terms["fall turned"], -third, small(kind))
    assert close(r, e.projectile_to_order(t, launch, g, omega, 1), big)
    moved = at(lambda t: e.position3(t, tuple(launch), tuple(g), tuple(omega))[0] + 0 * t, t)
    assert close(moved.rate, v.x, rate)


def test_eqn_6_24_is_right_to_the_first_order():
    """Halving the rate divides the error by 4; it is at most (2 omega t)^2/6 of the distance."""
    t, error = mp.mpf(60), []
    for rate in ("0.0002", "0.0001"):
        launch, g, omega = shot(rate)
        r, _ = by_exponential(t, (0, 0, 0), launch, g, omega)
        found = e.projectile_position(t, launch, g, omega)
        error.append(max(abs(a - b) for a, b in zip(found, r, strict=True)))
    assert 3.95 < error[0] / error[1] < 4.05
    way = launch.norm() * t + g.norm() * t * t / 2
    assert 0 < error[1] < (2 * mp.mpf("0.0001") * t) ** 2 / 6 * way


@every_kind
def test_eqns_6_25_and_6_28_coordinates(kind):
    """The book's three lines, written out."""
    v0, theta, phi, latitude, g, w = angles(kind)
    t = numbers(kind, 12)
    c, s, C, S, cl, sl = cos(theta), sin(theta), cos(phi), sin(phi), cos(latitude), sin(latitude)
    x = g * w * cl * t**3 / 3 - v0 * w * (S * cl - s * C * sl) * t**2 + v0 * c * C * t
    y = -v0 * w * c * C * sl * t**2 + v0 * s * C * t
    z = v0 * w * c * C * cl * t**2 - g * t**2 / 2 + v0 * S * t
    assert close(e.projectile(t, v0, theta, phi, latitude, g, w), (x, y, z), small(kind, 1e4))


@every_kind
def test_eqns_6_26_6_27_and_6_29_flight_time_and_range(kind):
    v0, theta, phi, latitude, g, w = given = angles(kind)
    t = e.flight_time(*given)
    lift = 2 * v0 * w * cos(theta) * cos(phi) * cos(latitude)
    assert close(t, 2 * v0 * sin(phi) / (g - lift), small(kind))
    x, y, z = e.projectile(t, *given)
    assert close(z, 0, small(kind, 1e4))
    assert close(e.shot_range(*given), sqrt(x * x + y * y), small(kind, 1e4))


def test_eqns_6_30_and_6_31_are_the_first_order_of_the_range():
    """The range is differentiated by the rate at rate 0, over symbols."""
    v0, phi, g, w = sympy.symbols("v0 phi g omega", positive=True)
    zero = sympy.Integer(0)
    t = e.flight_time(v0, zero, phi, zero, g, w)
    whole = e.projectile(t, v0, zero, phi, zero, g, w)[0]
    short = e.range_east(v0, phi, g, w)
    assert sympy.simplify((whole - short).subs(w, 0)) == 0
    assert sympy.simplify(sympy.diff(whole - short, w).subs(w, 0)) == 0
    still = short.subs(w, 0)
    assert sympy.simplify((still - short) / still - e.range_error(v0, phi, g, w)) == 0


@every_kind
def test_eqn_6_31_vanishes_at_60_degrees_and_changes_sign_there(kind):
    v0, _, _, _, g, w = angles(kind)
    single = "float" if kind == "array" else kind
    below, sixty, above = (radians(numbers(single, x)) for x in (59, 60, 61))
    assert close(e.range_error(v0, sixty, g, w), 0, small(kind))
    assert bool(np.all(e.range_error(v0, below, g, w) < 0))
    assert bool(np.all(e.range_error(v0, above, g, w) > 0))
    # lengthened
    still = v0**2 * sin(2 * below) / g
    assert float(first(e.range_east(v0, below, g, w))) > float(first(still))


def test_the_attraction_is_that_of_chapter_5():
    ground = e.ground_frame(e.earth_frame(Frame("stars"), 0), 0.8, radius=6.4e6)
    P = ground.point("P", 1e5, -2e5, 3e5)
    field = gravitational_field(P, e.EARTH_GM / K, ground.tree[0].origin).components(ground)
    assert close(e.attraction3((1e5, -2e5, 3e5), e.EARTH_GM / 6.4e6**2, 6.4e6), field, 1e-14)


@every_kind
def test_eqn_6_32_buoyancy_keeps_the_air_on_its_level(kind):
    v, theta, _, latitude, g, rate = angles(kind)
    m = numbers(kind, 2)
    ground = e.ground_frame(e.earth_frame(Frame("stars"), rate), latitude)
    wind = e.launch_velocity(ground, v, theta, numbers(kind, 0))
    B = e.buoyancy(m, v, theta, latitude, g, rate)
    a = e.apparent_acceleration(wind, B / m * ground.k - g * ground.k, e.earth_rate(ground))
    assert close(a.z, 0, small(kind))
    assert close((a.x, a.y), e.wind_acceleration(v, theta, latitude, rate), small(kind))
    assert close(B, m * g - 2 * m * rate * v * cos(latitude) * cos(theta), small(kind))


@every_kind
def test_eqns_6_33_and_6_34_free_air_is_turned_to_the_right_in_the_north(kind):
    v, theta, _, latitude, _, rate = angles(kind)
    x, y = e.wind_acceleration(v, theta, latitude, rate)
    turned = 2 * rate * v * sin(latitude)
    assert close((x, y), (turned * sin(theta), -turned * cos(theta)), small(kind))
    assert close(x * cos(theta) + y * sin(theta), 0, small(kind))  # across the motion
    assert close(-x * sin(theta) + y * cos(theta), -turned, small(kind))  # -e_theta: to the right
    assert close(e.wind_acceleration(v, theta, -latitude, rate), (-x, -y), small(kind))


def test_units():
    pure = Dimension()
    shot = SPEED, pure, pure, pure, GRAVITY, RATE
    assert e.projectile(Dimension(0, 0, 1), *shot) == (LENGTH,) * 3
    assert e.flight_time(*shot) == Dimension(0, 0, 1)
    assert e.shot_range(*shot) == LENGTH
    assert e.range_east(SPEED, pure, GRAVITY, RATE) == LENGTH
    assert e.range_error(SPEED, pure, GRAVITY, RATE) == pure
    assert e.gradient_wind(GRAVITY, LENGTH, pure, RATE) == SPEED
    assert e.wind_acceleration(SPEED, pure, pure, RATE) == (GRAVITY, GRAVITY)


def test_projectiles_compile():
    x = (12.0, 100.0, 0.6, 0.7, 0.8, 9.81, 1e-4)
    assert close(compiled(e.projectile)(*x), e.projectile(*x), 1e-12)
    assert close(compiled(e.shot_range)(*x[1:]), e.shot_range(*x[1:]), 1e-12)


def test_a_projectile_explains_its_terms():
    launch, g, omega, t = launched("float")
    r, ground = e.projectile_position(t, launch, g, omega), launch.frame
    assert "fall turned  -1/3 omega x g t^3" in str(r.explain("m"))
    known = r.terms["launch"] + r.terms["fall"]
    assert close(r.without("fall turned", "launch turned"), known, 1e-12)
    pull, push = e.effective_gravity(9.81, ground), e.support_force(1.0, 9.81, ground)
    for vector, number in ((r, "6.24"), (pull, "6.11"), (push, "6.13")):
        assert f"equation ({number})" in str(vector.explain())
