// Assignment in S dimensions by Lagrangian relaxation to two.
#pragma once

#include <memory>

#include "algorithms/api/associator.h"
#include "algorithms/relaxation/subgradient.h"

namespace mda {

/// Component by component, keeps the rows of the first two dimensions and relaxes those of all
/// others: for fixed multipliers that leaves a two-dimensional assignment, whose value is a lower
/// bound. Subgradient steps raise the bound; after each one a choice is recovered by placing the
/// dimensions one after the other, again by two-dimensional assignments. Claims an optimum when the
/// best cost meets the best bound. The multipliers it hands over are those of the relaxed rows and
/// the dual prices of the others. Any always feasible problem with any number of dimensions will
/// do, and dense axial ones, whose choices can always be completed; at most two dimensions need no
/// relaxation at all.
///
/// The problem is brought into its normal form first (normal_form.h), so that neither its order nor
/// the unit of cost matters. O(iterations * (nonzeros + dimensions * assignment)).
///
/// Source: Deb, Yeddanapudi, Pattipati and Bar-Shalom, "A generalized S-D assignment algorithm for
/// multisensor-multitarget state estimation" (1997); Poore and Rijavec, "A Lagrangian relaxation
/// algorithm for multidimensional assignment problems arising from multitarget tracking" (1993).
[[nodiscard]] std::unique_ptr<Associator> make_lagrangian_sd(const SubgradientOptions& options);

/// With the default options.
[[nodiscard]] std::unique_ptr<Associator> make_lagrangian_sd();

}  // namespace mda
