"""Reads what a student gives as an answer: numbers, vectors, formulas of SymPy."""
