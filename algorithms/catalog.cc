#include "algorithms/catalog.h"

#include <algorithm>
#include <array>
#include <utility>

#include "algorithms/adapters/decided.h"
#include "algorithms/adapters/scan_by_scan.h"
#include "algorithms/certified/cg_lp.h"
#include "algorithms/certified/dual_ascent.h"
#include "algorithms/certified/tree_exact.h"
#include "algorithms/exact/branch_and_bound.h"
#include "algorithms/exact/brute_force.h"
#include "algorithms/exact/exact.h"
#include "algorithms/flow/mcf.h"
#include "algorithms/flow/scf.h"
#include "algorithms/flow/scf_pairs.h"
#include "algorithms/flow/viterbi_sequential.h"
#include "algorithms/heuristic/greedy.h"
#include "algorithms/marginal/hnpda.h"
#include "algorithms/marginal/jpda.h"
#include "algorithms/marginal/jpda_cheap.h"
#include "algorithms/marginal/jpda_enumerate.h"
#include "algorithms/marginal/lbp.h"
#include "algorithms/marginal/pda.h"
#include "algorithms/multisensor/bojilov.h"
#include "algorithms/relaxation/first_order.h"
#include "algorithms/relaxation/lagrangian_sd.h"
#include "algorithms/relaxation/lp.h"
#include "algorithms/relaxation/lp_grp.h"
#include "algorithms/single_scan/gnn.h"
#include "algorithms/single_scan/mapada.h"
#include "algorithms/single_scan/mapada_miss.h"
#include "algorithms/single_scan/nn.h"
#include "algorithms/tree/mht.h"
#include "algorithms/tree/murty_k.h"
#if defined(MDA_WITH_LPSOLVE) || defined(MDA_WITH_RIVALS)
#include "algorithms/exact/library_search.h"
#endif

