// What the scenario viewer shows of a cell: plots and truth of its scene, and what algorithms made
// of it. A line of scenes.jsonl (results/README.md).
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "harness/forest_loop.h"
#include "harness/judge.h"
#include "harness/plan.h"
#include "harness/sweep.h"
#include "harness/track_book.h"

namespace mda {

/// Whether cells of this plan record scenes: those whose targets are born, in their first
/// replicate.
[[nodiscard]] bool records_scenes(const ScenarioPlan& plan);
/// Whether this cell does.
[[nodiscard]] bool records_scene(const Cell& cell);

class SceneBook {
 public:
  void reset() { answers_.clear(); }

  /// Open loop, before the present window is decided: the tracks within it of every player that was
  /// asked and whose answer is a verified choice. O(columns).
  void note(const ForestLoop& loop, const Verdicts& verdicts);

  /// Closed loop, after scan `scan`, the last one: the whole tracks that an algorithm made.
  void note(std::string_view algorithm, int scan, const std::vector<RecordedTrack>& tracks);

  /// The line, with its end; positions to 0.1 m.
  [[nodiscard]] std::string line(const Cell& cell, const Sweep& sweep, const Scene& scene) const;

 private:
  /// A track's first scan, then scan by scan the plot that it takes, kNoPlot for none.
  using Track = std::vector<int>;

  struct Answer {
    std::string algorithm;
    nlohmann::ordered_json scans;
  };

  void add(std::string_view algorithm, int scan, const std::vector<Track>& tracks);
  static void extend(Track& track, const PlotPlace& place);
  static std::vector<Track> tracks_of(const ForestLoop& loop, const Solution& solution);

  std::vector<Answer> answers_;
};

}  // namespace mda
