"""The steps before (4.17), (4.18): rotation of a frame, and motion of a point relative to it."""

from exercises.annotations import Steps
from exercises.catalogue.steps import is_zero
from exercises.catalogue.wording import body_text
from exercises.tools import Step, terms
from newton_euler import Frame, Point


def turning_of(frame: Frame, ground: Frame, axes: Frame, name: str, phrase: str) -> Steps:
    """omega and nonzero alpha of the frame called ``phrase`` ("the arm"), along ``axes``."""
    omega = frame.angular_velocity(ground).expressed_in(axes)
    alpha = frame.angular_acceleration(ground).expressed_in(axes)
    within = body(ground)
    means = f"angular velocity of {phrase} in {within}"
    yield Step(f"omega_{name}", omega, "rad/s", means, "4.9", "4.22")
    if not is_zero(alpha):
        means = f"angular acceleration of {phrase} in {within}"
        yield Step(f"alpha_{name}", alpha, "rad/s^2", means, "4.9", "4.25")


def seen_in(
    frame: Frame,
    P: Point,
    axes: Frame,
    length: str,
    phrase: str,
    start: str,
    r: str = "r",
    acceleration: bool = True,
) -> Steps:
    """Position, velocity and, if needed, acceleration of P relative to a frame with its origin at
    ``start``, along ``axes``, where not zero; ``length`` is the unit of length.
    """
    name = body_text(P.name)
    seen = P.position(frame), P.velocity(frame), P.acceleration(frame)
    place, v, a = (x.expressed_in(axes) for x in seen)
    yield Step(r, place, length, f"position of {name} from {start}", "4.8", "4.16")
    if not is_zero(v):
        means = f"velocity of {name} as seen from {phrase}"
        yield Step("v_r", v, f"{length}/s", means, "4.8", "4.17")
    if acceleration and not is_zero(a):
        means = f"acceleration of {name} as seen from {phrase}"
        yield Step("a_r", a, f"{length}/s^2", means, "4.8", "4.18")


def motion_via(
    frame: Frame, P: Point, ground: Frame, key: str, phrase: str, start: str, moved: str = "P"
) -> Steps:
    """Rotation of the frame in ``phrase``, motion of P in it, terms of (4.17), (4.18), in m."""
    yield from turning_of(frame, ground, frame, key, f"the moving frame, fixed in {phrase},")
    yield from seen_in(frame, P, frame, "m", phrase, start)
    v, a = P.velocity(ground, via=frame), P.acceleration(ground, via=frame)
    yield from terms(v, "v_P", "m/s", "4.8")
    yield Step("v_P", v, "m/s", f"velocity of {moved} in the ground", "4.8", "4.17")
    yield from terms(a, "a_P", "m/s^2", "4.8")
    yield Step("a_P", a, "m/s^2", f"acceleration of {moved} in the ground", "4.8", "4.18")


def body(frame: Frame) -> str:
    """A frame in a sentence: "the ground", but "space"."""
    return "space" if frame.name == "space" else f"the {frame.name}"
