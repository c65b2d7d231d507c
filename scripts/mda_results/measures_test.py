"""Statistics against cases that are known in closed form."""

import itertools
import math

import numpy as np
import pytest

from mda_results import measures

INF = math.inf


def test_shifted_geometric_mean_by_hand():
    assert measures.shifted_geometric_mean(np.array([0.0, 8.0]), 1.0) == pytest.approx(2.0)
    assert measures.shifted_geometric_mean(np.array([1.0, 9.0]), 1e-12) == pytest.approx(3.0)
    far = measures.shifted_geometric_mean(np.array([1.0, 9.0]), 1e6)
    assert far == pytest.approx(5.0, rel=1e-4)  # the arithmetic mean
    assert math.isnan(measures.shifted_geometric_mean(np.array([]), 1.0))


def test_profile_of_a_known_table():
    times = np.array([[1.0, 2.0, INF], [4.0, 1.0, INF], [3.0, 3.0, INF], [INF, INF, INF]])
    ratios = measures.performance_ratios(times)
    assert ratios.tolist() == [[1, 2, INF], [4, 1, INF], [1, 1, INF], [INF, INF, INF]]
    shares = measures.share_within(ratios, [1.0, 1.99, 2.0, 4.0, 1e9])
    assert shares[:, 0].tolist() == [0.5, 0.5, 0.5, 0.75, 0.75]
    assert shares[:, 1].tolist() == [0.5, 0.5, 0.75, 0.75, 0.75]
    assert shares[:, 2].tolist() == [0.0] * 5  # fails everywhere


def test_profile_changes_when_the_best_leaves():
    times = np.array([[1.0, 2.0, 3.0], [9.0, 2.0, 1.5]])
    alone = measures.performance_ratios(times[:, 1:])
    assert alone[0].tolist() == [1.0, 1.5]
    assert measures.performance_ratios(times)[0, 1:].tolist() == [2.0, 3.0]


def test_holm_by_hand():
    assert measures.holm([0.01, 0.04, 0.03, 0.005]) == pytest.approx([0.03, 0.06, 0.06, 0.02])
    assert measures.holm([0.5, 0.6]) == [1.0, 1.0]
    assert measures.holm([]) == []


def signed_rank_by_enumeration(differences: list[float]) -> float:
    """Two-sided: every sign is as likely as the other; equal sizes share their mean rank."""
    sizes = sorted(map(abs, differences))
    ranks = [sizes.index(abs(d)) + (1 + sizes.count(abs(d))) / 2 for d in differences]
    positive = sum(r for r, d in zip(ranks, differences) if d > 0)
    smaller = min(positive, sum(ranks) - positive)
    sums = [sum(r for r, s in zip(ranks, signs) if s)
            for signs in itertools.product([False, True], repeat=len(differences))]
    return min(1.0, 2 * sum(s <= smaller for s in sums) / len(sums))


@pytest.mark.parametrize("differences", [
    [1.0, 2.0, 3.0, 4.0, 5.0, 6.0], [1.0, -2.0, 3.0, 4.0, -0.5, 8.0, 7.0], [1.0, -2.0],
    [1.0, 1.0, 2.0, -1.0, 2.0, 5.0], [3.0, 3.0, 3.0, 3.0, -3.0]])
def test_signed_ranks_against_enumeration(differences):
    expected = signed_rank_by_enumeration(differences)
    assert measures.signed_rank_p(np.array([*differences, 0.0])) == pytest.approx(expected)
    assert measures.signed_rank_p(-np.array(differences)) == pytest.approx(expected)


def test_signed_ranks_near_their_normal_limit(monkeypatch):
    draw = np.random.default_rng(4)
    samples = [draw.normal(shift, 1.0, 51) for shift in (0.0, 0.2, 0.4)]
    limits = [measures.signed_rank_p(sample) for sample in samples]
    monkeypatch.setattr(measures, "_EXACT_UP_TO", 60)
    assert limits == pytest.approx([measures.signed_rank_p(s) for s in samples], abs=0.01)


def test_signed_ranks_of_ties_and_nothing():
    assert measures.signed_rank_p(np.zeros(9)) == 1.0
    assert measures.signed_rank_p(np.ones(20)) < 1e-4
    assert measures.signed_rank_p(np.array([1.0, -1.0] * 10)) == pytest.approx(1.0)


def test_front_of_a_known_table():
    gap, time = np.array([0.0, 1.0, 1.0, 2.0, 0.0]), np.array([9.0, 3.0, 4.0, 1.0, 9.0])
    found = [measures.dominator(gap, time, i) for i in range(5)]
    assert found == [None, None, 1, None, None]


def test_places_by_hand_and_of_ties():
    share = np.array([-1.0, -1.0, -0.5, -1.0, -1.0])
    gap = np.array([0.0, 0.0, 0.0, 0.5, 0.0])
    time = np.array([2.0, 1.0, 0.1, 0.1, 2.0])
    assert measures.places(share, gap, time).tolist() == [2, 1, 5, 4, 2]
    assert measures.places(np.ones(3)).tolist() == [1, 1, 1]
    rows = np.array([[3.0, 1.0, 2.0], [1.0, 1.0, 0.0]])
    assert measures.places(rows).tolist() == [[3, 1, 2], [2, 2, 1]]


def test_slope_of_a_line():
    x = np.array([1.0, 2.0, 5.0, 7.0])

    def of(y):
        return float(measures.slope(len(x), x.sum(), y.sum(), (x * x).sum(), (x * y).sum()))

    assert of(3.0 * x - 2.0) == pytest.approx(3.0)
    x = np.full(4, 2.0)
    assert math.isnan(of(np.arange(4.0)))
