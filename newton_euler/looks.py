"""How a stroke looks: its colours, line widths and dashes, by name; a stroke may have several looks, one over the other."""

# colours that colour-blind readers tell apart (Okabe and Ito); bodies are grey
KINDS = {"velocity": "#0072B2", "acceleration": "#D55E00", "rate": "#008060", "force": "#B0408A", "plain": "#000000"}
DARK, MIDDLE, LIGHT, PALE, BLACK, WHITE = "#454a50", "#c9ced4", "#dde1e5", "#eef0f2", "#000000", "#ffffff"
DASHES = {"solid": "-", "dashed": (0, (5, 3)), "dotted": (0, (1, 2)), "centre": (0, (9, 2.5, 2, 2.5))}
FONT = 11  # points

BODY, MARK, ARROW = range(3)  # layers: bodies cover each other by depth; marks and then arrows lie over them


def _look(edge, width, face="none", dashes="solid", ends="round"):
    """The arguments of a matplotlib patch; ``width`` in points. The names are whole, since matplotlib is slower with short ones."""
    return {"edgecolor": edge, "facecolor": face, "linewidth": width, "linestyle": DASHES[dashes], "capstyle": ends, "joinstyle": "round"}


LOOKS = {
    "thin": _look(DARK, 0.9),
    "body": _look(DARK, 1.1, LIGHT),
    "side": _look(DARK, 1.1, MIDDLE),
    "top": _look(DARK, 1.1, PALE),
    "seam": _look(DARK, 0.7),
    "ring": _look(DARK, 1.4),
    "rod edge": _look(DARK, 5.6),
    "rod": _look(LIGHT, 3.6),
    "shaft edge": _look(DARK, 9.5, ends="butt"),
    "shaft": _look(LIGHT, 7.5, ends="butt"),
    "centre": _look(DARK, 0.7, dashes="centre", ends="butt"),
    "cable": _look(DARK, 1.4),
    "spring": _look(DARK, 1.2),
    "patch": _look("none", 0, "#f1ede4"),
    "support": _look(DARK, 1.3),
    "tip": _look(WHITE, 1.5, WHITE),
    "joint": _look(BLACK, 1.2, WHITE),
    "dot": _look(BLACK, 0.5, BLACK),
    "axis": _look(BLACK, 1.0, BLACK),
    "measure": _look(BLACK, 0.7, BLACK),
    "path": _look("#6b6f75", 1.1),
    **{f"line {name}": _look(DARK, 0.9, dashes=name, ends="butt") for name in DASHES},
    **{kind: _look(colour, 1.8, colour) for kind, colour in KINDS.items()},
}
