#include <algorithm>
#include <set>

#include "algorithms/certified/cuts.h"

namespace mda {
namespace {

constexpr std::size_t index(int i) noexcept { return static_cast<std::size_t>(i); }
constexpr int kMostMembers = 64;
constexpr double kLeastBroken = 1e-3;

/// Columns of which any two share a row. Every row knows as bits which members use it.
class Clique {
 public:
  explicit Clique(const Packing& packing) : packing_(packing), users_(index(packing.rows()), 0) {}

  void clear() {
    for (const int j : members_) {
      for (const int r : packing_.rows_of(j)) users_[index(r)] = 0;
    }
    members_.clear();
    all_ = 0;
  }

  [[nodiscard]] bool takes(int column) const {
    if (std::ssize(members_) == kMostMembers) return false;
    std::uint64_t rivals = 0;
    for (const int r : packing_.rows_of(column)) rivals |= users_[index(r)];
    return rivals == all_;
  }

  void add(int column) {
    const std::uint64_t bit = std::uint64_t{1} << members_.size();
    for (const int r : packing_.rows_of(column)) users_[index(r)] |= bit;
    all_ |= bit;
    members_.push_back(column);
  }

  [[nodiscard]] const std::vector<int>& members() const { return members_; }

 private:
  const Packing& packing_;
  std::vector<std::uint64_t> users_;
  std::vector<int> members_;
  std::uint64_t all_ = 0;
};

}  // namespace

std::vector<Cut> clique_cuts(const Packing& packing, std::span<const char> alive,
                             std::span<const Steps> reduced, const FractionalPoint& x, int most) {
  FractionalPoint by_value = x;
  std::ranges::stable_sort(by_value, std::greater<>{}, &FractionalPoint::value_type::second);
  std::vector<int> by_reduced;
  std::vector<Cut> cuts;
  std::set<std::vector<int>> found;
  Clique clique(packing);
  for (const auto& [seed, seed_value] : by_value) {
    if (std::ssize(cuts) == most) break;
    clique.clear();
    clique.add(seed);
    double value = seed_value;
    for (const auto& [column, column_value] : by_value) {
      if (column == seed || !clique.takes(column)) continue;
      clique.add(column);
      value += column_value;
    }
    if (value < 1.0 + kLeastBroken) continue;
    std::vector<int> core = clique.members();
    std::ranges::sort(core);
    if (!found.insert(core).second) continue;
    if (by_reduced.empty()) {
      for (int j = 0; j < packing.columns(); ++j) {
        if (alive[index(j)] != 0) by_reduced.push_back(j);
      }
      std::ranges::stable_sort(by_reduced, {}, [&](int j) { return reduced[index(j)]; });
    }
    for (const int j : by_reduced) {
      if (!std::ranges::binary_search(core, j) && clique.takes(j)) clique.add(j);
    }
    Cut& cut = cuts.emplace_back();
    cut.kind = Cut::Kind::kClique;
    for (const int j : clique.members()) cut.columns.emplace_back(j, 1);
  }
  return cuts;
}

}  // namespace mda
