"""Worked examples of chapter 10, gyroscopic motion: a spherical pendulum (10.4), bodies free of
moments (10.8), a rotor in a car (10.10), gyroscopic instruments (10.11).
"""

from collections.abc import Iterable

from newton_euler import Frame, Point, Vector, cos, pi, sin, sqrt, where
from newton_euler.algebra.scalars import Scalar, scalar, to_plain
from newton_euler.applications.gyroscopes import FreePrecession, GyroError, free_precession
from newton_euler.bodies import Inertia
from newton_euler.bodies.solids import cylinder
from newton_euler.kinematics.rotations import euler_frame, quaternion_product

# -- 10.8: symmetric bodies on which no moment acts. The precession of the Earth's axis in about
# 26 000 years is not among them: the Sun and the Moon force it by their moments on the equatorial
# bulge. The wobble is free; its period would be about 10 months if the Earth were rigid.


def football(theta: Scalar, spin: Scalar) -> FreePrecession:
    """The free precession of a football with I0 = 3 I (10.8): direct, at psi' = phi'/(2
    cos(theta)).

    theta : rad, between the axis of symmetry and the angular momentum
    spin : phi' in rad/s

    >>> football(0.0, 10.0).rate
    5.0
    """
    return free_precession(3.0, 1.0, theta, spin)


def station_moments(radius: Scalar, length: Scalar, centre: Point) -> tuple[Scalar, Scalar]:
    """The moments of inertia I0 (transverse) and I (axial) about ``centre`` of a space station, a
    homogeneous cylinder of unit mass (10.8), in units of length squared.

    >>> from newton_euler import Frame
    >>> station_moments(3.0, 30.0, Frame("station").origin)
    (77.25, 4.5)
    """
    along, across, _ = cylinder(radius, length, centre, "x", mass=1.0).inertia.moments
    return across, along


def wobble_period(ellipticity: Scalar, day: Scalar) -> Scalar:
    """The period of the wobble of the rigid Earth, in units of ``day`` (10.8): of the axis of
    rotation about the axis of symmetry, seen from the body, at (I - I0) omega_z/I0. The observed
    period is 14 months, since the Earth is elastic.

    ellipticity : (I - I0)/I0, 0.003285 for the Earth

    >>> round(wobble_period(0.003285, 1.0))  # days
    304
    """
    return day / ellipticity


# -- 10.10: a rotor in a car that balances the overturning moment in a turn. Its axis is parallel to
# the axles, and it spins opposite to the wheels.


def rotor_moment(mass: Scalar, height: Scalar, speed: Scalar, turn_radius: Scalar) -> Scalar:
    """The moment of the rotor on the car with which the wheels on both sides carry equal loads
    (10.10): h m v^2/r, N m if in SI.

    height : h of the centre of mass of the car above the road

    >>> rotor_moment(1000.0, 0.5, 20.0, 100.0)
    2000.0
    """
    return height * mass * speed * speed / turn_radius


def rotor_spin(
    mass: Scalar, height: Scalar, speed: Scalar, rotor_mass: Scalar, gyration: Scalar
) -> Scalar:
    """The spin phi' = h m v/(K^2 m_R) (rad/s) that gives this moment in every turn (10.10), from I
    psi' phi' = h m v^2/r, psi' = v/r (10.37).

    mass, rotor_mass : both masses, or both weights
    gyration : the radius of gyration K of the rotor

    The book's 1000 rad/s, 9549 rev/min:

    >>> rotor_spin(3000.0, 4.0, 100.0, 300.0, 2.0)
    1000.0
    """
    return height * mass * speed / (gyration * gyration * rotor_mass)


def wheel_loads(
    mass: Scalar,
    height: Scalar,
    speed: Scalar,
    turn_radius: Scalar,
    track: Scalar,
    g: Scalar,
    rotor: Scalar = 0.0,
) -> tuple[Scalar, Scalar]:
    """The vertical forces on the inner and on the outer wheels of a car in a turn (10.10), N if in
    SI.

    track : distance between inner and outer wheels
    rotor : angular momentum I phi' of the rotor, kg m^2/s

    From moments about G: (outer - inner) track/2 = h m v^2/r - I phi' v/r. With the spin of
    :func:`rotor_spin` both forces are m g/2.

    >>> wheel_loads(1000.0, 0.5, 20.0, 100.0, 1.6, 10.0)
    (3750.0, 6250.0)
    """
    shift = (rotor_moment(mass, height, speed, turn_radius) - rotor * speed / turn_radius) / track
    return mass * g / 2 - shift, mass * g / 2 + shift


# -- 10.11: instruments, by M = I psi' phi' (10.37): a moment makes the axis of a spinning body
# precess, and to turn the axis needs a moment.


def uprighting_moment(
    I: Scalar, speed: Scalar, wheel_radius: Scalar, steering_rate: Scalar
) -> Scalar:
    """The gyroscopic moment of a rolling bicycle wheel about the line of travel (10.11): I phi'
    psi' with phi' = v/r, N m if in SI.

    steering_rate : psi' in rad/s. Positive: steered to the left, the wheel leans the bicycle to the
        right. It is not the only reason why a bicycle stays upright.

    >>> uprighting_moment(0.1, 5.0, 0.25, 0.5)
    1.0
    """
    return I * (speed / wheel_radius) * steering_rate


