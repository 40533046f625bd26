"""Devices of the book: frames, points, figure, and the same motion in time for proofs; each is
shared by the problems that ask about it.
"""
