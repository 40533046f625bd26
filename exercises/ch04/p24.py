"""4/24: the rotor of a helicopter that is nosing over."""

from exercises.tools import Sketch, angular_velocity, in_frame, minus, mp, proofs, spun, terms
from newton_euler import Frame, cos, sin


def fuselage_and_rotor(g):
    """y toward the nose, z along the mast; the fuselage pitches about -x, the rotor about z."""
    ground = Frame("ground")
    fuselage = ground.rotate("fuselage", "-x", rate=g.omega)
    return ground, fuselage, fuselage.rotate("rotor", "z", rate=g.Omega)


def solve(g):
    ground, fuselage, rotor = fuselage_and_rotor(g)
    return in_frame(fuselage, {"alpha_rotor": rotor.angular_acceleration(ground)})


def steps(g):
    ground, fuselage, rotor = fuselage_and_rotor(g)
    yield "omega_fuselage", fuselage.angular_velocity(ground)
    yield "omega_rotor", rotor.angular_velocity(fuselage).expressed_in(fuselage)
    yield from terms(solve(g)["alpha_rotor"], "alpha_rotor", "rad/s^2", "4.9")


def prove(g):
    """The mast tilts forward; the blade turns from the right toward the nose."""
    mast = lambda t: [0, mp.sin(g.omega * t), mp.cos(g.omega * t)]
    rotor = lambda t: spun(mast(t), [1, 0, 0], g.Omega * t)
    fuselage = lambda t: spun([1, 0, 0], [0, mp.cos(g.omega * t), -mp.sin(g.omega * t)], 0)
    turning = angular_velocity(fuselage)
    return {
        "alpha_rotor": proofs.angular_acceleration(rotor),
        "omega_fuselage": turning,
        "omega_rotor": minus(angular_velocity(rotor), turning),
    }


def mistakes(g):
    _, fuselage, _ = fuselage_and_rotor(g)
    alpha = solve(g)["alpha_rotor"]
    return {
        "zero": {"alpha_rotor": 0 * alpha},
        "reversed": {"alpha_rotor": -alpha},
        "twice": {"alpha_rotor": 2 * alpha},
        "along_transverse_axis": {"alpha_rotor": fuselage.vector(-g.omega * g.Omega, 0, 0)},
    }


def draw(g, ax):
    ground, fuselage, rotor = fuselage_and_rotor(g)
    hub = fuselage.point("hub", 0, 0, 0)
    s = Sketch(ax, ground, azimuth=25, elevation=20)
    s.rod((0, -0.6, -0.7), (0, -1.9, -0.55))  # tail
    s.rod((0, -1.9, -0.55), (0, -2, -0.2))
    # cabin
    s.plate([(0, 0.1 + 0.8 * cos(u), -0.75 + 0.38 * sin(u)) for u in (0.1 * n for n in range(63))])
    s.plate([(0, 0.45, -0.7), (0, 0.87, -0.7), (0, 0.7, -0.52), (0, 0.45, -0.42)])  # its window
    for y in (-0.25, 0.45):
        s.rod((0, y, -1.08), (0, y, -1.3))
    s.rod((0, -0.5, -1.3), (0, 0.8, -1.3))  # skid
    s.shaft((0, 0, -0.38), hub)
    s.ring(hub, fuselage.k, 1.2)
    for blade in (rotor.point("", 1.2 * cos(u), 1.2 * sin(u), 0) for u in (0.6, 2.694, 4.789)):
        s.rod(hub, blade)
    s.axes(hub, fuselage, length=0.75)
    s.turn((0, 0, 0.25), fuselage.k, label=r"$\Omega$")
    s.turn((0.5, 0.28, -0.6), -fuselage.i, label=r"$\omega$")