def sensed_tilt(I: Scalar, spin: Scalar, rate: Scalar, stiffness: Scalar) -> Scalar:
    """The tilt (rad) of a rate gyroscope about its line of nodes (10.11), held by a spring: I phi'
    psi'/stiffness, for small tilts.

    spin, rate : phi' and psi' in rad/s; stiffness : N m/rad

    >>> round(sensed_tilt(0.001, 1000.0, 0.02, 0.5), 6)
    0.04
    """
    return I * spin * rate / stiffness


def platform_drift(moment: Scalar, I: Scalar, spin: Scalar) -> Scalar:
    """The rate (rad/s) at which a friction moment in a gimbal turns the axis of an inertial
    platform (10.11): M/(I phi').

    >>> platform_drift(1e-6, 0.001, 1000.0)
    1e-06
    """
    return moment / (I * spin)


def spherical_pendulum_momentum(
    mass: Scalar, length: Scalar, psi: Scalar, theta: Scalar, phi: Scalar
) -> tuple[Vector, Frame]:
    """The angular momentum H of a uniform bar about its ball joint, in the frame {i, j, k} that
    does not spin, (10.16): a Vector whose frame is the parent of that of the bar.

    psi, theta, phi : Euler angles 3-1-3, :func:`newton_euler.moving`; the spin phi has no influence
    Returns H and the frame of the bar; ``H.expressed_in(bar)`` is (10.14).

    >>> from newton_euler import moving
    >>> psi, theta = moving(0.0, rate=1.0), moving(0.5, rate=2.0)
    >>> H, bar = spherical_pendulum_momentum(3.0, 2.0, psi, theta, 0.3)
    >>> [round(x, 6) for x in H]
    [8.0, 1.917702, 0]
    """
    ground = Frame("ground")
    bar = euler_frame(ground, "bar", psi, theta, phi)
    I0 = mass * (length * length) / 3
    axes = bar.parent  # {i, j, k}
    assert axes is not None
    turning = bar.angular_velocity(ground).expressed_in(axes)
    return Inertia(bar.origin, (I0, I0, 0), frame=axes, tolerance=None).times(turning), bar


def tilt_growth(I_x: Scalar, I_y: Scalar, I_z: Scalar, axis: str, rate: Scalar) -> Scalar:
    """The rate (1/s) at which a small tilt grows while a body spins at ``rate`` about its principal
    ``axis`` "x", "y" or "z": 0 where it does not.

    For the axis n with the others u, v it is |rate| sqrt((I_n - I_u)(I_v - I_n)/(I_u I_v)), real
    about the intermediate one alone. In the time T a tilt grows by exp(growth T). An integration in
    floats that starts exactly on the axis stays there, and does not show the instability.

    >>> tilt_growth(1.0, 2.0, 3.0, "z", 10.0), round(tilt_growth(1.0, 2.0, 3.0, "y", 3.0), 6)
    (0.0, 1.732051)
    """
    if axis not in ("x", "y", "z"):
        raise GyroError(f"the axis is 'x', 'y' or 'z', got {axis!r}")
    n = "xyz".index(axis)
    I = [to_plain(x) for x in (I_x, I_y, I_z)]
    own, u, v = I[n:] + I[:n]
    square = (own - u) * (v - own) / (u * v)
    return abs(rate) * sqrt(where(square > 0, square, abs(0.0 * square)))


def body_quaternion(state: Iterable[Scalar], spun: Scalar) -> tuple[Scalar, ...]:
    """The quaternion of the body, from a state of ``nonspinning_frame`` or ``free``
    (:mod:`newton_euler.scenes.spatial.top`) and the angle omega_z t (rad) that it has spun.

    >>> body_quaternion((1.0, 0, 0, 0, 0, 0), 0.0)
    (1.0, 0.0, 0.0, 0.0)
    """
    return quaternion_product(tuple(state)[:4], (cos(spun / 2), 0 * spun, 0 * spun, sin(spun / 2)))


def compass_period(
    I0: Scalar, I: Scalar, omega_z: Scalar, earth_rate: Scalar, latitude: Scalar
) -> Scalar:
    """The period (s) of small swings of a gyrocompass about north (10.11), 2 pi sqrt(I0/(c (I
    omega_z - I0 c))) with c = Omega cos(latitude).

    >>> round(compass_period(0.002, 0.003, 1000.0, 7.292e-5, 0.8), 3)
    22.761
    """
    level = earth_rate * cos(latitude)
    return 2 * pi(level) * sqrt(I0 / (level * (I * omega_z - I0 * level)))


def precession_rate(
    I0: Scalar, I: Scalar, theta: Scalar, omega_z: Scalar, momentum_difference: Scalar
) -> Scalar:
    """psi' of a top at the angle theta (10.24) from its constants: (p_psi - p_phi cos(theta))/(I0
    sin^2(theta)), by half angles; its limit at theta = 0 if ``momentum_difference`` is the integer
    0.

    >>> precession_rate(0.02, 0.01, 0.0, 100.0, 0)
    25.0
    """
    q, c, s = scalar(momentum_difference), cos(theta / 2), sin(theta / 2)
    return to_plain((2 * I * omega_z + q) / (4 * I0 * c**2) + q / (4 * I0 * s**2))
