"""Laws of the bootstrap interval."""

import math

import numpy as np
import pandas as pd
import pytest

from mda_results import bootstrap
from mda_results.render import Estimate


def units(count: int, group: str = "A", seed: int = 2) -> pd.DataFrame:
    draw = np.random.default_rng(seed)
    return pd.DataFrame({"group": group, "replicate": np.arange(count),
                         "part": draw.integers(0, 10, count), "whole": 10})


def test_interval_contains_the_ratio_and_repeats():
    frame = units(20)
    found = bootstrap.ratio(frame, "part", "whole")
    assert found.value == pytest.approx(frame["part"].sum() / 200)
    assert found.low < found.value < found.high
    assert bootstrap.ratio(frame.sample(frac=1.0, random_state=1), "part", "whole") == found


def test_interval_has_the_width_of_the_central_limit():
    frame = units(400)
    found = bootstrap.ratio(frame, "part", "whole")
    normal = 2 * 1.96 * (frame["part"] / 10).std() / math.sqrt(400)
    assert found.high - found.low == pytest.approx(normal, rel=0.1)


def test_the_scenario_is_the_unit():
    frame = units(20)
    repeated = pd.concat([frame] * 30)
    assert bootstrap.ratio(repeated, "part", "whole") == bootstrap.ratio(frame, "part", "whole")


def test_groups_are_resampled_apart():
    one, other = units(10).assign(part=0), units(10, "B").assign(part=10)
    assert bootstrap.ratio(pd.concat([one, other]), "part", "whole") == Estimate(0.5, 0.5, 0.5)


def test_no_interval_from_one_scenario_and_nothing_from_none():
    assert bootstrap.ratio(units(1), "part", "whole").low is None
    assert bootstrap.ratio(units(5).assign(whole=0), "part", "whole") is None
