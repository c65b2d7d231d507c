#include "harness/flow_paths.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "algorithms/catalog.h"
#include "harness/testing/flow_files.h"

namespace mda::testing {
namespace {

using Steps = std::vector<std::pair<int, int>>;

Steps sorted(Steps steps) {
  std::sort(steps.begin(), steps.end());
  return steps;
}

TEST(FlowPathsTest, PathsUseEveryArcWithFlowOnceAndLeadFromSourceToSink) {
  std::size_t paths_seen = 0;
  for (std::uint64_t seed = 1; seed <= 500; ++seed) {
    SCOPED_TRACE(seed);
    const FlowFile file = parse_flow_file(text_of(random_tracking_lines(seed)), "g.min");
    const FlowResult result = flow_codes().front().solve(file.graph);
    Steps used;
    for (std::size_t a = 0; a < result.flow.size(); ++a) {
      const FlowArc& arc = file.graph.arcs[a];
      if (result.flow[a] == 1) used.emplace_back(arc.tail, arc.head);
    }
    Steps walked;
    for (const std::vector<int>& path : paths_of_flow(file, result.flow)) {
      ++paths_seen;
      EXPECT_EQ(path.front(), file.graph.source);
      EXPECT_EQ(path.back(), file.graph.sink);
      for (std::size_t i = 1; i < path.size(); ++i) walked.emplace_back(path[i - 1], path[i]);
    }
    EXPECT_EQ(sorted(walked), sorted(used));
  }
  EXPECT_GT(paths_seen, 500U);
}

}  // namespace
}  // namespace mda::testing
