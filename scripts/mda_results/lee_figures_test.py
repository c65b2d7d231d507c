"""Figures of Lee & Jeong: what is drawn, from what, and what is named when it is not there."""

import json
from pathlib import Path

import numpy as np
import pandas as pd
import pytest

import figures
from mda_results import bootstrap
from mda_results.position_testing import outing, study, trajectories, write_position

pytest.importorskip("matplotlib")

SHOWN = ("oracle", "gnn", "mapada", "hnpda")


def draw(run: Path, *options: str) -> int:
    return figures.main(["lee1998", str(run), *options])


def test_every_figure_is_drawn(tmp_path, capsys):
    run = write_position(tmp_path / "run", study(2, SHOWN, (0.2, 0.8)))
    (run / "trajectories.json").write_text(json.dumps(trajectories()))
    assert draw(run) == 0
    names = ["figure_4", "figure_6", "figure_7", "figure_8", "figure_9", "maintenance_450m",
             "maintenance_750m"]
    files = list((run / "figures").iterdir())
    assert {f.name for f in files} == {f"{n}.{e}" for n in names for e in ("png", "svg")}
    assert all(f.stat().st_size > 5000 for f in files)
    printed = capsys.readouterr()
    assert set(printed.out.split()) == {str(f) for f in files} and printed.err == ""
    text = (run / "figures" / "figure_7.svg").read_text()
    for label in (*SHOWN, "time [s]", "rms position error [km]"):
        assert f">{label}<" in text
    assert ">jpda<" not in text
    assert ">mapada, paper<" in (run / "figures" / "maintenance_450m.svg").read_text()


def test_what_is_missing_is_named(tmp_path, capsys):
    run = write_position(tmp_path / "run", [outing("gnn")])
    assert draw(run) == 0
    printed = capsys.readouterr()
    assert {Path(p).stem for p in printed.out.split()} == {
        "figure_4", "figure_7", "maintenance_450m", "maintenance_750m"}
    assert printed.err.count("is left out") == 3
    assert "no finished outings of hnpda or mapada on the crossing targets" in printed.err


@pytest.mark.parametrize(("options", "expected"), [
    (["--only", "figure_6"], "no trajectories of lee-crossing"),
    (["--only", "figure_9"], "on the parallel targets"),
    (["--only", "figure_3"], "no figure figure_3"),
])
def test_what_cannot_be_drawn_is_one_sentence(tmp_path, capsys, options, expected):
    run = write_position(tmp_path / "run", [outing("mapada")])
    assert draw(run, *options) == 2
    printed = capsys.readouterr()
    assert printed.out == "" and printed.err.count("\n") == 1 and expected in printed.err


def test_a_sample_is_of_a_run_that_both_finished(tmp_path, capsys):
    run = write_position(tmp_path / "run", [outing("mapada", replicate=1),
                                            outing("hnpda", replicate=2)])
    (run / "trajectories.json").write_text(json.dumps(trajectories()))
    assert draw(run, "--only", "figure_6") == 2
    assert "no run of lee-crossing that hnpda and mapada finished" in capsys.readouterr().err


def test_a_band_of_ratios_is_the_interval_of_the_pooled_ratio():
    random = np.random.default_rng(6)
    squares, counts = random.random((9, 3)), random.integers(0, 3, 9).astype(float)
    found = bootstrap.ratio_band("crossing", squares, counts, np.sqrt)
    for point in range(3):
        frame = pd.DataFrame({"group": "crossing", "replicate": range(9), "n": counts,
                              "x": squares[:, point]})
        expected = bootstrap.ratio(frame, "x", "n", np.sqrt)
        assert [found.mean[point], found.low[point], found.high[point]] == pytest.approx(
            [expected.value, expected.low, expected.high])
