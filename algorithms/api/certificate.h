// A proof that a choice of columns is optimal, for a verifier that knows no solver
// (harness/certificate_check).
//
// It is about whole numbers: a cost of c nats counts c 2^bits units, to the nearest, ties to even,
// fine enough that what is at stake counts 2^30 of them: the largest gain of a column, and the
// cheapest columns alone of the exactly-once rows. (Or bits = kFinestBits.) Exactly-once rows are
// charged in advance for their cheapest column alone; then every row is used at most once, and only
// columns below 0 are looked at. Prices are whole numbers of 1/1024 unit.
//
// The steps are a programme that proves, for the columns still alive, that no choice costs less
// than a floor; at first, the claimed cost. With prices y on rows and w on cuts,
//
//     bound = sum_j min(0, c_j + sum_{r in j} y_r + sum_k a_kj w_k) - sum_r y_r - sum_k b_k w_k
//
// holds for every choice. A column dies when the bound with it in the choice reaches the floor;
// what is proven is proven when the bound itself does.
#pragma once

#include <cstdint>
#include <vector>

namespace mda {

struct ProofStep {
  enum class Kind : std::uint8_t {
    /// Prices of rows and cuts: columns die. (Where the bound reaches the floor, all of them.)
    kPrices,
    /// A cut. Of an odd number of rows, columns use half at most: floor(rows of S in j / 2) summed
    /// over the choice is (|S| - 1) / 2 at most. Cuts are numbered from 0 in the order in
    /// which they come, in every part anew.
    kOddRows,
    /// A cut: columns of which any two share a row; at most one is chosen.
    kClique,
    /// The rows fall into parts, and a column belongs to the part of its rows that are listed. Part
    /// by part follows the proof of a floor of its own; the floors add up to the present one.
    kParts,
    /// First the proof that one column uses both rows, or none uses either; then, that no column
    /// uses both. In either case, columns that do otherwise die.
    kRowPair,
    /// First the proof with the column, whose rivals die, then without it.
    kColumn,
    /// The end: the prices just given leave few choices to try, or none, as the bound tells.
    kEnumerate
  };

  Kind kind = Kind::kPrices;
  std::vector<int> rows;             ///< of the window: priced, in S, or the pair
  std::vector<std::int64_t> prices;  ///< one per row, 1/1024 unit, not negative
  std::vector<int> cuts;             ///< priced
  std::vector<std::int64_t> cut_prices;
  std::vector<int> columns;  ///< of the clique, or the one column
  std::vector<std::vector<int>> part_rows;
  std::vector<std::int64_t> part_floors;  ///< units
};

/// Costs as fine as 2^-1000 nats and no finer.
inline constexpr int kFinestBits = 1000;

struct Certificate {
  int bits = 0;
  std::int64_t cost = 0;  ///< of the choice, the solution's x, in units
  std::vector<ProofStep> steps;
};

}  // namespace mda
