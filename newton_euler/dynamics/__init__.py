"""Forces, constraints, Newton's and Euler's equations, work and energy (chapters 5, 6, 8, 11)."""
