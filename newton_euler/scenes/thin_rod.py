"""A thin uniform rod, by integration as the book does it (5.5, 7.3, 7.10)."""

from ..frames import Frame
from ..integration import integrated


def thin_rod(m, length, exact=False, frame=None):
    """The rod from the origin to x = ``length``: its mass spread evenly over x (5.13), (7.10). For one without integration see ``solids.rod``.

    >>> body = thin_rod(3.0, 2.0)
    >>> round(body.centre.position(body.frame).x, 12), [round(x, 12) for x in body.about(body.frame).moments]
    (1.0, [0.0, 4.0, 4.0])
    """
    return integrated(lambda x: (x, 0, 0), (0, length), frame=frame or Frame("rod"), mass=m, exact=exact, name="thin rod")
