// The windows of a scene whose targets are known from the start, made by KnownTrackWindows.
#pragma once

#include <optional>
#include <vector>

#include "harness/window_loop.h"
#include "scenarios/known/known_windows.h"

namespace mda {

class KnownLoop final : public WindowLoop {
 public:
  /// The windows come with their views in any case: they are made of the tree.
  void start(const ScenarioSpec& spec, std::uint64_t seed, int replicate, int window_k,
             bool views) override;
  bool next() override;
  void advance(const Decision& decision) override;
  [[nodiscard]] int scan() const noexcept override { return windows_->newest_scan(); }
  /// Plots of merged targets belong to several: there is no choice that is the truth.
  [[nodiscard]] std::optional<double> truth_cost() const override { return std::nullopt; }

  /// There after start().
  [[nodiscard]] const KnownTrackWindows& windows() const noexcept { return *windows_; }

  /// The sequence of every track. One that the decision leaves out misses every scan.
  [[nodiscard]] std::vector<Tuple> sequences(const Decision& decision) const;

 private:
  std::optional<KnownTrackWindows> windows_;
  Elapsed decide_;
};

}  // namespace mda
