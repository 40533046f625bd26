"""4/8: two points that stay a fixed distance apart, and the frame that follows them."""

from exercises.tools import Sketch, acceleration_of, in_frame, plus, proofs, scaled, terms
from newton_euler import Frame, moving


def line_AB(g):
    """The ground, with the axes of the frame now; A in it; the frame AB at A, and B in it."""
    ground = Frame("ground")
    coordinates = (0, g.v_x, g.a_Ax), (0, g.v_Ay, g.a_Ay), (0, g.v_Az, g.a_Az)
    A = ground.point("A", *(moving(*q) for q in coordinates))
    AB, change = ground.vector(g.L, 0, 0), ground.vector(0, g.v_By - g.v_Ay, g.v_Bz - g.v_Az)
    omega = ground.i * g.omega_x + AB.cross(change) / g.L**2
    frame = turning(ground, A, omega, ground.vector(g.wd_x, g.wd_y, g.wd_z))
    return ground, frame, frame.point("B", g.L, 0, 0)


def turning(ground, origin, omega, omega_dot):
    """A frame with this angular velocity and rate, by rotations about x, y and z from zero."""

    def frame(accelerations):
        f = ground.translate("A", origin)
        for axis, rate, acceleration in zip("xyz", omega, accelerations, strict=True):
            f = f.rotate(axis, axis, rate=rate, acceleration=acceleration)
        return f

    # belongs to omega_dot, but to no second rate of an angle
    cross_products = frame((0, 0, 0)).angular_acceleration(ground)
    return frame(omega_dot - cross_products)


def solve(g):
    ground, frame, B = line_AB(g)
    omega, a_B = frame.angular_velocity(ground), B.acceleration(ground)
    return in_frame(ground, {"omega": omega, "a_B": a_B})


def a_B(g, omega):
    vector = omega.frame.vector
    a_A, omega_dot = vector(g.a_Ax, g.a_Ay, g.a_Az), vector(g.wd_x, g.wd_y, g.wd_z)
    return a_A + acceleration_of(omega, omega_dot, vector(g.L, 0, 0))


follows = {"a_B": a_B}


def steps(g):
    ground, frame, _ = line_AB(g)
    AB, omega = ground.vector(g.L, 0, 0), frame.angular_velocity(ground).expressed_in(ground)
    v_AB = ground.vector(0, g.v_By - g.v_Ay, g.v_Bz - g.v_Az)
    yield "v_AB", v_AB
    yield "omega_across", AB.cross(v_AB) / g.L**2
    yield "omega_along", omega.x * ground.i
    yield from terms(solve(g)["a_B"], "a_B", "in/s^2", "4.8")


def prove(g):
    v_A, v_B = [g.v_x, g.v_Ay, g.v_Az], [g.v_x, g.v_By, g.v_Bz]
    a_A, omega_dot = [g.a_Ax, g.a_Ay, g.a_Az], [g.wd_x, g.wd_y, g.wd_z]

    # i from A to B, and j, which turns about AB at omega_x, made perpendicular to it
    def directions(t):
        i = plus([g.L, 0, 0], scaled(t, proofs.minus(v_B, v_A)))
        i = scaled(1 / proofs.size(i), i)
        j = [0, 1, g.omega_x * t]
        j = proofs.minus(j, scaled(sum(a * b for a, b in zip(i, j, strict=True)), i))
        j = scaled(1 / proofs.size(j), j)
        return proofs.transposed([i, j, proofs.cross(i, j)])

    omega = proofs.angular_velocity(directions)

    def B(t):
        A = plus(scaled(t, v_A), scaled(t**2 / 2, a_A))
        # the rotation from 0 to t, accurate to t^2
        mean = plus(omega, scaled(t / 2, omega_dot))
        return plus(A, proofs.times(proofs.rot(mean, t * proofs.size(mean)), [g.L, 0, 0]))

    found = {"omega_across": [0, *omega[1:]], "omega_along": [omega[0], 0, 0]}
    return {"omega": omega, "a_B": proofs.second_rate(B)} | found


def mistakes(g):
    ground, frame, B = line_AB(g)
    omega, a = frame.angular_velocity(ground), B.acceleration(ground)
    x, y, z = g.omega_x, (g.v_By - g.v_Ay) / g.L, (g.v_Bz - g.v_Az) / g.L
    wrong = {
        "no_centripetal": {"a_B": a.without("centripetal")},
        "no_omega_dot": {"a_B": a.without("euler")},
        "r_cross_omega": {"omega": omega.reweighted(y=-1, z=-1)},
        "component_by_component": {"omega": ground.vector(x, y, z)},
    }
    return in_frame(ground, wrong)


def draw(g, ax):
    ground, frame, B = line_AB(g)
    A = frame.origin
    s = Sketch(ax, ground, azimuth=35, elevation=25)
    s.line(A, B, style="solid")
    s.axes(A, frame, length=0.35 * g.L, labels="ijk")
    s.vector(A, A.velocity(ground), "$v_A$")
    s.vector(B, B.velocity(ground), "$v_B$")
    s.vector(A, ground.vector(g.a_Ax, g.a_Ay, g.a_Az), "$a_A$", kind="acceleration")
    s.turn(frame.point("M", 0.7 * g.L, 0, 0), frame.i * g.omega_x, label=r"$\omega_x$")
    s.dimension(A, B, label="L", offset=-0.12 * g.L)
    s.dot(A, "A")
    s.dot(B, "B")
