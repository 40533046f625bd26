"""One car seen from another that turns (2.12)."""

from dataclasses import dataclass

from ..frames import Frame
from ..jets import moving


@dataclass(frozen=True)
class TwoCars:
    """Car A on a straight road along I, car B at the crossing, heading along J in a curve to its left, with its centre on the side of -I.

    distance : of A before the crossing; radius : of B's curve; speeds and their rates of change. Any consistent units.

    >>> cars = TwoCars(distance=30.0, radius=200.0, v_A=25.0, rate_A=2.0, v_B=20.0, rate_B=-4.0)
    >>> print(*cars.A_seen_from_B())
    [25, -17, 0] in car B [0.3, -1.6, 0] in car B
    """

    distance: object
    radius: object
    v_A: object
    rate_A: object
    v_B: object
    rate_B: object

    def scene(self):
        """(ground, B, A): the ground, the frame that turns with car B (at this instant parallel to the ground), and car A as a Point."""
        ground = Frame("ground")
        at_crossing = ground.point("B", moving(0, 0, -self.v_B * self.v_B / self.radius), moving(0, self.v_B, self.rate_B), 0)
        B = ground.rotate("car B", "z", moving(0, self.v_B / self.radius, self.rate_B / self.radius), origin=at_crossing)
        return ground, B, ground.point("A", moving(-self.distance, self.v_A, self.rate_A), 0, 0)

    def A_seen_from_B(self):
        """Velocity and acceleration of A as seen by somebody in B, along B's axes: (2.24), (2.25) solved for v_r and a_r."""
        _, B, A = self.scene()
        return A.velocity(B).expressed_in(B), A.acceleration(B).expressed_in(B)
