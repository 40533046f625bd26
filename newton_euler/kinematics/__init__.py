"""Frames and points, rotations, coordinates, paths (chapters 2 to 4)."""
