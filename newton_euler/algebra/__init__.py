"""Scalars of every kind, vectors, sums with named terms, linear equations, quadrature, generated code."""
