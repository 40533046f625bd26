"""Scenes of one particle."""
