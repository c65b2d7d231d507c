#include "harness/position_loop.h"

#include <vector>

namespace mda {

void PositionLoop::start(const ScenarioSpec& spec, std::uint64_t seed, int replicate,
                         int /*window_k*/, bool /*views*/) {
  const Stopwatch watch;
  windows_.emplace(spec, seed, replicate);
  simulate_cpu_ms_ = watch.cpu_ms();
  decide_ = {};
}

bool PositionLoop::next() {
  const Stopwatch watch;
  if (!windows_->next()) return false;
  window_ = windows_->window();
  grow_ = {watch.wall_ms() + decide_.wall_ms, watch.cpu_ms() + decide_.cpu_ms};
  return true;
}

void PositionLoop::advance(const Decision& decision) {
  std::vector<Belief> beliefs = windows_->beliefs_of(decision.x);
  for (const Tuple& tuple : decision.tuples) {
    const int row = tuple.rows.front();
    const int first_plot = window_.problem.views()->pairs->tracks();
    const auto target = static_cast<std::size_t>(windows_->target_of_row(tuple.track));
    if (row != kNoRow) beliefs[target].items.push_back({row - first_plot, 1.0});
  }
  advance(beliefs);
}

void PositionLoop::advance(std::span<const Belief> beliefs) {
  const Stopwatch watch;
  windows_->advance(beliefs);
  decide_ = {watch.wall_ms(), watch.cpu_ms()};
}

}  // namespace mda
