#include "algorithms/certified/links.h"

#include <algorithm>

namespace mda {
namespace {

constexpr std::size_t index(int i) noexcept { return static_cast<std::size_t>(i); }

}  // namespace

void LinkFinder::find(const Packing& packing, Links& links) {
  links.tree_begin.assign(1, 0);
  links.tree.clear();
  links.row.clear();
  links.node.assign(1, {Links::kTop, -1});
  links.node_begin.assign(1, 1);
  links.node_of_column.clear();
  links.row_begin.assign(index(packing.rows()) + 1, 0);
  last_link_.assign(index(packing.rows()), -1);
  for (int t = 0; t < packing.trees(); ++t) {
    add_tree(packing, t, links);
    links.tree_begin.push_back(links.count());
    links.node_begin.push_back(links.nodes());
  }
  sort_by_row(links);
}

void LinkFinder::add_tree(const Packing& packing, int tree, Links& links) {
  const int first_link = links.count();
  path_.resize(std::max(path_.size(), std::size_t{1}));
  path_[0] = Links::kTop;
  std::span<const int> before;
  for (int j = packing.tree_begin[index(tree)]; j < packing.tree_begin[index(tree) + 1]; ++j) {
    const auto rows = packing.rows_of(j);
    const std::size_t most = std::min(before.size(), rows.size());
    std::size_t shared = 0;
    while (shared < most && before[shared] == rows[shared]) ++shared;
    if (path_.size() <= rows.size()) path_.resize(rows.size() + 1);
    for (std::size_t k = shared; k < rows.size(); ++k) {
      path_[k + 1] = links.nodes();
      links.node.push_back({path_[k], link_of(tree, rows[k], first_link, links)});
    }
    links.node_of_column.push_back(path_[rows.size()]);
    before = rows;
  }
}

int LinkFinder::link_of(int tree, int row, int first_link, Links& links) {
  int& link = last_link_[index(row)];
  if (link >= first_link) return link;
  link = links.count();
  links.row.push_back(row);
  links.tree.push_back(tree);
  ++links.row_begin[index(row) + 1];
  return link;
}

void LinkFinder::sort_by_row(Links& links) {
  for (std::size_t r = 1; r < links.row_begin.size(); ++r) {
    links.row_begin[r] += links.row_begin[r - 1];
  }
  links.by_row.resize(links.row.size());
  next_.assign(links.row_begin.begin(), links.row_begin.end() - 1);
  for (int l = 0; l < links.count(); ++l) {
    links.by_row[index(next_[index(links.row[index(l)])]++)] = l;
  }
}

}  // namespace mda
