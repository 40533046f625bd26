"""The scenes that move, by name: each with its section in the book, what it shows, and a motion to look at.

>>> model, t, start = SCENES["pendulum"].motion
>>> model.states, t, start
(('theta', 'omega'), 10.0, (1.0, 0.0))
"""

import math
from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property

from ..ladders import ladder
from ..models import ModelError
from ..scalars import sin
from ..scenes import (
    aircraft,
    car_on_hill,
    free_body,
    gyrocompass,
    low,
    orbit,
    pendulum,
    projectile,
    rolling_sphere,
    rotor,
    sliding_sphere,
    space_station,
    spherical_pendulum,
    top,
    turning_shaft,
)

DAY = 86_400.0  # s


@dataclass(frozen=True)
class Scene:
    """A scene: ``name``, ``section`` of the book, ``words``; ``make()`` returns the Model, the time at which to end, and the start."""

    name: str
    section: str
    words: str
    make: Callable

    @property
    def chapter(self):
        """The number of the chapter, as an int."""
        return int(self.section.partition(".")[0])

    @cached_property
    def motion(self):
        """(model, t, start), made when first asked for and then kept, since what is traced and compiled belongs to the model."""
        return self.make()


SCENES = {}


def _scene(section, name, words):
    """Puts the scene that a function makes into :data:`SCENES`."""

    def add(make):
        if name in SCENES:
            raise ModelError(f"two scenes have the name {name!r}")
        SCENES[name] = Scene(name, section, words, make)
        return make

    return add


# -- chapter 5: gravitation


@_scene("5.10", "planet", "a planet on an ellipse of eccentricity 0.44, in units of its distance and mu")
def _planet():
    return orbit.orbit(1.0), 30.0, (0.6, 0.8, -0.96, 0.72)


@_scene("5.10", "planet, eccentric", "a comet that passes close to its sun: eccentricity 0.75")
def _comet():
    return orbit.orbit(1.0), 20.0, (0.6, 0.8, -0.4, 0.3)


@_scene("5.10", "satellite", "a satellite over the equator of an oblate Earth, once round")
def _satellite():
    around = ladder("satellite")
    return around.fullest.model, around.t, around.fullest.start


# -- chapter 6: particles


@_scene("6.3", "aircraft", "an aircraft in a vertical plane, with thrust, lift and the drag of the air")
def _aircraft():
    model = aircraft.vertical_flight(2.0, 9.81, thrust=12.0, drag=_drag, lift=25.0)
    return model, 20.0, (50.0, 0.1, 0.0, 100.0)


def _drag(s, p, t):
    return 0.004 * s.v * s.v


@_scene("6.7", "space station", "a body let go 20 m from the axis of a turning station, until it reaches the floor at 100 m")
def _station():
    return space_station.free_body(-space_station.station_rate(9.81, 100.0)), 15.0, (20.0, 0.0, 0.0, 0.0)


@_scene("6.10", "projectile", "a shot of 283 m/s over the rotating earth, all terms")
def _shot():
    return projectile.full(9.82, 0.8), 40.0, (0.0, 0.0, 0.0, 200.0, 50.0, 200.0)


@_scene("6.10", "projectile, rotation only", "the shot with constant g and the Coriolis acceleration only")
def _shot_with_coriolis():
    return projectile.coriolis(9.82, 0.8), 40.0, (0.0, 0.0, 0.0, 200.0, 50.0, 200.0)


@_scene("6.11", "low", "air that starts at rest 300 km from the centre of a low, for two days")
def _low():
    return low.air_near_low(math.radians(45.0), push=1e-8), 2 * DAY, (3e5, 0.0, 0.0, 0.0)


@_scene("6.11", "low, friction", "air near a low with friction, which lets it run inwards")
def _low_with_friction():
    return low.air_near_low(math.radians(45.0), push=1e-8, friction=1e-5), 2 * DAY, (3e5, 0.0, 0.0, 0.0)


@_scene("6.11", "pendulum of Foucault", "67 m long, in Paris, for ten minutes, by the equations of the low")
def _foucault():
    return low.air_near_low(math.radians(48.85), push=9.81 / 67.0), 600.0, (3.0, 0.0, 0.0, 0.0)


@_scene("6.12", "aircraft in space", "an aircraft in a turn, banked by 0.5 rad, with a little more lift than it needs")
def _turning_aircraft():
    model = aircraft.flight(2.0, 9.81, thrust=12.0, drag=_drag, lift=22.5, bank=0.5)
    return model, 20.0, (50.0, 0.0, 0.0, 0.0, 0.0, 100.0)


# -- chapter 8: bodies in the plane


@_scene("8.6", "sliding sphere", "a sphere thrown without spin, until it begins to roll")
def _sliding():
    return sliding_sphere.sliding(0.2, 10.0, 0.5), 1.0, (0.0, 7.0, 0.0)


