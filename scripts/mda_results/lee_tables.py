"""Tables 3 and 4 of Lee & Jeong (1998) rebuilt, crossing and parallel targets apart, and costs."""

from collections.abc import Iterator
from functools import cache
from typing import cast

import numpy as np
import pandas as pd

from mda_results import bootstrap
from mda_results.cells import PUBLISHED
from mda_results.position_targets import DENSITIES, LAWS, PAIRS, finished, tracks_of
from mda_results.render import Cell, Column, Estimate, Table

KEPT = {"kept_450m": "0.45 km", "kept_750m": "0.75 km"}
_ENTRY = ["algorithm", "update"]
_WHO = [Column("algorithm"), Column("update")]
_QUANTITIES = {"position": ("km", ".3f"), "velocity": ("km_s", ".3f")}
_TARGETS = range(1, 11)


def tables(outings: pd.DataFrame) -> list[Table]:
    """Of outings without echoes; those for which there are none are left out."""
    tracks = tracks_of(outings)
    made: list[Table] = []
    for law in LAWS:
        own = tracks[tracks["law"] == law]
        pairs = own[own["scene"].isin(PAIRS)]
        if len(pairs):
            made += [_maintenance(pairs, outings, law), _errors(pairs, law, "position"),
                     _errors(pairs, law, "velocity"), _apart(pairs, outings, law)]
    ten = tracks[tracks["scene"] == "ten"]
    made += _ten(ten) if len(ten) else []
    return [*made, _costs(finished(outings))] if len(tracks) else made


def percent(frame: pd.DataFrame, field: str) -> Estimate | None:
    """Mean over the tracks in percent, with its interval over runs."""
    return bootstrap.ratio(frame, field, "one", lambda x: 100 * x)


def rms(tracks: pd.DataFrame, field: str) -> Estimate | None:
    """Root of the mean square over all scans of all these tracks; `field` is one of SQUARES."""
    return bootstrap.ratio(tracks, field, "scans", np.sqrt)


def _root(tracks: pd.DataFrame, field: str) -> float | None:
    """rms() without its interval."""
    if tracks.empty:
        return None
    return float(np.sqrt(tracks[field].sum() / tracks["scans"].sum()))


@cache
def published_table(number: int) -> pd.DataFrame:
    """Table 3 by clutter density, or Table 4 by target."""
    name = {3: "table_3_crossing_parallel", 4: "table_4_ten_targets"}[number]
    return pd.read_csv(PUBLISHED / f"lee1998_{name}.csv", index_col=0)


def published(number: int, line: float, quantity: str, algorithm: str) -> float | None:
    """What the paper has beside this algorithm, one of its two or a relative; `quantity`:
    maintenance_pct, position_rms_km or velocity_rms_km_s. None where it has nothing."""
    table = published_table(number)
    column = f"{quantity}_{algorithm.split('-')[0]}"
    if column not in table or line not in table.index or np.isnan(table.loc[line, column]):
        return None
    return float(table.loc[line, column])


def entries(frame: pd.DataFrame, first: str = "") -> Iterator[tuple[tuple, pd.DataFrame]]:
    """Per value of the column `first` in order, if one is named, and per algorithm and update as
    they come in the frame."""
    for value, part in frame.groupby(first, sort=True) if first else [(None, frame)]:
        for entry, own in part.groupby(_ENTRY, sort=False):
            yield (value, *entry) if first else entry, own


def _minus(value: Estimate | None, other: float | None) -> float | None:
    return None if value is None or other is None else value.value - other


