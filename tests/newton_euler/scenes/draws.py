"""Random questions to each ladder, over wide ranges, and what the state of each rung must hold.

A draw is a function of a ``random.Random`` that returns a Ladder and a tolerance, such that each
rung is sometimes the right choice.
"""

import math
from math import cos, sin, sqrt

from newton_euler.applications import EARTH_GM, EARTH_RATE, GyroError, steady_precession
from newton_euler.scenes import ladder
from newton_euler.scenes.particles.orbit import EARTH_OBLATENESS
from newton_euler.scenes.planar.hinged_rod import least_rate, rod, swing_out


def any_size(r, low, high):
    """A number between the two, with every order of magnitude equally likely."""
    return math.exp(r.uniform(math.log(low), math.log(high)))


def either(r):
    return r.choice((-1.0, 1.0))


def heading(r):
    return r.uniform(-3.1, 3.1)


def on_page(size, angle):
    return size * cos(angle), size * sin(angle)


def projectile(r):
    g, speed, azimuth, elevation = r.uniform(1.6, 25), any_size(r, 5, 3000), heading(r), r.uniform(0.1, 1.5)  # fmt: skip
    level, up = on_page(speed, elevation)
    start = (0.0, 0.0, r.choice((0.0, 100.0)), *on_page(level, azimuth), up)
    t = any_size(r, 0.003, 1.9) * up / g
    radius = any_size(r, 2e6, 7e7)
    # a fraction of the rate that would make bodies weightless at the equator
    rate = sqrt(g / radius) * any_size(r, 0.003, 0.5)
    latitude, drag = r.uniform(-1.5, 1.5), r.choice((0.0, any_size(r, 1e-9, 1e-3)))
    given = {"rate": rate, "radius": radius, "drag": drag, "start": start, "t": t}
    return ladder("projectile", g=g, latitude=latitude, **given), any_size(r, 1e-4, 1e3)


def physical_pendulum(r):
    l, g = any_size(r, 0.2, 5), r.uniform(1.6, 25)
    n = sqrt(g / l)
    start = either(r) * any_size(r, 1e-3, 2.5), r.choice((0.0, r.uniform(-1, 1) * n))
    I, t = l * l * any_size(r, 1e-6, 0.5), any_size(r, 1, 25) / n
    return ladder("physical pendulum", m=1.0, I=I, l=l, g=g, t=t, start=start), any_size(r, 1e-6, 1)


def top(r):
    I0, mgr = any_size(r, 0.005, 0.05), any_size(r, 0.05, 2.0)
    I = I0 * r.uniform(0.3, 1.8)
    omega_z = either(r) * 2 * sqrt(I0 * mgr) / I * any_size(r, 0.7, 20)
    upright = r.random() < 0.2
    theta = 0.0 if upright else r.uniform(0.1, 2.5)
    try:
        rate = steady_precession(I0, I, theta, omega_z=omega_z, mgr=mgr).slow
    except GyroError:
        rate = mgr / (I * omega_z)
    if upright:
        nods, precession = either(r) * any_size(r, 1e-3, 1.0), 0.0
    else:
        nods = r.choice((0.0, any_size(r, 1e-6, 1.0)))
        precession = rate * (1 + either(r) * any_size(r, 1e-6, 1.0))
    t = 2 * math.pi * I0 / abs(I * omega_z) * any_size(r, 0.3, 8)
    body = {"I0": I0, "I": I, "mgr": mgr, "asymmetry": any_size(r, 1e-6, 0.1)}
    motion = {"theta": theta, "theta_rate": nods, "precession": precession, "omega_z": omega_z}
    return ladder("top", **body, **motion, t=t), any_size(r, 1e-7, 0.3)


