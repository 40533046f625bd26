"""Figures: scenes of frames, vectors, bodies and dimension lines, true to scale, in an orthographic projection.

A :class:`Sketch` only records what it is told to draw. :meth:`Sketch.finish`, which runs by itself when the figure is shown or saved,
projects everything onto a plain 2-D Axes, draws the far before the near, and puts each label where it covers least.
Bodies are to scale; symbols (joints, arrows, axes, dimension lines) have sizes in points of the printed page.
Matplotlib is imported when the figure is finished, not with this module.
"""

import math
from dataclasses import dataclass, replace
from itertools import pairwise

from .frames import Frame, Point
from .vectors import FrameError, Vector, add3, cross3, dot3, scale3, sub3

# colours that colour-blind readers tell apart (Okabe and Ito); bodies are grey
KINDS = {"velocity": "#0072B2", "acceleration": "#D55E00", "rate": "#008060", "force": "#B0408A", "plain": "#000000"}
DARK, MIDDLE, LIGHT, PALE, BLACK = "#454a50", "#c9ced4", "#dde1e5", "#eef0f2", "#000000"
DASHES = {"solid": "-", "dashed": (0, (5, 3)), "dotted": (0, (1, 2)), "centre": (0, (9, 2.5, 2, 2.5))}

# how a stroke is drawn: arguments of a matplotlib patch; a stroke may have several looks, one over the other
LOOKS = {
    "thin": {"ec": DARK, "lw": 0.9},
    "body": {"ec": DARK, "fc": LIGHT, "lw": 1.1},
    "side": {"ec": DARK, "fc": MIDDLE, "lw": 1.1},
    "top": {"ec": DARK, "fc": PALE, "lw": 1.1},
    "seam": {"ec": DARK, "lw": 0.7},
    "ring": {"ec": DARK, "lw": 1.4},
    "rod edge": {"ec": DARK, "lw": 5.6, "capstyle": "round"},
    "rod": {"ec": LIGHT, "lw": 3.6, "capstyle": "round"},
    "shaft edge": {"ec": DARK, "lw": 9.5, "capstyle": "butt"},
    "shaft": {"ec": LIGHT, "lw": 7.5, "capstyle": "butt"},
    "centre": {"ec": DARK, "lw": 0.7, "ls": DASHES["centre"], "capstyle": "butt"},
    "cable": {"ec": DARK, "lw": 1.4},
    "spring": {"ec": DARK, "lw": 1.2},
    "patch": {"ec": "none", "fc": "#f1ede4", "lw": 0},
    "support": {"ec": DARK, "lw": 1.3},
    "tip": {"ec": "#ffffff", "fc": "#ffffff", "lw": 1.5},
    "joint": {"ec": BLACK, "fc": "#ffffff", "lw": 1.2},
    "dot": {"ec": BLACK, "fc": BLACK, "lw": 0.5},
    "axis": {"ec": BLACK, "fc": BLACK, "lw": 1.0},
    "measure": {"ec": BLACK, "fc": BLACK, "lw": 0.7},
    "path": {"ec": "#6b6f75", "lw": 1.1},
    **{f"line {name}": {"ec": DARK, "lw": 0.9, "ls": dashes, "capstyle": "butt"} for name, dashes in DASHES.items()},
    **{kind: {"ec": colour, "fc": colour, "lw": 1.8} for kind, colour in KINDS.items()},
}  # fmt: skip

BODY, MARK, ARROW = range(3)  # layers: bodies cover each other by depth; marks and then arrows lie over them
FONT = 11  # points


