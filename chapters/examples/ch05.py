"""Worked examples of chapter 5, systems of particles: a hammer on a film, a projectile that bursts.
(The bodies of 5.5 and 5.6 are in ch07.)
"""

from dataclasses import dataclass

from newton_euler import Frame, Vector, cos, sin
from newton_euler.algebra.scalars import Scalar, to_plain

HEAD, END = -0.08, 0.24  # m from G along the handle: where a hammer on a film is marked


def hammer(t: Scalar) -> tuple[tuple[Scalar, Scalar], Scalar]:
    """A juggled hammer at the time t: (x, z) of its centre of mass, and the angle of its handle
    from x towards z, m and rad (5.2). It is thrown at 4.9 m/s upward and turns at 12 rad/s.

    >>> hammer(1.0)
    ((1.2, 1.495), 12.3)
    """
    return (1.2 * t, 1.5 + 4.9 * t - 4.905 * t * t), 0.3 + 12.0 * t


def hammer_on_film(pictures: int = 26, a_second: float = 25.0) -> list[tuple[float, ...]]:
    """What a film shows of :func:`hammer`: rows of t, x and z of its head, x and z of the end of
    its handle, read to the millimetre (5.2). Invented data.

    >>> hammer_on_film()[0]
    (0.0, -0.076, 1.476, 0.229, 1.571)
    """
    rows = []
    for n in range(pictures):
        t = n / a_second
        (x, z), angle = hammer(t)
        c, s = cos(angle), sin(angle)
        marks = [(x + d * c, z + d * s) for d in (HEAD, END)]
        rows.append((t, *(round(float(u), 3) for mark in marks for u in mark)))
    return rows


@dataclass(frozen=True)
class BurstingProjectile:
    """A projectile that bursts at the top of its path into three pieces (5.3), launched in the (x,
    z) plane, z up. After the burst A flies straight up, B horizontally, and C has the rest of the
    momentum. Any consistent units. Neglected: air resistance, and the impulse of the weight during
    the burst.

    v_x, v_z : launch velocity
    m_A, m_B, m_C : masses, or weights, since only their ratios matter
    v_A : speed of A after the burst
    angle_B, range_B : direction of B from x in the horizontal plane (rad), and the horizontal
        distance from the burst to where B lands
    g : gravity

    >>> import math
    >>> shell = BurstingProjectile(  # ft, s
    ...     180.0, 240.0, 5.0, 9.0, 6.0, 179.0, math.pi/4, 4000.0, 32.2)
    >>> print(shell.v_C())
    [30.779, -569.221, -149.167] in ground
    """

    v_x: Scalar
    v_z: Scalar
    m_A: Scalar
    m_B: Scalar
    m_C: Scalar
    v_A: Scalar
    angle_B: Scalar
    range_B: Scalar
    g: Scalar

    def top(self) -> tuple[Scalar, Scalar]:
        """(time, height) of the highest point."""
        time = self.v_z / self.g
        return time, self.v_z * time / 2

    def v_B(self, ground: Frame | None = None) -> Vector:
        """The velocity of B after the burst: it falls for as long as the projectile rose, and
        travels ``range_B`` in that time.
        """
        speed = self.range_B / self.top()[0]
        x, y = to_plain(speed * cos(self.angle_B)), to_plain(speed * sin(self.angle_B))
        return (ground or Frame("ground")).vector(x, y, 0)

    def v_C(self, ground: Frame | None = None) -> Vector:
        """The velocity of C after the burst, which keeps the momentum of the three (5.8)."""
        ground = ground or Frame("ground")
        before = (self.m_A + self.m_B + self.m_C) * ground.vector(self.v_x, 0, 0)
        return (before - self._momentum_of_A_and_B(ground)) / self.m_C

    def v_G(self, ground: Frame | None = None) -> Vector:
        """The velocity of the common centre of mass after the burst (5.4), the same as before."""
        ground = ground or Frame("ground")
        momentum = self._momentum_of_A_and_B(ground) + self.m_C * self.v_C(ground)
        return momentum / (self.m_A + self.m_B + self.m_C)

    def _momentum_of_A_and_B(self, ground):
        return self.m_A * ground.vector(0, 0, self.v_A) + self.m_B * self.v_B(ground)
