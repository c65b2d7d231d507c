#include "harness/flow_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <system_error>
#include <type_traits>
#include <utility>

#include "harness/errors.h"
#include "harness/flow_cycle.h"
#include "harness/word_lines.h"

namespace mda {
namespace {

constexpr int kMostNodes = 10'000'000;
constexpr int kMostArcs = 100'000'000;
/// What capacities, and what supplies, may sum to: any sum of both is then within 64 bits.
constexpr std::int64_t kMostUnits = INT64_MAX / 4;
constexpr std::size_t kTrackingWords = 4;
constexpr std::size_t kDimacsWords = 6;
constexpr int kFinestScale = 30;
constexpr int kCoarsestScale = 20;

std::size_t index(int i) { return static_cast<std::size_t>(i); }

/// The finest scale at which flow codes take `largest`, the largest cost of a graph.
std::optional<double> cost_scale(double largest, int nodes) {
  for (int power = kFinestScale; power >= kCoarsestScale; --power) {
    const double scaled = std::ldexp(largest, power);
    if (std::abs(scaled) >= std::ldexp(1.0, 62)) continue;
    const FlowGraph probe{nodes, {}, {{0, 0, 1, std::llround(scaled)}}};
    if (fits_flow_codes(probe)) return std::ldexp(1.0, power);
  }
  return std::nullopt;
}

class Parser {
 public:
  Parser(std::string_view text, const std::string& file) : lines_(text), file_(file) {}

  FlowFile parse() {
    while (lines_.next(line_)) {
      if (line_.count > 0 && !line_.words[0].starts_with('c')) read_line();
    }
    if (problem_line_ == 0) {
      fail_at(std::max<std::int64_t>(line_.number, 1), "there is no 'p min N M' line");
    }
    check_arc_count();
    if (arc_words_ == kTrackingWords) {
      finish_tracking();
    } else {
      finish_dimacs();
    }
    result_.line = std::move(arc_lines_);
    return std::move(result_);
  }

 private:
  struct NodeLine {
    std::int64_t line = 0;
    int node = 0;
    std::string_view supply;
  };

  [[noreturn]] void fail_at(std::int64_t line, std::string_view why) const {
    throw InputError(fmt::format("{}:{}: {}", file_, line, why));
  }
  [[noreturn]] void fail(std::string_view why) const { fail_at(line_.number, why); }

  /// A word of the file as messages show it: what is no printable ASCII as \x9f.
  static std::string shown(std::string_view word) {
    constexpr std::size_t kLongest = 40;
    std::string text;
    for (const char c : word.substr(0, kLongest)) {
      const auto byte = static_cast<unsigned char>(c);
      text += byte >= 0x20 && byte < 0x7f ? std::string(1, c) : fmt::format("\\x{:02x}", byte);
    }
    return word.size() <= kLongest ? text : text + "...";
  }

  /// A number that is the whole word; `at` is the line that messages name.
  template <typename Number>
  Number number(std::string_view word, std::string_view what, std::int64_t at) const {
    std::string_view digits = word;
    if (digits.size() > 1 && digits[0] == '+' && digits[1] != '-') digits.remove_prefix(1);
    Number value{};
    const char* const end = digits.data() + digits.size();
    const auto [stop, error] = std::from_chars(digits.data(), end, value);
    if (error == std::errc::result_out_of_range && stop == end) {
      fail_at(at, fmt::format("the {} '{}' is too large or too small", what, shown(word)));
    }
    if (error != std::errc{} || stop != end) {
      constexpr std::string_view kKind = std::is_integral_v<Number> ? "a whole number" : "a number";
      fail_at(at, fmt::format("the {} '{}' is not {}", what, shown(word), kKind));
    }
    if constexpr (std::is_floating_point_v<Number>) {
      if (!std::isfinite(value))
        fail_at(at, fmt::format("the {} '{}' is not finite", what, shown(word)));
    }
    return value;
  }

