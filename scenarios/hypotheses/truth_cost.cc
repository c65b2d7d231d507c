#include "scenarios/hypotheses/truth_cost.h"

#include <algorithm>
#include <cmath>

namespace mda {

void TruthCost::reset(const World& world, const TrackerModel& model) {
  world_ = world;
  model_ = model;
  terms_ = cost_terms(world, model);
  least_plots_ = model.newborn == Newborn::kSinglePlot ? 1 : 2;
  tracks_.clear();
  ended_cost_ = 0.0;
}

void TruthCost::add(const Scan& scan) {
  plot_of_target_.assign(tracks_.size(), nullptr);
  for (const Plot& plot : scan.plots) {
    if (plot.source == kFalseAlarm) continue;
    const auto target = static_cast<std::size_t>(plot.source);
    if (target >= tracks_.size()) {
      tracks_.resize(target + 1);
      plot_of_target_.resize(target + 1, nullptr);
    }
    plot_of_target_[target] = &plot;
  }
  for (std::size_t target = 0; target < tracks_.size(); ++target) {
    if (plot_of_target_[target] != nullptr) {
      extend(tracks_[target], *plot_of_target_[target]);
    } else if (tracks_[target].plots > 0) {
      miss(tracks_[target]);
    }
  }
}

void TruthCost::extend(Track& track, const Plot& plot) const {
  if (track.plots == 0) {
    track = {newborn_state(world_, model_, plot), plot, terms_.birth, 1, 0};
    return;
  }
  const Gaussian predicted = predict(world_, track.state);
  const Innovation expected = innovation(world_, predicted);
  const Eigen::Vector2d nu = residual(expected, plot);
  track.cost += terms_.detection + 0.5 * std::log(expected.covariance.determinant()) +
                log_clutter_density(world_, model_, plot) +
                0.5 * nu.dot(expected.covariance.inverse() * nu);
  track.state = track.plots == 1
                    ? two_plot_state(world_, model_, track.first, plot, track.misses + 1)
                    : update(predicted, expected, plot);
  ++track.plots;
  track.misses = 0;
}

void TruthCost::miss(Track& track) {
  track.state = predict(world_, track.state);
  track.cost += terms_.miss;
  if (++track.misses <= model_.max_misses) return;
  if (track.plots >= least_plots_) ended_cost_ += track.cost - terms_.ended_discount;
  track = {};
}

double TruthCost::counted(const Track& track) const {
  return track.plots < least_plots_ ? 0.0 : track.cost - track.misses * terms_.live_discount;
}

double TruthCost::cost() const {
  double sum = ended_cost_;
  for (const Track& track : tracks_) sum += counted(track);
  return sum;
}

}  // namespace mda
