"""The base of all errors that the engine raises in its own words."""


class NewtonEulerError(Exception):
    """Base of the engine's errors; each is also the built-in error that fits it, as ValueError or
    TypeError.

    >>> from newton_euler import Frame, NewtonEulerError
    >>> try:
    ...     Frame("ground").point("P", 1.0, 0, 0).velocity()
    ... except NewtonEulerError as error:
    ...     print(type(error).__name__)
    FrameError
    """
