"""The page about one or several runs, as one HTML text."""

import re
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import pandas as pd

from mda_results import facts, page_assets, page_data, page_html, page_studies, pool
from mda_results.page_scenes import scenes_of
from mda_results.rows import load_manifest, unfinished

SHIFT_MS = 1.0


@dataclass(frozen=True)
class Page:
    html: str
    warnings: list[str]


def make(directories: Sequence[Path]) -> Page:
    """The page of these runs; the same for the same files. Raises RunError if a run is damaged or
    the chart library is missing."""
    script = page_assets.bundle()
    loaded = pool.load(directories)
    warnings = [note for run in directories for note in unfinished(run)] + loaded.warnings
    rows = facts.judged(loaded.rows) if len(loaded.rows) else loaded.rows
    manifests = {d.resolve().name: load_manifest(d / "manifest.json") for d in directories}
    scenes = [scene for run in directories for scene in scenes_of(run, warnings)]
    studies, lacking = page_studies.studies(directories)
    title = "mda-bench: " + ", ".join(loaded.names)
    sections = _sections(loaded, rows, manifests, scenes, studies, [*warnings, *lacking])
    return Page(_filled(
        title=page_html.text(title), lead=page_html.text(_lead(rows, loaded)),
        style=_source("page.css"), places=_places(sections), sections="".join(sections),
        licences=page_assets.licences(), script=script,
        data=page_data.packed(_data(rows, manifests, scenes))), warnings)


def _source(name: str) -> str:
    return (page_assets.SOURCES / name).read_text(encoding="utf-8")


def _filled(**parts: str) -> str:
    """The template with its {{names}} replaced, once: what is put in is not looked at again."""
    return re.sub(r"\{\{(\w+)\}\}", lambda name: parts[name[1]], _source("page.html"))


def _lead(rows: pd.DataFrame, loaded: pool.Pool) -> str:
    outings = len(loaded.born) + len(loaded.known)
    held = [f"{len(rows):,} rows"] if len(rows) else []
    if len(rows):
        held += [f"{rows['window'].nunique():,} windows", f"{rows['algorithm'].nunique()} algorithms"]
    if outings:
        held.append(f"{outings:,} closed-loop outings")
    return ", ".join(held) + "."


def _places(sections: list[str]) -> str:
    found = [re.match(r'<section id="([\w-]+)"><h2>(.*?)</h2>', part) for part in sections]
    return "".join(f'<a href="#{m[1]}">{m[2]}</a>' for m in found if m)


def _sections(loaded: pool.Pool, rows: pd.DataFrame, manifests: dict[str, Any],
              scenes: list[Any], studies: list[page_studies.Study],
              told: list[str]) -> list[str]:
    section, place = page_html.section, page_html.place
    about = "".join(f'<p class="warning">{page_html.text(line)}</p>' for line in told)
    parts = [section("overview", "Overview", "", about, page_html.notes(loaded.about))]
    if len(rows):
        parts += [
            section("ranks", "Ranking", "", '<div id="ranking"></div>', place("ranking-charts")),
            section("maps", "Where it is hard", "Of every group, K and scan period: the share of "
                    "integral LPs, proofs, gaps, times.", place("heat")),
            section("speed", "Time", "", place("curves"), place("scaling"))]
    if scenes:
        parts.append(section("viewer", "Scenario", "", place("scene").replace(" pair", "")))
    for study in studies:
        parts.append(section(study.name, study.report.name, "",
                             page_html.report_cards(study.report, folded=True)))
    if len(rows):
        parts.append(section("rows", "Rows", "", place("raw").replace("pair", "card")))
    parts.append(section("origin", "Origin", "What the runs say about themselves.",
                         *(_origin(name, manifest) for name, manifest in manifests.items())))
    return parts


def _origin(name: str, manifest: dict[str, Any]) -> str:
    simple = [(key, value) for key, value in manifest.items()
              if not isinstance(value, (dict, list))]
    simple += [(key, ", ".join(map(str, value))) for key, value in manifest.items()
               if isinstance(value, list)]
    simple += [(key, ", ".join(f"{k} {v}" for k, v in manifest[key].items()))
               for key in ("libraries",) if isinstance(manifest.get(key), dict)]
    return (f'<details class="card"><summary>{page_html.text(name)}</summary>'
            f"{page_html.facts(simple)}</details>")


def _data(rows: pd.DataFrame, manifests: dict[str, Any], scenes: list[Any]) -> dict[str, Any]:
    named = set(rows["algorithm"]) | {a["algorithm"] for s in scenes for a in s["answers"]}
    order = {name: i for i, name in enumerate(manifests)}
    tables = (page_data.columns_of(rows.assign(run=rows["run"].map(order))) if len(rows)
              else {"rows": {"count": 0, "columns": {}}, "windows": {"count": 0, "columns": {}}})
    return {**tables, "scenes": scenes, "styles": page_data.styles_of(sorted(named)),
            "runs": [_run(name, manifest) for name, manifest in manifests.items()],
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
