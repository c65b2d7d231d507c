"""The command for figures: what it draws, names and refuses."""

import json
import sys
from pathlib import Path

import numpy as np
import pandas as pd
import pytest

import figures
from mda_results import battistelli_overview, bootstrap, known_testing, palette
from mda_results.known_testing import open_row, outing, write_known

pytest.importorskip("matplotlib")
PAIR = ["battistelli-1", "battistelli-2"]


def draw(run: Path, *options: str) -> int:
    return figures.main(["battistelli2008", str(run), *options])


def test_every_figure_is_drawn(tmp_path, capsys):
    run = write_known(tmp_path / "run", known_testing.study_rows(2, 1, PAIR),
                      known_testing.study_outings(2, PAIR))
    (run / "trajectories.json").write_text(json.dumps(known_testing.trajectories(PAIR)))
    assert draw(run) == 0
    names = {"figure_3", "figure_4", "figure_5", "figure_6", "figure_7", "figure_8",
             "figure_9_scf-tie", "figure_9_mcf", "gap_by_k", "gap_against_cpu"}
    files = list((run / "figures").iterdir())
    assert {f.name for f in files} == {f"{n}.{e}" for n in names for e in ("png", "svg")}
    assert all(f.stat().st_size > 5000 for f in files)
    printed = capsys.readouterr()
    assert set(printed.out.split()) == {str(f) for f in files} and printed.err == ""
    text = (run / "figures" / "figure_7.svg").read_text()
    for label in ("ideal", "oracle", "scf-tie", "mcf", "time [s]", "mean d(t) [m]"):
        assert f">{label}<" in text


def test_the_same_run_gives_the_same_file(tmp_path):
    run = write_known(tmp_path / "run", [open_row("scf")], [])
    for place in ("a", "b"):
        assert draw(run, "--only", "gap_by_k", "--out", str(tmp_path / place)) == 0
    assert (tmp_path / "a/gap_by_k.svg").read_bytes() == (tmp_path / "b/gap_by_k.svg").read_bytes()


def test_what_is_missing_is_named(tmp_path, capsys):
    run = write_known(tmp_path / "run", [], [outing("scf-tie", position_error_m=9.0)],
                      {"schema_version": 1})
    assert draw(run) == 0
    printed = capsys.readouterr()
    assert {Path(p).stem for p in printed.out.split()} == {"figure_7", "figure_8",
                                                          "figure_9_scf-tie"}
    assert printed.err.count("is left out") == 7
    assert "figure_9_mcf is left out: run has no finished outings of mcf" in printed.err


@pytest.mark.parametrize(("options", "expected"), [
    (["--only", "figure_4"], "no finished outings of battistelli-1 or"),
    (["--only", "figure_3"], "no trajectories"), (["--only", "figure_2"], "no figure figure_2"),
    (["--only", "gap_by_k"], "no answered windows in open loop"),
])
def test_what_cannot_be_drawn_is_one_sentence(tmp_path, capsys, options, expected):
    run = write_known(tmp_path / "run", [], [outing("scf-tie")], {"schema_version": 1})
    assert draw(run, *options) == 2
    printed = capsys.readouterr()
    assert printed.out == "" and printed.err.count("\n") == 1 and expected in printed.err


def test_wrong_trajectories_are_refused(tmp_path, capsys):
    run = write_known(tmp_path / "run", [open_row()], [])
    (run / "trajectories.json").write_text('{"battistelli-1": {"targets": [[1]]}}')
    assert draw(run, "--only", "figure_3") == 2
    assert "no lists of pairs" in capsys.readouterr().err


def test_matplotlib_may_be_missing(tmp_path, capsys, monkeypatch):
    monkeypatch.setitem(sys.modules, "matplotlib", None)
    run = write_known(tmp_path / "run", [open_row()], [])
    assert draw(run) == 2
    assert capsys.readouterr().err == "figures.py: figures need the package python3-matplotlib\n"


def test_no_two_algorithms_look_alike():
    names = [*palette._STYLES, *(f"{a}-by-scan" for a in ("gnn", "nn", "jpda", "pda", "jpda-cheap",
                                                          "lbp", "hnpda", "mapada-miss"))]
    looks = [palette.style_of(name) for name in names]
    assert len(set(looks)) == len(looks)


def test_entries_of_one_colour_have_markers_of_their_own():
    """Those that go scan by scan share theirs with the single-scan method; hollow and dashed."""
    looks = list(palette._STYLES.values())
    assert len({(look.color, look.marker) for look in looks}) == len(looks)
    for name in ("gnn", "nn", "jpda", "lbp"):
        one, other = palette.style_of(name), palette.style_of(f"{name}-by-scan")
        assert one.dash != other.dash and other.hollow


def test_the_best_trade_offs_are_beaten_by_none(monkeypatch):
    random = np.random.default_rng(3)
    means = pd.DataFrame({"cpu_ms": random.random(30), "gap_nats": random.integers(0, 9, 30)})
    drawn = {}

    class Axis:
        def step(self, x, y, **_):
            drawn["front"] = set(zip(x, y))

    battistelli_overview._front(Axis(), means)
    points = list(zip(means["cpu_ms"], means["gap_nats"]))
    unbeaten = {p for p in points if not any(
        q != p and q[0] <= p[0] and q[1] <= p[1] for q in points)}
    assert drawn["front"] == unbeaten


def test_a_band_is_the_interval_at_every_point():
    values = np.random.default_rng(4).normal(size=(6, 3))
    band = bootstrap.band("A", values)
    for point in range(3):
        frame = pd.DataFrame({"group": "A", "replicate": range(6), "x": values[:, point], "one": 1})
        expected = bootstrap.ratio(frame, "x", "one")
        assert [band.mean[point], band.low[point], band.high[point]] == pytest.approx(
            [expected.value, expected.low, expected.high])
