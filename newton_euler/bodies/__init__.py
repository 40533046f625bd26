"""Bodies, their inertia and principal axes, solids (chapters 5 and 7)."""

from ..algebra.names import guide as _guide
from .admissibility import MassError
from .body import Body, centre_of_mass, composite, particle
from .inertia import Inertia
from .parametric import integrated
from .principal_axes import Principal, Symmetry
from .solids import (
    annulus,
    arc,
    box,
    cone,
    cylinder,
    cylindrical_shell,
    disk,
    ellipsoid,
    half_disk,
    half_ring,
    hemisphere,
    plate,
    ring,
    rod,
    sector,
    simplex,
    sphere,
    spherical_shell,
    tube,
    wedge,
)

_guide(__name__)
