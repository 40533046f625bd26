"""7/20: the centroidal axis of a connecting rod, from its moments of inertia about two others."""

from exercises.devices.connecting_rod import about_A, figure, mean_square, two_masses
from exercises.tools import mp
from exercises.tools import root as proof_root
from newton_euler import sqrt

follows = {"k_G": lambda g, r_a: at_G(g, r_a)}


def at_G(g, r_a):
    """The radius of gyration about GG', if GG' is at this distance from AA'."""
    A, G, _ = about_A(g.m, g.I_AA, r_a, g.L - r_a)
    return A.about(G).radius_of_gyration("z")


def solve(g):
    r_a = (g.L + apart(g)) / 2
    return {"r_a": r_a, "k_G": at_G(g, r_a)}


def apart(g):
    """r_a - r_b, from r_a^2 - r_b^2."""
    return (g.I_AA - g.I_BB) / (g.m * g.L)


def steps(g):
    return {"apart": apart(g), "I_GG": g.I_AA - g.m * solve(g)["r_a"] ** 2}


def prove(g):
    """By two mass points with the same mass, centre and moments about AA' and BB'."""

    def excess(r_a):
        return mean_square([g.L - x for x in two_masses(g.I_AA / g.m, r_a)]) - g.I_BB / g.m

    nearly = 1 - mp.mpf(10) ** -9  # share of the distance, almost all of the mass at G
    r_a = proof_root(excess, 0, nearly * mp.sqrt(g.I_AA / g.m))
    near, far = two_masses(g.I_AA / g.m, r_a)
    return {"r_a": r_a, "k_G": (far - near) / 2}


def mistakes(g):
    r_a = solve(g)["r_a"]
    return {
        "in_proportion": {"r_a": g.L * g.I_AA / (g.I_AA + g.I_BB)},
        "swapped": {"r_a": g.L - r_a},
        "no_own_moment": {"r_a": sqrt(g.I_AA / g.m)},
        "units": {"r_a": g.L / 2 + (r_a - g.L / 2) / 1000},
    }


def draw(g, ax):
    # GG' is not where the answer has it
    s, up = figure(ax, 0.54 * g.L, 0.46 * g.L)
    s.dimension((0, 0, 0), (0.54 * g.L, 0, 0), label="$r_a$", offset=up)
    s.dimension((0.54 * g.L, 0, 0), (g.L, 0, 0), label="$r_b$", offset=up)
    s.dimension((0, 0, 0), (g.L, 0, 0), label="L", offset=-up)
