"""4/27: a disk at the end of a cranked bracket that turns about a fixed axis."""

from exercises.devices.moving_frame import seen_in, turning_of
from exercises.tools import Sketch, in_frame, plus, rate, rot, second_rate, terms, times
from newton_euler import Frame


def bracket_and_disk(g):
    """Ground; the bracket turns about the fixed x axis, in it the disk about the bracket's z."""
    ground = Frame("ground")
    bracket = ground.rotate("bracket", "x", rate=g.Omega)
    disk = bracket.rotate("disk", "z", rate=g.omega, origin=bracket.point("B", 0, g.a, g.h))
    return ground, bracket, disk, disk.point("A", 0, -g.r, 0)


def answers(ground, bracket, _, A):
    v, a = A.velocity(ground, via=bracket), A.acceleration(ground, via=bracket)
    return in_frame(ground, {"v_A": v, "a_A": a})


def solve(g):
    return answers(*bracket_and_disk(g))


def steps(g):
    ground, bracket, _, A = bracket_and_disk(g)
    phrase = "the moving frame, fixed in the bracket,"
    yield from turning_of(bracket, ground, ground, "bracket", phrase)
    yield from seen_in(bracket, A, ground, "mm", "the bracket", "O", "r_A")
    v, a = solve(g).values()
    yield from terms(v, "v_A", "mm/s", "4.8")
    yield from terms(a, "a_A", "mm/s^2", "4.8")


def prove(g):
    seen = lambda t: plus([0, g.a, g.h], times(rot("z", g.omega * t), [0, -g.r, 0]))
    A = lambda t: times(rot("x", g.Omega * t), seen(t))
    found = {"r_A": seen(0), "v_r": rate(seen), "a_r": second_rate(seen)}
    return {"v_A": rate(A), "a_A": second_rate(A)} | found


def mistakes(g):
    frames = ground, _, disk, _ = bracket_and_disk(g)
    B, solved = disk.origin, answers(*frames)
    v, a = solved["v_A"], solved["a_A"]
    wrong = {
        "rev_per_min": solve(g.but(omega=g.stated("omega"), Omega=g.stated("Omega"))),
        "B_at_rest": {"v_A": v - B.velocity(ground), "a_A": a - B.acceleration(ground)},
        "A_carried_like_B": {"v_A": v.without("rotation") + B.velocity(ground)},
        "square_of_the_sum": {"a_A": a + ground.j * (2 * g.omega * g.Omega * g.r)},
        "A_beyond_B": solve(g.but(r=-g.r)),
    }
    return in_frame(ground, wrong)


def draw(g, ax):
    ground, bracket, disk, A = bracket_and_disk(g)
    B, O, corner = disk.origin, bracket.point("O", 0, 0, 0), bracket.point("", 0, g.a, 0)
    back, front = ground.point("", -0.3 * g.a, 0, 0), ground.point("", 1.1 * g.a, 0, 0)
    s = Sketch(ax, ground, azimuth=35, elevation=25)
    s.shaft(back, front)
    s.ground(front, normal=-ground.i)
    s.rod(O, corner, B)
    s.disk(B, bracket.k, g.r, spoke=A)
    s.axes(O, ground, length=0.6 * g.a)
    s.turn(ground.point("", 0.85 * g.a, 0, 0), ground.i, label=r"$\Omega$")
    s.turn(disk.point("", 0, 0, 0.5 * g.r), bracket.k, label=r"$\omega$")
    s.dimension(O, corner, label="a")
    s.dimension(corner, B, label="h")
    s.dimension(B, A, label="r", offset=0)
    s.dot(A)
    s.dot(B)
    for P in (A, B, O):
        s.label(P, P.name)
