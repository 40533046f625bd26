"""Costs and true errors: of methods of integration, of textbook methods, over parameter space."""