def satellite(r):
    distance = any_size(r, 6.6e6, 5e7)
    speed, azimuth = sqrt(EARTH_GM / distance), heading(r)
    climb = r.choice((0.0, either(r) * any_size(r, 1e-6, 0.3)))
    fast = speed * (1 + either(r) * any_size(r, 1e-7, 0.3))
    ahead = azimuth + either(r) * (math.pi / 2 - climb)
    start = (*on_page(distance, azimuth), *on_page(fast, ahead))
    oblateness = EARTH_OBLATENESS * any_size(r, 1e-4, 3)
    t = 2 * math.pi * distance / speed * any_size(r, 0.05, 3)
    tolerance = distance * any_size(r, 1e-8, 0.3)
    return ladder("satellite", oblateness=oblateness, start=start, t=t), tolerance


def in_plan(r, length, n, least):
    """The amplitude of a swing, and its start x, y, dx, dy."""
    size = length * any_size(r, least, 0.6)
    turn, across = heading(r), r.choice((0.0, r.uniform(-1, 1)))
    c, s = on_page(size, turn)
    return size, (c, s, -n * across * s, n * across * c)


def foucault(r):
    length, g = any_size(r, 0.5, 100), r.uniform(9.78, 9.84)
    n = sqrt(g / length)
    size, start = in_plan(r, length, n, 1e-4)
    at = {"latitude": r.uniform(-1.5, 1.5), "rate": EARTH_RATE * any_size(r, 0.3, 300)}
    asked = ladder("Foucault's pendulum", length=length, g=g, **at, start=start, t=any_size(r, 1, 25) / n)  # fmt: skip
    return asked, size * any_size(r, 1e-6, 0.3)


def spherical_pendulum(r):
    length, g = any_size(r, 0.2, 5), r.uniform(1.6, 25)
    n = sqrt(1.5 * g / length)
    size, start = in_plan(r, length, n, 1e-3)
    friction, t = n * any_size(r, 1e-6, 0.5), any_size(r, 1, 25) / n
    asked = ladder("spherical pendulum", length=length, g=g, friction=friction, start=start, t=t)
    return asked, size * any_size(r, 1e-6, 0.3)


def free_body(r):
    spin, turn = either(r) * any_size(r, 0.1, 20), heading(r)
    wobble = abs(spin) * any_size(r, 1e-4, 1.0)
    I_y, I_z = 1 + either(r) * any_size(r, 1e-6, 0.4), r.uniform(0.5, 1.6)
    start, t = (*on_page(wobble, turn), spin), any_size(r, 1, 60) / abs(spin)
    asked = ladder("free body", I_x=1.0, I_y=I_y, I_z=I_z, start=start, t=t)
    return asked, abs(spin) * any_size(r, 1e-8, 0.3)


def sphere_on_incline(r):
    """Solids, shells and hoops on gentle and steep inclines."""
    slope, g, air, k = any_size(r, 0.01, 1.3), r.uniform(1.6, 25), any_size(r, 1e-6, 0.1), r.uniform(0.1, 1)  # fmt: skip
    start, t = (0.0, any_size(r, 0.01, 10)), any_size(r, 0.1, 20)
    asked = ladder("sphere on an incline", slope=slope, g=g, air=air, k=k, start=start, t=t)
    return asked, any_size(r, 1e-5, 1e3)


def car_on_hill(r):
    """Cars that speed up, and cars that slow down but do not come to rest."""
    m, slope, t, v = r.uniform(500, 3000), r.uniform(0, 0.3), any_size(r, 0.5, 30), r.uniform(2, 30)
    gain = r.choice((any_size(r, 0.01, 3), -0.3 * v / t))
    wheels = {"wheel_mass": any_size(r, 0.1, 100), "gyration": r.uniform(0.2, 0.3), "radius": 0.3}
    given = {"m": m, "slope": slope, "air": any_size(r, 1e-4, 0.5), "start": (0.0, v), "t": t}
    asked = ladder("car on a hill", **given, **wheels, force=m * (9.81 * sin(slope) + gain))
    return asked, any_size(r, 1e-4, 1e3)