class Sketch:
    """A figure of a scene on ``ax``, a plain 2-D matplotlib Axes. Lengths in metres; a *place* is a Point, or a Vector or triple of
    coordinates from the origin of ``ground``; a *direction* is a Vector, or a triple along the axes of ``ground``.

    azimuth, elevation : where the eye is, in degrees: about the axis ``up``, from the axis after it ("x" if up is "z") towards the next,
        and above the horizontal
    plane : two axes, as "xz", for a plane figure with the first to the right and the second up
    """

    def __init__(self, ax, ground, azimuth=35, elevation=20, up="z", plane=None):
        if not hasattr(ax, "add_patch"):
            raise FrameError(f"a sketch is drawn on a matplotlib Axes, got {ax!r}; make one with fig, ax = plt.subplots()")
        if not isinstance(ground, Frame):
            raise FrameError(f"a sketch shows a scene from its ground, a Frame; got {ground!r}. Write Sketch(ax, ground)")
        self.ax, self.frame = ax, ground
        self.view = _plane_view(plane) if plane is not None else _space_view(azimuth, elevation, up)
        self._commands, self._extent, self._longest, self._artists = [], [], {}, []
        self._pending, self._before = False, None

    # -- frames and vectors

    def axes(self, P, frame, length=None, labels="xyz"):
        """The unit vectors of ``frame`` as arrows at P, ``length`` metres long, with three labels (a string or a list; "" for none)."""
        if not isinstance(frame, Frame):
            raise FrameError(f"axes(P, frame) draws the axes of a Frame, got {frame!r}")
        if labels and len(labels) != 3:
            raise FrameError(f"the axes have three labels, as in labels='XYZ' or labels=['x_1', 'y_1', 'z_1']; got {labels!r}")
        P, units = self._place(P), [self._triple(e.components(self.frame), "axis") for e in (frame.i, frame.j, frame.k)]
        length = length and self._size(length)

        def command(ink):
            for e, text in zip(units, labels or ("", "", ""), strict=True):
                tip = add3(P, scale3(length or 38 * ink.pt, e))
                ink.arrow(P, tip, "axis", MARK)
                ink.note(tip, _italic(text), away_from=P, gap=2)

        self._record(command)

    def vector(self, P, v, label="", kind="velocity"):
        """An arrow from P along ``v``. ``kind``, which sets the colour: velocity, acceleration, rate, force, plain.

        The longest arrow of each kind gets a length that suits the figure, the others their share of it.
        """
        if kind not in KINDS:
            raise FrameError(f"an arrow is of the kind {', '.join(KINDS)}; got {kind!r}")
        P, v = self._place(P), self._triple(v, "direction")
        size = _length(v)
        self._longest[kind] = max(size, self._longest.get(kind, 0))

        def command(ink):
            tip = P
            if size:
                tip = add3(P, scale3(62 * ink.pt / size * max(size / self._longest[kind], 0.25), v))
                ink.arrow(P, tip, kind, ARROW)
            ink.note(tip, _italic(label), away_from=P, colour=KINDS[kind], gap=3)

        self._record(command)

    def turn(self, P, axis, label="", radius=None):
        """A curved arrow about ``axis`` through P, right-handed: a rate of turning. ``radius`` in metres."""
        P, axis = self._place(P), self._unit(axis)
        radius = radius and self._size(radius)

        def command(ink):
            r = radius or 17 * ink.pt
            e1, e2 = ink.view.across(ink.view.tilted(axis))
            arc = [_on_circle(P, e1, e2, r, math.radians(a)) for a in range(-200, 65, 10)]
            for n in range(0, len(arc) - 2, 2):  # the rear goes behind the body that turns, the front is never hidden
                in_front = ink.view.depth(sub3(arc[n + 1], P)) > -1e-9 * r
                ink.line(arc[n : n + 3], "rate", MARK if in_front else BODY)
            ink.head(arc[-4], arc[-1], "rate", MARK)
            ink.note(arc[-3], _italic(label), away_from=P, colour=KINDS["rate"], gap=5)

        self._record(command)

    # -- bodies

    def rod(self, A, B):
        """A slender rod from A to B."""
        self._straight(A, B, "rod edge", "rod")

    def shaft(self, A, B):
        """A shaft from A to B with its centre line."""
        self._straight(A, B, "shaft edge", "shaft", "centre")

    def line(self, A, B, style="dashed"):
        """A thin line from A to B, ``style`` solid, dashed, dotted or centre."""
        if style not in DASHES:
            raise FrameError(f"a line is {', '.join(DASHES)}; got {style!r}")
        self._straight(A, B, f"line {style}")

    def cable(self, A, B):
        """A cable from A to B."""
        self._straight(A, B, "cable")

    def _straight(self, A, B, *looks):
        A, B = self._place(A), self._place(B)
        self._record(lambda ink: ink.line((A, B), looks))

    def spring(self, A, B):
        """A coil spring from A to B."""
        A, B = self._place(A), self._place(B)

        def command(ink):
            side = ink.view.sideways(A, B)
            swings = [(0, 0), (0.15, 0), *((0.15 + 0.7 * (n + 0.5) / 12, (-1) ** n) for n in range(12)), (0.85, 0), (1, 0)]
            ink.line([add3(_between(A, B, t), scale3(5 * s * ink.pt, side)) for t, s in swings], "spring")

        self._record(command)

    def disk(self, C, normal, radius, spoke=None):
        """A thin disk about C. ``spoke``: a place on its rim that is joined to C, which shows how it has turned."""
        C, normal = self._place(C), self._unit(normal)
        rim = self._reach(*_circle(C, normal, self._size(radius)))
        spoke = None if spoke is None else self._place(spoke)

        def command(ink):
            ink.face(rim, "body", normal)
            if spoke:
                ink.line((C, spoke), "ring", depth=ink.view.depth(C) + ink.pt)

        self._record(command)

    def ring(self, C, normal, radius):
        """A circle about C without a filling."""
        rim = self._reach(*_circle(self._place(C), self._unit(normal), self._size(radius)))

        def command(ink):
            for n in range(0, len(rim), 4):
                ink.line([*rim, rim[0]][n : n + 5], "ring")

        self._record(command)

    def cone(self, apex, axis, length, radius):
        """A cone from its apex along ``axis`` to a base of ``radius`` at the distance ``length``."""
        apex, axis = self._place(apex), self._unit(axis)
        base = self._reach(*_circle(add3(apex, scale3(self._size(length), axis)), axis, self._size(radius)))

        def command(ink):
            ink.solid([apex, *base], "side")
            ink.end(base, axis, "top")

        self._record(command)

    def gear(self, C, normal, radius, cone_apex=None):
        """A gear wheel about C with the pitch ``radius``; with ``cone_apex`` also the lines of its pitch cone."""
        C, normal, r = self._place(C), self._unit(normal), self._size(radius)
        apex = None if cone_apex is None else self._place(cone_apex)
        e1, e2 = _across(normal)
        count = 28
        teeth = [(n + d, 1 + h) for n in range(count) for d, h in ((-0.3, -0.05), (-0.15, 0.05), (0.15, 0.05), (0.3, -0.05))]
        rim = self._reach(*(_on_circle(C, e1, e2, r * f, 2 * math.pi * n / count) for n, f in teeth))

        def command(ink):
            ink.face(rim, "body", normal)
            ink.line(_circle(C, normal, 0.18 * r, closed=True), "seam", depth=ink.view.depth(C) + ink.pt)
            for end in _silhouette(ink.view, apex, _circle(C, normal, r)) if apex else ():
                ink.line((apex, end), "line centre")

        self._record(command)

    def cylinder(self, A, B, radius):
        """A cylinder with the axis from A to B."""
        A, B, r = self._place(A), self._place(B), self._size(radius)
        axis = self._unit(sub3(B, A))
        first, last = (self._reach(*_circle(P, axis, r)) for P in (A, B))
        self._record(lambda ink: ink.cylinder(first, last, axis, "side", "top"))

    def sphere(self, C, radius):
        """A sphere about C."""
        C, r = self._place(C), self._size(radius)
        outline = self._reach(*_circle(C, self.view.eye, r))
        equator = _circle(C, self.view.tilted(self.view.up), r)

        def command(ink):
            ink.line(outline, "body", closed=True, depth=ink.view.depth(C) + r / 2)
            near = [p for p in equator[36:] + equator[:36] if ink.view.depth(sub3(p, C)) > 0]
            ink.line(near, "seam", depth=ink.view.depth(C) + r / 2 + ink.pt)

        self._record(command)

    def plate(self, corners):
        """A plane plate with these corners, three or more places in order."""
        corners = [self._place(P) for P in corners]
        if len(corners) < 3:
            raise FrameError(f"a plate has three corners or more, got {len(corners)}")
        self._record(lambda ink: ink.face(corners, "body", _normal(corners)))

    def box(self, centre, frame, sizes):
        """A box about ``centre`` with its edges, of three ``sizes`` in metres, along the axes of ``frame``."""
        if not isinstance(frame, Frame):
            raise FrameError(f"box(centre, frame, sizes) takes the directions of its edges from a Frame, got {frame!r}")
        C, sizes = self._place(centre), self._triple(sizes, "sizes")
        halves = [scale3(s / 2, e.components(self.frame)) for s, e in zip(sizes, (frame.i, frame.j, frame.k), strict=True)]
        faces = [(sign, n) for n in range(3) for sign in (1, -1)]

        def corners(sign, n):
            middle, a, b = add3(C, scale3(sign, halves[n])), halves[(n + 1) % 3], halves[(n + 2) % 3]
            return [add3(middle, add3(scale3(s, a), scale3(t, b))) for s, t in ((1, 1), (-1, 1), (-1, -1), (1, -1))]

        self._reach(*(p for face in faces for p in corners(*face)))

        def command(ink):
            for sign, n in faces:
                if ink.view.depth(scale3(sign, halves[n])) > 1e-12 * _length(sizes):
                    ink.face(corners(sign, n), ("body", "side", "top")[n], halves[n])

        self._record(command)

    # -- supports and joints

    def ground(self, P, normal, size=None):
        """Fixed ground at P, a hatched patch that faces ``normal``, ``size`` metres wide."""
        P, normal = self._place(P), self._unit(normal)
        size = size and self._size(size)

        def command(ink):
            half = (size or 44 * ink.pt) / 2
            edge_on = abs(ink.view.depth(normal)) < 0.2
            (ink.support if edge_on else ink.floor)(P, normal, half)

        self._record(command)

    def hinge(self, P, axis=None):
        """A hinge at P: a small circle, or a sleeve along ``axis``."""
        P, axis = self._place(P), None if axis is None else self._unit(axis)

        def command(ink):
            if axis is None or abs(ink.view.depth(axis)) > 0.95:
                ink.disc(P, 3.6, "joint")
            else:
                first, last = (_circle(add3(P, scale3(s * 8 * ink.pt, axis)), axis, 4 * ink.pt) for s in (-1, 1))
                ink.cylinder(first, last, axis, "joint", "joint", MARK)

        self._record(command)

    def ball_joint(self, P):
        """A ball joint at P."""
        P = self._place(P)
        self._record(lambda ink: (ink.disc(P, 5.5, "joint"), ink.disc(P, 3.4, "side")))

    def dot(self, P):
        """A small black dot at P."""
        P = self._place(P)
        self._record(lambda ink: ink.disc(P, 2, "dot"))

    # -- measures and names

    def arc(self, C, A, B, label=""):
        """The angle at C from CA to CB, with its label."""
        C, A, B = self._place(C), self._place(A), self._place(B)
        a, b = sub3(A, C), sub3(B, C)
        if not (_length(a) and _length(b)):
            raise FrameError(f"an angle at {C} needs two other places to point to; got {A} and {B}")
        a, b = scale3(1 / _length(a), a), scale3(1 / _length(b), b)
        angle = math.atan2(_length(cross3(a, b)), dot3(a, b))
        if _length(cross3(a, b)) > 1e-9:
            side = cross3(cross3(a, b), a)
        else:  # at 0 and at 180 degrees any plane will do: the one that faces the eye most
            side = cross3(_across_most(a, self.view.eye), a)
        side = scale3(1 / _length(side), side)
        reach = min(_length(sub3(A, C)), _length(sub3(B, C)))

        def command(ink):
            r = min(30 * ink.pt, 0.7 * reach)
            ink.line([_on_circle(C, a, side, r, angle * n / 24) for n in range(25)], "thin", MARK)
            ink.note(_on_circle(C, a, side, r, angle / 2), _italic(label), away_from=C, gap=2)

        self._record(command)

    def dimension(self, A, B, label="", offset=None):
        """A dimension line beside AB. ``offset``: by how much, in metres: a number, to the left of AB as seen, or a direction."""
        A, B = self._place(A), self._place(B)
        shift = offset if offset is None or isinstance(offset, (int, float)) else self._triple(offset, "offset")

        def command(ink):
            left = ink.view.sideways(A, B)
            if shift is None:
                inside = dot3(sub3(ink.centre, A), left) > 0
                by = scale3((-16 if inside else 16) * ink.pt, left)
            else:
                by = shift if isinstance(shift, tuple) else scale3(shift, left)
            a, b = add3(A, by), add3(B, by)
            if _length(by):
                beyond = scale3(3 * ink.pt / _length(by), by)
                for P, p in ((A, a), (B, b)):
                    ink.line((_between(P, p, 0.2), add3(p, beyond)), "measure", MARK)
            if ink.view.seen(sub3(B, A)):
                ink.line((a, b), "measure", MARK)
                ink.head(b, a, "measure", MARK, 6)
                ink.head(a, b, "measure", MARK, 6)
            ink.note(_between(a, b, 0.5), _italic(label), away_from=_between(A, B, 0.5), gap=3)

        self._record(command)

    def path(self, points):
        """A curve through many places."""
        points = [self._place(P) for P in points]

        def command(ink):
            for n in range(0, len(points) - 1, 4):
                ink.line(points[n : n + 5], "path")

        self._record(command)

    def label(self, P, text, offset=None):
        """The name of a place, bold, beside it. ``offset``: a pair, points to the right and up; or a direction to put it in."""
        P = self._place(P)
        pair = tuple(map(float, offset)) if isinstance(offset, (tuple, list)) and len(offset) == 2 else None
        towards = None if offset is None or pair else self._triple(offset, "offset")

        def command(ink):
            away = sub3(P, towards) if towards else ink.centre
            ink.note(P, text, away_from=away, gap=5, weight="bold", fixed=pair)

        self._record(command)

    # -- what a place and a direction are

    def _place(self, P):
        """A place as a triple of floats in the ground; it counts for the extent of the figure."""
        if isinstance(P, Point):
            P = P.position(self.frame)
        return self._reach(self._triple(P, "place"))[0]

    def _triple(self, v, what):
        if isinstance(v, Point):
            raise FrameError(f"a {what} is a Vector or a triple, got the point {v.name}; write B - A for the vector from A to B")
        try:
            v = tuple(v.components(self.frame) if isinstance(v, Vector) else v)
        except TypeError:
            v = (v,)
        if len(v) != 3:
            raise FrameError(f"a {what} is a {'Point, a ' * (what == 'place')}Vector or three numbers, got {v!r}")
        try:
            v = tuple(map(float, v))
        except (TypeError, ValueError):
            raise FrameError(f"a sketch needs numbers, but the {what} is {v!r}; draw with one value for each given") from None
        if not all(map(math.isfinite, v)):
            raise FrameError(f"the {what} {v!r} is not finite and cannot be drawn")
        return v

    def _unit(self, v):
        v = self._triple(v, "direction")
        if not _length(v):
            raise FrameError("a direction of length zero points nowhere; give a vector that is not zero")
        return scale3(1 / _length(v), v)

    def _size(self, x):
        try:
            size = float(x)
        except (TypeError, ValueError):
            size = math.nan
        if not 0 < size < math.inf:
            raise FrameError(f"a radius, length or size is a positive number of metres; got {x!r}")
        return size

    def _reach(self, *points):
        self._extent.extend(points)
        return points

    # -- recording and finishing

    def _record(self, command):
        self._commands.append(command)
        if not self._pending:
            self._pending, self._before = True, self.ax.get_axes_locator()
            self.ax.set_axes_locator(self._locate)  # matplotlib asks for the place of the axes at the start of every drawing

    def _locate(self, ax, renderer):
        before = self._before
        self.finish(renderer)
        return before(ax, renderer) if before else ax.get_position(original=True)

    def finish(self, renderer=None):
        """Draw what was recorded: limits to fit, equal aspect, no frame. Runs by itself when the figure is drawn; twice does no harm."""
        if not self._pending:
            return
        self._pending = False
        if self.ax.get_axes_locator() == self._locate:
            self.ax.set_axes_locator(self._before)
        for artist in self._artists:
            artist.remove()
        width, height = (size * 72 / self.ax.figure.dpi for size in self.ax.bbox.size)
        ink = self._inked(width, height)
        x, y = ink.middle()
        self.ax.set(xlim=(x - width / 2 * ink.pt, x + width / 2 * ink.pt), ylim=(y - height / 2 * ink.pt, y + height / 2 * ink.pt))
        self.ax.set_aspect("equal", adjustable="datalim")
        self.ax.set_axis_off()
        patches = [patch for stroke in _far_to_near(ink) for patch in stroke.drawn(self.ax, self.view)]
        self._artists = [*patches, *_labelled(self.ax, ink, renderer)]

    def _inked(self, width, height):
        """Everything in ink. Symbols have sizes in points, so how long a point is depends on the symbols: a few rounds settle it."""
        ink = _Ink(self.view, 0, self._extent)
        for _ in range(5):
            ink = _Ink(self.view, ink.point_for(width, height), self._extent)
            for command in self._commands:
                command(ink)
            if abs(ink.point_for(width, height) / ink.pt - 1) < 0.02:
                break
        return ink


