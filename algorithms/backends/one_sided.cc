#include "algorithms/backends/one_sided.h"

#include <algorithm>
#include <utility>

namespace mda {
namespace {

constexpr std::int64_t kFar = INT64_MAX;

/// Longer price wars cost more than the searches they save.
constexpr std::int64_t kBidsPerChain = 32;

std::size_t index(std::int32_t i) { return static_cast<std::size_t>(i); }

}  // namespace

void OneSidedMatcher::grow() {
  const auto objects = problem_.unused.size();
  price_.insert(price_.end(), problem_.unused.begin() + static_cast<std::ptrdiff_t>(price_.size()),
                problem_.unused.end());
  owner_.resize(objects, -1);
  label_.resize(objects, Label{kFar, -1, -1});
  pick_.resize(problem_.alone.size(), kWaiting);
}

std::int64_t OneSidedMatcher::value(int agent) const {
  const std::int32_t pick = pick_[index(agent)];
  if (pick == kAlone) return problem_.alone[index(agent)];
  const Choice& choice = problem_.choices[index(pick)];
  return choice.cost - price_[index(choice.object)];
}

OneSidedMatcher::Best OneSidedMatcher::two_best(int agent) const {
  Best best{problem_.alone[index(agent)], kFar, kAlone, kAlone};
  const std::int32_t end = problem_.row_end[index(agent)];
  for (std::int32_t i = problem_.row_begin[index(agent)]; i < end; ++i) {
    const Choice& choice = problem_.choices[index(i)];
    const std::int64_t cost = choice.cost - price_[index(choice.object)];
    if (cost >= best.second) continue;
    if (cost < best.first) {
      best = {cost, best.first, i, best.first_pick};
    } else {
      best.second = cost;
      best.second_pick = i;
    }
  }
  return best;
}

void OneSidedMatcher::take(int agent, std::int32_t pick) {
  pick_[index(agent)] = pick;
  if (pick != kAlone) owner_[index(object_of(pick))] = agent;
}

void OneSidedMatcher::bid(int agent, std::int64_t step, std::int64_t& bids) {
  const auto is_open = [&](std::int32_t pick) {
    return pick == kAlone || owner_[index(object_of(pick))] < 0;
  };
  for (; bids > 0; --bids) {
    const Best best = two_best(agent);
    if (is_open(best.first_pick)) {
      if (is_own(agent, best.first_pick)) lower(agent, best.second - best.first);
      return take(agent, best.first_pick);
    }
    if (best.first == best.second && step == 0) {
      // Displacing the owner would leave all prices as they are, and could go on for ever.
      if (is_open(best.second_pick)) return take(agent, best.second_pick);
      break;
    }
    const std::int32_t object = object_of(best.first_pick);
    const std::int32_t displaced = owner_[index(object)];
    lower(object, best.second - best.first + step);
    take(agent, best.first_pick);
    pick_[index(displaced)] = kWaiting;
    agent = displaced;
  }
  waiting_.push_back(agent);
}

void OneSidedMatcher::push(std::int64_t distance, std::int32_t object) {
  heap_.push_back({distance, object});
  std::push_heap(heap_.begin(), heap_.end(),
                 [](const Reached& a, const Reached& b) { return a.distance > b.distance; });
}

OneSidedMatcher::Reached OneSidedMatcher::pop() {
  std::pop_heap(heap_.begin(), heap_.end(),
                [](const Reached& a, const Reached& b) { return a.distance > b.distance; });
  const Reached top = heap_.back();
  heap_.pop_back();
  return top;
}

void OneSidedMatcher::forget_labels() {
  for (const std::int32_t object : reached_) label_[index(object)].distance = kFar;
  reached_.clear();
  settled_.clear();
  heap_.clear();
}

/// `base` + cost - price is the distance of a choice of `agent`.
void OneSidedMatcher::scan(int agent, std::int64_t base, End& end) {
  const std::int64_t alone = base + problem_.alone[index(agent)];
  if (alone < end.distance) end = {alone, agent, kAlone};
  const std::int32_t row_end = problem_.row_end[index(agent)];
  for (std::int32_t i = problem_.row_begin[index(agent)]; i < row_end; ++i) {
    const Choice& choice = problem_.choices[index(i)];
    const std::int64_t distance = base + choice.cost - price_[index(choice.object)];
    if (distance >= end.distance) continue;
    Label& label = label_[index(choice.object)];
    if (owner_[index(choice.object)] < 0) {
      end = {distance, agent, i};
    } else if (distance < label.distance) {
      if (label.distance == kFar) reached_.push_back(choice.object);
      label = {distance, agent, i};
      push(distance, choice.object);
    }
  }
}

void OneSidedMatcher::augment(int agent, const End& end) {
  std::int32_t taker = end.agent;
  std::int32_t pick = end.pick;
  for (;;) {
    const std::int32_t before = pick_[index(taker)];
    take(taker, pick);
    if (taker == agent) return;
    const Label& label = label_[index(object_of(before))];
    taker = label.agent;
    pick = label.pick;
  }
}

std::size_t OneSidedMatcher::search(int agent) {
  End end{kFar, -1, kAlone};
  scan(agent, 0, end);
  while (!heap_.empty()) {
    const Reached top = pop();
    if (top.distance >= end.distance) break;
    if (top.distance > label_[index(top.object)].distance) continue;
    settled_.push_back(top.object);
    const std::int32_t owner = owner_[index(top.object)];
    scan(owner, top.distance - value(owner), end);
  }
  for (const std::int32_t object : settled_) {
    price_[index(object)] -= end.distance - label_[index(object)].distance;
  }
  augment(agent, end);
  const std::size_t moved = settled_.size();
  forget_labels();
  return moved;
}

void OneSidedMatcher::match_until(std::size_t most_moved) {
  auto agent = static_cast<int>(pick_.size());
  grow();
  std::size_t moved = 0;
  for (; agent < problem_.agents(); ++agent) {
    std::int64_t bids = kBidsPerChain;
    bid(agent, 0, bids);
    if (waiting_.empty() || moved > most_moved) continue;
    moved += search(waiting_.back());
    waiting_.pop_back();
  }
}

void OneSidedMatcher::match() { match_until(SIZE_MAX); }

void OneSidedMatcher::match_hard(std::int64_t step, double most_moves) {
  match_until(static_cast<std::size_t>(most_moves * problem_.objects()));
  if (!waiting_.empty()) auction(std::exchange(waiting_, {}), step);
}

}  // namespace mda
