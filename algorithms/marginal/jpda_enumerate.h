// Joint probabilistic data association, event by event.
#pragma once

#include <memory>

#include "algorithms/api/associator.h"

namespace mda {

/// The marginals of `jpda` straight from their definition: every way to give each track of a
/// cluster one of its plots or none, no plot twice, weighed one by one. For tests: exponential in
/// the tracks, so it declines more than 30 columns in one component. Stats::nodes counts the
/// events. Source: Fortmann, Bar-Shalom and Scheffe, "Sonar tracking of multiple targets using
/// joint probabilistic data association", IEEE Journal of Oceanic Engineering 8 (1983).
[[nodiscard]] std::unique_ptr<Associator> make_jpda_enumerate();

}  // namespace mda
