"""What the figures share: matplotlib without a display, and how they are written."""

from collections.abc import Iterable
from pathlib import Path
from types import ModuleType
from typing import TYPE_CHECKING, Any

import numpy as np

from mda_results.render import Estimate
from mda_results.rows import RunError

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

_DPI = 130


def pyplot() -> ModuleType:
    """matplotlib.pyplot, set up; raises RunError if it is not installed."""
    try:
        import matplotlib
    except ImportError:
        raise RunError("figures need the package python3-matplotlib") from None
    matplotlib.use("Agg")
    import matplotlib.pyplot as plt

    # Texts stay texts, and the same run gives the same file.
    plt.rcParams.update({"svg.fonttype": "none", "svg.hashsalt": "mda", "axes.grid": True,
                         "grid.alpha": 0.3, "axes.spines.top": False, "axes.spines.right": False,
                         "axes.axisbelow": True, "font.size": 10, "legend.frameon": False})
    return plt


def save(figure: "Figure", name: str, directory: Path) -> list[Path]:
    """Writes NAME.svg and NAME.png and closes the figure."""
    written = []
    for ending, about in (("svg", {"Date": None}), ("png", {})):
        written.append(directory / f"{name}.{ending}")
        figure.savefig(written[-1], dpi=_DPI, metadata=about)
    pyplot().close(figure)
    return written


def with_legend_row(rows: int, columns: int, size: tuple[float, float], legend_inches: float,
                    **options: Any) -> tuple["Figure", np.ndarray, "Axes"]:
    """A figure with a grid of axes and, under them, an empty one for add_legend()."""
    plt = pyplot()
    figure = plt.figure(figsize=size, layout="constrained")
    upper, lower = figure.subfigures(
        2, 1, height_ratios=[size[1] - legend_inches, legend_inches])
    axes = upper.subplots(rows, columns, squeeze=False, **options)
    legend = lower.subplots()
    legend.axis("off")
    return figure, axes, legend


def add_legend(legend: "Axes", axes: Iterable["Axes"], columns: int) -> None:
    """One legend for all axes, without repeats."""
    entries: dict[str, Any] = {}
    for axis in axes:
        entries.update({label: handle for handle, label in zip(*axis.get_legend_handles_labels())})
    legend.legend(entries.values(), entries.keys(), loc="center", ncol=columns)


def draw_points(axis: "Axes", points: list[tuple[float, Estimate | None]], **look: Any) -> None:
    """A line through estimates with bars for their intervals; what is None is left out."""
    known = [(x, e) for x, e in points if e is not None]
    if not known:
        return
    values = np.array([e.value for _, e in known])
    low = np.array([e.value if e.low is None else e.low for _, e in known])
    high = np.array([e.value if e.high is None else e.high for _, e in known])
    bars = np.maximum(0.0, [values - low, high - values])
    axis.errorbar([x for x, _ in known], values, yerr=bars, capsize=2, **look)
