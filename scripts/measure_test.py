"""A session from end to end with programs that only pretend, and the real ones' manners."""

import shutil
import subprocess
from pathlib import Path
from typing import Any

import pytest

import compare
import measure
from mda_nightly import callgrind, cells, comparison, frozen, history, machine, sessions, testing
from mda_nightly.cells import Cell, CellError, Player
from mda_nightly.sessions import BASELINE, CANDIDATE
from mda_nightly.timing import Side, Task

SCRIPTS = Path(__file__).resolve().parent
BUILT = SCRIPTS.parent / "build" / "release"
# Takes SECONDS on every cell, and fails on FAILS.
BENCH = """#!/bin/sh
while read -r line; do
  case "$1" in
    *^FAILS*) echo '{"name": "FAILS", "error": "it cannot"}' ;;
    *) echo '{"name": "set", "cpu_s": SECONDS, "wall_s": SECONDS, "counters": {"problems": 1}}' ;;
  esac
done
"""
# Answers are copied from the directory beside it.
MDA_BENCH = """#!/bin/sh
case "$*" in
  doctor*) echo '{"cpu": "Old Faithful", "cores": 2, "load_1min": 1.0, "valgrind": null}' ;;
  export*) while [ "$1" != --out ]; do shift; done; echo '{}' >"$2" ;;
  *--closed-loop*) cp -r "$(dirname "$0")/closed" "$4" ;;
  *) cp -r "$(dirname "$0")/open" "$4" ;;
esac
"""


def write_programs(directory: Path, seconds: float = 0.001, fails: str = "nothing") -> None:
    """What a build of a commit leaves, as far as it matters here."""
    directory.mkdir(parents=True)
    bench = BENCH.replace("SECONDS", str(seconds)).replace("FAILS", fails)
    testing.answers(directory / "open")
    testing.outings(directory / "closed")
    for name, program in ((cells.WINDOWS_PROGRAM, f"{bench}# {directory.name}\n"),
                          ("mda-bench", MDA_BENCH)):
        (directory / name).write_text(program)
        (directory / name).chmod(0o755)


