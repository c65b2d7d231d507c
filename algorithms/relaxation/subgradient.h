// The Lagrangian dual of one component by subgradient steps, with choices made on the way.
#pragma once

#include <vector>

#include "algorithms/api/associator.h"
#include "algorithms/relaxation/normal_form.h"

namespace mda {

struct SubgradientOptions {
  int iterations = 200;      ///< at most, at least 1
  double step = 1.0;         ///< share of the Polyak step to the best known cost, at first
  int patience = 8;          ///< iterations without a better bound until the share is halved
  double least_step = 1e-3;  ///< share at which it gives up
};

/// In the component's unit of cost.
struct SubgradientResult {
  double cost = 0.0;               ///< of the best choice found
  std::vector<int> columns;        ///< of it
  double bound = 0.0;              ///< the best
  std::vector<double> multiplier;  ///< per row, proves the bound
  bool closed = false;             ///< cost and bound agree: the choice is optimal
  bool expired = false;            ///< the deadline came first
  int iterations = 0;
};

/// Maximises L(u) over the multipliers of all levels but the first two. Deflected steps after
/// Camerini, Fratta and Maffioli, "On improving relaxation methods by modified gradient
/// techniques" (1975). Every step gives a choice too: StagedAssignment::recover(), filled up with
/// what still has free rows. After the deadline it ends with the iteration it is in.
[[nodiscard]] SubgradientResult maximise_dual(const NormalComponent& component,
                                              const SubgradientOptions& options,
                                              const Budget& budget);

}  // namespace mda
