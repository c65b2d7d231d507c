"""Figures 4 and 6 to 9 of Lee & Jeong (1998), and track maintenance over clutter, from a run."""

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

import numpy as np
import pandas as pd

from mda_results import bootstrap, plotting
from mda_results.lee_tables import KEPT, percent, published
from mda_results.outings import true_paths_km
from mda_results.palette import REFERENCES, style_of
from mda_results.position_targets import (DENSITIES, LAWS, ORACLE, PAIRS, PositionRun, finished,
                                          tracks_of)
from mda_results.rows import RunError

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

_GATE_KM = 0.15 * 9.21**0.5  # sigma of a plot, root of the gate: of a prediction without error
_HEADINGS_DEG = (0, 45, 100)
_IN_TIME = (ORACLE, "jpda", "gnn", "hnpda", "mapada")  # the last on top
_SAMPLES = ("hnpda", "mapada")  # of the paper
_MARGIN_KM = 1.0
_ASIDE = 0.05  # by how much points of one density are moved apart
_MARK_EVERY = 5  # scans

Draw = Callable[[], "Figure"]


def figures(run: PositionRun) -> dict[str, Draw]:
    """How to draw each figure, by file name; drawing raises RunError if the run lacks its part."""
    drawn: dict[str, Draw] = {"figure_4": _distance_profile}
    for number, scene in ((6, "crossing"), (8, "parallel")):
        drawn[f"figure_{number}"] = lambda s=scene: _sample(run, s)
        drawn[f"figure_{number + 1}"] = lambda s=scene: _errors(run, s)
    for field in KEPT:
        drawn[f"maintenance{field.removeprefix('kept')}"] = lambda f=field: _maintenance(run, f)
    return drawn


def squared_distance(x: Any, y: Any, vx: float, vy: float) -> Any:
    """Equation (3): of a measurement at (x, y) from the line through the gate's centre, which is
    the origin, along the velocity. In the square of the unit of x and y."""
    return (x * vy - y * vx) ** 2 / (vx**2 + vy**2)


def _distance_profile() -> "Figure":
    """Analytic; no run is needed for it."""
    plt = plotting.pyplot()
    figure, axes = plt.subplots(1, len(_HEADINGS_DEG), figsize=(11.5, 4.2), sharey=True,
                                layout="constrained")
    x, y = np.meshgrid(*2 * [np.linspace(-_GATE_KM, _GATE_KM, 241)])
    levels = np.linspace(0, _GATE_KM**2, 12)
    for axis, heading in zip(axes, _HEADINGS_DEG):
        vx, vy = np.cos(np.radians(heading)), np.sin(np.radians(heading))
        inside = np.hypot(x, y) <= _GATE_KM
        shown = np.ma.masked_where(~inside, squared_distance(x, y, vx, vy))
        filled = axis.contourf(x, y, shown, levels=levels, cmap="viridis")
        axis.add_patch(plt.Circle((0, 0), _GATE_KM, fill=False, linewidth=1.2))
        axis.annotate("", (0.8 * _GATE_KM * vx, 0.8 * _GATE_KM * vy), (0, 0),
                      arrowprops={"arrowstyle": "-|>", "color": "white", "linewidth": 2})
        axis.set(title=f"velocity at {heading}°", xlabel="x from the gate's centre [km]")
        axis.set_aspect("equal")
        axis.grid(False)
    axes[0].set_ylabel("y from the gate's centre [km]")
    figure.colorbar(filled, ax=axes, label="squared distance, equation (3) [km²]", format="%.2f")
    figure.suptitle("Figure 4: the distance is blind along the velocity; the smallest gate, "
                    f"{_GATE_KM:.2f} km")
    return figure


