"""10/9: a wheel rolling around a post, whose normal force exceeds its weight."""

from exercises.tools import Sketch, moment_needed, mp, plus, proofs, rot, times
from newton_euler import Body, ForceSystem, Frame, bodies, dynamics, solve_linear, solve_rates


def wheel(g, spin):
    """Ground with z up, the axle, whose x points from O to C, and the disk."""
    ground = Frame("ground")
    axle = ground.rotate("axle", "z", rate=g.Omega)
    turned = axle.rotate("disk", "-x", rate=spin, origin=axle.point("C", g.R, 0, 0))
    mass = dynamics.mass_from_weight(g.W, g.g)
    return ground, axle, bodies.disk(g.r, turned, "x", mass=mass)


def rolling_spin(g):

    def slip(spin):
        ground, axle, body = wheel(g, spin)
        contact = body.frame.point("contact", 0, 0, -g.r).velocity(ground)
        return contact.expressed_in(axle).y

    return solve_rates(slip, 1)[0]


def moment(g, spin, wheel=wheel):
    """The moment that the disk needs about O, in the axes of the axle."""
    ground, axle, body = wheel(g, spin)
    return dynamics.resultant_moment(body, ground, about=axle.point("O", 0, 0, 0), via=axle)


def normal_force(g, needed):
    """The normal force that, with the weight, exerts this moment about the line of the hinge."""
    axle = needed.frame
    O, C, contact = (axle.point("", x, 0, z) for x, z in ((0, 0), (g.R, 0), (g.R, -g.r)))
    forces = lambda N: ForceSystem({"N": (axle.k * N, contact), "W": (axle.k * -g.W, C)})
    balance = lambda N: forces(N).moment(O).y - needed.y
    return {"N_floor": solve_linear(balance).N}


def solve(g):
    return normal_force(g, moment(g, rolling_spin(g)))


def steps(g):
    spin = rolling_spin(g)
    *_, body = wheel(g, spin)
    return {"spin": spin, "I_s": body.inertia.moment("x"), "M_gyro": -moment(g, spin).y}


def prove(g):
    """By mass points of the rolling disk: the needed moment minus that of the weight."""
    m = g.W / g.g
    upright = proofs.along_x(proofs.disk(g.r))
    unrolled = lambda t: g.R * g.Omega * t / g.r

    def disk_at(t):
        around, own = rot("z", g.Omega * t), rot([-1, 0, 0], unrolled(t))
        return [(u, times(around, plus([g.R, 0, 0], times(own, p)))) for u, p in upright]

    up = lambda moment: -moment[1]  # about -y: it lifts C
    weight = up(proofs.mean(lambda p: proofs.cross(p, [0, 0, -g.W]), disk_at(mp.mpf(0))))
    needed = up(moment_needed(m, disk_at))
    return {
        "N_floor": (needed - weight) / g.R,
        "spin": proofs.rate(unrolled),
        "I_s": m * proofs.mean(lambda p: p[1] ** 2 + p[2] ** 2, upright),
        "M_gyro": needed,
    }


def mistakes(g):
    spin = rolling_spin(g)

    def about_diameter(g, spin):
        ground, axle, body = wheel(g, spin)
        across = body.inertia.moment("y")
        return ground, axle, Body("disk", body.mass, body.frame, (across, across, across))

    return {
        "weight": normal_force(g, moment(g, 0 * spin)),
        "other_sense": normal_force(g, moment(g, -spin)),
        "spin_Omega": normal_force(g, moment(g, g.Omega)),
        "diameter": normal_force(g, moment(g, spin, about_diameter)),
    }


def draw(g, ax):
    ground, axle, body = wheel(g, rolling_spin(g))
    s = Sketch(ax, ground, azimuth=-60, elevation=18)
    O, C, foot, contact = (0, 0, 0), body.centre, (0, 0, -g.r), (g.R, 0, -g.r)
    s.ground(foot, normal=ground.k)
    s.ring(foot, ground.k, g.R)
    s.shaft(foot, (0, 0, 0.8 * g.R))
    s.rod(O, C)
    s.hinge(O, axis=axle.j)
    s.disk(C, axle.i, g.r)
    s.turn((0, 0, 0.55 * g.R), ground.k, label=r"$\Omega$")
    s.dimension(foot, contact, label="R", offset=0)
    s.dimension(C, contact, label="r", offset=0)
    s.label(O, "O")
    s.dot(C, "C")
