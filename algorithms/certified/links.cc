#include "algorithms/certified/links.h"

namespace mda {
namespace {

constexpr std::size_t index(int i) noexcept { return static_cast<std::size_t>(i); }

}  // namespace

Links links_of(const Packing& packing) {
  Links links;
  links.of_entry.reserve(packing.row.size());
  links.row_begin.assign(index(packing.rows()) + 1, 0);
  std::vector<int> last_link(index(packing.rows()), -1);
  for (int t = 0; t < packing.trees(); ++t) {
    const int first = links.count();
    const int begin = packing.begin[index(packing.tree_begin[index(t)])];
    const int end = packing.begin[index(packing.tree_begin[index(t) + 1])];
    for (int e = begin; e < end; ++e) {
      const int r = packing.row[index(e)];
      int& link = last_link[index(r)];
      if (link < first) {
        link = links.count();
        links.row.push_back(r);
        links.tree.push_back(t);
        ++links.row_begin[index(r) + 1];
      }
      links.of_entry.push_back(link);
    }
    links.tree_begin.push_back(links.count());
  }
  for (int r = 0; r < packing.rows(); ++r)
    links.row_begin[index(r) + 1] += links.row_begin[index(r)];
  links.by_row.resize(links.row.size());
  std::vector<int>& next = last_link;
  next.assign(links.row_begin.begin(), links.row_begin.end() - 1);
  for (int l = 0; l < links.count(); ++l) {
    links.by_row[index(next[index(links.row[index(l)])]++)] = l;
  }
  return links;
}

}  // namespace mda
