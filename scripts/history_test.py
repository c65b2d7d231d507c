"""The history: steps are dated and named, quiet series stay quiet, and it is made anew alike."""

import json
import sqlite3
from pathlib import Path
from typing import Any
from xml.etree import ElementTree

import numpy as np
import pytest

import history as program
import report
from mda_nightly import changepoints, history, page_history, testing
from mda_nightly.changepoints import LEAST_LEVEL, steps
from mda_nightly.sessions import ANCHOR, CANDIDATE
from mda_nightly.testing import CELLS, samples, write_session

NIGHTS = 60
STEP = float(np.log(1.05))


def nights(seed: int, noise: float = 0.01) -> np.ndarray:
    """Log ratios to the anchor; one night in twenty is wild."""
    draw = np.random.default_rng(seed)
    return draw.normal(0, noise, NIGHTS) + draw.normal(0, 0.1, NIGHTS) * (draw.random(NIGHTS) < 0.05)


def test_a_step_of_five_percent_is_dated_within_a_night() -> None:
    dated = 0
    for seed in range(1, 101):
        first = int(np.random.default_rng([seed, 1]).integers(LEAST_LEVEL + 3, NIGHTS - LEAST_LEVEL))
        values = nights(seed, 0.005)
        values[first:] += STEP
        found = steps(values)
        dated += len(found) == 1 and abs(found[0].first - first) <= 1 and (
            abs(found[0].size - STEP) < 0.01)
    assert dated >= 95


def test_at_most_one_quiet_history_in_twenty_cries() -> None:
    assert sum(bool(steps(nights(seed))) for seed in range(1, 201)) <= 10


def test_a_slow_drift_of_the_machine_is_not_seen_in_ratios_but_two_steps_are() -> None:
    values = nights(7, 0.005)
    values[20:] += STEP
    values[40:] -= 2 * STEP
    found = steps(values)
    assert [abs(s.first - t) <= 1 for s, t in zip(found, (20, 40), strict=True)] == [True, True]
    assert found[0].size > 0 > found[1].size


def test_units_and_sign_change_nothing() -> None:
    for seed in range(1, 6):
        values = nights(seed)
        values[30:] += STEP
        plain = [(s.first, s.p) for s in steps(values)]
        assert plain == [(s.first, s.p) for s in steps(7.0 + 3.0 * values)]
        assert plain == [(s.first, s.p) for s in steps(-values)]


def test_time_turned_around_finds_the_same_split() -> None:
    values = nights(3, 0.005)
    values[25:] += STEP
    assert [s.first for s in steps(values[::-1])] == [NIGHTS - s.first for s in steps(values)]


@pytest.mark.parametrize("values", [[], [0.0] * 5, [0.0] * 60, [0.0] * 30 + [9.0] + [0.0] * 29])
def test_short_constant_and_once_wild_series_have_no_step(values: list[float]) -> None:
    assert steps(np.array(values)) == []


def test_steps_of_counts_without_noise_are_exact() -> None:
    values = np.zeros(20)
    values[13:] = 0.002
    assert [s.first for s in steps(values)] == [13]


def write_nights(directory: Path, count: int, first_slow: int, **changes: Any) -> Path:
    """Sessions in which the candidate is slower on one cell from a night on."""
    for n in range(1, count + 1):
        def slowdown(cell: str, side: str, slow: bool = n >= first_slow) -> float:
            return STEP if slow and side == CANDIDATE and cell == CELLS[2] else 0.0

        sides = testing.facts()["sides"]
        sides[CANDIDATE]["commit"] = f"commit{n:03d}"
        instructions = {(CELLS[2], ANCHOR): 1000, (CELLS[2], CANDIDATE): 1000 + 50 * (n >= first_slow)}
        write_session(directory / f"night{n:03d}", samples(n, slowdown, rounds=9, noise=0.003,
                                                           wild=0.003), instructions,
                      id=f"night{n:03d}", started=f"2026-01-{n:02d}T02:00:00Z", sides=sides,
                      **changes)
    return directory


