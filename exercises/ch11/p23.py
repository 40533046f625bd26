"""11/23: energy and angular momentum of a turning platform with a sliding particle."""

from exercises.tools import Sketch, in_frame, mpf, proofs
from newton_euler import Frame, moving, particle
from newton_euler.bodies import disk
from newton_euler.dynamics import kinetic_energy


def scene(g):
    """Ground, the turning axes, the two bodies, and O."""
    ground = Frame("ground")
    platform = ground.rotate("platform", "z", rate=g.omega)
    P = platform.point("P", moving(g.r, rate=g.v), 0, 0)
    bodies = disk(g.a, platform, "z", mass=g.M), particle(g.m, P)
    return ground, platform, bodies, platform.origin


def momenta(ground, platform, bodies, O):
    return [b.angular_momentum(ground, about=O).expressed_in(platform) for b in bodies]


def solve(g):
    ground, platform, bodies, _ = now = scene(g)
    of_platform, of_particle = momenta(*now)
    T = kinetic_energy(bodies, ground).value
    return {"T": T, **in_frame(platform, {"H_O": of_platform + of_particle})}


def steps(g):
    ground, platform, (disk, P), _ = now = scene(g)
    of_platform, of_particle = momenta(*now)
    return {
        "I_O": disk.inertia.moment("z"),
        "T_M": kinetic_energy(disk, ground).value,
        "v_P": P.centre.velocity(ground, via=platform).expressed_in(platform),
        "T_m": kinetic_energy(P, ground).value,
        "H_M": of_platform,
        "H_m": of_particle,
    }


def prove(g):
    """The platform as mass points, and the particle on its spiral."""
    platform = proofs.carried(proofs.disk(g.a, order=2), lambda t: proofs.rot("z", g.omega * t))
    path = lambda t: proofs.at_angle(g.r + g.v * t, g.omega * t, mpf(0))
    spiral = lambda t: [(mpf(1), path(t))]
    found = {}
    for name, m, motion in (("M", g.M, platform), ("m", g.m, spiral)):
        found[f"T_{name}"] = proofs.kinetic_energy(m, motion)
        found[f"H_{name}"] = proofs.angular_momentum(m, motion)
    return {
        "T": found["T_M"] + found["T_m"],
        "H_O": proofs.plus(found["H_M"], found["H_m"]),
        "v_P": proofs.rate(path),
        **found,
    }


def mistakes(g):
    ground, platform, (disk, _), _ = now = scene(g)
    of_platform, of_particle = momenta(*now)
    own = kinetic_energy(disk, ground).value
    one_way = g.v + g.r * g.omega
    wrong = {
        "only_relative_speed": {"T": own + g.m * g.v**2 / 2},
        "speeds_added": {"T": own + g.m * one_way**2 / 2},
        "relative_moment": {"H_O": of_platform + of_particle + platform.k * (g.m * g.r * g.v)},
        "no_particle": {"H_O": of_platform},
    }
    return in_frame(platform, wrong)


def draw(g, ax):
    _, platform, _, O = scene(g)
    s = Sketch(ax, platform, plane="xy")
    P, half = (g.r, 0, 0), 0.05 * g.a
    s.disk(O, platform.k, g.a)
    for y in (-half, half):
        s.line((0, y, 0), (g.a, y, 0), style="solid")
    s.dot(P)
    s.vector(P, platform.i, "v", kind="velocity")
    s.axes(O, platform, length=1.35 * g.a, labels=["x", "y", ""])
    s.turn(O, platform.k, label=r"$\omega$")
    s.dimension(O, P, label="r", offset=0.2 * g.a)
    s.arrow(O, (-0.8 * g.a, -0.6 * g.a, 0), label="a")
    s.dot(O, "O", offset=(-14, 14))
    s.label(P, "m", offset=(0, -16), bold=False)
