"""Two sides of a session against each other: work, times, answers, and one verdict."""

from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np

from mda_nightly import judging, quality, sessions
from mda_nightly.judging import FAILS, FASTER, IDENTICAL, SLOWER, SUSPECTED, Gate, Shift, Verdict
from mda_nightly.sessions import AGAIN, BASELINE, CANDIDATE, FIRST, TWIN, Session
from mda_results.render import Cell, Column, Estimate, Report, Table
from mda_results.rows import RunError

OPEN, CLOSED = "windows", "tracking"  # runs below a side's directory
ANSWERING = (BASELINE, CANDIDATE)  # sides that have them
WELL, REGRESSION, INVALID = 0, 1, 4  # exit codes


@dataclass
class Comparison:
    """All that is known; what a session does not hold is empty."""

    about: list[str]
    gate: Gate | None = None
    times: dict[str, Verdict] = field(default_factory=dict)
    walls: dict[str, Shift] = field(default_factory=dict)
    broken: dict[str, str] = field(default_factory=dict)  # cells that only the baseline runs
    work: list[list[Cell]] = field(default_factory=list)
    answers: list[quality.Difference] = field(default_factory=list)
    tracking: list[quality.Difference] = field(default_factory=list)

    @property
    def valid(self) -> bool:
        """Whether the clock can be believed, or is not asked: all programs are the same files."""
        return self.gate is None or self.gate.valid or self.identical

    @property
    def identical(self) -> bool:
        return bool(self.times) and all(v.word == IDENTICAL for v in self.times.values())

    @property
    def regressions(self) -> list[str]:
        """What got worse, a sentence part each; times count in valid sessions only."""
        found = [f"{name} fails: {why}" for name, why in self.broken.items()]
        found += [f"{d.algorithm}: {d.measure} worse in {d.worse} of {d.rows} rows"
                  for d in (*self.answers, *self.tracking) if d.word == quality.WORSE]
        if self.valid:
            found += [f"{name} is slower by {_percent(v.shift.size)}"
                      for name, v in self.times.items() if v.word == SLOWER]
        return found

    @property
    def exit_code(self) -> int:
        if self.regressions:
            return REGRESSION
        return WELL if self.valid else INVALID


def compare(base: Path, candidate: Path) -> Comparison:
    """Of SESSION/SIDE and SESSION/SIDE of one session, or of two runs of mda-bench, which hold
    answers only. Raises RunError, one sentence, when there is nothing to be said."""
    home = _session_of(base, candidate)
    if home is not None:
        return of_session(sessions.load(home), base.resolve().name, candidate.resolve().name)
    for directory in (base, candidate):
        if not directory.is_dir():
            raise RunError(f"there is no directory {directory}")
    for directory in (base, candidate):
        if not (directory / "manifest.json").is_file():
            raise RunError(f"{directory} is neither a run nor a side of a session: it has no "
                           f"manifest.json, and {directory.resolve().parent} no "
                           f"{sessions.SESSION_FILE}")
    return _of_runs(base, candidate)


def _session_of(base: Path, candidate: Path) -> Path | None:
    """The session whose sides the two are, one at least; None if neither is a side. A session holds
    directories of the sides that answered, so a side need not be one."""
    homes = [d.resolve().parent for d in (base, candidate)]
    are_sides = [(home / sessions.SESSION_FILE).is_file() for home in homes]
    if not any(are_sides):
        return None
    if not all(are_sides):
        raise RunError(f"{base} and {candidate} are not of one kind: one is a side of a session, the "
                       "other is not")
    if homes[0] != homes[1]:
        machines = [sessions.machine_key(sessions.load(home).facts["machine"]) for home in homes]
        where = ("in different sessions" if machines[0] == machines[1] else
                 f"on different machines ({machines[0]}; {machines[1]})")
        raise RunError(f"{base} and {candidate} were timed {where}, and only interleaved times can "
                       "be compared: no verdict")
    return homes[0]


def _of_runs(base: Path, candidate: Path) -> Comparison:
    about = [f"{base} (commit {quality.commit_of(base)}) against {candidate} (commit "
             f"{quality.commit_of(candidate)}): answers only; runs are not interleaved, so their "
             "times are not compared."]
    found = Comparison(about)
    closed = [(d / "tracking.jsonl").is_file() for d in (base, candidate)]
    opened = [(d / "rows.jsonl").is_file() for d in (base, candidate)]
    if closed[0] != closed[1] or opened[0] != opened[1] or not (closed[0] or opened[0]):
        raise RunError(f"{base} and {candidate} do not hold the same kind of run: no verdict")
    if opened[0]:
        found.answers = quality.open_loop(base, candidate)
    if closed[0]:
        found.tracking = quality.closed_loop(base, candidate)
    return found


