"""Scenes of bodies in space."""
