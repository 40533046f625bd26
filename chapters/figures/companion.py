"""The figure of the companion on speed and accuracy."""

from collections.abc import Callable, Mapping, Sequence

from newton_euler.algebra.late import plt
from newton_euler.classroom import show_figure
from newton_euler.motion.solution import Motion


def satellite(
    runs: Mapping[str, Sequence[Motion]], off: Callable[[Motion], float], needed: float
) -> None:
    """Figure 0.1: how far off, in metres, the runs of each method are, by their calls of the
    right-hand side; ``needed`` is drawn as a line.
    """
    fig, ax = plt.subplots(figsize=(6.4, 3.8))
    for (name, found), mark in zip(runs.items(), "os^D", strict=True):
        calls, errors = [run.cost.calls for run in found], [off(run) for run in found]
        ax.loglog(calls, errors, mark + "-", label=name)
    ax.axhline(needed, color="black", ls="--", lw=1)
    ax.set(xlabel="calls of the right-hand side", ylabel="error after a day (m)")
    ax.legend(frameon=False, fontsize=9)
    show_figure(
        fig,
        alt="The error of a satellite's position after a day against the calls of the right-hand "
        "side, both on logarithmic scales. The lines of four methods fall, the more steeply the "
        "higher their order; that of dop853 lies lowest to the left, Verlet's does not reach the "
        "dashed line.",
    )
