"""The claims of Battistelli et al. (2008), each judged per scenario by a rule that is printed."""

from collections.abc import Callable, Iterator

import pandas as pd

from mda_results import battistelli_closed, battistelli_tracking_claims, bootstrap, cells
from mda_results.battistelli_open import graph_sizes
from mda_results.battistelli_tracking_claims import FLOWS
from mda_results.known_targets import SCENARIOS, KnownRun, finished, nominal, nominal_period_s
from mda_results.render import Cell, Column, Estimate, Table
from mda_results.rows import WINDOW_KEY
from mda_results.verdicts import FAILS, HOLDS, OPEN, Claim, at_least, at_most, over

_EXACT, _MULTI = "sd-exact", "mcf"
_NEAR_PERCENT = 1.0  # of the optimal cost
_FASTER = 2.0
_GROWTH = 1.5
_Judge = Callable[[pd.DataFrame, str], Iterator[Claim]]


def tables(run: KnownRun) -> list[Table]:
    """The claims with their rules, and what comes of each per scenario and variant."""
    rows, outings = nominal(run.rows), finished(nominal(run.outings))
    compared = battistelli_closed.compared(outings)
    judged = [_judged(judge, rows) for judge in _OPEN_LOOP]
    judged += [_judged(judge, outings if judge in battistelli_tracking_claims.ALL_K else compared)
               for judge in battistelli_tracking_claims.JUDGES]
    rules: list[list[Cell]] = []
    verdicts: list[list[Cell]] = []
    for number, claims in enumerate(judged, start=1):
        rules.append([str(number), claims[0][1].said, claims[0][1].rule])
        verdicts += [[str(number), s, c.ours, c.verdict] for s, c in claims]
    notes = ["Brackets: 95 % bootstrap interval over scenes. A rule met at some K only: holds "
             "partly. scf: equations as printed; scf-tie: ties at missed detections by the "
             "cumulative cost."]
    return [Table("claims_rules", "Claims of the paper, and when they count as true",
                  [Column("no."), Column("the paper"), Column("rule")], rules),
            Table("claims", "Verdicts", [Column("no.", once=True), Column("scenario"),
                                         Column("ours"), Column("verdict")], verdicts, notes)]


def _judged(judge: _Judge, frame: pd.DataFrame) -> list[tuple[str, Claim]]:
    """One claim on every scenario that the frame has; without any, that there is no data."""
    present = [s for s in SCENARIOS if (frame["scenario"] == s).any()]
    claims = [(s, c) for s in present for c in judge(frame[frame["scenario"] == s], s)]
    if claims:
        return claims
    claim = next(judge(frame.iloc[:0], "battistelli-2"))
    return [("all", Claim(claim.said, "no data", OPEN, claim.rule))]


def _by_k(rows: pd.DataFrame, of: Callable[[pd.DataFrame], Estimate | None],
          judge: Callable[[Estimate | None], str], digits: str) -> tuple[str, str]:
    """What is found at each K > 1, and the verdict of all together."""
    return over(rows[rows["window_k"] > 1], "window_k", of, judge, "K=", digits)


def _answered(rows: pd.DataFrame, algorithm: str) -> pd.DataFrame:
    return rows[(rows["algorithm"] == algorithm) & cells.answered(rows)]


def _near_optimal(rows: pd.DataFrame, _: str) -> Iterator[Claim]:
    for algorithm in FLOWS:
        own = _answered(rows, algorithm)
        own = own.assign(size=own["reference_cost_nats"].abs())
        told, verdict = _by_k(
            own, lambda part: bootstrap.ratio(part.dropna(subset=["gap_nats"]), "gap_nats",
                                                 "size", lambda x: 100 * x),
            lambda e: at_most(e, _NEAR_PERCENT), ".2f")
        yield Claim("close-to-optimal association (abstract): gap of SCF in percent of the optimum",
                    f"{algorithm}: {told}", verdict,
                    f"at most {_NEAR_PERCENT:g} % of the optimal cost at every K > 1")


def _faster(rows: pd.DataFrame, slow: str, said: str) -> Iterator[Claim]:
    """CPU time of solving, making the graph included; the same windows on both sides."""
    for quick in FLOWS:
        first, second = (_answered(rows, a) for a in (slow, quick))
        pairs = second.merge(first[[*WINDOW_KEY, "cpu_ms"]], on=WINDOW_KEY, suffixes=("", "_slow"))
        told, verdict = _by_k(pairs, lambda part: bootstrap.ratio(part, "cpu_ms_slow", "cpu_ms"),
                              lambda e: at_least(e, _FASTER), ".1f")
        yield Claim(said, f"{slow} / {quick}: {told}", verdict,
                    f"at least {_FASTER:g} times the CPU time of SCF, making its graph included, "
                    "at every K > 1")


