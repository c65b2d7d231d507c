#include "algorithms/certified/working_set.h"

#include <algorithm>
#include <bit>
#include <limits>

namespace mda {
namespace {

constexpr std::size_t index(int i) noexcept { return static_cast<std::size_t>(i); }
constexpr int kWordBits = 64;
constexpr int kUnknown = -1;

int words_for(int columns) { return (columns + kWordBits - 1) / kWordBits; }

bool has(const std::uint64_t* mask, int i) {
  return ((mask[i / kWordBits] >> (i % kWordBits)) & 1U) != 0;
}

/// The least of `reduced` where `mask` (or, flipped, its complement) has a bit.
Steps least_of(const Steps* reduced, int size, const std::uint64_t* mask, std::uint64_t flip) {
  Steps least = std::numeric_limits<Steps>::max();
  for (int first = 0; first < size; first += kWordBits) {
    std::uint64_t word = mask[first / kWordBits] ^ flip;
    if (size - first < kWordBits) word &= (std::uint64_t{1} << (size - first)) - 1;
    for (; word != 0; word &= word - 1) {
      least = std::min(least, reduced[first + std::countr_zero(word)]);
    }
  }
  return least;
}

}  // namespace

void WorkingSet::start(const Packing& packing, const Links& links) {
  packing_ = &packing;
  links_ = &links;
  is_in_.assign(packing.cost.size(), 0);
  column_.resize(packing.cost.size());
  reduced_.resize(packing.cost.size());
  size_.assign(index(packing.trees()), 0);
  best_.assign(index(packing.trees()), kUnknown);
  is_used_.assign(links.row.size(), 0);
  by_row_.resize(links.row.size());
  used_of_.assign(index(packing.rows()), 0);
  mask_begin_.clear();
  std::size_t words = 0;
  for (int t = 0; t < packing.trees(); ++t) {
    const int columns = packing.tree_begin[index(t) + 1] - packing.tree_begin[index(t)];
    for (int l = links.tree_begin[index(t)]; l < links.tree_begin[index(t) + 1]; ++l) {
      mask_begin_.push_back(words);
      words += index(words_for(columns));
    }
  }
  masks_.assign(words, 0);
}

bool WorkingSet::widen(int tree, std::span<const Steps> reduced, Steps most) {
  const int before = size_[index(tree)];
  const int end = packing_->tree_begin[index(tree) + 1];
  for (int j = packing_->tree_begin[index(tree)]; j < end; ++j) {
    if (reduced[index(j)] <= most && is_in_[index(j)] == 0) add(tree, j, reduced[index(j)]);
  }
  if (size_[index(tree)] == before) return false;
  best_[index(tree)] = kUnknown;
  return true;
}

void WorkingSet::add(int tree, int column, Steps reduced) {
  const int i = size_[index(tree)]++;
  const int place = packing_->tree_begin[index(tree)] + i;
  is_in_[index(column)] = 1;
  column_[index(place)] = column;
  reduced_[index(place)] = reduced;
  int node = links_->node_of_column[index(column)];
  for (; node != Links::kTop; node = links_->node[index(node)].parent) {
    const int link = links_->node[index(node)].link;
    masks_[mask_begin_[index(link)] + index(i / kWordBits)] |= std::uint64_t{1} << (i % kWordBits);
    if (is_used_[index(link)] != 0) continue;
    is_used_[index(link)] = 1;
    const int row = links_->row[index(link)];
    by_row_[index(links_->row_begin[index(row)] + used_of_[index(row)]++)] = link;
  }
}

const std::uint64_t* WorkingSet::mask(int link) const {
  return masks_.data() + mask_begin_[index(link)];
}

void WorkingSet::find_best(int tree) {
  const Steps* first = reduced_.data() + packing_->tree_begin[index(tree)];
  best_[index(tree)] =
      static_cast<int>(std::min_element(first, first + size_[index(tree)]) - first);
}

Steps WorkingSet::worth(int link) {
  const int tree = links_->tree[index(link)];
  if (best_[index(tree)] == kUnknown) find_best(tree);
  const Steps* reduced = reduced_.data() + packing_->tree_begin[index(tree)];
  const int best = best_[index(tree)];
  const std::uint64_t* bits = mask(link);
  const bool best_uses = has(bits, best);
  const Steps other =
      least_of(reduced, size_[index(tree)], bits, best_uses ? ~std::uint64_t{0} : 0);
  return best_uses ? std::min<Steps>(0, other) - reduced[best]
                   : std::min<Steps>(0, reduced[best]) - other;
}

void WorkingSet::move(int link, Steps change) {
  const int tree = links_->tree[index(link)];
  Steps* reduced = reduced_.data() + packing_->tree_begin[index(tree)];
  const std::uint64_t* bits = mask(link);
  int least = -1;  // of the columns that move
  for (int w = 0; w < words_for(size_[index(tree)]); ++w) {
    for (std::uint64_t word = bits[w]; word != 0; word &= word - 1) {
      const int i = w * kWordBits + std::countr_zero(word);
      reduced[i] += change;
      if (least < 0 || reduced[i] < reduced[least]) least = i;
    }
  }
  int& best = best_[index(tree)];
  if (best == kUnknown) return;
  if (change < 0) {
    if (reduced[least] < reduced[best]) best = least;
  } else if (has(bits, best)) {
    best = kUnknown;
  }
}

}  // namespace mda
