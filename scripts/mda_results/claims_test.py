"""Verdicts follow from the rows: planted runs turn them."""

import pytest

import tables
from mda_results import claims, storms2003_times
from mda_results.render import Estimate
from mda_results.rows import RunError, load_run
from mda_results.testing import full_size, row


def verdicts(*directories):
    report = claims.report([load_run(d) for d in directories])
    return {line[0]: line[2] for line in report.tables[0].rows}


def changed(rows, **changes):
    return [{**r, **changes} for r in rows]


def test_integrality_follows_the_rows(write):
    said = "94 % of the LPs of groups A to C are integral"
    rows = full_size(replicates=3)
    all_integral = [{**r, "integral": True} for r in rows]
    assert verdicts(write(all_integral))[said] == claims.FAILS
    assert verdicts(write(changed(rows, integral=False)))[said] == claims.FAILS


def test_clutter_follows_the_rows(write):
    said = "more false alarms make windows no harder"
    rows = full_size(replicates=3)
    harder = [{**r, "integral": r["scenario"] != "C"} for r in rows]
    easier = [{**r, "integral": r["scenario"] != "A"} for r in rows]
    assert verdicts(write(harder))[said] == claims.FAILS
    assert verdicts(write(easier))[said] == claims.HOLDS


def test_truth_follows_the_rows(write):
    rows = full_size(replicates=3)
    said = next(s for s in verdicts(write(rows)) if s.startswith("O above V_T"))
    above = [{**r, "truth_cost_nats": -1e9} for r in rows]
    assert verdicts(write(above))[said] == claims.FAILS


def test_what_is_missing_cannot_be_decided(write):
    one_group = [r for r in full_size(replicates=3) if r["scenario"] == "A"]
    found = verdicts(write(one_group))
    assert found["56 % of the LPs of group D are integral"] == claims.OPEN
    assert found["no gain in O beyond K = 5, group B"] == claims.OPEN


@pytest.mark.parametrize(("estimate", "expected"), [
    (None, claims.OPEN), (Estimate(60.0), claims.OPEN), (Estimate(60, 55, 65), claims.HOLDS),
    (Estimate(40, 35, 45), claims.FAILS), (Estimate(50, 45, 55), claims.OPEN),
])
def test_a_verdict_needs_its_whole_interval(estimate, expected):
    verdict = claims._verdict(estimate, lambda a, _: a > 50, lambda _, b: b < 50)
    assert verdict == expected


def test_ratios_by_hand(write):
    rows = []
    for scan, (slow, quick) in enumerate([(3.0, 2.0), (1.0, 1.0)], start=1):
        shared = {"scenario": "D", "scan": scan, "fingerprint": f"f{scan}", "columns": 9}
        rows.append(row("lp-grp", cpu_ms=quick, round_ms=0.1, integral=False, paper_fractional=4,
                        gap_nats=1.5, **shared))
        rows.append(row("cbc", cpu_ms=slow, **shared))
    table = storms2003_times.report(load_run(write(rows))).tables[0]
    ours = dict(zip((c.full_header for c in table.columns), table.rows[1]))
    assert ours["windows"] == 2
    assert ours["ratio mean"] == pytest.approx(1.25)
    assert ours["ratio >= 1.2 [%]"] == ours["ratio >= 1.5 [%]"] == 50
    assert ours["mean F"] == 4 and ours["mean Δ"] == 1.5


def test_published_ratios_are_the_papers(write):
    rows = [row("lp-grp", scenario="D", integral=False, paper_fractional=4),
            row("cbc", scenario="D")]
    published = storms2003_times.report(load_run(write(rows))).tables[0].rows[0]
    assert published[1] == 66
    assert published[2] == pytest.approx(1.42, abs=0.005)


def test_times_need_both_algorithms(write):
    with pytest.raises(RunError):
        storms2003_times.report(load_run(write([row("lp-grp", scenario="D")])))


def test_only_claims_takes_several_runs(write, capsys):
    run = str(write(full_size()))
    assert tables.main(["claims", run, run]) == 0
    assert tables.main(["storms2003", run, run]) == 2
    assert capsys.readouterr().err.count("\n") == 1
