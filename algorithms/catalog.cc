#include "algorithms/catalog.h"

#include <algorithm>
#include <array>

#include "algorithms/exact/branch_and_bound.h"
#include "algorithms/exact/brute_force.h"
#include "algorithms/exact/exact.h"
#include "algorithms/heuristic/greedy.h"
#include "algorithms/relaxation/lp.h"
#include "algorithms/relaxation/lp_grp.h"
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
    CatalogEntry{.name = "sd-exact",
                 .family = "exact",
                 .summary = "S-D assignment of known tracks, proven optimal",
                 .source = "Battistelli et al. 2008, section II",
                 .make = make_sd_exact},
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
