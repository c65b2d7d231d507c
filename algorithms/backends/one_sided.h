// One-sided assignment: every agent takes one object or stays alone, every object serves at most
// one agent. The form to which flows of disjoint paths reduce, and its exact solver.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace mda {

/// An object that an agent may take.
struct Choice {
  std::int64_t cost;
  std::int32_t object;
  std::int32_t arc;  ///< the caller's own number; never read here
};

/// Minimise the sum, over agents, of the cost of their choice or of `alone`, plus the sum over
/// objects that nobody takes of `unused`. The dual: maximise sum u + sum q with
///   u_j + q_o <= cost(j, o),  u_j <= alone_j,  q_o <= unused_o.
/// Numbers must be so small that eight of them add up within 64 bits.
struct OneSidedProblem {
  std::vector<std::int64_t> alone;   ///< per agent
  std::vector<std::int64_t> unused;  ///< per object
  /// Agent j's choices are choices[row_begin[j] .. row_end[j] - 1]; between rows may be gaps.
  std::vector<std::int32_t> row_begin;
  std::vector<std::int32_t> row_end;
  std::vector<Choice> choices;

  [[nodiscard]] int agents() const noexcept { return static_cast<int>(alone.size()); }
  [[nodiscard]] int objects() const noexcept { return static_cast<int>(unused.size()); }
  [[nodiscard]] std::span<const Choice> row(int agent) const noexcept {
    const auto j = static_cast<std::size_t>(agent);
    const auto begin = static_cast<std::size_t>(row_begin[j]);
    return {choices.data() + begin, static_cast<std::size_t>(row_end[j]) - begin};
  }
};

/// Agent after agent bids with exact increments (the augmenting row reduction of Jonker and
/// Volgenant 1987); who is displaced too often gets a shortest augmenting path, which ends at the
/// nearest free object or lone agent. Prices stay dual feasible throughout. An agent that takes the
/// object of its own number while that is free lowers its price at once, as far as it can and still
/// prefer it: where all do so in the order of time, prices become distances. Worst case O(agents x
/// choices x log objects); on tracking graphs nearly linear.
class OneSidedMatcher {
 public:
  static constexpr std::int32_t kAlone = -1;
  static constexpr std::int32_t kWaiting = -2;  ///< never left by match() and match_hard()

  /// The problem must outlive the matcher.
  explicit OneSidedMatcher(const OneSidedProblem& problem) : problem_(problem) {}

  /// Matches all agents and objects that the problem got since the last call; optimal for all of
  /// them. Every agent's row must have been there, unchanged, when it was first matched.
  void match();

  /// The same; but once searches have moved `most_moves` prices per object, goes over to an auction
  /// with increments of `step` (at least 1) and a repair from both sides. For a problem that is
  /// matched once and whole.
  void match_hard(std::int64_t step, double most_moves);

  /// Position in problem.choices, or kAlone.
  [[nodiscard]] std::int32_t pick(int agent) const {
    return pick_[static_cast<std::size_t>(agent)];
  }
  /// The agent that has the object, or -1.
  [[nodiscard]] int owner(int object) const { return owner_[static_cast<std::size_t>(object)]; }
  /// The dual q of an object.
  [[nodiscard]] std::int64_t price(int object) const {
    return price_[static_cast<std::size_t>(object)];
  }
  /// The dual u of a matched agent.
  [[nodiscard]] std::int64_t value(int agent) const;

 private:
  struct Best {
    std::int64_t first;
    std::int64_t second;
    std::int32_t first_pick;
    std::int32_t second_pick;
  };
  /// How a search reached an object.
  struct Label {
    std::int64_t distance;
    std::int32_t agent;
    std::int32_t pick;  ///< of `agent`
  };
  struct Reached {
    std::int64_t distance;
    std::int32_t object;
  };
  /// Where a search ends so far.
  struct End {
    std::int64_t distance;
    std::int32_t agent;
    std::int32_t pick;
  };

  [[nodiscard]] std::int32_t object_of(std::int32_t pick) const {
    return problem_.choices[static_cast<std::size_t>(pick)].object;
  }
  void grow();
  [[nodiscard]] Best two_best(int agent) const;
  void take(int agent, std::int32_t pick);
  [[nodiscard]] bool is_own(int agent, std::int32_t pick) const {
    return pick != kAlone && object_of(pick) == agent;
  }
  void lower(int object, std::int64_t by) { price_[static_cast<std::size_t>(object)] -= by; }
  /// Matches new agents in turn; once searches have moved more than `most_moved` prices, agents
  /// that would need one are left in waiting_.
  void match_until(std::size_t most_moved);
  /// Lets an agent, and those it displaces, choose; whoever still waits at the end goes to
  /// waiting_.
  void bid(int agent, std::int64_t step, std::int64_t& bids);
  /// Shortest augmenting path of an agent that waits. Returns the objects whose price it moved.
  std::size_t search(int agent);
  void scan(int agent, std::int64_t base, End& end);
  void augment(int agent, const End& end);
  void push(std::int64_t distance, std::int32_t object);
  [[nodiscard]] Reached pop();
  void forget_labels();

  // The repair, one_sided_repair.cc.
  void auction(std::vector<std::int32_t> agents, std::int64_t step);
  void release_if_not_best();
  void transpose();
  void reprice(int object);
  void scan_object(int object, std::int64_t distance, End& end);

  const OneSidedProblem& problem_;
  std::vector<std::int64_t> price_;  ///< q per object
  std::vector<std::int32_t> owner_;  ///< per object
  std::vector<std::int32_t> pick_;   ///< per agent
  std::vector<std::int32_t> waiting_;
  std::vector<Label> label_;           ///< per object; distance is kFar outside a search
  std::vector<std::int32_t> reached_;  ///< objects with a label
  std::vector<std::int32_t> settled_;  ///< objects whose distance is final
  std::vector<Reached> heap_;
  std::vector<std::int32_t> column_begin_;  ///< per object, into column_
  std::vector<std::int32_t> column_agent_;
  std::vector<std::int32_t> column_pick_;
};

}  // namespace mda
