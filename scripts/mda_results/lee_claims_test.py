"""Verdicts on the claims of Lee & Jeong follow from the lines: planted runs turn them."""

from pathlib import Path
from typing import Any

import numpy as np
import pytest

from mda_results import lee_claims, lee_figures
from mda_results.position_targets import DENSITIES, load, without_echoes
from mda_results.position_testing import outing, per_target, write_position
from mda_results.verdicts import FAILS, HOLDS, OPEN, PARTLY

LOST = [False, False]


@pytest.fixture
def judged(tmp_path: Path):
    def verdicts_of(outings: list[dict], said: str, field: int = 4) -> list[str]:
        """Those of the claim whose text holds `said`, in order; or another field of its lines."""
        rules, claims = lee_claims.tables(load([write_position(tmp_path / "run", outings)]).outings)
        numbers = [r[0] for r in rules.rows if said in r[1]]
        assert len(numbers) == 1
        return [r[field] for r in claims.rows if r[0] == numbers[0]]

    return verdicts_of


def runs_of(algorithm: str, densities=(0.2, 0.8), law: str = "normal",
            scenes=("crossing", "parallel"), **changes: Any) -> list[dict]:
    return [outing(algorithm, scene, r, density, law, **changes)
            for density in densities for scene in scenes for r in (1, 2, 3)]


def test_which_keeps_more(judged):
    said = "keeps more tracks than HNPDA"
    hnpda = runs_of("hnpda", maintained_450m=LOST)
    assert judged(runs_of("mapada") + hnpda, said) == [HOLDS, FAILS]  # 0.45 km, 0.75 km
    assert judged(runs_of("mapada", maintained_450m=LOST) + runs_of("hnpda"), said)[0] == FAILS
    at_one = runs_of("hnpda", (0.2,)) + runs_of("hnpda", (0.8,), maintained_450m=LOST)
    assert judged(runs_of("mapada") + at_one, said)[0] == PARTLY
    assert judged(runs_of("mapada"), said) == [OPEN]
    assert judged(runs_of("mapada"), said, 3) == ["no data"]


def test_only_the_same_runs_are_compared(judged):
    outings = runs_of("mapada") + [
        {**line, "replicate": line["replicate"] + 3} for line in runs_of("hnpda")]
    assert judged(outings, "keeps more tracks than HNPDA", 3) == ["no data"]


def test_rms_errors_of_all_and_of_those_that_both_keep(judged):
    said = "smaller rms errors"
    # HNPDA is as near where both keep a track, and far off where it does not.
    hnpda = runs_of("hnpda", maintained_450m=[True, False], position_squares_km2=[0.08, 8.0],
                    velocity_squares_km2_s2=[0.0016, 8.0])
    outings = runs_of("mapada") + hnpda
    assert judged(outings, said) == [HOLDS, FAILS, HOLDS, FAILS]
    told = judged(outings, said, 3)
    assert f"C=0.2 {np.sqrt(8.08 / 0.16):.2f} [" in told[0] and "(12, 12)" in told[0]
    assert "C=0.2 1.00 [1.00, 1.00]" in told[1] and "(6, 6)" in told[1]


@pytest.mark.parametrize(("lost", "verdict"), [
    ((2, 3, 3, 3), HOLDS), ((3, 3, 3, 3), PARTLY), ((6, 6, 6, 6), FAILS)])
def test_near_the_published_maintenance(judged, lost, verdict):
    outings = []
    for density, count in zip(DENSITIES, lost):
        runs = runs_of("mapada", (density,))  # 12 tracks; the paper keeps 84, 76, 74 and 76 %
        for run in runs[:count]:
            run["maintained_450m"] = [True, False]
        outings += runs
    literal = runs_of("mapada-literal", DENSITIES)  # keeps all: none is near
    assert judged(outings + literal, "that of Table 3") == [verdict, FAILS]
    assert f"C=0.4 {100 - 100 * lost[1] / 12:.1f}, paper 76" in judged(outings, "of Table 3", 3)[0]


def test_best(judged):
    said = "optimal data association"
    worse = runs_of("gnn", maintained_450m=LOST, maintained_750m=LOST)
    assert judged(runs_of("mapada") + worse, said) == [HOLDS, HOLDS]
    mapada = runs_of("mapada", maintained_450m=[True, False])
    assert judged(mapada + worse + runs_of("lbp"), said) == [FAILS, OPEN]
    best = judged(mapada + worse + runs_of("mapada-miss") + runs_of("oracle"), said)
    assert best[0] == HOLDS
    assert judged(runs_of("mapada") + worse + runs_of("lbp"), said) == [OPEN, OPEN]


