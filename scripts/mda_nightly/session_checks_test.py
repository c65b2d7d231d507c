"""Damaged files of a session: one sentence that names the file, and no verdict."""

import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

import compare
from mda_nightly import sessions
from mda_nightly.sessions import (AGAIN, BASELINE, CANDIDATE, COUNTS_FILE, FIRST, SAMPLES_FILE,
                                  SESSION_FILE, TWIN)
from mda_nightly.testing import CELLS, MACHINE, SIDES, samples, write_session
from mda_results.rows import RunError

Line = dict[str, Any]
LINES = samples(1, rounds=9, again=CELLS[:2])
COUNTS = {(cell, side): 1000 for cell in CELLS for side in SIDES if side != TWIN}


@pytest.fixture
def session(tmp_path: Path) -> Path:
    return write_session(tmp_path / "s", LINES, COUNTS,
                         machine={**MACHINE, "valgrind": "/usr/bin/valgrind"})


def refusal(session: Path, capsys: Any) -> str:
    code = compare.main([str(session / BASELINE), str(session / CANDIDATE)])
    said = capsys.readouterr()
    assert (code, said.out, said.err.count("\n")) == (2, "", 1), said.err
    return said.err


def read(path: Path) -> list[Line]:
    return [json.loads(line) for line in path.read_text().splitlines()]


def write(path: Path, lines: list[Line]) -> None:
    path.write_text("".join(json.dumps(line) + "\n" for line in lines))


def test_a_whole_session_is_judged(session: Path) -> None:
    assert compare.main([str(session / BASELINE), str(session / CANDIDATE)]) == 0


@pytest.mark.parametrize("field, value", [
    ("cpu_s", [1e-3] * 4), ("cpu_s", []), ("wall_s", []), ("cpu_s", [True] * 5),
    ("cpu_s", [10**400] * 5), ("cpu_s", ["a"] * 5), ("cpu_s", [-1.0] * 5), ("cpu_s", None),
    ("counters", {"cost": "x"}), ("counters", {"cost": None}), ("counters", {"cost": True}),
    ("counters", 5), ("pass", True), ("pass", 3), ("round", 0), ("round", 1.0), ("stalled", "x"),
    ("stalled", False), ("side", "nobody"), ("cell", "nowhere"), ("cell", ["set/a"])])
@pytest.mark.parametrize("at", [0, 7])
def test_a_field_of_a_sample(field: str, value: Any, at: int, session: Path, capsys: Any) -> None:
    lines = read(session / SAMPLES_FILE)
    lines[at][field] = value
    write(session / SAMPLES_FILE, lines)
    said = refusal(session, capsys)
    assert f"{session / SAMPLES_FILE}:{at + 1}: {field.removesuffix('s')}" in said or (
        value == [] and f"{SAMPLES_FILE}:{at + 1}: cpu_s has" in said)


@pytest.mark.parametrize("field", ["cell", "side", "pass", "round", "cpu_s", "wall_s", "stalled",
                                   "counters"])
def test_an_absent_field_of_a_sample(field: str, session: Path, capsys: Any) -> None:
    lines = read(session / SAMPLES_FILE)
    del lines[3][field]
    write(session / SAMPLES_FILE, lines)
    assert f"{SAMPLES_FILE}:4 has no field '{field}'" in refusal(session, capsys)


def test_turns_that_other_sides_of_the_round_do_not_have(session: Path, capsys: Any) -> None:
    lines = read(session / SAMPLES_FILE)
    for field in ("cpu_s", "wall_s"):
        lines[2][field] = lines[2][field][:3]
    write(session / SAMPLES_FILE, lines)
    assert f"{SAMPLES_FILE}:3: the number of turns is 3, and 5" in refusal(session, capsys)


def test_other_problems_in_later_rounds(session: Path, capsys: Any) -> None:
    lines = read(session / SAMPLES_FILE)
    for line in lines:
        line["counters"]["problems"] += line["side"] == CANDIDATE and line["round"] > 3
    write(session / SAMPLES_FILE, lines)
    assert "counters.problems is 8.0, and 7.0" in refusal(session, capsys)


@pytest.mark.parametrize("keep", [
    lambda s: s["round"] <= 8,
    lambda s: s["pass"] == AGAIN or s["cell"] != CELLS[0],
    lambda s: s["pass"] == AGAIN or s["cell"] != CELLS[0] or s["side"] != CANDIDATE,
    lambda s: s["pass"] == AGAIN,
    lambda s: s["pass"] == FIRST or s["round"] <= 8 or s["cell"] != CELLS[0],
    lambda s: s["pass"] == FIRST or s["side"] != CANDIDATE or s["cell"] != CELLS[0],
    lambda s: s["pass"] == FIRST or s["side"] != BASELINE or s["cell"] != CELLS[0]])
def test_samples_that_end_at_a_line(keep: Callable[[Line], bool], session: Path,
                                    capsys: Any) -> None:
    write(session / SAMPLES_FILE, [s for s in LINES if keep(s)])
    assert str(session / SAMPLES_FILE) in refusal(session, capsys)


def test_a_rerun_that_ends_at_a_round(session: Path, capsys: Any) -> None:
    facts = json.loads((session / SESSION_FILE).read_text())
    sessions.write_facts(session, {**facts, "rounds_again": 9})
    assert compare.main([str(session / BASELINE), str(session / CANDIDATE)]) == 0
    capsys.readouterr()
    write(session / SAMPLES_FILE, [s for s in LINES if s["pass"] == FIRST or s["round"] <= 8])
    assert "not all of 9 rounds" in refusal(session, capsys)