class _View:
    """An orthographic projection: unit vectors to the right, up, and to the eye, in the ground."""

    def __init__(self, right, up):
        self.right, self.up, self.eye = right, up, cross3(right, up)

    def flat(self, p):
        return (dot3(p, self.right), dot3(p, self.up))

    def depth(self, p):
        """How near to the eye."""
        return dot3(p, self.eye)

    def lifted(self, p, x, y):
        """The place seen at (x, y) from p."""
        return add3(p, add3(scale3(x, self.right), scale3(y, self.up)))

    def seen(self, v):
        """False where v points so nearly at the eye that it shows as a dot."""
        return math.hypot(*self.flat(v)) > 0.1 * _length(v)

    def slant(self, v):
        """How well a direction serves for hatching: steep, and rather to the right."""
        x, y = self.flat(v)
        angle = math.atan2(y, x)
        return abs(math.sin(angle)) + 0.2 * math.sin(2 * angle)

    def sideways(self, A, B):
        """The unit vector that is seen at a right angle to the left of AB."""
        x, y = self.flat(sub3(B, A))
        size = math.hypot(x, y)
        return self.lifted((0, 0, 0), -y / size, x / size) if size else self.up

    def tilted(self, axis):
        """The axis, or if a circle about it were seen edge-on, one near it about which it shows as an ellipse."""
        d = self.depth(axis)
        if abs(d) >= 0.3:
            return axis
        return _normalized(add3(axis, scale3(math.copysign(0.3, d if abs(d) > 1e-9 else 1), self.eye)))

    def across(self, axis):
        """Two unit vectors that make a right-handed triple with ``axis``, the first towards the eye."""
        e1 = _across_most(axis, self.eye)
        return e1, cross3(axis, e1)


