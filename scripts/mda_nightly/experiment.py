"""What the sessions of scripts/noise_experiment.py say: false alarms, and planted work found."""

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from mda_nightly import judging, schema, sessions
from mda_nightly.judging import FASTER, SLOWER, Verdict
from mda_nightly.sessions import AGAIN, BASELINE, CANDIDATE, FIRST, PLANTED, TWIN, Session
from mda_results.render import Cell, Column, Report, Table
from mda_results.rows import RunError, load_manifest

_PLANTED_RATIO = 1.05
_FACTS = {PLANTED: schema.NAME, "seed": schema.WHOLE}  # of session.json, beyond what others need


@dataclass(frozen=True)
class Outcome:
    """Of one session."""

    number: int
    planted: str  # the cell
    gate: judging.Gate
    null: dict[str, Verdict]  # candidate against baseline: a copy everywhere
    work: dict[str, Verdict]  # the same, but for the planted cell
    seconds: float  # of processor time that was sampled
    contaminated: float  # share of samples
    load: float

    @property
    def false_alarms(self) -> list[str]:
        return _alarms(self.null)

    @property
    def found(self) -> bool:
        """The planted cell is called slower, and nothing else is called anything."""
        return self.work[self.planted].word == SLOWER and _alarms(self.work) == [self.planted]


def _alarms(found: Mapping[str, Verdict]) -> list[str]:
    return [name for name, v in found.items() if v.word in (SLOWER, FASTER)]


def is_finished(directory: Path) -> bool:
    path = directory / sessions.SESSION_FILE
    return path.is_file() and load_manifest(path).get("outcome") == sessions.FINISHED


def suspects(directory: Path, planted: str) -> list[tuple[str, str]]:
    """(cell, side) that are to be timed again, of a session whose first pass is whole."""
    session = sessions.load(directory, unfinished=True)
    null, work = _verdicts(session, planted, judging.gate(_twins(session)).noise)
    found = [(name, CANDIDATE) for name in judging.suspects(null)]
    return found + [(planted, PLANTED)] * (planted in judging.suspects(work))


def outcome(session: Session) -> Outcome:
    """Judges a session by the rules of the nightly, but for identical programs. Raises RunError if
    it is none of the experiment."""
    path = session.directory / sessions.SESSION_FILE
    schema.check(session.facts, _FACTS, path)
    schema.check(session.facts["machine"], {"load_1min": schema.NUMBER}, path, "machine.")
    planted = session.facts[PLANTED]
    gate = judging.gate(_twins(session))
    null, work = _verdicts(session, planted, gate.noise)
    seconds = sum(sum(s["cpu_s"]) for s in session.samples.values())
    return Outcome(session.facts["seed"], planted, gate, null, work, seconds,
                   session.contaminated(), float(session.facts["machine"]["load_1min"]))


def _twins(session: Session) -> dict[str, np.ndarray]:
    return session.log_ratios(FIRST, BASELINE, TWIN)


def _verdicts(session: Session, planted: str,
              noise: float) -> tuple[dict[str, Verdict], dict[str, Verdict]]:
    first, again = (session.log_ratios(n, BASELINE, CANDIDATE) for n in (FIRST, AGAIN))
    more, more_again = (session.log_ratios(n, BASELINE, PLANTED) for n in (FIRST, AGAIN))
    null = judging.verdicts(first, again, [], noise)
    return null, judging.verdicts(
        {**first, **more}, {**{k: v for k, v in again.items() if k != planted}, **more_again}, [],
        noise)


def report(directory: Path) -> Report:
    """Over all finished sessions of the experiment; raises RunError if there are none."""
    loaded = [sessions.load(path) for path in sorted(directory.glob("session-*"))
              if is_finished(path)]
    if not loaded:
        raise RunError(f"there is no finished session in {directory}")
    found = [outcome(session) for session in loaded]
    facts = loaded[0].facts
    about = [
        f"{len(found)} sessions of {facts['rounds']} rounds on {len(facts['cells'])} cells, on "
        f"{sessions.machine_key(facts['machine'])}, started {facts['started']}; load at the start "
        f"{min(o.load for o in found):.1f} to {max(o.load for o in found):.1f}, "
        f"{100 * np.mean([o.contaminated for o in found]):.0f} % of the samples contaminated by "
        "neighbours.",
        "CPU time; randomly interleaved rounds; cells that change by more than max(1 %, the "
        "session's noise) are suspected (Benjamini and Hochberg, 20 %), and called only on the "
        "evidence of a rerun (5 %)."]
    return Report("Nightly on a noisy machine: A/A and A/B", about,
                  [_summary(found), _estimates(found), _by_session(found)])


def _summary(found: list[Outcome]) -> Table:
    valid = [o for o in found if o.gate.valid]
    rows: list[list[Cell]] = []
    for name, group in (("all", found), ("valid", valid)):
        n = len(group)
        rows.append([name, n, sum(bool(o.false_alarms) for o in group),
                     _percent(sum(bool(o.false_alarms) for o in group), n),
                     sum(o.found for o in group), _percent(sum(o.found for o in group), n)])
    suspected = sum(v.again is not None for o in found for v in o.null.values())
    notes = ["False alarm: any cell of a copy is called slower or faster. Found: the cell with 5 % "
             "more passes is called slower, and no other cell anything.",
             f"Invalid by the gate: {len(found) - len(valid)} of {len(found)}. Suspected copies "
             f"before the rerun: {suspected} of {sum(len(o.null) for o in found)} cells."]
    return Table("summary", "Alarms per session", [
        Column("sessions", once=True), Column("n"), Column("with a false alarm", "A/A"),
        Column("[%]", "A/A", ".0f"), Column("found", "A/B"), Column("[%]", "A/B", ".0f")],
        rows, notes)


def _percent(part: int, whole: int) -> float | None:
    return 100.0 * part / whole if whole else None


def _estimates(found: list[Outcome]) -> Table:
    """How far the medians are from the truth."""
    null = np.array([v.shift.size.value for o in found for v in o.null.values()])
    work = np.array([o.work[o.planted].shift.size.value for o in found])
    rows: list[list[Cell]] = []
    for name, x, truth in (("copy", null, 0.0), ("5 % planted", work, np.log(_PLANTED_RATIO))):
        off = 100 * np.expm1(x)
        rows.append([name, len(x), 100 * np.expm1(truth), float(off.mean()),
                     float(off.std()), float(off.min()), float(off.max())])
    return Table("estimates", "Median change per cell and session, %", [
        Column("program"), Column("n"), Column("true", digits=".1f"), Column("mean", digits=".2f"),
        Column("sd", digits=".2f"), Column("least", digits=".2f"), Column("most", digits=".2f")],
        rows)


def _by_session(found: list[Outcome]) -> Table:
    rows: list[list[Cell]] = []
    for o in found:
        change = o.work[o.planted]
        rows.append([o.number, o.load, 100 * o.contaminated, o.seconds, 100 * o.gate.noise,
                     "yes" if o.gate.valid else "no", ", ".join(o.false_alarms) or "none",
                     o.planted, 100 * float(np.expm1(change.shift.size.value)), change.word])
    return Table("sessions", "Session by session", [
        Column("session"), Column("load", digits=".1f"), Column("contaminated [%]", digits=".0f"),
        Column("CPU sampled [s]", digits=".1f"), Column("noise [%]", digits=".2f"),
        Column("valid"), Column("false alarms"), Column("planted in"),
        Column("measured [%]", digits="+.2f"), Column("called")], rows)
