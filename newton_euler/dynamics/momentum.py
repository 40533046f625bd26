"""Angular momentum and the moment equation (7.1, 8.1-8.3, 8.7): forces and moments from a motion,
and the motion from them.

For every point B, however it moves, with the *relative* angular momentum H_B of (7.6) and d from B
to the centre of mass G,

    M_B = DH_B/Dt + d x m a_B                                                    (8.9), (8.21)

D/Dt is the rate seen from an inertial frame, the ``observer`` here; by way of any frame that turns
with Omega it is dH/dt + Omega x H, which is (8.12) for the frame of the body. The last term
vanishes for B = G (8.10), for B at rest or at constant velocity (8.11), and for d along a_B.

*Motion given, which forces?* :func:`newton_euler.dynamics.newton.resultant_force` and
:func:`resultant_moment`. *Forces given?* :func:`equations_of_motion` writes (8.21) for
:func:`newton_euler.solve_linear`. Units: any consistent ones; in SI kg, m, s, N.
"""

from ..algebra.errors import checked, checked_but
from ..algebra.ledger import Ledger, Terms
from ..algebra.vectors import ZERO3, Vector
from ..bodies.body import Body
from ..kinematics.frames import Frame, Point, as_point
from .force_systems import ForceSystem, Parts
from .newton import resultant_force


@checked
def angular_momentum(body: Body, observer: Frame, about: Point | Frame | None = None) -> Vector:
    """The relative angular momentum H of a body (7.6), a Vector that knows its rate; kg m^2/s.

    about : G (default), a Point fixed in the body, in the ground, or moving in any way, or a Frame
        for its origin
    About a point of the body it is I omega with the matrix about that point (7.12); about another
    H_G + d x m Dd/Dt (7.23), the terms of :meth:`newton_euler.bodies.body.Body.angular_momentum`.

    >>> from newton_euler import Frame
    >>> from newton_euler.bodies.solids import rod
    >>> ground = Frame("ground")
    >>> turning = ground.rotate("turning", "z", rate=2.0)
    >>> bar = rod(2.0, turning.point("G", 1.0, 0, 0), "x", mass=3.0)
    >>> angular_momentum(bar, ground, about=turning).z  # m L^2/3 omega
    8.0
    """
    B = _point(body, about)
    if B is not body.centre and _is_fixed(B, body):
        return body.about(B).times(body.frame.angular_velocity(observer))
    return body.angular_momentum(observer, B)


def _point(body, about):
    return body.centre if about is None else as_point(about, "the point that the moment is about")


def _is_fixed(point, body):
    """True if the point and the centre of mass are given as fixed in the frame of the body."""
    return all(P.frame is body.frame and all(x.rests() for x in P.x) for P in (point, body.centre))


@checked
def resultant_moment(
    body: Body, observer: Frame, about: Point | Frame | None = None, via: Frame | None = None
) -> Vector:
    """The moment of all external forces, from the motion: (8.9), (8.10), (8.11), (8.12); N m.

    observer : an inertial frame
    about : G (default), or any Point B, however it moves, or a Frame for its origin
    via : the frame in which H is differentiated, and of the result; default: that of the body
    terms : ``relative``, the rate of H seen in ``via``; ``rotation``, omega x H with the omega of
        ``via``; unless about G, ``reference``, d x m a_B

    >>> from newton_euler import Frame
    >>> from newton_euler.bodies.solids import rod
    >>> ground = Frame("ground")
    >>> turning = ground.rotate("turning", "z", rate=2.0, acceleration=5.0)
    >>> bar = rod(2.0, turning.point("G", 1.0, 0, 0), "x", mass=3.0)
    >>> resultant_moment(bar, ground, about=turning).z
    20.0
    """
    about, via = _point(body, about), via or body.frame
    seen = f"seen from {observer.name}, by way of {via.name}"
    if about is body.centre:
        rate = angular_momentum(body, observer).expressed_in(via).rate(observer)
        kind = "moment about the centre of mass"
        return rate.as_sum(kind, f"of {body.name}, {seen}", lambda: _rate_terms(rate, observer))
    route = _about_fixed_point if _is_fixed(about, body) else _about_any_point
    total, terms = route(body, observer, about, via)
    ledger = Ledger("moment", f"of {body.name} about {about.name}, {seen}", terms)
    return Vector(total.c, via, None, ledger)