def test_consistency(judged):
    outings = runs_of("mapada") + runs_of("mapada-literal") + runs_of("hnpda")
    assert judged(outings, "always yields consistent") == [HOLDS, HOLDS]
    assert judged(outings, "in contrast to HNPDA") == [FAILS]
    outings[6]["conflict_rate"] = outings[13]["conflict_rate"] = 0.125
    assert judged(outings, "always yields consistent") == [FAILS, FAILS]
    outings[6]["conflict_rate"] = 0
    assert judged(outings, "always yields consistent") == [HOLDS, FAILS]
    assert judged(outings, "always yields consistent", 3)[1] == (
        "mapada-literal: conflicts in 1 of 96 scans")
    outings[-1]["conflict_rate"] = 0.5
    assert judged(outings, "in contrast to HNPDA") == [HOLDS]
    many = runs_of("hnpda", (0.2, 0.4, 0.6, 0.8))
    many[0]["conflict_rate"] = 0.125
    assert judged(many, "in contrast to HNPDA") == [FAILS], "1 scan of 192 is no contrast"


def test_steady(judged):
    said = "quite steady"
    suffers = runs_of("hnpda", (0.2,)) + runs_of("hnpda", (0.8,), maintained_450m=LOST,
                                                 position_squares_km2=[9.0, 9.0])
    assert judged(runs_of("mapada") + suffers, said) == [HOLDS, HOLDS]
    swapped = [{**line, "algorithm": "mapada"} for line in suffers] + runs_of("hnpda")
    assert judged(swapped, said) == [FAILS, FAILS]
    assert "+100.0 [+100.0, +100.0]" in judged(runs_of("mapada") + suffers, said, 3)[0]
    assert judged(runs_of("mapada", (0.2,)) + runs_of("hnpda", (0.2,)), said) == [OPEN]


def test_clutter(judged):
    suffers = runs_of("mapada", (0.2,)) + runs_of("mapada", (0.8,), maintained_450m=LOST)
    assert judged(suffers + runs_of("hnpda"), "more clutter makes it harder") == [HOLDS, FAILS]
    assert judged(runs_of("mapada", (0.2,)), "more clutter makes it harder") == [OPEN]
    normal, uniform = runs_of("mapada", (0.2,)), runs_of("mapada", (0.2,), "uniform")
    said = "than uniform clutter"
    lost = [{**line, "maintained_450m": LOST} for line in normal]
    assert judged(lost + uniform, said) == [HOLDS]
    assert judged(normal + [{**line, "maintained_450m": LOST} for line in uniform], said) == [FAILS]
    assert judged(normal, said, 3) == ["no data"]


@pytest.mark.parametrize(("changes", "verdict"), [
    ({}, FAILS), ({"maintained_450m": [True, False]}, HOLDS)])
def test_emulation(judged, changes, verdict):
    outings = runs_of("jpda") + runs_of("hnpda", **changes)
    assert judged(outings, "does not do what JPDA does") == [verdict]


def test_ten_targets(judged):
    hard = [True] * 7 + [False] + [True] * 2
    mapada = runs_of("mapada", (0.2,), scenes=("ten",))
    hnpda = runs_of("hnpda", (0.2,), scenes=("ten",), maintained_450m=hard,
                    **per_target(10, position_squares_km2=0.32, velocity_squares_km2_s2=0.0032))
    assert judged(mapada + hnpda, "superior to HNPDA with ten") == [HOLDS, HOLDS, FAILS]
    assert judged(mapada + hnpda, "target 8 is the hardest") == [HOLDS, FAILS]
    assert "keeps 0 %; +100.0" in judged(mapada + hnpda, "target 8 is the hardest", 3)[0]


def test_what_both_updates_share_is_said_once(tmp_path):
    soft = runs_of("mapada") + runs_of("hnpda")
    hard = [{**line, "update": "hard"} for line in soft]
    for line in hard[12:]:
        line["position_squares_km2"] = [9.0, 9.0]
    run = load([write_position(tmp_path / "soft", soft), write_position(tmp_path / "hard", hard)])
    verdicts = lee_claims.tables(without_echoes(run.outings))[1].rows
    assert [r[2] for r in verdicts if "mapada: conflicts" in r[3]] == ["either"]
    assert [r[2] for r in verdicts if "position, all tracks (" in r[3]] == ["hard", "soft"]


def test_one_run_decides_nothing(judged):
    outings = [outing(), outing("hnpda", maintained_450m=LOST)]
    assert judged(outings, "keeps more tracks than HNPDA") == [OPEN, OPEN]


def test_the_distance_is_that_of_a_point_from_a_line():
    """Equation (3): turning everything changes nothing, moving along the velocity neither."""
    random = np.random.default_rng(5)
    for x, y, vx, vy, angle, along in random.normal(size=(50, 6)):
        found = lee_figures.squared_distance(x, y, vx, vy)
        unit = np.array([vx, vy]) / np.hypot(vx, vy)
        assert found == pytest.approx(np.cross(unit, [x, y]) ** 2)
        cos, sin = np.cos(angle), np.sin(angle)
        turned = (cos * x - sin * y, sin * x + cos * y, cos * vx - sin * vy, sin * vx + cos * vy)
        assert lee_figures.squared_distance(*turned) == pytest.approx(found)
        moved = (x + along * vx, y + along * vy, vx, vy)
        assert lee_figures.squared_distance(*moved) == pytest.approx(found, abs=1e-12)
