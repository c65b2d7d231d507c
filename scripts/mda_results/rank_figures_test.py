"""Figures of the ranking: that they show what its tables say."""

from pathlib import Path

import pytest

import figures
from mda_results import pool, rank_figures, rank_report, testing
from mda_results.ranking_testing import MANIFEST, row, study, write

plt = pytest.importorskip("matplotlib.pyplot")


def draw(run: Path, *options: str) -> int:
    return figures.main(["ranking", str(run), *options])


@pytest.fixture(scope="module")
def run(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return write(tmp_path_factory.mktemp("study") / "run", study())


def axes_of(run: Path, name: str) -> list:
    """With curves or points, in their order."""
    figure = rank_figures.figures(pool.load([run]))[name]()
    plt.close(figure)
    return [axis for axis in figure.axes if axis.has_data()]


def table(run: Path, name: str):
    found = rank_report.rank(pool.load([run]))
    return next(t for t in [*found.report.tables, *found.data] if t.name == name)


def test_every_figure_is_drawn_and_the_same_again(run, tmp_path, capsys):
    for place in ("a", "b"):
        assert draw(run, "--out", str(tmp_path / place)) == 0
    names = {"gap_against_time", "profiles", "time_to_gap"}
    assert {p.name for p in (tmp_path / "a").iterdir()} == {
        f"{n}.{e}" for n in names for e in ("png", "svg")}
    for name in names:
        one, other = ((tmp_path / place / f"{name}.svg").read_bytes() for place in ("a", "b"))
        assert one == other
    assert capsys.readouterr().err == ""


def test_points_are_those_of_the_pareto_table(run):
    front = table(run, "pareto")
    for axis, hardness in zip(axes_of(run, "gap_against_time"), ("easy", "hard")):
        assert hardness in axis.get_title()
        drawn = {bars.get_label(): (bars[0].get_xdata()[0], bars[0].get_ydata()[0])
                 for bars in axis.containers}
        for algorithm in drawn:
            line = testing.values(front, hardness, algorithm)
            assert drawn[algorithm] == pytest.approx((line["CPU [ms]"], line["gap [nats]"]))
        assert set(drawn) == {r[1] for r in front.rows if r[0] == hardness}
        steps = next(line for line in axis.get_lines() if line.get_label() == "best trade-off")
        unbeaten = {drawn[r[1]] for r in front.rows if r[0] == hardness and r[4] == "front"}
        assert set(zip(*steps.get_data())) == unbeaten


@pytest.mark.parametrize(("figure", "name"), [("profiles", "profiles_fine"),
                                              ("time_to_gap", "time_to_gap_fine")])
def test_curves_are_those_of_the_fine_tables(run, figure, name):
    fine = table(run, name)
    for axis, hardness in zip(axes_of(run, figure), ("easy", "hard")):
        for line in axis.get_lines():
            values = next(r for r in fine.rows if r[:2] == [hardness, line.get_label()]
                          and (figure == "profiles" or r[2] == 0.0))
            points = line.get_ydata()
            assert list(points) == pytest.approx(values[-len(points):])


def test_the_disqualified_are_not_drawn(tmp_path):
    rows = [*study(), row("wrong", scenario="A", replicate=1, scan=1, window_k=3,
                          status="failed", note="refuted")]
    axes = axes_of(write(tmp_path / "run", rows), "gap_against_time")
    assert all("wrong" not in axis.get_legend_handles_labels()[1] for axis in axes)


def test_nothing_to_rank_is_one_sentence(tmp_path, capsys):
    run = testing.write_run(tmp_path / "run", [row("lp", answer="relaxation", gap_nats=None)],
                            MANIFEST)
    assert draw(run, "--only", "profiles") == 2
    printed = capsys.readouterr()
    assert printed.out == "" and printed.err.count("\n") == 1
    assert "no selections to rank" in printed.err