namespace mda {
namespace {

constexpr std::string_view kDualAscent =
    "after Haller and Savchynskyy 2024; the trees and the working set are ours";
constexpr std::string_view kColumnGeneration =
    "after Wang, Wolf, Fowlkes and Yarkony 2017; explicit trees";
constexpr std::string_view kTreeExact = "ours, of published parts: algorithms/README.md names them";
constexpr std::string_view kScfTie = "Battistelli et al. 2008, section III; the tie rule is ours";
constexpr std::string_view kJpda =
    "Fortmann, Bar-Shalom and Scheffe 1983; the dynamic programme is ours";
constexpr std::string_view kMapada =
    "Lee and Jeong 1998, sections II and III; the decision is ours";
constexpr std::string_view kHnpda = "Sengupta and Iltis 1989, as quoted elsewhere";

std::unique_ptr<Associator> make_gnn_by_scan() { return make_scan_by_scan(make_gnn()); }

std::unique_ptr<Associator> make_nn_by_scan() { return make_scan_by_scan(make_nn()); }

std::unique_ptr<Associator> decided_by_scan(std::unique_ptr<Associator> marginals) {
  return make_scan_by_scan(make_decided(std::move(marginals), make_gnn()));
}

/// The loss axis of Bojilov's figure 2: the treatment with a threshold Q that loses this share.
template <int kPerTenThousand>
std::unique_ptr<Associator> make_bojilov_losing() {
  return make_bojilov(bojilov_options(kPerTenThousand * 1e-4));
}

constexpr CatalogEntry bojilov_entry(std::string_view name, std::string_view summary,
                                     std::unique_ptr<Associator> (*make)()) {
  return {.name = name,
          .family = "multisensor",
          .summary = summary,
          .source = "Bojilov 1995, sections 3 and 4",
          .make = make};
}

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
                 .make = make_exact},
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
    CatalogEntry{.name = "scf",
                 .family = "flow",
                 .summary = "single-commodity flow, ties by lowest index",
                 .source = "Battistelli et al. 2008, section III, as printed",
                 .make =
                     [] {
                       return make_scf({.tie_rule = TieRule::kLiteral},
                                       find_flow_code("scf-assignment")->solve);
                     }},
    CatalogEntry{.name = "scf-tie",
                 .family = "flow",
                 .summary = "single-commodity flow, ties by the cost of the best partial path",
                 .source = kScfTie,
                 .make = [] { return make_scf({}, find_flow_code("scf-assignment")->solve); }},
    CatalogEntry{.name = "scf-networksimplex",
                 .family = "flow",
                 .summary = "scf-tie by LEMON's network simplex",
                 .source = kScfTie,
                 .make = [] { return make_scf({}, find_flow_code("scf-networksimplex")->solve); }},
    CatalogEntry{.name = "scf-capacityscaling",
                 .family = "flow",
                 .summary = "scf-tie by LEMON's capacity scaling",
                 .source = kScfTie,
                 .make = [] { return make_scf({}, find_flow_code("scf-capacityscaling")->solve); }},
    CatalogEntry{.name = "scf-costscaling",
                 .family = "flow",
                 .summary = "scf-tie by LEMON's cost scaling",
                 .source = kScfTie,
                 .make = [] { return make_scf({}, find_flow_code("scf-costscaling")->solve); }},
    CatalogEntry{.name = "scf-lp",
                 .family = "flow",
                 .summary = "scf-tie as a linear programme, by Clp",
                 .source = kScfTie,
                 .make = [] { return make_scf({}, find_flow_code("scf-lp")->solve); }},
    CatalogEntry{.name = "scf-assignment",
                 .family = "flow",
                 .summary = "scf-tie as a one-sided assignment: price war and exact repair",
                 .source = kScfTie,
                 .make = [] { return make_scf({}, find_flow_code("scf-assignment")->solve); }},
    CatalogEntry{.name = "mcf",
                 .family = "flow",
                 .summary = "multi-commodity flow, a layered graph per track, by Clp and CBC",
                 .source = "Battistelli et al. 2008, sections I and II, on their reference [3]",
                 .make = make_mcf},
    CatalogEntry{.name = "mcf-lp",
                 .family = "flow",
                 .summary = "the relaxation of mcf, its paths rounded where fractional",
                 .source = "Battistelli et al. 2008, sections I and II; the rounding is ours",
                 .make = make_mcf_lp},
    CatalogEntry{.name = "viterbi-sequential",
                 .family = "flow",
                 .summary = "shortest paths through the graph of scf-tie, one track at a time",
                 .source = "after Pulford 2006, as cited by Battistelli et al. 2008, section III",
                 .make = make_viterbi_sequential},
    CatalogEntry{.name = "scf-pairs",
                 .family = "flow",
                 .summary = "scf-tie for fixed tracks, a flow through pairs of plots for births",
                 .source = "after Battistelli et al. 2008, section III; the births are ours",
                 .make = make_scf_pairs},
    CatalogEntry{.name = "brute-force",
                 .family = "exact",
                 .summary = "every choice of at most 25 columns",
                 .source = "none: the definition of the problem",
                 .make = make_brute_force},
    CatalogEntry{.name = "gnn",
                 .family = "single scan",
                 .summary = "global nearest neighbour: the optimal 2-D assignment",
                 .source = "Bar-Shalom and Li 1995",
                 .make = make_gnn},
    CatalogEntry{.name = "nn",
                 .family = "single scan",
                 .summary = "nearest neighbour: every track looks for itself",
                 .source = "Bar-Shalom and Li 1995",
                 .make = make_nn},
    CatalogEntry{.name = "mapada",
                 .family = "single scan",
                 .summary = "relaxed assignment by distance from the velocity line, clipped",
                 .source = kMapada,
                 .make = make_mapada},
    CatalogEntry{.name = "mapada-literal",
                 .family = "single scan",
                 .summary = "mapada without clipping, every track takes its largest value",
                 .source = "Lee and Jeong 1998, equation (16) as printed",
                 .make =
                     [] {
                       return make_mapada(
                           {.decision = MapadaDecision::kArgmax, .iteration = {.clip = false}});
                     }},
    CatalogEntry{.name = "mapada-weighted",
                 .family = "single scan",
                 .summary = "mapada's relaxed assignment taken as probabilities",
                 .source = kMapada,
                 .make = [] { return make_mapada({.decision = MapadaDecision::kWeighted}); }},
    CatalogEntry{.name = "mapada-miss",
                 .family = "single scan",
                 .summary = "mapada with a private miss per track, on the columns' costs",
                 .source = "after Lee and Jeong 1998, section III; the misses are ours",
                 .make = make_mapada_miss},
    CatalogEntry{.name = "hnpda",
                 .family = "marginal",
                 .summary = "Hopfield network for probabilities, outputs normalised per track",
                 .source = kHnpda,
                 .make = [] { return make_hnpda({}); }},
    CatalogEntry{.name = "hnpda-raw",
                 .family = "marginal",
                 .summary = "hnpda's outputs as they are, the rest of each track without a plot",
                 .source = kHnpda,
                 .make = [] { return make_hnpda({.normalised = false}); }},
    CatalogEntry{.name = "lagrangian-sd",
                 .family = "relaxation",
                 .summary = "S-D assignment by Lagrangian relaxation to two dimensions",
                 .source = "Deb, Yeddanapudi, Pattipati and Bar-Shalom 1997",
                 .make = make_lagrangian_sd},
    CatalogEntry{.name = "mapada-window",
                 .family = "relaxation",
                 .summary = "mapada's clipped steps on the relaxation of the window, then greedy",
                 .source = "after Lee and Jeong 1998, equation (16); the window is ours",
                 .make = make_mapada_window},
    CatalogEntry{.name = "pdhg",
                 .family = "relaxation",
                 .summary = "LP relaxation by extrapolated first-order steps, then greedy",
                 .source = "Chambolle and Pock 2011, algorithm 1",
                 .make = make_pdhg},
    CatalogEntry{.name = "dual-ascent",
                 .family = "certified",
                 .summary = "coordinate ascent on row prices with the best of every track, greedy",
                 .source = kDualAscent,
                 .make = make_dual_ascent},
    CatalogEntry{.name = "cg-lp",
                 .family = "certified",
                 .summary = "LP relaxation by column generation on the trees, from dual-ascent",
                 .source = kColumnGeneration,
                 .make = make_cg_lp},
    CatalogEntry{.name = "tree-exact",
                 .family = "certified",
                 .summary = "dual ascent, columns, cuts, search: the optimum with a certificate",
                 .source = kTreeExact,
                 .make = make_tree_exact,
                 .reference = true},
    CatalogEntry{.name = "gnn-by-scan",
                 .family = "adapter",
                 .summary = "scan after scan by 2-D assignment, nothing taken back",
                 .source = "Bar-Shalom and Li 1995",
                 .make = make_gnn_by_scan},
    CatalogEntry{.name = "nn-by-scan",
                 .family = "adapter",
                 .summary = "scan after scan by nearest neighbour, nothing taken back",
                 .source = "Bar-Shalom and Li 1995",
                 .make = make_nn_by_scan},
    CatalogEntry{.name = "mapada-miss-by-scan",
                 .family = "adapter",
                 .summary = "scan after scan by mapada-miss, nothing taken back",
                 .source = "after Lee and Jeong 1998, section III; the misses are ours",
                 .make = [] { return make_scan_by_scan(make_mapada_miss()); }},
    CatalogEntry{.name = "jpda",
                 .family = "marginal",
                 .summary = "exact marginals by dynamic programming over masks of shared rows",
                 .source = kJpda,
                 .make = [] { return make_jpda({}); }},
    CatalogEntry{.name = "jpda-enumerate",
                 .family = "marginal",
                 .summary = "exact marginals, event by event, of at most 30 columns a component",
                 .source = kJpda,
                 .make = make_jpda_enumerate},
    CatalogEntry{.name = "pda",
                 .family = "marginal",
                 .summary = "marginals of every track for itself",
                 .source = "Bar-Shalom and Tse 1975",
                 .make = make_pda},
    CatalogEntry{.name = "jpda-cheap",
                 .family = "marginal",
                 .summary = "Fitzgerald's ad hoc formula for marginals",
                 .source = "Fitzgerald 1986",
                 .make = make_jpda_cheap},
    CatalogEntry{.name = "lbp",
                 .family = "marginal",
                 .summary = "marginals by loopy belief propagation",
                 .source = "Williams and Lau 2014",
                 .make = [] { return make_lbp({}); }},
    CatalogEntry{.name = "jpda-by-scan",
                 .family = "adapter",
                 .summary = "scan after scan by jpda and an assignment on its marginals",
                 .source = kJpda,
                 .make = [] { return decided_by_scan(make_jpda({})); }},
    CatalogEntry{.name = "pda-by-scan",
                 .family = "adapter",
                 .summary = "scan after scan by pda and an assignment on its marginals",
                 .source = "Bar-Shalom and Tse 1975",
                 .make = [] { return decided_by_scan(make_pda()); }},
    CatalogEntry{.name = "jpda-cheap-by-scan",
                 .family = "adapter",
                 .summary = "scan after scan by jpda-cheap and an assignment on its marginals",
                 .source = "Fitzgerald 1986",
                 .make = [] { return decided_by_scan(make_jpda_cheap()); }},
    CatalogEntry{.name = "lbp-by-scan",
                 .family = "adapter",
                 .summary = "scan after scan by lbp and an assignment on its marginals",
                 .source = "Williams and Lau 2014",
                 .make = [] { return decided_by_scan(make_lbp({})); }},
    CatalogEntry{.name = "hnpda-by-scan",
                 .family = "adapter",
                 .summary = "scan after scan by hnpda and an assignment on its outputs",
                 .source = kHnpda,
                 .make = [] { return decided_by_scan(make_hnpda({})); }},
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
    bojilov_entry("bojilov", "two assignments in sequence, treated; Q loses 1 % of true pairs",
                  make_bojilov_losing<100>),
    bojilov_entry("bojilov-loss-0.2", "bojilov, Q loses 20 %", make_bojilov_losing<2000>),
    bojilov_entry("bojilov-loss-0.1", "bojilov, Q loses 10 %", make_bojilov_losing<1000>),
    bojilov_entry("bojilov-loss-0.05", "bojilov, Q loses 5 %", make_bojilov_losing<500>),
    bojilov_entry("bojilov-loss-0.025", "bojilov, Q loses 2.5 %", make_bojilov_losing<250>),
    bojilov_entry("bojilov-loss-0.005", "bojilov, Q loses 0.5 %", make_bojilov_losing<50>),
    bojilov_entry("bojilov-loss-0.001", "bojilov, Q loses 0.1 %", make_bojilov_losing<10>),
    bojilov_entry("bojilov-loss-0.0001", "bojilov, Q loses 0.01 %", make_bojilov_losing<1>),
    bojilov_entry("bojilov-worst-ties", "bojilov whose ties in step 3 cost it good pairs",
                  [] { return make_bojilov(worst_ties_options(0.01)); }),
    bojilov_entry("bojilov-untreated", "bojilov without treatment of the cost matrix",
                  [] { return make_bojilov(untreated_options(0.01)); }),
    CatalogEntry{.name = "bojilov-calibrated",
                 .family = "multisensor",
                 .summary = "bojilov, triples with a 1 % threshold of their own, pairs kept",
                 .source = "after Bojilov 1995; the triples' threshold is ours",
                 .make = [] { return make_bojilov(calibrated_options(0.01)); }},
    CatalogEntry{.name = "bojilov-a3",
                 .family = "multisensor",
                 .summary = "bojilov without thresholds: all sensors see all targets only",
                 .source = "Bojilov 1994, as cited by Bojilov 1995",
                 .make = [] { return make_bojilov(a3_options()); }},
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
#ifdef MDA_WITH_RIVALS
    CatalogEntry{.name = "glpk-bb",
                 .family = "exact",
                 .summary = "branch and bound by GLPK on the whole window",
                 .source = "GLPK 5.0, default settings",
                 .make = make_glpk_bb},
    CatalogEntry{.name = "cbc-main",
                 .family = "exact",
                 .summary = "CBC as its command line runs it: -ratio 0 -solve",
                 .source = "CBC 2.10",
                 .make = make_cbc_main},
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

Solution decided(const AssociationProblem& problem, std::span<const double> marginals) {
  const auto assignment = make_gnn();
  return decide(problem, marginals, *assignment, Budget{});
}

}  // namespace mda
