"""A machine part of sheet: half disk, rectangle and round hole (5.6, 7.10)."""

from ..frames import Frame
from ..mass import composite
from ..solids import disk, half_disk, plate


def machine_part(r, h, s, thickness=1, density=1, frame=None):
    """The sheet in the plane x = 0, with the origin in the middle of the half disk's straight edge, y along that edge.

    r : radius of the half disk, at z < 0; h : the rectangle 2 r by h, at z > 0; s : radius of the hole, in the middle of the rectangle

    >>> part = machine_part(1.0, 2.0, 0.5)
    >>> round(part.centre.position(part.frame).z, 6), part.about(part.frame).products
    (0.53244, (0, 0, 0))
    """
    frame = frame or Frame("sheet")
    middle = frame.point("middle of the rectangle", 0, 0, h / 2)
    sheet = density * thickness
    parts = [
        half_disk(r, frame, "x", "-z", density=sheet, name="half disk"),
        plate(2 * r, h, middle, "x", density=sheet, name="rectangle"),
    ]
    return composite("machine part", parts, removed=[disk(s, middle, "x", density=sheet, name="hole")])
