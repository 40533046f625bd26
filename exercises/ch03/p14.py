"""3/14: water in a nozzle turning about the vertical, in cylindrical components."""

from exercises.devices.nozzle import figure, nozzle_and_particle, particle_in_time
from exercises.tools import mp, rate, second_rate, size, terms
from newton_euler import Frame, cos, cylindrical, moving, pi, sin


def particle(g):
    """Velocity and acceleration along e_r, e_theta, k."""
    ground, along = Frame("ground"), moving(g.d, rate=g.nu)
    r, z = along * sin(g.tilt), along * cos(g.tilt)
    P = cylindrical(ground, "P", r, moving(0, rate=g.omega), z)
    return r, z, P.velocity(ground), P.acceleration(ground)


def solve(g):
    *_, v, a = particle(g)
    return {"speed": v.norm(), "acc_mag": a.norm()}


def steps(g):
    r, z, v, a = particle(g)
    yield "r", r.value
    yield "r_dot", r.rate
    yield "v_theta", v.y
    yield "z_dot", z.rate
    yield from terms(a, "a", "m/s^2", "3.5")
    yield "a", a


def prove(g):
    P = particle_in_time(g)
    r = lambda t: mp.hypot(*P(t)[:2])
    v = rate(P)
    found = {"r": r(0), "r_dot": rate(r), "v_theta": v[1], "z_dot": v[2]}
    return {"speed": size(v), "acc_mag": size(second_rate(P))} | found


def mistakes(g):
    *_, v, a = particle(g)
    too_far = 1 / sin(g.tilt)
    return {
        "d_from_the_axis": {
            "speed": v.reweighted(transverse=too_far).norm(),
            "acc_mag": a.reweighted(centripetal=too_far).norm(),
        },
        "no_coriolis": {"acc_mag": a.without("coriolis").norm()},
        "tilt_from_the_horizontal": solve(g.but(tilt=pi(g.tilt) / 2 - g.tilt)),
        "coriolis_of_horizontal_nozzle": {"acc_mag": a.reweighted(coriolis=too_far).norm()},
    }


def draw(g, ax):
    figure(g, ax, *nozzle_and_particle(g))
