"""A body sliding along i on a plate that turns about A: the welder, the rod of 2/36."""

from exercises.tools import Step, in_frame, mp, proofs, rate, rot, second_rate, terms
from newton_euler import Frame


def turning(name, omega, alpha=None):
    """Ground with z out of the plane; the plate, about A, at the instant parallel to the ground."""
    ground = Frame("ground")
    growing = {} if alpha is None else {"acceleration": alpha}
    return ground, ground.rotate(name, "z", rate=omega, **growing)


def motion(ground, P):
    """Velocity and acceleration of P, which moves in the plate, with their terms."""
    return in_frame(ground, {
        f"v_{P.name}": P.velocity(ground),
        f"a_{P.name}": P.acceleration(ground),
    })  # fmt: skip


def motion_steps(ground, P, length):
    """The quantities in (2.24) and (2.25), then the terms; ``length`` is the unit of length."""
    plate, name = P.frame, P.frame.name
    yield Step(
        f"omega_{name}", plate.angular_velocity(ground), "rad/s",
        f"angular velocity of the {name}", "2.8", "2.19",
    )  # fmt: skip
    yield Step(
        f"alpha_{name}", plate.angular_acceleration(ground), "rad/s^2",
        f"angular acceleration of the {name}", "2.10", "2.26",
    )  # fmt: skip
    yield Step("r", P.position(plate), length, f"position of {P.name} from A", "2.10", "2.23")
    yield Step(
        "v_r", P.velocity(plate), f"{length}/s",
        f"velocity of {P.name} relative to the {name}", "2.10", "2.24",
    )  # fmt: skip
    v, a = motion(ground, P).items()
    yield from terms(v[1], v[0], f"{length}/s", "2.10", "2.24")
    yield from terms(a[1], a[0], f"{length}/s^2", "2.10", "2.25")


def proof(name, plate, theta, x, y):
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


def acceleration_from(ground, P, v):
    """Acceleration from v = v_r + omega x r: a = omega x (v + v_r) + alpha x r + a_r."""
    right = motion(ground, P)
    off = ground.vector(*v) - right[f"v_{P.name}"]
    return right[f"a_{P.name}"] + P.frame.angular_velocity(ground).cross(off).expressed_in(ground)
