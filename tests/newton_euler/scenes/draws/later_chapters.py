"""Random questions to the ladders of chapters 6, 9, 10 and 11, and what their states hold;
:mod:`tests.newton_euler.scenes.draws.ladders` has them with the others.
"""

import math

from newton_euler.scenes import ladder
from newton_euler.scenes.planar.hinged_rod import least_rate, rod, swing_out


def any_size(r, low, high):
    """Every order of magnitude between the two is as likely."""
    return math.exp(r.uniform(math.log(low), math.log(high)))


def either(r):
    return r.choice((-1.0, 1.0))


def sphere_on_incline(r):
    """Solids, shells and hoops on gentle and steep inclines."""
    given = {
        "slope": any_size(r, 0.01, 1.3),
        "g": r.uniform(1.6, 25),
        "air": any_size(r, 1e-6, 0.1),
        "k": r.uniform(0.1, 1),
    }
    start = 0.0, any_size(r, 0.01, 10)
    return ladder("sphere on an incline", **given, start=start, t=any_size(r, 0.1, 20)), any_size(
        r, 1e-5, 1e3
    )


def car_on_hill(r):
    """Cars that speed up, and cars that slow down but do not come to rest."""
    m, slope, t, v = r.uniform(500, 3000), r.uniform(0, 0.3), any_size(r, 0.5, 30), r.uniform(2, 30)
    gain = r.choice((any_size(r, 0.01, 3), -0.3 * v / t))
    wheels = {"wheel_mass": any_size(r, 0.1, 100), "gyration": r.uniform(0.2, 0.3), "radius": 0.3}
    given = {
        "m": m,
        "air": any_size(r, 1e-4, 0.5),
        "force": m * (9.81 * math.sin(slope) + gain),
        "slope": slope,
    }
    return ladder("car on a hill", **given, **wheels, start=(0.0, v), t=t), any_size(r, 1e-4, 1e3)


def aircraft(r):
    """Flights in balance and far from it, with level wings and banked."""
    m, v, bank = any_size(r, 300, 1e5), r.uniform(40, 250), either(r) * any_size(r, 1e-5, 0.8)
    gamma, off = (
        (0.0, any_size(r, 1e-6, 0.01))
        if r.random() < 0.5
        else (either(r) * any_size(r, 1e-6, 0.3), any_size(r, 1e-6, 0.3))
    )
    lift = m * 9.81 / v**2 / r.choice((1.0, math.cos(bank))) * (1 + either(r) * off)
    drag = lift / r.uniform(8, 40)
    thrust = (drag * v**2 + m * 9.81 * math.sin(gamma)) * (1 + either(r) * off)
    start = v, r.uniform(-3.1, 3.1), gamma, r.uniform(-1e3, 1e3), r.uniform(-1e3, 1e3), 2000.0
    given = {"m": m, "thrust": thrust, "lift": lift, "drag": drag, "bank": bank}
    return ladder("aircraft", **given, start=start, t=any_size(r, 0.5, 40)), any_size(r, 1e-3, 1e3)


def space_station(r):
    """Things let go and thrown near the rims of small and large stations."""
    radius, speed, direction = (
        any_size(r, 20, 1e5),
        r.choice((0.0, *[any_size(r, 0.01, 10)] * 9)),
        r.uniform(-3.1, 3.1),
    )
    omega = either(r) * math.sqrt(r.uniform(1, 12) / radius)
    start = (
        radius - r.uniform(0.5, 2.5),
        r.uniform(-0.5, 0.5),
        speed * math.cos(direction),
        speed * math.sin(direction),
    )
    given = {"omega": omega, "radius": radius, "air": any_size(r, 1e-6, 0.1)}
    return ladder("space station", **given, start=start, t=any_size(r, 0.05, 3)), any_size(
        r, 1e-5, 10
    )


def rotor(r):
    """Rotors well and badly balanced, sped up and slowed down."""
    mass, off, at = any_size(r, 1, 100), any_size(r, 1e-7, 1e-2), r.uniform(-3.1, 3.1)
    I = mass * r.uniform(0.01, 0.1)
    given = {
        "mass": mass,
        "x": off * math.cos(at),
        "y": off * math.sin(at),
        "I": I,
        "moment": I * either(r) * any_size(r, 1e-4, 10),
    }
    return ladder(
        "rotor",
        **given,
        start=(r.uniform(-3.1, 3.1), any_size(r, 0.1, 100)),
        t=any_size(r, 0.1, 20),
    ), any_size(r, 1e-4, 1e2)


