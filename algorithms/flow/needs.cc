#include "algorithms/flow/needs.h"

namespace mda {
namespace {

constexpr const char* kNoTree = "it needs the hypothesis tree of the window";

}  // namespace

Verdict needs_tree_of_known_tracks(const Shape& shape) {
  if (!shape.has_tree) return {false, kNoTree};
  if (!shape.known_tracks) return {false, "tracks are born in this window"};
  if (!shape.always_feasible) return {false, "a track of this window cannot miss every scan"};
  return {};
}

Verdict needs_tree_of_free_tracks(const Shape& shape) {
  if (!shape.has_tree) return {false, kNoTree};
  if (shape.has_exactly_once_rows) return {false, "some rows of this window must be used"};
  return {};
}

}  // namespace mda
