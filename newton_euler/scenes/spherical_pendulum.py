"""The thin spherical pendulum: a uniform bar that hangs from a ball joint (10.4).

It is a top without a moment of inertia about its axis, I0 = m L^2/3 and I = 0. The axis k points from the joint along the bar and theta is its angle
with the *upward* vertical K, so that the bar hangs at theta = pi.
"""

from ..frames import Frame
from ..inertia import Inertia
from ..rotations import euler_frame
from .top import reduced, rolled_out, surplus


def momentum(mass, length, psi, theta, phi):
    """H about the joint, in the frame {i, j, k} that does not spin, (10.16): a Vector whose frame is the parent of that of the bar.

    psi, theta, phi : Euler angles 3-1-3, :func:`newton_euler.moving`; the spin phi has no influence
    Returns H and the frame of the bar; ``H.expressed_in(bar)`` is (10.14).

    >>> from newton_euler import moving
    >>> H, bar = momentum(3.0, 2.0, moving(0.0, rate=1.0), moving(0.5, rate=2.0), 0.3)
    >>> [round(x, 6) for x in H]
    [8.0, 1.917702, 0]
    """
    ground = Frame("ground")
    bar = euler_frame(ground, "bar", psi, theta, phi)
    I0 = mass * (length * length) / 3
    turning = bar.angular_velocity(ground).expressed_in(bar.parent)
    return Inertia(bar.origin, (I0, I0, 0), frame=bar.parent, tolerance=None).times(turning), bar


def pendulum(mass, length, g):
    """The pendulum as a Model without a singular place: :func:`newton_euler.scenes.top.rolled_out`.

    >>> pendulum(3.0, 2.0, 9.81).parameters["I0"]
    4.0
    """
    return rolled_out(mass * (length * length) / 3, 0, mass * g * length / 2, 0)


def nodding(mass, length, g, theta, precession):
    """The angle theta alone, for a start at ``theta`` (rad, from the upward vertical) with this rate psi': :func:`newton_euler.scenes.top.reduced`.

    >>> round(nodding(3.0, 2.0, 9.81, 3.0, 0.0).derivative((3.0, 0.0))[1], 6)  # falls towards theta = pi
    1.03829
    """
    I0 = mass * (length * length) / 3
    return reduced(I0, 0, mass * g * length / 2, 0, surplus(I0, 0, theta, precession, 0))
