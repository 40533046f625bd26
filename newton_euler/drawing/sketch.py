"""Figures true to scale: a :class:`Sketch` records drawing commands; when the figure is written or
shown, everything is projected onto the page, drawn far before near, and each label put where it
covers least. Bodies are to scale; symbols (joints, arrows, axes, dimension lines) have sizes in
points of the page.
"""

from .elements.lines import Lines
from .elements.machines import Machines
from .elements.measures import Measures
from .elements.solids import Solids
from .elements.springs import Springs
from .elements.supports import Supports
from .elements.vectors import Vectors


class Sketch(Vectors, Supports, Measures, Lines, Solids, Machines, Springs):
    """A figure of a scene on ``ax``: a :class:`.Panel`, a plain 2-D matplotlib Axes, or None for a
    page of its own, which :func:`.svg` writes. Lengths are in metres. A *place* is a Point, or a
    Vector or triple of coordinates from the origin of ``ground``; a *direction* is a Vector, or a
    triple along the axes of ``ground``.

    up : the axis that points up in the figure: "x", "y" or "z"
    azimuth : the direction from which the scene is seen, in degrees about ``up``. With z up, 0 is
        from +x (y to the right), 90 from +y (x to the left), -90 from -y (x to the right). With y
        up, 0 is from +z (x to the right), 90 from +x (z to the left), -90 from -x (z to the right).
    elevation : how far above the horizontal the eye is, in degrees
    plane : two axes, as "xz", for a plane figure with the first to the right and the second up
    arrows : points of the page, the length of the longest vector of each kind

    So that no two axes look alike, stay 15 degrees or more from azimuth 0, 90, 180 … and use an
    elevation of 12 to 35.

    >>> from newton_euler import Frame
    >>> from newton_euler.drawing import Sketch
    >>> from newton_euler.drawing.page.svg import svg
    >>> ground = Frame("ground")
    >>> s = Sketch(None, ground, azimuth=30, elevation=15)
    >>> s.rod((0, 0, 0), (0, 0, 2))
    >>> s.vector((0, 0, 2), (0, -1, 0), "$F$", kind="force")
    >>> s.label((0, 0, 0), "O")
    >>> svg(s.ax.figure, "A rod stands on O and is pushed at its tip.").count("</text>")
    2
    """
