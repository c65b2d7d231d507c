// The window of three sensors at one instant: a problem in three dimensions, without tracks.
#pragma once

#include "scenarios/hypotheses/extract.h"
#include "scenarios/spec.h"
#include "scenarios/static3/sensor_scene.h"

namespace mda {

/// Rows: the reports of sensor 1, 2 and 3 in the scene's order (dimensions 1, 2, 3, at most once).
/// Columns: all pairs and triples of negative cost (SensorCosts) of which no two reports are
/// farther apart than the gate; ordered by their rows, a pair before the triples it is in.
/// With RowRule::kEquality rows are exactly-once, and a column of cost 0 for each of them follows.
/// leaf_of_column is empty, retired_nats 0, ungated_columns counts all pairs and triples.
///
/// Time, up to logarithms: O(reports + pairs in the gate + triples of such pairs), by a grid of
/// cells. Throws std::invalid_argument with the sentence of sensor_fault(), and
/// std::runtime_error beyond kMostSensorColumns.
[[nodiscard]] WindowInstance sensor_window(const ScenarioSpec& spec, const SensorScene& scene);

inline constexpr int kMostSensorColumns = 5000000;

/// Attaches the distances of all pairs, gated or not, and the cost of any tuple.
/// O(reports squared) in time and memory.
void attach_sensor_view(const ScenarioSpec& spec, const SensorScene& scene, WindowInstance& window);

/// The true tuples: per target that two sensors at least have seen, the rows of its reports in
/// sensor_window(), ascending.
[[nodiscard]] std::vector<std::vector<int>> true_tuples(const SensorScene& scene);

/// What the true tuples cost as columns, nats.
[[nodiscard]] double true_cost(const ScenarioSpec& spec, const SensorScene& scene);

}  // namespace mda
