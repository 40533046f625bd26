"""Slips in what a problem computes: edits of its traced formulas, and the numbers they give."""
