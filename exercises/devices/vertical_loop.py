"""A particle inside a smooth vertical loop (11/9, 11/10): its contact, proof, figure."""

from exercises.annotations import Number, Path, Scalar
from exercises.tools import Sketch, force_needed, mp, plus
from newton_euler import Frame, dynamics, kinematics, moving, pi


def contact(m: Scalar, g: Scalar, r: Scalar, phi: Scalar, v: Scalar, **shares: Scalar) -> Scalar:
    """The track's force toward the centre, ``phi`` from the bottom; ``shares``: of its terms."""
    ground = Frame("ground")  # with y up
    P = kinematics.polar(ground, "P", r, moving(phi - pi(phi) / 2, rate=v / r))
    N = dynamics.reaction(m, P.acceleration(ground), weight=-m * g * ground.j)
    return N.reweighted(**shares).dot((P - ground.origin) * (-1 / r))


def circle(r: Number) -> Path:
    """Proof: position as a function of phi, z up, from the lowest point."""
    return lambda phi: [r * mp.sin(phi), 0, r - r * mp.cos(phi)]


def proved_contact(m: Number, g: Number, r: Number, phi: Number, v: Number) -> Number:
    """Proof: the force needed toward the centre besides the weight, at any rate of the speed."""
    needed = force_needed(m, lambda t: [(1, circle(r)(phi + v / r * t))])
    track = plus(needed, [0, 0, m * g])
    return track[2] * mp.cos(phi) - track[0] * mp.sin(phi)


def draw_loop(s: Sketch, ground: Frame, r: Scalar) -> None:
    """The loop, z up, its lowest point at the origin."""
    foot = (0, 0, 0)
    s.wire([*s.around((0, 0, r), foot, ground.j), foot])
