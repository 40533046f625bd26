"""Figures of the chapters: shown once or moved by sliders, with their alt texts; and error
messages as text.
"""
