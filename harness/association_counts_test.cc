#include "harness/association_counts.h"

#include <gtest/gtest.h>

namespace mda::testing {
namespace {

TEST(AssociationCountsTest, TheTruthAgreesWithItself) {
  const TrueAssociation truth({{0, 4, 9}, {1, 5}, {2, 10}});
  const AssociationCounts counts = truth.count({{2, 10}, {0, 4, 9}, {1, 5}});
  EXPECT_EQ(counts.true_tuples, 3);
  EXPECT_EQ(counts.true_pairs, 5);
  EXPECT_EQ(counts.target_exact(), 1.0);
  EXPECT_EQ(counts.pair_precision(), 1.0);
  EXPECT_EQ(counts.pair_recall(), 1.0);
}

/// A triple of which one report is missed, one with a false alarm, one pair that does not exist,
/// and one target that is overlooked.
TEST(AssociationCountsTest, NearlyRightIsNotExact) {
  const TrueAssociation truth({{0, 4, 9}, {1, 5}, {2, 10}, {3, 6}});
  const AssociationCounts counts = truth.count({{0, 9}, {1, 5, 11}, {2, 10}, {7, 8}});
  EXPECT_EQ(counts.answer_tuples, 4);
  EXPECT_EQ(counts.exact_tuples, 1);
  EXPECT_EQ(counts.true_pairs, 6);
  EXPECT_EQ(counts.answer_pairs, 6);
  EXPECT_EQ(counts.right_pairs, 3);
  EXPECT_EQ(counts.target_exact(), 0.25);
  EXPECT_EQ(counts.pair_precision(), 0.5);
  EXPECT_EQ(counts.pair_recall(), 0.5);
}

TEST(AssociationCountsTest, NothingIsNoShare) {
  const TrueAssociation truth({{0, 4}});
  EXPECT_EQ(truth.count({}).target_exact(), 0.0);
  EXPECT_EQ(truth.count({}).pair_precision(), std::nullopt);
  EXPECT_EQ(TrueAssociation().count({{0, 4}}).target_exact(), std::nullopt);
  EXPECT_EQ(TrueAssociation().count({{0, 4}}).pair_precision(), 0.0);
}

}  // namespace
}  // namespace mda::testing
