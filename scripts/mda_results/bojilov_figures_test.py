"""Figures of Bojilov: what is drawn, from what, and what is named when it is not there."""

from pathlib import Path

import pytest

import figures
from mda_results import bojilov_figures, three_sensors
from mda_results.sensor_testing import AXIS, rows_of, sensor_row
from mda_results.testing import write_run

plt = pytest.importorskip("matplotlib.pyplot")

NAMES = ("bojilov-untreated", *AXIS, "bojilov-calibrated", "greedy", "exact")


def draw(run: Path, *options: str) -> int:
    return figures.main(["bojilov1995", str(run), *options])


def drawn(run: Path, name: str):
    """The figure, closed for others to count."""
    figure = bojilov_figures.figures(three_sensors.load(run))[name]()
    plt.close(figure)
    return figure


def axes_of(figure) -> list:
    """Those with curves: the legend's has none of its own."""
    return [axis for axis in figure.axes if axis.has_data()]


def curves_of(axis) -> dict[str, list[tuple[float, float]]]:
    """The labelled curves, point by point."""
    return {line.get_label(): list(zip(*line.get_data())) for line in axis.get_lines()
            if str(line.get_label()).startswith("σ")}


def labels_at(axis) -> dict[float, str]:
    return dict(zip(axis.get_xticks(), (t.get_text() for t in axis.get_xticklabels())))


def test_every_figure_is_drawn(tmp_path, capsys):
    run = write_run(tmp_path / "run", [
        line for scene in ("36", "64") for f in (0.0, 0.1, 0.3) for a in NAMES
        for line in rows_of(a, 9, (0.1, 0.2), scene=scene, false_alarms=f)])
    assert draw(run) == 0
    files = list((run / "figures").iterdir())
    assert {f.name for f in files} == {f"{n}.{e}" for e in ("png", "svg") for n in (
        "figure_2_f0", "figure_2_f0.1", "figure_2_f0.3", "gap_by_sigma")}
    printed = capsys.readouterr()
    assert set(printed.out.split()) == {str(f) for f in files} and printed.err == ""
    text = (run / "figures" / "figure_2_f0.3.svg").read_text()
    for label in ("σ = 0.1", "σ = 0.2", "exact", "calibrated", "correct association [%]"):
        assert f">{label}<" in text
    assert ">worst ties<" not in text and ">σ = 0.3<" not in text


def test_every_threshold_stands_at_its_own_place(tmp_path):
    """Counts of exact tuples that tell the algorithms apart, of 20 targets: 5 points each."""
    right = {name: 2 + n for n, name in enumerate(NAMES)}
    run = write_run(tmp_path / "run", [line for a in NAMES for line in rows_of(a, right[a])])
    axis = axes_of(drawn(run, "figure_2_f0.1"))[0]
    labels = labels_at(axis)
    curve = {labels[x]: y for x, y in curves_of(axis)["σ = 0.2"]}
    assert curve == pytest.approx(
        {f"{loss:g}": 5.0 * right[a] for loss, a in three_sensors.LOSSES.items()})
    apart = {labels[x]: y for bars in axis.containers for x, y in zip(*bars[0].get_data())}
    ours = {"x": "bojilov-untreated", "calibrated": "bojilov-calibrated", "greedy": "greedy",
            "exact": "exact"}
    assert apart == pytest.approx({label: 5.0 * right[a] for label, a in ours.items()})


def test_a_band_is_the_interval_of_the_table(tmp_path):
    lines = [sensor_row(replicate=r, right=right) for r, right in zip((1, 2, 3), (8, 16, 4))]
    lines += [sensor_row("bojilov-loss-0.025", replicate=r) for r in (1, 2, 3)]
    run = write_run(tmp_path / "run", lines)
    axis = axes_of(drawn(run, "figure_2_f0.1"))[0]
    band = axis.collections[0].get_paths()[0].vertices
    loaded = three_sensors.load(run).rows
    own = three_sensors.target_exact(loaded[loaded["algorithm"] == "bojilov"])
    at = {label: x for x, label in labels_at(axis).items()}["1"]
    assert {round(y, 9) for x, y in band if x == at} == {round(own.low, 9), round(own.high, 9)}


def test_one_axis_per_number_of_targets_and_layout(tmp_path):
    run = write_run(tmp_path / "run", [line for scene in ("64", "36", "36-random")
                                       for line in rows_of("bojilov", scene=scene)])
    titles = [axis.get_title() for axis in axes_of(drawn(run, "figure_2_f0.1"))]
    assert [title.split(";")[0] for title in titles] == [
        "36 targets", "36 targets, anywhere", "64 targets"]


def test_gaps_are_drawn_in_percent(tmp_path):
    lines = rows_of("bojilov", sigmas=(0.1, 0.2), gap_nats=0.5, cost_nats=-9.5)
    run = write_run(tmp_path / "run", lines + rows_of("exact", sigmas=(0.1, 0.2)))
    bars = axes_of(drawn(run, "gap_by_sigma"))[0].containers
    assert [bar.get_label() for bar in bars] == ["bojilov"]
    assert list(bars[0][0].get_ydata()) == pytest.approx([5.0, 5.0])


def test_what_is_missing_is_named(tmp_path, capsys):
    run = write_run(tmp_path / "run", rows_of("bojilov"))
    assert draw(run) == 0
    printed = capsys.readouterr()
    assert {Path(p).stem for p in printed.out.split()} == {"figure_2_f0.1", "gap_by_sigma"}
    assert "figure_2_f0.3 is left out: run has no answers of bojilov with 0.3" in printed.err


@pytest.mark.parametrize(("lines", "only", "expected"), [
    (rows_of("exact"), "figure_2_f0.1", "no answers of bojilov with 0.1 false alarms"),
    (rows_of("exact"), "gap_by_sigma", "no answers with a gap on a grid"),
    (rows_of("bojilov"), "figure_3", "no figure figure_3"),
    (rows_of("bojilov", status="failed", cost_nats=None), "figure_2_f0.1", "no answers of bojilov"),
])
def test_what_cannot_be_drawn_is_one_sentence(tmp_path, capsys, lines, only, expected):
    run = write_run(tmp_path / "run", lines)
    assert draw(run, "--only", only) == 2
    printed = capsys.readouterr()
    assert printed.out == "" and printed.err.count("\n") == 1 and expected in printed.err