def _maintenance(tracks: pd.DataFrame, outings: pd.DataFrame, law: str) -> Table:
    columns = [Column("C", digits="g", once=True), *_WHO, Column("runs"), Column("failed")]
    columns += [Column("kept [%]", "0.45 km", ".1f", interval=True),
                Column("s.e.", "0.45 km", ".1f"), Column("paper", "0.45 km", ".0f"),
                Column("diff.", "0.45 km", "+.1f"), Column("kept [%]", "0.75 km", ".1f"),
                Column("s.e.", "0.75 km", ".1f"), Column("diff.", "0.75 km", "+.1f"),
                Column("dropped [%]", digits=".1f")]
    failed = outings[(outings["status"] == "failed") & (outings["law"] == law)
                     & outings["scene"].isin(PAIRS)].groupby(["density", *_ENTRY]).size()
    rows: list[list[Cell]] = []
    for key, own in entries(tracks, "density"):
        paper = published(3, key[0], "maintenance_pct", key[1])
        strict, wide = (percent(own, field) for field in KEPT)
        assert strict is not None and wide is not None
        rows.append([*key, len(own.drop_duplicates(["scene", "replicate"])),
                     int(failed.get(key, 0)), strict, strict.error, paper, _minus(strict, paper),
                     wide.value, wide.error, _minus(wide, paper),
                     100.0 * float(own["dropped"].mean())])
    notes = ["Crossing and parallel targets pooled. C: clutter per km^2. kept: share of the tracks "
             "never as far from their target as that in the last 5 scans. s.e.: standard error, "
             "and brackets: 95 % interval, over runs, whose two tracks are not independent. "
             "Where all or none are kept, resampling says nothing: the other share is below "
             "3 / runs. runs: finished ones of both scenes together; failed ones are left out. "
             "diff.: ours minus the paper's, whose threshold is not known. dropped: given up, 2 km "
             "off or with a variance above 1 km^2."]
    return Table(f"table_3_kept_{law}", f"Table 3, track maintenance; clutter {LAWS[law]}", columns,
                 rows, notes)


def _errors(tracks: pd.DataFrame, law: str, quantity: str) -> Table:
    unit, digits = _QUANTITIES[quantity]
    columns = [Column("C", digits="g", once=True), *_WHO,
               Column("kept tracks", "filtered", digits, interval=True),
               Column("all tracks", "filtered", digits, interval=True),
               Column("kept", "predicted", digits), Column("all", "predicted", digits),
               Column("rms", "paper", ".2f"), Column("kept diff.", "paper", "+.2f"),
               Column("all diff.", "paper", "+.2f")]
    rows: list[list[Cell]] = []
    for key, own in entries(tracks, "density"):
        kept = own[own["kept_450m"] == 1]
        paper = published(3, key[0], f"{quantity}_rms_{unit}", key[1])
        of_kept, of_all = rms(kept, quantity), rms(own, quantity)
        before = (_root(part, f"predicted_{quantity}") for part in (kept, own))
        rows.append([*key, of_kept, of_all, *before, paper, _minus(of_kept, paper),
                     _minus(of_all, paper)])
    notes = ["Roots of the mean squares over all scans of the tracks kept within 0.45 km, and of "
             "all tracks; after the update (filtered) and before it (predicted). The paper does "
             "not say which is its. A dropped track coasts on and counts under all."]
    return Table(f"table_3_{quantity}_{law}",
                 f"Table 3, rms {quantity} error [{unit.replace('_', '/')}]; clutter {LAWS[law]}",
                 columns, rows, notes)


def _apart(tracks: pd.DataFrame, outings: pd.DataFrame, law: str) -> Table:
    columns = [Column("C", digits="g", once=True), *_WHO]
    for scene in PAIRS:
        columns += [Column("0.45", f"{scene}: kept [%]", ".1f"),
                    Column("s.e.", f"{scene}: kept [%]", ".1f"),
                    Column("0.75", f"{scene}: kept [%]", ".1f"),
                    Column("swaps", f"{scene}, per 100 runs", ".1f"),
                    Column("coal.", f"{scene}, per 100 runs", ".1f")]
    done = finished(outings)
    events = done[done["law"] == law].groupby(["density", *_ENTRY, "scene"])[
        ["swaps", "coalescences"]].mean()
    rows: list[list[Cell]] = []
    for key, own in entries(tracks, "density"):
        line: list[Cell] = [*key]
        for scene in PAIRS:
            part = own[own["scene"] == scene]
            if part.empty:
                line += [None] * 5
                continue
            strict = percent(part, "kept_450m")
            assert strict is not None
            line += [strict.value, strict.error,
                     100.0 * float(part["kept_750m"].mean()),
                     *(100.0 * float(n) for n in events.loc[(*key, scene)])]
        rows.append(line)
    notes = ["swaps: the two tracks have changed places in the last 5 scans; coal.: coalescences, "
             "the two are one while their targets are not. The targets of the parallel pair are "
             "0.5 km apart: within 0.75 km a swapped or coalesced track counts as kept."]
    return Table(f"scenes_{law}", f"Crossing and parallel targets apart; clutter {LAWS[law]}",
                 columns, rows, notes)


