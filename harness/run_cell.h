// The main flow: one forest, all its windows, every algorithm on each.
#pragma once

#include <atomic>
#include <map>
#include <string>
#include <vector>

#include "harness/forest_loop.h"
#include "harness/judge.h"
#include "harness/known_loop.h"
#include "harness/plan.h"
#include "harness/position_loop.h"
#include "harness/scene_book.h"
#include "harness/sensor_loop.h"
#include "harness/sweep.h"

namespace mda {

/// Counts and times of one cell, or of many added up.
struct Tally {
  std::int64_t windows = 0;
  std::int64_t rows = 0;
  std::int64_t failed = 0;            ///< rows that failed by themselves
  std::int64_t refuted = 0;           ///< rows whose claim the referee refuted
  std::int64_t skipped = 0;           ///< rows whose algorithm declined
  std::int64_t timed_out = 0;         ///< rows that stopped at their time limit
  std::int64_t fallbacks = 0;         ///< windows that somebody else than the driver had to advance
  std::int64_t compared = 0;          ///< windows that two or more exact algorithms finished
  double largest_exact_spread = 0.0;  ///< nats, over those
  std::string worst_example;          ///< the first refuted or failed row, for people
  // CPU time of the workers, milliseconds.
  double simulate_cpu_ms = 0.0;
  double hypotheses_cpu_ms = 0.0;
  double solve_cpu_ms = 0.0;
  double cell_cpu_ms = 0.0;
  double cell_wall_ms = 0.0;  ///< wall clock

  void add(const Tally& other);
};

/// What a cell leaves behind: lines for the files of the run, complete or not at all.
struct CellReport {
  bool finished = false;  ///< false: interrupted, nothing to be written
  std::string rows;
  std::string answers;
  std::string tracking;  ///< lines of tracking.jsonl, of a closed-loop cell
  std::string scene;     ///< the line of scenes.jsonl, of a cell that records its scene
  Tally tally;
};

/// The plan's algorithms, and the driver and the reference if they are not among them.
[[nodiscard]] std::vector<Player> make_players(const Sweep& sweep, const ScenarioPlan& plan);

/// Whether one of them needs the windows' views.
[[nodiscard]] bool need_views(const std::vector<Player>& players);

/// What one worker keeps from cell to cell.
class Worker {
 public:
  /// Those of make_players().
  [[nodiscard]] std::vector<Player>& players(const Sweep& sweep, const ScenarioPlan& plan);
  /// The driver alone, its rows not asked for: for windows that are there to be passed.
  [[nodiscard]] std::vector<Player>& driver(const Sweep& sweep);
  /// Makes this scenario's windows.
  [[nodiscard]] WindowLoop& windows(const ScenarioSpec& spec);
  [[nodiscard]] ForestLoop& forest() { return forest_; }
  [[nodiscard]] KnownLoop& known() { return known_; }
  [[nodiscard]] PositionLoop& positions() { return positions_; }
  /// Emptied by every call.
  [[nodiscard]] SceneBook& scene_book();

 private:
  std::map<const ScenarioPlan*, std::vector<Player>> players_;
  std::vector<Player> driver_;
  ForestLoop forest_;
  KnownLoop known_;
  PositionLoop positions_;
  SensorLoop sensors_;
  SceneBook scene_book_;
};

/// Runs a cell; gives up between two windows once `interrupted` is set. `workers` is for the rows.
[[nodiscard]] CellReport run_cell(const Cell& cell, const Sweep& sweep, Worker& worker, int workers,
                                  const std::atomic<bool>& interrupted);

}  // namespace mda
