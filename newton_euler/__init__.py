"""Newton-Euler dynamics of particles and rigid bodies in three dimensions for teaching and work.

>>> from newton_euler import Frame
>>> ground = Frame("ground")
>>> shaft = ground.rotate("shaft", "z", rate=0.6)
>>> print(shaft.point("P", 2.0, 0, 0).acceleration(ground))
[-0.72, 0, 0] in shaft

A name is imported from its room when it is first asked for, so that ``import newton_euler`` costs
next to nothing.
"""

from importlib import import_module

__version__ = "0.2.0"

# The names at the top, by the room that they come from; __init__.pyi says the same to type
# checkers.
# All other public names are imported from their room: from newton_euler.dynamics import weight
_NAMES = {
    "algebra": """Dimension NewtonEulerError Vector acos asin at atan atan2 compiled cos cosh cross
        dot exp integral log moving pi radians root sin sinh solve_linear solve_rates sqrt table
        tan tanh unit where""",
    "kinematics": """Frame Point axis_angle cylindrical euler_frame frenet polar quaternion
        rotation_matrix spherical""",
    "bodies": "Body Inertia centre_of_mass composite particle",
    "dynamics": "Couple Force ForceSystem equations_of_motion kinetic_energy work_along",
    "motion": "Event Model integrate prepare",
    "scenes": "smallest",
}
ROOMS = {*_NAMES, "accuracy", "answers", "applications", "classroom", "drawing"}
_ROOM_OF = {name: room for room, names in _NAMES.items() for name in names.split()}
__all__ = sorted(_ROOM_OF)


def __getattr__(name):
    if name in ROOMS:
        return import_module(f"{__name__}.{name}")
    if name not in _ROOM_OF:
        import_module(f"{__name__}.algebra.names").unknown(__name__, name)
    value = globals()[name] = getattr(import_module(f"{__name__}.{_ROOM_OF[name]}"), name)
    return value


def __dir__():
    return sorted({*globals(), *__all__, *ROOMS})
