"""The figures of appendix B: the solids of the table with their axes, and their moments as bars."""

from collections.abc import Sequence
from fractions import Fraction

from newton_euler import Frame
from newton_euler.algebra.late import plt
from newton_euler.bodies.solids import box, cone, cylinder
from newton_euler.classroom import Slider, show_figure
from newton_euler.drawing import AnyAxes, Sketch

from .curves import evenly
from .sliding import with_sliders

O = (0, 0, 0)
SCALE = 6  # height of a bar, in metres of the sketch, for 1 kg m^2


@with_sliders(
    Slider("x", 0.7, 0.2, 1.0, 0.1, unit="m"),
    Slider("y", 0.8, 0.2, 1.0, 0.1, unit="m"),
    Slider("z", 0.6, 0.2, 1.0, 0.1, unit="m"),
    alt="Axes x, y, z and an element of mass dm. An arrow of length l_x leads from the x axis "
    "straight to the element; its square is y squared plus z squared and does not contain x.",
    size=(6.0, 4.4),
)
def element(ax: AnyAxes, x: float, y: float, z: float) -> None:
    """Figure B.1: an element of mass and its distance from the x axis."""
    ground = Frame("ground")
    s = Sketch(ax, ground, azimuth=30, elevation=22)
    s.axes(O, ground, length=1.2)
    s.sphere((x, y, z), 0.05)
    s.label((x, y, z), "dm")
    s.arrow((x, 0, 0), (x, y, z), r"$\ell_x$", "acceleration")
    s.line((x, 0, 0), (x, y, 0))
    s.line((x, y, 0), (x, y, z))
    s.dimension((x, 0, 0), (x, y, 0), "y", offset=(0, 0, -0.12))
    s.label((x, y, z / 2), "z", bold=False)
    ax.set_title(rf"$\ell_x^2 = y^2 + z^2$ = {y**2 + z**2:.2f} m²", fontsize=11)


def table() -> None:
    """Figure B.2: the seven solids of the table, with their axes and centres of mass."""
    ground = Frame("ground")
    corners = [(0, -0.5, -0.3), (0, 0.5, -0.3), (0, 0.5, 0.3), (0, -0.5, 0.3)]
    solids = {  # what draws each, and its centre of mass
        "thin rod": (lambda s: s.rod((-0.7, 0, 0), (0.7, 0, 0)), O),
        "thin rectangular plate": (lambda s: s.plate(corners), O),
        "rectangular prism": (lambda s: s.box(O, ground, (0.9, 0.6, 0.4)), O),
        "thin disk": (lambda s: s.disk(O, ground.i, 0.55), O),
        "cylinder": (lambda s: s.cylinder((-0.5, 0, 0), (0.5, 0, 0), 0.35), O),
        "cone, axes at the apex": (lambda s: s.cone(O, ground.i, 1.0, 0.45), (0.75, 0, 0)),
        "sphere": (lambda s: s.sphere(O, 0.5), O),
    }
    fig, axes = plt.subplots(2, 4, figsize=(11, 5.2))
    for ax, (name, (draw, G)) in zip(axes.flat, solids.items(), strict=False):
        s = Sketch(ax, ground, azimuth=55, elevation=22)
        draw(s)
        s.axes(O, ground, length=1.1)
        s.dot(G, "G")
        ax.set_title(name, fontsize=11)
    axes.flat[-1].axis("off")
    show_figure(
        fig,
        alt="Seven solids with their axes x, y, z: a thin rod along x, a thin plate and a thin disk "
        "with the normal x, a prism, a cylinder along x, a cone along x with the axes at its apex, "
        "a sphere. A dot G marks the centre of mass; it is at the origin except for the cone.",
    )


@with_sliders(
    Slider("n", 4, 1, 24, 1, label="particles"),
    alt="A rod drawn as a row of equal particles, each in the middle of its share of the length, "
    "and the axis across the middle. With more particles the sum of mass times distance "
    "squared approaches one twelfth of mass times length squared, from below.",
    size=(6.4, 2.6),
)
def particles(ax: AnyAxes, n: float) -> None:
    """Figure B.3: a rod as a row of equal particles."""
    n = round(n)
    places = [-0.5 + (k + 0.5) / n for k in range(n)]
    total = sum(x**2 for x in places) / n
    s = Sketch(ax, Frame("ground"), plane="xz")
    s.line((-0.5, 0, 0), (0.5, 0, 0), style="solid")
    s.line((0, 0, -0.08), (0, 0, 0.2), style="centre")
    for x in places:
        s.sphere((x, 0, 0), 0.02)
    s.dimension((-0.5, 0, 0), (0.5, 0, 0), "L", offset=-0.12)
    count = f"{n} particle{'s' * (n > 1)}"
    ax.set_title(f"{count}: {total:.5f} $mL^2$; 1/12 = {1 / 12:.5f}", fontsize=11)


