#include "algorithms/marginal/frontier_order.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "algorithms/testing/random_scans.h"

namespace mda {
namespace {

constexpr std::size_t index(int i) noexcept { return static_cast<std::size_t>(i); }

/// Width and work from the definition: a shared bit is in the mask from its first layer to its
/// last.
FrontierOrder replay(const Incidence& incidence, const std::vector<int>& layers) {
  FrontierOrder result{.layers = layers, .width = 0, .work = 0.0};
  std::vector<int> place(index(incidence.layers()));
  for (std::size_t i = 0; i < layers.size(); ++i) place[index(layers[i])] = static_cast<int>(i);
  std::vector<int> width(layers.size(), 0);
  for (int b = 0; b < incidence.bits(); ++b) {
    if (incidence.is_private(b)) continue;
    std::vector<int> places;
    for (int i = incidence.bit_begin[index(b)]; i < incidence.bit_begin[index(b) + 1]; ++i) {
      places.push_back(place[index(incidence.layer_of_bit[index(i)])]);
    }
    const auto [first, last] = std::minmax_element(places.begin(), places.end());
    for (int i = *first; i <= *last; ++i) ++width[index(i)];
  }
  for (std::size_t i = 0; i < layers.size(); ++i) {
    const int pairs =
        incidence.layer_begin[index(layers[i]) + 1] - incidence.layer_begin[index(layers[i])];
    result.width = std::max(result.width, width[i]);
    result.work += std::ldexp(3.0 * (pairs + 1), width[i]);
  }
  return result;
}

std::vector<Cluster> clusters_of(const testing::ScanShape& shape, std::uint64_t seed) {
  ScanWeights weights;
  weights.read(testing::random_scan(shape, seed));
  return {weights.clusters().begin(), weights.clusters().end()};
}

TEST(FrontierOrder, SaysWhatItCosts) {
  testing::ScanShape shape{.tracks = 30, .plots = 40, .length = 30.0, .height = 3.0, .gate = 2.0};
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    SCOPED_TRACE(seed);
    for (const Cluster& cluster : clusters_of(shape, seed)) {
      for (const bool mask_tracks : {true, false}) {
        const Incidence incidence = incidence_of(cluster, mask_tracks);
        const FrontierOrder order = find_frontier_order(incidence);
        std::vector<int> sorted = order.layers;
        std::sort(sorted.begin(), sorted.end());
        std::vector<int> all(index(incidence.layers()));
        std::iota(all.begin(), all.end(), 0);
        ASSERT_EQ(sorted, all);
        const FrontierOrder expected = replay(incidence, order.layers);
        EXPECT_EQ(order.width, expected.width);
        EXPECT_DOUBLE_EQ(order.work, expected.work);
      }
    }
  }
}

/// Against all orders of at most 7 layers.
TEST(FrontierOrder, IsMostlyTheCheapestAndNeverFarFromIt) {
  testing::ScanShape shape{.tracks = 6, .plots = 7, .length = 6.0, .height = 2.0, .gate = 1.3};
  int best = 0;
  int others = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    SCOPED_TRACE(seed);
    for (const Cluster& cluster : clusters_of(shape, seed)) {
      const Incidence incidence = incidence_of(cluster, true);
      std::vector<int> layers(index(incidence.layers()));
      std::iota(layers.begin(), layers.end(), 0);
      double least = replay(incidence, layers).work;
      while (std::next_permutation(layers.begin(), layers.end())) {
        least = std::min(least, replay(incidence, layers).work);
      }
      const double found = find_frontier_order(incidence).work;
      EXPECT_GE(found, least);
      EXPECT_LE(found, 3.0 * least);
      ++(found == least ? best : others);
    }
  }
  EXPECT_GE(best, others);
}

/// Tracks and plots in turn on a line: whatever their numbers, two bits are enough.
TEST(FrontierOrder, FollowsAChain) {
  constexpr int kTracks = 40;
  ProblemBuilder builder;
  for (int t = 0; t < kTracks; ++t) builder.add_row(0, RowUse::kAtMostOnce);
  for (int j = 0; j <= kTracks; ++j) builder.add_row(1, RowUse::kAtMostOnce);
  for (int t = 0; t < kTracks; ++t) {
    const int place = (t * 17) % kTracks;
    builder.add_column(-1.0, std::vector{t, kTracks + place});
    builder.add_column(-1.0, std::vector{t, kTracks + place + 1});
  }
  ScanWeights weights;
  weights.read(builder.build());
  ASSERT_EQ(weights.clusters().size(), 1U);
  EXPECT_LE(find_frontier_order(incidence_of(weights.clusters()[0], true)).width, 2);
  EXPECT_LE(find_frontier_order(incidence_of(weights.clusters()[0], false)).width, 2);
}

/// So wide that its work is beyond any number.
TEST(FrontierOrder, OfAClusterTooWideIsComplete) {
  testing::ScanShape shape{.tracks = 1100, .plots = 1100};
  ScanWeights weights;
  weights.read(testing::random_scan(shape, 1));
  const FrontierOrder order = find_frontier_order(incidence_of(weights.clusters()[0], true));
  EXPECT_EQ(order.layers.size(), 1100U);
  EXPECT_EQ(order.width, 1100);
}

}  // namespace
}  // namespace mda
