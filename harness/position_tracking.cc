#include "harness/position_tracking.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "harness/clocks.h"
#include "harness/position_metrics.h"
#include "harness/scan_values.h"
#include "harness/tracking_line.h"
#include "harness/words.h"
#include "scenarios/cartesian/trajectories.h"

namespace mda {
namespace {

/// How one algorithm did on one scene.
struct Outing {
  TrackSet set;
  std::vector<StateSeries> predicted;  ///< [target]
  int scans = 0;
  int conflicts = 0;  ///< scans in which two tracks hold the same plot for the likeliest
  std::optional<std::int64_t> iterations;
  OwnLoopTally tally;
  bool broke_down = false;
  double hypotheses_cpu_ms = 0.0;
};

/// One algorithm, or the truth, on one scene.
class PositionClosedLoop {
 public:
  /// `player`: nullptr for the truth.
  PositionClosedLoop(const Sweep& sweep, const ScenarioSpec& spec, PositionLoop& loop,
                     const Player* player)
      : sweep_(sweep), spec_(spec), loop_(loop), player_(player) {
    const auto targets = static_cast<std::size_t>(loop.windows().targets());
    outing_.set.tracks.resize(targets);
    outing_.set.targets.resize(targets);
    outing_.set.dropped.assign(targets, false);
    outing_.predicted.resize(targets);
  }

  /// Nothing if interrupted.
  std::optional<Outing> run(const std::atomic<bool>& interrupted) {
    try {
      while (loop_.next()) {
        if (interrupted) return std::nullopt;
        const std::vector<Belief> beliefs = own_beliefs();
        if (!outing_.tally.declined.empty()) break;
        loop_.advance(beliefs);
        outing_.hypotheses_cpu_ms += loop_.grow_cpu_ms();
        note();
      }
    } catch (const std::exception& error) {
      outing_.tally.failed = true;
      outing_.broke_down = true;
      outing_.tally.note = fmt::format("scan {}: {}", loop_.scan(), error.what());
    }
    return std::move(outing_);
  }

 private:
  std::vector<Belief> own_beliefs() {
    const PositionWindows& windows = loop_.windows();
    if (player_ == nullptr) return windows.true_beliefs();
    const AssociationProblem& problem = loop_.window().problem;
    const Verdicts verdicts = own_verdicts(loop_, *player_, sweep_, outing_.tally);
    const Attempt& attempt = verdicts.attempts.front();
    const Solution& solution = attempt.solution;
    if (const auto iterations = solution.stats.iterations) {
      outing_.iterations = outing_.iterations.value_or(0) + *iterations;
    }
    if (attempt.skipped || attempt.refuted || !attempt.examined.well_formed) {
      ++outing_.tally.unanswered;
      return std::vector<Belief>(outing_.set.tracks.size());
    }
    if (are_in_conflict(problem, largest_by_track(problem, solution.x))) ++outing_.conflicts;
    return windows.beliefs_of(values_to_follow(problem, solution, spec_.model.update));
  }

  /// What has become of the tracks in the newest scan.
  void note() {
    const PositionWindows& windows = loop_.windows();
    ++outing_.scans;
    for (std::size_t i = 0; i < outing_.predicted.size(); ++i) {
      outing_.predicted[i].push_back(state_of(windows.predicted()[i]));
      outing_.set.tracks[i].push_back(state_of(windows.estimates()[i]));
      outing_.set.targets[i].push_back(windows.scan().truth[i]);
      outing_.set.dropped[i] = windows.is_dropped(static_cast<int>(i));
    }
  }

