"""Verdicts on the claims follow from the rows: planted runs turn them."""

from pathlib import Path

import pytest

from mda_results import battistelli2008, verdicts
from mda_results.known_testing import open_row, outing, write_known
from mda_results.testing import table_of
from mda_results.verdicts import FAILS, HOLDS, OPEN, PARTLY


@pytest.fixture
def judged(tmp_path: Path):
    def verdicts_of(rows: list[dict], outings: list[dict], said: str) -> list[str]:
        """Those of the claim whose text holds `said`, in order."""
        report = battistelli2008.report(write_known(tmp_path / "run", rows, outings))[0]
        numbers = [r[0] for r in table_of(report, "claims_rules").rows if said in r[1]]
        assert len(numbers) == 1
        return [r[3] for r in table_of(report, "claims").rows if r[0] == numbers[0]]

    return verdicts_of


def rows_of(algorithm: str, ks=(2, 3), **changes) -> list[dict]:
    return [open_row(algorithm, k=k, scan=5, replicate=r, **changes)
            for k in ks for r in (1, 2, 3)]


def runs_of(algorithm: str, scenario: str = "battistelli-2", **changes) -> list[dict]:
    return [outing(algorithm, scenario, r, **changes) for r in (1, 2, 3)]


@pytest.mark.parametrize(("gap", "verdict"), [(0.5, HOLDS), (2.0, FAILS)])
def test_close_to_optimal(judged, gap, verdict):
    rows = rows_of("scf", gap_nats=gap) + rows_of("scf-tie", gap_nats=gap)
    assert judged(rows, [], "close-to-optimal") == [verdict, verdict]


def test_close_to_optimal_at_some_k_holds_partly(judged):
    rows = rows_of("scf", (2,), gap_nats=0.5) + rows_of("scf", (3,), gap_nats=2.0)
    assert judged(rows, [], "close-to-optimal") == [PARTLY, OPEN]


@pytest.mark.parametrize(("slow", "said"), [("sd-exact", "computational load"),
                                            ("mcf", "computational burden")])
@pytest.mark.parametrize(("ms", "verdict"), [(3.0, HOLDS), (1.5, FAILS)])
def test_times(judged, slow, said, ms, verdict):
    rows = rows_of("scf", cpu_ms=1.0) + rows_of(slow, cpu_ms=ms)
    assert judged(rows, [], said)[0] == verdict
    other = "mcf" if slow == "sd-exact" else "sd-exact"
    assert judged(rows + rows_of(other), [], said)[0] == verdict


@pytest.mark.parametrize(("integral", "always", "guaranteed"), [(True, HOLDS, OPEN),
                                                               (False, FAILS, HOLDS)])
def test_integrality(judged, integral, always, guaranteed):
    rows = rows_of("scf-lp") + rows_of("mcf-lp")
    rows[0]["integral"] = rows[-1]["integral"] = integral
    assert judged(rows, [], "integral optimum") == [always]
    assert judged(rows, [], "not guaranteed") == [guaranteed]


def test_graph_size(judged):
    rows = rows_of("scf")
    assert judged(rows, [], "O((M+T)S) nodes") == [HOLDS]
    rows[0]["graph_nodes"] += 1  # open_row() has as many as there can be
    assert judged(rows, [], "O((M+T)S) nodes") == [FAILS]


def test_growth_and_exact_solution(judged):
    rows = rows_of("sd-exact")
    assert judged(rows, [], "exponentially") == [HOLDS]
    assert judged([{**r, "columns": 40} for r in rows], [], "exponentially") == [FAILS]
    assert judged(rows, [], "ruled out") == [FAILS]
    assert judged([*rows[1:], {**rows[0], "cpu_ms": 6000.0}], [], "ruled out") == [HOLDS]
    assert judged([*rows[1:], {**rows[0], "status": "feasible"}], [], "ruled out") == [HOLDS]


@pytest.mark.parametrize(("d", "verdict"), [(42.0, HOLDS), (54.0, PARTLY), (60.0, FAILS)])
def test_ideal_and_oracle(judged, d, verdict):
    outings = runs_of("scf", position_error_m=d)  # ideal 40 m, oracle 50 m
    assert judged([], outings, "with respect to the ideal")[0] == verdict


@pytest.mark.parametrize(("d", "right", "verdict"), [
    (62.0, 0.91, HOLDS), (62.0, 0.8, PARTLY), (80.0, 0.8, FAILS), (40.0, 0.9, PARTLY)])
def test_close_to_the_others(judged, d, right, verdict):
    outings = runs_of("scf", position_error_m=d, right_share=right)
    outings += runs_of("mcf") + runs_of("sd-exact")
    assert judged([], outings, "very close to MCF")[0] == verdict
    assert judged([], outings, "negligible impact")[0] == verdict


def series(quiet: float, turning: float) -> list[float]:
    """At 50, 100, 150, 200, 250, 300 and 350 s."""
    return [quiet] * 3 + [turning] * 2 + [quiet] * 2


def test_manoeuvres(judged, monkeypatch):
    monkeypatch.setattr("mda_results.known_targets.nominal_period_s", lambda _: 50.0)
    outings = runs_of("scf", period=50.0, scans=7, right_series=[1.0] * 7,
                      ideal_series_m=series(40, 60), oracle_series_m=series(40, 90),
                      position_error_series_m=series(42, 100))
    assert judged([], outings, "but for 200-250 s")[0] == HOLDS
    assert judged([], outings, "due to manoeuvres")[0] == HOLDS
    outings = [{**line, "position_error_series_m": series(60, 200)} for line in outings]
    assert judged([], outings, "but for 200-250 s")[0] == FAILS
    assert judged([], outings, "due to manoeuvres")[0] == FAILS
    first = [{**line, "scenario": "battistelli-1"} for line in outings]
    assert judged([], first, "due to manoeuvres") == [OPEN]


@pytest.mark.parametrize(("single", "verdict"), [(70.0, HOLDS), (50.0, FAILS)])
def test_several_scans_against_one(judged, single, verdict):
    outings = runs_of("sd-exact") + runs_of("sd-exact", k=1, position_error_m=single)
    assert judged([], outings, "multiscan association significantly")[0] == verdict


def test_one_run_decides_nothing(judged):
    assert judged([], [outing("scf")], "with respect to the ideal")[0] == OPEN


@pytest.mark.parametrize(("parts", "verdict"), [
    ([], OPEN), ([HOLDS, HOLDS], HOLDS), ([HOLDS, OPEN], PARTLY), ([FAILS, OPEN], FAILS),
    ([PARTLY, FAILS], PARTLY), ([OPEN], OPEN),
])
def test_together(parts, verdict):
    assert verdicts.together(parts) == verdict
