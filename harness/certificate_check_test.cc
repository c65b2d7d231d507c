#include "harness/certificate_check.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "algorithms/catalog.h"
#include "algorithms/testing/oracle.h"
#include "algorithms/testing/random_problems.h"
#include "algorithms/testing/tiny_problems.h"
#include "harness/certificate_file.h"
#include "harness/referee.h"
#include "harness/testing/real_windows.h"

namespace mda::testing {
namespace {

struct Proven {
  AssociationProblem problem;
  CertificateFile file;

  [[nodiscard]] std::string fault() const {
    return certificate_fault(problem, file.columns, file.certificate);
  }
};

Proven prove(AssociationProblem problem) {
  const Solution solution = find_algorithm("tree-exact")->make()->solve(problem, Budget{});
  Proven proven;
  if (solution.certificate == nullptr) {
    ADD_FAILURE() << "no certificate";
    return proven;
  }
  proven.file = {problem.fingerprint(), {}, *solution.certificate};
  for (int j = 0; j < problem.columns(); ++j) {
    if (solution.x[static_cast<std::size_t>(j)] > 0.5) proven.file.columns.push_back(j);
  }
  proven.problem = std::move(problem);
  return proven;
}

/// Many columns on few rows, so that the proof needs cuts and a search.
AssociationProblem knot(std::uint64_t seed) {
  RandomShape shape;
  shape.dimensions = 3 + static_cast<int>(seed % 3);
  shape.rows_per_dimension = 14;
  shape.columns = 600;
  shape.presence = 0.9;
  shape.neighbourhood = 4;
  shape.exactly_once = seed % 4 == 0 ? 0.5 : 0.0;
  return random_problem(shape, seed);
}

/// Certificates of all kinds: of random windows, of groups C and D, and of knots.
const std::vector<Proven>& certificates() {
  static const std::vector<Proven> kAll = [] {
    std::vector<Proven> all;
    for (const TinyProblem& tiny : tiny_problems()) {
      if (tiny.problem.shape().always_feasible) all.push_back(prove(tiny.problem));
    }
    for (std::uint64_t seed = 1; seed <= 200; ++seed) {
      AssociationProblem problem = random_problem(random_shape(seed, 24), seed);
      if (problem.shape().always_feasible) all.push_back(prove(std::move(problem)));
    }
    for (const WindowSource source : {WindowSource{"C", 5}, {"D", 3}, {"D", 5}}) {
      for (AssociationProblem& problem : real_windows(source, 4)) {
        all.push_back(prove(std::move(problem)));
      }
    }
    for (std::uint64_t seed = 1; seed <= 12; ++seed) all.push_back(prove(knot(seed)));
    return all;
  }();
  return kAll;
}

TEST(CertificateTest, EveryOneIsAccepted) {
  std::vector<int> steps_of_kind(7, 0);
  for (std::size_t i = 0; i < certificates().size(); ++i) {
    EXPECT_EQ(certificates()[i].fault(), "") << i;
    for (const ProofStep& step : certificates()[i].file.certificate.steps) {
      ++steps_of_kind[static_cast<std::size_t>(step.kind)];
    }
  }
  for (const ProofStep::Kind kind :
       {ProofStep::Kind::kPrices, ProofStep::Kind::kOddRows, ProofStep::Kind::kClique,
        ProofStep::Kind::kParts, ProofStep::Kind::kRowPair, ProofStep::Kind::kEnumerate}) {
    EXPECT_GT(steps_of_kind[static_cast<std::size_t>(kind)], 0) << static_cast<int>(kind);
  }
}

/// The multipliers of an answer: where the LP was needed, they prove more than any ascent does.
TEST(CertificateTest, MultipliersAreThoseOfTheLp) {
  int more = 0;
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    const AssociationProblem problem = knot(seed);
    const auto bound = [&](const char* name) {
      const Solution solution = find_algorithm(name)->make()->solve(problem, Budget{});
      return mda::certified_bound(problem, solution.row_dual).value();
    };
    const double lp = bound("cg-lp");
    const double ours = bound("tree-exact");
    EXPECT_LE(ours, lp + cost_tolerance(lp));
    more += ours > bound("dual-ascent") + cost_tolerance(lp) ? 1 : 0;
  }
  EXPECT_GT(more, 0) << "the LP was never needed";
}

TEST(CertificateTest, SurvivesAFile) {
  for (const Proven& proven : certificates()) {
    const std::string text = certificate_json(proven.file);
    const CertificateFile back = parse_certificate(text, "proof.json");
    EXPECT_EQ(certificate_json(back), text);
    EXPECT_EQ(certificate_fault(proven.problem, back.columns, back.certificate), "");
  }
}

/// An empty proof of nothing, which coarse costs would make true.
TEST(CertificateTest, CostsMustNotBeRoundedAway) {
  ProofStep end;
  end.kind = ProofStep::Kind::kEnumerate;
  for (const Proven& proven : certificates()) {
    Proven forged = proven;
    forged.file.columns.clear();
    for (const int bits : {std::numeric_limits<int>::min(), -100, -20, -12, -1, 8}) {
      forged.file.certificate = {.bits = bits, .cost = 0, .steps = {ProofStep{}, end}};
      EXPECT_NE(forged.fault(), "") << bits;
    }
    forged = proven;
    forged.file.certificate.bits = kFinestBits + 1;
    EXPECT_NE(forged.fault(), "");
  }
}

TEST(CertificateTest, CostsMayBeOfAnySize) {
  const auto window = [](const std::vector<double>& costs, RowUse use, int rows) {
    ProblemBuilder builder;
    for (int r = 0; r < rows; ++r) {
      builder.add_row(0, use);
      for (const double cost : costs) builder.add_column(cost, {&r, 1});
    }
    return builder.build();
  };
  for (const std::vector<double>& costs : {std::vector<double>{131073.0},
                                           {-1.0, 1e6},
                                           {-3.0, 1e9},
                                           {-3.0, 1e12},
                                           {-1e-300, 1e12},
                                           {1e12, 1e12 - 3.0},
                                           {-1e12, 5.0},
                                           {0.0},
                                           {5e-324}}) {
    for (const RowUse use : {RowUse::kAtMostOnce, RowUse::kExactlyOnce}) {
      for (const int rows : {1, 12}) {
        const Proven proven = prove(window(costs, use, rows));
        EXPECT_EQ(proven.fault(), "") << costs.front();
        const double free = use == RowUse::kAtMostOnce ? 0.0 : std::numeric_limits<double>::max();
        double cost = 0.0;
        for (const int j : proven.file.columns) cost += proven.problem.cost(j);
        const double best = rows * std::min(free, *std::ranges::min_element(costs));
        EXPECT_NEAR(cost, best, 1e-12 * std::abs(best));
      }
    }
  }
}

/// False claims with a proof that was good for the true one: 1,000 of them and more.
TEST(CertificateTest, NothingFalseIsAccepted) {
  int refused = 0;
  const auto expect_refused = [&](const Proven& tampered, const char* what) {
    EXPECT_NE(tampered.fault(), "") << what;
    ++refused;
  };
  for (const Proven& proven : certificates()) {
    const auto tamper = [&](const char* what, const std::function<void(CertificateFile&)>& how) {
      Proven tampered = proven;
      how(tampered.file);
      expect_refused(tampered, what);
    };
    tamper("the cost is not that of the choice",
           [](CertificateFile& file) { --file.certificate.cost; });
    tamper("the proof has no end",
           [](CertificateFile& file) { file.certificate.steps.pop_back(); });
    tamper("the proof goes on", [](CertificateFile& file) {
      file.certificate.steps.push_back(file.certificate.steps.back());
    });
    // Other choices, with their own cost: none of them is optimal.
    for (std::size_t i = 0; i < proven.file.columns.size() && i < 5; ++i) {
      const int j = proven.file.columns[i];
      const double units = std::ldexp(proven.problem.cost(j), proven.file.certificate.bits);
      if (std::llround(units) >= 0) continue;
      tamper("a column is missing", [&](CertificateFile& file) {
        file.columns.erase(file.columns.begin() + static_cast<std::ptrdiff_t>(i));
        file.certificate.cost -= std::llround(units);
      });
      tamper("a column is there twice", [&](CertificateFile& file) {
        file.columns.push_back(j);
        file.certificate.cost += std::llround(units);
      });
    }
  }
  EXPECT_GE(refused, 1000);
}

/// The window is another one, in which the choice is not optimal any more.
TEST(CertificateTest, ABetterColumnInTheWindowIsNoticed) {
  for (const Proven& proven : certificates()) {
    ProblemBuilder builder;
    const AssociationProblem& p = proven.problem;
    for (int r = 0; r < p.rows(); ++r) builder.add_row(p.dimension(r), p.use(r));
    for (int j = 0; j < p.columns(); ++j) builder.add_column(p.cost(j), p.rows_of(j));
    if (p.rows() == 0) continue;
    const int row = p.rows() - 1;
    double all = 1.0;  // nats: more than any choice costs or gains
    for (const double cost : p.costs()) all += std::abs(cost);
    const double least = -2.0 * all;
    builder.add_column(least, {&row, 1});
    const AssociationProblem better = builder.build();
    EXPECT_NE(certificate_fault(better, proven.file.columns, proven.file.certificate), "");
  }
}

/// No steps whatsoever prove what is false: here that the choice is optimal with a column missing.
TEST(CertificateTest, DamagedStepsDoNotProveAFalseClaim) {
  int damaged = 0;
  for (const Proven& proven : certificates()) {
    const auto costs_less_than_nothing = [&](int j) {
      return std::ldexp(proven.problem.cost(j), proven.file.certificate.bits) <= -1.0;
    };
    Proven claim = proven;
    const auto gone = std::ranges::find_if(claim.file.columns, costs_less_than_nothing);
    if (gone == claim.file.columns.end() || proven.problem.columns() > 1000) continue;
    claim.file.certificate.cost -=
        std::llround(std::ldexp(proven.problem.cost(*gone), proven.file.certificate.bits));
    claim.file.columns.erase(gone);
    for (std::size_t s = 0; s < proven.file.certificate.steps.size() && s < 12; ++s) {
      for (const int how : {0, 1, 2, 3, 4}) {
        Proven tampered = claim;
        auto& steps = tampered.file.certificate.steps;
        ProofStep& step = steps[s];
        for (auto& price : step.prices) price = how == 0 ? 2 * price : price / 2 + 1;
        for (auto& floor : step.part_floors) floor += how - 2;
        for (auto& row : step.rows) row += how == 1 ? 1 : 0;
        if (how == 2) steps.erase(steps.begin() + static_cast<std::ptrdiff_t>(s));
        if (how == 3) step.kind = ProofStep::Kind::kEnumerate;
        if (how == 4) steps.insert(steps.begin(), step);
        EXPECT_NE(tampered.fault(), "");
        ++damaged;
      }
    }
  }
  EXPECT_GT(damaged, 1000);
}

/// More exactly-once rows in one column than 64 bits can add the charges of.
TEST(CertificateTest, ChargesMustNotOverflow) {
  constexpr int kRows = 20000;
  constexpr int kBits = 29;
  const double much = std::ldexp(1.0, 48 - kBits);
  ProblemBuilder builder;
  std::vector<int> all;
  for (int r = 0; r < kRows; ++r) all.push_back(builder.add_row(r, RowUse::kExactlyOnce));
  for (const int r : all) builder.add_column(much, {&r, 1});
  for (int r = kRows; r < 2 * kRows; ++r) {
    const int row = builder.add_row(r, RowUse::kExactlyOnce);
    builder.add_column(-much, {&row, 1});
  }
  builder.add_column(0.0, all);  // the best by far
  Proven claim;
  claim.problem = builder.build();
  for (int j = 0; j < 2 * kRows; ++j) claim.file.columns.push_back(j);
  claim.file.certificate.bits = kBits;
  claim.file.certificate.steps.resize(2);
  claim.file.certificate.steps[1].kind = ProofStep::Kind::kEnumerate;
  EXPECT_EQ(claim.fault(), "a column gains too much");
}

/// What rounding hides makes no optimum: the proof stands, with its margin, and the status tells.
TEST(CertificateTest, WhatIsRoundedTooCoarselyIsNotCalledOptimal) {
  for (const double alone : {1.0, 1e12}) {
    ProblemBuilder builder;
    std::vector<int> rows;
    for (int r = 0; r < 3; ++r) {
      rows.push_back(builder.add_row(r, r < 2 ? RowUse::kExactlyOnce : RowUse::kAtMostOnce));
    }
    const std::vector<int> ends = {rows[0], rows[2]};
    builder.add_column(alone, {rows.data(), 1});
    builder.add_column(-alone, {&rows[1], 1});
    builder.add_column(alone - 1.0003, ends);
    const AssociationProblem problem = builder.build();
    const Solution solution = find_algorithm("tree-exact")->make()->solve(problem, Budget{});
    EXPECT_EQ(solution.status, alone > 1.0 ? Status::kFeasible : Status::kOptimal);
    EXPECT_LE(solution.lower_bound, -1.0003);
    EXPECT_NE(solution.certificate, nullptr);
  }
}

}  // namespace
}  // namespace mda::testing
