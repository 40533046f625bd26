"""Figures of the chapters, shown once or moved by sliders; error messages as text."""
