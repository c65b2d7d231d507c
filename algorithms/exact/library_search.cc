#include "algorithms/exact/library_search.h"

#include <vector>

#ifdef MDA_WITH_LPSOLVE
#include "algorithms/backends/lpsolve.h"
#endif
#ifdef MDA_WITH_RIVALS
#include "algorithms/backends/cbc_main.h"
#include "algorithms/backends/glpk.h"
#endif

namespace mda {
namespace {

std::vector<int> used_columns(const std::vector<double>& x) {
  std::vector<int> columns;
  for (std::size_t j = 0; j < x.size(); ++j) {
    if (x[j] > 0.5) columns.push_back(static_cast<int>(j));
  }
  return columns;
}

class LibrarySearch final : public Associator {
 public:
  using Library = LibraryRun (*)(const AssociationProblem&, const Budget&);

  explicit LibrarySearch(Library library) : library_(library) {}

  [[nodiscard]] Traits traits() const noexcept override {
    return {.answer = Answer::kSelection, .exact = true, .bounds = true};
  }

  [[nodiscard]] Verdict can_solve(const Shape& /*shape*/) const override { return {}; }

  [[nodiscard]] Solution solve(const AssociationProblem& problem, const Budget& budget) override {
    const LibraryRun run = library_(problem, budget);
    const bool optimal = run.outcome == Outcome::kOptimal;
    Solution solution = no_answer(run.outcome);
    if (optimal || !run.x.empty()) {
      const Stop stop = solution.stop;
      solution = selection_of(used_columns(run.x), problem.columns(),
                              optimal ? Status::kOptimal : Status::kFeasible);
      solution.stop = stop;
    }
    if (optimal) solution.lower_bound = run.objective;
    solution.stats.nodes = run.nodes;
    solution.stats.iterations = run.iterations;
    solution.stats.translate_ms = run.translate_ms;
    return solution;
  }

 private:
  Library library_;
};

}  // namespace

#ifdef MDA_WITH_LPSOLVE
std::unique_ptr<Associator> make_lpsolve_bb() {
  return std::make_unique<LibrarySearch>(
      [](const AssociationProblem& problem, const Budget& budget) {
        return lpsolve(problem, true, budget);
      });
}
#endif

#ifdef MDA_WITH_RIVALS
std::unique_ptr<Associator> make_glpk_bb() { return std::make_unique<LibrarySearch>(glpk); }

std::unique_ptr<Associator> make_cbc_main() { return std::make_unique<LibrarySearch>(cbc_main); }
#endif

}  // namespace mda