@_scene("8.6", "rolling sphere", "a sphere that rolls on the level: nothing changes but its place")
def _rolling():
    return sliding_sphere.rolling(0.5), 2.0, (6.0, 5.0, -10.0)


# -- chapter 9: a fixed axis


@_scene("9.5", "rotor", "a rotor with dead weight, started from rest by a constant moment")
def _rotor():
    return rotor.turning_rotor(2.0, 0.1, 0.0, 0.5, 10.0, moment=2.5), 8.0, (0.0, 0.0)


# -- chapter 10: tops and gyroscopes

SPIN = 8.0  # rad/s, of the nutating top: I0 = 1, I = 1.5, mgr = 5, let go at 0.6 rad from the vertical


def tilted(theta):
    """The start of :func:`newton_euler.scenes.top.rolled_out` at rest, but for the spin, at this angle from the vertical."""
    return math.cos(theta / 2), math.sin(theta / 2), 0.0, 0.0, 0.0, 0.0


@_scene("10.4", "spherical pendulum", "a bar on a ball joint, pushed sideways, without a singular place")
def _spherical():
    return spherical_pendulum.pendulum(3.0, 2.0, 9.81), 8.0, (math.cos(1.2), math.sin(1.2), 0.0, 0.0, 0.1, 0.7)


@_scene("10.4", "spherical pendulum, nodding", "its angle from the vertical alone, the cyclic one eliminated")
def _nodding():
    return spherical_pendulum.nodding(3.0, 2.0, 9.81, 2.0, 1.5), 8.0, (2.0, 0.0)


@_scene("10.5", "top", "a nutating top, in the frame that does not spin")
def _top():
    return top.rolled_out(1.0, 1.5, 5.0, SPIN), 10.0, tilted(0.6)


@_scene("10.5", "top, attitude", "the nutating top by the quaternion of the body")
def _attitude():
    return top.attitude(1.0, 1.5, 5.0, SPIN), 10.0, tilted(0.6)


@_scene("10.5", "top, nutation", "the nutating top reduced to its angle from the vertical")
def _nutation():
    return top.reduced(1.0, 1.5, 5.0, SPIN, top.surplus(1.0, 1.5, 0.6, 0.0, SPIN)), 10.0, (0.6, 0.0)


@_scene("10.5", "top, angles", "the nutating top in Euler's angles")
def _angles():
    return top.euler(1.0, 1.5, 5.0, SPIN), 10.0, (0.0, 0.6, 0.0, 0.0, 0.0)


@_scene("10.7", "turning shaft", "a rod hinged on a turning shaft, swinging about the angle at which it would stay")
def _shaft():
    return turning_shaft.hinged(**turning_shaft.rod(3.0, 2.0, 4.0, 9.81)), 12.0, (0.2, 0.5)


@_scene("10.8", "free body", "a spin about the intermediate axis, which it leaves and comes back to")
def _tumbling():
    return free_body.free_body(1.0, 2.0, 3.0), 50.0, (0.01, 1.0, 0.01)


@_scene("10.8", "free body, calm", "a spin near the axis of the least moment")
def _calm():
    return free_body.free_body(1.0, 1.5, 2.2), 20.0, (1.0, 0.1, 0.4)


@_scene("10.8", "free symmetric body", "a football, with its attitude")
def _football():
    return top.free(3.0, 1.0, 6.0), 10.0, (1.0, 0.0, 0.0, 0.0, 0.8, 0.0)


@_scene("10.11", "gyrocompass", "a level axis that swings about north, for two minutes")
def _compass():
    return gyrocompass.gyrocompass(0.002, 0.003, 1000.0, 7.292e-5, 0.8), 120.0, (1.0, 0.0)


# -- chapter 11: energy


@_scene("11.15", "sphere on an incline", "a sphere that rolls down a plane of 30 degrees")
def _incline():
    return rolling_sphere.rolling_down(math.radians(30.0), 9.8), 2.0, (1.0, 0.5)


@_scene("11.17", "pendulum", "a rigid pendulum, swinging by 1 rad")
def _pendulum():
    return pendulum.physical_pendulum(2.0, 0.5, 0.5, 10.0), 10.0, (1.0, 0.0)


@_scene("11.17", "pendulum, over the top", "a rigid pendulum let go next to the upright position")
def _upright():
    return pendulum.physical_pendulum(2.0, 0.5, 0.5, 10.0), 15.0, (3.1, 0.0)


@_scene("11.19", "car on a hill", "a car of constant power over wavy ground")
def _car():
    return car_on_hill.Car(1200.0, 20.0, 0.25, 0.3, _air, 9.81).model(power=40e3, slope=_waves), 60.0, (0.0, 10.0)


def _air(v):
    return 0.5 * v * v


def _waves(s, p, t):
    return 0.08 * sin(s.s / 64)


def scene(name):
    """The scene of this name; :class:`ModelError` lists those that there are."""
    if name not in SCENES:
        raise ModelError(f"there is no scene {name!r}; there are {', '.join(SCENES)}")
    return SCENES[name]