def _bars(ax, moments):
    """The three moments as bars, with their values."""
    s = Sketch(ax, Frame("ground"), plane="xz")
    s.line((-0.1, 0, -0.5), (1.5, 0, -0.5), style="solid")
    for n, (I, axis) in enumerate(zip(moments, "xyz", strict=True)):
        left, right, top = 0.5 * n, 0.5 * n + 0.35, SCALE * float(I) - 0.5
        corners = [(left, 0, -0.5), (right, 0, -0.5), (right, 0, top), (left, 0, top)]
        s.plate(corners, shade="dark")
        s.label(((left + right) / 2, 0, top), f"{float(I):.3f}", offset=(0, 9), bold=False)
        s.label(((left + right) / 2, 0, -0.5), f"$I_{{{axis}{axis}}}$", offset=(0, -12))
    ax.set_title("moments about G in kg m², mass 1 kg", fontsize=10)


@with_sliders(
    Slider("y", 0.7, -0.9, 0.9, 0.1, unit="m"),
    Slider("z", 0.4, -0.6, 0.6, 0.1, unit="m"),
    alt="A flat plate in the plane of y and z, seen along x, and an element dm of it. Its "
    "distance from the y axis is z, from the z axis y, and from the x axis, which points at "
    "the reader, the root of the sum of their squares.",
    size=(6.0, 4.2),
)
def flat(ax: AnyAxes, y: float, z: float) -> None:
    """Figure B.4: an element of a flat body and its distances from three axes."""
    s = Sketch(ax, Frame("ground"), plane="yz")
    s.plate([(0, -1, -0.7), (0, 1, -0.7), (0, 1, 0.7), (0, -1, 0.7)], shade="light")
    s.axes(O, s.frame, 1.2, ["", "y", "z"])
    s.dot((0, y, z), "dm")
    s.arrow(O, (0, y, z), r"$\ell_x$", "acceleration")
    s.arrow((0, 0, z), (0, y, z), "$y$", "velocity")
    s.arrow((0, y, 0), (0, y, z), "$z$", "velocity")
    squares = rf"$y^2$ = {y**2:.2f}, $z^2$ = {z**2:.2f}, $\ell_x^2$ = {y**2 + z**2:.2f} m²"
    ax.set_title(squares, fontsize=11)


@with_sliders(
    Slider("a", 0.9, 0.02, 1.0, 0.02, unit="m"),
    Slider("b", 0.6, 0.02, 1.0, 0.02, unit="m"),
    Slider("c", 0.4, 0.02, 1.0, 0.02, unit="m"),
    alt="Left: a rectangular prism with the edges a, b, c along x, y, z. Right: its three moments "
    "of inertia as bars. The edge along an axis does not change the moment about that axis.",
    size=(8.4, 4.4),
    panels=(1, 2),
)
def prism(axes: Sequence[AnyAxes], a: float, b: float, c: float) -> None:
    """Figure B.5: a prism of 1 kg and its moments."""
    ground = Frame("ground")
    s = Sketch(axes[0], ground, azimuth=35, elevation=22)
    s.box(O, ground, (a, b, c))
    s.dimension((-a / 2, b / 2, -c / 2), (a / 2, b / 2, -c / 2), "a")
    s.dimension((a / 2, -b / 2, -c / 2), (a / 2, b / 2, -c / 2), "b")
    s.dimension((-a / 2, b / 2, -c / 2), (-a / 2, b / 2, c / 2), "c")
    s.axes(O, ground, length=0.8)
    _bars(axes[1], box(a, b, c, ground, mass=1.0).inertia.moments)


