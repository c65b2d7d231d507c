// The one list of algorithms, and with it that of the codes for flow. A name means one setting for
// ever; a new setting is a new name.
#pragma once

#include <memory>
#include <span>
#include <string_view>

#include "algorithms/api/associator.h"
#include "algorithms/flow/flow_codes.h"  // IWYU pragma: export

namespace mda {

struct CatalogEntry {
  std::string_view name;
  std::string_view family;
  std::string_view summary;  ///< one line for people
  std::string_view source;   ///< paper, section
  std::unique_ptr<Associator> (*make)();
  bool reference = false;  ///< exactly one entry: the default driver and the yardstick of gaps
};

[[nodiscard]] std::span<const CatalogEntry> catalog() noexcept;

/// nullptr when there is no entry of that name.
[[nodiscard]] const CatalogEntry* find_algorithm(std::string_view name) noexcept;

[[nodiscard]] const CatalogEntry& reference_algorithm() noexcept;

/// The choice of the largest product of probabilities (adapters/decided.h), for whoever has
/// marginals and needs a decision.
[[nodiscard]] Solution decided(const AssociationProblem& problem,
                               std::span<const double> marginals);

}  // namespace mda