def of_session(session: Session, first: str, second: str) -> Comparison:
    """Of two sides; raises RunError when there is nothing to be said."""
    for side in (first, second):
        if side not in session.sides:
            raise RunError(f"the session {session.directory} has no side '{side}'; it has "
                           f"{', '.join(sorted(session.sides))}")
    _check_problems(session, first, second)
    found = Comparison(_about(session, first, second))
    found.gate = judging.gate(_enough(session, session.log_ratios(FIRST, BASELINE, TWIN)))
    found.times = _times(session, first, second, found.gate.noise)
    found.walls = {c: judging.shift(d, 0.0, f"{c} wall") for c, d in session.log_ratios(
        FIRST, first, second, "wall_s").items()}
    found.broken = {cell: why[second] for cell, why in session.facts.get("broken", {}).items()
                    if second in why and first not in why}
    found.work = _work(session, first, second)
    uncounted = sum((cell, side) not in session.counts for cell in session.cells()
                    for side in (first, second))
    if uncounted:
        found.about.append(f"Instructions are not counted in {uncounted} of {2 * len(session.cells())} "
                           "cases: no valgrind, or it does not bear them.")
    if {first, second} <= set(ANSWERING):
        base, candidate = (session.directory / side for side in (first, second))
        found.answers = quality.open_loop(base / OPEN, candidate / OPEN)
        found.tracking = quality.closed_loop(base / CLOSED, candidate / CLOSED)
    else:
        found.about.append(f"Answers are not compared: only {' and '.join(ANSWERING)} give them.")
    return found


def _times(session: Session, first: str, second: str, noise: float) -> dict[str, Verdict]:
    identical = [c for c in session.cells() if _same_program(session, c, first, second)]
    return judging.verdicts(_enough(session, session.log_ratios(FIRST, first, second)),
                            session.log_ratios(AGAIN, first, second), identical, noise)


def copies_agree(session: Session) -> bool:
    """Whether the gate lets a session pass. It looks at baseline and twin alone, so a session that
    goes on until they agree favours no candidate."""
    return judging.gate(session.log_ratios(FIRST, BASELINE, TWIN)).valid


def suspects(session: Session) -> list[str]:
    """Cells of a session to be timed again, by candidate and baseline, before anybody is told."""
    gate = judging.gate(_enough(session, session.log_ratios(FIRST, BASELINE, TWIN)))
    return judging.suspects(_times(session, BASELINE, CANDIDATE, gate.noise))


def _enough(session: Session, ratios: dict[str, np.ndarray]) -> dict[str, np.ndarray]:
    if not ratios:
        raise RunError(f"the session {session.directory} has no cell that all sides ran: no "
                       "verdict")
    least = min(map(len, ratios.values()))
    if least < judging.LEAST_ROUNDS:
        raise RunError(f"the session {session.directory} has {least} rounds, and a verdict needs "
                       f"{judging.LEAST_ROUNDS}")
    return ratios


def _check_problems(session: Session, first: str, second: str) -> None:
    for cell in session.cells():
        problems = {session.counters(cell, side).get("problems") for side in (first, second)
                    if (FIRST, cell, side, 1) in session.samples}
        if len(problems) > 1:
            raise RunError(f"{first} and {second} of {session.directory} solved different windows "
                           f"in {cell}: no verdict")


def _same_program(session: Session, cell: str, first: str, second: str) -> bool:
    programs = [session.program(cell, side) for side in (first, second)]
    return programs[0] is not None and programs[0] == programs[1]


def _about(session: Session, first: str, second: str) -> list[str]:
    facts, sides = session.facts, session.sides
    named = [f"{side} ({sides[side]['commit'][:12] or sides[side]['revision']})"
             for side in (first, second)]
    ends = [facts["machine"], facts["machine_at_end"]]
    load = " to ".join(f"{m['load_1min']:.1f}" for m in ends if m.get("load_1min") is not None)
    return [f"Session {session.name}, {facts['started']} to {facts['ended']}: {named[1]} "
            f"against {named[0]} on {sessions.machine_key(facts['machine'])}; load "
            f"{load or 'unknown'}; {100 * session.contaminated():.0f} % of the samples contaminated by neighbours."]


def _work(session: Session, first: str, second: str) -> list[list[Cell]]:
    """Lines of the table of work: what differs, and of what."""
    lines: list[list[Cell]] = []
    for cell in session.cells():
        base, candidate = (
            {**session.counters(cell, side),
             **({"instructions": session.counts[cell, side]}
                if (cell, side) in session.counts else {})} for side in (first, second))
        for name in sorted(set(base) & set(candidate)):
            if base[name] != candidate[name]:
                lines.append([cell, name, base[name], candidate[name],
                              _change(base[name], candidate[name])])
    return lines


