"""7/21: the moment of inertia of a connecting rod about its other bearing."""

from exercises.devices.connecting_rod import about_A, figure, mean_square, two_masses


def solve(g):
    A, G, B = about_A(g.m, g.I_AA, g.r_a, g.r_b)
    return {"I_BB": A.about(G).about(B).moment("z")}


def steps(g):
    A, G, B = about_A(g.m, g.I_AA, g.r_a, g.r_b)
    own = A.about(G)
    return {"I_GG": own.moment("z"), "transfer": own.about(B).terms["transfer"].moment("z")}


def prove(g):
    """By two mass points with the same mass, centre and moment about AA'."""
    near, far = two_masses(g.I_AA / g.m, g.r_a)
    from_B = [g.r_a + g.r_b - x for x in (near, far)]
    return {"I_BB": g.m * mean_square(from_B), "I_GG": g.m * ((far - near) / 2) ** 2}


def mistakes(g):
    A, G, _ = about_A(g.m, g.I_AA, g.r_a, g.r_b)
    return {
        "A_as_G": {"I_BB": g.I_AA + g.m * (g.r_a + g.r_b) ** 2},
        "both_added": {"I_BB": g.I_AA + g.m * (g.r_a**2 + g.r_b**2)},
        "difference": {"I_BB": g.I_AA + g.m * (g.r_b - g.r_a) ** 2},
        "stops_at_G": {"I_BB": A.about(G).moment("z")},
    }


def draw(g, ax):
    s, up = figure(ax, g.r_a, g.r_b)
    s.dimension((0, 0, 0), (g.r_a, 0, 0), label="$r_a$", offset=up)
    s.dimension((g.r_a, 0, 0), (g.r_a + g.r_b, 0, 0), label="$r_b$", offset=up)
