"""3/5: acceleration of constant magnitude on a helix, at constant speed and from rest."""

from exercises.devices.helix import figure, on_helix
from exercises.tools import mp, proofs
from newton_euler import asin, integral, kinematics, moving, pi, sin, sqrt

follows = {"z_uniform": lambda g, theta_uniform: rise(g.p) * theta_uniform}


def rise(p):
    """The rise per radian."""
    return p / (2 * pi(p))


def at_unit_rate(one, a, p):
    """Length of path c and normal acceleration n at 1 rad/s: of theta, c theta' and n theta'^2."""
    P = on_helix(a, rise(p), moving(0 * one, rate=one))
    return P.velocity(P.ground).norm(), P.acceleration(P.ground).norm()


def of_symbols(g):
    return at_unit_rate(g.one, g.a, g.p)


def of_numbers(g):
    return at_unit_rate(g.one, g.a_1, g.p_1)


def formulas(g, c, n):
    """Solutions of (c theta'')^2 + (n theta'^2)^2 = A^2: constant theta', and from rest."""
    uniform = sqrt(g.A / n) * g.t
    return {
        "theta_uniform": uniform,
        "z_uniform": rise(g.p) * uniform,
        "theta_rate": sqrt(g.A / n * sin(2 * n * g.theta / c)),
        "theta_1": pi(n) * c / (4 * n),
    }


def times_from_rest(g, c, n):
    """The times t_h, t_1, integrals of dtheta/theta'. With 2 n theta/c = pi/2 - 2
    asin(sin(w)/sqrt(2)) they are elliptic integrals of the first kind, w falling from pi/2 at the
    start to 0 at theta_1.
    """
    scale = c / sqrt(2 * n * g.A_1)
    return {"t_h": falls(g)[0] * scale, "t_1": falls(g)[1] * scale}


def falls(g):
    """The elliptic integrals to theta_1/2 and to theta_1."""
    right = pi(g.one) / 2
    at_half = asin(sqrt(2 * g.one) * sin(right / 4))
    fall = lambda end: integral(lambda w: 1 / sqrt(1 - sin(w) ** 2 / 2), end, right)
    return fall(at_half), fall(0)


def solve(g):
    return formulas(g, *of_symbols(g)) | times_from_rest(g, *of_numbers(g))


def steps(g):
    (c, n), (K_h, K_1) = of_symbols(g), falls(g)
    w = 2 * n * g.theta / c
    return {"c": c, "n": n, "w": w, "c_1": of_numbers(g)[0], "K_h": K_h, "K_1": K_1}


def prove(g):
    """theta and t as integrals over u = theta'^2 from rest, up to A/n; the rate as a root."""
    c, n, h = stretch_and_bend(g.a, g.p)
    c_1, n_1, _ = stretch_and_bend(g.a_1, g.p_1)
    scale = c_1 / n_1 / mp.sqrt(g.A_1 / n_1)

    def time(share):
        """The time until u is this share of A/n."""
        return proofs.integral(lambda s: scale / mp.sqrt(1 - s**4), 0, mp.sqrt(share))

    rate = proofs.root(lambda w: n * w**2 - g.A, 0, 2 * mp.sqrt(g.A / n))
    return {
        "theta_uniform": rate * g.t,
        "z_uniform": h * rate * g.t,
        "theta_rate": mp.sqrt(g.A / n * share_at(g.theta, c, n)),
        "theta_1": reached(0, c, n),
        "t_h": time(share_at(reached(0, c_1, n_1) / 2, c_1, n_1)),
        "t_1": time(1),
    }


def stretch_and_bend(a, p):
    """Magnitudes of dr/dtheta and its derivative on the helix, and its rise."""
    h = p / (2 * mp.pi)
    place = lambda s: [a * mp.cos(s), a * mp.sin(s), h * s]
    return proofs.size(proofs.rate(place)), proofs.size(proofs.second_rate(place)), h


def reached(s, c, n):
    """theta where u = (1 - s*s) A/n, a form without cancellation near the end."""
    return proofs.integral(lambda s: c / n / mp.sqrt(2 - s * s), s, 1)


def share_at(theta, c, n):
    """u at the angle theta, as a share of A/n."""
    s = mp.findroot(lambda s: reached(s, c, n) - theta, (0.6, 0.7))
    return 1 - s * s


def mistakes(g):
    (c, _), (c_1, _) = of_symbols(g), of_numbers(g)
    flat = solve(g.but(p=0 * g.p, p_1=0 * g.p_1))
    higher = solve(g.but(p=2 * pi(g.p) * g.p, p_1=2 * pi(g.p_1) * g.p_1))
    from_rest = ("theta_rate", "theta_1", "t_h", "t_1")
    by_cylinder = formulas(g, c, c**2 / g.a) | times_from_rest(g, c_1, c_1**2 / g.a_1)
    return {
        "no_normal": {"theta_rate": sqrt(2 * g.A * g.theta / c)},
        "no_axial": {key: flat[key] for key in from_rest},
        "radius_of_cylinder": by_cylinder,
        "pitch_per_radian": {key: higher[key] for key in ("z_uniform", *from_rest)},
    }


def draw(g, ax):
    at_P = on_helix(g.a, rise(g.p), moving(2.2, rate=1.0))
    ground = at_P.ground
    s, O, Q, P = figure(ax, ground, g.a, rise(g.p), 2.2, "a")
    triad = kinematics.frenet(at_P.velocity(ground), at_P.acceleration(ground))
    s.line(O, Q)
    s.line(Q, P)
    s.arc(O, (g.a, 0, 0), Q, label=r"$\theta$")
    s.vector(P, triad.e_t, "$a_t$", kind="acceleration")
    s.vector(P, triad.e_n, "$a_n$", kind="acceleration")
