"""compare.py: planted changes are found, nulls are quiet, and what cannot be judged is not."""

import json
import random
import shutil
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import compare
from mda_nightly import comparison, sessions, testing
from mda_nightly.sessions import ANCHOR, BASELINE, CANDIDATE, TWIN
from mda_nightly.testing import CELLS, planted, samples, write_session


def run(session: Path, *more: str) -> int:
    return compare.main([str(session / BASELINE), str(session / CANDIDATE), *more])


def verdicts(session: Path) -> dict[str, str]:
    found = comparison.compare(session / BASELINE, session / CANDIDATE)
    return {name: verdict.word for name, verdict in found.times.items()}


def test_planted_work_is_found_and_nothing_else(tmp_path: Path) -> None:
    """5 % in one cell of twelve, on a machine whose speed wanders by a factor of two."""
    found = 0
    for seed in range(1, 21):
        cell = CELLS[seed % len(CELLS)]
        session = write_session(tmp_path / str(seed), samples(seed, planted([cell]), again=[cell]))
        words = verdicts(session)
        others = {word for name, word in words.items() if name != cell}
        assert others == {"no credible change"}, (seed, words)
        found += words[cell] == "slower"
    assert found >= 18


def test_null_sessions_are_quiet(tmp_path: Path) -> None:
    alarms = 0
    for seed in range(1, 21):
        session = write_session(tmp_path / str(seed), samples(seed, again=CELLS))
        alarms += "slower" in verdicts(session).values()
    assert alarms <= 2


def test_less_work_is_faster_and_no_regression(tmp_path: Path, capsys: Any) -> None:
    session = write_session(tmp_path / "s",
                            samples(3, planted(CELLS[:2], -0.1), again=CELLS[:2]))
    assert run(session) == 0
    assert capsys.readouterr().out.startswith(f"No credible regression; faster: {CELLS[0]}")


def test_an_alarm_needs_a_rerun_that_agrees(tmp_path: Path) -> None:
    lines = samples(1, planted([CELLS[0]], 0.1))
    assert verdicts(write_session(tmp_path / "without", lines))[CELLS[0]] == "suspected"
    null = [s for s in samples(2, again=[CELLS[0]]) if s["pass"] == sessions.AGAIN]
    disagreeing = write_session(tmp_path / "disagreeing", lines + null)
    assert verdicts(disagreeing)[CELLS[0]] == "no credible change"
    assert run(disagreeing) == 0


def test_order_of_lines_and_scale_of_times_change_nothing(tmp_path: Path, capsys: Any) -> None:
    lines = samples(5, planted([CELLS[3]]), again=[CELLS[3]])
    texts = []
    for name, factor in (("a", 1.0), ("b", 1.0), ("c", 4.0)):
        scaled = [{**s, **{k: [factor * t for t in s[k]] for k in ("cpu_s", "wall_s")}}
                  for s in lines]
        random.Random(name).shuffle(scaled)
        run(write_session(tmp_path / name, scaled), "--format", "json")
        texts.append(capsys.readouterr().out)
    assert texts[0] == texts[1]
    assert json.loads(texts[0])["verdict"] == json.loads(texts[2])["verdict"] == "regression"


def test_swapping_sides_turns_slower_into_faster(tmp_path: Path) -> None:
    session = write_session(tmp_path / "s", samples(4, planted([CELLS[1]], 0.1), again=[CELLS[1]]))
    turned = comparison.compare(session / CANDIDATE, session / BASELINE)
    assert turned.times[CELLS[1]].word == "faster"
    assert turned.exit_code == 0


def test_identical_programs_are_identical_whatever_the_clock_says(tmp_path: Path,
                                                                  capsys: Any) -> None:
    sides = testing.facts()["sides"]
    sides[CANDIDATE]["programs"] = sides[BASELINE]["programs"]

    def absurd(cell: str, side: str) -> float:
        return {CANDIDATE: 1.0, TWIN: -0.5}.get(side, 0.0)

    session = write_session(tmp_path / "s", samples(1, absurd, again=CELLS), sides=sides)
    assert set(verdicts(session).values()) == {"identical"}
    assert run(session) == 0
    assert "identical files" in capsys.readouterr().out


@pytest.mark.parametrize("off, cells", [(0.05, CELLS[:1]), (0.015, CELLS)])
def test_a_session_in_which_copies_differ_is_invalid(off: float, cells: Sequence[str],
                                                     tmp_path: Path, capsys: Any) -> None:
    def biased(cell: str, side: str) -> float:
        return off if side == TWIN and cell in cells else planted([CELLS[5]], 0.2)(cell, side)

    lines = samples(1, biased, again=[CELLS[5]], wild=0.01, noise=0.003)
    session = write_session(tmp_path / "s", lines)
    assert run(session) == 4
    assert capsys.readouterr().out.startswith("Session invalid")


