"""All nights in one SQLite file, made from the sessions and never edited: it can be deleted."""

import json
import sqlite3
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from mda_nightly import changepoints, comparison, judging, sessions
from mda_nightly.changepoints import Step
from mda_nightly.sessions import ANCHOR, BASELINE, CANDIDATE, FIRST, Session
from mda_results.rows import RunError, load_run

SCHEMA_VERSION = 1
CPU, INSTRUCTIONS, GAP, INTEGRAL = "CPU time", "instructions", "mean gap", "integral"
RATIOS = (CPU, INSTRUCTIONS)  # ln(candidate / anchor); the others are means of the candidate's rows

_SCHEMA = """
CREATE TABLE nights (
  id TEXT PRIMARY KEY, started TEXT NOT NULL, machine TEXT NOT NULL, candidate TEXT NOT NULL,
  baseline TEXT NOT NULL, anchor TEXT NOT NULL, valid INTEGER NOT NULL, verdict TEXT NOT NULL);
CREATE TABLE metrics (
  night TEXT NOT NULL REFERENCES nights (id), kind TEXT NOT NULL, subject TEXT NOT NULL,
  value REAL NOT NULL, low REAL, high REAL, PRIMARY KEY (night, kind, subject));
"""


@dataclass(frozen=True)
class Night:
    """A session in the history."""

    name: str
    started: str
    machine: str
    candidate: str  # commits
    anchor: str
    valid: bool  # its times
    verdict: str


@dataclass(frozen=True)
class Series:
    """A metric over the nights of one machine with one anchor."""

    machine: str
    anchor: str
    kind: str
    subject: str
    nights: list[Night]
    values: np.ndarray


def rebuild(directory: Path, database: Path) -> list[str]:
    """Makes the database anew from all sessions in `directory`, the same for the same sessions;
    returns a sentence for each that is left out. Raises RunError if there is no directory."""
    if not directory.is_dir():
        raise RunError(f"there is no directory {directory} of sessions")
    beside = database.with_name(database.name + ".new")
    beside.unlink(missing_ok=True)
    left_out = []
    connection = sqlite3.connect(beside)
    try:
        connection.executescript(f"PRAGMA user_version = {SCHEMA_VERSION};{_SCHEMA}")
        for path in sorted(p.parent for p in directory.glob(f"*/{sessions.SESSION_FILE}")):
            try:
                _insert(connection, path)
            except RunError as error:
                left_out.append(f"left out {path.name}: {error}")
        connection.commit()
    finally:
        connection.close()
    beside.replace(database)
    return left_out


def _insert(connection: sqlite3.Connection, path: Path) -> None:
    session = sessions.load(path)
    found = comparison.compare(path / BASELINE, path / CANDIDATE)
    facts, sides = session.facts, session.sides
    metrics = list(_metrics(session, path))
    connection.execute("INSERT INTO nights VALUES (?, ?, ?, ?, ?, ?, ?, ?)", (
        session.name, facts["started"], sessions.machine_key(facts["machine"]),
        *(sides[side]["commit"] for side in (CANDIDATE, BASELINE, ANCHOR)), found.gate.valid,
        comparison.verdict_sentence(found)))
    connection.executemany("INSERT INTO metrics VALUES (?, ?, ?, ?, ?, ?)",
                           [(session.name, *metric) for metric in metrics])


def _metrics(session: Session, path: Path) -> Iterator[tuple[object, ...]]:
    """kind, subject, value, low, high."""
    for cell, ratios in session.log_ratios(FIRST, ANCHOR, CANDIDATE).items():
        size = judging.shift(ratios, 0.0, f"{cell} history").size
        yield CPU, cell, size.value, size.low, size.high
    for cell in session.cells():
        pair = [session.counts.get((cell, side)) for side in (ANCHOR, CANDIDATE)]
        if all(pair):
            yield INSTRUCTIONS, cell, float(np.log(pair[1] / pair[0])), None, None
    run = path / CANDIDATE / comparison.OPEN
    if run.is_dir():
        rows = load_run(run).rows
        for algorithm, own in rows.groupby("algorithm", observed=True):
            for kind, field in ((GAP, "gap_nats"), (INTEGRAL, "integral")):
                if own[field].notna().any():
                    yield kind, str(algorithm), float(own[field].astype(float).mean()), None, None


def load(database: Path) -> tuple[list[Night], list[Series]]:
    """Nights by time, and every metric of the valid ones. Raises RunError if it is no history of
    this schema."""
    if not database.is_file():
        raise RunError(f"there is no history {database}; scripts/history.py makes it")
    try:
        connection = sqlite3.connect(f"file:{database}?mode=ro", uri=True)
        version = connection.execute("PRAGMA user_version").fetchone()[0]
        if version != SCHEMA_VERSION:
            raise RunError(f"{database} has schema version {version}; read is {SCHEMA_VERSION}")
        lines = connection.execute("SELECT id, started, machine, candidate, anchor, valid, verdict "
                                   "FROM nights ORDER BY started, id").fetchall()
        values = connection.execute("SELECT night, kind, subject, value FROM metrics").fetchall()
        connection.close()
    except sqlite3.DatabaseError as error:
        raise RunError(f"{database} is no history: {error}") from None
    nights = [Night(*line[:5], bool(line[5]), line[6]) for line in lines]
    return nights, _series(nights, values)


def _series(nights: list[Night], values: list[tuple[str, str, str, float]]) -> list[Series]:
    by_name = {night.name: night for night in nights}
    found: dict[tuple[str, str, str, str], list[tuple[Night, float]]] = {}
    for name, kind, subject, value in values:
        night = by_name[name]
        if night.valid or kind != CPU:
            found.setdefault((night.machine, night.anchor, kind, subject), []).append((night, value))
    series = []
    for key, points in sorted(found.items()):
        points.sort(key=lambda point: (point[0].started, point[0].name))
        series.append(Series(*key, [night for night, _ in points],
                             np.array([value for _, value in points])))
    return series


def changes(series: list[Series]) -> list[tuple[Series, Step]]:
    """Steps of all series; together they cry falsely in one history of a hundred."""
    per_machine: dict[tuple[str, str], int] = {}
    for s in series:
        key = (s.machine, s.anchor)
        per_machine[key] = per_machine.get(key, 0) + (len(s.values) >= changepoints.LEAST_NIGHTS)
    return [(s, step) for s in series for step in changepoints.steps(
        s.values, changepoints.LEVEL / max(1, per_machine[s.machine, s.anchor]))]


def commit_range(series: Series, step: Step) -> str:
    """What `git log` takes: the commits that came in with the step."""
    before, after = series.nights[step.first - 1], series.nights[step.first]
    return f"{before.candidate[:12]}..{after.candidate[:12]}"


def dump(database: Path) -> str:
    """All that is in it, as SQL: equal histories have equal dumps."""
    connection = sqlite3.connect(database)
    text = json.dumps(list(connection.iterdump()), indent=0)
    connection.close()
    return text
