// How far a run is, on stderr: a bar that redraws itself on a terminal, a line now and then
// elsewhere.
#pragma once

#include <chrono>
#include <cstdint>

namespace mda {

/// Not thread safe: call it under the lock that guards the run's files.
class Progress {
 public:
  explicit Progress(int total);
  /// Ends the bar's line, if there is one.
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// One more cell is done; `windows` and `rows` are totals so far.
  void step(std::int64_t windows, std::int64_t rows);

 private:
  void draw(double share, double left_s, std::int64_t windows, std::int64_t rows);

  int total_ = 0;
  int done_ = 0;
  int last_tenth_ = 0;
  bool terminal_ = false;
  bool drawn_ = false;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  std::chrono::steady_clock::time_point last_draw_;
};

}  // namespace mda
