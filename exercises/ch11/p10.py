"""11/10: the least compression of a spring to shoot a pellet round a loop."""

from exercises.devices.vertical_loop import contact, draw_loop, proved_contact
from exercises.tools import ProofError, after, mp, mpf, on_ground, until
from exercises.tools import root as proved_root
from newton_euler import pi, root, sqrt
from newton_euler.dynamics import mass_from_weight, spring_potential, weight_potential


def mass(g):
    return mass_from_weight(g.W, g.g)


def least_speed(g, r):
    """The speed at which a pellet just keeps contact at the top of a loop of radius r."""
    fast = 10 * sqrt(g.g * r)
    return root(lambda v: contact(mass(g), g.g, r, pi(r), v), fast / 1000, fast)


def compression(g, v, rise):
    """The compression that gives the pellet the speed v at the height ``rise``."""
    needed = mass(g) * v**2 / 2 + weight_potential(mass(g), rise, g.g)
    most = g.W / g.k + 10 * rise
    return {"x_min": root(lambda x: spring_potential(g.k, x) - needed, most / 10**4, most)}


def solve(g):
    return compression(g, least_speed(g, g.r), 2 * g.r)


def steps(g):
    v = least_speed(g, g.r)
    taken = weight_potential(mass(g), 2 * g.r, g.g)
    return {"v_D": v, "T_D": mass(g) * v**2 / 2, "V_D": taken}


def prove(g):
    """Backward in time from the top, with zero contact force, into the spring to rest."""
    m = g.W / g.g
    v = proved_root(lambda v: proved_contact(m, g.g, g.r, mp.pi, v), 0, 10 * mp.sqrt(g.g * g.r))
    swing = mp.sqrt(g.r / g.g)

    def round_loop(state):
        pull = g.g / g.r * mp.sin(state[0])
        return [state[1], -float(pull) if isinstance(state[0], float) else -pull]

    _, (_, rate) = until(round_loop, [mp.pi, v / g.r], lambda s: s[0] - 2 * mp.pi, swing / 4)
    v_B = rate * g.r
    slowing = lambda s: [s[1], -g.k / m * s[0]]
    _, (x, _) = until(slowing, [mpf(0), v_B], lambda s: s[1], mp.sqrt(m / g.k) / 2)

    def gets_round(speed):
        """Whether a pellet that enters the loop at this speed keeps contact all the way."""
        state, moment = [0.0, float(speed / g.r)], float(swing / 20)
        while state[0] < 2 * mp.pi:
            if proved_contact(m, g.g, g.r, state[0], state[1] * g.r) < 0:
                return False
            state = after(round_loop, state, moment)
        return True

    if gets_round(v_B * mpf("0.999")) or not gets_round(v_B * mpf("1.001")):
        raise ProofError("this is not the speed at which the pellet begins to get round the loop")
    return {"x_min": x, "v_D": v}


def mistakes(g):
    v = least_speed(g, g.r)
    return {
        "at_rest_at_the_top": compression(g, 0 * v, 2 * g.r),
        "rise_r": compression(g, v, g.r),
        "feet": solve(g.but(r=g.r / 12)),
        "diameter": compression(g, least_speed(g, 2 * g.r), 2 * g.r),
    }


def draw(g, ax):
    ground, s = on_ground(ax, plane="xz")
    r = g.r
    w = 0.12 * r
    left, A = -3.2 * r, (-1.8 * r, 0, 0)
    s.road([(left, 0, 0), (1.4 * r, 0, 0)])
    s.ground((left, 0, w), normal=ground.i, size=0.5 * r)
    s.spring((left, 0, w), (A[0] - w, 0, w))
    s.sphere((A[0], 0, w), w)
    draw_loop(s, ground, r)
    O, B, D = (0, 0, r), (0, 0, 0), (0, 0, 2 * r)
    for P in (O, B, D):
        s.dot(P)
    s.arrow(O, (0.6 * r, 0, 1.8 * r), label="r")
    s.label(A, "A", offset=(0, -16))
    s.label(B, "B", offset=(0, -16))
    s.label(D, "D", offset=(0, 14))
    s.label((0.5 * (left + A[0]), 0, w), "k", offset=(0, 22), bold=False)
