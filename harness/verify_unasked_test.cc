// What verify says of answers whose rows were not asked for, and of rankings.
#include <gtest/gtest.h>

#include <functional>
#include <utility>
#include <vector>

#include "harness/testing/recorded_run.h"
#include "harness/testing/tampered_run.h"

namespace mda::testing {
namespace {

using nlohmann::json;

constexpr int kLastScan = 30;  // no later window can tell that its answer was altered

Sweep ranking_sweep() {
  Sweep sweep = small_sweep();
  sweep.name = "ranking";
  sweep.scenarios = {{scenario_named("A"), {3}, 1}};
  sweep.algorithms = {"murty-k"};
  return sweep;
}

class VerifyUnaskedTest : public TamperedRun {
 protected:
  VerifyUnaskedTest() : TamperedRun(original()) {}

  void alter(const char* algorithm, int scan, const std::function<void(json&)>& change) const {
    tamper("answers.jsonl", [&](json& answer) {
      if (answer["algorithm"] != algorithm || answer["scan"] != scan) return false;
      change(answer);
      return true;
    });
  }

 private:
  static const std::filesystem::path& original() {
    static const std::filesystem::path kPath = kept_run(ranking_sweep());
    return kPath;
  }
};

TEST_F(VerifyUnaskedTest, AnHonestRunAgrees) {
  const Verification result = verify();
  EXPECT_EQ(result.disagreements, 0) << (result.examples.empty() ? "" : result.examples.front());
  EXPECT_EQ(result.rows, 30) << "those that were asked for";
}

TEST_F(VerifyUnaskedTest, AlteredRankingsAreNoticed) {
  alter("murty-k", kLastScan, [](json& answer) { answer["ranked"].erase(9); });
  expect_disagreement("ranked_nats");
  restore();
  alter("murty-k", kLastScan, [](json& answer) { answer["ranked"].erase(1); });
  expect_disagreement("ranked_nats");
  restore();
  alter("murty-k", kLastScan, [](json& answer) { answer.erase("ranked"); });
  expect_disagreement("ranked_nats");
  restore();
  alter("murty-k", kLastScan,
        [](json& answer) { std::swap(answer["ranked"][1], answer["ranked"][9]); });
  EXPECT_GT(verify().disagreements, 0);
}

TEST_F(VerifyUnaskedTest, AlteredAnswersOfTheDriverAreNoticed) {
  const std::vector<std::pair<const char*, std::function<void(json&)>>> alterations = {
      {"another choice", [](json& answer) { answer["columns"].erase(0); }},
      {"no choice", [](json& answer) { answer["columns"].clear(); }},
      {"a broken row", [](json& answer) { answer["columns"] = {0, 1, 2, 3, 4, 5, 6, 7}; }},
      {"no proof", [](json& answer) { answer["claimed"] = "feasible"; }},
      {"another bound", [](json& answer) { answer["bound_nats"] = -1e6; }},
      {"another end", [](json& answer) { answer["stop"] = "deadline"; }},
      {"no multipliers", [](json& answer) { answer["row_dual"].clear(); }},
      {"no row", [](json& answer) { answer.erase("row"); }},
      {"a number for a row", [](json& answer) { answer["row"] = 7; }},
      {"a skip", [](json& answer) { answer["row"]["status"] = "skipped"; }},
      {"another cost", [](json& answer) { answer["row"]["cost_nats"] = -1.0; }},
      {"nothing", [](json& answer) { answer = nullptr; }},
  };
  for (const auto& [what, change] : alterations) {
    SCOPED_TRACE(what);
    alter("exact", kLastScan, change);
    expect_disagreement("scan 30, exact: ");
    restore();
  }
}

}  // namespace
}  // namespace mda::testing
