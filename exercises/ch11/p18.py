"""11/18: the kinetic energy of a sphere about a point of its surface, in two forms."""

from exercises.tools import ball, on_ground, proofs, rot, size, times, transposed
from newton_euler import Frame, bodies, cos, kinematics, moving, sin


def hung():
    axes = Frame("axes")
    return axes, axes.point("O", 0, 0, 0)


def body(g, axes):
    return bodies.sphere(g.R, axes.point("G", 0, 0, g.R), mass=g.M)


def by_euler(g, axes):
    """The components in axes that do not spin, principal for a body of revolution as well."""
    ground = Frame("ground")
    turned = kinematics.euler_frame(ground, "sphere", *(
        moving(angle, rate=rate)
        for angle, rate in ((0, g.psi_dot), (g.theta, g.theta_dot), (0, g.phi_dot))
    ))  # fmt: skip
    return axes.vector(*turned.angular_velocity(ground).expressed_in(turned.parent).components())


def half_product(I, omega):
    return omega.dot(I.times(omega)) / 2


def about_O(g, omega):
    """The kinetic energy of the sphere turning at omega about the fixed point O."""
    axes, O = hung()
    return half_product(body(g, axes).about(O), axes.vector(*omega.components()))


def answers(g, energy):
    """The answers; ``energy``: a function of the angular velocity along x, y, z."""
    axes, _ = hung()
    omega = axes.vector(g.omega_x, g.omega_y, g.omega_z)
    return {"T_omega": energy(omega), "T_euler": energy(by_euler(g, axes))}


def solve(g):
    return answers(g, lambda omega: about_O(g, omega))


def steps(g):
    axes, O = hung()
    I = body(g, axes).about(O)
    omega = by_euler(g, axes)
    return {"I_z": I.moment("z"), "I_x": I.moment("x"), "omega_t": omega.y, "omega_s": omega.z}


def prove(g):
    """By mass points of the ball, turned about one axis, and by Euler's angles."""
    points = [(u, [x, y, z + g.R]) for u, (x, y, z) in ball(g.R, order=2)]
    axis = [g.omega_x, g.omega_y, g.omega_z]
    tilt = lambda t: rot("x", g.theta + g.theta_dot * t)
    in_time = lambda t: times(rot("z", g.psi_dot * t), tilt(t), rot("z", g.phi_dot * t))
    energy = lambda turned: proofs.kinetic_energy(g.M, proofs.carried(points, turned))
    omega = times(transposed(rot("x", g.theta)), proofs.angular_velocity(in_time))
    return {
        "T_omega": energy(lambda t: rot(axis, size(axis) * t)),
        "T_euler": energy(in_time),
        "I_z": g.M * proofs.mean(lambda r: r[0] ** 2 + r[1] ** 2, points),
        "I_x": g.M * proofs.mean(lambda r: r[1] ** 2 + r[2] ** 2, points),
        "omega_t": omega[1],
        "omega_s": omega[2],
    }


def mistakes(g):
    axes, O = hung()
    ball_at_G = body(g, axes)
    G = ball_at_G.centre - O
    I_G, transverse = ball_at_G.inertia, ball_at_G.about(O).moment("x")
    components = lambda omega: axes.vector(*omega.components())
    v = lambda omega: components(omega).cross(G)
    of_centre = lambda omega: g.M * v(omega).dot(v(omega)) / 2
    euler = by_euler(g, axes)
    return {
        "transverse_for_all": answers(g, lambda omega: transverse * omega.dot(omega) / 2),
        "no_translation": answers(g, lambda omega: half_product(I_G, components(omega))),
        "spin_alone": {"T_euler": about_O(g, axes.vector(euler.x, euler.y, g.phi_dot))},
        "centre_twice": answers(g, lambda omega: about_O(g, omega) + of_centre(omega)),
    }


def draw(g, ax):
    ground, s = on_ground(ax, plane="xz")
    R, theta = 1.0, 2.6  # anywhere
    O, down = (0, 0, 0), (sin(theta), 0, cos(theta))
    G, end = (R * down[0], 0, R * down[2]), (2.7 * down[0], 0, 2.7 * down[2])
    wall, top = (-0.8 * R, 0, 0.35 * R), (0, 0, 1.1 * R)
    s.rod(wall, O)
    s.ground(wall, normal=ground.i)
    s.sphere(G, R)
    for tip, name in ((top, "Z"), (end, "z")):
        s.arrow(O, tip)
        s.label(tip, name, offset=(10, 2), bold=False)
    s.ball_joint(O)
    s.arc(O, top, G, label=r"$\theta$", radius=0.6 * R)
    s.dimension(G, (G[0] - 0.8 * R, 0, G[2] - 0.6 * R), label="R", offset=0)
    s.label(O, "O", offset=(12, 13))
    s.dot(G, "G", offset=(10, 8))
