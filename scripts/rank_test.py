"""scripts/rank.py from rows to what it prints."""

import csv
import io
import json
import math
import random
from pathlib import Path
from typing import Any

import pytest

import rank
from mda_results import known_testing, pool, rank_report, testing, tracking_test
from mda_results.rank_report import Selection
from mda_results.ranking_testing import (MANIFEST, contests_of, row, study, unanswered,
                                         write)
from mda_results.render import Table
from mda_results.testing import Row, values


@pytest.fixture(scope="module")
def run(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return write(tmp_path_factory.mktemp("study") / "run", study())


def printed(capsys: pytest.CaptureFixture[str], *arguments: str) -> str:
    assert rank.main(list(arguments)) == 0
    return capsys.readouterr().out


def tables_of(text: str) -> dict[str, dict[str, Any]]:
    return {t["name"]: t for t in json.loads(text)["tables"]}


def table(run: Path, name: str, **selected: Any) -> Table:
    found = rank_report.rank(pool.load([run]), Selection(**selected))
    return next(t for t in [*found.report.tables, *found.data] if t.name == name)


def test_the_order_of_rows_and_runs_does_not_matter(tmp_path, capsys):
    rows, lines = study(), []
    for turn in range(2):
        parts = [[r for r in rows if r["scenario"] == s] for s in "AB"]
        for part in parts:
            random.Random(turn).shuffle(part)
        runs = [str(write(tmp_path / s, part)) for s, part in zip("ab", parts)]
        lines.append(printed(capsys, *runs[:: 1 - 2 * turn], "--format", "json"))
    assert lines[0] == lines[1]


def test_the_formats_tell_the_same(run, tmp_path, capsys):
    text = printed(capsys, str(run))
    markdown = printed(capsys, str(run), "--format", "markdown")
    told = tables_of(printed(capsys, str(run), "--format", "json"))
    ranking = list(csv.DictReader(io.StringIO(printed(capsys, str(run), "--format", "csv"))))
    place = told["ranking"]["columns"].index("algorithm")
    assert [line["algorithm"] for line in ranking] == [r[place] for r in told["ranking"]["rows"]]
    for name, found in told.items():
        assert all(len(line) == len(found["columns"]) for line in found["rows"])
        for_people = name not in ("pairs", "profiles_fine", "time_to_gap_fine")
        if for_people:
            assert f"\n{found['title']}\n" in text and f"## {found['title']}\n" in markdown
    out = printed(capsys, str(run), "--format", "csv", "--out", str(tmp_path / "csv")).split()
    assert {Path(p).stem for p in out} == set(told)
    written = list(csv.DictReader((tmp_path / "csv" / "ranking.csv").open()))
    assert written == ranking


def test_some_tables_alone(run, capsys):
    told = tables_of(printed(capsys, str(run), "--format", "json", "--tables", "pairs,ranking"))
    assert list(told) == ["pairs", "ranking"]
    assert told["ranking"] == tables_of(printed(capsys, str(run), "--format", "json"))["ranking"]
    refused(capsys, "no table order; there are", str(run), "--tables", "order")


def test_every_row_is_counted(run):
    fates = table(run, "fates")
    rows = study()
    for line in fates.rows:
        own = [r for r in rows if r["algorithm"] == line[0]]
        assert sum(line[3:]) == line[2] == len(own) == 96
        assert values(fates, line[0])["declined"] == sum(r["status"] == "skipped" for r in own)
        assert values(fates, line[0])["timed out"] == sum(r["stop"] == "deadline" for r in own)


def test_relaxations_and_marginals_are_ranked_apart(run):
    assert {line[3] for line in table(run, "ranking").rows} == {"exact", "quick", "late", "small"}
    apart = table(run, "apart")
    assert {(line[0], line[3]) for line in apart.rows} == {("relaxation", "lp"),
                                                          ("marginals", "odds")}
    odds = values(apart, "marginals", "easy")
    assert odds["worst row violation"] == 0.25
    assert math.isnan(odds["bound below the best [nats] mean"])
    assert values(apart, "relaxation", "hard")["bound below the best [nats] mean"] == 0.0


def test_relaxations_are_ordered_by_their_bounds(tmp_path):
    common = {"answer": "relaxation", "gap_nats": None, "gap_share": None}
    rows = [row("exact", lp_gap=0.5), row("tight", lp_gap=0.5, **common, cpu_ms=9.0),
            row("weak", lp_gap=2.0, **common, cpu_ms=0.1),
            row("claims", **common, certified_bound_nats=None, bound_nats=-11.0)]
    apart = table(write(tmp_path / "run", rows), "apart")
    assert [(line[2], line[3], line[8]) for line in apart.rows] == [
        ("1", "tight", 0.0), ("2", "claims", 0.5), ("3", "weak", 1.5)]


def test_a_selection_computes_everything_anew(run):
    everything = table(run, "profiles")
    alone = table(run, "profiles", algorithms=("exact", "late"))
    assert values(everything, "easy", "exact")["percent within this ratio of the fastest 1"] < 50
    assert values(alone, "easy", "exact")["percent within this ratio of the fastest 1"] == 100.0
    whole, part = (table(run, "gaps"), table(run, "gaps", scenarios=("A",), windows=(5,)))
    count = {h: len(c.windows) for h, c in contests_of(run, Selection(("A",), (5,))).items()}
    assert sum(count.values()) == 24
    assert values(part, "easy", "exact")["n"] == count["easy"] < values(whole, "easy", "exact")["n"]


def test_facts_do_not_depend_on_the_selection(tmp_path):
    rows = [row("exact", lp_gap=0.5), row("quick", 2.0, certified_bound_nats=None)]
    alone = table(write(tmp_path / "run", rows), "ranking", algorithms=("quick",))
    assert values(alone, "hard")["certified gap [nats] mean"].value == pytest.approx(2.5)


def test_planted_exponents_are_found(tmp_path):
    rows = []
    for k in (2, 4, 8):
        for n in range(12):
            columns = 10 + 7 * n
            key = {"window_k": k, "replicate": 1 + n // 3, "scan": 1 + n % 3, "columns": columns}
            rows += [row("a", **key, cpu_ms=0.01 * columns**1.5 * k**2),
                     row("b", **key, cpu_ms=2.0),
                     unanswered("c", "no_answer", "deadline", **key) if n == 11 else
                     row("c", **key, cpu_ms=0.01 * columns**0.5)]
    manifest = {**MANIFEST, "scenarios": {"A": {"births_per_scan": 2.0}}}
    run = write(tmp_path / "run", rows, manifest)
    found = values(table(run, "scaling"), "easy", "a")
    exponent = found["exponent of CPU time in columns"]
    assert exponent.value == pytest.approx(1.5) and exponent.low <= 1.5 <= exponent.high
    assert found["exponent of CPU time in K"].value == pytest.approx(2.0)
    late = values(table(run, "scaling"), "easy", "c")
    assert late["exponent of CPU time in columns"].value == pytest.approx(0.5)
    assert (late["n"], late["left out"]) == (33, 3)
    still = values(table(run, "scaling"), "easy", "b")
    assert still["exponent of CPU time in targets"].value == pytest.approx(0.0)
    assert found["exponent of CPU time in targets"].value > 0  # columns grow with the scan


def test_bins_of_hardness_hold_every_window_once(run):
    count = {h: len(c.windows) for h, c in contests_of(run).items()}
    for name in ("lp_gap", "lp_fractional", "largest_component_columns"):
        for hardness, total in count.items():
            line = values(table(run, f"hardness_{name}"), hardness, "exact")
            own = [v for header, v in line.items() if header.endswith(" n") and v is not None]
            assert sum(own) == total
    line = values(table(run, "hardness_lp_gap"), "hard", "exact")
    assert line["0 n"] is None and line["<= 1 n"] > 0
    line = values(table(run, "hardness_lp_fractional"), "hard", "exact")
    assert line["0 n"] is None and line["<= 6 n"] == count["hard"]


def test_the_front_and_who_is_beaten(run):
    front = {line[1]: line[4:] for line in table(run, "pareto").rows if line[0] == "hard"}
    assert front["quick"][0] == front["exact"][0] == "front"
    assert front["late"] == ["", "exact"]


def test_tracking_has_tables_of_its_own(tmp_path, capsys):
    lines = [tracking_test.outing(a, r, g, scenario=s) for s in "AB"
             for a, r, g in (("exact", 1, 1.0), ("exact", 2, 3.0), ("quick", 1, 1.5),
                             ("quick", 2, 1.5))]
    lines += [tracking_test.outing("broken", 1, 0.1), tracking_test.outing("broken", 2, 0.1,
                                                                           status="failed")]
    lines += [known_testing.outing("scf", replicate=r, distance_error_m=9.0) for r in (1, 2)]
    run = known_testing.write_known(tmp_path / "run", [], lines)
    told = tables_of(printed(capsys, str(run), "--format", "json"))
    assert set(told) == {"tracking_births", "tracking_known"}
    births = told["tracking_births"]["rows"]
    assert [(r[0], r[3], r[4], r[5], r[6]) for r in births] == [
        ("A", "1", "exact", 1, 0), ("A", "2", "quick", 1, 0), ("A", "out", "broken", 1, 1),
        ("B", "1", "quick", 2, 0), ("B", "2", "exact", 2, 0)]
    assert told["tracking_known"]["rows"][0][9]["value"] == 9.0
    both = known_testing.write_known(tmp_path / "both", study(), lines)
    assert {"ranking", "tracking_births"} <= set(tables_of(
        printed(capsys, str(both), "--format", "json")))
    alone = printed(capsys, str(both), "--scenarios", "battistelli-2", "--format", "json")
    assert set(tables_of(alone)) == {"tracking_known"}


def position_outing(replicate: int, kept: list[bool], update: str) -> dict[str, Any]:
    return {"schema_version": 1, "scenario": "pair", "scan_period_s": 1, "seed": 1,
            "replicate": replicate, "window_k": 1, "algorithm": "jpda", "update": update,
            "status": "finished", "scans": 4, "targets": [1, 2], "unanswered": 0, "cpu_ms": 2.0,
            "maintained_450m": kept, "dropped": [False, False], "swaps": 0, "coalescences": 1,
            "position_squares_km2": [8.0, 24.0]}


def test_tracks_maintained_by_hand(tmp_path, capsys):
    lines = [position_outing(1, [True, False], "soft"), position_outing(2, [True, True], "soft"),
             position_outing(1, [False] * 2, "hard"), position_outing(2, [True, False], "hard")]
    run = known_testing.write_known(tmp_path / "run", [], lines)
    found = tables_of(printed(capsys, str(run), "--format", "json"))["tracking_positions"]["rows"]
    assert [(r[3], r[4], r[9]["value"]) for r in found] == [("1", "jpda, soft", 25.0),
                                                            ("2", "jpda, hard", 75.0)]
    assert found[0][11] == pytest.approx(2.0)  # rms: root of 32 over 4 scans of 2 tracks


@pytest.mark.parametrize("change, expected", [
    ({"schema_version": 2}, "schema version"), ({"status": None}, "no field 'status'"),
    ({"maintained_450m": []}, "no number"), ({"position_squares_km2": None}, "no number"),
    ({"replicate": 2}, "there twice")])
def test_damaged_outings_are_one_sentence(tmp_path, capsys, change, expected):
    lines = [{**position_outing(1, [True], "soft"), **change},
             position_outing(2, [True], "soft")]
    refused(capsys, expected, str(known_testing.write_known(tmp_path / "run", [], lines)))


def test_times_of_different_machines_are_marked(tmp_path, capsys):
    first = write(tmp_path / "a", [row("exact"), row("quick", 1.0)])
    second = write(tmp_path / "b", [row("late")], {**MANIFEST, "cpu": "another"})
    text = printed(capsys, str(first), str(second))
    assert "TIMES ARE NOT COMPARABLE" in text and "cpu" in text
    assert "TIMES ARE" not in printed(capsys, str(first))


TORN = json.dumps(row("exact", scan=9))[:80]


def test_of_a_run_that_was_stopped_a_torn_last_line_is_left_out_and_said(tmp_path, capsys):
    whole = printed(capsys, str(write(tmp_path / "run", study())))
    run = write(tmp_path / "run", study(), {**MANIFEST, "outcome": "running"}, TORN)
    assert rank.main([str(run)]) == 0
    told = capsys.readouterr()
    assert told.out == whole
    assert "rows.jsonl:577: the last line is torn and was left out" in told.err
    assert "did not finish" in told.err


@pytest.mark.parametrize("manifest", [MANIFEST, {**MANIFEST, "outcome": "finished"}])
def test_a_finished_run_has_no_torn_line(tmp_path, capsys, manifest):
    run = write(tmp_path / "run", study(), manifest, TORN)
    refused(capsys, "rows.jsonl:577: the last line is torn, though the run finished", str(run))


def refused(capsys: pytest.CaptureFixture[str], expected: str, *arguments: str) -> None:
    assert rank.main(list(arguments)) == 2
    told = capsys.readouterr()
    assert told.out == ""
    assert told.err.count("\n") == 1 and expected in told.err


@pytest.mark.parametrize("rows, expected", [
    ([], "no rows"),
    ([row("exact", schema_version=2)], "mix schema versions"),
    ([row("exact"), row("exact", scan=2, schema_version=2)], "mix schema versions: 1, 2"),
    ([row("exact", answer=None)], "answer is null"),
    ([row("exact"), row("exact")], "two rows of exact"),
    ([row("exact"), row("quick", fingerprint="f" * 16)], "two different problems"),
])
def test_unusable_rows_are_one_sentence(tmp_path, capsys, rows: list[Row], expected):
    refused(capsys, expected, str(write(tmp_path / "run", rows)))


def test_unusable_runs_are_one_sentence(run, tmp_path, capsys):
    refused(capsys, "no run directory", str(tmp_path / "absent"))
    refused(capsys, "both have", str(run), str(run))
    other = write(tmp_path / "other", [row("new", fingerprint="f" * 16)])
    refused(capsys, "different problems", str(run), str(other))
    refused(capsys, "nothing of scenario Z; they have A, B", str(run), "--scenarios", "Z")
    refused(capsys, "nothing of K = 9; they have 3, 5", str(run), "--windows", "3,9")
    refused(capsys, "nothing of algorithm best", str(run), "--algorithms", "best")
    one = write(tmp_path / "one", [row("exact"), row("quick", scenario="B")])
    refused(capsys, "no row has all of it", str(one), "--scenarios", "B", "--algorithms", "exact")
    (other / "manifest.json").unlink()
    refused(capsys, "has no manifest.json", str(other))
    (other / "rows.jsonl").unlink()
    refused(capsys, "has no manifest.json", str(other))


@pytest.mark.parametrize("arguments", [
    [], ["RUN", "--format", "xml"], ["RUN", "--windows", "three"], ["RUN", "--algorithms", ","],
    ["RUN", "--shift", "0"], ["RUN", "--out", "RUN/manifest.json"]])
def test_bad_usage(run, capsys, arguments):
    with pytest.raises(SystemExit) as stopped:
        rank.main([a.replace("RUN", str(run)) for a in arguments])
    assert stopped.value.code == 2 and capsys.readouterr().out == ""


def test_help_teaches(capsys):
    with pytest.raises(SystemExit):
        rank.main(["--help"])
    text = capsys.readouterr().out
    for word in ("PAR-2", "certified gap", "Easy", "scenes", "examples", "exit code"):
        assert word in text