def test_worse_answers_are_a_regression_even_when_the_session_is_invalid(tmp_path: Path,
                                                                         capsys: Any) -> None:
    session = write_session(tmp_path / "s", samples(
        1, lambda cell, side: 0.1 * (side == TWIN)))
    testing.answers(session / BASELINE / comparison.OPEN)
    testing.answers(session / CANDIDATE / comparison.OPEN, gap_nats=0.5, cost_nats=-9.5)
    assert run(session) == 1
    said = capsys.readouterr().out
    assert "greedy: gap [nats] worse in 4 of 4 rows" in said
    assert "invalid" in said


def test_a_cell_that_only_the_baseline_runs_is_a_regression(tmp_path: Path) -> None:
    broken = {CELLS[0]: {CANDIDATE: "it crashed"}, CELLS[1]: {BASELINE: "it is new"}}
    lines = [s for s in samples(1) if s["side"] not in broken.get(s["cell"], {})]
    session = write_session(tmp_path / "s", lines, broken=broken)
    found = comparison.compare(session / BASELINE, session / CANDIDATE)
    assert found.exit_code == 1
    assert found.regressions == [f"{CELLS[0]} fails: it crashed"]


def test_work_is_counted_not_timed(tmp_path: Path, capsys: Any) -> None:
    counts = {(CELLS[0], BASELINE): 1000, (CELLS[0], CANDIDATE): 1100,
              (CELLS[1], BASELINE): 500, (CELLS[1], CANDIDATE): 500}
    session = write_session(tmp_path / "s", samples(1), counts)
    assert run(session) == 0
    assert "not counted in 20 of 24 cases" in capsys.readouterr().out
    found = comparison.compare(session / BASELINE, session / CANDIDATE)
    assert found.work == [[CELLS[0], "instructions", 1000, 1100, pytest.approx(10.0)]]
    assert found.exit_code == 0


def torn(session: Path) -> None:
    path = session / sessions.SAMPLES_FILE
    path.write_text(path.read_text()[:-20])


def without_some(session: Path) -> None:
    path = session / sessions.SAMPLES_FILE
    path.write_text("".join(path.read_text().splitlines(keepends=True)[:-1]))


def running(session: Path) -> None:
    sessions.write_facts(session, testing.facts(outcome="running"))


def other_windows(session: Path) -> None:
    path = session / sessions.SAMPLES_FILE
    lines = [json.loads(line) for line in path.read_text().splitlines()]
    for line in lines:
        line["counters"]["problems"] += line["side"] == CANDIDATE
    path.write_text("".join(json.dumps(line) + "\n" for line in lines))


def twice(session: Path) -> None:
    path = session / sessions.SAMPLES_FILE
    path.write_text(path.read_text() + path.read_text().splitlines(keepends=True)[0])


def impossible(session: Path) -> None:
    path = session / sessions.SAMPLES_FILE
    path.write_text(path.read_text().replace('"cpu_s": [', '"cpu_s": [-1.0, ', 1))


def other_rows(session: Path) -> None:
    testing.answers(session / BASELINE / comparison.OPEN)
    testing.answers(session / CANDIDATE / comparison.OPEN, window_k=4)


def other_fingerprints(session: Path) -> None:
    testing.answers(session / BASELINE / comparison.OPEN)
    testing.answers(session / CANDIDATE / comparison.OPEN)
    path = session / CANDIDATE / comparison.OPEN / "rows.jsonl"
    path.write_text(path.read_text().replace("A-1-3-1", "A-1-3-9"))


def half_written_rows(session: Path) -> None:
    testing.answers(session / BASELINE / comparison.OPEN)
    run_directory = testing.answers(session / CANDIDATE / comparison.OPEN)
    path = run_directory / "rows.jsonl"
    path.write_text(path.read_text()[:-30])


def few_rounds(session: Path) -> None:
    write_session(session, samples(1, rounds=5))


@pytest.mark.parametrize("spoil", [
    torn, without_some, running, other_windows, twice, impossible, other_rows, other_fingerprints,
    half_written_rows, few_rounds])
def test_bad_sessions_get_one_sentence_and_no_verdict(spoil: Any, tmp_path: Path,
                                                      capsys: Any) -> None:
    session = write_session(tmp_path / "s", samples(1))
    assert run(session) == 0
    capsys.readouterr()
    spoil(session)
    assert run(session) == 2
    said = capsys.readouterr()
    assert said.out == ""
    assert said.err.count("\n") == 1
    assert said.err.startswith("compare.py: ")