def aircraft(r):
    """Flights in balance and far from it, with wings level or banked."""
    m, v, bank = any_size(r, 300, 1e5), r.uniform(40, 250), either(r) * any_size(r, 1e-5, 0.8)
    if r.random() < 0.5:
        gamma, off = 0.0, any_size(r, 1e-6, 0.01)
    else:
        gamma, off = either(r) * any_size(r, 1e-6, 0.3), any_size(r, 1e-6, 0.3)
    lift = m * 9.81 / v**2 / r.choice((1.0, cos(bank))) * (1 + either(r) * off)
    drag = lift / r.uniform(8, 40)
    thrust = (drag * v**2 + m * 9.81 * sin(gamma)) * (1 + either(r) * off)
    start = v, heading(r), gamma, r.uniform(-1e3, 1e3), r.uniform(-1e3, 1e3), 2000.0
    given = {"m": m, "thrust": thrust, "lift": lift, "drag": drag, "bank": bank}
    return ladder("aircraft", **given, start=start, t=any_size(r, 0.5, 40)), any_size(r, 1e-3, 1e3)


def space_station(r):
    """Things let go or thrown near the rims of small and large stations."""
    radius, speed = any_size(r, 20, 1e5), r.choice((0.0, *[any_size(r, 0.01, 10)] * 9))
    direction, omega = heading(r), either(r) * sqrt(r.uniform(1, 12) / radius)
    place = radius - r.uniform(0.5, 2.5), r.uniform(-0.5, 0.5)
    given = {"omega": omega, "radius": radius, "air": any_size(r, 1e-6, 0.1)}
    start, t = (*place, *on_page(speed, direction)), any_size(r, 0.05, 3)
    return ladder("space station", **given, start=start, t=t), any_size(r, 1e-5, 10)


def rotor(r):
    """Rotors balanced well or badly, speeding up or slowing down."""
    mass = any_size(r, 1, 100)
    x, y = on_page(any_size(r, 1e-7, 1e-2), heading(r))
    I = mass * r.uniform(0.01, 0.1)
    moment, start = I * either(r) * any_size(r, 1e-4, 10), (heading(r), any_size(r, 0.1, 100))
    asked = ladder("rotor", mass=mass, x=x, y=y, I=I, moment=moment, start=start, t=any_size(r, 0.1, 20))  # fmt: skip
    return asked, any_size(r, 1e-4, 1e2)


def turning_shaft(r):
    """Shafts light and heavy, below and above the least rate, near rest and far from it."""
    mass, length, g = any_size(r, 0.1, 10), any_size(r, 0.2, 3), r.uniform(1.6, 25)
    least = least_rate(**rod(mass, length, 1.0, g))
    omega = least * r.choice((r.uniform(0.1, 0.9), r.uniform(1.1, 4)))
    rest = swing_out(**rod(mass, length, omega, g)) if omega > least else 0.0
    theta = rest + either(r) * min(any_size(r, 1e-4, 1.5), 0.9 * rest or 1.5)
    start = theta, r.choice((0.0, any_size(r, 1e-4, 1) * least))
    shaft, t = mass * length**2 / 3 * any_size(r, 1, 1e6), any_size(r, 0.3, 20) / least
    given = {"mass": mass, "length": length, "omega": omega, "g": g, "shaft": shaft}
    return ladder("turning shaft", **given, start=start, t=t), any_size(r, 1e-7, 1)


def air_near_low(r):
    """Parcels of air at all latitudes, for a quarter of an hour to a day."""
    away, place, speed, direction = any_size(r, 1e4, 1e6), heading(r), any_size(r, 0.1, 30), heading(r)  # fmt: skip
    latitude, gradient = r.uniform(-1.4, 1.4), any_size(r, 1e-10, 1e-7)
    given = {"latitude": latitude, "pressure_gradient": gradient, "friction": any_size(r, 1e-9, 1e-4)}  # fmt: skip
    start, t = (*on_page(away, place), *on_page(speed, direction)), any_size(r, 900, 86_400)
    return ladder("air near a low", **given, start=start, t=t), any_size(r, 0.1, 1e5)