def _space_view(azimuth, elevation, up):
    if up not in ("x", "y", "z"):
        raise FrameError(f"up is 'x', 'y' or 'z', the axis of the ground that is vertical in the figure; got {up!r}")
    a, h = math.radians(azimuth), math.radians(elevation)
    n = "xyz".index(up)

    def turned(first, second, vertical):
        out = [0.0, 0.0, 0.0]
        out[(n + 1) % 3], out[(n + 2) % 3], out[n] = first, second, vertical
        return tuple(out)

    eye_up = turned(-math.sin(h) * math.cos(a), -math.sin(h) * math.sin(a), math.cos(h))
    return _View(turned(-math.sin(a), math.cos(a), 0.0), eye_up)


def _plane_view(plane):
    if not isinstance(plane, str) or len(plane) != 2 or len(set(plane) & set("xyz")) != 2:
        raise FrameError(f"a plane is two axes, as in plane='xz' for x to the right and z up; got {plane!r}")
    return _View(*(tuple(float(axis == name) for axis in "xyz") for name in plane))


class _Ink:
    """What is drawn, for one length ``pt`` of a point: strokes in space with their looks, and notes beside places."""

    def __init__(self, view, pt, extent):
        self.view, self.pt, self.strokes, self.notes = view, pt, [], []
        self.spots = [view.flat(p) for p in extent] or [(0.0, 0.0)]
        self.centre = _mean(extent) if extent else (0.0, 0.0, 0.0)

    def _put(self, points, looks, layer, closed, depth, normal=None):
        looks = (looks,) if isinstance(looks, str) else looks
        if depth is None:
            depth = self.view.depth(_mean(points))
        self.spots += map(self.view.flat, points)
        self.strokes.append(_Stroke(list(points), looks, layer, closed, depth, normal))

    def line(self, points, looks, layer=BODY, closed=False, depth=None):
        self._put(points, looks, layer, closed, depth)

    def face(self, corners, look, normal, layer=BODY):
        self._put(corners, look, layer, True, None, normal)

    def solid(self, points, look, layer=BODY):
        """The outline of a convex body."""
        near = (self.view.depth(_mean(points)) + max(map(self.view.depth, points))) / 2
        self._put(_hull(self.view, points), look, layer, True, near)

    def end(self, rim, outwards, look, layer=BODY):
        """The flat end of a body; turned away from the eye it is not seen, but still parts what is inside from what is outside."""
        self.face(rim, look if self.view.depth(outwards) > 0 else (), outwards, layer)

    def cylinder(self, first, last, axis, side, top, layer=BODY):
        self.solid(first + last, side, layer)
        self.end(first, scale3(-1, axis), top, layer)
        self.end(last, axis, top, layer)

    def disc(self, P, radius, look, layer=MARK):
        """A circle on the page, radius in points."""
        self.line(_circle(P, self.view.eye, radius * self.pt, 24), look, layer, closed=True)

    def head(self, tail, tip, look, layer, size=8):
        """An arrowhead at ``tip``, ``size`` points long."""
        x, y = self.view.flat(sub3(tip, tail))
        length = math.hypot(x, y) or 1.0
        x, y = size * self.pt * x / length, size * self.pt * y / length
        wing = 0.32
        corners = [tip, self.view.lifted(tip, -x - wing * y, -y + wing * x), self.view.lifted(tip, -x + wing * y, -y - wing * x)]
        self.line(corners, ("tip", look), layer, True)

    def arrow(self, tail, tip, look, layer):
        """An arrow, or where it points at the eye or away from it, a circle with a dot or a cross."""
        v = sub3(tip, tail)
        if self.view.seen(v):
            self.line((tail, tip), look, layer)
            self.head(tail, tip, look, layer, min(8, 0.6 * math.hypot(*self.view.flat(v)) / self.pt))
        else:
            self.disc(tail, 4, "joint", layer)
            d = 2.8 * self.pt
            if self.view.depth(v) > 0:
                self.disc(tail, 1.3, look, layer)
            else:
                for s in (-1, 1):
                    self.line((self.view.lifted(tail, -d, -s * d), self.view.lifted(tail, d, s * d)), look, layer)

    def support(self, P, normal, half):
        """Ground seen edge-on: a line, hatched on the far side of the normal."""
        n = _normalized(self.view.lifted((0, 0, 0), *self.view.flat(normal)))
        along = cross3(n, self.view.eye)
        self.line((add3(P, scale3(-half, along)), add3(P, scale3(half, along))), "support")
        slant = scale3(5 * self.pt, add3(scale3(-1, n), scale3(-0.8, along)))
        for k in range(-4, 6):
            foot = add3(P, scale3(half * k / 5, along))
            self.line((foot, add3(foot, slant)), "thin")

    def floor(self, P, normal, half):
        """Ground seen in perspective: a patch with hatching."""
        e1, e2 = (scale3(half, e) for e in _across(normal))
        e2 = max((e2, scale3(-1, e2)), key=lambda e: self.view.slant(add3(e1, e)))

        def corner(s, t):
            return add3(P, add3(scale3(s, e1), scale3(t, e2)))

        back = self.view.depth(P) - half
        self.line([corner(s, t) for s, t in ((1, 1), (-1, 1), (-1, -1), (1, -1))], "patch", closed=True, depth=back)
        for k in range(-3, 4):
            s = k / 2
            self.line((corner(max(-1, s - 1), max(-1, -1 - s)), corner(min(1, s + 1), min(1, 1 - s))), "seam", depth=back)

    def note(self, place, text, away_from=None, gap=3, colour=BLACK, weight="normal", fixed=None):
        if text:
            x, y = self.view.flat(sub3(place, away_from)) if away_from else (0, 0)
            self.notes.append((self.view.flat(place), text, math.atan2(y, x), gap, colour, weight, fixed))

    def box(self):
        xs, ys = zip(*self.spots, strict=True)
        return min(xs), max(xs), min(ys), max(ys)

    def middle(self):
        left, right, bottom, top = self.box()
        return (left + right) / 2, (bottom + top) / 2

    def point_for(self, width, height, margin=12):
        """The length of a point with which all this fills a page of so many points."""
        left, right, bottom, top = self.box()
        return max((right - left) / (width - 2 * margin), (top - bottom) / (height - 2 * margin)) or 1 / width


