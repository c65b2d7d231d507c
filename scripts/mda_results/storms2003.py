"""The tables of Storms & Spieksma (2003), published beside ours."""

import json
from typing import Any

import pandas as pd

from mda_results import cells, solvers, storms2003_summary
from mda_results.render import Cell, Column, Report, Table
from mda_results.rows import Run

_LONGEST_VALUE = 12  # characters of a manifest value that fit into Table 1
_UNKNOWN_SEEDS = (
    "The paper's scenarios are random draws whose seeds are not known: a single scenario of ours "
    "cannot match the paper's of the same number; only the distributions can be compared."
)


def report(run: Run) -> Report:
    """All tables; raises RunError when the run lacks what they need."""
    rows = cells.rows_of_paper(run)
    ours, paper = cells.measured(rows), cells.published()
    groups = [g for g in cells.GROUPS if (ours["group"] == g).any()]
    tables = [_parameters(run.manifest, ours)]
    tables += [_group_table(group, paper, ours) for group in groups]
    tables += storms2003_summary.tables(paper, ours, rows)
    tables += solvers.tables(rows)
    return Report("Storms & Spieksma 2003", _about(run, rows, groups), tables)


def _about(run: Run, rows: pd.DataFrame, groups: list[str]) -> list[str]:
    manifest = run.manifest
    about = [f"Run {run.name}: {len(rows)} rows, seed {rows['seed'].iloc[0]}, "
             f"driver {rows['driver'].iloc[0]}."]
    if "commit" in manifest:
        dirty = " with uncommitted changes" if manifest.get("dirty") else ""
        about.append(f"Commit {manifest['commit']}{dirty}.")
    about.append(_UNKNOWN_SEEDS)
    absent = [g for g in cells.GROUPS if g not in groups]
    if absent:
        about.append(f"Not in this run: group {', '.join(absent)}.")
    found = ", ".join(f"{g} {n}" for g, n in rows.groupby("group")["replicate"].nunique().items())
    about.append(f"Replicates in the rows: {found}.")
    other = cells.left_out(run, rows)
    return about + ([other] if other else [])


def _parameters(manifest: dict[str, Any], ours: pd.DataFrame) -> Table:
    """Table 1. A parameter that the manifest does not give under the same key has a dash; values of
    the manifest that are too long for a cell are left to the manifest."""
    published = pd.read_csv(cells.PUBLISHED / "storms2003_table_1.csv")
    scenarios = manifest.get("scenarios") or {}
    columns = [Column("parameter")]
    columns += [Column(g, block) for block in ("published", "ours") for g in cells.GROUPS]
    rows: list[list[Cell]] = []
    for _, row in published.iterrows():
        mine = [scenarios.get(g, {}).get(row["key"]) for g in cells.GROUPS]
        printed = [f"{row[g]:g}" for g in cells.GROUPS]
        rows.append([row["parameter"], *printed, *map(_compact, mine)])
    known = set(published["key"])
    further = [key for g in cells.GROUPS for key in scenarios.get(g, {}) if key not in known]
    for key in dict.fromkeys(further):
        mine = [_compact(scenarios.get(g, {}).get(key)) for g in cells.GROUPS]
        if max(len(text or "") for text in mine) <= _LONGEST_VALUE:
            rows.append([key, None, None, None, None, *mine])
    windows: list[Cell] = ["K", *("3-7" if g != "D" else "3" for g in cells.GROUPS)]
    for group in cells.GROUPS:
        ks = sorted(ours.loc[ours["group"] == group, "window_k"].unique())
        windows.append(" ".join(map(str, ks)) if ks else None)
    rows.append(windows)
    return Table("table_1", "Table 1. Parameters of the groups", columns, rows)


def _compact(value: Any) -> str | None:
    """A value of the manifest in few characters."""
    if value is None or isinstance(value, str):
        return value
    if isinstance(value, dict):
        return ", ".join(f"{key} {_compact(v)}" for key, v in value.items())
    if isinstance(value, float):
        return f"{value:g}"
    return json.dumps(value)


def _group_table(group: str, paper: pd.DataFrame, ours: pd.DataFrame) -> Table:
    """One of Tables 2 to 5: per scenario R, Delta and O for every K."""
    number = 2 + cells.GROUPS.index(group)
    sides = [("published", paper[paper["group"] == group]), ("ours", ours[ours["group"] == group])]
    printed = sides[0][1]["replicate"].max()
    replicates = sorted(set(sides[1][1]["replicate"]))
    columns = [Column("No.", once=True), Column("what")]
    lookups = []
    for block, frame in sides:
        ks = sorted(frame["window_k"].unique())
        columns += [Column(f"K={k}", block, ".3f") for k in ks]
        indexed = frame.set_index(["replicate", "window_k"])
        lookups += [(indexed, k) for k in ks]
    rows: list[list[Cell]] = []
    for replicate in range(1, printed + 1):
        for label, field in (("R", "fractional"), ("Δ", "gap_max"), ("O", "optimum")):
            values = [_cell(frame, (replicate, k), field) for frame, k in lookups]
            rows.append([cells.number_offset(group) + replicate, label, *values])
    notes = []
    if len(replicates) > printed:
        notes.append(f"Ours: the first {printed} of {len(replicates)} replicates; "
                     "the summaries below use all.")
    title = f"Table {number}. Rounding against the optimum, group {group}"
    if number == 2:
        notes.append(
            "No.: the paper's scenario number; R: windows with a fractional LP; Δ: largest cost of "
            "the rounding above the optimum, nats; O: optimum after the last scan, nats."
        )
    return Table(f"table_{number}", title, columns, rows, notes)


def _cell(frame: pd.DataFrame, key: tuple[int, int], field: str) -> Cell:
    if key not in frame.index:
        return None
    value = frame.at[key, field]
    if field == "fractional":
        return int(value) if frame.at[key, "windows"] else None
    return 0 if value == 0 else float(value)
