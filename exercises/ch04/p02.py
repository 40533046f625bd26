"""4/2: water flowing outward in a nozzle that turns about the vertical."""

from exercises.devices.moving_frame import motion_via
from exercises.devices.nozzle import figure, nozzle_and_particle, particle_in_time
from exercises.tools import rate, second_rate, size
from newton_euler import sin


def motion(g):
    ground, turning, P = nozzle_and_particle(g)
    return P.velocity(ground, via=turning), P.acceleration(ground, via=turning)


def solve(g):
    v, a = motion(g)
    return {"speed": v.norm(), "acc_mag": a.norm()}


def steps(g):
    ground, turning, P = nozzle_and_particle(g)
    start = "O, with x horizontal, outward in the plane of the nozzle, and z up"
    return motion_via(turning, P, ground, "nozzle", "the nozzle", start, "the particle")


def prove(g):
    P = particle_in_time(g)
    v, a = rate(P), second_rate(P)
    return {"speed": size(v), "acc_mag": size(a), "v_P": v, "a_P": a}


def mistakes(g):
    v, a = motion(g)
    too_far = 1 / sin(g.tilt)
    return {
        "no_coriolis": {"acc_mag": a.without("coriolis").norm()},
        "d_from_the_axis": {
            "speed": v.reweighted(rotation=too_far).norm(),
            "acc_mag": a.reweighted(centripetal=too_far).norm(),
        },
        "single_coriolis": {"acc_mag": a.reweighted(coriolis=0.5).norm()},
        "coriolis_of_horizontal_nozzle": {"acc_mag": a.reweighted(coriolis=too_far).norm()},
    }


def draw(g, ax):
    frames = _, turning, _ = nozzle_and_particle(g)
    figure(g, ax, *frames).axes((0, 0, 0), turning, length=0.3 * g.d)
