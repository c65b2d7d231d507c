"""The page's command: what it writes and refuses. What the page does stands in
report_page_test.py."""

import random
import re
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

import report
from mda_results import output, page_assets, page_data, page_testing, palette, testing
from mda_results.known_testing import outing, skipped, write_known
from mda_results.page_courses import courses
from mda_results.page_scenes import scenes_of
from mda_results.ranking_testing import MANIFEST, row, study
from mda_results.rows import RunError
from mda_results.sensor_testing import rows_of


@pytest.fixture
def make(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Callable[..., Path]:
    """Writes the page of these rows, without the script of the page."""
    monkeypatch.setattr(page_assets, "bundle", lambda: "")
    monkeypatch.setattr(page_assets, "licences", lambda: "")

    def made(rows: list[testing.Row], manifest: Any = MANIFEST, name: str = "run") -> Path:
        run = testing.write_run(tmp_path / name, rows, manifest)
        assert report.main([str(run), "--out", str(tmp_path / "page.html")]) == 0
        return tmp_path / "page.html"
    return made


def refused(capsys: pytest.CaptureFixture[str], run: Path, expected: str) -> None:
    out = run.parent / "never.html"
    assert report.main([str(run), "--out", str(out)]) == 2
    printed = capsys.readouterr()
    assert not out.exists() and printed.out == ""
    assert printed.err.count("\n") == 1 and printed.err.startswith("report.py: ")
    assert expected in printed.err


def test_without_the_chart_library_it_says_how_to_get_it(tmp_path, monkeypatch, capsys):
    monkeypatch.setattr(page_assets, "ASSETS", tmp_path / "nothing")
    refused(capsys, testing.write_run(tmp_path / "run", study(2, 2)), "scripts/setup.sh --report")


@pytest.mark.parametrize(("rows", "manifest", "expected"), [
    ([], MANIFEST, "no rows"),
    ([row("exact"), row("exact", scan=2, schema_version=2)], MANIFEST, "mix schema versions"),
    ([row("exact"), row("exact")], MANIFEST, "two rows of exact"),
    ([row("exact")], [], "does not hold an object"),
])
def test_unusable_runs_are_one_sentence(tmp_path, make, capsys, rows, manifest, expected):
    refused(capsys, testing.write_run(tmp_path / "run", rows, manifest), expected)


def test_a_missing_manifest_is_one_sentence(tmp_path, make, capsys):
    run = testing.write_run(tmp_path / "run", study(2, 2))
    (run / "manifest.json").unlink()
    refused(capsys, run, "has no manifest.json")
    refused(capsys, tmp_path / "absent", "no run directory")


def test_a_torn_last_line_is_told_in_the_page_too(tmp_path, make, capsys):
    make(study(2, 2))
    run = testing.write_run(tmp_path / "run", study(2, 2), {**MANIFEST, "outcome": "running"},
                            '{"torn')
    assert report.main([str(run), "--out", str(tmp_path / "page.html")]) == 0
    assert "torn" in capsys.readouterr().err
    assert "the last line is torn" in (tmp_path / "page.html").read_text()


@pytest.mark.parametrize("name", ["rows", "scenes"])
def test_a_finished_run_has_no_torn_line(tmp_path, make, capsys, name):
    run = page_testing.write_scenes(testing.write_run(tmp_path / "run", study(2, 2)),
                                    [page_testing.scene()])
    with (run / f"{name}.jsonl").open("a") as file:
        file.write('{"torn')
    refused(capsys, run, "the last line is torn, though the run finished")


@pytest.mark.parametrize(("scene", "expected"), [
    (page_testing.scene(schema_version=2), "scenes.jsonl:1: its schema version"),
    (page_testing.scene(plots=None), "scenes.jsonl:1: "),
    (page_testing.scene(answers=[{"algorithm": "exact", "window_k": 3, "loop": "open",
                                  "scans": [{"scan": 1, "tracks": [[1, 99]]}]}]),
     "plot 99 of scan 1, which is not there"),
    (page_testing.scene(answers=[{"algorithm": "exact", "window_k": 3, "loop": "ajar",
                                  "scans": []}]), 'unknown loop: "ajar"'),
    ({"schema_version": 1}, "no field 'plots'"),
])
def test_damaged_scenes_are_one_sentence(tmp_path, make, capsys, scene, expected):
    run = testing.write_run(tmp_path / "run", study(2, 2))
    refused(capsys, page_testing.write_scenes(run, [scene]), expected)


def parts_of(scene: dict[str, Any]) -> list[dict[str, Any]]:
    """The scene as a run writes it, an answer a line."""
    return [{**scene, "answers": [answer]} for answer in scene["answers"]]


def test_the_lines_about_a_scene_are_one_scene_in_any_order(tmp_path):
    first, second = page_testing.scene(), page_testing.scene(2, scenario="B")
    lines = [*parts_of(first), *parts_of(second)]
    found = []
    for turn in range(3):
        random.Random(turn).shuffle(lines)
        found.append(scenes_of(page_testing.write_scenes(tmp_path, lines), []))
        assert found[-1] == found[0]
    assert [scene["scenario"] for scene in found[0]] == ["A", "B"]
    for scene, whole in zip(found[0], (first, second)):
        assert scene["plots"] == whole["plots"] and scene["targets"] == whole["targets"]
        names = [(a["window_k"], a["algorithm"], a["loop"]) for a in scene["answers"]]
        assert names == sorted((a["window_k"], a["algorithm"], a["loop"])
                               for a in whole["answers"])


def test_lines_that_tell_one_scene_differently_are_one_sentence(tmp_path, make, capsys):
    run = testing.write_run(tmp_path / "run", study(2, 2))
    other = page_testing.scene(range_km=51.0)
    page_testing.write_scenes(run, [page_testing.scene(), other])
    refused(capsys, run, "scenes.jsonl:2: another line has other plots or targets")


def test_a_torn_last_scene_is_left_out_and_told(tmp_path):
    warnings: list[str] = []
    lines = [page_testing.scene(), page_testing.scene(2, scenario="B")]
    found = scenes_of(page_testing.write_scenes(tmp_path, lines, '{"schema_version": 1, "sc'),
                      warnings)
    assert len(found) == 2 and len(warnings) == 1 and "torn" in warnings[0]


def test_the_same_rows_give_the_same_page(make):
    rows = study(3, 2)
    first = make(rows).read_bytes()
    random.Random(1).shuffle(rows)
    assert make(rows).read_bytes() == first


def test_the_tables_need_no_script(make):
    text = make(study(3, 3)).read_text()
    ranking = re.search(r'data-table="ranking".*?</table>', text, re.DOTALL)
    assert ranking is not None
    for name in ("exact", "quick", "late"):
        assert f">{name}</td>" in ranking[0]
    for name in ("fates", "gaps", "profiles", "time_to_gap", "scaling", "pareto"):
        assert f'data-table="{name}"' in text


def test_the_tables_of_the_study_of_three_sensors_are_there(make):
    text = make([*rows_of("bojilov"), *rows_of("exact")]).read_text()
    assert '<section id="bojilov1995-run">' in text and 'data-table="figure_2_36_f0.1"' in text


def test_what_runs_hold_is_never_markup(make):
    evil = "</script><script>alert(1)</script><b>"
    rows = [*study(2, 2), row(evil, scan=1, note=evil)]
    text = make(rows, {**MANIFEST, "commit": evil}).read_text()
    assert text.count("<script") == 2 and "<b>" not in text and "alert(1)&lt;/script" in text


def test_nothing_in_the_page_is_elsewhere(make):
    text = make(study(2, 2)).read_text()
    assert re.findall(r'(?:src|href)="(?!#|data:)[^"]*"', text) == []
    assert re.findall(r"url\((?!#|data:)", text) == []


def test_compressed_columns_hold_the_values():
    import pandas as pd
    frame = pd.DataFrame({"cost_nats": [-1.25, float("nan"), float("inf")], "note": ["b", "a", "b"],
                          "scan": [3, 1, 2], "integral": [1.0, float("nan"), 0.0]})
    columns = page_data._table(frame)["columns"]
    assert columns["cost_nats"] == {"values": [-1.25, None, None], "infinite": [2]}
    assert columns["note"] == {"values": [1, 0, 1], "words": ["a", "b"]}
    assert columns["scan"]["values"] == [3, 1, 2]
    assert columns["integral"]["values"] == [True, None, False]


def test_colours_stay_apart_and_readable_on_a_dark_ground():
    def brightness(color: str) -> float:  # relative luminance of WCAG 2
        parts = [int(color[i:i + 2], 16) / 255 for i in (1, 3, 5)]
        linear = [p / 12.92 if p <= 0.04045 else ((p + 0.055) / 1.055) ** 2.4 for p in parts]
        return 0.2126 * linear[0] + 0.7152 * linear[1] + 0.0722 * linear[2]

    style = (page_assets.SOURCES / "page.css").read_text()
    ground = re.findall(r"--card: (#\w{6})", style)[-1]
    colors = {s.color for s in palette._STYLES.values()} | {palette.style_of("unheard-of").color}
    dark = {palette.on_dark(color) for color in colors}
    assert len(dark) == len(colors)
    for color in dark:
        assert (brightness(color) + 0.05) / (brightness(ground) + 0.05) >= 4.5, color


def test_courses_are_means_over_scenes(tmp_path):
    errors = [[float(n + r) for n in range(8)] for r in (0, 3)]
    outings = [outing("scf", replicate=r + 1, position_error_series_m=errors[r]) for r in (0, 1)]
    outings.append(skipped(outing("mcf")))
    outings[0]["per_track_series"] = [[1.0], [2.0]]
    found = courses([write_known(tmp_path / "run", [], outings)])
    assert [(c["algorithm"], c["scenes"]) for c in found] == [("scf", 2)]
    assert "per_track_series" not in found[0]["series"]
    assert found[0]["series"]["position_error_series_m"] == [n + 1.5 for n in range(8)]
    outings[1]["position_error_series_m"] = [1.0]
    with pytest.raises(RunError, match="of different lengths"):
        courses([write_known(tmp_path / "run", [], outings)])


@pytest.mark.parametrize("arguments", [[], ["RUN"], ["--out", "x.html"], ["RUN", "--out", "."]])
def test_bad_usage(arguments, capsys):
    with pytest.raises(SystemExit) as stopped:
        report.main(arguments)
    assert stopped.value.code == 2 and capsys.readouterr().out == ""


def test_a_place_that_cannot_be_written_is_one_sentence(tmp_path, make, capsys):
    run = make(study(2, 2)).parent / "run"
    (tmp_path / "file").write_text("")
    capsys.readouterr()
    assert report.main([str(run), "--out", str(tmp_path / "file" / "page.html")]) == 5
    printed = capsys.readouterr()
    assert printed.err.count("\n") == 1 and "cannot write to" in printed.err


def test_the_command_has_its_help():
    done = subprocess.run([sys.executable, report.__file__, "--help"], capture_output=True,
                          text=True, check=True)
    assert "scripts/setup.sh --report" in done.stdout


def test_a_page_that_cannot_be_written_leaves_what_was_there(tmp_path, monkeypatch):
    place = tmp_path / "report.html"
    place.write_text("before")

    def full(*_: object) -> None:
        raise OSError(28, "full")

    monkeypatch.setattr(Path, "replace", full)
    with pytest.raises(OSError, match="full"):
        output.write_whole(place, "after")
    assert [(p.name, p.read_text()) for p in tmp_path.iterdir()] == [("report.html", "before")]