@with_sliders(
    Slider("a", 0.3, 0.02, 0.6, 0.02, unit="m"),
    Slider("L", 0.8, 0.02, 1.2, 0.02, unit="m"),
    alt="Left: a circular cylinder along x. Right: its moments of inertia as bars. When it is "
    "short it is a disk, with I_xx twice the others; when it is slender, a rod with I_xx "
    "nearly zero.",
    size=(8.4, 4.4),
    panels=(1, 2),
)
def round_bar(axes: Sequence[AnyAxes], a: float, L: float) -> None:
    """Figure B.6: a cylinder of 1 kg and its moments."""
    ground = Frame("ground")
    s = Sketch(axes[0], ground, azimuth=35, elevation=22)
    s.cylinder((-L / 2, 0, 0), (L / 2, 0, 0), a)
    s.dimension((-L / 2, 0, -a), (L / 2, 0, -a), "L")
    s.line((L / 2, 0, 0), (L / 2, 0, -a))
    s.label((L / 2, 0, -a / 2), "a", bold=False)
    s.axes(O, ground, length=0.9)
    _bars(axes[1], cylinder(a, L, ground, mass=1.0).inertia.moments)


@with_sliders(
    Slider("d", 0.3, 0.0, 1.0, 0.05, unit="m"),
    alt="Left: a cone along x and a transverse axis at the distance d from its apex. Right: the "
    "moment about that axis against d, a parabola with its lowest point where the axis "
    "passes through the centre of mass, three quarters of the height from the apex.",
    size=(8.4, 4.2),
    panels=(1, 2),
)
def cone_axes(axes: Sequence[AnyAxes], d: float) -> None:
    """Figure B.7: the transverse moment of a cone about an axis that is moved along it."""
    a, h = 0.4, 1.0
    d = round(d, 9) + 0.0  # no -0.00 in the title
    ground = Frame("ground")
    body = cone(a, h, ground, mass=1.0)
    s = Sketch(axes[0], ground, azimuth=-65, elevation=20)
    s.cone(O, ground.i, h, a)
    s.line((d, -0.7, 0), (d, 0.7, 0), style="centre")
    s.dot((3 * h / 4, 0, 0), "G")
    s.axes(O, ground, 1.2)
    s = Sketch(axes[1], ground, plane="xz")

    def I_yy(x):
        return float(body.about(ground.point("P", x, 0, 0)).moments[1])

    s.path([(x, 0, I_yy(x)) for x in evenly(0, h, 41)])
    s.axes(O, ground, 1.1, ["$d$", "", "$I$"])
    for x, name in ((0.0, "apex"), (3 * h / 4, "G"), (h, "base")):
        s.line((x, 0, 0), (x, 0, I_yy(x)), style="dotted")
        s.label((x, 0, 0), name, offset=(0, -10), bold=False)
    s.dot((d, 0, I_yy(d)))
    axes[1].set_title(f"axis at d = {d:.2f} m: I = {I_yy(d):.4f} kg m²", fontsize=11)


def top() -> None:
    """Figure B.8: a top of cone, disk and stem, cut along its axis, which points up."""
    ground = Frame("ground")
    fig, ax = plt.subplots(figsize=(4.4, 4.8))
    s = Sketch(ax, ground, plane="yx")
    s.plate([(0, 0, 0), (4, -3, 0), (4, 3, 0)])
    s.plate([(4, -3, 0), (4.5, -3, 0), (4.5, 3, 0), (4, 3, 0)])
    s.plate([(4.5, -0.5, 0), (7.5, -0.5, 0), (7.5, 0.5, 0), (4.5, 0.5, 0)])
    s.axes(O, ground, length=2, labels=["x", "y", ""])
    for x, name in ((2.6, "cone"), (4.25, "disk"), (6, "stem")):
        s.label((x, 0.7, 0), name, offset=(14, 0), bold=False)
    s.dimension((0, -3.2, 0), (4, -3.2, 0), "4 cm", offset=0.3)
    s.dimension((4.5, 2.0, 0), (7.5, 2.0, 0), "3 cm", offset=-0.3)
    s.dimension((-0.4, 0, 0), (-0.4, 3, 0), "3 cm", offset=(-0.3, 0, 0))
    show_figure(
        fig,
        alt="A top cut along its axis: a cone that stands on its apex, a thin disk on its base and "
        "a stem on the disk. The axes x, upward, and y start at the apex.",
    )


def exact_cone(a: float, h: float) -> list[Fraction]:
    """The moments of a cone of 1 kg about its apex, as fractions of exact decimal numbers."""
    square = Fraction(a) ** 2
    across = Fraction(3, 5) * (square / 4 + Fraction(h) ** 2)
    return [Fraction(3, 10) * square, across, across]
