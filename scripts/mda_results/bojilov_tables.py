"""Tables of a run over three sensors: correct association, pairs, gaps and times."""

from collections.abc import Callable

import pandas as pd

from mda_results import bootstrap, cells
from mda_results.battistelli_open import is_optimal
from mda_results.render import Cell, Column, Estimate, Table
from mda_results.three_sensors import (LOSSES, SCENE, UNTREATED, counted, pair_precision,
                                       pair_recall, target_exact)

_Measure = Callable[[pd.DataFrame], Estimate | None]


def tables(rows: pd.DataFrame) -> list[Table]:
    """Per scene correct association over loss and sigma, pairs, and gaps; then times and fates."""
    scenes = list(rows.groupby(SCENE, sort=True))
    made = [_figure_2(scene, own) for scene, own in scenes]
    made += [_pairs(scene, own) for scene, own in scenes]
    made += [_gaps(scene, own) for scene, own in scenes]
    return [*made, _times(rows), _fates(rows)]


def title_of(scene: tuple[int, str, float]) -> str:
    """A scene for people."""
    targets, layout, false_alarms = scene
    place = "on a grid" if layout == "grid" else "anywhere"
    return f"{targets} targets {place}, {false_alarms:g} false alarms per target"


def _name(what: str, scene: tuple[int, str, float]) -> str:
    targets, layout, false_alarms = scene
    return f"{what}_{targets}{'_random' if layout == 'random' else ''}_f{false_alarms:g}"


def _label(algorithm: str) -> str | None:
    """Where an algorithm stands on the horizontal axis of figure 2."""
    if algorithm == UNTREATED:
        return "x"
    return next((f"{loss:g}" for loss, a in LOSSES.items() if a == algorithm), None)


def _parts(own: pd.DataFrame) -> list[tuple[str, pd.DataFrame]]:
    """The rows per algorithm, in the order that they have."""
    return [(str(a), part) for a, part in own.groupby("algorithm", sort=False)]


def _by_sigma(own: pd.DataFrame, sigmas: list[float], of: _Measure) -> list[Cell]:
    return [of(own[own["sigma"] == s]) for s in sigmas]


def _sigmas(own: pd.DataFrame) -> list[float]:
    return sorted(map(float, own["sigma"].unique()))


def _figure_2(scene: tuple[int, str, float], own: pd.DataFrame) -> Table:
    sigmas = _sigmas(own)
    columns = [Column("loss [%]"), Column("algorithm"), Column("runs"),
               *(Column(f"σ = {s:.2f}", "correct association [%]", ".1f", interval=True)
                 for s in sigmas)]
    lines: list[list[Cell]] = [
        [_label(a), a, _runs(counted(part), sigmas), *_by_sigma(part, sigmas, target_exact)]
        for a, part in _parts(own)]
    notes = ["Share of the targets that two sensors at least have seen whose very set of reports "
             "is a tuple of the answer. loss: share of true pairs that the threshold Q loses; x: "
             "no treatment. σ: of a report, in mean distances of the targets. runs: of the σ with "
             "fewest. Brackets: 95 % bootstrap interval over runs."]
    return Table(_name("figure_2", scene), f"Figure 2: {title_of(scene)}", columns, lines, notes)


def _runs(own: pd.DataFrame, sigmas: list[float]) -> int:
    return int(own.groupby("sigma")["replicate"].nunique().reindex(sigmas, fill_value=0).min())


def _pairs(scene: tuple[int, str, float], own: pd.DataFrame) -> Table:
    sigmas = _sigmas(own)
    columns = [Column("algorithm"),
               *(Column(f"σ = {s:.2f}", block, ".1f", interval=True)
                 for block in ("pair precision [%]", "pair recall [%]") for s in sigmas)]
    lines: list[list[Cell]] = [
        [a, *_by_sigma(part, sigmas, pair_precision), *_by_sigma(part, sigmas, pair_recall)]
        for a, part in _parts(own)]
    notes = ["Pairs of reports in one tuple. precision: those of the answer that are one target; "
             "recall: those of one target that are in the answer."]
    return Table(_name("pairs", scene), f"Pairs: {title_of(scene)}", columns, lines, notes)


def _gaps(scene: tuple[int, str, float], own: pd.DataFrame) -> Table:
    sigmas = _sigmas(own)
    columns = [Column("algorithm"),
               *(Column(f"σ = {s:.2f}", "gap [% of the optimum]", ".2f", interval=True)
                 for s in sigmas),
               *(Column(f"σ = {s:.2f}", "optimal [%]", ".1f") for s in sigmas)]
    lines: list[list[Cell]] = [
        [a, *_by_sigma(part, sigmas, gap_percent), *_by_sigma(part, sigmas, _optimal_percent)]
        for a, part in _parts(own)]
    notes = ["Cost less optimum, as share of the optimum, pooled over runs; costs are minus log "
             "likelihood ratios. optimal: gap at most 1e-5 nats + 1e-9 |cost|."]
    return Table(_name("gap", scene), f"Gap to the optimum: {title_of(scene)}", columns, lines,
                 notes)


def gap_percent(rows: pd.DataFrame) -> Estimate | None:
    """Gap as percent of the optimal cost; interval over runs."""
    own = rows[cells.answered(rows)].dropna(subset=["gap_nats"])
    own = own.assign(size=own["reference_cost_nats"].abs())
    return bootstrap.ratio(own, "gap_nats", "size", lambda share: 100 * share)


def _optimal_percent(rows: pd.DataFrame) -> Estimate | None:
    own = rows[cells.answered(rows)].dropna(subset=["gap_nats"])
    return Estimate(100.0 * float(is_optimal(own).mean())) if len(own) else None


def _times(rows: pd.DataFrame) -> Table:
    columns = [Column("targets", once=True), Column("layout", once=True), Column("algorithm"),
               Column("n"), Column("columns", digits=".0f"),
               Column("mean", "solve, CPU [ms]", ".3f"), Column("max", "solve, CPU [ms]", ".2f"),
               Column("views [ms]", digits=".3f"), Column("certified [%]", digits=".1f")]
    good = rows[cells.answered(rows)]
    lines: list[list[Cell]] = [
        [int(targets), layout, algorithm, len(part), float(part["columns"].mean()),
         float(part["cpu_ms"].mean()), float(part["cpu_ms"].max()),
         float(part["views_ms"].mean()),
         100.0 * float(part["certified_bound_nats"].notna().mean())]
        for (targets, layout), own in good.groupby(["targets", "layout"], sort=True)
        for algorithm, part in _parts(own)]
    notes = ["Answered windows of all σ and levels of false alarms. views: distances between "
             "reports, for those who ask for them. certified: answers with a bound recomputed "
             "from multipliers."]
    return Table("times", "Times", columns, lines, notes)


def _fates(rows: pd.DataFrame) -> Table:
    columns = [Column("algorithm", once=True), Column("what"), Column("rows"),
               Column("scenario of the first"), Column("its reason")]
    bad = rows[~cells.answered(rows)]
    lines: list[list[Cell]] = [
        [str(a), str(status), len(part), str(part["scenario"].iloc[0]),
         str(part["note"].iloc[0])[:60] or None]
        for (a, status), part in bad.groupby(["algorithm", "status"], sort=True, observed=True)]
    return Table("fates", "Rows without an answer that stands", columns, lines,
                 [] if lines else ["None."])