def _ten(tracks: pd.DataFrame) -> list[Table]:
    """A table per quantity of Table 4, a column per target."""
    kept = tracks[tracks["kept_450m"] == 1]
    made = [_by_target(f"table_4_{field}", f"tracks kept within {limit} [%]", ".1f",
                       "maintenance_pct", tracks, field, 100.0)
            for field, limit in KEPT.items()]
    made[0].notes.append("The standard error of a share p over n runs is sqrt(p (1 - p) / n): at "
                         f"most {50.0 / np.sqrt(_fewest_runs(tracks)):.1f} points here.")
    for quantity, (unit, digits) in _QUANTITIES.items():
        for field, told in ((quantity, "filtered"), (f"predicted_{quantity}", "predicted")):
            made.append(_by_target(
                f"table_4_{field}", f"rms {quantity} error [{unit.replace('_', '/')}], {told}, of "
                "the tracks kept within 0.45 km", digits, f"{quantity}_rms_{unit}", kept, field,
                None))
    return made


def _fewest_runs(tracks: pd.DataFrame) -> int:
    return int(tracks.groupby(["law", *_ENTRY])["replicate"].nunique().min())


def _by_target(name: str, title: str, digits: str, quantity: str, tracks: pd.DataFrame, part: str,
               scale: float | None) -> Table:
    """Means of `part` over the tracks times `scale`, or its rms without one."""
    columns = [Column("clutter", once=True), *_WHO,
               *(Column(str(t), "target", digits) for t in _TARGETS), Column("all", digits=digits)]

    def value(own: pd.DataFrame) -> float | None:
        if scale is None or own.empty:
            return _root(own, part)
        return scale * float(own[part].mean())

    rows: list[list[Cell]] = [
        ["paper", algorithm, "", *(published(4, t, quantity, algorithm) for t in _TARGETS), None]
        for algorithm in ("hnpda", "mapada")]
    rows += [[*key, *(value(own[own["target"] == t]) for t in _TARGETS), value(own)]
             for key, own in entries(tracks, "law")]
    return Table(name, f"Table 4, {title}", columns, rows)


def _costs(outings: pd.DataFrame) -> Table:
    """Means over the scans by density, the pairs of targets pooled, and of the ten targets."""
    fields = (("conflicts", "scans with a conflict [%]", ".2f"),
              ("iterations", "iterations per scan", ".1f"), ("cpu_ms", "CPU [ms/scan]", ".4f"))
    groups = [*(f"{d:g}" for d in DENSITIES), "ten"]
    columns = [Column("clutter", once=True), *_WHO]
    columns += [Column(g, title, digits) for _, title, digits in fields for g in groups]
    own = outings.assign(
        conflicts=100.0 * outings["conflict_rate"] * outings["scans"],
        iterations=outings["iterations_per_scan"] * outings["scans"],
        group=outings["density"].map("{:g}".format).where(outings["scene"] != "ten", "ten"))
    rows: list[list[Cell]] = []
    for key, part in entries(own, "law"):
        sums = part.groupby("group")[[*(f for f, _, _ in fields), "scans"]].sum(min_count=1)
        rows.append([*key, *(_share(sums, g, f) for f, _, _ in fields for g in groups)])
    notes = ["Closed loop, columns by clutter density (crossing and parallel targets pooled) and "
             "of the ten targets. Conflict: two tracks have the same plot for their largest value. "
             "CPU: of solving; of the oracle 0. iterations: of the method, where it counts some."]
    return Table("costs", "Conflicts, iterations and time", columns, rows, notes)


def _share(sums: pd.DataFrame, group: str, field: str) -> float | None:
    if group not in sums.index or np.isnan(sums.loc[group, field]):
        return None
    return cast(float, sums.loc[group, field] / sums.loc[group, "scans"])
