// Verifies certificates (algorithms/api/certificate.h). It knows no solver: all it does with the
// proof is to add up whole numbers, in 128 bits.
#pragma once

#include <span>
#include <string>

#include "algorithms/api/certificate.h"
#include "algorithms/api/problem.h"

namespace mda {

/// Why the certificate does not prove that `columns` are an optimal choice, in costs rounded to
/// 2^-bits nats; an empty text if it does. Takes always feasible problems only. About O(nonzeros)
/// per step; choices that are to be enumerated must be few.
[[nodiscard]] std::string certificate_fault(const AssociationProblem& problem,
                                            std::span<const int> columns,
                                            const Certificate& certificate);

}  // namespace mda
