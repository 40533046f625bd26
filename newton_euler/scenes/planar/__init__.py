"""Scenes of bodies in the plane."""