@pytest.mark.parametrize("field, value", [
    ("instructions", "many"), ("instructions", None), ("instructions", [1]), ("instructions", -5),
    ("instructions", 0), ("instructions", True), ("instructions", 1.5), ("cell", ["set/a"]),
    ("cell", "nowhere"), ("side", "nobody"), ("side", None)])
def test_a_field_of_a_count(field: str, value: Any, session: Path, capsys: Any) -> None:
    lines = read(session / COUNTS_FILE)
    lines[1][field] = value
    write(session / COUNTS_FILE, lines)
    assert f"{session / COUNTS_FILE}:2: {field} is" in refusal(session, capsys)


@pytest.mark.parametrize("field", ["cell", "side", "instructions"])
def test_an_absent_field_of_a_count(field: str, session: Path, capsys: Any) -> None:
    lines = read(session / COUNTS_FILE)
    del lines[1][field]
    write(session / COUNTS_FILE, lines)
    assert f"{COUNTS_FILE}:2 has no field '{field}'" in refusal(session, capsys)


@pytest.mark.parametrize("spoil", [
    lambda lines: [], lambda lines: lines[:10], lambda lines: [*lines, lines[0]],
    lambda lines: [*lines, {**lines[0], "side": TWIN}]])
def test_counts_that_are_too_few_or_too_many(spoil: Callable[[list[Line]], list[Line]],
                                             session: Path, capsys: Any) -> None:
    write(session / COUNTS_FILE, spoil(read(session / COUNTS_FILE)))
    assert str(session / COUNTS_FILE) in refusal(session, capsys)


def test_counts_that_are_not_there(session: Path, capsys: Any) -> None:
    (session / COUNTS_FILE).unlink()
    assert "holds 0 counts, and 36 were taken" in refusal(session, capsys)


def test_a_session_tells_how_many_counts_were_taken(session: Path, capsys: Any) -> None:
    facts = json.loads((session / SESSION_FILE).read_text())
    write(session / COUNTS_FILE, read(session / COUNTS_FILE)[:10])
    sessions.write_facts(session, {**facts, "counted": 10})
    assert compare.main([str(session / BASELINE), str(session / CANDIDATE)]) == 0


ABSENT = object()


@pytest.mark.parametrize("path, value", [
    *(([name], value) for name in ("machine", "sides", "cells", "machine_at_end")
      for value in (5, None, [], {}, ABSENT)),
    *(([name], value) for name in ("id", "started", "ended") for value in (5, None, "", ABSENT)),
    *((["rounds"], value) for value in (0, None, True, 5, "9", ABSENT)),
    *((["schema_version"], value) for value in (True, 1.0, 2, None, "1", ABSENT)),
    *((["sides", CANDIDATE], value) for value in ({}, None, 5, ABSENT)),
    *((["sides", CANDIDATE, "programs"], value) for value in ({}, None, [], {"a": 5}, ABSENT)),
    *((["sides", CANDIDATE, "commit"], value) for value in (5, None, ABSENT)),
    *((["cells", CELLS[0]], value) for value in ({}, None, {"program": 5}, ABSENT)),
    *((["machine", "load_1min"], value) for value in ("x", True, -1.0)),
    *((["machine", "cores"], value) for value in ("x", True, 0, ABSENT)),
    *((["machine_at_end", "load_1min"], value) for value in ("x", [])),
    *((["broken"], value) for value in ([], ["a"], 5, {CELLS[0]: "x"}, {"nowhere": {}},
                                        {CELLS[0]: {CANDIDATE: 5}}, {CELLS[0]: {"nobody": "x"}},
                                        {CELLS[0]: {CANDIDATE: "it crashed"}})),
    (["machine_at_end", "cpu"], "New Faithful"),
    (["sides", TWIN, "programs"], {"windows_bench": "another"}),
    (["cells", "new/cell"], {"program": "windows_bench"}),
    (["outcome"], "running"), (["outcome"], None), (["planted"], "nope"), (["planted"], 5)])
def test_a_field_of_the_session(path: list[str], value: Any, session: Path, capsys: Any) -> None:
    facts = json.loads((session / SESSION_FILE).read_text())
    *outer, last = path
    inside = facts
    for name in outer:
        inside = inside[name]
    if value is ABSENT:
        del inside[last]
    else:
        inside[last] = value
    (session / SESSION_FILE).write_text(json.dumps(facts))
    assert str(session) in refusal(session, capsys)


@pytest.mark.parametrize("name", [SESSION_FILE, SAMPLES_FILE, COUNTS_FILE])
@pytest.mark.parametrize("text", ["", "[1]\n", "{\n", "[" * 100_000, "\xff\xfe\0", "9" * 5000,
                                  "null\n"])
def test_files_of_something_else(name: str, text: str, session: Path, capsys: Any) -> None:
    (session / name).write_bytes(text.encode("latin-1"))
    assert str(session) in refusal(session, capsys)


def test_the_sentence_is_short_whatever_the_value(session: Path, capsys: Any) -> None:
    facts = json.loads((session / SESSION_FILE).read_text())
    (session / SESSION_FILE).write_text(json.dumps({**facts, "rounds": ["x" * 9999]}))
    assert len(refusal(session, capsys)) < 300


def test_a_session_that_is_being_taken_may_lack_its_end(session: Path) -> None:
    facts = json.loads((session / SESSION_FILE).read_text())
    for name in ("ended", "machine_at_end"):
        del facts[name]
    sessions.write_facts(session, {**facts, "outcome": "running", "rounds": 13})
    assert sessions.load(session, unfinished=True).cells() == sorted(CELLS)
    with pytest.raises(RunError, match="did not finish"):
        sessions.load(session)
