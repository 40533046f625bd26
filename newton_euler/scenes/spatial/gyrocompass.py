"""The gyrocompass (10.11): a gyroscope whose axis is kept level swings about north."""

from ...algebra.scalars import Scalar, cos, sin
from ...motion.model import Model
from ..catalogue import scene


@scene(
    "10.11", "gyrocompass", "a level axis that swings about north, two minutes",
    120.0, (1.0, 0.0),
    I0=0.002, I=0.003, omega_z=1000.0, earth_rate=7.292e-5, latitude=0.8,
)  # fmt: skip
def gyrocompass(
    I0: Scalar, I: Scalar, omega_z: Scalar, earth_rate: Scalar, latitude: Scalar
) -> Model:
    """The Model of the gyrocompass: states azimuth (rad, from north) and azimuth_rate.

    With c = Omega cos(latitude) the axis turns at c sin(azimuth) about the level and at Omega
    sin(latitude) + azimuth' about the vertical, so that I0 azimuth'' = -c sin(azimuth) (I omega_z -
    I0 c cos(azimuth)).

    >>> compass = gyrocompass(0.002, 0.003, 1000.0, 7.292e-5, 0.8)
    >>> compass.derivative((0.1, 0.0))[1] < 0 < compass.derivative((-0.1, 0.0))[1]  # back to north
    True
    """
    return Model("gyrocompass", locals(), ("azimuth", "azimuth_rate"), _rates, {"energy": _energy})


def _rates(s, p, t):
    level = p.earth_rate * cos(p.latitude)
    momentum = p.I * p.omega_z - p.I0 * level * cos(s.azimuth)
    return s.azimuth_rate, -level * sin(s.azimuth) * momentum / p.I0


def _energy(s, p, t):
    level = p.earth_rate * cos(p.latitude)
    square = s.azimuth_rate**2 - (level * sin(s.azimuth)) ** 2
    return p.I0 * square / 2 - p.I * p.omega_z * level * cos(s.azimuth)