def _fitted(run: PositionRun, scene: str, algorithms: tuple[str, ...]) -> pd.DataFrame:
    """Finished outings of a scene in normal clutter at the least density."""
    own = finished(run.outings)
    own = own[(own["scene"] == scene) & (own["law"] == "normal")
              & (own["density"] == DENSITIES[0]) & own["algorithm"].isin(algorithms)]
    if own.empty:
        raise RunError(f"{run.name} has no finished outings of {' or '.join(algorithms)} on the "
                       f"{scene} targets in normal clutter of {DENSITIES[0]:g} per km^2")
    return _one_update(own)


def _one_update(own: pd.DataFrame) -> pd.DataFrame:
    """A run has one update; were there more, the last in the alphabet: soft."""
    return own[own["update"] == own["update"].max()]


def _told_update(own: pd.DataFrame) -> str:
    """How marginals move a track."""
    return f"marginals {own['update'].iloc[0]}"


def _sample(run: PositionRun, scene: str) -> "Figure":
    """Truth and tracks of the first run that all have finished."""
    own = _fitted(run, scene, _SAMPLES)
    scenario = own["scenario"].iloc[0]
    truth = true_paths_km(run.trajectories, scenario, run.name)
    if truth is None:
        raise RunError(f"{run.name} has no trajectories of {scenario} in a trajectories.json")
    lines = {a: part.set_index("replicate") for a, part in own.groupby("algorithm")}
    shared = set.intersection(*(set(part.index) for part in lines.values()))
    if not shared:
        raise RunError(f"{run.name} has no run of {scenario} that {' and '.join(lines)} finished")
    replicate = min(shared)
    figure, axes, legend = plotting.with_legend_row(
        1, len(lines), (5.2 * len(lines), 5.6), 0.5, sharex=True, sharey=True)
    for axis, (algorithm, part) in zip(axes[0], lines.items()):
        _draw_tracks(axis, part.loc[replicate], str(algorithm), truth)
        axis.set(title=algorithm, xlabel="x [km]")
    axes[0][0].set_ylabel("y [km]")
    every = np.concatenate(truth)
    low, high = every.min(axis=0) - _MARGIN_KM, every.max(axis=0) + _MARGIN_KM
    axes[0][0].set(xlim=(low[0], high[0]), ylim=(low[1], high[1]))
    plotting.add_legend(legend, axes[0], 3)
    figure.suptitle(f"Sample of the {scene} targets: run {replicate}, C = {DENSITIES[0]:g}/km², "
                    f"normal clutter, {_told_update(own)}")
    return figure


def _draw_tracks(axis: "Axes", outing: pd.Series, algorithm: str,
                 truth: list[np.ndarray]) -> None:
    style = style_of(algorithm)
    for path in truth:
        axis.plot(path[:, 0], path[:, 1], color="#777777", linewidth=1.1, label="truth")
    for n, (track, dropped) in enumerate(zip(outing["track_series_km"], outing["dropped"])):
        axis.plot(track[:, 0], track[:, 1], linewidth=1.2, linestyle=("-", "--")[n % 2],
                  **style.point(), markersize=3.5,
                  label=f"{algorithm}, track {outing['targets'][n]}"
                  + (" (dropped)" if dropped else ""))


def _errors(run: PositionRun, scene: str) -> "Figure":
    """Root of the mean square over runs and tracks, scan by scan, of kept tracks and of all."""
    own = _fitted(run, scene, _IN_TIME)
    figure, axes, legend = plotting.with_legend_row(2, 2, (10.5, 7.0), 0.5, sharex=True)
    panels = (("position_error_series_km", "position error [km]"),
              ("velocity_error_series_km_s", "velocity error [km/s]"))
    for line, (field, label) in zip(axes, panels):
        for axis, only_kept in zip(line, (True, False)):
            for algorithm in _IN_TIME:
                part = own[own["algorithm"] == algorithm]
                if len(part):
                    _band(axis, part, field, only_kept, algorithm, scene)
            axis.set_ylabel(f"rms {label}")
        line[0].set_ylim(bottom=0)
        line[1].set_yscale("log")
    axes[0][0].set_title("tracks kept within 0.45 km")
    axes[0][1].set_title("all tracks, dropped ones coasting")
    for axis in axes[1]:
        axis.set_xlabel("time [s]")
    plotting.add_legend(legend, axes[0], len(_IN_TIME))
    runs = own["replicate"].nunique()
    over = f"bands: 95 % over {runs} runs" if runs > 1 else "one run"
    figure.suptitle(f"rms errors of the {scene} targets, C = {DENSITIES[0]:g}/km², normal clutter, "
                    f"{_told_update(own)}; {over}")
    return figure