@dataclass(frozen=True, slots=True)
class _Stroke:
    points: list
    looks: tuple
    layer: int
    closed: bool
    depth: float
    normal: tuple | None = None  # of a flat face
    cut: bool = False  # a piece of a line that a face cuts

    def drawn(self, ax, view):
        """The stroke as patches, one for each look."""
        from matplotlib.patches import PathPatch
        from matplotlib.path import Path

        xy = [view.flat(p) for p in self.points]
        path = Path(xy + xy[:1], closed=True) if self.closed else Path(xy)
        for look in self.looks:
            style = {"joinstyle": "round", "capstyle": "round", **LOOKS[look]}
            if not self.closed:
                style["fc"] = "none"
            if self.cut:
                style["capstyle"] = "butt"
            yield ax.add_artist(PathPatch(path, clip_on=False, zorder=2 + self.layer, **style))


# -- what covers what


def _far_to_near(ink):
    """The strokes in the order of drawing. Bodies go by depth, but what lies beyond the plane of a face is always drawn before the face,
    and what lies on the eye's side after it; a line through a face is cut in two."""
    faces = [s for s in ink.strokes if s.normal and s.layer == BODY and abs(ink.view.depth(s.normal)) > 0.02]
    bodies = []
    for stroke in ink.strokes:
        if stroke.layer == BODY:
            bodies += _cut(ink.view, stroke, faces)
    bodies.sort(key=lambda s: s.depth)
    marks = [s for s in ink.strokes if s.layer != BODY]
    return _by_planes(ink.view, bodies, 1e-3 * ink.pt) + sorted(marks, key=lambda s: (s.layer, s.depth))


