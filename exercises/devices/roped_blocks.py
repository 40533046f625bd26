"""Two blocks on one rope over pulleys without mass or friction, 6/5 to 6/8: in the x, y plane, y
up.

The rope pulls either block along its own line, toward the pulley.
"""

from dataclasses import dataclass

from exercises.tools import Sketch, Step, minus, rate, root
from newton_euler import Frame, cos, pi, sin, solve_linear, tan
from newton_euler.algebra.vectors import Vector
from newton_euler.dynamics import mass_from_weight, resultant_force, weight


@dataclass
class Block:
    """A block: the rope pulls it along ``line``, a face pushes it along ``normal``, if any."""

    name: str
    m: object
    line: Vector
    normal: Vector | None = None
    pulls: int = 1  # the parts of the rope that pull on it
    runs: int = 1  # those that shorten as it moves along its line


def hanging(g, name, W, parts=1):
    """A block of this weight that hangs on so many parts of the rope."""
    return Block(name, mass_from_weight(W, g.g), Frame("ground").j, None, parts, parts)


def on_face(g, name, W, angle, toward=1):
    """On a smooth face that rises at ``angle``, to the right, or with ``toward`` -1 to the left."""
    ground = Frame("ground")
    line = ground.vector(toward * cos(angle), sin(angle), 0)
    normal = ground.vector(-toward * sin(angle), cos(angle), 0)
    return Block(name, mass_from_weight(W, g.g), line, normal)


def motion(g, A, B):
    """a_A and a_B along the pull of the rope, tension T, N_A and N_B, by ``solve_linear``."""
    pushed = [b for b in (A, B) if b.normal]

    def laws(a_A, a_B, T, *pushes):
        N = {b.name: N * b.normal for b, N in zip(pushed, pushes, strict=True)}
        equations = {"rope": A.runs * a_A + B.runs * a_B}
        for b, a in ((A, a_A), (B, a_B)):
            F = weight(b.m, b.line.frame.j, g.g) + T * (b.pulls * b.line)
            F = F + N[b.name] if b.name in N else F
            equations[b.name] = resultant_force(b.m, a * b.line) - F
        return equations

    return solve_linear(laws, ["a_A", "a_B", "T", *(f"N_{b.name}" for b in pushed)])


def block_steps(g, A, B, laws):
    """The masses, the parts of the weights along the lines, and what is left without the tension of
    the equations of motion, which ``laws`` writes, for the acceleration a of ``A`` toward its
    pulley.
    """
    for b in (A, B):
        yield Step(f"m_{b.name}", b.m, "slug", f"mass of {b.name}, W/g")
    along = {b.name: -weight(b.m, b.line.frame.j, g.g).dot(b.line) for b in (A, B)}
    for b in (A, B):
        if b.normal:
            yield Step(f"W_{b.name}t", along[b.name], "lb",
                       f"part of the weight of {b.name} down its face", "6.1", "6.3")  # fmt: skip
    yield Step("F", A.runs * along[B.name] - B.runs * along[A.name], "lb",
               f"force that is left of the equations of motion {laws} without T", "6.1",
               "6.3")  # fmt: skip
    yield Step("M", A.m * B.runs**2 + B.m * A.runs**2, "slug", "mass that it accelerates, F = M*a",
               "6.1", "6.3")  # fmt: skip


def by_energy(g, W_A, W_B, places, reach):
    """Proof: the rate of growth a of the run of the rope at B, and its tension, from the energy.

    places : of A and B, lists, when B has moved by s along its line away from the pulley
    reach : a is between this and a millionth of it
    """

    def gain(W, place, a):
        """The gain in energy of a block in the first unit of time, s = a t^2/2 from rest."""
        moved = lambda t: place(a * t**2 / 2)
        up = minus(moved(1), moved(0))[1]
        return W / g.g * sum(v**2 for v in rate(moved, 1)) / 2 + W * up

    weights = (W_A, W_B)
    a = root(
        lambda a: sum(gain(W, place, a) for W, place in zip(weights, places, strict=True)),
        reach / 10**6,
        reach,
    )
    return a, -gain(W_B, places[1], a) / (a / 2)  # what B loses is the work against the rope


def draw_wedge(ax, left, right=None):
    """A wedge with A on its left, B on its right face or hanging; angles with their labels."""
    ground = Frame("ground")
    s = Sketch(ax, ground, plane="xy")
    height, half, long = 0.55, 0.09, 0.13  # of the wedge; half sizes of a block
    top, foot = (0, 0, 0), (-height / tan(left[0]), -height, 0)
    heel = (height / tan(right[0]) if right else 0, -height, 0)
    s.plate([top, foot, heel], shade="light")
    s.road([(foot[0] - half, -height, 0), (heel[0] + 3 * half, -height, 0)])

    def block(name, angle, run, side=1, thick=2):
        """Its middle at ``run`` from the top, on this ``side``; returns the rope's end."""
        face = ground.rotate(f"line of {name}", "z", angle)
        place = face.point(name, -run, side * half, 0)
        s.box(place, face, (2 * long, thick * half, 2 * half))
        s.label(place, name, offset=(0, 0))
        return face.point("end", long - run, side * half, 0)

    A = block("A", left[0], 0.5 * height / sin(left[0]))
    if right:
        B = block("B", pi(right[0]) - right[0], 0.55 * height / sin(right[0]), side=-1)
    else:
        B = block("B", pi(left[0]) / 2, 0.6 * height, side=-1, thick=1.3)
    wheel = s.pulley(top, ground.k, half)  # so that the rope is parallel to the faces
    s.cable(A, wheel, B, turns=[-1])
    s.arc(foot, heel, top, label=left[1])
    if right:
        s.arc(heel, top, foot, label=right[1])
