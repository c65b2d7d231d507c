#include "harness/closed_loop.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "harness/clocks.h"
#include "harness/set_distance.h"
#include "harness/track_book.h"
#include "harness/track_metrics.h"
#include "harness/tracking_line.h"

namespace mda {
namespace {

/// Sums over the scans of one scene.
struct Distances {
  int scans = 0;
  SetDistance sum;

  void add(const SetDistance& d) {
    ++scans;
    sum.gospa += d.gospa;
    sum.localisation_squared += d.localisation_squared;
    sum.missed_squared += d.missed_squared;
    sum.false_squared += d.false_squared;
    sum.ospa += d.ospa;
  }
  [[nodiscard]] double mean(double total) const { return scans > 0 ? total / scans : 0.0; }
};

/// How one algorithm did on one scene.
struct Outing {
  Distances distances;
  std::vector<RecordedTrack> tracks;  ///< all of them, after the last scan
  TrackMetrics metrics;
  OwnLoopTally tally;
  double cost_nats = 0.0;
  std::optional<double> truth_cost_nats;
};

std::vector<Position> true_positions(const World& world, const Scan& scan) {
  std::vector<Position> positions;
  for (const TruePosition& truth : scan.truth) {
    const Position position{truth.state.x, truth.state.y};
    if (std::hypot(position.x, position.y) <= world.range_km) positions.push_back(position);
  }
  return positions;
}

/// Where the chosen tracks are now, as far as they are confirmed and alive.
std::vector<Position> estimates(const TrackForest& forest, const std::vector<int>& chosen) {
  std::vector<Position> positions;
  for (const int number : chosen) {
    const Leaf& leaf = forest.leaves()[static_cast<std::size_t>(number)];
    if (leaf.misses == kEnded || leaf.plots < kConfirmedPlots) continue;
    const Gaussian state = forest.state_of(leaf);
    positions.push_back({state.mean(0), state.mean(2)});
  }
  return positions;
}

/// One algorithm, one scene.
class ClosedLoop {
 public:
  ClosedLoop(const World& world, const Sweep& sweep, ForestLoop& windows, const Player& player,
             Associator& assignment)
      : world_(world), sweep_(sweep), windows_(windows), player_(player), assignment_(assignment) {}

  /// Nothing if interrupted.
  std::optional<Outing> run(const std::atomic<bool>& interrupted) {
    book_.reset();
    const auto last = static_cast<int>(windows_.scene().scans.size());
    while (windows_.next()) {
      if (interrupted) return std::nullopt;
      const Decision decision = own_turn(windows_, player_, sweep_, outing_.tally);
      const std::vector<int> chosen = windows_.chosen_leaves(decision.x);
      measure(chosen);
      if (windows_.scan() == last) {
        finish(decision.x, chosen);
      } else {
        book_.note(windows_.forest(), chosen);
      }
      windows_.advance(decision);
    }
    return std::move(outing_);
  }

 private:
  void measure(const std::vector<int>& chosen) {
    const Scan& scan = windows_.scene().scans[static_cast<std::size_t>(windows_.scan() - 1)];
    outing_.distances.add(set_distance(true_positions(world_, scan),
                                       estimates(windows_.forest(), chosen), kTrackingCutOffKm,
                                       assignment_));
  }

  void finish(const std::vector<double>& x, const std::vector<int>& chosen) {
    outing_.tracks = book_.close(windows_.forest(), chosen);
    outing_.metrics = track_metrics(world_, windows_.scene(), outing_.tracks);
    outing_.cost_nats = windows_.window().retired_nats + examine(windows_.window().problem, x).cost;
    outing_.truth_cost_nats = windows_.truth_cost();
  }

  const World& world_;
  const Sweep& sweep_;
  ForestLoop& windows_;
  const Player& player_;
  Associator& assignment_;
  TrackBook book_;
  Outing outing_;
};

void write_outing(const Outing& outing, JsonLine& line) {
  const Distances& d = outing.distances;
  const TrackMetrics& m = outing.metrics;
  line.field("scans", d.scans);
  line.field("unanswered", outing.tally.unanswered);
  line.field("gospa_km", d.mean(d.sum.gospa));
  line.field("gospa_localisation_km2", d.mean(d.sum.localisation_squared));
  line.field("gospa_missed_km2", d.mean(d.sum.missed_squared));
  line.field("gospa_false_km2", d.mean(d.sum.false_squared));
  line.field("ospa_km", d.mean(d.sum.ospa));
  line.field("correct_association", m.correct_association);
  line.field("purity", m.purity);
  line.field("completeness", m.completeness);
  line.field("track_breaks", m.track_breaks);
  line.field("swaps", m.swaps);
  line.field("lost", m.lost);
  line.field("present", m.present);
  line.field("tracks", m.tracks);
  line.field("targets", m.targets);
  line.field("cost_nats", outing.cost_nats);
  line.field("truth_cost_nats", outing.truth_cost_nats);
  line.field("wall_ms", outing.tally.wall_ms);
  line.field("cpu_ms", outing.tally.cpu_ms);
}

/// Whether the algorithm declined every window that it did not leave unanswered otherwise: then
/// nothing of it was measured.
bool declined_all(const Outing& outing) {
  return !outing.tally.declined.empty() && outing.tally.unanswered == outing.distances.scans;
}

std::string tracking_line(const Cell& cell, const Sweep& sweep, const Player& player,
                          const std::optional<Outing>& outing, int workers) {
  std::string text;
  JsonLine line(text);
  write_outing_key(cell, sweep, player.entry->name, line);
  const bool ran = outing && !declined_all(*outing);
  OwnLoopTally tally;
  tally.declined = "its answers are no selections";
  write_outing_fate(outing ? outing->tally : tally, ran, workers, line);
  if (ran) write_outing(*outing, line);
  line.end();
  return text;
}

}  // namespace

CellReport run_closed_cell(const Cell& cell, const Sweep& sweep, Worker& worker, int workers,
                           const std::atomic<bool>& interrupted) {
  const Stopwatch watch;
  CellReport report;
  const ScenarioSpec spec = scenario_of(cell);
  const auto assignment = reference_algorithm().make();
  const std::vector<Player>& players = worker.players(sweep, *cell.plan);
  SceneBook& book = worker.scene_book();
  for (const Player& player : players) {
    if (!player.asked) continue;
    std::optional<Outing> outing;
    if (player.solver->traits().answer == Answer::kSelection) {
      ForestLoop& windows = worker.forest();
      windows.start(spec, sweep.seed, cell.replicate, cell.window_k,
                    player.solver->traits().needs_views());
      outing = ClosedLoop(spec.world, sweep, windows, player, *assignment).run(interrupted);
      if (!outing) return {};
      report.tally.windows += outing->distances.scans;
      report.tally.solve_cpu_ms += outing->tally.cpu_ms;
      report.tally.failed += outing->tally.failed ? 1 : 0;
      report.tally.skipped += declined_all(*outing) ? 1 : 0;
      if (!declined_all(*outing)) {
        book.note(player.entry->name, outing->distances.scans, outing->tracks);
      }
    } else {
      ++report.tally.skipped;
    }
    report.tracking += tracking_line(cell, sweep, player, outing, workers);
    ++report.tally.rows;
  }
  if (records_scene(cell)) {
    report.scene = book.line(cell, sweep, simulate(spec, sweep.seed, cell.replicate));
  }
  report.tally.cell_cpu_ms = watch.cpu_ms();
  report.tally.cell_wall_ms = watch.wall_ms();
  report.finished = true;
  return report;
}

}  // namespace mda