  template <typename Number>
  Number number(std::string_view word, std::string_view what) const {
    return number<Number>(word, what, line_.number);
  }

  int count(std::string_view word, std::string_view what, int least, int most) const {
    const auto value = number<std::int64_t>(word, what);
    if (value < least || value > most) {
      fail(fmt::format("the {} {} is not from {} to {}", what, value, least, most));
    }
    return static_cast<int>(value);
  }

  /// A node's number from 0.
  int node(std::string_view word) const {
    const auto value = number<std::int64_t>(word, "node");
    if (value < 1 || value > result_.graph.nodes) {
      fail(fmt::format("there is no node {}, they are numbered from 1 to {}", value,
                       result_.graph.nodes));
    }
    return static_cast<int>(value - 1);
  }

  void read_line() {
    const std::string_view kind = line_.words[0];
    if (kind == "p") {
      read_problem();
    } else if (kind != "n" && kind != "a") {
      fail(fmt::format("a line begins with c, p, n or a, not with '{}'", shown(kind)));
    } else if (problem_line_ == 0) {
      fail("the 'p min N M' line must come first");
    } else if (kind == "n") {
      read_node();
    } else {
      read_arc();
    }
  }

  void read_problem() {
    if (problem_line_ != 0) {
      fail(fmt::format("there is a 'p' line already, line {}", problem_line_));
    }
    if (line_.count != 4 || line_.words[1] != "min") fail("a 'p' line must be 'p min N M'");
    result_.graph.nodes = count(line_.words[2], "number of nodes", 1, kMostNodes);
    arcs_promised_ = count(line_.words[3], "number of arcs", 0, kMostArcs);
    result_.graph.supply.resize(index(result_.graph.nodes));
    problem_line_ = line_.number;
  }

  void read_node() {
    if (line_.count != 3) fail("an 'n' line must be 'n NODE SUPPLY'");
    node_lines_.push_back({line_.number, node(line_.words[1]), line_.words[2]});
  }

  void read_arc() {
    if (line_.count != kTrackingWords && line_.count != kDimacsWords) {
      fail("an 'a' line must be 'a TAIL HEAD COST' or 'a TAIL HEAD LOW CAP COST'");
    }
    if (arc_words_ == 0) arc_words_ = line_.count;
    if (line_.count != arc_words_) {
      fail("'a TAIL HEAD COST' and 'a TAIL HEAD LOW CAP COST' lines cannot be in one file");
    }
    FlowArc arc;
    arc.tail = node(line_.words[1]);
    arc.head = node(line_.words[2]);
    if (arc_words_ == kTrackingWords) {
      result_.lower.push_back(0);
      result_.cost.push_back(number<double>(line_.words[3], "cost"));
    } else {
      const auto low = number<std::int64_t>(line_.words[3], "lower bound");
      arc.capacity = capacity_above(low);
      arc.cost = number<std::int64_t>(line_.words[5], "cost");
      result_.graph.supply[index(arc.tail)] -= low;
      result_.graph.supply[index(arc.head)] += low;
      result_.lower.push_back(low);
      result_.cost.push_back(static_cast<double>(arc.cost));
    }
    result_.graph.arcs.push_back(arc);
    arc_lines_.push_back(line_.number);
  }

  std::int64_t capacity_above(std::int64_t low) {
    const auto capacity = number<std::int64_t>(line_.words[4], "capacity");
    if (capacity < 0) fail(fmt::format("the capacity {} is negative", capacity));
    if (low < 0) fail(fmt::format("the lower bound {} is negative", low));
    if (low > capacity) {
      fail(fmt::format("the lower bound {} is above the capacity {}", low, capacity));
    }
    if (capacity > kMostUnits - capacities_) {
      fail(fmt::format("the capacities up to here sum to more than {}", kMostUnits));
    }
    capacities_ += capacity;
    return capacity - low;
  }

