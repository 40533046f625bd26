"""3/27: components of a position by matrices, given as three rows."""

from exercises.tools import mp, on_ground, times
from newton_euler import Frame, atan2, sqrt
from newton_euler.kinematics.coordinates import T_phi, T_theta, cylindrical_frame, spherical_frame
from newton_euler.kinematics.rotations import apply, transpose

# in full: the matrices of a student may have entries where there are none
follows = {
    "r_cyl": lambda g, T_theta: Frame("cylindrical").vector(*apply(T_theta, (g.x, g.y, g.z))),
    "r_sph": lambda g, r_cyl, T_phi: r_cyl.frame.vector(*apply(T_phi, r_cyl.components())),
}


def coordinates(g):
    """r, theta, R, phi."""
    r = sqrt(g.x**2 + g.y**2)
    return r, atan2(g.y, g.x), sqrt(r**2 + g.z**2), atan2(g.z, r)


def answers(g, phi, turned=lambda T: T):
    """The answers for the elevation phi; ``turned`` is applied to the matrices."""
    _, theta, *_ = coordinates(g)
    ground = Frame("ground")
    to_cylindrical, to_spherical = turned(T_theta(theta)), turned(T_phi(phi))
    cylindrical = apply(to_cylindrical, (g.x, g.y, g.z))
    return {
        "T_theta": to_cylindrical,
        "r_cyl": cylindrical_frame(ground, theta).vector(*cylindrical),
        "T_phi": to_spherical,
        "r_sph": spherical_frame(ground, theta, phi).vector(*apply(to_spherical, cylindrical)),
    }


def solve(g):
    *_, phi = coordinates(g)
    return answers(g, phi)


def steps(g):
    r, theta, _, phi = coordinates(g)
    return {"r": r, "theta": theta, "phi": phi}


def prove(g):
    """Rows of unit vectors: to the point, around the axis, normal to both; without angles."""
    r = mp.sqrt(g.x**2 + g.y**2)
    R = mp.sqrt(r**2 + g.z**2)
    T_1 = [[g.x / r, g.y / r, 0], [-g.y / r, g.x / r, 0], [0, 0, g.one]]
    T_2 = [[r / R, 0, g.z / R], [0, g.one, 0], [-g.z / R, 0, r / R]]
    cylindrical = times(T_1, [g.x, g.y, g.z])
    return {"T_theta": T_1, "r_cyl": cylindrical, "T_phi": T_2, "r_sph": times(T_2, cylindrical)}


def mistakes(g):
    right = solve(g)
    r, theta, R, phi = coordinates(g)

    def elevation(phi):
        return {key: x for key, x in answers(g, phi).items() if key in ("T_phi", "r_sph")}

    return {
        "coordinates": {
            "r_cyl": right["r_cyl"].frame.vector(r, theta * g.one, g.z),
            "r_sph": right["r_sph"].frame.vector(R, theta * g.one, phi * g.one),
        },
        "transposed": answers(g, phi, transpose),
        "z_by_R": elevation(atan2(g.z, R)),
        "phi_from_z": elevation(atan2(r, g.z)),
    }


def draw(g, ax):
    ground, s = on_ground(ax, azimuth=60, elevation=22)
    O, P, Q = (0, 0, 0), (g.x, g.y, g.z), (g.x, g.y, 0)
    s.axes(O, ground, length=1.1 * max(g.x, g.y, g.z))
    s.arrow(O, P)
    s.line(O, Q)
    s.line(Q, P)
    s.arc(O, (g.x, 0, 0), Q, label=r"$\theta$")
    s.arc(O, Q, P, label=r"$\phi$")
    s.dot(P, "P")
    s.label(Q, "Q")
    s.label(O, "O")
