// Wall clock and CPU time of a stretch of code.
#pragma once

#include <chrono>
#include <ctime>

namespace mda {

/// Milliseconds.
struct Elapsed {
  double wall_ms = 0.0;
  double cpu_ms = 0.0;
};

/// Starts when it is made.
class Stopwatch {
 public:
  /// Milliseconds of wall clock.
  [[nodiscard]] double wall_ms() const {
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - wall_)
        .count();
  }
  /// Milliseconds of this thread's CPU time. Call it on the thread that made the stopwatch.
  [[nodiscard]] double cpu_ms() const { return thread_cpu_ms() - cpu_; }

 private:
  static double thread_cpu_ms() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) * 1e3 + static_cast<double>(now.tv_nsec) * 1e-6;
  }

  std::chrono::steady_clock::time_point wall_ = std::chrono::steady_clock::now();
  double cpu_ = thread_cpu_ms();
};

}  // namespace mda
