#include "algorithms/backends/growing_assignment.h"

#include <stdexcept>
#include <string>

namespace mda {
namespace {

__extension__ using Wide = __int128;

void check(std::int64_t cost) {
  constexpr std::int64_t kLargest = INT64_MAX / 64;
  if (cost > kLargest || cost < -kLargest) {
    throw std::invalid_argument("a cost of " + std::to_string(cost) + " is out of range");
  }
}

}  // namespace

int GrowingAssignment::add_detection(std::int64_t cost, std::int64_t entry, std::int64_t exit) {
  check(cost);
  check(entry);
  check(exit);
  const int number = problem_.agents();
  const auto begin = static_cast<std::int32_t>(problem_.choices.size());
  cost_.push_back(cost);
  problem_.alone.push_back(entry);
  problem_.unused.push_back(exit);
  problem_.choices.push_back({-cost, number, -1});
  problem_.row_begin.push_back(begin);
  problem_.row_end.push_back(begin + 1);
  return number;
}

void GrowingAssignment::add_link(int from, std::int64_t cost) {
  check(cost);
  if (from < 0 || from + 1 >= problem_.agents()) {
    throw std::invalid_argument("a link from detection " + std::to_string(from) +
                                ", which is not older than the newest one");
  }
  if (cost >= problem_.alone.back() + problem_.unused[static_cast<std::size_t>(from)]) return;
  problem_.choices.push_back({cost, from, -1});
  ++problem_.row_end.back();
}

std::int64_t GrowingAssignment::cost() const {
  Wide cost = 0;
  for (int d = 0; d < problem_.agents(); ++d) {
    cost += cost_[static_cast<std::size_t>(d)];
    cost += matcher_.value(d);
    cost += matcher_.price(d);
  }
  if (cost > INT64_MAX || cost < INT64_MIN) {
    throw std::overflow_error("the cost of the paths is outside 64 bits");
  }
  return static_cast<std::int64_t>(cost);
}

std::vector<int> GrowingAssignment::starts() const {
  std::vector<int> starts;
  for (int d = 0; d < problem_.agents(); ++d) {
    if (matcher_.pick(d) == OneSidedMatcher::kAlone) starts.push_back(d);
  }
  return starts;
}

}  // namespace mda
