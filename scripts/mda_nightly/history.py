"""All nights in one SQLite file, made from the sessions and never edited: it can be deleted."""

import json
import os
import sqlite3
from collections.abc import Iterator
from contextlib import closing, contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from mda_nightly import changepoints, comparison, judging, schema, sessions
from mda_nightly.changepoints import Step
from mda_nightly.schema import NAME
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

_NIGHT = {"id": NAME, "started": schema.TIME, "machine": schema.TEXT, "candidate": schema.TEXT,
          "anchor": schema.TEXT, "valid": schema.one_of(0, 1), "verdict": schema.TEXT}
_METRIC = {"night": NAME, "kind": NAME, "subject": NAME, "value": schema.NUMBER}


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
    returns a sentence for each that is left out. Raises RunError if there is no directory, or if
    what is in the database's place is no history, which stays there."""
    if not directory.is_dir():
        raise RunError(f"there is no directory {directory} of sessions")
    if database.exists():
        with _opened(database):
            pass
    beside = database.with_name(f"{database.name}.{os.getpid()}.part")
    try:
        with closing(sqlite3.connect(beside)) as connection:
            connection.executescript(f"PRAGMA user_version = {SCHEMA_VERSION};{_SCHEMA}")
            left_out = _insert_all(connection, directory)
            connection.commit()
        beside.replace(database)
    finally:
        beside.unlink(missing_ok=True)
    return left_out


def _insert_all(connection: sqlite3.Connection, directory: Path) -> list[str]:
    left_out, names = [], {}
    for path in sorted(p.parent for p in directory.glob(f"*/{sessions.SESSION_FILE}")):
        try:
            session = sessions.load(path)
            if session.name in names:
                raise RunError(f"its id is that of {names[session.name]}")
            _insert(connection, session)
            names[session.name] = path.name
        except (RunError, OSError) as error:
            left_out.append(f"left out {path.name}: {error}")
    return left_out


def _insert(connection: sqlite3.Connection, session: Session) -> None:
    facts, sides = session.facts, session.sides
    if ANCHOR not in sides:
        raise RunError(f"{session.directory / sessions.SESSION_FILE} has no side '{ANCHOR}'")
    found = comparison.of_session(session, BASELINE, CANDIDATE)
    metrics = list(_metrics(session))
    connection.execute("INSERT INTO nights VALUES (?, ?, ?, ?, ?, ?, ?, ?)", (
        session.name, facts["started"], sessions.machine_key(facts["machine"]),
        *(sides[side]["commit"] for side in (CANDIDATE, BASELINE, ANCHOR)), found.gate.valid,
        comparison.verdict_sentence(found)))
    connection.executemany("INSERT INTO metrics VALUES (?, ?, ?, ?, ?, ?)",
                           [(session.name, *metric) for metric in metrics])


def _metrics(session: Session) -> Iterator[tuple[object, ...]]:
    """kind, subject, value, low, high."""
    for cell, ratios in session.log_ratios(FIRST, ANCHOR, CANDIDATE).items():
        size = judging.shift(ratios, 0.0, f"{cell} history").size
        yield CPU, cell, size.value, size.low, size.high
    for cell in session.cells():
        pair = [session.counts.get((cell, side)) for side in (ANCHOR, CANDIDATE)]
        if all(pair):
            yield INSTRUCTIONS, cell, float(np.log(pair[1] / pair[0])), None, None
    rows = load_run(session.directory / CANDIDATE / comparison.OPEN).rows
    for algorithm, own in rows.groupby("algorithm", observed=True):
        for kind, field in ((GAP, "gap_nats"), (INTEGRAL, "integral")):
            if own[field].notna().any():
                yield kind, str(algorithm), float(own[field].astype(float).mean()), None, None


def load(database: Path) -> tuple[list[Night], list[Series]]:
    """Nights by time, and every metric of the valid ones. Raises RunError if it is no history of
    this schema."""
    if not database.is_file():
        raise RunError(f"there is no history {database}; scripts/history.py makes it")
    lines, values = _read(database)
    nights = [Night(*line[:5], bool(line[5]), line[6]) for line in lines]
    names = {night.name for night in nights}
    for name, *_ in values:
        if name not in names:
            raise RunError(f"{database} is damaged: it has metrics of a night {name}, and no such "
                           "night")
    return nights, _series(nights, values)


def _read(database: Path) -> tuple[list[tuple[Any, ...]], list[tuple[Any, ...]]]:
    """Lines of its two tables, whose fields are what they should be."""
    with _opened(database) as connection:
        return (_select(connection, "nights", _NIGHT, "ORDER BY started, id", database),
                _select(connection, "metrics", _METRIC, "", database))


@contextmanager
def _opened(database: Path) -> Iterator[sqlite3.Connection]:
    """A history, to be read; raises RunError if it is none, or has no such tables."""
    try:
        uri = f"{database.resolve().as_uri()}?mode=ro"
        with closing(sqlite3.connect(uri, uri=True)) as connection:
            version = connection.execute("PRAGMA user_version").fetchone()[0]
            if version != SCHEMA_VERSION:
                raise RunError(f"{database} is no history: it has schema version {version}; "
                               f"read is {SCHEMA_VERSION}")
            connection.execute("SELECT id FROM nights LIMIT 1")
            yield connection
    except sqlite3.DatabaseError as error:
        raise RunError(f"{database} is no history: {error}") from None


def _select(connection: sqlite3.Connection, table: str, fields: schema.Fields, order: str,
            database: Path) -> list[tuple[Any, ...]]:
    lines = connection.execute(f"SELECT {', '.join(fields)} FROM {table} {order}").fetchall()
    for number, line in enumerate(lines, start=1):
        where = f"{database} is damaged: line {number} of {table}"
        schema.check(dict(zip(fields, line)), fields, where)
    return lines


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
