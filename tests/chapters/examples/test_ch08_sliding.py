"""A sphere from sliding to rolling (8.6)."""

from newton_euler import Frame, equations_of_motion, moving, solve_linear
from newton_euler.bodies import sphere
from newton_euler.chapters.examples import ch08
from newton_euler.scenes.planar import sliding_sphere
from tests.kinds import every_kind, numbers, small
from tests.tumbling import close


@every_kind
def test_example_8_6_sphere_from_sliding_to_rolling(kind):
    v0, mu, g, r = numbers(kind, 7, "1/5", "9.81", "1/8")
    begins = ch08.rolling_begins(v0, mu, g, r)
    assert close(begins.t, 2 * v0 / (7 * mu * g), small(kind))
    assert close(begins.v, 5 * v0 / 7, small(kind))
    assert close(begins.omega, -5 * v0 / (7 * r), small(kind, 100))
    assert close(begins.x, v0 * begins.t - mu * g * begins.t * begins.t / 2, small(kind, 10))
    model = sliding_sphere.sliding(mu, g, r)
    start = (0 * v0, v0, 0 * v0)
    x, v, omega = model.solution(begins.t, start)
    assert close((x, v, omega), (begins.x, begins.v, begins.omega), small(kind, 100))
    rolled = sliding_sphere.rolling(r)
    end = rolled.solution(v0, (x, v, omega))
    for law, before, after in ((model, start, (x, v, omega)), (rolled, (x, v, omega), end)):
        assert law.invariants
        for name in law.invariants:
            kept, now = law.invariant(name, before), law.invariant(name, after)
            assert close(now, kept, small(kind, 10))
    assert close(rolled.invariant("slip", (x, v, omega)), 0, small(kind, 100))


def test_example_8_6_derives_its_accelerations_from_the_newton_euler_equations():
    m, r, mu, g, v = 3.0, 0.125, 0.2, 9.81, 4.0
    ground = Frame("ground")

    def laws(N, a, alpha):
        G = ground.point("G", moving(1.0, v, a), r, 0)
        turning = ground.rotate("ball", "z", rate=-2.0, acceleration=alpha, origin=G)
        ball = sphere(r, turning, mass=m)
        surface = ground.vector(-mu * N, N, 0), ground.point("contact", 1.0, 0, 0)
        weight = ground.vector(0, -m * g, 0), ball.centre
        return equations_of_motion(ball, {"weight": weight, "surface": surface}, ground)

    s = solve_linear(laws)
    _, a, alpha = sliding_sphere.sliding(mu, g, r).derivative((1.0, v, -2.0))
    assert close((s.N, s.a, s.alpha), (m * g, a, alpha), 1e-12)


def test_a_sphere_with_too_much_forward_spin_speeds_up():
    b = ch08.rolling_begins(1.0, 0.3, 9.81, 0.2, omega0=-30.0, sense=-1)
    assert b.t > 0
    assert b.v > 1.0
    # the wrong sense shows
    assert ch08.rolling_begins(1.0, 0.3, 9.81, 0.2, omega0=-30.0).t < 0
