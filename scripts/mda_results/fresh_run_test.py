"""A run as the program writes it, read by the scripts. ctest says where the program is; skipped
where nobody does."""

import os
import subprocess
from pathlib import Path

import pytest

from mda_results import page, page_assets, pool, rank_report
from mda_results.page_scenes import Scene, scenes_of

PROGRAM = os.environ.get("MDA_BENCH", "")

pytestmark = pytest.mark.skipif(not PROGRAM, reason="MDA_BENCH does not say where mda-bench is")


@pytest.fixture(scope="module", params=["open", "closed"])
def run(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> Path:
    directory = tmp_path_factory.mktemp("fresh") / request.param
    words = [PROGRAM, "run", "smoke", "--scenarios", "A,D", "--replicates", "2", "--algorithms",
             "exact,greedy,lp", "--out", str(directory)]
    subprocess.run([*words, *(["--closed-loop"] if request.param == "closed" else [])], check=True,
                   capture_output=True)
    return directory


def taken(scene: Scene, scan: int, tracks: list[list[int]]) -> list[int]:
    """The sources of the plots that the tracks take in this scan."""
    return [int(scene["plots"][scan - 1][plots[scan - first]][2]) for first, *plots in tracks
            if 0 <= scan - first < len(plots) and plots[scan - first] >= 0]


def test_the_first_scene_of_every_scenario_is_there(run):
    warnings: list[str] = []
    scenes = scenes_of(run, warnings)
    assert warnings == []
    assert [(s["scenario"], s["replicate"]) for s in scenes] == [("A", 1), ("D", 1)]
    for scene in scenes:
        assert [(a["window_k"], a["algorithm"]) for a in scene["answers"]] == [
            (k, a) for k in (3, 5) for a in ("exact", "greedy")]
        assert {answer["loop"] for answer in scene["answers"]} == {run.name}
        for answer in scene["answers"]:
            sources = [s for entry in answer["scans"]
                       for s in taken(scene, entry["scan"], entry["tracks"])]
            assert sum(s >= 0 for s in sources) > 0.9 * len(sources) > 0, "tracks follow targets"


def test_ranking_and_page_take_it(run, monkeypatch):
    for name in ("bundle", "licences"):
        monkeypatch.setattr(page_assets, name, lambda: "")
    assert rank_report.rank(pool.load([run])).report.tables
    made = page.make([run])
    assert made.warnings == [] and "These runs record no scene" not in made.html