def _band(axis: "Axes", part: pd.DataFrame, field: str, only_kept: bool, algorithm: str,
          scene: str) -> None:
    scans = int(part["scans"].min())
    chosen = [np.array(kept, dtype=float) if only_kept else np.ones(len(kept))
              for kept in part["maintained_450m"]]
    counts = np.array([mask.sum() for mask in chosen])
    if not counts.any():
        return
    squares = np.array([mask @ series[:, :scans] ** 2
                        for mask, series in zip(chosen, part[field])])
    band = bootstrap.ratio_band(scene, squares, counts, np.sqrt)
    times = 1.0 + np.arange(scans)
    look = _look(algorithm)
    axis.fill_between(times, band.low, band.high, color=look["color"], alpha=0.15, linewidth=0)
    axis.plot(times, band.mean, label=algorithm, markevery=_MARK_EVERY, **look)


def _look(algorithm: str) -> dict[str, Any]:
    return (REFERENCES[algorithm] if algorithm == ORACLE else style_of(algorithm)).line()


def _maintenance(run: PositionRun, field: str) -> "Figure":
    """Share of kept tracks over density, by clutter law, of both scenes and of each."""
    tracks = tracks_of(_one_update(run.outings))
    tracks = tracks[tracks["scene"].isin(PAIRS)]
    if tracks.empty:
        raise RunError(f"{run.name} has no finished outings of crossing or parallel targets")
    laws = [law for law in LAWS if (tracks["law"] == law).any()]
    figure, axes, legend = plotting.with_legend_row(
        len(laws), 3, (13.0, 3.9 * len(laws) + 1.2), 1.0, sharex=True, sharey=True)
    for line, law in zip(axes, laws):
        own = tracks[tracks["law"] == law]
        for axis, scenes in zip(line, (PAIRS, *((s,) for s in PAIRS))):
            _draw_shares(axis, own[own["scene"].isin(scenes)], field)
            axis.set_title(f"{' and '.join(scenes)}; {LAWS[law]}", fontsize=9)
        if law == "normal":
            _draw_published(line[0])
        line[0].set_ylabel(f"tracks kept within {KEPT[field]} [%]")
    for axis in axes[-1]:
        axis.set(xlabel="clutter density [1/km²]", xticks=DENSITIES)
    axes[0][0].set_ylim(-3, 103)
    plotting.add_legend(legend, axes.flat, 6)
    figure.suptitle(f"Track maintenance, {_told_update(tracks)}; bars: 95 % over runs")
    return figure


def _draw_shares(axis: "Axes", tracks: pd.DataFrame, field: str) -> None:
    offsets = np.linspace(-_ASIDE, _ASIDE, max(2, tracks["algorithm"].nunique()))
    for offset, (algorithm, own) in zip(offsets, tracks.groupby("algorithm", sort=False)):
        points = [(d + offset, percent(at, field)) for d, at in own.groupby("density", sort=True)]
        plotting.draw_points(axis, points, label=str(algorithm), elinewidth=0.7,
                             **_look(str(algorithm)))


def _draw_published(axis: "Axes") -> None:
    for algorithm in _SAMPLES:
        shares = [published(3, d, "maintenance_pct", algorithm) for d in DENSITIES]
        style = style_of(algorithm)
        axis.plot(DENSITIES, shares, linestyle="none", marker=style.marker, markersize=11,
                  markerfacecolor="none", markeredgecolor=style.color, markeredgewidth=2, zorder=5,
                  label=f"{algorithm}, paper")
