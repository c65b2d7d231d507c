"""The command: what it prints, writes and refuses."""

import json
import math
import random
import re
import shlex
import subprocess
import sys
from pathlib import Path

import pandas as pd
import pytest

import tables
from mda_results.render import Report, to_text
from mda_results.testing import (MANIFEST, Row, full_size, hand_made, report_of, row, table_of,
                                 values)


def test_order_of_rows_does_not_matter(write):
    rows = full_size()
    text = to_text(report_of(write(rows)))
    random.Random(1).shuffle(rows)
    assert to_text(report_of(write(rows))) == text


def test_text_is_printed_and_fits_a_terminal(write, capsys):
    assert tables.main(["storms2003", str(write(full_size()))]) == 0
    printed = capsys.readouterr()
    assert printed.err == ""
    assert max(map(len, printed.out.splitlines())) <= 120
    assert "unknown" not in printed.out and "nan" not in printed.out
    assert "random draws whose seeds are not known" in printed.out.replace("\n  ", " ")


def test_columns_of_text_are_aligned(write):
    for table in report_of(write(full_size())).tables:
        lines = to_text(Report("", [], [table])).strip().splitlines()
        rule = next(i for i, line in enumerate(lines) if line.startswith("--"))
        width = len(lines[rule])
        between = [i for i, mark in enumerate(lines[rule]) if mark == " "]
        for line in lines[rule - 1 : rule + 1 + len(table.rows)]:
            assert len(line) <= width
            assert all(line.ljust(width)[i] == " " for i in between)
        starts = [m.start() for m in re.finditer("-+", lines[rule])]
        for left, right, start in zip(table.columns, table.columns[1:], starts[1:]):
            if rule == 3 and left.block != right.block:  # the line of common headings
                assert lines[1].ljust(width)[start - 2 : start] == "  "
        if table.name == "table_2":  # numbers end where their column ends
            assert all(len(line) == width for line in lines[rule + 1 : rule + 10])


def test_markdown_has_rectangular_tables(write, tmp_path, capsys):
    run = write(full_size())
    arguments = ["storms2003", str(run), "--format", "markdown", "--out", str(tmp_path)]
    assert tables.main(arguments) == 0
    text = (tmp_path / "storms2003.md").read_text()
    for table in report_of(run).tables:
        part = text.split(f"## {table.title}\n\n")[1].split("\n\n")[0].splitlines()
        assert len(part) == 2 + len(table.rows)
        assert {line.count("|") for line in part} == {len(table.columns) + 1}
    assert capsys.readouterr().out.strip() == str(tmp_path / "storms2003.md")


def test_csv_keeps_full_precision(write, tmp_path):
    rows = hand_made()
    rows[5]["retired_nats"] = -7.123456789012345
    run, out = write(rows), tmp_path / "new" / "csv"
    assert tables.main(["storms2003", str(run), "--format", "csv", "--out", str(out)]) == 0
    report = report_of(run)
    assert {p.stem for p in out.iterdir()} == {t.name for t in report.tables}
    frame = pd.read_csv(out / "table_2.csv").set_index(["No.", "what"])
    assert frame.loc[(2, "O"), "ours K=3"] == -17.123456789012345
    assert math.isnan(frame.loc[(1, "Δ"), "ours K=4"])
    shares = pd.read_csv(out / "integrality.csv").set_index(["group", "K"])
    found = values(table_of(report, "integrality"), "A", "3")["ours integral %"]
    line = shares.loc[("A", "3")]
    written = [line[f"ours integral %{ending}"] for ending in ("", " low", " high")]
    assert written == [found.value, found.low, found.high]


def test_a_torn_last_line_is_left_out_with_a_warning(write, capsys):
    whole = to_text(report_of(write(hand_made())))
    run = write(hand_made(), tail=json.dumps(row(scan=9))[:80])
    assert tables.main(["storms2003", str(run)]) == 0
    printed = capsys.readouterr()
    assert printed.out == whole
    assert printed.err.count("\n") == 1 and "rows.jsonl:13" in printed.err


def without(field: str) -> list[Row]:
    rows = hand_made()
    del rows[3][field]
    return rows


