"""3/2: velocity and acceleration on a given path; a component of the velocity."""

from exercises.tools import Sketch, minus, mp, size
from newton_euler import Frame
from newton_euler.kinematics import along

GROUND = Frame("ground")


def point(g, t):
    return GROUND.point("P", *along(lambda t: (g.cx * t**2, g.cy * t**3, -g.cz * t**4), t))


def direction(g, frame=GROUND):
    return frame.vector(g.nx, g.ny, g.nz)


def v_n(g, v):
    n = direction(g, v.frame)
    return v.dot(n) / n.norm()


follows = {"v_n": v_n}


def solve(g):
    P = point(g, g.t1)
    v = P.velocity(GROUND)
    return {"v": v, "v_n": v_n(g, v), "a": P.acceleration(GROUND)}


def steps(g):
    return {"length": direction(g).norm(), "product": solve(g)["v"].dot(direction(g))}


def prove(g):
    """For powers of t, t x' = n x and t^2 x'' = n (n - 1) x; v_n by the triangle of v and n."""
    place = lambda t: [g.cx * t**2, g.cy * t**3, -g.cz * t**4]
    r, n = place(g.t1), [g.nx, g.ny, g.nz]
    degree = [mp.log(y / x, 2) for x, y in zip(r, place(2 * g.t1), strict=True)]
    v = [d * x / g.t1 for d, x in zip(degree, r, strict=True)]
    a = [(d - 1) * x / g.t1 for d, x in zip(degree, v, strict=True)]
    third = size(minus(v, n))  # numbers without units
    cosine = (size(v) ** 2 + size(n) ** 2 - third**2) / (2 * size(v) * size(n))
    return {"v": v, "v_n": size(v) * cosine, "a": a, "length": size(n)}


def mistakes(g):
    right, n = solve(g), direction(g)
    mean_v = point(g, g.t1).position(GROUND) / g.t1
    return {
        "n_not_unit": {"v_n": right["v"].dot(n)},
        "sign_lost": {"v_n": abs(right["v_n"])},
        "z_upward": solve(g.but(cz=-g.cz)),
        "averages": {"v": mean_v, "v_n": v_n(g, mean_v), "a": mean_v / g.t1},
    }


def draw(g, ax):
    s = Sketch(ax, GROUND, azimuth=-35, elevation=15)
    P, far = point(g, g.t1), g.cz * g.t1**4
    s.axes((0, 0, 0), GROUND, length=0.6 * far)
    s.path([point(g, g.t1 * n / 40).position(GROUND) for n in range(44)])
    n = 0.9 * far * direction(g).direction()
    s.arrow((0, 0, 0), n)
    s.label(n, "$\\mathbf{n}$")
    s.vector(P, P.velocity(GROUND), "$\\mathbf{v}$")
    s.dot(P, "P")
    s.label((0, 0, 0), "O")
