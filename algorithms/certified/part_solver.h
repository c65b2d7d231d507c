// A component of a packing: enumeration, the LP, or search, whichever is enough.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "algorithms/api/associator.h"
#include "algorithms/certified/proof.h"

namespace mda {

/// What is known of one part, or of several together.
struct Settlement {
  bool complete = true;  ///< before the deadline
  /// Nobody costs less. If complete: the choice's own cost, or the ceiling without one.
  Steps floor = 0;
  std::optional<std::vector<int>> choice;  ///< columns of the window, cheaper than the ceiling
  Steps cost = 0;                          ///< of the choice
  std::vector<int> pieces;  ///< columns of all parts' choices, where not all have one
};

struct Work {
  std::int64_t nodes = 0;  ///< of the search and of enumerations
  std::int64_t iterations = 0;
};

class PartSolver {
 public:
  PartSolver(const Budget& budget, Proof& proof) : budget_(budget), proof_(proof) {}

  /// The cheapest choice that costs less than `ceiling` of all the parts together, the smallest
  /// part first. What a part may cost is what the ceiling leaves when all others cost their bounds,
  /// so that what has been proven for one part helps the next.
  [[nodiscard]] Settlement settle(std::vector<Part>& parts, Steps ceiling);

  [[nodiscard]] const Work& work() const noexcept { return work_; }
  /// Rows of the window, and their prices, in parts whose LP was solved or begun: a bound of the
  /// whole, with the ascent's for the other rows, as far as the columns that died allow.
  [[nodiscard]] const std::vector<std::pair<int, Steps>>& lp_prices() const { return lp_prices_; }

 private:
  /// How far the part has come: prices of the ascent, or of its LP.
  enum class Stage : std::uint8_t { kAscent, kLp };

  [[nodiscard]] Settlement settle(std::vector<Part>& parts, Steps ceiling, Stage stage);
  [[nodiscard]] Settlement settle(Part& part, Steps ceiling, Stage stage);
  [[nodiscard]] Settlement by_bound(Part& part, Steps ceiling);
  [[nodiscard]] std::optional<Settlement> try_all(const Part& part, Steps ceiling, Stage stage);
  [[nodiscard]] Settlement by_lp(Part& part, Steps ceiling);
  [[nodiscard]] Settlement by_search(const Part& part, Steps ceiling);

  const Budget& budget_;
  Proof& proof_;
  Work work_;
  std::vector<std::pair<int, Steps>> lp_prices_;
};

}  // namespace mda
