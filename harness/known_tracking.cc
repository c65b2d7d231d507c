#include "harness/known_tracking.h"

#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "harness/clocks.h"
#include "harness/known_loop.h"
#include "harness/known_metrics.h"
#include "harness/tracking_line.h"
#include "scenarios/known/references.h"

namespace mda {
namespace {

/// What all algorithms of a cell are compared with.
struct References {
  TrackStates truth;
  TrackStates ideal;
  TrackStates oracle;
};

/// How one algorithm did on one scene.
struct Outing {
  TrackStates states;               ///< filtered along the whole window, scan by scan
  TrackStates lagged;               ///< those that the next window starts from
  std::vector<double> right;        ///< share of right newest decisions, scan by scan
  std::vector<double> right_fixed;  ///< of the decisions that left the window, scan by scan
  OwnLoopTally tally;
  double hypotheses_cpu_ms = 0.0;
};

/// One algorithm, one scene.
class KnownClosedLoop {
 public:
  KnownClosedLoop(const Sweep& sweep, KnownLoop& loop, const Player& player, int window_k)
      : sweep_(sweep), loop_(loop), player_(player), window_k_(window_k) {}

  /// Nothing if interrupted.
  std::optional<Outing> run(const std::atomic<bool>& interrupted) {
    while (loop_.next()) {
      if (interrupted) return std::nullopt;
      const Decision decision = own_turn(loop_, player_, sweep_, outing_.tally);
      if (!outing_.tally.declined.empty()) break;
      const std::vector<Tuple> sequences = loop_.sequences(decision);
      measure(sequences);
      outing_.hypotheses_cpu_ms += loop_.grow_cpu_ms();
      loop_.advance(decision);
      outing_.lagged.push_back(loop_.windows().lagged_estimates());
    }
    return std::move(outing_);
  }

 private:
  void measure(const std::vector<Tuple>& sequences) {
    const KnownTrackWindows& windows = loop_.windows();
    const int newest = windows.window_scans();
    outing_.states.push_back(windows.estimates(sequences));
    outing_.right.push_back(right_share(sequences, newest));
    const bool is_last = windows.newest_scan() == std::ssize(windows.scene().scans);
    int decided = newest == window_k_ ? 1 : 0;
    if (is_last) decided = newest;
    for (int k = 1; k <= decided; ++k) {
      outing_.right_fixed.push_back(right_share(sequences, k));
    }
  }

  /// Over the tracks, of what they take in scan k of the window, 1 being the oldest.
  [[nodiscard]] double right_share(const std::vector<Tuple>& sequences, int k) const {
    const KnownTrackWindows& windows = loop_.windows();
    const int scan = windows.newest_scan() - windows.window_scans() + k;
    const KnownScan& plots = windows.scene().scans[static_cast<std::size_t>(scan - 1)];
    const std::vector<int> taken = windows.decisions(sequences, k);
    std::vector<double> right;
    for (int track = 0; track < std::ssize(taken); ++track) {
      right.push_back(is_right(plots, taken, track) ? 1.0 : 0.0);
    }
    return mean(right);
  }

