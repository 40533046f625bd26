"""Figures to scale and animations."""