  const Sweep& sweep_;
  const ScenarioSpec& spec_;
  PositionLoop& loop_;
  const Player* player_;
  Outing outing_;
};

/// To 0.1 m and 0.1 m/s: more would be digits of the noise.
double rounded(double km) { return std::round(km * 1e4) / 1e4; }

std::vector<double> rounded(std::vector<double> km) {
  for (double& value : km) value = rounded(value);
  return km;
}

std::vector<std::vector<double>> places(const StateSeries& series) {
  std::vector<std::vector<double>> result;
  for (const TargetState& state : series) result.push_back({rounded(state.x), rounded(state.y)});
  return result;
}

/// A list with one entry per target.
template <typename Entry>
void per_target(JsonLine& line, std::string_view name, const std::vector<TrackErrors>& errors,
                Entry entry) {
  std::vector<decltype(entry(errors.front(), 0))> list;
  for (std::size_t i = 0; i < errors.size(); ++i) list.push_back(entry(errors[i], i));
  line.field(name, list);
}

void write_errors(const Outing& outing, JsonLine& line) {
  const TrackSet& set = outing.set;
  std::vector<TrackErrors> errors;
  for (std::size_t i = 0; i < set.tracks.size(); ++i) {
    errors.push_back(track_errors(set.tracks[i], outing.predicted[i], set.targets[i]));
  }
  const auto kept = [&](double loss_km) {
    return [&, loss_km](const TrackErrors& e, std::size_t i) {
      return !set.dropped[i] && is_maintained(e.position_km, loss_km);
    };
  };
  const auto squares = [](std::vector<double> TrackErrors::*series) {
    return [series](const TrackErrors& e, std::size_t) { return sum_of_squares(e.*series); };
  };
  const auto series = [](std::vector<double> TrackErrors::*values) {
    return [values](const TrackErrors& e, std::size_t) { return rounded(e.*values); };
  };
  per_target(line, "maintained_450m", errors, kept(kStrictLossKm));
  per_target(line, "maintained_750m", errors, kept(kWideLossKm));
  per_target(line, "position_squares_km2", errors, squares(&TrackErrors::position_km));
  per_target(line, "velocity_squares_km2_s2", errors, squares(&TrackErrors::velocity_km_s));
  per_target(line, "predicted_position_squares_km2", errors,
             squares(&TrackErrors::predicted_position_km));
  per_target(line, "predicted_velocity_squares_km2_s2", errors,
             squares(&TrackErrors::predicted_velocity_km_s));
  per_target(line, "position_error_series_km", errors, series(&TrackErrors::position_km));
  per_target(line, "velocity_error_series_km_s", errors, series(&TrackErrors::velocity_km_s));
  per_target(line, "track_series_km", errors,
             [&](const TrackErrors&, std::size_t i) { return places(set.tracks[i]); });
}

void write_outing(const Outing& outing, const PositionTargets& targets, JsonLine& line) {
  const double scans = std::max(1, outing.scans);
  std::optional<double> iterations;
  if (outing.iterations) iterations = static_cast<double>(*outing.iterations) / scans;
  line.field("scans", outing.scans);
  line.field("targets", target_numbers(targets.scene));
  line.field("unanswered", outing.tally.unanswered);
  line.field("dropped", outing.set.dropped);
  line.field("swaps", swaps(outing.set));
  line.field("coalescences", coalescences(outing.set, targets.plot_sigma_km));
  line.field("conflict_rate", outing.conflicts / scans);
  line.field("iterations_per_scan", iterations);
  line.field("wall_ms", outing.tally.wall_ms);
  line.field("cpu_ms", outing.tally.cpu_ms);
  line.field("hypotheses_cpu_ms", outing.hypotheses_cpu_ms);
  write_errors(outing, line);
}

std::string position_line(const Cell& cell, const Sweep& sweep, std::string_view algorithm,
                          const Outing& outing, int workers) {
  std::string text;
  JsonLine line(text);
  const ScenarioSpec& spec = cell.plan->spec;
  const bool ran = outing.tally.declined.empty();
  write_outing_key(cell, sweep, algorithm, line);
  line.field("update", word_of(kTrackUpdateWords, spec.model.update));
  write_outing_fate(outing.tally, ran, workers, line);
  if (ran && !outing.broke_down) write_outing(outing, *spec.position_targets, line);
  line.end();
  return text;
}

void count(const Outing& outing, const PositionLoop& loop, Tally& tally) {
  tally.simulate_cpu_ms += loop.simulate_cpu_ms();
  tally.windows += outing.scans;
  tally.solve_cpu_ms += outing.tally.cpu_ms;
  tally.hypotheses_cpu_ms += outing.hypotheses_cpu_ms;
  tally.failed += outing.tally.failed ? 1 : 0;
  tally.skipped += outing.tally.declined.empty() ? 0 : 1;
  ++tally.rows;
}

}  // namespace

CellReport run_position_cell(const Cell& cell, const Sweep& sweep, Worker& worker, int workers,
                             const std::atomic<bool>& interrupted) {
  const Stopwatch watch;
  CellReport report;
  const ScenarioSpec spec = scenario_of(cell);
  PositionLoop& loop = worker.positions();
  std::vector<const Player*> players = {nullptr};
  for (const Player& player : worker.players(sweep, *cell.plan)) {
    if (player.asked) players.push_back(&player);
  }
  for (const Player* player : players) {
    loop.start(spec, sweep.seed, cell.replicate, cell.window_k, true);
    const auto outing = PositionClosedLoop(sweep, spec, loop, player).run(interrupted);
    if (!outing) return {};
    count(*outing, loop, report.tally);
    report.tracking += position_line(cell, sweep, player == nullptr ? kOracle : player->entry->name,
                                     *outing, workers);
  }
  report.tally.cell_cpu_ms = watch.cpu_ms();
  report.tally.cell_wall_ms = watch.wall_ms();
  report.finished = true;
  return report;
}

}  // namespace mda
