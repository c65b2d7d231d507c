// Costs of sequences as the paper writes them, by a filter of its own: an independent check.
#pragma once

#include <functional>

#include "algorithms/api/views.h"
#include "scenarios/known/known_windows.h"
#include "scenarios/spec.h"

namespace mda::testing {

/// Visits, with its cost, every sequence of the window of which each plot lies in the gate of what
/// came before it. Only for windows before the first decision, which start from the given
/// estimates. The filter is written in the information form; no plot is left out for its range.
void every_gated_sequence(const ScenarioSpec& spec, const KnownTrackWindows& windows,
                          const std::function<void(const Tuple&, double)>& visit);

}  // namespace mda::testing
