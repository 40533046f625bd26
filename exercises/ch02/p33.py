"""2/33: a slider at the centre of a turning disk."""

from exercises.devices.turning_plate import turning
from exercises.tools import Sketch, angular_velocity, mp, rot, second_rate
from newton_euler import moving


def disk_and_slider(g):
    ground, disk = turning("disk", g.omega, g.alpha)
    return ground, disk, disk.point("slider", moving(0, rate=g.x_dot), 0, 0)


def solve(g):
    ground, _, P = disk_and_slider(g)
    return {"a": P.acceleration(ground)}


def steps(g):
    ground, disk, P = disk_and_slider(g)
    return {"omega_disk": disk.angular_velocity(ground), "v_r": P.velocity(disk)}


def prove(g):
    """The spiral in the ground, through O, along x at t = 0."""
    theta = lambda t: g.omega * t + g.alpha * t**2 / 2
    place = lambda t: [g.x_dot * t * mp.cos(theta(t)), g.x_dot * t * mp.sin(theta(t)), 0]
    return {"a": second_rate(place), "omega_disk": angular_velocity(lambda t: rot("z", theta(t)))}


def mistakes(g):
    a = solve(g)["a"]
    return {
        "zero": {"a": a.without("coriolis")},
        "no_2": {"a": a.reweighted(coriolis=0.5)},
        "reversed": {"a": a.reweighted(coriolis=-1)},
    }


def draw(g, ax):
    ground, disk, P = disk_and_slider(g)
    s = Sketch(ax, ground, plane="xy")
    R, w = 1, 0.09  # the size of the disk is not given
    slot = [(-0.85, -w, 0), (0.85, -w, 0), (0.85, w, 0), (-0.85, w, 0)]
    s.disk(P, disk.k, R)
    s.plate(slot, shade="light")
    s.plate([(-0.16, -w, 0), (0.16, -w, 0), (0.16, w, 0), (-0.16, w, 0)], shade="dark")
    s.swing(P, (R * 1.08, 0, 0), disk.k, r"$\omega,\ \alpha$")
    s.line((R, 0, 0), (1.4 * R, 0, 0), style="centre")
    s.vector((0.16, 0, 0), disk.i, r"$\dot x$")
    s.label((1.4 * R, 0, 0), "x", offset=(10, 0), bold=False)
    s.dot(P, "O", offset=(0, -18))
