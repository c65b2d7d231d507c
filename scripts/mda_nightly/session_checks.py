"""Whether the files of a session are what scripts/measure.py writes: a function per file.

All raise RunError, one sentence with file, line and field. Files that end early at the end of a
line look whole, so a finished session is compared with what session.json says should be there.
"""

from collections.abc import Collection, Iterable, Iterator, Mapping
from pathlib import Path
from typing import Any

from mda_nightly import schema
from mda_nightly.schema import COUNT, NAME, NOT_NEGATIVE, TEXT, TIME, WHOLE, may_be_absent
from mda_results.rows import RunError, json_lines, load_manifest

SCHEMA_VERSION = 1
SESSION_FILE, SAMPLES_FILE, COUNTS_FILE = "session.json", "samples.jsonl", "counts.jsonl"
BASELINE, TWIN, CANDIDATE, ANCHOR = "baseline", "twin", "candidate", "anchor"
PLANTED = "planted"  # of the experiment on noise: a side that has one cell, and that cell
FIRST, AGAIN = 1, 2  # passes: every cell, and the rerun of suspected ones
FINISHED = "finished"

SampleKey = tuple[int, str, str, int]  # pass, cell, side, round
Facts = Mapping[str, Any]  # session.json

_FACTS = {
    "id": NAME, "started": TIME, "outcome": NAME, "rounds": COUNT, "machine": schema.OBJECT,
    "sides": schema.OBJECTS, "cells": schema.OBJECTS,
    "broken": may_be_absent(schema.object_of(schema.object_of(TEXT))),
    "counted": may_be_absent(WHOLE),  # lines of counts.jsonl
    "rounds_again": may_be_absent(WHOLE), "planted": may_be_absent(NAME)}
_AT_THE_END = {"ended": TIME, "machine_at_end": schema.OBJECT}
_MACHINE = {"cpu": TEXT, "cores": COUNT,
            "load_1min": may_be_absent(schema.or_null(NOT_NEGATIVE)),
            "valgrind": may_be_absent(schema.or_null(TEXT))}
_SIDE = {"revision": NAME, "commit": TEXT, "programs": schema.object_of(NAME)}
_CELL = {"program": NAME}
_TIMES = schema.list_of(schema.POSITIVE)
_SAMPLE = {"cell": NAME, "side": NAME, "pass": schema.one_of(FIRST, AGAIN), "round": COUNT,
           "cpu_s": _TIMES, "wall_s": _TIMES, "stalled": NOT_NEGATIVE,
           "counters": schema.object_of(schema.NUMBER)}
_COUNTED = {"cell": NAME, "side": NAME, "instructions": COUNT}


def load_facts(directory: Path, unfinished: bool) -> dict[str, Any]:
    """session.json; with `unfinished`, of a session that is still being taken, too."""
    path = directory / SESSION_FILE
    facts = load_manifest(path)
    if not schema.one_of(SCHEMA_VERSION).holds(facts.get("schema_version")):
        raise RunError(f"{path} has schema version {schema.shown(facts.get('schema_version'))}; "
                       f"read is {SCHEMA_VERSION}")
    schema.check(facts, _FACTS, path)
    schema.check(facts["machine"], _MACHINE, path, "machine.")
    for group, fields in (("sides", _SIDE), ("cells", _CELL)):
        for name, found in facts[group].items():
            schema.check(found, fields, path, f"{group}.{name}.")
    _check_sides(facts, path)
    if facts["outcome"] == FINISHED:
        _check_end(facts, path)
    elif not unfinished:
        raise RunError(f"the session {directory} did not finish ({facts['outcome']}): no verdict")
    return facts


def _check_sides(facts: Facts, path: Path) -> None:
    sides, cells = facts["sides"], facts["cells"]
    for side in (BASELINE, TWIN, CANDIDATE):
        if side not in sides:
            raise RunError(f"{path} has no side '{side}'")
    if sides[TWIN]["programs"] != sides[BASELINE]["programs"]:
        raise RunError(f"{path}: sides.{TWIN}.programs are not those of {BASELINE}: it is no copy")
    for cell, why in facts.get("broken", {}).items():
        if cell not in cells or not set(why) <= set(sides):
            raise RunError(f"{path}: broken.{cell} names a cell or a side that is not there")
    if PLANTED in facts and not (facts[PLANTED] in cells and PLANTED in sides):
        raise RunError(f"{path}: planted is {schema.shown(facts[PLANTED])}, which is no cell, or "
                       f"there is no side '{PLANTED}'")


def _check_end(facts: Facts, path: Path) -> None:
    schema.check(facts, _AT_THE_END, path)
    schema.check(facts["machine_at_end"], _MACHINE, path, "machine_at_end.")
    ends = [machine_key(facts[name]) for name in ("machine", "machine_at_end")]
    if ends[0] != ends[1]:
        raise RunError(f"{path}: the session began on one machine ({ends[0]}) and ended on another "
                       f"({ends[1]}): no verdict")


def machine_key(machine: Mapping[str, Any]) -> str:
    """What has to be equal for times to be compared at all."""
    return f"{machine['cpu'] or 'unknown'}, {machine['cores']} cores"


