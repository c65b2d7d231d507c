#include "harness/tracking_line.h"

#include "harness/row.h"

namespace mda {

void write_outing_key(const Cell& cell, const Sweep& sweep, std::string_view algorithm,
                      JsonLine& line) {
  line.field("schema_version", kSchemaVersion);
  line.field("scenario", cell.plan->spec.name);
  line.field("scan_period_s", cell.scan_period_s);
  line.field("seed", sweep.seed);
  line.field("replicate", cell.replicate);
  line.field("window_k", cell.window_k);
  line.field("algorithm", algorithm);
}

void write_outing_fate(const OwnLoopTally& tally, bool ran, int workers, JsonLine& line) {
  line.field("status", std::string_view(!ran ? "skipped" : tally.failed ? "failed" : "finished"));
  line.field("note", ran && !tally.note.empty() ? tally.note : tally.declined);
  line.field("workers", workers);
}

}  // namespace mda