def test_a_step_is_named_by_its_commits(tmp_path: Path, capsys: Any) -> None:
    sessions, database = write_nights(tmp_path / "s", 20, 12), tmp_path / "h.sqlite"
    assert program.main(["--sessions", str(sessions), "--database", str(database),
                         "--format", "json"]) == 0
    tables = {t["name"]: t for t in json.loads(capsys.readouterr().out)["tables"]}
    found = {(line[1], line[2]): line for line in tables["changes"]["rows"]}
    assert set(found) == {("CPU time", CELLS[2]), ("instructions", CELLS[2])}
    for line in found.values():
        assert line[5] == "commit011..commit012"
        assert line[4] == pytest.approx(5.0, abs=1.0)
    assert len(tables["nights"]["rows"]) == 20


def test_made_again_it_is_the_same_and_machines_stay_apart(tmp_path: Path) -> None:
    sessions = write_nights(tmp_path / "s", 4, 9)
    write_session(sessions / "elsewhere", samples(1), id="elsewhere",
                  machine={"cpu": "New Faithful", "cores": 8})
    first, second = tmp_path / "1.sqlite", tmp_path / "2.sqlite"
    for database in (first, second, second):
        assert history.rebuild(sessions, database) == []
    assert history.dump(first) == history.dump(second)
    _, series = history.load(first)
    assert {s.machine for s in series} == {"Old Faithful, 2 cores", "New Faithful, 8 cores"}
    assert all(len(s.values) == (1 if "New" in s.machine else 4) for s in series)


def test_damaged_sessions_are_left_out_and_named(tmp_path: Path) -> None:
    sessions = write_nights(tmp_path / "s", 3, 9)
    torn = sessions / "night002" / "samples.jsonl"
    torn.write_text(torn.read_text()[:-9])
    said = history.rebuild(sessions, tmp_path / "h.sqlite")
    assert len(said) == 1 and "night002" in said[0]
    assert [n.name for n in history.load(tmp_path / "h.sqlite")[0]] == ["night001", "night003"]


@pytest.mark.parametrize("changes, word", [
    ({"id": "night001"}, "its id is that of night001"), ({"started": None}, "started is null"),
    ({"machine": 5}, "machine is 5"), ({"broken": []}, "broken is []"),
    ({"sides": {k: v for k, v in testing.facts()["sides"].items() if k != ANCHOR}}, "anchor")])
def test_one_bad_night_is_named_and_stops_nothing(changes: dict[str, Any], word: str,
                                                  tmp_path: Path) -> None:
    sessions = write_nights(tmp_path / "s", 3, 9)
    path = sessions / "night002" / "session.json"
    path.write_text(json.dumps({**json.loads(path.read_text()), **changes}))
    said = history.rebuild(sessions, tmp_path / "h.sqlite")
    assert len(said) == 1 and said[0].startswith("left out night002: ") and word in said[0]
    assert [n.name for n in history.load(tmp_path / "h.sqlite")[0]] == ["night001", "night003"]
    assert {p.name for p in tmp_path.iterdir()} == {"s", "h.sqlite"}


@pytest.mark.parametrize("content", [b"", b"my notes\n", b"SQLite format 3\0"])
def test_a_file_that_is_no_history_is_not_overwritten(content: bytes, tmp_path: Path,
                                                      capsys: Any) -> None:
    (tmp_path / "s").mkdir()
    for name in ("notes", "notes.new"):
        (tmp_path / name).write_bytes(content)
    assert program.main(["--sessions", str(tmp_path / "s"),
                         "--database", str(tmp_path / "notes")]) == 2
    said = capsys.readouterr().err
    assert said.count("\n") == 1 and f"{tmp_path / 'notes'} is no history" in said
    assert {p.name: p.read_bytes() for p in tmp_path.iterdir() if p.is_file()} == {
        "notes": content, "notes.new": content}


def test_another_database_is_not_overwritten(tmp_path: Path) -> None:
    (tmp_path / "s").mkdir()
    with sqlite3.connect(tmp_path / "other.sqlite") as other:
        other.executescript("PRAGMA user_version = 1; CREATE TABLE mine (x)")
    with pytest.raises(history.RunError, match="is no history"):
        history.rebuild(tmp_path / "s", tmp_path / "other.sqlite")


