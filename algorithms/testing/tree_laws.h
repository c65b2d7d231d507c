// The laws that the header of HypothesisTree states.
#pragma once

#include "algorithms/api/problem.h"

namespace mda::testing {

/// Expects all of them, of a problem that has views: the order of the nodes, that every node leads
/// to a column, and that every column is a node of the last layer, uses the rows on its path and
/// costs the sum of the steps on it.
void expect_lawful_tree(const AssociationProblem& problem);

/// Expects that tuple_cost gives every column its own cost, up to `tolerance` nats.
void expect_tuple_cost_of_columns(const AssociationProblem& problem, double tolerance);

}  // namespace mda::testing
