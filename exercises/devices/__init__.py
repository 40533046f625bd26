"""Devices shared by several problems: frames, points, figure, and the motion for ``prove``."""
