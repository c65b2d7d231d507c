// Branch and bound by other libraries, as they come: rivals to measure against. Each is built with
// its option only.
#pragma once

#include <memory>

#include "algorithms/api/associator.h"

namespace mda {

// All take the whole window, with the library's default settings and gaps of 0; exponential in the
// worst case. The bound is that of a finished search.

#ifdef MDA_WITH_LPSOLVE
/// By lp_solve 5.5. Source: Storms and Spieksma, section 4 (there lp_solve 1.5).
[[nodiscard]] std::unique_ptr<Associator> make_lpsolve_bb();
#endif

#ifdef MDA_WITH_RIVALS
/// By GLPK: its simplex method, then its integer optimiser.
[[nodiscard]] std::unique_ptr<Associator> make_glpk_bb();

/// By CBC as its command line does it with `-ratio 0 -solve`: preprocessing, heuristics, cuts. One
/// at a time in a process, whatever the thread: that part of CBC keeps state in statics.
[[nodiscard]] std::unique_ptr<Associator> make_cbc_main();
#endif

}  // namespace mda
