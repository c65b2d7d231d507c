#include "algorithms/certified/proof.h"

namespace mda {
namespace {

constexpr std::size_t index(int i) noexcept { return static_cast<std::size_t>(i); }

}  // namespace

ProofStep& Proof::add(ProofStep::Kind kind) {
  steps_.emplace_back().kind = kind;
  return steps_.back();
}

void Proof::prices(const Packing& packing, std::span<const Steps> rows,
                   std::span<const Steps> cuts) {
  ProofStep& step = add(ProofStep::Kind::kPrices);
  step.rows.reserve(rows.size());
  step.prices.reserve(rows.size());
  for (int r = 0; r < packing.rows(); ++r) {
    if (rows[index(r)] == 0) continue;
    step.rows.push_back(packing.row_origin[index(r)]);
    step.prices.push_back(rows[index(r)]);
  }
  for (int k = 0; k < static_cast<int>(cuts.size()); ++k) {
    if (cuts[index(k)] == 0) continue;
    step.cuts.push_back(k);
    step.cut_prices.push_back(cuts[index(k)]);
  }
}

void Proof::odd_rows(const Packing& packing, std::span<const int> rows) {
  ProofStep& step = add(ProofStep::Kind::kOddRows);
  for (const int r : rows) step.rows.push_back(packing.row_origin[index(r)]);
}

void Proof::clique(const Packing& packing, std::span<const int> columns) {
  add(ProofStep::Kind::kClique).columns = origins_of(packing, columns);
}

std::size_t Proof::parts(std::span<const Part> parts) {
  ProofStep& step = add(ProofStep::Kind::kParts);
  for (const Part& part : parts) step.part_rows.push_back(part.packing.row_origin);
  step.part_floors.resize(parts.size());
  return steps_.size() - 1;
}

void Proof::floor_of_part(std::size_t step, int part, Steps floor) {
  steps_[step].part_floors[index(part)] = on_grid(floor) / kGrid;
}

void Proof::row_pair(const Packing& packing, int first, int second) {
  add(ProofStep::Kind::kRowPair).rows = {packing.row_origin[index(first)],
                                         packing.row_origin[index(second)]};
}

void Proof::column(const Packing& packing, int column) {
  add(ProofStep::Kind::kColumn).columns = {packing.origin[index(column)]};
}

void Proof::enumerate() { add(ProofStep::Kind::kEnumerate); }

}  // namespace mda
