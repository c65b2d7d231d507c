#include "harness/progress.h"

#include <fmt/format.h>
#include <unistd.h>

#include <string>

#include "harness/messages.h"

namespace mda {
namespace {

constexpr int kBarWidth = 30;

std::string clock_text(double seconds) {
  const long s = std::lround(seconds);
  return s < 3600 ? fmt::format("{}:{:02}", s / 60, s % 60)
                  : fmt::format("{}:{:02}:{:02}", s / 3600, s / 60 % 60, s % 60);
}

}  // namespace

Progress::Progress(int total) : total_(total), terminal_(isatty(STDERR_FILENO) == 1) {}

Progress::~Progress() {
  if (drawn_) tell("\n");
}

void Progress::step(std::int64_t windows, std::int64_t rows) {
  using Seconds = std::chrono::duration<double>;
  ++done_;
  const auto now = std::chrono::steady_clock::now();
  const double share = static_cast<double>(done_) / total_;
  const double left_s = Seconds(now - start_).count() * (1.0 - share) / share;
  if (terminal_) {
    if (done_ < total_ && Seconds(now - last_draw_).count() < 0.1) return;
    last_draw_ = now;
    draw(share, left_s, windows, rows);
    return;
  }
  const int tenth = 10 * done_ / total_;
  if (tenth == last_tenth_) return;
  last_tenth_ = tenth;
  tell(fmt::format("{:3} %  {} of {} cells, {} windows, {} rows, {} left\n", 10 * tenth, done_,
                   total_, windows, rows, clock_text(left_s)));
}

void Progress::draw(double share, double left_s, std::int64_t windows, std::int64_t rows) {
  const int filled = static_cast<int>(share * kBarWidth);
  tell(fmt::format("\r[{:-<{}}] {:3.0f} %  {} windows, {} rows, {} left\x1b[K",
                   std::string(static_cast<std::size_t>(filled), '#'), kBarWidth, 100.0 * share,
                   windows, rows, clock_text(left_s)));
  drawn_ = true;
}

}  // namespace mda