LATER_CHAPTERS = {
    "aircraft": aircraft, "space station": space_station, "air near a low": air_near_low, "rotor": rotor,
    "turning shaft": turning_shaft, "sphere on an incline": sphere_on_incline, "car on a hill": car_on_hill,
}  # fmt: skip
DRAWS = {
    "projectile": projectile, "physical pendulum": physical_pendulum, "top": top, "satellite": satellite,
    "Foucault's pendulum": foucault, "spherical pendulum": spherical_pendulum, "free body": free_body, **LATER_CHAPTERS,
}  # fmt: skip

# What the state of a rung holds: 2 numbers for each degree of freedom, less those left out, which
# are coordinates that are not asked for or constants of the motion (as the momenta of cyclic
# coordinates) and so parameters; and spare ones that a constraint takes back.
POINT, IN_PLANE, ONE_WAY = (3, 0, 0), (2, 0, 0), (1, 0, 0)
EVEN = (1, 1, 0)  # one angle or distance, at a constant rate
FREEDOM = {  # by ladder and rung: degrees of freedom, numbers left out, spare ones
    "projectile": {
        "projectile, flat": POINT, "projectile, Coriolis to first order": POINT, "projectile, full": POINT,
        "projectile, Coriolis and effective gravity": POINT, "projectile, flat in air": POINT, "projectile, full in air": POINT,
    },
    "physical pendulum": dict.fromkeys(("pendulum, small swings", "pendulum, a particle", "physical pendulum"), ONE_WAY),
    "top": {
        "top, slow precession": EVEN,
        "top, steady precession": EVEN,
        "top, nutation and precession": (3, 3, 0),  # phi is not asked for; omega_z and p_psi are constant
        "top of unequal moments, Euler's angles": POINT,  # phi matters now
        "top of unequal moments, quaternion": (3, 0, 1),  # without a singular point
    },
    "satellite": {
        "satellite, circle": EVEN,
        "satellite, ellipse": IN_PLANE,  # exact, so states cost nothing
        "satellite, over an oblate Earth": (2, 1, 0),  # the angular momentum is constant
    },
    "Foucault's pendulum": {
        "Foucault's pendulum, small swings, Earth at rest": IN_PLANE, "Foucault's pendulum, small swings": IN_PLANE,
        "Foucault's pendulum, any swing, Earth at rest": IN_PLANE, "Foucault's pendulum": IN_PLANE,
    },
    "spherical pendulum": {
        "bar, small swings": IN_PLANE, "bar, small swings with friction": IN_PLANE,
        "bar, any swing": IN_PLANE, "bar, any swing with friction": IN_PLANE,
    },
    "free body": {  # only rates are asked for, not the attitude
        "wobble of a symmetric body": (3, 4, 0), "small wobble": (3, 4, 0), "free body": (3, 3, 0),  # w_z is constant in a wobble
    },
    "aircraft": {
        "aircraft, straight": EVEN, "aircraft in a level turn": EVEN,
        "aircraft in a vertical plane": IN_PLANE, "aircraft in space": POINT,
    },
    "space station": dict.fromkeys(
        ("uniform gravity in a turning station", "free body in a turning station", "body in the air of a turning station"), IN_PLANE
    ),
    "air near a low": dict.fromkeys(("air near a low, Earth at rest", "air near a low, without friction", "air near a low"), IN_PLANE),
    "rotor": {"rotor at a constant rate": EVEN, "rotor without weight": ONE_WAY, "rotor with dead weight": ONE_WAY},
    "turning shaft": {
        "small swings on a turning shaft": ONE_WAY, "hinged on a turning shaft": ONE_WAY,
        "hinged on a shaft let go": (2, 2, 0),  # the angle of the shaft is not asked for; its momentum is constant
    },
    "sphere on an incline": dict.fromkeys(("block on an incline", "sphere on an incline", "sphere on an incline, in air"), ONE_WAY),
    "car on a hill": dict.fromkeys(("car, particle", "car on wheels", "car on wheels, in air"), ONE_WAY),
}  # fmt: skip