def _about_fixed_point(body, observer, B, via):
    """The moment and its terms about a point fixed in the body, with H_B = I_B omega."""
    rate = angular_momentum(body, observer, B).expressed_in(via).rate(observer)
    reference = _arm_times_mass(body, B, via, B.acceleration(observer))
    return rate + reference, lambda: {**_rate_terms(rate, observer), "reference": reference}


def _about_any_point(body, observer, B, via):
    """The moment and its terms; in the sum DH_G/Dt + d x m a_G the motion of B cancels."""
    own = angular_momentum(body, observer).expressed_in(via).rate(observer)
    a = body.centre.acceleration(observer)

    def terms():
        rotation = via.angular_velocity(observer).cross(angular_momentum(body, observer, B))
        a_B = B.acceleration(observer)
        reference = _arm_times_mass(body, B, via, a_B)
        orbital = _arm_times_mass(body, B, via, a.expressed_in(via) - a_B)
        return {"relative": own + orbital - rotation, "rotation": rotation, "reference": reference}

    return own + _arm_times_mass(body, B, via, a), terms


def _arm_times_mass(body, B, via, a):
    """d x m a."""
    return (body.centre - B).expressed_in(via).cross(a * body.mass)


def _rate_terms(rate, observer):
    """The terms ``relative`` and ``rotation`` of a rate; seen from its own frame nothing turns."""
    if rate.frame is observer:
        return {"relative": Vector(rate.c, observer), "rotation": Vector(ZERO3, observer)}
    return dict(rate.terms)


@checked_but("forces")
def equations_of_motion(
    body: Body, forces: ForceSystem | Parts, observer: Frame, about: Point | Frame | None = None
) -> Terms[Vector]:
    """The Newton-Euler equations (8.21) of one body, as Vectors that must vanish: for
    :func:`newton_euler.algebra.linear.solve_linear`.

    forces : all external forces, a :class:`.ForceSystem` or the parts of one, as {"pin": (R, P)};
        they and the motion of the body may hold unknowns
    about : G (default), or any Point; a point where unknown forces act keeps them out of the moment
        equation
    Returns a dict of two Vectors in the frame of ``observer``, "force on beam" and "moment on beam
    about G", each the forces' part less that of the motion. The equations of several bodies are
    joined as first | second, which keeps all of them where bodies share a name.

    >>> from newton_euler import Frame, solve_linear
    >>> from newton_euler.bodies.solids import rod
    >>> ground = Frame("ground")
    >>> def beam_let_go(R, alpha):  # 6 kg and 2 m, pinned at its end, released at this instant
    ...     turned = ground.rotate("beam", "z", acceleration=alpha)
    ...     beam = rod(2.0, turned.point("G", 1.0, 0, 0), "x", mass=6.0)
    ...     weight, pin = ground.vector(0, -60.0, 0), ground.vector(0, R, 0)
    ...     forces = {"weight": (weight, beam.centre), "pin": (pin, ground)}
    ...     return equations_of_motion(beam, forces, ground)
    >>> s = solve_linear(beam_let_go)
    >>> round(s.R, 12), round(s.alpha, 12)
    (15.0, -7.5)
    """
    if not isinstance(forces, ForceSystem):
        forces = ForceSystem(forces, observer)
    about = _point(body, about)
    motion = resultant_force(body.mass, body.centre.acceleration(observer))
    force = forces.force.expressed_in(observer) - motion
    moment = forces.moment(about).expressed_in(observer) - resultant_moment(body, observer, about)
    names = f"force on {body.name}", f"moment on {body.name} about {about.name}"
    return Terms(zip(names, (force, moment), strict=True))
