#include "algorithms/catalog.h"

#include <algorithm>
#include <array>

#include "algorithms/exact/branch_and_bound.h"
#include "algorithms/exact/brute_force.h"
#include "algorithms/exact/exact.h"
#include "algorithms/heuristic/greedy.h"
#include "algorithms/relaxation/lp.h"
#include "algorithms/relaxation/lp_grp.h"
#include "algorithms/tree/mht.h"
#include "algorithms/tree/murty_k.h"
#ifdef MDA_WITH_LPSOLVE
#include "algorithms/exact/lpsolve_bb.h"
#endif

namespace mda {
namespace {

constexpr std::array kCatalog = {
    CatalogEntry{.name = "lp",
                 .family = "relaxation",
                 .summary = "LP relaxation by the simplex method: the bound with its certificate",
                 .source = "Storms and Spieksma 2003, section 3.2",
                 .make = make_lp},
    CatalogEntry{.name = "lp-grp",
                 .family = "relaxation",
                 .summary = "LP relaxation, then the greedy rounding procedure where fractional",
                 .source = "Storms and Spieksma 2003, section 3.2",
                 .make = make_lp_grp},
    CatalogEntry{.name = "cbc",
                 .family = "exact",
                 .summary = "branch and bound by COIN-OR CBC on the whole window",
                 .source = "Storms and Spieksma 2003, section 4",
                 .make = make_branch_and_bound},
    CatalogEntry{.name = "exact",
                 .family = "exact",
                 .summary = "LP first, branch and bound only on its fractional components",
                 .source = "Storms and Spieksma 2003, section 3, model (13)",
                 .make = make_exact,
                 .reference = true},
    CatalogEntry{.name = "greedy",
                 .family = "heuristic",
                 .summary = "the best column first, each row once",
                 .source = "none: the usual first idea",
                 .make = make_greedy},
    CatalogEntry{.name = "brute-force",
                 .family = "exact",
                 .summary = "every choice of at most 25 columns",
                 .source = "none: the definition of the problem",
                 .make = make_brute_force},
    CatalogEntry{.name = "murty-k",
                 .family = "tree",
                 .summary = "the 10 best choices, each part of Murty's partition by exact",
                 .source = "Murty 1968; Lawler 1972",
                 .make = [] { return make_murty_k({}, make_exact()); }},
    CatalogEntry{
        .name = "mht",
        .family = "tree",
        .summary = "hypothesis-oriented tracking with clusters and the 100 best hypotheses",
        .source = "Reid 1979; Cox and Hingorani 1996",
        .make = [] { return make_mht({}); }},
    CatalogEntry{.name = "mht-ahead",
                 .family = "tree",
                 .summary = "mht whose ranking counts a share of what the scans to come promise",
                 .source = "Reid 1979; Cox and Hingorani 1996; the ranking is ours",
                 .make = [] { return make_mht({.look_ahead = true}); }},
#ifdef MDA_WITH_LPSOLVE
    CatalogEntry{.name = "lpsolve-bb",
                 .family = "exact",
                 .summary = "branch and bound by lp_solve 5.5 on the whole window",
                 .source = "Storms and Spieksma 2003, section 4",
                 .make = make_lpsolve_bb},
    CatalogEntry{.name = "lpsolve-lp-grp",
                 .family = "relaxation",
                 .summary = "lp-grp with the LP solved by lp_solve 5.5",
                 .source = "Storms and Spieksma 2003, section 3.2",
                 .make = make_lpsolve_lp_grp},
#endif
};

static_assert(std::count_if(kCatalog.begin(), kCatalog.end(),
                            [](const CatalogEntry& entry) { return entry.reference; }) == 1);

}  // namespace

std::span<const CatalogEntry> catalog() noexcept { return kCatalog; }

const CatalogEntry* find_algorithm(std::string_view name) noexcept {
  const auto* entry = std::find_if(kCatalog.begin(), kCatalog.end(),
                                   [&](const CatalogEntry& e) { return e.name == name; });
  return entry == kCatalog.end() ? nullptr : entry;
}

const CatalogEntry& reference_algorithm() noexcept {
  return *std::find_if(kCatalog.begin(), kCatalog.end(),
                       [](const CatalogEntry& entry) { return entry.reference; });
}

}  // namespace mda
