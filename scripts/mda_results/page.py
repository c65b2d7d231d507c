"""The page about one or several runs, as one HTML text."""

import re
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import pandas as pd

from mda_results import page_assets, page_data, page_html, page_studies, pool, rank_report
from mda_results.page_courses import courses
from mda_results.page_scenes import Scene, scenes_of
from mda_results.render import Report, Table
from mda_results.rows import check_torn, load_manifest, unfinished
from mda_results.standings import SHIFT_MS


@dataclass(frozen=True)
class Page:
    html: str
    warnings: list[str]


@dataclass(frozen=True)
class _Contents:
    """What the runs hold."""

    pool: pool.Pool
    rows: pd.DataFrame  # of facts.judged()
    ranking: Report
    manifests: dict[str, Any]  # by name of the run
    scenes: list[Scene]
    courses: list[dict[str, Any]]
    studies: list[page_studies.Study]
    told: list[str]  # what a reader must know first
    lacking: list[str]  # studies that are left out, and why


def make(directories: Sequence[Path], more: Sequence[str] = ()) -> Page:
    """The page of these runs, with `more` sections before the last one; the same for the same
    files. Raises RunError if a run is damaged or the chart library is missing."""
    script = page_assets.bundle()
    contents, warnings = _contents(directories)
    *sections, origin = _sections(contents)
    sections += [*more, origin]
    title = "mda-bench: " + ", ".join(contents.pool.names)
    return Page(_filled(
        title=page_html.text(title), lead=page_html.text(_lead(contents)),
        style=_source("page.css"), places=_places(sections), sections="".join(sections),
        licences=page_assets.licences(), script=script,
        data=page_data.packed(_data(contents))), warnings)


def _contents(directories: Sequence[Path]) -> tuple[_Contents, list[str]]:
    loaded = pool.load(directories)
    warnings = [note for run in directories for note in unfinished(run)] + loaded.warnings
    rows = rank_report.judged(loaded).rows
    manifests = {d.resolve().name: load_manifest(d / "manifest.json") for d in directories}
    scenes = [scene for run in directories for scene in _scenes(run, warnings)]
    studies, lacking = page_studies.studies(directories)
    return _Contents(loaded, rows, rank_report.rank(loaded).report, manifests, scenes,
                     courses(directories), studies, warnings, lacking), warnings


def _scenes(run: Path, warnings: list[str]) -> list[Scene]:
    """With the name of the run, as several may have one scene."""
    torn: list[str] = []
    scenes = scenes_of(run, torn)
    check_torn(run, torn)
    warnings += torn
    return [{**scene, "run": run.resolve().name} for scene in scenes]


def _source(name: str) -> str:
    return (page_assets.SOURCES / name).read_text(encoding="utf-8")


def _filled(**parts: str) -> str:
    """The template with its {{names}} replaced, once: what is put in is not looked at again."""
    return re.sub(r"\{\{(\w+)\}\}", lambda name: parts[name[1]], _source("page.html"))


def _lead(contents: _Contents) -> str:
    rows, outings = contents.rows, len(contents.pool.outings)
    held = []
    if len(rows):
        held += [f"{len(rows):,} rows", f"{rows['window'].nunique():,} windows",
                 f"{rows['algorithm'].nunique()} algorithms"]
    if outings:
        held.append(f"{outings:,} closed-loop outings")
    return ", ".join(held) + "."


def _places(sections: list[str]) -> str:
    found = [re.match(r'<section id="([\w-]+)"><h2>(.*?)</h2>', part) for part in sections]
    return "".join(f'<a href="#{m[1]}">{m[2]}</a>' for m in found if m)


