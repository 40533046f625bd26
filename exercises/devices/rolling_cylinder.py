"""A homogeneous cylinder or disk that rolls or slips along a surface or a thread: 8/7, 8/8, 8/9.

Axes: x along the surface, y out of it, z = x cross y; the contact C is at -r y from the centre.
``a`` is the acceleration of the centre along x, ``alpha`` the angular acceleration about z, ``F``
and ``N`` the forces of the surface on the body along x and y.
"""

from collections.abc import Callable, Sequence

from exercises.annotations import Number, Points, Scalar
from exercises.tools import disk as points_of_disk
from exercises.tools import plus, rot, times
from newton_euler import Body, Frame, equations_of_motion, moving, solve_linear
from newton_euler.algebra import Solution
from newton_euler.bodies import disk


def rolls(
    m: Scalar,
    r: Scalar,
    gravity: Sequence[Scalar],
    surface: Scalar = 0,
    shape: Callable[..., Body] = disk,
    no_slip: Callable[[Scalar, Scalar], Scalar] | None = None,
) -> Solution:
    """a, alpha, F and N without slip: a solution of ``solve_linear``.

    gravity : components of the acceleration of gravity along x and y
    surface : acceleration of the surface along x
    no_slip : a wrong condition of a and alpha, instead of the right one
    """

    def laws(a, alpha, F, N):
        equations, a_C = _equations(m, r, gravity, shape, a, alpha, F, N)
        return equations | {"no slip": no_slip(a, alpha) if no_slip else a_C - surface}

    return solve_linear(laws)


def slips(m: Scalar, r: Scalar, gravity: Sequence[Scalar], f: Scalar) -> Solution:
    """a, alpha and N with the friction f N, along x."""
    return solve_linear(lambda a, alpha, N: _equations(m, r, gravity, disk, a, alpha, f * N, N)[0])


def _equations(m, r, gravity, shape, a, alpha, F, N):
    """Newton's and Euler's equations, and the x acceleration of the body at the contact."""
    ground = Frame("ground")
    G = ground.point("G", moving(0 * r, rate=0, acceleration=a), 0, 0)
    frame = ground.rotate("cylinder", "z", acceleration=alpha, origin=G)
    body, C = shape(r, frame, "z", mass=m, name="cylinder"), frame.point("C", 0, -r, 0)
    forces = {
        "weight": (m * ground.vector(*gravity, 0), body.centre),
        "contact": (ground.vector(F, N, 0), C),
    }
    a_C = C.acceleration(ground).expressed_in(ground).x
    return equations_of_motion(body, forces, ground), a_C


def rolled(r: Number, q: Number) -> Points:
    """Proof: the mass points when the centre has moved by q, on a surface at rest."""
    turned = rot("z", -q / r)
    return [(u, plus([q, 0, 0], times(turned, p))) for u, p in points_of_disk(r, order=2)]
