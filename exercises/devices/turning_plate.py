"""A body sliding along i on a plate that turns about A: the welder, the rod of 2/36."""

from exercises.annotations import Answers, Coordinate, Scalar, Steps
from exercises.tools import Step, in_frame, mp, proofs, rate, rot, second_rate, terms
from newton_euler import Frame, Point, Vector


def turning(name: str, omega: Scalar, alpha: Scalar = 0) -> tuple[Frame, Frame]:
    """Ground with z out of the plane; the plate, about A, at the instant parallel to the ground."""
    ground = Frame("ground")
    return ground, ground.rotate(name, "z", rate=omega, acceleration=alpha)


def motion(ground: Frame, P: Point) -> Answers:
    """Velocity and acceleration of P, which moves in the plate, with their terms."""
    v, a = P.velocity(ground), P.acceleration(ground)
    return in_frame(ground, {f"v_{P.name}": v, f"a_{P.name}": a})


def motion_steps(ground: Frame, P: Point, length: str) -> Steps:
    """The quantities in (2.24) and (2.25), then the terms; ``length`` is the unit of length."""
    plate, name = P.frame, P.frame.name
    omega, alpha = plate.angular_velocity(ground), plate.angular_acceleration(ground)
    means = f"angular velocity of the {name}"
    yield Step(f"omega_{name}", omega, "rad/s", means, "2.8", "2.19")
    means = f"angular acceleration of the {name}"
    yield Step(f"alpha_{name}", alpha, "rad/s^2", means, "2.10", "2.26")
    yield Step("r", P.position(plate), length, f"position of {P.name} from A", "2.10", "2.23")
    means = f"velocity of {P.name} relative to the {name}"
    yield Step("v_r", P.velocity(plate), f"{length}/s", means, "2.10", "2.24")
    v, a = motion(ground, P).values()
    yield from terms(v, f"v_{P.name}", f"{length}/s", "2.10", "2.24")
    yield from terms(a, f"a_{P.name}", f"{length}/s^2", "2.10", "2.25")


def proof(name: str, plate: str, theta: Coordinate, x: Coordinate, y: Coordinate) -> Answers:
    """Proof by the explicit path; ``theta``, ``x`` and ``y`` are functions of time."""

    def P(t):
        c, s = mp.cos(theta(t)), mp.sin(theta(t))
        return [x(t) * c - y(t) * s, x(t) * s + y(t) * c, 0]

    turned = lambda t: rot("z", theta(t))
    return {
        f"v_{name}": rate(P),
        f"a_{name}": second_rate(P),
        f"omega_{plate}": proofs.angular_velocity(turned),
        f"alpha_{plate}": proofs.angular_acceleration(turned),
        "r": P(0),
        "v_r": rate(lambda t: [x(t), y(t), 0]),
    }


def acceleration_from(ground: Frame, P: Point, v: Vector) -> Vector:
    """Acceleration from v = v_r + omega x r: a = omega x (v + v_r) + alpha x r + a_r."""
    right = motion(ground, P)
    off = ground.vector(*v) - right[f"v_{P.name}"]
    return right[f"a_{P.name}"] + P.frame.angular_velocity(ground).cross(off).expressed_in(ground)
