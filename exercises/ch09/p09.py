"""9/9: a ring swinging out from a turning shaft."""

from exercises.tools import mp, on_ground, proofs
from newton_euler import Frame, acos, cos, particle, pi, sin, solve_linear, sqrt
from newton_euler.bodies import Inertia, disk, ring

# omega^2*cos(beta_ring) is the same for all rates
follows = {"omega_max": lambda g, beta_ring: g.omega * sqrt(cos(beta_ring))}


def hanging(g, body=ring):
    """The body, of mass 1, and A: x is the tangent, y points from G to A, z is the normal."""
    frame = Frame("ring")
    return body(g.a, frame.point("G", 0, -g.a, 0), "z", mass=1), frame.point("A", 0, 0, 0)


def moments(g, body, A, inertia, cos_beta):
    """Moments about x over sin(beta): the one needed at 1 rad/s, and that of the weight."""
    up = A.frame.vector(0, cos_beta, 1)  # its component along the normal divided by sin(beta)
    return up.cross(inertia.times(up)).x, (body.centre - A).cross(up * -g.g).x


def angles(g, body, A, inertia=None):
    inertia = inertia or body.about(A)

    def excess(cos_beta):
        needed, of_weight = moments(g, body, A, inertia, cos_beta)
        return needed * g.omega**2 - of_weight

    needed, of_weight = moments(g, body, A, inertia, 1)
    beta = acos(solve_linear(excess).cos_beta)
    return {"beta_ring": beta, "omega_max": sqrt(of_weight / needed)}


def solve(g):
    return angles(g, *hanging(g))


def steps(g):
    body, A = hanging(g)
    I = body.about(A)
    return {"J_n": I.moment("z"), "J_d": I.moment("y")}


def prove(g):
    """By stationary energy in the shaft's frame, a minimum at 0 while its curvature is positive."""
    points = [(share, (x, g.a - y)) for share, (x, y, _) in proofs.ring(g.a)]

    def energy(beta, omega):
        c, s = mp.cos(beta), mp.sin(beta)

        def of(point):
            along, down = point
            return -g.g * down * c - omega**2 / 2 * (along**2 + (down * s) ** 2)

        return proofs.mean(of, points)

    slope = lambda beta: proofs.rate(lambda t: energy(beta + t, g.omega))
    curvature = lambda omega: proofs.second_rate(lambda t: energy(t, omega))
    beta = proofs.root(slope, mp.mpf("0.01"), mp.pi / 2)
    quick = 10 * mp.sqrt(g.g / g.a)
    return {
        "beta_ring": beta,
        "omega_max": proofs.root(curvature, quick / 1000, quick),
        "J_n": sum(share * (x * x + y * y) for share, (x, y) in points),
        "J_d": sum(share * x * x for share, (x, _) in points),
    }


def mistakes(g):
    body, A = hanging(g)
    return {
        "particle": angles(g, particle(1, body.centre), A),
        "no_transfer": angles(g, body, A, Inertia(A, body.inertia.moments)),
        "as_disk": angles(g, *hanging(g, disk)),
        "with_the_level": {"beta_ring": pi(g.a) / 2 - solve(g)["beta_ring"]},
    }


def draw(g, ax):
    ground, s = on_ground(ax, up="y", azimuth=-18, elevation=12)
    beta = 0.7
    A, low = (0, 0, 0), (0, -1.9 * g.a, 0)
    out = ground.vector(sin(beta), -cos(beta), 0)
    G = (out * g.a).components()
    s.shaft(low, (0, 0.7 * g.a, 0))
    s.hinge(A, axis=ground.j)
    s.wire(s.around(G, A, out.cross(ground.k)))
    s.line(A, (out * 2 * g.a).components(), style="centre")
    s.line(A, low)
    s.dot(G)
    s.arc(A, low, G, label=r"$\beta$", radius=0.6 * g.a)
    s.dimension(A, G, label="a")
    s.turn((0, 0.5 * g.a, 0), ground.j, label=r"$\omega$")
    s.label(A, "A")
