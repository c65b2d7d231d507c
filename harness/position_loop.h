// The windows of one scan over targets seen as positions, made by PositionWindows.
#pragma once

#include <optional>

#include "harness/window_loop.h"
#include "scenarios/cartesian/position_windows.h"

namespace mda {

class PositionLoop final : public WindowLoop {
 public:
  /// `window_k` is 1: check() of a sweep refuses others. The windows come with their views in any
  /// case.
  void start(const ScenarioSpec& spec, std::uint64_t seed, int replicate, int window_k,
             bool views) override;
  bool next() override;
  void advance(const Decision& decision) override;
  /// The same for what every track makes of its scan.
  void advance(std::span<const Belief> beliefs);
  [[nodiscard]] int scan() const noexcept override { return windows_->newest_scan(); }
  /// The past of the tracks costs nothing, so there is no cost of whole tracks.
  [[nodiscard]] std::optional<double> truth_cost() const override { return std::nullopt; }

  /// There after start().
  [[nodiscard]] const PositionWindows& windows() const noexcept { return *windows_; }

 private:
  std::optional<PositionWindows> windows_;
  Elapsed decide_;
};

}  // namespace mda
