"""The ride of 3/19 to 3/24: cars on hinged arms R and a wavy track (h/2)(1 - cos(2 theta))."""

from collections.abc import Sequence

from exercises.annotations import AnyAxes, Functions, Givens, Number, Path, Scalar, Steps, Triple
from exercises.tools import Sketch, Step, mp, proofs, rate, second_rate, size, terms
from newton_euler import Frame, asin, cos, cylindrical, moving, pi, sin, spherical, sqrt
from newton_euler.kinematics.coordinates import CoordinatePoint


def problem_of(key: str, names: Sequence[str], in_spherical: bool = False) -> Functions:
    """``solve``, ``steps``, ``prove`` and ``draw`` of the velocity "v" or acceleration "a" of the
    car, in cylindrical or spherical components; ``names``: of the :func:`steps`.
    """
    section = "3.7" if in_spherical else "3.5"
    axes = proofs.spherical_axes if in_spherical else proofs.cylindrical_axes

    def solve(g):
        ground, *cars = car(g)
        P = cars[in_spherical]
        return {key: P.velocity(ground) if key == "v" else P.acceleration(ground)}

    def all_steps(g):
        yield from steps(g, section, *names)
        if key == "a":
            yield from terms(solve(g)["a"], "a", "m/s^2", section)

    def prove(g):
        P = car_in_time(g)
        found = rate(P) if key == "v" else second_rate(P)
        return {key: proofs.times(axes(P(0)), found)} | proved_steps(g, *names)

    return solve, all_steps, prove, lambda g, ax: figure(g, ax, in_spherical)


def coordinates(g: Givens) -> tuple[Scalar, Scalar, Scalar, Scalar]:
    """r, theta, z and phi of the car at theta = pi/4, moving: r^2 + z^2 = R^2, R sin(phi) = z."""
    theta = moving(pi(g.R) / 4, rate=g.omega)
    z = g.h / 2 * (1 - cos(2 * theta))
    r = sqrt(g.R**2 - z.value**2)
    r_dot = -z.value * z.rate / r
    r_ddot = -(z.rate**2 + r_dot**2 + z.value * z.acceleration) / r
    phi = asin(z.value / g.R)
    phi_dot = z.rate / (g.R * cos(phi))
    phi_ddot = (z.acceleration / g.R + phi_dot**2 * sin(phi)) / cos(phi)
    return moving(r, r_dot, r_ddot), theta, z, moving(phi, phi_dot, phi_ddot)


def car(g: Givens) -> tuple[Frame, CoordinatePoint, CoordinatePoint]:
    """Ground, with z up, and the car in cylindrical and in spherical coordinates."""
    ground = Frame("ground")
    r, theta, z, phi = coordinates(g)
    return (ground, cylindrical(ground, "P", r, theta, z), spherical(ground, "P", g.R, theta, phi))


def steps(g: Givens, section: str, *names: str) -> Steps:
    """The named ones of r, z, phi and their rates as steps."""
    r, _, z, phi = coordinates(g)
    means = {
        "z": (z.value, "m", "height of the car at theta = pi/4"),
        "z_dot": (z.rate, "m/s", "rate of the height, h sin(2 theta) omega"),
        "r": (r.value, "m", "distance of the car from the axis, sqrt(R^2 - z^2)"),
        "r_dot": (r.rate, "m/s", r"its rate, $-z\,\dot{z}/r$"),
        "r_ddot": (
            r.acceleration,
            "m/s^2",
            r"its second rate, from the rate of $r\,\dot{r} = -z\,\dot{z}$ as $\ddot{z} = 0$",
        ),
        "sin_phi": (sin(phi.value), "1", "sine of the elevation of the arm, z/R"),
        "cos_phi": (cos(phi.value), "1", "cosine of the elevation, sqrt(1 - sin(phi)^2)"),
        "phi_dot": (phi.rate, "rad/s", r"rate of the elevation, $\dot{z}/(R \cos\phi)$"),
        "phi_ddot": (
            phi.acceleration,
            "rad/s^2",
            r"second rate of the elevation, $\dot\phi^2 \tan\phi$ as $\ddot{z} = 0$",
        ),
    }
    for name in names:
        yield Step(name, *means[name], section, "3.24" if name == "sin_phi" else "")


