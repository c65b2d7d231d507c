// One line of rows.jsonl: one algorithm on one window. results/README.md describes the fields.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "harness/association_counts.h"

namespace mda {

/// Fields without a value are written as null; so is anything that is not a finite number.
struct Row {
  // What was solved.
  std::string_view scenario;
  std::string_view driver;
  std::string fingerprint;
  std::uint64_t seed = 0;
  double scan_period_s = 0.0;
  int replicate = 0;
  int window_k = 0;
  int scan = 0;
  int rows = 0;
  int columns = 0;
  int nonzeros = 0;
  int dimensions = 0;
  int components = 0;
  int largest_component_columns = 0;
  double ungated_columns = 0.0;
  double grow_ms = 0.0;
  double retired_nats = 0.0;
  std::optional<double> truth_cost_nats;
  std::optional<double> reference_cost_nats;

  // Who solved it, and how it went.
  std::string_view algorithm;
  std::string_view answer;
  std::string_view status;
  std::string_view stop;
  std::string note;
  std::optional<double> wall_ms;
  std::optional<double> cpu_ms;
  std::optional<double> translate_ms;
  std::optional<double> views_ms;
  std::optional<double> lp_ms;
  std::optional<double> round_ms;
  std::optional<std::int64_t> iterations;
  std::optional<std::int64_t> nodes;
  std::optional<int> off_column_paths;
  std::optional<int> graph_nodes;
  std::optional<int> graph_arcs;

  // What the referee says.
  std::optional<double> cost_nats;
  std::optional<double> bound_nats;
  std::optional<double> certified_bound_nats;
  std::optional<double> gap_nats;
  std::optional<double> gap_share;
  std::optional<double> row_violation;
  std::optional<std::vector<double>> ranked_nats;
  std::optional<int> fractional;
  std::optional<int> paper_fractional;
  std::optional<bool> integral;
  std::optional<bool> tight;
  int workers = 1;

  // What the truth says of a choice; only written for windows of sensors.
  bool of_sensors = false;
  std::optional<AssociationCounts> association;
};

inline constexpr int kSchemaVersion = 1;

class JsonLine;

/// The fields that name a row, in every file of a run.
void write_key(const Row& row, JsonLine& line);

/// All fields of a line of rows.jsonl.
void write_row(const Row& row, JsonLine& line);

/// A line of rows.jsonl: one JSON object and a line end. Doubles survive unchanged.
void append_row_line(const Row& row, std::string& text);

}  // namespace mda
