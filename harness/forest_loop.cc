#include "harness/forest_loop.h"

#include <memory>

#include "scenarios/hypotheses/tree_view.h"

namespace mda {

void ForestLoop::start(const ScenarioSpec& spec, std::uint64_t seed, int replicate, int window_k,
                       bool views) {
  const Stopwatch watch;
  scene_ = simulate(spec, seed, replicate);
  simulate_cpu_ms_ = watch.cpu_ms();
  decide_ = {};
  views_ = views;
  forest_.reset(spec.world, spec.model, window_k, views);
  truth_.reset(spec.world, spec.model);
}

bool ForestLoop::next() {
  const auto scan = static_cast<std::size_t>(forest_.newest_scan());
  if (scan == scene_.scans.size()) return false;
  const Stopwatch watch;
  forest_.grow(scene_.scans[scan]);
  window_ = extractor_.extract(forest_);
  grow_ = {watch.wall_ms() + decide_.wall_ms, watch.cpu_ms() + decide_.cpu_ms};
  if (views_) {
    const Stopwatch views_watch;
    auto views = std::make_shared<Views>();
    views->tree = tree_of(forest_, window_);
    window_.problem.attach(std::move(views));
    views_ms_ = views_watch.wall_ms();
    grow_.cpu_ms += views_watch.cpu_ms();
  }
  truth_.add(scene_.scans[scan]);
  return true;
}

std::vector<int> ForestLoop::chosen_leaves(std::span<const double> x) const {
  std::vector<int> leaves;
  for (std::size_t j = 0; j < x.size(); ++j) {
    if (x[j] > 0.5 && window_.leaf_of_column[j] >= 0) leaves.push_back(window_.leaf_of_column[j]);
  }
  return leaves;
}

void ForestLoop::advance(const Decision& decision) {
  const Stopwatch watch;
  forest_.decide(chosen_leaves(decision.x));
  decide_ = {watch.wall_ms(), watch.cpu_ms()};
}

}  // namespace mda
