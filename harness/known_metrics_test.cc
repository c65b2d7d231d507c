#include "harness/known_metrics.h"

#include <gtest/gtest.h>

namespace mda {
namespace {

TargetState at(double x, double y) { return {x, 0.0, y, 0.0}; }

TEST(KnownMetrics, DistancesAreMeansOverTheTracks) {
  const TrackStates a = {{at(0, 0), at(1, 1)}, {at(3, 4), at(0, 0)}};
  const TrackStates b = {{at(3, 4), at(1, 1)}, {at(3, 4), at(0, 0)}};
  EXPECT_EQ(mean_distances_km(a, b), (std::vector<double>{2.5, 0.0}));
  EXPECT_EQ(mean_distances_km(b, a), mean_distances_km(a, b));
  EXPECT_EQ(mean({}), 0.0);
}

TEST(KnownMetrics, LostOnceIsLostEver) {
  const TrackStates reference(3, {at(0, 0), at(0, 0), at(0, 0), at(0, 0)});
  TrackStates states = reference;
  states[1][0] = at(0, 2);       // strays and comes back
  states[2][1] = at(2, 0);       // is off at the end
  states[0][2] = at(0.6, 0.79);  // just within 1 km
  const LostShares lost = lost_shares(states, reference, 1.0);
  EXPECT_EQ(lost.ever, 0.5);
  EXPECT_EQ(lost.at_end, 0.25);
  EXPECT_EQ(lost_shares(reference, reference, 0.0).ever, 0.0) << "no farther than 0";
}

}  // namespace
}  // namespace mda
