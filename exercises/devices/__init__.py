"""Devices of the book, shared by problems: frames, points, figure, and the proofs' motion."""
