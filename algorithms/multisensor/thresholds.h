// How far apart reports of one target are, in the units of SensorView::distance.
#pragma once

namespace mda {

/// Q: the threshold that loses the share `loss`, in (0, 1), of the true pairs. A pair's distance A
/// is chi-square with 2 degrees of freedom, P(A > q) = exp(-q / 2): Q = 9.21 loses 1 %.
[[nodiscard]] double pair_threshold(double loss);

/// Q3: the same for the cost A13 + A23 of a triple. The two distances share a report, so that their
/// sum is no chi-square of 4 degrees of freedom, but 3/2 of one with 2 and 1/2 of another:
/// P(A13 + A23 > q) = (3 exp(-q / 3) - exp(-q)) / 2. Q3 = 15.03 loses 1 %; Q = 9.21 loses 6.95 %.
[[nodiscard]] double triple_threshold(double loss);

/// P(A13 + A23 > q) of a true triple.
[[nodiscard]] double triple_loss(double q);

}  // namespace mda
