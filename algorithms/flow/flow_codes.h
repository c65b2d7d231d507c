// The one list of codes for minimum-cost flow; algorithms/catalog.h shows it to the harness.
#pragma once

#include <span>
#include <string_view>

#include "algorithms/api/flow.h"

namespace mda {

/// A name means one code with one setting for ever.
struct FlowCode {
  std::string_view name;
  std::string_view summary;  ///< one line for people
  FlowResult (*solve)(const FlowGraph&);
};

[[nodiscard]] std::span<const FlowCode> flow_codes() noexcept;

/// nullptr when there is no code of that name.
[[nodiscard]] const FlowCode* find_flow_code(std::string_view name) noexcept;

}  // namespace mda
