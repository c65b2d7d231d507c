#include "harness/row.h"

#include "harness/json_line.h"

namespace mda {
namespace {

void write_association(const std::optional<AssociationCounts>& counts, JsonLine& line) {
  const auto field = [&](std::string_view name, auto member) {
    line.field(name, counts ? std::optional((*counts).*member) : std::nullopt);
  };
  const auto share = [&](std::string_view name, auto member) {
    line.field(name, counts ? ((*counts).*member)() : std::nullopt);
  };
  share("target_exact", &AssociationCounts::target_exact);
  share("pair_precision", &AssociationCounts::pair_precision);
  share("pair_recall", &AssociationCounts::pair_recall);
  field("true_tuples", &AssociationCounts::true_tuples);
  field("answer_tuples", &AssociationCounts::answer_tuples);
  field("exact_tuples", &AssociationCounts::exact_tuples);
  field("true_pairs", &AssociationCounts::true_pairs);
  field("answer_pairs", &AssociationCounts::answer_pairs);
  field("right_pairs", &AssociationCounts::right_pairs);
}

}  // namespace

void write_key(const Row& row, JsonLine& line) {
  line.field("schema_version", kSchemaVersion);
  line.field("scenario", row.scenario);
  line.field("scan_period_s", row.scan_period_s);
  line.field("seed", row.seed);
  line.field("replicate", row.replicate);
  line.field("window_k", row.window_k);
  line.field("scan", row.scan);
  line.field("driver", row.driver);
  line.field("algorithm", row.algorithm);
  line.field("fingerprint", row.fingerprint);
}

void write_row(const Row& row, JsonLine& line) {
  write_key(row, line);
  line.field("answer", row.answer);
  line.field("status", row.status);
  line.field("stop", row.stop);
  line.field("cost_nats", row.cost_nats);
  line.field("bound_nats", row.bound_nats);
  line.field("certified_bound_nats", row.certified_bound_nats);
  line.field("reference_cost_nats", row.reference_cost_nats);
  line.field("gap_nats", row.gap_nats);
  line.field("gap_share", row.gap_share);
  line.field("row_violation", row.row_violation);
  line.field("ranked_nats", row.ranked_nats);
  line.field("integral", row.integral);
  line.field("tight", row.tight);
  line.field("fractional", row.fractional);
  line.field("paper_fractional", row.paper_fractional);
  line.field("retired_nats", row.retired_nats);
  line.field("truth_cost_nats", row.truth_cost_nats);
  line.field("rows", row.rows);
  line.field("columns", row.columns);
  line.field("nonzeros", row.nonzeros);
  line.field("dimensions", row.dimensions);
  line.field("components", row.components);
  line.field("largest_component_columns", row.largest_component_columns);
  line.field("ungated_columns", row.ungated_columns);
  line.field("iterations", row.iterations);
  line.field("nodes", row.nodes);
  line.field("off_column_paths", row.off_column_paths);
  line.field("graph_nodes", row.graph_nodes);
  line.field("graph_arcs", row.graph_arcs);
  line.field("wall_ms", row.wall_ms);
  line.field("cpu_ms", row.cpu_ms);
  line.field("translate_ms", row.translate_ms);
  line.field("views_ms", row.views_ms);
  line.field("lp_ms", row.lp_ms);
  line.field("round_ms", row.round_ms);
  line.field("grow_ms", row.grow_ms);
  if (row.of_sensors) write_association(row.association, line);
  line.field("workers", row.workers);
  line.field("note", row.note);
}

void append_row_line(const Row& row, std::string& text) {
  JsonLine line(text);
  write_row(row, line);
  line.end();
}

}  // namespace mda
