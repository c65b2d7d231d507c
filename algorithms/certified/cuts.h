// Inequalities that all choices keep and a fractional point of the LP breaks.
#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "algorithms/certified/packing.h"

namespace mda {

/// sum_j a_j x_j <= right_hand_side.
struct Cut {
  enum class Kind : std::uint8_t {
    kOddRows,  ///< a_j = floor(rows of S in j / 2), right-hand side (|S| - 1) / 2, |S| odd
    kClique    ///< a_j = 1 for columns of which any two share a row, right-hand side 1
  };
  Kind kind = Kind::kOddRows;
  std::vector<int> rows;                     ///< S; of a clique: empty
  std::vector<std::pair<int, int>> columns;  ///< and their coefficients, above 0
  int right_hand_side = 1;
};

/// The fractional part of an LP optimum.
using FractionalPoint = std::vector<std::pair<int, double>>;

/// Zero-half cuts of a packing: half the sum of the rows of S, rounded down. Such a cut is broken
/// by (1 - w(S)) / 2, where w(S) adds up the slacks of the rows and the values of columns that use
/// an odd number of them. From every row that fractional columns use, S grows by the pair of rows
/// that makes w(S) least, to 11 rows; of three rows all S are looked at that hang together by
/// fractional columns. At most `most` cuts, the most broken first. Columns that are not `alive` are
/// left out.
///
/// Source: Caprara and Fischetti 1996; the search is ours.
[[nodiscard]] std::vector<Cut> odd_row_cuts(const Packing& packing, std::span<const char> alive,
                                            const FractionalPoint& x, int most);

/// Cliques of the conflict graph, grown greedily from every fractional column, then lifted by alive
/// columns that share a row with each member, those of least `reduced` cost first. At most `most`
/// cuts of at most 64 members.
[[nodiscard]] std::vector<Cut> clique_cuts(const Packing& packing, std::span<const char> alive,
                                           std::span<const Steps> reduced, const FractionalPoint& x,
                                           int most);

}  // namespace mda
