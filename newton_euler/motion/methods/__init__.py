"""Methods of integration: steppers, and the table that lists them."""