def load_samples(path: Path, facts: Facts) -> dict[SampleKey, dict[str, Any]]:
    """samples.jsonl, which has all that session.json promises if the session is finished."""
    if not path.is_file():
        raise RunError(f"{path.parent} has no {path.name}")
    samples: dict[SampleKey, dict[str, Any]] = {}
    turns: dict[Any, Any] = {}
    problems: dict[Any, Any] = {}
    for where, line in _lines(path):
        schema.check(line, _SAMPLE, where)
        number, cell, side, r = key = line["pass"], line["cell"], line["side"], line["round"]
        _check_named(cell, side, facts, where)
        if key in samples:
            raise RunError(f"{where}: this sample is there twice")
        if not 0 < len(line["cpu_s"]) == len(line["wall_s"]):
            raise RunError(f"{where}: cpu_s has {len(line['cpu_s'])} turns and wall_s "
                           f"{len(line['wall_s'])}")
        _agree(turns, (number, cell, r), len(line["cpu_s"]), f"{where}: the number of turns")
        _agree(problems, (cell, side), line["counters"].get("problems"),
               f"{where}: counters.problems")
        samples[key] = line
    _check_rounds(samples, facts, path)
    return samples


def load_counts(path: Path, facts: Facts) -> dict[tuple[str, str], int]:
    """counts.jsonl by (cell, side); empty if nothing could count."""
    counts: dict[tuple[str, str], int] = {}
    for where, line in _lines(path) if path.is_file() else ():
        schema.check(line, _COUNTED, where)
        cell, side = key = line["cell"], line["side"]
        _check_named(cell, side, facts, where)
        if key in counts:
            raise RunError(f"{where}: this count is there twice")
        counts[key] = line["instructions"]
    expected = _expected_counts(facts)
    if expected is not None and len(counts) != expected:
        raise RunError(f"{path} holds {len(counts)} counts, and {expected} were taken: no verdict")
    return counts


def _expected_counts(facts: Facts) -> int | None:
    """None if nobody knows. Early sessions do not tell; there, valgrind bore every cell."""
    if "counted" in facts:
        return facts["counted"]
    if facts["outcome"] != FINISHED or PLANTED in facts or not facts["machine"].get("valgrind"):
        return None
    return sum(side != TWIN for _, side in _asked(facts))


def _lines(path: Path) -> Iterator[tuple[str, dict[str, Any]]]:
    """Every line, and where it is."""
    torn: list[str] = []
    for number, line in enumerate(json_lines(path, torn), start=1):
        yield f"{path}:{number}", line
    if torn:
        raise RunError(f"{path} ends in the middle of a line: no verdict")


def _check_named(cell: str, side: str, facts: Facts, where: str) -> None:
    for kind, name in (("cells", cell), ("sides", side)):
        if name not in facts[kind]:
            raise RunError(f"{where}: {kind[:-1]} is {schema.shown(name)}, which {SESSION_FILE} "
                           "does not name")


def _agree(known: dict[Any, Any], key: Any, value: Any, what: str) -> None:
    if known.setdefault(key, value) != value:
        raise RunError(f"{what} is {value}, and {known[key]} in an earlier line of "
                       f"{', '.join(map(str, key))}")


def _asked(facts: Facts) -> Iterable[tuple[str, str]]:
    """(cell, side) that were timed."""
    return ((cell, side) for cell in facts["cells"] for side in facts["sides"]
            if side not in facts.get("broken", {}).get(cell, ())
            and (side != PLANTED or cell == facts.get(PLANTED)))


def _check_rounds(samples: Collection[SampleKey], facts: Facts, path: Path) -> None:
    rounds: dict[tuple[int, str], dict[str, set[int]]] = {}
    for number, cell, side, r in samples:
        rounds.setdefault((number, cell), {}).setdefault(side, set()).add(r)
    for (_, cell), by_side in rounds.items():
        if len({frozenset(r) for r in by_side.values()}) > 1:
            raise RunError(f"{path} has not all samples of {cell}: no verdict")
    if facts["outcome"] == FINISHED:
        _check_first(rounds, facts, path)
        _check_again(rounds, facts, path)


def _check_first(rounds: Mapping[tuple[int, str], Mapping[str, set[int]]], facts: Facts,
                 path: Path) -> None:
    """Every cell and side of the first pass has all rounds. Early experiments
    name the rounds from before they went on once; else they are those in the end."""
    allowed = {facts["rounds"], facts["rounds"] * (2 if PLANTED in facts else 1)}
    asked = set(_asked(facts))
    there = {(cell, side) for (number, cell), by_side in rounds.items() if number == FIRST
             for side in by_side}
    for cell, side in sorted(asked ^ there):
        what = "no samples" if (cell, side) in asked else "samples that should not be there,"
        raise RunError(f"{path} has {what} of {cell} by {side}: no verdict")
    for cell, side in sorted(asked):
        found = rounds[FIRST, cell][side]
        if not (len(found) in allowed and _is_whole(found)):
            raise RunError(f"{path} has {len(found)} rounds of {cell} by {side}, and "
                           f"{SESSION_FILE} {facts['rounds']}: no verdict")
        if facts["cells"][cell]["program"] not in facts["sides"][side]["programs"]:
            raise RunError(f"{path.with_name(SESSION_FILE)}: sides.{side}.programs has no "
                           f"{facts['cells'][cell]['program']}, which ran {cell}")


def _check_again(rounds: Mapping[tuple[int, str], Mapping[str, set[int]]], facts: Facts,
                 path: Path) -> None:
    """Every cell of the rerun has the same rounds, by baseline and somebody else."""
    reruns = {cell: by_side for (number, cell), by_side in rounds.items() if number == AGAIN}
    most = max((len(r) for by_side in reruns.values() for r in by_side.values()), default=0)
    expected = facts.get("rounds_again", most)
    for cell, by_side in sorted(reruns.items()):
        if BASELINE not in by_side or len(by_side) < 2:
            raise RunError(f"{path} has not all samples of {cell}, timed again: no verdict")
        if any(len(r) != expected or not _is_whole(r) for r in by_side.values()):
            raise RunError(f"{path} has not all of {expected} rounds of {cell}, timed again: no "
                           "verdict")


def _is_whole(rounds: set[int]) -> bool:
    return rounds == set(range(1, len(rounds) + 1))
