#include "algorithms/flow/flow_codes.h"

#include <algorithm>
#include <array>

#include "algorithms/backends/assignment_flow.h"
#include "algorithms/backends/clp_flow.h"
#include "algorithms/backends/lemon_flow.h"

namespace mda {
namespace {

constexpr std::array kFlowCodes = {
    FlowCode{.name = "scf-networksimplex",
             .summary = "network simplex of LEMON",
             .solve = network_simplex_flow},
    FlowCode{.name = "scf-capacityscaling",
             .summary = "capacity scaling of LEMON: successive shortest paths at capacities of 1",
             .solve = capacity_scaling_flow},
    FlowCode{.name = "scf-costscaling",
             .summary = "cost scaling of LEMON: push-relabel",
             .solve = cost_scaling_flow},
    FlowCode{.name = "scf-lp",
             .summary = "the flow as a linear programme, by the dual simplex of Clp",
             .solve = clp_flow},
    FlowCode{.name = "scf-assignment",
             .summary = "disjoint paths as a one-sided assignment: price war, exact repair",
             .solve = assignment_flow},
};

}  // namespace

std::span<const FlowCode> flow_codes() noexcept { return kFlowCodes; }

const FlowCode* find_flow_code(std::string_view name) noexcept {
  const auto* code = std::find_if(kFlowCodes.begin(), kFlowCodes.end(),
                                  [&](const FlowCode& c) { return c.name == name; });
  return code == kFlowCodes.end() ? nullptr : code;
}

}  // namespace mda