@pytest.fixture
def programs(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.setattr(cells, "CELLS", (Cell("set/one"), Cell("set/two")))
    monkeypatch.setattr(frozen, "WINDOW_SETS", {"set": cells.WindowSet("A", 3, (1,), (5,))})
    for commit in ("old", "new"):
        write_programs(tmp_path / "programs" / commit)
    return tmp_path / "programs"


def take(programs: Path, out: Path, candidate: str = "new") -> int:
    return measure.main([str(out), "--programs", str(programs), "--baseline", "old",
                         "--candidate", candidate, "--anchor", "old", "--rounds", "8"])


def test_a_session_is_taken_judged_and_remembered(programs: Path, tmp_path: Path,
                                                  capsys: Any) -> None:
    write_programs(programs / "slow", seconds=0.00125)
    assert take(programs, tmp_path / "s" / "good") == 0
    assert take(programs, tmp_path / "s" / "slow", "slow") == 0
    for name, code in (("good", 0), ("slow", 1)):
        session = tmp_path / "s" / name
        assert compare.main([str(session / BASELINE), str(session / CANDIDATE)]) == code
    assert "set/one is slower by 2" in capsys.readouterr().out
    assert history.rebuild(tmp_path / "s", tmp_path / "h.sqlite") == []
    nights, _ = history.load(tmp_path / "h.sqlite")
    assert [(n.candidate, n.anchor) for n in nights] == [("new", "old"), ("slow", "old")]


def test_a_cell_that_the_candidate_cannot_run_is_named(programs: Path, tmp_path: Path) -> None:
    write_programs(programs / "broken", fails="set/two")
    assert take(programs, tmp_path / "s", "broken") == 0
    found = comparison.compare(tmp_path / "s" / BASELINE, tmp_path / "s" / CANDIDATE)
    assert found.regressions == ["set/two fails: set/two ended with an error: it cannot"]


def test_the_same_commit_twice_is_identical(programs: Path, tmp_path: Path) -> None:
    assert take(programs, tmp_path / "s", "old") == 0
    assert comparison.compare(tmp_path / "s" / BASELINE, tmp_path / "s" / CANDIDATE).identical


def test_a_session_whose_copies_differ_goes_on_once(programs: Path, tmp_path: Path,
                                                    monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(comparison, "copies_agree", lambda session: False)
    assert take(programs, tmp_path / "s") == 0
    session = sessions.load(tmp_path / "s")
    assert {r for _, _, _, r in session.samples} == set(range(1, 17))
    assert session.facts["rounds"] == 16


@pytest.mark.parametrize("words", [["--rounds", "3"], ["--rounds", "x"], ["--budget", "nan"],
                                   ["--seed", "1.5"]])
def test_the_nightly_refuses_before_it_builds(words: list[str], tmp_path: Path) -> None:
    scripts = tmp_path / "scripts"
    scripts.mkdir()
    shutil.copy2(SCRIPTS / "nightly.sh", scripts)
    (scripts / "measure.py").symlink_to(SCRIPTS / "measure.py")
    (scripts / "setup.sh").write_text("#!/bin/sh\n")
    (scripts / "build.sh").write_text("#!/bin/sh\necho building >&2\nexit 99\n")
    for name in ("setup.sh", "build.sh"):
        (scripts / name).chmod(0o755)
    git = ["git", "-C", str(tmp_path), "-c", "user.name=n", "-c", "user.email=e"]
    for more in (["init", "-q"], ["add", "."], ["commit", "-q", "-m", "all"]):
        subprocess.run([*git, *more], check=True)
    nightly = [str(scripts / "nightly.sh"), "--anchor", "HEAD"]
    done = subprocess.run([*nightly, *words], capture_output=True, text=True, check=False)
    assert done.returncode == 2 and done.stdout == ""
    assert words[0] in done.stderr and "building" not in done.stderr
    done = subprocess.run([*nightly, "--rounds", "9"], capture_output=True, text=True, check=False)
    assert done.returncode == 99 and "building" in done.stderr


def test_missing_programs_are_one_sentence(programs: Path, tmp_path: Path, capsys: Any) -> None:
    shutil.rmtree(programs / "old")
    assert take(programs, tmp_path / "s") == 2
    said = capsys.readouterr()
    assert said.out == "" and said.err.startswith("measure.py: there is no baseline")
    assert not (tmp_path / "s").exists()


def test_a_program_that_hangs_or_babbles_is_an_error(tmp_path: Path,
                                                     monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(cells, "PATIENCE_S", 0.2)
    program = tmp_path / cells.WINDOWS_PROGRAM
    for body in ("sleep 5", "echo nonsense", "exit 3"):
        program.write_text(f"#!/bin/sh\nread -r line\nexec {body}\n")
        program.chmod(0o755)
        with pytest.raises(CellError), Player(Cell("set/one"), tmp_path, tmp_path) as player:
            player.turn()


def test_frozen_windows_are_the_wanted_ones_and_no_others(programs: Path, tmp_path: Path) -> None:
    for _ in range(2):
        frozen.freeze(programs / "old" / "mda-bench", tmp_path / "w")
        assert [p.name for p in (tmp_path / "w" / "set").iterdir()] == ["01-05.json"]
        (tmp_path / "w" / "set" / "stray.json").write_text("{}")


needs_build = pytest.mark.skipif(
    not (BUILT / "mda-bench").is_file() or not (BUILT / "harness" / "windows_bench").is_file(),
    reason="nothing is built")


@needs_build
def test_the_programs_take_turns_and_repeat_their_work(tmp_path: Path) -> None:
    windows = frozen.freeze(BUILT / "mda-bench", tmp_path)
    problems = set()
    for solver in ("exact", "greedy"):
        with Player(Cell(f"light/{solver}"), BUILT / "harness", windows) as player:
            turns = [player.turn() for _ in range(3)]
        assert all(t.cpu_s > 0 and t.counters == turns[0].counters for t in turns)
        problems.add(turns[0].counters["problems"])
    with Player(Cell("wide/exact"), BUILT / "harness", windows) as player:
        problems.add(player.turn().counters["problems"])
    assert len(problems) == 2  # the number names the windows, not the solver
    for cell in (Cell("light/nobody"), Cell("light/gnn"), Cell("light/exact", "no_such_program")):
        with pytest.raises(CellError), Player(cell, BUILT / "harness", windows) as player:
            player.turn()


@needs_build
@pytest.mark.skipif(shutil.which("valgrind") is None, reason="there is no valgrind")
def test_instructions_are_the_same_every_time(tmp_path: Path) -> None:
    windows = frozen.freeze(BUILT / "mda-bench", tmp_path)
    counts = [callgrind.count(Cell("light1/greedy"), BUILT / "harness", windows)
              for _ in range(2)]
    assert counts[0] == counts[1] > 1000


@needs_build
def test_the_doctor_tells_what_a_session_needs() -> None:
    state = machine.state(BUILT / "mda-bench")
    assert sessions.machine_key(state).endswith(f"{state['cores']} cores")
    assert {"cpu", "load_1min", "valgrind", "fit"} <= set(state)
    assert state["fit"] == all(finding["good"] for finding in state["findings"])


def test_every_cell_is_of_a_program_that_is_built() -> None:
    assert {cell.program for cell in cells.CELLS} == set(cells.PROGRAMS)
    assert len({cell.name for cell in cells.CELLS}) == len(cells.CELLS)


def test_equal_files_are_counted_once(monkeypatch: pytest.MonkeyPatch) -> None:
    counted: list[str] = []

    def count(cell: Cell, programs: Path, windows: Path) -> int:
        counted.append(f"{cell.name} {programs.name}")
        if cell.name == "set/two":
            raise CellError("valgrind does not bear it")
        return len(programs.name)

    monkeypatch.setattr(callgrind, "count", count)
    sides = tuple(Side(name, Path(name)) for name in ("a", "b", "new"))
    programs = {"a": {"windows_bench": "1"}, "b": {"windows_bench": "1"},
                "new": {"windows_bench": "2"}}
    tasks = [Task(Cell(f"set/{name}"), sides) for name in ("one", "two")]
    found = callgrind.count_all(tasks, Path(), programs, 2)
    assert len(counted) == 4
    assert found == {("set/one", "a"): 1, ("set/one", "b"): 1, ("set/one", "new"): 3}


def test_a_cell_that_nobody_can_run_is_told_and_judged_by_nobody(programs: Path, tmp_path: Path,
                                                                 monkeypatch: pytest.MonkeyPatch
                                                                 ) -> None:
    monkeypatch.setattr(cells, "CELLS", (Cell("set/one"), Cell("nobody", "no_such_program")))
    assert take(programs, tmp_path / "s") == 0
    session = sessions.load(tmp_path / "s")
    assert session.cells() == ["set/one"]
    assert set(session.facts["broken"]["nobody"]) == set(testing.SIDES)
    assert session.facts["counted"] == session.facts["rounds_again"] == 0
    found = comparison.compare(tmp_path / "s" / BASELINE, tmp_path / "s" / CANDIDATE)
    assert found.broken == {} and found.exit_code == 0
