"""Tests with a method= are skipped where its library is not installed."""

import pytest


@pytest.fixture(autouse=True)
def library(request):
    """heyoka, for the method of Taylor series."""
    parameters = getattr(getattr(request.node, "callspec", None), "params", {})
    method = parameters.get("method") or getattr(parameters.get("case"), "method", "")
    if method == "taylor":
        pytest.importorskip("heyoka")
