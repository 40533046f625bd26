"""Models and the integration of their motion."""