def test_missing_sides_other_machines_and_other_sessions_are_refused(tmp_path: Path,
                                                                     capsys: Any) -> None:
    first = write_session(tmp_path / "first", samples(1))
    second = write_session(tmp_path / "second", samples(1), id="another")
    copy = shutil.copytree(first, tmp_path / "copy")
    third = write_session(tmp_path / "third", samples(1), id="third",
                          machine={"cpu": "New Faithful", "cores": 2})
    (first / "nobody").mkdir()
    for base, candidate, word in (
            (first / "absent", first / CANDIDATE, "no side 'absent'"),
            (tmp_path / "no" / "where", tmp_path / "no" / "body", "no directory"),
            (first / "nobody", first / CANDIDATE, "no side 'nobody'"),
            (first / BASELINE, second / CANDIDATE, "different sessions"),
            (first / BASELINE, copy / CANDIDATE, "different sessions"),
            (first / BASELINE, second / CANDIDATE / comparison.OPEN, "not of one kind"),
            (first / BASELINE, third / CANDIDATE, "different machines")):
        assert compare.main([str(base), str(candidate)]) == 2
        said = capsys.readouterr()
        assert said.out == "" and said.err.count("\n") == 1 and word in said.err
        assert str(tmp_path) in said.err


@pytest.mark.parametrize("words", [["", ""], [".", ""]])
def test_an_empty_word_is_no_directory(words: list[str], capsys: Any) -> None:
    with pytest.raises(SystemExit) as ended:
        compare.main(words)
    assert ended.value.code == 2 and "an empty word is no directory" in capsys.readouterr().err


@pytest.mark.parametrize("run_name", [comparison.OPEN, comparison.CLOSED])
def test_answers_that_are_gone_are_missed(run_name: str, tmp_path: Path, capsys: Any) -> None:
    session = write_session(tmp_path / "s", samples(1))
    for side in (BASELINE, CANDIDATE):
        shutil.rmtree(session / side / run_name)
    assert run(session) == 2
    assert str(session / BASELINE / run_name) in capsys.readouterr().err


def test_sides_without_answers_are_compared_by_the_rest(tmp_path: Path, capsys: Any) -> None:
    session = write_session(tmp_path / "s", samples(1))
    assert compare.main([str(session / ANCHOR), str(session / CANDIDATE)]) == 0
    assert "Answers are not compared" in capsys.readouterr().out


def test_an_algorithm_of_one_side_alone_is_told(tmp_path: Path, capsys: Any) -> None:
    base, candidate = (testing.answers(tmp_path / name) for name in ("base", "candidate"))
    rows = (candidate / "rows.jsonl").read_text().splitlines(keepends=True)
    (candidate / "rows.jsonl").write_text("".join(r for r in rows if "greedy" not in r))
    (candidate / "manifest.json").write_text(json.dumps(testing.manifest(8)))
    assert compare.main([str(base), str(candidate)]) == 0
    assert "not compared: greedy (only in the baseline)" in capsys.readouterr().out


def test_the_sentence_about_an_invalid_session_names_one_cell(tmp_path: Path, capsys: Any) -> None:
    session = write_session(tmp_path / "s", samples(1, lambda cell, side: 0.1 * (side == TWIN)))
    assert run(session, "--format", "json") == 4
    sentence = json.loads(capsys.readouterr().out)["about"][0]
    assert sum(sentence.count(cell) for cell in CELLS) == 1 and "in 11 more cells" in sentence


def test_two_plain_runs_are_compared_by_their_answers(tmp_path: Path, capsys: Any) -> None:
    base = testing.answers(tmp_path / "base")
    same = testing.answers(tmp_path / "same")
    worse = testing.answers(tmp_path / "worse", status="failed", stop="error")
    assert compare.main([str(base), str(same)]) == 0
    assert compare.main([str(base), str(worse)]) == 1
    assert "greedy: failed or refuted worse in 4 of 4 rows" in capsys.readouterr().out
    assert compare.main([str(worse), str(base)]) == 0


def test_medians_follow_the_planted_size(tmp_path: Path) -> None:
    for seed, size in enumerate(np.log([0.9, 1.0, 1.05, 1.3]), start=1):
        session = write_session(tmp_path / str(seed), samples(seed, planted(CELLS, float(size))))
        found = comparison.compare(session / BASELINE, session / CANDIDATE)
        medians = [v.shift.size.value for v in found.times.values()]
        assert np.median(medians) == pytest.approx(size, abs=0.005)
