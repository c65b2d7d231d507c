"""The experiment counts what its sessions hold, and goes on where it stopped."""

import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import noise_experiment
from mda_nightly import experiment, sessions, testing
from mda_nightly.sessions import CANDIDATE, FIRST
from mda_nightly.testing import CELLS, write_session


def write(directory: Path, number: int, size: float) -> Path:
    """A session whose planted side takes exp(size) times what the candidate takes."""
    cell = CELLS[number % len(CELLS)]
    lines = testing.samples(number, again=[cell], wild=0.01)
    more = [{**s, "side": experiment.PLANTED,
             "cpu_s": [float(t * np.exp(size)) for t in s["cpu_s"]]}
            for s in lines if s["cell"] == cell and s["side"] == CANDIDATE]
    sides = testing.facts()["sides"]
    kept = [s for s in lines if s["pass"] == FIRST or s["side"] != CANDIDATE]
    return write_session(directory / f"session-{number:03d}", kept + more, seed=number, planted=cell,
                         sides={**sides, experiment.PLANTED: sides[CANDIDATE]})


def test_planted_work_is_counted_as_found_and_its_absence_is_not(tmp_path: Path) -> None:
    for number, size in enumerate((0.05, 0.05, 0.0, 0.05), start=1):
        write(tmp_path, number, size)
    tables = {t.name: t for t in experiment.report(tmp_path).tables}
    called = [row[-1] for row in tables["sessions"].rows]
    assert called == ["slower", "slower", "no credible change", "slower"]
    assert tables["summary"].rows[0][:5] == ["all", 4, 0, 0.0, 3]


def test_unfinished_sessions_do_not_count(tmp_path: Path) -> None:
    write(tmp_path, 1, 0.05)
    second = write(tmp_path, 2, 0.05)
    sessions.write_facts(second, testing.facts(outcome="running"))
    assert len({t.name: t for t in experiment.report(tmp_path).tables}["sessions"].rows) == 1


def test_an_empty_experiment_is_one_sentence(tmp_path: Path, capsys: Any) -> None:
    assert noise_experiment.main(["--out", str(tmp_path), "--sessions", "0"]) == 2
    said = capsys.readouterr()
    assert said.out == "" and said.err.count("\n") == 1


@pytest.mark.parametrize("changes, word", [
    ({"planted": "nope"}, 'planted is "nope"'), ({"planted": None}, "planted is null"),
    ({"seed": "x"}, "seed is"), ({"seed": True}, "seed is"), ({"machine": {}}, "machine.cpu"),
    ({"machine": {**testing.MACHINE, "load_1min": None}}, "machine.load_1min is null")])
def test_a_damaged_session_is_one_sentence(changes: dict[str, Any], word: str, tmp_path: Path,
                                           capsys: Any) -> None:
    path = write(tmp_path, 1, 0.05) / sessions.SESSION_FILE
    path.write_text(json.dumps({**json.loads(path.read_text()), **changes}))
    assert noise_experiment.main(["--out", str(tmp_path), "--sessions", "0"]) == 2
    said = capsys.readouterr()
    assert said.out == "" and said.err.count("\n") == 1
    assert str(path) in said.err and word in said.err


def test_an_ordinary_session_is_none_of_the_experiment(tmp_path: Path, capsys: Any) -> None:
    write_session(tmp_path / "session-001", testing.samples(1))
    assert noise_experiment.main(["--out", str(tmp_path), "--sessions", "0"]) == 2
    assert "session.json has no field 'planted'" in capsys.readouterr().err


@pytest.mark.parametrize("words", [["--sessions", "-1"], ["--rounds", "3"]])
def test_impossible_numbers_are_refused(words: list[str], tmp_path: Path) -> None:
    with pytest.raises(SystemExit) as ended:
        noise_experiment.main(["--out", str(tmp_path), *words])
    assert ended.value.code == 2