  const Sweep& sweep_;
  KnownLoop& loop_;
  const Player& player_;
  int window_k_;
  Outing outing_;
};

TrackStates truth_of(const KnownScene& scene) {
  TrackStates truth;
  for (const KnownScan& scan : scene.scans) truth.push_back(scan.truth);
  return truth;
}

/// Metres to the centimetre: more would be digits of the noise.
double metres(double km) { return std::round(km * 1e5) / 1e2; }

std::vector<double> metres(std::vector<double> km) {
  for (double& value : km) value = metres(value);
  return km;
}

/// Mean error of the states that the decisions fixed so far lead to, where there are any.
double lagged_error_km(const Outing& outing, const References& references, int window_k) {
  std::vector<double> errors;
  for (std::size_t t = 0; t < outing.lagged.size(); ++t) {
    const int fixed_scan = static_cast<int>(t) + 2 - window_k;
    if (fixed_scan < 1) continue;
    errors.push_back(mean_distance_km(outing.lagged[t],
                                      references.truth[static_cast<std::size_t>(fixed_scan - 1)]));
  }
  return mean(errors);
}

void write_outing(const Outing& outing, const References& references, int window_k,
                  JsonLine& line) {
  const std::vector<double> error = mean_distances_km(outing.states, references.truth);
  const std::vector<double> ideal = mean_distances_km(references.ideal, references.truth);
  const std::vector<double> oracle = mean_distances_km(references.oracle, references.truth);
  const LostShares lost = lost_shares(outing.states, references.ideal, kLostKm);
  line.field("scans", static_cast<int>(outing.states.size()));
  line.field("targets", static_cast<int>(references.truth.front().size()));
  line.field("unanswered", outing.tally.unanswered);
  line.field("off_column_paths", outing.tally.off_column_paths);
  line.field("position_error_m", metres(mean(error)));
  line.field("position_error_lagged_m", metres(lagged_error_km(outing, references, window_k)));
  line.field("ideal_error_m", metres(mean(ideal)));
  line.field("oracle_error_m", metres(mean(oracle)));
  line.field("distance_error_m", metres(mean(mean_distances_km(outing.states, references.ideal))));
  line.field("distance_error_oracle_m",
             metres(mean(mean_distances_km(outing.states, references.oracle))));
  line.field("lost_ever", lost.ever);
  line.field("lost_at_end", lost.at_end);
  line.field("right_share", mean(outing.right));
  line.field("right_share_fixed", mean(outing.right_fixed));
  line.field("wall_ms", outing.tally.wall_ms);
  line.field("cpu_ms", outing.tally.cpu_ms);
  line.field("hypotheses_cpu_ms", outing.hypotheses_cpu_ms);
  line.field("position_error_series_m", metres(error));
  line.field("ideal_series_m", metres(ideal));
  line.field("oracle_series_m", metres(oracle));
  line.field("right_series", outing.right);
}

std::string known_line(const Cell& cell, const Sweep& sweep, const Player& player,
                       const Outing& outing, const References& references, int workers) {
  std::string text;
  JsonLine line(text);
  const bool ran = outing.tally.declined.empty();
  write_outing_key(cell, sweep, player.entry->name, line);
  write_outing_fate(outing.tally, ran, workers, line);
  if (ran) write_outing(outing, references, cell.window_k, line);
  line.end();
  return text;
}

}  // namespace

CellReport run_known_cell(const Cell& cell, const Sweep& sweep, Worker& worker, int workers,
                          const std::atomic<bool>& interrupted) {
  const Stopwatch watch;
  CellReport report;
  const ScenarioSpec spec = scenario_of(cell);
  KnownLoop& loop = worker.known();
  std::optional<References> references;
  for (const Player& player : worker.players(sweep, *cell.plan)) {
    if (!player.asked) continue;
    loop.start(spec, sweep.seed, cell.replicate, cell.window_k, true);
    if (!references) {
      const KnownScene& scene = loop.windows().scene();
      references = {truth_of(scene), ideal_states(scene, spec), oracle_states(scene, spec)};
    }
    std::optional<Outing> outing = Outing{};
    if (player.solver->traits().answer == Answer::kSelection) {
      outing = KnownClosedLoop(sweep, loop, player, cell.window_k).run(interrupted);
      if (!outing) return {};
    } else {
      outing->tally.declined = "its answers are no selections";
    }
    report.tally.simulate_cpu_ms += loop.simulate_cpu_ms();
    report.tally.windows += std::ssize(outing->states);
    report.tally.solve_cpu_ms += outing->tally.cpu_ms;
    report.tally.hypotheses_cpu_ms += outing->hypotheses_cpu_ms;
    report.tally.failed += outing->tally.failed ? 1 : 0;
    report.tally.skipped += outing->tally.declined.empty() ? 0 : 1;
    report.tracking += known_line(cell, sweep, player, *outing, *references, workers);
    ++report.tally.rows;
  }
  report.tally.cell_cpu_ms = watch.cpu_ms();
  report.tally.cell_wall_ms = watch.wall_ms();
  report.finished = true;
  return report;
}

}  // namespace mda
