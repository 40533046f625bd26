"""4/14: two disks on the ends of one axle that roll in a circle."""

from exercises.tools import Sketch, angular_velocity, in_frame, minus, rate, rot, terms, times
from newton_euler import Frame, solve_rates


def axle_and_disk(g):
    """The axle turns about z at the height r; disk A about x, its lowest point at rest."""
    ground = Frame("ground")
    axle = ground.rotate("axle", "z", rate=g.omega, origin=ground.point("M", 0, 0, g.r))
    disk = lambda spin: axle.rotate("disk", "x", rate=spin, origin=axle.point("A", g.R, 0, 0))
    contact = lambda spin: disk(spin).point("contact", 0, 0, -g.r)
    (spin,) = solve_rates(lambda spin: contact(spin).velocity(ground).y, 1)
    return ground, axle, disk(spin)


def solve(g):
    ground, axle, disk = axle_and_disk(g)
    return in_frame(axle, {"omega_A": disk.angular_velocity(ground)})


def steps(g):
    ground, axle, disk = axle_and_disk(g)
    yield "v_A", disk.origin.velocity(ground).expressed_in(axle)
    yield "omega_spin", disk.angular_velocity(axle).expressed_in(axle)
    yield from terms(solve(g)["omega_A"], "omega_A", "rad/s", "4.9")


def prove(g):
    """Equal arcs on the path of radius R and on the rim of the disk."""
    # moving toward +y, its top leads
    disk = lambda t: times(rot("z", g.omega * t), rot("x", -g.R * g.omega * t / g.r))
    centre = rate(lambda t: times(rot("z", g.omega * t), [g.R, 0, g.r]))
    omega = angular_velocity(disk)
    return {"omega_A": omega, "v_A": centre, "omega_spin": minus(omega, [0, 0, g.omega])}


def mistakes(g):
    ground, axle, disk = axle_and_disk(g)
    omega = disk.angular_velocity(ground)
    wrong = {
        "only_spin": omega.without("axle"),
        "wrong_sense": omega.reweighted(disk=-1),
        "whole_axle_as_radius": omega.reweighted(disk=2),
        "omega_as_spin": omega.reweighted(disk=g.r / g.R),
    }
    return in_frame(axle, {name: {"omega_A": vector} for name, vector in wrong.items()})


def draw(g, ax):
    ground, axle, _ = axle_and_disk(g)
    O = ground.point("O", 0, 0, 0)
    M = ground.point("", 0, 0, g.r)
    top = ground.point("", 0, 0, g.r + 0.7 * g.R)
    A = axle.point("A", g.R, 0, 0)
    other = axle.point("", -g.R, 0, 0)
    contact = axle.point("", -g.R, 0, -g.r)
    s = Sketch(ax, ground, azimuth=-60, elevation=20)
    s.ground(O, normal=ground.k)
    s.ring(O, ground.k, g.R)
    s.rod(other, A)
    s.disk(A, axle.i, g.r)
    s.disk(other, axle.i, g.r)
    s.line(O, top, style="centre")
    s.axes(M, axle)
    s.turn(top, ground.k, label=r"$\omega$")
    s.dimension(M, A, label="R")
    s.dimension(other, contact, label="r", offset=axle.i * (-0.5 * g.r))
    s.dot(A, "A")
