"""One file for each kind of chart: what is drawn, and what its caption says."""
