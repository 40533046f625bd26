"""4/2: water that flows outward in a nozzle which turns about the vertical."""

from mpmath import mp

from exercises.proofs import rate, rot, second_rate, size, times
from newton_euler import Frame, moving, sin
from newton_euler.drawing import Sketch


def nozzle_and_particle(g):
    """Ground with Z up; a frame that turns with the nozzle, x outward; a frame with z along the nozzle, and the particle in it."""
    ground = Frame("ground")
    turning = ground.rotate("turning", "z", rate=g.omega)
    nozzle = turning.rotate("nozzle", "y", angle=g.tilt)
    return ground, turning, nozzle.point("P", 0, 0, moving(g.d, rate=g.nu))


def motion(g):
    ground, turning, P = nozzle_and_particle(g)
    return P.velocity(ground), P.acceleration(ground, via=turning)


def solve(g):
    v, a = motion(g)
    return {"speed": v.norm(), "acc_mag": a.norm()}


def prove(g):
    def P(t):
        d = g.d + g.nu * t
        return times(rot("z", g.omega * t), [d * mp.sin(g.tilt), 0, d * mp.cos(g.tilt)])

    return {"speed": size(rate(P)), "acc_mag": size(second_rate(P))}


def mistakes(g):
    v, a = motion(g)
    too_far = 1 / sin(g.tilt)
    return {
        "no_coriolis": {"acc_mag": a.without("coriolis").norm()},
        "d_from_the_axis": {"speed": v.reweighted(rotation=too_far).norm(), "acc_mag": a.reweighted(centripetal=too_far).norm()},
        "single_coriolis": {"acc_mag": a.reweighted(coriolis=0.5).norm()},
        "coriolis_of_horizontal_nozzle": {"acc_mag": a.reweighted(coriolis=too_far).norm()},
    }


def draw(g, ax):
    ground, turning, P = nozzle_and_particle(g)
    nozzle, O = P.frame, (0, 0, 0)
    up = ground.point("up", 0, 0, 1.3 * g.d)
    s = Sketch(ax, ground, azimuth=-105, elevation=15)
    s.line((0, 0, -0.4 * g.d), up, style="centre")
    s.cylinder(O, nozzle.point("end", 0, 0, 1.3 * g.d), 0.035 * g.d)
    s.vector(P, nozzle.k, r"$\nu$")
    s.turn((0, 0, 1.1 * g.d), ground.k, label=r"$\omega$")
    s.axes(O, turning, length=0.3 * g.d)
    s.arc(O, up, P, label="tilt")
    s.dimension(O, P, label="d")
    s.dot(P)
    s.label(O, "O")