def _cut(view, stroke, faces):
    """The pieces of a straight line between the faces it passes through; anything else whole."""
    if stroke.closed or len(stroke.points) != 2:
        return [stroke]
    A, B = stroke.points
    cuts = {0.0, 1.0}
    for face in faces:
        a, b = (dot3(face.normal, sub3(P, face.points[0])) for P in (A, B))
        if a * b < 0 and _inside(view, _between(A, B, a / (a - b)), face.points):
            cuts.add(a / (a - b))
    cuts = sorted(cuts)
    if len(cuts) == 2:
        return [stroke]
    pieces = [(_between(A, B, s), _between(A, B, t)) for s, t in pairwise(cuts)]
    return [replace(stroke, points=piece, depth=view.depth(_mean(piece)), cut=True) for piece in pieces]


def _inside(view, p, corners):
    """Whether p is seen inside the polygon: a ray to the right crosses its edges an odd number of times."""
    x, y = view.flat(p)
    flat = [view.flat(q) for q in corners]
    odd = False
    for (x0, y0), (x1, y1) in zip(flat, flat[1:] + flat[:1], strict=True):
        if (y0 > y) != (y1 > y) and x < x0 + (y - y0) * (x1 - x0) / (y1 - y0):
            odd = not odd
    return odd


def _by_planes(view, strokes, eps):
    """Strokes sorted by depth, put into an order that also obeys the planes of the faces, as far as these agree."""
    import numpy as np

    faces = [n for n, s in enumerate(strokes) if s.normal and abs(view.depth(s.normal)) > 0.02]
    if not faces:
        return strokes
    starts = np.cumsum([0, *(len(s.points) for s in strokes[:-1])])
    points = np.array([p for s in strokes for p in s.points])
    seen = points @ np.array([view.right, view.up]).T
    low, high = np.minimum.reduceat(seen, starts), np.maximum.reduceat(seen, starts)
    before = [set() for _ in strokes]  # what must be drawn before each
    for f in faces:
        face = strokes[f]
        normal = np.array(face.normal) * math.copysign(1 / _length(face.normal), view.depth(face.normal))
        height = (points - points[starts[f]]) @ normal
        least, most = np.minimum.reduceat(height, starts), np.maximum.reduceat(height, starts)
        meets = ((low < high[f] - eps) & (high > low[f] + eps)).all(axis=1)
        for n in np.flatnonzero(meets & (least > -eps) & (most > -eps)):
            if most[n] > eps or not strokes[n].closed:
                before[n].add(f)
        for n in np.flatnonzero(meets & (most < eps) & (least < -eps)):
            before[f].add(n)
    return _released(strokes, before)


