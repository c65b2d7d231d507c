#include "algorithms/certified/links.h"

namespace mda {
namespace {

constexpr std::size_t index(int i) noexcept { return static_cast<std::size_t>(i); }

/// Tree after tree, column after column.
class LinkFinder {
 public:
  explicit LinkFinder(const Packing& packing)
      : packing_(packing), last_link_(index(packing.rows()), -1) {
    links_.row_begin.assign(index(packing.rows()) + 1, 0);
    links_.node_of_column.reserve(packing.cost.size());
    links_.parent.reserve(2 * packing.cost.size());
    links_.link.reserve(2 * packing.cost.size());
  }

  Links run() {
    for (int t = 0; t < packing_.trees(); ++t) {
      add_tree(t);
      links_.tree_begin.push_back(links_.count());
      links_.node_begin.push_back(links_.nodes());
    }
    sort_by_row();
    return std::move(links_);
  }

 private:
  void add_tree(int tree) {
    const int first_link = links_.count();
    path_.assign(1, Links::kTop);
    std::span<const int> before;
    for (int j = packing_.tree_begin[index(tree)]; j < packing_.tree_begin[index(tree) + 1]; ++j) {
      const auto rows = packing_.rows_of(j);
      std::size_t shared = 0;
      while (shared < before.size() && shared < rows.size() && before[shared] == rows[shared]) {
        ++shared;
      }
      path_.resize(shared + 1);
      for (std::size_t k = shared; k < rows.size(); ++k) {
        links_.parent.push_back(path_.back());
        links_.link.push_back(link_of(tree, rows[k], first_link));
        path_.push_back(links_.nodes() - 1);
      }
      links_.node_of_column.push_back(path_.back());
      before = rows;
    }
  }

  int link_of(int tree, int row, int first_link) {
    int& link = last_link_[index(row)];
    if (link >= first_link) return link;
    link = links_.count();
    links_.row.push_back(row);
    links_.tree.push_back(tree);
    ++links_.row_begin[index(row) + 1];
    return link;
  }

  void sort_by_row() {
    for (int r = 0; r < packing_.rows(); ++r) {
      links_.row_begin[index(r) + 1] += links_.row_begin[index(r)];
    }
    links_.by_row.resize(links_.row.size());
    std::vector<int> next(links_.row_begin.begin(), links_.row_begin.end() - 1);
    for (int l = 0; l < links_.count(); ++l) {
      links_.by_row[index(next[index(links_.row[index(l)])]++)] = l;
    }
  }

  const Packing& packing_;
  Links links_;
  std::vector<int> last_link_;  // per row
  std::vector<int> path_;       // of the column before
};

}  // namespace

Links links_of(const Packing& packing) { return LinkFinder(packing).run(); }

}  // namespace mda
