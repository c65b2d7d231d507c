#include "harness/window_loop.h"

namespace mda {

void WindowLoop::start(const ScenarioSpec& spec, std::uint64_t seed, int replicate, int window_k) {
  const Stopwatch watch;
  scene_ = simulate(spec, seed, replicate);
  simulate_cpu_ms_ = watch.cpu_ms();
  decide_ = {};
  forest_.reset(spec.world, spec.model, window_k);
  truth_.reset(spec.world, spec.model);
}

bool WindowLoop::next() {
  const auto scan = static_cast<std::size_t>(forest_.newest_scan());
  if (scan == scene_.scans.size()) return false;
  const Stopwatch watch;
  forest_.grow(scene_.scans[scan]);
  window_ = extractor_.extract(forest_);
  grow_ = {watch.wall_ms() + decide_.wall_ms, watch.cpu_ms() + decide_.cpu_ms};
  truth_.add(scene_.scans[scan]);
  return true;
}

std::vector<int> WindowLoop::chosen_leaves(std::span<const double> x) const {
  std::vector<int> leaves;
  for (std::size_t j = 0; j < x.size(); ++j) {
    if (x[j] > 0.5 && window_.leaf_of_column[j] >= 0) leaves.push_back(window_.leaf_of_column[j]);
  }
  return leaves;
}

void WindowLoop::advance(std::span<const double> x) {
  const Stopwatch watch;
  forest_.decide(chosen_leaves(x));
  decide_ = {watch.wall_ms(), watch.cpu_ms()};
}

}  // namespace mda
