// Writes down what the stages of a solve have proven, in the window's numbers.
#pragma once

#include <span>
#include <vector>

#include "algorithms/api/certificate.h"
#include "algorithms/certified/parts.h"

namespace mda {

class Proof {
 public:
  void prices(const Packing& packing, std::span<const Steps> rows,
              std::span<const Steps> cuts = {});
  void odd_rows(const Packing& packing, std::span<const int> rows);
  void clique(const Packing& packing, std::span<const int> columns);
  /// Returns the step's number, for the floors that come later.
  std::size_t parts(std::span<const Part> parts);
  void floor_of_part(std::size_t step, int part, Steps floor);
  void row_pair(const Packing& packing, int first, int second);
  void column(const Packing& packing, int column);
  /// Ends what is to be proven at present, by trying choices where the prices leave any.
  void enumerate();

  [[nodiscard]] std::vector<ProofStep> steps() && { return std::move(steps_); }

 private:
  ProofStep& add(ProofStep::Kind kind);

  std::vector<ProofStep> steps_;
};

}  // namespace mda
