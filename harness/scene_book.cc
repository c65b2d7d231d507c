#include "harness/scene_book.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "harness/row.h"

namespace mda {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::string_view kOpen = "open";
constexpr std::string_view kClosed = "closed";

double to_decimetre(double km) { return std::round(km * 1e4) / 1e4; }

Json place(double x_km, double y_km) { return {to_decimetre(x_km), to_decimetre(y_km)}; }

Json plots_of(const Scene& scene) {
  Json scans = Json::array();
  for (const Scan& scan : scene.scans) {
    Json plots = Json::array();
    for (const Plot& plot : scan.plots) {
      Json entry = place(plot.range_km * std::cos(plot.bearing_rad),
                         plot.range_km * std::sin(plot.bearing_rad));
      entry.push_back(plot.source);
      plots.push_back(std::move(entry));
    }
    scans.push_back(std::move(plots));
  }
  return scans;
}

/// A target lives in neighbouring scans.
Json targets_of(const Scene& scene) {
  Json targets = Json::array();
  for (int target = 0; target < scene.targets; ++target) {
    targets.push_back({{"first_scan", 1}, {"positions_km", Json::array()}});
  }
  int number = 0;
  for (const Scan& scan : scene.scans) {
    ++number;
    for (const TruePosition& truth : scan.truth) {
      Json& target = targets[static_cast<std::size_t>(truth.target)];
      Json& positions = target["positions_km"];
      if (positions.empty()) target["first_scan"] = number;
      positions.push_back(place(truth.state.x, truth.state.y));
    }
  }
  return targets;
}

/// By dimension, the row of a window's first plot in that scan; rows stand in their order.
std::vector<int> first_rows(const AssociationProblem& problem) {
  std::vector<int> first;
  for (int row = 0; row < problem.rows(); ++row) {
    const auto dimensions = static_cast<std::size_t>(problem.dimension(row)) + 1;
    if (first.size() < dimensions) first.resize(dimensions, row);
  }
  return first;
}

}  // namespace

bool records_scenes(const ScenarioPlan& plan) {
  const ScenarioSpec& spec = plan.spec;
  return !spec.known_targets && !spec.position_targets && !spec.three_sensors &&
         plan.first_replicate == 1;
}

bool records_scene(const Cell& cell) { return records_scenes(*cell.plan) && cell.replicate == 1; }

void SceneBook::extend(Track& track, const PlotPlace& place) {
  if (track.empty()) track.push_back(place.scan);
  track.resize(static_cast<std::size_t>(place.scan - track.front()) + 1, kNoPlot);
  track.push_back(place.plot);
}

std::vector<SceneBook::Track> SceneBook::tracks_of(const ForestLoop& loop,
                                                   const Solution& solution) {
  const WindowInstance& window = loop.window();
  const AssociationProblem& problem = window.problem;
  const std::vector<int> first_row = first_rows(problem);
  std::vector<Track> tracks;
  const auto add_track = [&](std::span<const int> rows) {
    Track track;
    for (const int row : rows) {
      const int dimension = row == kNoRow ? 0 : problem.dimension(row);
      if (dimension == 0) continue;  // a miss, or the fixed track itself
      extend(track, {loop.forest().fixed_scan() + dimension,
                     row - first_row[static_cast<std::size_t>(dimension)]});
    }
    if (!track.empty()) tracks.push_back(std::move(track));
  };
  for (int j = 0; j < problem.columns(); ++j) {
    const auto column = static_cast<std::size_t>(j);
    if (solution.x[column] > 0.5 && window.leaf_of_column[column] >= 0) {
      add_track(problem.rows_of(j));
    }
  }
  for (const Tuple& tuple : solution.tuples) add_track(tuple.rows);
  return tracks;
}

void SceneBook::note(const ForestLoop& loop, const Verdicts& verdicts) {
  for (const Attempt& attempt : verdicts.attempts) {
    if (!attempt.player->asked || !is_verified_choice(attempt)) continue;
    add(attempt.player->entry->name, loop.scan(), tracks_of(loop, attempt.solution));
  }
}

void SceneBook::note(std::string_view algorithm, int scan,
                     const std::vector<RecordedTrack>& tracks) {
  std::vector<Track> whole;
  for (const RecordedTrack& recorded : tracks) {
    Track track;
    for (const PlotPlace& place : recorded.plots) extend(track, place);
    if (!track.empty()) whole.push_back(std::move(track));
  }
  add(algorithm, scan, whole);
}

void SceneBook::add(std::string_view algorithm, int scan, const std::vector<Track>& tracks) {
  auto answer = std::ranges::find(answers_, algorithm, &Answer::algorithm);
  if (answer == answers_.end()) {
    answers_.push_back({std::string(algorithm), Json::array()});
    answer = std::prev(answers_.end());
  }
  answer->scans.push_back({{"scan", scan}, {"tracks", tracks}});
}

std::string SceneBook::line(const Cell& cell, const Sweep& sweep, const Scene& scene) const {
  const std::string_view loop = cell.plan->closed_loop ? kClosed : kOpen;
  Json answers = Json::array();
  for (const Answer& answer : answers_) {
    answers.push_back({{"algorithm", answer.algorithm},
                       {"window_k", cell.window_k},
                       {"loop", loop},
                       {"scans", answer.scans}});
  }
  const Json line = {{"schema_version", kSchemaVersion},
                     {"scenario", cell.plan->spec.name},
                     {"scan_period_s", cell.scan_period_s},
                     {"seed", sweep.seed},
                     {"replicate", cell.replicate},
                     {"window_k", cell.window_k},
                     {"loop", loop},
                     {"range_km", cell.plan->spec.world.range_km},
                     {"plots", plots_of(scene)},
                     {"targets", targets_of(scene)},
                     {"answers", std::move(answers)}};
  return line.dump() + "\n";
}

}  // namespace mda