@pytest.mark.parametrize("name", ["100%25.sqlite", "a%41?mode=rwc", "q?x#1.sqlite", "3 sp ü"])
def test_any_name_of_a_file_will_do(name: str, tmp_path: Path) -> None:
    (tmp_path / "s").mkdir()
    for _ in range(2):
        assert history.rebuild(tmp_path / "s", tmp_path / name) == []
        assert history.load(tmp_path / name) == ([], [])
    assert {p.name for p in tmp_path.iterdir()} == {"s", name}


@pytest.mark.parametrize("statement", [
    "DELETE FROM nights WHERE id = 'night001'", "UPDATE metrics SET value = 'much'",
    "UPDATE metrics SET value = 9e999", "UPDATE nights SET started = 'yesterday'",
    "UPDATE nights SET started = 5", "UPDATE nights SET valid = 'no'",
    "UPDATE nights SET verdict = x'ff'", "DROP TABLE metrics",
    "ALTER TABLE metrics RENAME COLUMN value TO worth"])
def test_a_damaged_history_is_one_sentence(statement: str, tmp_path: Path, capsys: Any) -> None:
    database = tmp_path / "h.sqlite"
    history.rebuild(write_nights(tmp_path / "s", 2, 9), database)
    with sqlite3.connect(database) as connection:
        connection.execute(statement)
    assert report.main([str(tmp_path), "--out", str(tmp_path / "page.html"),
                        "--history", str(database)]) == 2
    said = capsys.readouterr().err
    assert said.count("\n") == 1 and said.startswith(f"report.py: {database} is ")
    assert history.rebuild(tmp_path / "s", database) == []  # it is ours, and made anew


def test_one_night_is_one_night(tmp_path: Path, capsys: Any) -> None:
    sessions = write_nights(tmp_path / "s", 1, 9)
    assert program.main(["--sessions", str(sessions), "--database", str(tmp_path / "h")]) == 0
    assert "1 night, 1 with valid times, on 1 machine." in capsys.readouterr().out


def test_other_files_and_schemas_are_refused(tmp_path: Path, capsys: Any) -> None:
    other = tmp_path / "other.sqlite"
    sqlite3.connect(other).execute("PRAGMA user_version = 99").connection.close()
    text = tmp_path / "text.sqlite"
    text.write_text("no database, but long enough to look like one\n" * 100)
    for path in (other, text, tmp_path / "absent.sqlite"):
        with pytest.raises(history.RunError):
            history.load(path)
    assert program.main(["--sessions", str(tmp_path / "absent")]) == 2
    assert capsys.readouterr().err.count("\n") == 1


def test_the_bonferroni_share_keeps_a_history_of_many_cells_quiet() -> None:
    """31 cells, 20 histories: at LEVEL all together, hardly one may cry."""
    cries = 0
    for seed in range(20):
        level = changepoints.LEVEL / 31
        cries += any(steps(nights(1000 * seed + cell), level) for cell in range(31))
    assert cries <= 2


def test_the_section_of_the_page_names_every_change_and_needs_nothing_else(tmp_path: Path) -> None:
    database = tmp_path / "h.sqlite"
    history.rebuild(write_nights(tmp_path / "s", 20, 12), database)
    html = page_history.section(database)
    assert html.startswith('<section id="history">')
    assert html.count("commit011..commit012") == 2
    assert f"CPU time of {CELLS[2]}" in html and "Metrics without a change (11)" in html
    assert html == page_history.section(database)
    assert "<script" not in html and "http" not in html
    ElementTree.fromstring(html)


def test_a_page_of_no_history_is_refused(tmp_path: Path, capsys: Any) -> None:
    out = tmp_path / "page.html"
    assert report.main([str(tmp_path), "--out", str(out), "--history", str(tmp_path / "no")]) == 2
    said = capsys.readouterr()
    assert "there is no history" in said.err and said.err.count("\n") == 1 and not out.exists()