def _change(base: float, candidate: float) -> float | None:
    return 100.0 * (candidate / base - 1.0) if base else None


def _percent(size: Estimate) -> str:
    value, low, high = (100 * np.expm1(x) for x in (size.value, size.low, size.high))
    return f"{value:.1f} % [{low:.1f}, {high:.1f}]"


def report(found: Comparison) -> Report:
    """For people and programs; the verdict comes first."""
    tables = []
    if found.gate is not None:
        tables += [_work_table(found), _time_table(found), _gate_table(found.gate)]
    for name, title, differences in (
            ("answers", "Answers on frozen windows", found.answers),
            ("tracking", "Tracking in closed loop", found.tracking)):
        if differences:
            tables.append(quality.table(name, title, differences))
    return Report("Comparison", [verdict_sentence(found), *found.about], tables)


def verdict_sentence(found: Comparison) -> str:
    """One sentence."""
    notes = "" if found.valid else " The times of this session are invalid and count for nothing."
    if found.regressions:
        return f"Regression: {'; '.join(found.regressions)}.{notes}"
    if not found.valid:
        return f"Session invalid: {'; '.join(found.gate.faults)}. No verdict on times."
    faster = [name for name, v in found.times.items() if v.word == FASTER]
    better = [f"{d.algorithm} ({d.measure})" for d in (*found.answers, *found.tracking)
              if d.word == quality.BETTER]
    said = ([f"faster: {', '.join(faster)}"] if faster else []) + (
        [f"better: {', '.join(better)}"] if better else [])
    alone = [f"{d.algorithm} ({d.word})" for d in (*found.answers, *found.tracking) if d.only]
    if alone:
        said.append(f"not compared: {', '.join(alone)}")
    waiting = [name for name, v in found.times.items() if v.word == SUSPECTED]
    if waiting:
        said.append(f"suspected, but not timed again: {', '.join(waiting)}")
    if found.identical:
        said.append("all timed programs are identical files, whatever the clock says")
    return f"No credible regression{'; ' if said else ''}{'; '.join(said)}."


def _work_table(found: Comparison) -> Table:
    notes = ["Counted, not timed: equal in every repetition. Instructions by valgrind, one thread, "
             "of one pass or call. Only what differs is shown."]
    return Table("work", "Work", [Column("cell", once=True), Column("what"),
                                  Column("baseline", digits=".10g"),
                                  Column("candidate", digits=".10g"),
                                  Column("change [%]", digits="+.2f")], found.work, notes)


def _time_table(found: Comparison) -> Table:
    rows: list[list[Cell]] = []
    for name, v in found.times.items():
        wall = found.walls.get(name)
        rows.append([name, _in_percent(v.shift.size), v.shift.p,
                     _in_percent(v.again.size) if v.again else None,
                     _in_percent(wall.size) if wall else None, v.word])
    rows += [[name, None, None, None, None, FAILS] for name in found.broken]
    notes = [f"CPU time per cell, candidate over baseline: median over rounds with 95 % interval "
             f"(block bootstrap). Credible beyond {100 * found.gate.noise:.2f} %: the larger of 1 % "
             "and what a copy of the baseline differs by. Suspects (Benjamini and Hochberg, 20 %) are "
             "timed again, and called on that evidence alone (5 %). Wall time is shown, not judged."]
    return Table("times", "Times", [
        Column("cell"), Column("CPU [%]", digits="+.1f", interval=True), Column("p", digits=".2g"),
        Column("again [%]", digits="+.1f", interval=True),
        Column("wall [%]", digits="+.1f", interval=True), Column("verdict")], rows, notes)


def _gate_table(gate: Gate) -> Table:
    rows: list[list[Cell]] = [[name, _in_percent(s.size), "yes" if s.beside_zero else "no"]
                              for name, s in gate.shifts.items()]
    notes = gate.faults or ["The session is valid."]
    return Table("gate", "Baseline against a copy of itself", [
        Column("cell"), Column("CPU [%]", digits="+.1f", interval=True),
        Column("beside 0")], rows, notes)


def _in_percent(size: Estimate) -> Estimate:
    return Estimate(*(100 * float(np.expm1(x)) for x in (size.value, size.low, size.high)))


def machine_readable(found: Comparison) -> dict[str, Any]:
    """What --format json adds to the tables."""
    return {"verdict": {0: "no credible regression", 1: "regression", 4: "session invalid"}[
        found.exit_code], "exit_code": found.exit_code, "valid": found.valid,
        "regressions": found.regressions}