def _released(items, before):
    """The items in their order, each held back until all ``before`` it are out; where they wait for each other the first goes."""
    waiting, out = list(range(len(items))), []
    while waiting:
        n = next((n for n in waiting if not before[n].intersection(waiting)), waiting[0])
        waiting.remove(n)
        out.append(items[n])
    return out


def _labelled(ax, ink, renderer):
    """The notes as texts, each where it covers the fewest lines and no other text."""
    import numpy as np

    covered = _dots(np, ink)
    taken = np.empty((0, 4))
    left, right, bottom, top = _page(ax, ink)
    angles = np.radians(np.arange(0, 360, 22.5))
    turns, rings = (a.ravel() for a in np.meshgrid(angles, [0, 7, 15, 26]))
    for place, text, towards, gap, colour, weight, fixed in sorted(ink.notes, key=lambda note: note[-1] is None):
        artist = ax.annotate(text, place, (0, 0), textcoords="offset points", ha="center", va="center",
                             color=colour, fontsize=FONT, fontweight=weight, zorder=9, annotation_clip=False)  # fmt: skip
        extent = artist.get_window_extent(renderer)
        w, h = (size * 72 / ax.figure.dpi / 2 for size in (extent.width, extent.height))
        x0, y0 = place[0] / ink.pt, place[1] / ink.pt
        if fixed is not None:
            x, y = np.array([x0 + fixed[0]]), np.array([y0 + fixed[1]])
        else:
            x = x0 + np.cos(towards + turns) * (w + gap + rings)
            y = y0 + np.sin(towards + turns) * (h + gap + rings)
        boxes = np.stack((x - w - 1.5, x + w + 1.5, y - h - 1, y + h + 1), axis=1)
        inside = ((covered[:, 0] > boxes[:, :1]) & (covered[:, 0] < boxes[:, 1:2])
                  & (covered[:, 1] > boxes[:, 2:3]) & (covered[:, 1] < boxes[:, 3:]))  # fmt: skip
        overlaps = ((taken[:, 0] < boxes[:, 1:2]) & (taken[:, 1] > boxes[:, :1])
                    & (taken[:, 2] < boxes[:, 3:]) & (taken[:, 3] > boxes[:, 2:3]))  # fmt: skip
        off = (boxes[:, 0] < left) | (boxes[:, 1] > right) | (boxes[:, 2] < bottom) | (boxes[:, 3] > top)
        best = 0
        if fixed is None:
            best = np.argmin(2 * inside.sum(axis=1) + 50 * overlaps.sum(axis=1) + 100 * off + 4 * (1 - np.cos(turns)) + 0.4 * rings)
        artist.set_position((x[best] - x0, y[best] - y0))
        taken = np.vstack((taken, boxes[best]))
        yield artist


