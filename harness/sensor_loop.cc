#include "harness/sensor_loop.h"

#include <algorithm>
#include <iterator>
#include <utility>
#include <vector>

#include "scenarios/static3/sensor_window.h"

namespace mda {

void SensorLoop::start(const ScenarioSpec& spec, std::uint64_t seed, int replicate,
                       int /*window_k*/, bool views) {
  const Stopwatch watch;
  spec_ = spec;
  scene_ = simulate_sensors(spec, seed, replicate);
  simulate_cpu_ms_ = watch.cpu_ms();
  views_ = views;
  done_ = false;
}

bool SensorLoop::next() {
  if (std::exchange(done_, true)) return false;
  const Stopwatch watch;
  window_ = sensor_window(spec_, scene_);
  grow_ = {watch.wall_ms(), watch.cpu_ms()};
  if (views_) {
    const Stopwatch views_watch;
    attach_sensor_view(spec_, scene_, window_);
    views_ms_ = views_watch.wall_ms();
    grow_.cpu_ms += views_watch.cpu_ms();
  }
  truth_ = TrueAssociation(true_tuples(scene_));
  truth_cost_ = true_cost(spec_, scene_);
  return true;
}

std::optional<AssociationCounts> SensorLoop::association(const Solution& solution) const {
  const AssociationProblem& problem = window_.problem;
  std::vector<ReportTuple> answer;
  for (int j = 0; j < problem.columns(); ++j) {
    if (solution.x[static_cast<std::size_t>(j)] <= 0.5) continue;
    const auto rows = problem.rows_of(j);
    answer.emplace_back(rows.begin(), rows.end());
  }
  for (const Tuple& tuple : solution.tuples) {
    ReportTuple& rows = answer.emplace_back();
    std::ranges::copy_if(tuple.rows, std::back_inserter(rows),
                         [](int row) { return row != kNoRow; });
    std::ranges::sort(rows);
  }
  return truth_.count(answer);
}

}  // namespace mda
