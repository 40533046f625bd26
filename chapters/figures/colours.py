"""Colours of curves and bars: three of Okabe and Ito, for the colour-blind too, and a grey."""

BLUE, ORANGE, GREEN, GREY = "#0072B2", "#D55E00", "#009E73", "#555555"
