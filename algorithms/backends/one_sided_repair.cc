// The way for hard problems: an auction whose prices move by a little more than they must, which
// ends wars between near-equals, then a repair that makes its result exact again.
#include <algorithm>
#include <numeric>
#include <utility>

#include "algorithms/backends/one_sided.h"

namespace mda {
namespace {

constexpr std::int64_t kFar = INT64_MAX;

/// Bounds an auction whose prices would have to fall by more than steps can (agents that must not
/// stay alone).
constexpr std::int64_t kBidsPerAgent = 60;
constexpr std::int64_t kExactBidsPerChain = 256;

std::size_t index(std::int32_t i) { return static_cast<std::size_t>(i); }

}  // namespace

void OneSidedMatcher::auction(std::vector<std::int32_t> agents, std::int64_t step) {
  std::int64_t bids = kBidsPerAgent * problem_.agents();
  for (const std::int32_t agent : agents) bid(agent, step, bids);
  release_if_not_best();
  agents = std::exchange(waiting_, {});
  for (const std::int32_t agent : agents) {
    std::int64_t chain = kExactBidsPerChain;
    bid(agent, 0, chain);
  }
  agents = std::exchange(waiting_, {});
  for (const std::int32_t agent : agents) search(agent);
  for (int object = 0; object < problem_.objects(); ++object) {
    if (owner_[index(object)] < 0 && price_[index(object)] < problem_.unused[index(object)]) {
      reprice(object);
    }
  }
}

/// Agents whose pick costs more than their best one wait again; what they had stays at its price.
void OneSidedMatcher::release_if_not_best() {
  for (int agent = 0; agent < problem_.agents(); ++agent) {
    const std::int32_t pick = pick_[index(agent)];
    if (pick == kWaiting || value(agent) == two_best(agent).first) continue;
    if (pick != kAlone) owner_[index(object_of(pick))] = -1;
    pick_[index(agent)] = kWaiting;
    waiting_.push_back(agent);
  }
}

void OneSidedMatcher::transpose() {
  column_begin_.assign(problem_.unused.size() + 1, 0);
  for (int agent = 0; agent < problem_.agents(); ++agent) {
    for (const Choice& choice : problem_.row(agent)) ++column_begin_[index(choice.object) + 1];
  }
  std::partial_sum(column_begin_.begin(), column_begin_.end(), column_begin_.begin());
  column_agent_.resize(index(column_begin_.back()));
  column_pick_.resize(index(column_begin_.back()));
  std::vector<std::int32_t> fill(column_begin_.begin(), column_begin_.end() - 1);
  for (int agent = 0; agent < problem_.agents(); ++agent) {
    const std::int32_t end = problem_.row_end[index(agent)];
    for (std::int32_t i = problem_.row_begin[index(agent)]; i < end; ++i) {
      const auto slot = index(fill[index(object_of(i))]++);
      column_agent_[slot] = agent;
      column_pick_[slot] = i;
    }
  }
}

/// An agent that could take `object` leaves what it has: for good if it was alone, or for
/// somebody else, or to stay unused.
void OneSidedMatcher::scan_object(int object, std::int64_t distance, End& end) {
  const std::int64_t base = distance - price_[index(object)];
  for (auto slot = index(column_begin_[index(object)]);
       slot < index(column_begin_[index(object) + 1]); ++slot) {
    const std::int32_t agent = column_agent_[slot];
    const std::int32_t pick = column_pick_[slot];
    const std::int64_t through = base + problem_.choices[index(pick)].cost - value(agent);
    if (through >= end.distance || owner_[index(object)] == agent) continue;
    if (pick_[index(agent)] == kAlone) {
      end = {through, agent, pick};
      continue;
    }
    const std::int32_t left = object_of(pick_[index(agent)]);
    Label& label = label_[index(left)];
    if (through >= label.distance) continue;
    if (label.distance == kFar) reached_.push_back(left);
    label = {through, agent, pick};
    push(through, left);
    const std::int64_t unused = through + problem_.unused[index(left)] - price_[index(left)];
    if (unused < end.distance) end = {unused, agent, pick};
  }
}

/// Makes a free object whose price is too low cost what it costs unused, or finds it an agent: the
/// search of search(), from the side of the objects.
void OneSidedMatcher::reprice(int object) {
  if (column_begin_.empty()) transpose();
  label_[index(object)] = {0, -1, -1};
  reached_.push_back(object);
  push(0, object);
  End end{problem_.unused[index(object)] - price_[index(object)], -1, -1};
  while (!heap_.empty()) {
    const Reached top = pop();
    if (top.distance >= end.distance) break;
    if (top.distance > label_[index(top.object)].distance) continue;
    settled_.push_back(top.object);
    scan_object(top.object, top.distance, end);
  }
  for (const std::int32_t moved : settled_) {
    price_[index(moved)] += end.distance - label_[index(moved)].distance;
  }
  std::int32_t taker = end.agent;
  std::int32_t pick = end.pick;
  if (taker >= 0 && pick_[index(taker)] != kAlone) {
    owner_[index(object_of(pick_[index(taker)]))] = -1;
  }
  while (taker >= 0) {
    const std::int32_t taken = object_of(pick);
    take(taker, pick);
    taker = label_[index(taken)].agent;
    pick = label_[index(taken)].pick;
  }
  forget_labels();
}

}  // namespace mda