def _dots(np, ink, step=3):
    """Dots along all lines, every few points: what a label should not cover. In points."""
    ends, wide = [], []
    for stroke in ink.strokes:
        flat = [ink.view.flat(p) for p in stroke.points]
        ends += pairwise(flat + flat[:1] * stroke.closed)
        wide += [LOOKS[stroke.looks[0]]["lw"] if stroke.looks else 0] * (len(ends) - len(wide))
    if not ends:
        return np.empty((0, 2))
    a, b = np.moveaxis(np.array(ends) / ink.pt, 1, 0)
    thick = np.array(wide) > 3
    along = (b - a)[thick]
    side = along[:, ::-1] * (-1, 1) * (np.array(wide)[thick] / 2 / np.maximum(np.hypot(*along.T), 1e-9))[:, None]
    a, b = np.concatenate((a, a[thick] + side, a[thick] - side)), np.concatenate((b, b[thick] + side, b[thick] - side))
    count = np.ceil(np.hypot(*(b - a).T) / step).astype(int) + 1
    line = np.repeat(np.arange(len(count)), count)
    share = (np.arange(len(line)) - np.repeat(np.cumsum(count) - count, count)) / count[line]
    return a[line] + share[:, None] * (b - a)[line]


def _page(ax, ink):
    """The edges of the figure, in points where the drawing's origin is zero."""
    corners = ax.transData.inverted().transform(ax.figure.bbox.get_points()) / ink.pt
    return corners[0, 0], corners[1, 0], corners[0, 1], corners[1, 1]


def _italic(text):
    """A symbol of one letter in italics, as it is set in print; anything else as it is."""
    return f"${text}$" if len(text) == 1 and text.isalpha() else text


# -- geometry of triples


def _length(v):
    return math.sqrt(dot3(v, v))


def _normalized(v):
    return scale3(1 / _length(v), v)


def _between(A, B, t):
    return add3(A, scale3(t, sub3(B, A)))


def _mean(points):
    return tuple(sum(c) / len(points) for c in zip(*points, strict=True))


def _across_most(axis, target):
    """The unit vector at right angles to ``axis`` that is nearest to ``target``."""
    v = sub3(target, scale3(dot3(axis, target), axis))
    if _length(v) < 1e-6:
        return _across(axis)[0]
    return _normalized(v)


def _across(axis):
    """Two unit vectors that make a right-handed triple with ``axis``."""
    least = min(range(3), key=lambda n: abs(axis[n]))
    e1 = _across_most(axis, tuple(float(n == least) for n in range(3)))
    return e1, cross3(axis, e1)


def _on_circle(C, e1, e2, radius, angle):
    return add3(C, add3(scale3(radius * math.cos(angle), e1), scale3(radius * math.sin(angle), e2)))


def _circle(C, normal, radius, count=60, closed=False):
    e1, e2 = _across(normal)
    return [_on_circle(C, e1, e2, radius, 2 * math.pi * n / count) for n in range(count + closed)]


def _normal(corners):
    """The normal of a plane polygon, by Newell's sum."""
    total = (0.0, 0.0, 0.0)
    for p, q in zip(corners, corners[1:] + corners[:1], strict=True):
        total = add3(total, cross3(p, q))
    return total


def _hull(view, points):
    """The points on the convex outline as seen, counter-clockwise (monotone chain)."""
    ordered = sorted(points, key=view.flat)

    def half(points):
        out = []
        for p in points:
            while len(out) > 1 and dot3(cross3(sub3(out[-1], out[-2]), sub3(p, out[-1])), view.eye) <= 0:
                out.pop()
            out.append(p)
        return out[:-1]

    return half(ordered) + half(ordered[::-1])


def _silhouette(view, apex, rim):
    """The two places of the rim where lines from the apex touch it as seen; none if the apex is seen inside."""
    outline = _hull(view, [apex, *rim])
    if apex not in outline:
        return ()
    n = outline.index(apex)
    return outline[n - 1], outline[(n + 1) % len(outline)]
