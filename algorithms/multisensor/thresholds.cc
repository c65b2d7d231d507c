#include "algorithms/multisensor/thresholds.h"

#include <cmath>

namespace mda {

double pair_threshold(double loss) { return -2.0 * std::log(loss); }

double triple_loss(double q) { return (3.0 * std::exp(-q / 3.0) - std::exp(-q)) / 2.0; }

double triple_threshold(double loss) {
  // The loss lies between that of its slower part, exp(-q / 3), and 3/2 of it.
  double low = -3.0 * std::log(loss);
  double high = low + 3.0 * std::log(1.5);
  for (double middle = (low + high) / 2.0; low < middle && middle < high;
       middle = (low + high) / 2.0) {
    (triple_loss(middle) > loss ? low : high) = middle;
  }
  return high;
}

}  // namespace mda
