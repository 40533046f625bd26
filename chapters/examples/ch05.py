"""Worked example of chapter 5, systems of particles: a projectile that bursts. (The bodies of 5.5
and 5.6 stand in ch07.)
"""

from dataclasses import dataclass

from newton_euler import Frame, Vector, cos, sin
from newton_euler.algebra.scalars import Scalar, to_plain


@dataclass(frozen=True)
class BurstingProjectile:
    """A projectile that bursts at the top of its path into three pieces (5.3).

    It is launched in the (x, z) plane, z up. After the burst A flies straight up, B horizontally,
    and C has the rest of the momentum. Any consistent units. Neglected: air resistance, and the
    impulse of the weight during the burst.

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
        others = self.m_A * ground.vector(0, 0, self.v_A) + self.m_B * self.v_B(ground)
        return (before - others) / self.m_C

    def v_G(self, ground: Frame | None = None) -> Vector:
        """The velocity of the common centre of mass after the burst (5.4), the same as before."""
        ground = ground or Frame("ground")
        momentum = (
            self.m_A * ground.vector(0, 0, self.v_A)
            + self.m_B * self.v_B(ground)
            + self.m_C * self.v_C(ground)
        )
        return momentum / (self.m_A + self.m_B + self.m_C)