@pytest.mark.parametrize(
    "rows, tail, expected",
    [
        ([], "", "no rows"),
        (hand_made(), '{"torn\n' + json.dumps(row(scan=4)) + "\n", "rows.jsonl:13"),
        (hand_made(), "[1]\n" + json.dumps(row(scan=4)) + "\n", "rows.jsonl:13"),
        (hand_made() + [row(scan=4, cost_nats=math.nan), row(scan=5)], "", "rows.jsonl:13"),
        (hand_made() + [row(scan=4, scan_period_s="8")], "", "rows.jsonl:13: scan_period_s"),
        (hand_made() + [row(scan=4, seed=None)], "", "rows.jsonl:13: seed is null"),
        (without("gap_nats"), "", "rows.jsonl:4: the row has no field 'gap_nats'"),
        (hand_made() + [row(scan=4, schema_version=2)], "", "mix schema versions: 1, 2"),
        ([row(schema_version=2)], "", "mix schema versions"),
        (hand_made() + [row(scan=4, seed=2)], "", "several seeds: 1, 2"),
        (hand_made() + [row(scan=1)], "", "two rows of lp-grp for scenario A"),
        (hand_made() + [row("cbc", fingerprint="f" * 16)], "", "two different problems"),
        ([row("cbc"), row("exact")], "", "no rows of lp-grp, which the tables need; it has cbc, "),
        ([row(scenario="crossing")], "", "no rows of scenarios A, B, C or D"),
        ([row(status="great")], "", "unknown status: great"),
    ],
)
def test_unusable_rows_are_one_sentence(write, capsys, rows, tail, expected):
    refused(capsys, write(rows, tail=tail), expected)


def refused(capsys: pytest.CaptureFixture[str], run: Path, expected: str) -> None:
    assert tables.main(["storms2003", str(run)]) == 2
    printed = capsys.readouterr()
    assert printed.out == ""
    assert printed.err.count("\n") == 1 and expected in printed.err


def test_unusable_directories_are_one_sentence(write, tmp_path, capsys):
    refused(capsys, tmp_path / "absent", "no run directory")
    run = write(hand_made())
    (run / "manifest.json").write_text("{")
    refused(capsys, run, "manifest.json is not JSON")
    (run / "manifest.json").write_text("[]")
    refused(capsys, run, "does not hold an object")
    (run / "manifest.json").unlink()
    refused(capsys, run, "has no manifest.json")
    refused(capsys, write(hand_made(), {"schema_version": 3}), "mix schema versions: 1, 3")
    (run / "rows.jsonl").unlink()
    refused(capsys, run, "has no rows.jsonl")


@pytest.mark.parametrize(
    "arguments, expected",
    [(["storms1999", "RUN"], "storms1999"), (["storms2003", "RUN", "--format", "csv"], "--out"),
     (["storms2003", "RUN", "--out", "RUN/manifest.json"], "not a directory"), ([], "required")],
)
def test_bad_usage(write, capsys, arguments, expected):
    run = str(write(hand_made()))
    with pytest.raises(SystemExit) as stopped:
        tables.main([a.replace("RUN", run) for a in arguments])
    printed = capsys.readouterr()
    assert stopped.value.code == 2 and printed.out == "" and expected in printed.err


@pytest.mark.parametrize(("outcome", "told"), [
    ("interrupted", "interrupted, 3 of 10 cells"), ("running", "still running, or was killed"),
    ("disk failure", "disk failure, 3 of 10 cells"),
])
def test_an_unfinished_run_is_called_so(write, capsys, outcome, told):
    summary = {"cells": 10, "cells_finished": 3}
    run = write(hand_made(), {**MANIFEST, "outcome": outcome, "summary": summary})
    assert tables.main(["storms2003", str(run)]) == 0
    printed = capsys.readouterr()
    for text in (printed.out, printed.err):
        text = " ".join(text.split())
        assert "did not finish" in text and told in text
    write(hand_made(), {**MANIFEST, "outcome": "finished"})
    assert tables.main(["storms2003", str(run)]) == 0
    printed = capsys.readouterr()
    assert "did not finish" not in printed.out + printed.err


@pytest.mark.parametrize("out", [">/dev/full", ">&-"])
@pytest.mark.parametrize("options", [[], ["--format", "csv", "--out", "files"]])
def test_an_output_that_takes_nothing_is_one_sentence(write, out, options):
    if not Path("/dev/full").is_char_device():
        pytest.skip("no /dev/full here")
    run = write(hand_made())
    words = shlex.join([sys.executable, tables.__file__, "storms2003", str(run), *options])
    done = subprocess.run(["bash", "-c", f"{words} {out}"], cwd=run, capture_output=True, text=True)
    assert done.returncode == 5
    assert done.stderr.count("\n") == 1
    assert done.stderr.startswith("tables.py: cannot write to standard output")
