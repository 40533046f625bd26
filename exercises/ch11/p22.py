"""11/22: the kinetic energy of a cone rolling about its tip."""

from exercises.tools import mp, on_ground, proofs
from newton_euler import Frame, bodies, cos, sin, solve_rates, tan


def scene(g, spin):
    """Ground; axes whose x is the line of contact; the cone, its axis along its x; its tip O."""
    ground = Frame("ground")
    contact = ground.rotate("contact", "z", rate=g.Omega)
    axle = contact.rotate("axle", "y", angle=-g.alpha)
    O = axle.rotate("cone", "x", rate=spin).point("O", 0, 0, 0)
    return ground, contact, bodies.cone(g.h * tan(g.alpha), g.h, O, "x", mass=g.M), O


def rolling(g):
    """The scene in rolling: omega has no z component."""

    def turning(spin):
        _, contact, body, _ = scene(g, spin)
        return spin * body.frame.i.expressed_in(contact).z + g.Omega

    (spin,) = solve_rates(turning, 1)
    return spin, *scene(g, spin)


def solve(g):
    spin, _, contact, body, O = rolling(g)
    return {"T": body.about(O).moment(contact.i) * (spin * cos(g.alpha)) ** 2 / 2}


def steps(g):
    spin, ground, contact, body, O = rolling(g)
    at_tip = body.about(O)
    return {
        "spin": spin,
        "omega_x": body.frame.angular_velocity(ground).expressed_in(contact).x,
        "I_axial": at_tip.moment("x"),
        "I_across": at_tip.moment("y"),
        "I_contact": at_tip.moment(contact.i),
    }


def prove(g):
    """By mass points, the base rolling on a circle whose radius is the side of the cone."""
    r, side = g.h * mp.tan(g.alpha), g.h / mp.cos(g.alpha)
    points = proofs.along_x(proofs.cone(r, g.h))
    unrolled = -g.Omega * side / r

    def orientation(t):
        about_z, about_axis = proofs.rot("z", g.Omega * t), proofs.rot("x", unrolled * t)
        return proofs.times(about_z, proofs.rot("y", -g.alpha), about_axis)

    def about_x(angle):
        """The mean square distance from the x axis, with the axis of the cone at this angle."""
        tilt = proofs.rot("y", -angle)
        return g.M * proofs.mean(lambda p: sum(x * x for x in proofs.times(tilt, p)[1:]), points)

    return {
        "T": proofs.kinetic_energy(g.M, proofs.carried(points, orientation)),
        "spin": unrolled,
        "omega_x": proofs.angular_velocity(orientation)[0],
        "I_axial": about_x(0),
        "I_across": about_x(mp.pi / 2),
        "I_contact": about_x(g.alpha),
    }


def mistakes(g):
    _, ground, contact, body, O = rolling(g)
    omega = body.frame.angular_velocity(ground).expressed_in(contact).x
    I_G, I_O = body.inertia.moment(contact.i), body.about(O).moment(contact.i)
    energy = lambda I, rate=omega: {"T": I * rate**2 / 2}
    return {
        "omega_is_Omega": energy(I_O, g.Omega),
        "about_centre": energy(I_G),
        "centre_in_base": energy(I_G + g.M * (g.h * sin(g.alpha)) ** 2),
        "about_cone_axis": energy(body.inertia.moment("x")),
    }


def draw(g, ax):
    ground, s = on_ground(ax, plane="xz")
    O, axis = (0, 0, 0), ground.vector(cos(g.alpha), 0, sin(g.alpha))
    side = g.h / cos(g.alpha)
    s.road([(-0.5 * side, 0, 0), (1.5 * side, 0, 0)])
    s.cone(O, axis, g.h, g.h * tan(g.alpha))
    s.axes(O, ground, length=1.2 * side, labels=["x", "", "z"])
    s.line(O, axis * (1.3 * g.h), style="centre")
    s.arc(O, ground.i, axis, label=r"$\alpha$")
    s.dimension(O, axis * g.h, label="h", offset=0)
    s.turn(ground.k * (0.9 * side), ground.k, label=r"$\Omega$")
    s.label(O, "O", offset=(-14, 8))
