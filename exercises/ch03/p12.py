"""3/12: the screw-jack of 4/1, in cylindrical components."""

from exercises.devices.screw_jack import figure, handle_in_time, rise, screw_in_nut
from exercises.tools import rate, second_rate, size
from newton_euler import Frame, cylindrical, moving


def handle(g, up):
    """A, rising at the speed ``up``."""
    return cylindrical(Frame("ground"), "A", g.a, moving(0 * g.one, rate=g.n), moving(0, rate=up))


def motion(g, up):
    A = handle(g, up)
    v = A.velocity(A.ground)
    return {"speed": v.norm(), "v_axial": v.z, "acc_mag": A.acceleration(A.ground).norm()}


def solve(g):
    return motion(g, rise(g))


def steps(g):
    A = handle(g, rise(g))
    return {"omega": g.n, "v_theta": A.velocity(A.ground).y}


def prove(g):
    A = handle_in_time(g)
    v = rate(A)
    return {"speed": size(v), "v_axial": v[2], "acc_mag": size(second_rate(A)), "v_theta": v[1]}


def mistakes(g):
    slow = g.but(n=g.stated("n"))
    high, level = motion(g, g.lead * g.n), motion(g, 0 * rise(g))
    return {
        "n_as_rad_per_s": motion(slow, rise(slow)),
        "lead_per_radian": {key: high[key] for key in ("speed", "v_axial")},
        "no_axial_velocity": {"v_axial": level["v_axial"]},
    }


def draw(g, ax):
    figure(g, ax, *screw_in_nut(g, rise(g), g.n))
