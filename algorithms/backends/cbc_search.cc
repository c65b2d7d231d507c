#include "algorithms/backends/cbc_search.h"

#include <CbcModel.hpp>
#include <CglClique.hpp>
#include <OsiClpSolverInterface.hpp>
#include <stdexcept>
#include <string>

namespace mda {
namespace {

void prepare_search(CbcModel& model, CglClique& cliques, const Budget& budget) {
  model.setLogLevel(0);
  model.solver()->messageHandler()->setLogLevel(0);
  model.solver()->setHintParam(OsiDoReducePrint, true, OsiHintDo);
  // By default CBC ignores choices that are better by less than 1e-5.
  model.setCutoffIncrement(1e-9);
  // Tracks that pairwise share plots are what makes the relaxation fractional. Of the cut
  // generators, the one for odd cycles (CglZeroHalf) keeps state in statics: not for threads.
  constexpr int kAsLongAsUseful = -1;
  cliques.setStarCliqueReport(false);
  cliques.setRowCliqueReport(false);
  model.addCutGenerator(&cliques, kAsLongAsUseful, "Clique");
  if (budget.deadline != Clock::time_point::max()) {
    model.setUseElapsedTime(true);
    model.setMaximumSeconds(budget.seconds_left());
  }
}

/// Reads the verdict of a finished or interrupted search. CBC calls a stop at a gap finished too;
/// only the secondary status tells a proof. An infeasible problem may end with either proof.
Outcome outcome_of(const CbcModel& model) {
  constexpr int kFinished = 0;
  constexpr int kStopped = 1;
  constexpr int kProven = 0;
  constexpr int kProvenInfeasible = 1;
  constexpr int kOutOfTime = 4;
  const int status = model.status();
  const int secondary = model.secondaryStatus();
  if (status == kFinished && (secondary == kProven || secondary == kProvenInfeasible)) {
    return model.bestSolution() == nullptr ? Outcome::kInfeasible : Outcome::kOptimal;
  }
  if (status == kStopped && secondary == kOutOfTime) return Outcome::kDeadline;
  throw std::runtime_error("CBC gave up with status " + std::to_string(status) + "/" +
                           std::to_string(secondary));
}

}  // namespace

CbcSearch search_from(ClpSimplex& root, const Budget& budget) {
  OsiClpSolverInterface relaxation(&root);
  CbcModel model(relaxation);
  CglClique cliques;
  prepare_search(model, cliques, budget);
  model.branchAndBound();
  CbcSearch search;
  search.nodes = model.getNodeCount();
  search.iterations = model.getIterationCount();
  search.outcome = outcome_of(model);
  if (search.outcome == Outcome::kInfeasible) return search;
  constexpr double kNoBound = -1e49;
  const double bound = model.getBestPossibleObjValue();
  if (bound > kNoBound) search.lower_bound = bound;
  if (const double* best = model.bestSolution(); best != nullptr) {
    search.best.assign(best, best + root.numberColumns());
  }
  return search;
}

}  // namespace mda
