"""An arm in a vertical plane that turns about Z; its angle beta from the vertical grows."""

from exercises.annotations import Scalar
from newton_euler import Frame, Point, Vector


def turning_boom(omega: Scalar, beta: Scalar) -> tuple[Frame, Frame, Frame]:
    """Ground; the house, turning, x outward in the plane of the boom; the boom, z along it."""
    ground = Frame("ground")
    house = ground.rotate("house", "z", rate=omega)
    return ground, house, house.rotate("boom", "y", angle=beta)


def acceleration_without_cross_product(P: Point, ground: Frame) -> Vector:
    """a_P via the boom, if alpha is without omega_house x omega_boom."""
    alpha = P.frame.angular_acceleration(ground).without("house x boom")
    return P.acceleration(ground).without("euler") + alpha.cross(P.position(P.frame))
