"""The statistics of a session against their definitions."""

import itertools

import numpy as np
import pytest
from scipy.stats import binom

from mda_nightly import judging
from mda_nightly.judging import credible, gate, shift


def test_benjamini_and_hochberg_by_the_definition() -> None:
    draw = np.random.default_rng(1)
    for _ in range(200):
        p = draw.beta(0.3, 2.0, size=int(draw.integers(1, 9)))
        ordered = sorted(p)
        k = max([i for i, x in enumerate(ordered, start=1) if x <= 0.05 * i / len(p)], default=0)
        assert credible(p) == [x in ordered[:k] for x in p]


def test_benjamini_and_hochberg_does_not_see_the_order() -> None:
    p = [0.001, 0.011, 0.02, 0.5]
    for order in itertools.permutations(range(4)):
        assert credible([p[i] for i in order]) == [credible(p)[i] for i in order]
    assert credible([]) == []


@pytest.mark.parametrize("cells", [1, 2, 12, 31, 100])
def test_the_gate_allows_what_one_good_session_in_a_hundred_exceeds(cells: int) -> None:
    assert judging._most_beside_zero(cells) == binom.ppf(0.99, cells, 0.05)


def test_intervals_hold_the_truth_about_as_often_as_they_say() -> None:
    draw = np.random.default_rng(2)
    held = 0
    for _ in range(400):
        size = shift(draw.standard_t(3, 13), 0.0, "cell").size
        held += size.low <= 0.0 <= size.high
    assert 0.88 <= held / 400 <= 0.99


def test_a_shift_moves_with_the_values_and_turns_with_their_sign() -> None:
    values = np.random.default_rng(3).normal(0, 0.01, 13)
    plain, moved, turned = (shift(v, 0.0, "cell").size for v in (values, values + 1, -values))
    for a, b, c in zip((plain.value, plain.low, plain.high), (moved.value, moved.low, moved.high),
                       (turned.value, turned.high, turned.low)):
        assert b == pytest.approx(a + 1) and c == pytest.approx(-a)


def test_more_noise_makes_a_change_less_credible() -> None:
    values = np.random.default_rng(4).normal(0.05, 0.02, 13)
    p = [shift(values, noise, "cell").p for noise in (0.0, 0.01, 0.03, 0.05, 0.08)]
    assert p == sorted(p)


def test_the_gate_is_as_noisy_as_its_worst_cell_but_never_below_one_percent() -> None:
    quiet = {f"cell {i}": np.full(13, 0.0) for i in range(12)}
    assert gate(quiet).noise == judging.LEAST_CHANGE
    loud = {**quiet, "cell 3": np.full(13, -0.015)}
    assert gate(loud).noise == 0.015 and gate(loud).valid
    assert not gate({**quiet, "cell 3": np.full(13, 0.021)}).valid
