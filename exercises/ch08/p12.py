"""8/12: the angular momentum of a cone spinning in a turning bracket."""

from exercises.tools import Sketch, in_frame, proofs
from newton_euler import Frame, Inertia, bodies


def scene(g):
    """Ground, bracket, the cone, and its vertex O."""
    ground = Frame("ground")
    bracket = ground.rotate("bracket", "x", rate=g.omega)
    O = bracket.rotate("spinning", "z", rate=g.p).point("O", 0, 0, 0)
    return ground, bracket, bodies.cone(g.r, g.b, O, "z", mass=g.m), O


def solve(g):
    ground, bracket, body, O = scene(g)
    return in_frame(bracket, {"H_O": body.angular_momentum(ground, about=O)})


def steps(g):
    ground, bracket, body, _ = scene(g)
    omega = body.frame.angular_velocity(ground).expressed_in(bracket)
    _, across, axial = body.inertia.moments
    d = body.centre.position(body.frame).z
    return {"omega_cone": omega, "d": d, "I_G": across, "I_z": axial}


def prove(g):
    """By momenta of mass points."""
    orientation = lambda t: proofs.times(proofs.rot("x", g.omega * t), proofs.rot("z", g.p * t))
    over_cone = lambda f: proofs.scaled(g.m, proofs.mean(f, proofs.cone(g.r, g.b)))
    turning = proofs.rate(orientation)
    H_O = over_cone(lambda r: proofs.cross(r, proofs.times(turning, r)))
    I_z = over_cone(lambda r: [r[0] ** 2 + r[1] ** 2])[0]
    middle = over_cone(lambda r: r)[2] / g.m
    I_G = over_cone(lambda r: [r[1] ** 2 + (r[2] - middle) ** 2])[0]
    omega = proofs.angular_velocity(orientation)
    return {"H_O": H_O, "omega_cone": omega, "d": middle, "I_G": I_G, "I_z": I_z}


def mistakes(g):
    ground, bracket, body, O = scene(g)
    across, _, axial = body.about(O).moments
    omega = body.frame.angular_velocity(ground)

    def with_moments(*moments):
        I = Inertia(O, moments, frame=body.frame, tolerance=None)
        return in_frame(bracket, {"H_O": I.times(omega)})

    own = body.angular_momentum(ground, about=O).without("orbital")
    return {
        "about_centre": in_frame(bracket, {"H_O": own}),
        "spin_only": solve(g.but(omega=0 * g.omega)),
        "cylinder": with_moments(across, across, g.m * g.r**2 / 2),
        "exchanged": with_moments(axial, axial, across),
    }


def draw(g, ax):
    ground, *_, O = scene(g)
    s = Sketch(ax, ground, azimuth=-60, elevation=18)
    x, z = ground.i, ground.k
    side, top = 1.5 * g.r, 1.5 * g.b
    end, base = 2.1 * g.r, z * g.b
    s.shaft(x * -end, x * end)
    for at in (-1, 1):
        s.rod(x * (at * side), x * (at * side) + z * top)
        s.hinge(x * (at * end), axis=x)
    s.rod(x * -side + z * top, x * side + z * top)
    s.cone(O, z, g.b, g.r)
    s.rod(base, z * (1.1 * top))
    s.hinge(z * top, axis=z)
    s.axes(O, ground, length=1.2 * max(1.5 * top, 1.3 * end))
    s.turn(z * (1.3 * top), z, "p")
    s.turn(x * (1.3 * end), x, r"$\omega$")
    s.dimension(O, base, "b", offset=x * (-1.3 * side))
    s.dimension(base, base + x * g.r, "r", offset=0)
    s.label(O, "O")
