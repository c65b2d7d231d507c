#include "harness/known_loop.h"

namespace mda {

void KnownLoop::start(const ScenarioSpec& spec, std::uint64_t seed, int replicate, int window_k,
                      bool /*views*/) {
  const Stopwatch watch;
  windows_.emplace(spec, seed, replicate, window_k);
  simulate_cpu_ms_ = watch.cpu_ms();
  decide_ = {};
}

bool KnownLoop::next() {
  const Stopwatch watch;
  if (!windows_->next()) return false;
  window_ = windows_->window();
  grow_ = {watch.wall_ms() + decide_.wall_ms, watch.cpu_ms() + decide_.cpu_ms};
  return true;
}

std::vector<Tuple> KnownLoop::sequences(const Decision& decision) const {
  std::vector<int> columns;
  for (std::size_t j = 0; j < decision.x.size(); ++j) {
    if (decision.x[j] > 0.5) columns.push_back(static_cast<int>(j));
  }
  std::vector<Tuple> tuples = windows_->sequences_of(columns);
  tuples.insert(tuples.end(), decision.tuples.begin(), decision.tuples.end());
  std::vector<char> has_one(static_cast<std::size_t>(windows_->tracks()), 0);
  for (const Tuple& tuple : tuples) has_one[static_cast<std::size_t>(tuple.track)] = 1;
  const auto scans = static_cast<std::size_t>(windows_->window_scans());
  for (int track = 0; track < windows_->tracks(); ++track) {
    if (has_one[static_cast<std::size_t>(track)] != 0) continue;
    tuples.push_back({track, std::vector<int>(scans, kNoRow)});
  }
  return tuples;
}

void KnownLoop::advance(const Decision& decision) {
  const Stopwatch watch;
  windows_->advance(sequences(decision));
  decide_ = {watch.wall_ms(), watch.cpu_ms()};
}

}  // namespace mda
