// The cuts of a proof that is being checked (certificate_check), and the prices they have.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <stdexcept>
#include <vector>

#include "algorithms/api/problem.h"

namespace mda {

/// The proof proves nothing, and why.
struct Refused : std::runtime_error {
  using std::runtime_error::runtime_error;
};

inline void demand(bool holds, const char* what) {
  if (!holds) throw Refused(what);
}

/// Whether two columns share a row. O(rows squared).
[[nodiscard]] bool rivals(const AssociationProblem& problem, int a, int b);

class CertificateCuts {
 public:
  explicit CertificateCuts(const AssociationProblem& problem) : problem_(&problem) {}

  // Numbers of rows and columns must be those of the problem. Throw Refused where that is no cut.
  void add_odd_rows(std::span<const int> rows);
  void add_clique(std::span<const int> columns);

  [[nodiscard]] int count() const { return static_cast<int>(right_hand_side_.size()); }
  /// What a choice uses of every cut at most.
  [[nodiscard]] const std::vector<std::int64_t>& right_hand_side() const {
    return right_hand_side_;
  }
  /// One per cut.
  [[nodiscard]] std::vector<std::int64_t>& prices() { return price_; }
  /// Sum over the cuts of price times what the column uses.
  [[nodiscard]] std::int64_t price_of(int column);

 private:
  void add(std::int64_t right_hand_side);

  const AssociationProblem* problem_;
  std::vector<std::int64_t> right_hand_side_;
  std::vector<std::int64_t> price_;
  std::vector<int> hits_;                     // while a column is priced: of its rows, by cut
  std::vector<std::vector<int>> odd_of_row_;  // numbers of cuts; empty without such cuts
  std::vector<std::vector<int>> cliques_of_column_;
};

}  // namespace mda