def turning_shaft(r):
    """Rods below and above the least rate, near the angle of rest and far from it, on light and
    heavy shafts.
    """
    mass, length, g = any_size(r, 0.1, 10), any_size(r, 0.2, 3), r.uniform(1.6, 25)
    least = least_rate(**rod(mass, length, 1.0, g))
    omega = least * r.choice((r.uniform(0.1, 0.9), r.uniform(1.1, 4)))
    rest = swing_out(**rod(mass, length, omega, g)) if omega > least else 0.0
    start = (
        rest + either(r) * min(any_size(r, 1e-4, 1.5), 0.9 * rest or 1.5),
        r.choice((0.0, any_size(r, 1e-4, 1) * least)),
    )
    given = {
        "mass": mass,
        "length": length,
        "omega": omega,
        "g": g,
        "shaft": mass * length**2 / 3 * any_size(r, 1, 1e6),
    }
    return ladder("turning shaft", **given, start=start, t=any_size(r, 0.3, 20) / least), any_size(
        r, 1e-7, 1
    )


def air_near_low(r):
    """Parcels of air at all latitudes, for a quarter of an hour to a day."""
    away, place, speed, direction = (
        any_size(r, 1e4, 1e6),
        r.uniform(-3.1, 3.1),
        any_size(r, 0.1, 30),
        r.uniform(-3.1, 3.1),
    )
    start = (
        away * math.cos(place),
        away * math.sin(place),
        speed * math.cos(direction),
        speed * math.sin(direction),
    )
    given = {
        "latitude": r.uniform(-1.4, 1.4),
        "pressure_gradient": any_size(r, 1e-10, 1e-7),
        "friction": any_size(r, 1e-9, 1e-4),
    }
    return ladder("air near a low", **given, start=start, t=any_size(r, 900, 86_400)), any_size(
        r, 0.1, 1e5
    )


DRAWS = {
    "aircraft": aircraft,
    "space station": space_station,
    "air near a low": air_near_low,
    "rotor": rotor,
    "turning shaft": turning_shaft,
    "sphere on an incline": sphere_on_incline,
    "car on a hill": car_on_hill,
}

ALONG = (1, 0, "one way, along the incline")
ON_LEVEL = (2, 0, "a parcel of air on the level, whose place is asked for")
IN_STATION = (2, 0, "a particle in the plane of the rotation, whose place is asked for")
TURNED = (1, 0, "one angle, which is asked for")

# freedom, what is left out of 2 numbers for each, and why; by rung
FREEDOM = {
    "aircraft": {
        "aircraft, straight": (1, 1, "the way flown, at a constant speed"),
        "aircraft in a level turn": (1, 1, "the heading, at a constant rate"),
        "aircraft in a vertical plane": (2, 0, "a particle in a plane"),
        "aircraft in space": (3, 0, "a particle in space"),
    },
    "space station": {
        "uniform gravity in a turning station": IN_STATION,
        "free body in a turning station": IN_STATION,
        "body in the air of a turning station": IN_STATION,
    },
    "air near a low": {
        "air near a low, Earth at rest": ON_LEVEL,
        "air near a low, without friction": ON_LEVEL,
        "air near a low": ON_LEVEL,
    },
    "rotor": {
        "rotor at a constant rate": (1, 1, "one angle, at a constant rate"),
        "rotor without weight": TURNED,
        "rotor with dead weight": TURNED,
    },
    "turning shaft": {
        "small swings on a turning shaft": TURNED,
        "hinged on a turning shaft": TURNED,
        "hinged on a shaft let go": (
            2,
            2,
            "the angle of the shaft is not asked for; its momentum is constant",
        ),
    },
    "sphere on an incline": {
        "block on an incline": ALONG,
        "sphere on an incline": ALONG,
        "sphere on an incline, in air": ALONG,
    },
    "car on a hill": {
        "car, particle": ALONG,
        "car on wheels": ALONG,
        "car on wheels, in air": ALONG,
    },
}
