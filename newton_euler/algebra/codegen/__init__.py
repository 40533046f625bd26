"""A formula traced once into straight-line code for floats, arrays and heyoka."""
