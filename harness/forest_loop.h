// The windows of a scene whose targets appear and vanish, made by a TrackForest.
#pragma once

#include <span>
#include <vector>

#include "harness/window_loop.h"
#include "scenarios/hypotheses/track_forest.h"
#include "scenarios/hypotheses/truth_cost.h"
#include "scenarios/world/simulate.h"

namespace mda {

class ForestLoop final : public WindowLoop {
 public:
  void start(const ScenarioSpec& spec, std::uint64_t seed, int replicate, int window_k,
             bool views) override;
  bool next() override;
  /// Sequences beside the columns have no leaf: those tracks end as false alarms.
  void advance(const Decision& decision) override;
  [[nodiscard]] int scan() const noexcept override { return forest_.newest_scan(); }
  [[nodiscard]] std::optional<double> truth_cost() const override { return truth_.cost(); }

  [[nodiscard]] const Scene& scene() const noexcept { return scene_; }
  [[nodiscard]] const TrackForest& forest() const noexcept { return forest_; }

  /// The leaves that the answer `x` to window() chooses.
  [[nodiscard]] std::vector<int> chosen_leaves(std::span<const double> x) const;

 private:
  Scene scene_;
  TrackForest forest_;
  TruthCost truth_;
  WindowExtractor extractor_;
  Elapsed decide_;
  bool views_ = false;
};

}  // namespace mda