def _sections(contents: _Contents) -> list[str]:
    section, place = page_html.section, page_html.place
    tables = _Tables(contents.ranking.tables)
    about = "".join(f'<p class="warning">{page_html.text(line)}</p>' for line in contents.told)
    said = "Easy and hard windows apart; how sure it is, in brackets." if len(contents.rows) else ""
    parts = [section("ranking", "Ranking", said, about,
                     f'<div id="ranks"><div class="whole">{tables.open("ranking")}'
                     f"{page_html.notes(contents.ranking.lines)}</div></div>", place("trade"),
                     tables.open("correctness"), tables.open("fates"),
                     tables.folded("gaps", "apart", "pareto"),
                     tables.starting("beats_"))]
    if len(contents.rows):
        parts += [
            section("maps", "Where it is hard", "By group, K and scan period.", place("heat"),
                    tables.starting("hardness_")),
            section("time", "Time", "", place("curves"), place("growth"),
                    tables.folded("times", "profiles", "time_to_gap", "scaling"))]
    closed = tables.rest()
    if closed:
        parts.append(section("closed", "Closed loop", "Every algorithm drives its own windows.",
                             closed, place("courses", pair=False)))
    said = "" if contents.scenes else "These runs record no scene (scenes.jsonl)."
    parts.append(section("scenario", "Scenario", said, place("scene", pair=False)))
    parts += [section(s.name, s.report.name, "", page_html.report_cards(s.report, folded=True))
              for s in contents.studies]
    if len(contents.rows):
        parts.append(section("rows", "Rows", "", place("raw", pair=False)))
    parts.append(section("origin", "Origin", "What the runs say about themselves.",
                         page_html.notes(contents.lacking),
                         *(_origin(name, found) for name, found in contents.manifests.items())))
    return parts


class _Tables:
    """Tables of the ranking as HTML, each given out once."""

    def __init__(self, tables: list[Table]) -> None:
        self._left = {table.name: table for table in tables}

    def open(self, name: str) -> str:
        return page_html.table_card(self._left.pop(name)) if name in self._left else ""

    def folded(self, *names: str) -> str:
        return "".join(page_html.table_card(self._left.pop(n), folded=True) for n in names
                       if n in self._left)

    def starting(self, word: str) -> str:
        return self.folded(*[name for name in self._left if name.startswith(word)])

    def rest(self) -> str:
        return "".join(map(self.open, list(self._left)))


def _origin(name: str, manifest: dict[str, Any]) -> str:
    simple = [(key, value) for key, value in manifest.items()
              if not isinstance(value, (dict, list))]
    simple += [(key, ", ".join(map(str, value))) for key, value in manifest.items()
               if isinstance(value, list)]
    simple += [(key, ", ".join(f"{k} {v}" for k, v in manifest[key].items()))
               for key in ("libraries",) if isinstance(manifest.get(key), dict)]
    return (f'<details class="card"><summary>{page_html.text(name)}</summary>'
            f"{page_html.facts(simple)}</details>")


def _data(contents: _Contents) -> dict[str, Any]:
    rows, scenes = contents.rows, contents.scenes
    frames = (rows, contents.pool.outings)
    named = {name for frame in frames for name in frame["algorithm"].unique()}
    named |= {answer["algorithm"] for scene in scenes for answer in scene["answers"]}
    order = {name: i for i, name in enumerate(contents.manifests)}
    tables = (page_data.columns_of(rows.assign(run=rows["run"].map(order))) if len(rows)
              else {"rows": {"count": 0, "columns": {}}, "windows": {"count": 0, "columns": {}}})
    return {**tables, "scenes": scenes, "courses": contents.courses,
            "styles": page_data.styles_of(sorted(named)),
            "runs": [_run(name, manifest) for name, manifest in contents.manifests.items()],
            "shift_ms": SHIFT_MS, **_first_shown(rows)}


def _run(name: str, manifest: dict[str, Any]) -> dict[str, Any]:
    """What the command that makes a row again needs."""
    sweep = manifest.get("sweep") if isinstance(manifest.get("sweep"), dict) else {}
    files = [word for word in manifest.get("arguments", []) if str(word).endswith(".toml")]
    return {"name": name, "sweep": files[0] if files else sweep.get("name", "SWEEP"),
            "seed": sweep.get("seed", 1), "time_limit_s": pool.time_limit_s(manifest)}


def _first_shown(rows: pd.DataFrame) -> dict[str, str | None]:
    """The algorithms that the heat maps begin with: one with an LP, and the one of largest gaps."""
    if not len(rows):
        return {"lp_algorithm": None, "gap_algorithm": None}
    own = rows.groupby("algorithm")
    solved, gaps = own["integral"].count(), own["gap_nats"].mean()
    return {"lp_algorithm": str(solved.idxmax()),
            "gap_algorithm": str(gaps.idxmax() if gaps.notna().any() else solved.idxmax())}
