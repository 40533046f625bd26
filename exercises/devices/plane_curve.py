"""Proof for a point at constant speed on a plane curve, as in 2/1 and 2/2."""

from exercises.annotations import Number, Path
from exercises.tools import plus, rate, scaled, second_rate, size


def at_constant_speed(curve: Path, q: Number, speed: Number) -> tuple[list[Number], list[Number]]:
    """Velocity and acceleration at ``q`` of a point that runs along ``curve(q)``, a list of three,
    in the direction of increasing q.

    q grows by q' t + q'' t^2/2. The speed gives q'; q'' makes the acceleration, which is linear in
    it, normal to the velocity.
    """
    q_dot = speed / size(rate(lambda t: curve(q + t)))
    acceleration = lambda q_ddot: second_rate(lambda t: curve(q + q_dot * t + q_ddot * t**2 / 2))
    v = rate(lambda t: curve(q + q_dot * t))
    before, after = (acceleration(n * q_dot) for n in (0, 1))
    along = [sum(x * y for x, y in zip(v, a, strict=True)) for a in (before, after)]
    share = along[0] / (along[0] - along[1])
    return v, plus(scaled(1 - share, before), scaled(share, after))
