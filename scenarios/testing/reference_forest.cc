#include "scenarios/testing/reference_forest.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <stdexcept>

#include "scenarios/hypotheses/cost.h"

namespace mda::testing {
namespace {

/// Minus the logarithm of a detection's factor in (6): P_d f_delta / (lambda_phi f_phi).
double detection_nats(const World& world, double squared_distance, double determinant,
                      double log_clutter) {
  const double log_density =
      -0.5 * squared_distance - std::log(2.0 * std::numbers::pi * std::sqrt(determinant));
  return -(std::log(world.detection_probability) + log_density - std::log(world.clutter_per_scan) -
           log_clutter);
}

double miss_nats(const World& world) { return -std::log(1.0 - world.detection_probability); }

/// How many of the misses after the last plot count.
int charged_misses(const TrackerModel& model, int misses, bool ended) {
  switch (model.trailing_misses) {
    case TrailingMisses::kAll:
      return misses;
    case TrailingMisses::kAllowed:
      return std::min(misses, model.max_misses);
    case TrailingMisses::kLiveOnly:
      return ended ? 0 : misses;
    case TrailingMisses::kNone:
      return 0;
  }
  throw std::invalid_argument("unknown rule for trailing misses");
}

}  // namespace

History up_to(const History& history, int scan) {
  History early;
  for (const PlotOfScan& plot : history) {
    if (plot.scan <= scan) early.push_back(plot);
  }
  return early;
}

void ReferenceForest::grow(const Scan& scan) {
  ++newest_;
  std::vector<Hypothesis> next;
  for (const Hypothesis& hypothesis : hypotheses_) {
    if (hypothesis.end_scan != 0) {
      next.push_back(hypothesis);
    } else {
      add_children(hypothesis, scan, next);
    }
  }
  for (int plot = 0; const Plot& seen : scan.plots) {
    // lambda_nu f_nu / (lambda_phi f_phi) with f_nu = f_phi
    const double birth = -std::log(world_.births_per_scan / world_.clutter_per_scan);
    next.push_back({{{newest_, plot++}}, newborn_state(world_, model_, seen), seen, birth, 0, 0});
  }
  hypotheses_ = std::move(next);
}

void ReferenceForest::add_children(const Hypothesis& parent, const Scan& scan,
                                   std::vector<Hypothesis>& out) const {
  const Gaussian predicted = predict(world_, parent.state);
  const Innovation expected = innovation(world_, predicted);
  const Eigen::Matrix2d inverse = expected.covariance.inverse();
  for (int plot = 0; plot < static_cast<int>(scan.plots.size()); ++plot) {
    const Plot& seen = scan.plots[static_cast<std::size_t>(plot)];
    const Eigen::Vector2d nu = residual(expected, seen);
    const double squared_distance = nu.dot(inverse * nu);
    if (squared_distance > model_.gate) continue;
    Hypothesis child = parent;
    child.state = parent.history.size() == 1
                      ? two_plot_state(world_, model_, parent.first, seen, parent.misses + 1)
                      : update(predicted, expected, seen);
    child.history.push_back({newest_, plot});
    child.cost += parent.misses * miss_nats(world_) +
                  detection_nats(world_, squared_distance, expected.covariance.determinant(),
                                 log_clutter_density(world_, model_, seen));
    child.misses = 0;
    out.push_back(std::move(child));
  }
  out.push_back(missed(parent, predicted));
}

ReferenceForest::Hypothesis ReferenceForest::missed(const Hypothesis& parent,
                                                    const Gaussian& predicted) const {
  Hypothesis child = parent;
  child.state = predicted;
  ++child.misses;
  if (child.misses > model_.max_misses) child.end_scan = newest_;
  return child;
}

double ReferenceForest::cost(const Hypothesis& h) const {
  return h.cost + charged_misses(model_, h.misses, h.end_scan != 0) * miss_nats(world_);
}

std::map<History, double> ReferenceForest::columns() const {
  const std::size_t least_plots = model_.newborn == Newborn::kSinglePlot ? 1 : 2;
  std::map<History, double> found;
  for (const Hypothesis& hypothesis : hypotheses_) {
    if (hypothesis.history.size() < least_plots || cost(hypothesis) >= 0.0) continue;
    if (!found.emplace(hypothesis.history, cost(hypothesis)).second) {
      throw std::logic_error("two hypotheses of the same plots");
    }
  }
  return found;
}

void ReferenceForest::decide(std::span<const History> chosen) {
  if (newest_ <= window_k_) return;
  fixed_ = newest_ - window_k_ + 1;
  std::set<History> kept;
  for (const Hypothesis& h : hypotheses_) {
    if (std::find(chosen.begin(), chosen.end(), h.history) == chosen.end()) continue;
    const bool ended = h.end_scan != 0 && h.end_scan <= fixed_;
    if (ended) {
      retired_.emplace(h.history, cost(h));
    } else if (h.history.front().scan <= fixed_) {
      kept.insert(up_to(h.history, fixed_));
    }
  }
  std::erase_if(hypotheses_, [&](const Hypothesis& h) {
    return h.history.front().scan <= fixed_ && !kept.contains(up_to(h.history, fixed_));
  });
  tracks_.assign(kept.begin(), kept.end());
}

int ReferenceForest::live() const {
  return static_cast<int>(
      std::count_if(hypotheses_.begin(), hypotheses_.end(),
                    [](const Hypothesis& hypothesis) { return hypothesis.end_scan == 0; }));
}

}  // namespace mda::testing
