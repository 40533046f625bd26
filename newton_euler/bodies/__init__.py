"""Bodies, their inertia and principal axes, solids (chapters 5 and 7)."""