def _faster_than_exact(rows: pd.DataFrame, _: str) -> Iterator[Claim]:
    yield from _faster(rows, _EXACT, "significant reduction of the computational load (abstract), "
                       "here against exact S-D assignment")


def _faster_than_multi(rows: pd.DataFrame, _: str) -> Iterator[Claim]:
    yield from _faster(rows, _MULTI, "significantly reduced computational burden against MCF (IV)")


def _integral(rows: pd.DataFrame, _: str) -> Iterator[Claim]:
    said = "the flow LP always has an integral optimum (III)"
    known = _answered(rows, "scf-lp").dropna(subset=["integral"])
    if known.empty:
        yield Claim(said, "no data", OPEN, "every optimum of scf-lp is integral")
        return
    whole = int(known["integral"].sum())
    yield Claim(said, f"{whole} of {len(known)} windows", HOLDS if whole == len(known) else FAILS,
                "every optimum of scf-lp is integral")


def _not_guaranteed(rows: pd.DataFrame, _: str) -> Iterator[Claim]:
    said = "integrality is not guaranteed for MCF (I)"
    known = _answered(rows, "mcf-lp").dropna(subset=["integral"])
    broken = int((known["integral"] == 0).sum())
    yield Claim(said, f"fractional: {broken} of {len(known)} windows" if len(known) else "no data",
                HOLDS if broken else OPEN, "some optimum of mcf-lp is fractional")


def _graph_size(rows: pd.DataFrame, _: str) -> Iterator[Claim]:
    said = "the graph has O((M+T)S) nodes and O((M+T)^2 S) arcs (III)"
    rule = ("in every window at most (M+T)S nodes beside sources and sink, and (M+T)^2 S arcs "
            "beside T")
    sizes = graph_sizes(rows, "scf").dropna(subset=["nodes", "arcs"])
    if sizes.empty:
        yield Claim(said, "no data", OPEN, rule)
        return
    nodes = float((sizes["nodes"] / sizes["node_bound"]).max())
    arcs = float((sizes["arcs"] / sizes["arc_bound"]).max())
    within = ((sizes["nodes"] <= sizes["most_nodes"] + 1e-6)
              & (sizes["arcs"] <= sizes["arc_bound"] + sizes["targets"] + 1e-6)).all()
    yield Claim(said, f"at most {nodes:.2f} (M+T)S nodes, {arcs:.3f} (M+T)^2 S arcs",
                HOLDS if within else FAILS, rule)


def _exponential(rows: pd.DataFrame, _: str) -> Iterator[Claim]:
    said = "the number of sequences grows exponentially with S (I, II)"
    rule = f"mean columns after gating grow by {_GROWTH:g} times or more with every further scan"
    full = rows[rows["scan"] >= rows["window_k"]].drop_duplicates(WINDOW_KEY)
    columns = full.groupby("window_k")["columns"].mean()
    growth = [(k, columns[k] / columns[k - 1]) for k in columns.index if k - 1 in columns.index]
    if not growth:
        yield Claim(said, "no data", OPEN, rule)
        return
    told = ", ".join(f"{factor:.2f}" for _, factor in growth)
    yield Claim(said, f"factors from K={growth[0][0] - 1} on: {told}; "
                f"{columns.iloc[-1]:.0f} columns at K={columns.index[-1]}",
                HOLDS if min(f for _, f in growth) >= _GROWTH else FAILS, rule)


def _ruled_out(rows: pd.DataFrame, scenario: str) -> Iterator[Claim]:
    said = "exact solution is ruled out unless instances are very small (II)"
    rule = "some window without its optimum, or that takes longer than the scan period"
    own = rows[(rows["algorithm"] == _EXACT) & (rows["status"] != "skipped")]
    if own.empty:
        yield Claim(said, "no data", OPEN, rule)
        return
    unsolved = int((own["status"] != "optimal").sum())
    longest = float(own["cpu_ms"].max())
    late = longest > 1000.0 * nominal_period_s(scenario)
    yield Claim(said, f"{_EXACT}: {unsolved} of {len(own)} windows unsolved, longest "
                f"{longest:.2f} ms", HOLDS if unsolved or late else FAILS, rule)


_OPEN_LOOP: tuple[_Judge, ...] = (
    _near_optimal, _faster_than_exact, _faster_than_multi, _integral, _not_guaranteed, _graph_size,
    _exponential, _ruled_out)