def car_in_time(g: Givens) -> Path:
    """Proof: position of the car over time, theta = pi/4 at t = 0."""

    def P(t):
        theta = mp.pi / 4 + g.omega * t
        z = g.h * mp.sin(theta) ** 2
        r = mp.sqrt((g.R - z) * (g.R + z))
        return [r * mp.cos(theta), r * mp.sin(theta), z]

    return P


def proved_steps(g: Givens, *names: str) -> dict[str, Number]:
    """Proof: the named ones of r, z, phi and their rates."""
    P = car_in_time(g)
    found: dict[str, Number] = {}
    for name, of in {
        "r": lambda place: mp.hypot(place[0], place[1]),
        "z": lambda place: place[2],
        "phi": proofs.elevation,
    }.items():
        f = lambda t, of=of: of(P(t))
        found |= {name: f(0), f"{name}_dot": rate(f), f"{name}_ddot": second_rate(f)}
    found |= {"sin_phi": P(0)[2] / size(P(0)), "cos_phi": found["r"] / size(P(0))}
    return {name: found[name] for name in names}


def on_track(g: Givens, theta: Scalar) -> Triple:
    """A place on the track."""
    z = g.h / 2 * (1 - cos(2 * theta))
    r = sqrt(g.R**2 - z**2)
    return r * cos(theta), r * sin(theta), z


def figure(g: Givens, ax: AnyAxes, elevation_angle: bool) -> None:
    """The ride, its track, theta, and the height of a car or the elevation of its arm."""
    ground, C, P = car(g)
    s = Sketch(ax, ground, azimuth=12, elevation=33)
    place = P.position(ground)
    O, foot, top = (0, 0, 0), (0, 0, -0.7 * g.R), on_track(g, pi(g.R) / 2)
    Q, below = (place.x, place.y, 0), (top[0], top[1], 0)
    opposite = ground.vector(*on_track(g, 5 * pi(g.R) / 4))
    s.ground(foot, normal=ground.k, size=0.5 * g.R)
    s.shaft(foot, O)
    s.path([on_track(g, pi(g.R) * n / 60) for n in range(121)])
    for end in (place, opposite):
        s.rod(O, end)
        s.box(end, C.local, (0.12 * g.R, 0.16 * g.R, 0.1 * g.R))
    s.hinge(O, P.local.j)
    s.axes(O, ground, length=0.75 * g.R, labels=["x", "", "z"])
    s.line(O, Q)
    s.line(Q, place)
    s.arc(O, (g.R, 0, 0), Q, label=r"$\theta$", radius=0.5 * g.R)
    if elevation_angle:
        s.arc(O, Q, place, label=r"$\phi$", radius=0.72 * g.R)
    else:
        s.dimension(Q, place, label="z")
    s.line(O, below)
    s.dimension(below, top, label="h")
    s.turn((0, 0, -0.5 * g.R), ground.k, label=r"$\omega$")
    s.label(opposite * 0.55, "$R$", offset=(8, 8), bold=False)
    s.label(O, "O")


def section(g: Givens, ax: AnyAxes) -> None:
    """The vertical plane of a car's arm, with the unit vectors of both coordinate systems."""
    ground, C, P = car(g)
    s = Sketch(ax, C.local, plane="xz")
    place = P.position(ground)
    r = C.coordinates[0].value
    O, Q = (0, 0, 0), (r, 0, 0)
    s.line((0, 0, -0.3 * g.R), (0, 0, 0.6 * g.R), style="centre")
    s.line(O, (1.15 * r, 0, 0))
    s.rod(O, place)
    s.hinge(O)
    s.arc(O, Q, place, label=r"$\phi$", radius=0.4 * g.R)
    s.dimension(Q, place, label="z")
    s.label(place * 0.6, "$R$", offset=P.local.k, bold=False)
    s.axes(place, C.local, length=0.3 * g.R, labels=["$e_r$", "", "k"])
    s.axes(place, P.local, length=0.3 * g.R, labels=["$e_R$", "", r"$e_\phi$"])
    s.dot(place)
    s.label(O, "O")