  void check_arc_count() const {
    if (arc_lines_.size() == index(arcs_promised_)) return;
    const bool is_short = arc_lines_.size() < index(arcs_promised_);
    fail_at(is_short ? line_.number : arc_lines_[index(arcs_promised_)],
            fmt::format("line {} promises {} arcs, but the file has {}", problem_line_,
                        arcs_promised_, arc_lines_.size()));
  }

  void finish_dimacs() {
    std::vector<std::int64_t> line_of_node(index(result_.graph.nodes));
    std::int64_t supplied = 0;
    std::int64_t demanded = 0;
    for (const NodeLine& line : node_lines_) {
      std::int64_t& earlier = line_of_node[index(line.node)];
      if (earlier != 0) {
        fail_at(line.line,
                fmt::format("node {} has an 'n' line already, line {}", line.node + 1, earlier));
      }
      earlier = line.line;
      const auto supply = number<std::int64_t>(line.supply, "supply", line.line);
      if (supply > kMostUnits - supplied || supply < demanded - kMostUnits) {
        fail_at(line.line, fmt::format("the supplies up to here sum to more than {}", kMostUnits));
      }
      (supply > 0 ? supplied : demanded) += supply > 0 ? supply : -supply;
      result_.graph.supply[index(line.node)] += supply;
    }
    if (supplied != demanded) {
      fail_at(node_lines_.back().line,
              fmt::format("the supplies do not balance: {} units are supplied and {} demanded",
                          supplied, demanded));
    }
    result_.supplied = supplied;
  }

  void finish_tracking() {
    for (const NodeLine& line : node_lines_) {
      static_cast<void>(number<double>(line.supply, "supply", line.line));
    }
    if (node_lines_.size() < 2) {
      fail_at(line_.number,
              fmt::format("there must be two 'n' lines, which name the source and the "
                          "sink, but the file has {}",
                          node_lines_.size()));
    }
    if (node_lines_.size() > 2) {
      fail_at(node_lines_[2].line,
              "the source and the sink have their 'n' lines already, there can be no third one");
    }
    if (node_lines_[0].node == node_lines_[1].node) {
      fail_at(node_lines_[1].line,
              fmt::format("node {} cannot be both source and sink", node_lines_[1].node + 1));
    }
    result_.graph.source = node_lines_[0].node;
    result_.graph.sink = node_lines_[1].node;
    refuse_cycles();
    scale_costs();
  }

  void refuse_cycles() const {
    const auto arc = arc_that_closes_a_cycle(result_.graph);
    if (arc) fail_at(arc_lines_[*arc], "this arc closes a cycle, which tracks cannot have");
  }

  void scale_costs() {
    const auto is_smaller = [](double a, double b) { return std::abs(a) < std::abs(b); };
    const auto largest = std::max_element(result_.cost.begin(), result_.cost.end(), is_smaller);
    const auto scale = cost_scale(*largest, result_.graph.nodes);
    if (!scale) {
      const auto arc = static_cast<std::size_t>(largest - result_.cost.begin());
      fail_at(arc_lines_[arc], fmt::format("the cost {} is too large for a graph of {} nodes",
                                           *largest, result_.graph.nodes));
    }
    result_.cost_scale = *scale;
    for (std::size_t a = 0; a < result_.cost.size(); ++a) {
      result_.graph.arcs[a].cost = std::llround(result_.cost[a] * *scale);
    }
  }

  WordLines lines_;
  const std::string& file_;
  WordLine line_;
  FlowFile result_;
  std::int64_t problem_line_ = 0;  ///< 0: none yet
  int arcs_promised_ = 0;
  std::size_t arc_words_ = 0;  ///< of an arc line; 0: none yet
  std::int64_t capacities_ = 0;
  std::vector<NodeLine> node_lines_;
  std::vector<std::int64_t> arc_lines_;
};

}  // namespace

FlowFile parse_flow_file(std::string_view text, const std::string& file) {
  return Parser(text, file).parse();
}

}  // namespace mda
