#include "harness/flow_file.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "algorithms/testing/draw.h"
#include "harness/errors.h"
#include "harness/testing/flow_files.h"

namespace mda::testing {
namespace {

FlowFile parsed(const std::string& text) { return parse_flow_file(text, "g.min"); }

TEST(FlowFileTest, ReadsDimacsAndShiftsLowerBounds) {
  const FlowFile file =
      parsed("c a graph\np min 3 2\nn 1 4\n\nn 3 -4\na 1 3 0 5 -7\n  a\t2 1  2 9 3 \n");
  EXPECT_FALSE(file.is_tracking());
  EXPECT_EQ(file.graph.nodes, 3);
  EXPECT_EQ(file.graph.supply, (std::vector<std::int64_t>{6, -2, -4}));
  EXPECT_EQ(file.graph.sink, -1);
  ASSERT_EQ(file.graph.arcs.size(), 2U);
  EXPECT_EQ(file.graph.arcs[0].tail, 0);
  EXPECT_EQ(file.graph.arcs[0].head, 2);
  EXPECT_EQ(file.graph.arcs[0].capacity, 5);
  EXPECT_EQ(file.graph.arcs[0].cost, -7);
  EXPECT_EQ(file.graph.arcs[1].tail, 1);
  EXPECT_EQ(file.graph.arcs[1].head, 0);
  EXPECT_EQ(file.graph.arcs[1].capacity, 7);
  EXPECT_EQ(file.lower, (std::vector<std::int64_t>{0, 2}));
  EXPECT_EQ(file.cost, (std::vector<double>{-7.0, 3.0}));
  EXPECT_EQ(file.supplied, 4);
}

TEST(FlowFileTest, ReadsTheTrackingDialectWhateverItsSupplies) {
  for (const char* supplies : {"n 3 0\nn 1 0\n", "n 3 2\nn 1 -2\n", "n 3 -1.5\nn 1 7\n"}) {
    const FlowFile file =
        parsed("p min 3 2\n" + std::string(supplies) + "a 3 2 -1.25\na 2 1 +2e-3\n");
    EXPECT_TRUE(file.is_tracking());
    EXPECT_EQ(file.graph.source, 2);
    EXPECT_EQ(file.graph.sink, 0);
    EXPECT_EQ(file.graph.supply, (std::vector<std::int64_t>{0, 0, 0}));
    EXPECT_EQ(file.cost, (std::vector<double>{-1.25, 2e-3}));
    EXPECT_EQ(file.lower, (std::vector<std::int64_t>{0, 0}));
    EXPECT_EQ(file.cost_scale, 0x1p30);
    EXPECT_EQ(file.graph.arcs[0].capacity, 1);
    EXPECT_EQ(file.graph.arcs[0].cost, -1.25 * 0x1p30);
    EXPECT_EQ(file.graph.arcs[1].cost, 2147484);  // 2e-3 * 2^30 = 2147483.648
  }
}

TEST(FlowFileTest, LineEndsAndTheLastOneDoNotMatter) {
  const std::string text = "p min 2 1\nn 1 0\nn 2 0\na 1 2 -1\n";
  std::string carriage;
  for (const char c : text) carriage += c == '\n' ? "\r\n" : std::string(1, c);
  for (const std::string& other :
       {carriage, text.substr(0, text.size() - 1), carriage.substr(0, carriage.size() - 2)}) {
    const FlowFile file = parsed(other);
    EXPECT_EQ(file.graph.source, 0);
    EXPECT_EQ(file.cost, std::vector<double>{-1.0});
  }
}

TEST(FlowFileTest, GraphsWithoutArcsAreDimacs) {
  EXPECT_FALSE(parsed("p min 2 0\nn 1 0\nn 2 0\n").is_tracking());
  EXPECT_EQ(parsed("p min 2 0\nn 1 3\nn 2 -3\n").supplied, 3);
}

TEST(FlowFileTest, LargeCostsAreScaledLessUntilNothingFits) {
  const auto scale_of = [](const std::string& cost) {
    return parsed("p min 3 1\nn 1 0\nn 3 0\na 1 3 " + cost + "\n").cost_scale;
  };
  // 3 nodes leave (2^63 - 1) / 64, a little less than 2^57, for costs.
  EXPECT_EQ(scale_of("-1.3e8"), 0x1p30);  // a little less than 2^27
  EXPECT_EQ(scale_of("134217728"), 0x1p29);
  EXPECT_EQ(scale_of("-1.3e11"), 0x1p20);  // a little less than 2^37
  EXPECT_THROW(static_cast<void>(scale_of("137438953472")), InputError);
  EXPECT_THROW(static_cast<void>(scale_of("-1e300")), InputError);
}

struct Malformed {
  std::string text;
  std::string message;  ///< how it begins after the file's name
};

std::string tracking(const std::string& arc) { return "p min 3 1\nn 1 0\nn 3 0\n" + arc + "\n"; }

std::string dimacs(const std::string& arc) { return "p min 3 1\nn 1 1\nn 3 -1\n" + arc + "\n"; }

std::vector<Malformed> malformed_heads() {
  return {
      {"", "1: there is no 'p min N M' line"},
      {"c nothing\n\n", "2: there is no 'p min N M' line"},
      {"n 1 0\np min 2 0\n", "1: the 'p min N M' line must come first"},
      {"c\na 1 2 3\n", "2: the 'p min N M' line must come first"},
      {"p min 2 0\nc\np min 2 0\n", "3: there is a 'p' line already, line 1"},
      {"p max 2 0\n", "1: a 'p' line must be"},
      {"p min 2\n", "1: a 'p' line must be"},
      {"p min 2 0 0\n", "1: a 'p' line must be"},
      {"p min 0 0\n", "1: the number of nodes 0 is not from 1"},
      {"p min -2 0\n", "1: the number of nodes -2 is not from 1"},
      {"p min 2 -1\n", "1: the number of arcs -1 is not from 0"},
      {"p min 2000000000 0\n", "1: the number of nodes 2000000000 is not from 1"},
      {"p min 2 2000000000\n", "1: the number of arcs 2000000000 is not from 0"},
      {"p min 99999999999999999999 0\n", "1: the number of nodes '99999999999999999999' is too"},
      {"p min two 0\n", "1: the number of nodes 'two' is not a whole number"},
      {"p min 2.0 0\n", "1: the number of nodes '2.0' is not a whole number"},
      {"hello\n", "1: a line begins with c, p, n or a, not with 'hello'"},
      {std::string("\0\0\0", 3), "1: a line begins with"},
      {"p min 2 0\n\xff\xfe\n", "2: a line begins with"},
      {"{\"schema\": 1}", "1: a line begins with"},
  };
}

std::vector<Malformed> malformed_arcs() {
  return {
      {tracking("a 1 3"), "4: an 'a' line must be"},
      {tracking("a 1 3 0 1"), "4: an 'a' line must be"},
      {tracking("a 1 3 0 1 5 6"), "4: an 'a' line must be"},
      {tracking("a 1 3 5 x y z w"), "4: an 'a' line must be"},
      {tracking("a 0 3 5"), "4: there is no node 0, they are numbered from 1 to 3"},
      {tracking("a 1 4 5"), "4: there is no node 4"},
      {tracking("a -1 3 5"), "4: there is no node -1"},
      {tracking("a 1 1e0 5"), "4: the node '1e0' is not a whole number"},
      {tracking("a 1 3 five"), "4: the cost 'five' is not a number"},
      {tracking("a 1 3 5x"), "4: the cost '5x' is not a number"},
      {tracking("a 1 3 +-5"), "4: the cost '+-5' is not a number"},
      {tracking("a 1 3 0x5"), "4: the cost '0x5' is not a number"},
      {tracking("a 1 3 nan"), "4: the cost 'nan' is not finite"},
      {tracking("a 1 3 -inf"), "4: the cost '-inf' is not finite"},
      {tracking("a 1 3 1e999"), "4: the cost '1e999' is too large"},
      {tracking("a 1 3 1e100"), "4: the cost 1e+100 is too large for a graph of 3 nodes"},
      {tracking("a 2 2 1"), "4: this arc closes a cycle"},
      {dimacs("a 1 3 0 -1 5"), "4: the capacity -1 is negative"},
      {dimacs("a 1 3 -1 1 5"), "4: the lower bound -1 is negative"},
      {dimacs("a 1 3 2 1 5"), "4: the lower bound 2 is above the capacity 1"},
      {dimacs("a 1 3 0 1.0 5"), "4: the capacity '1.0' is not a whole number"},
      {dimacs("a 1 3 x 1 5"), "4: the lower bound 'x' is not a whole number"},
      {dimacs("a 1 3 0 1 0.5"), "4: the cost '0.5' is not a whole number"},
      {dimacs("a 1 3 0 1 nan"), "4: the cost 'nan' is not a whole number"},
      {dimacs("a 1 3 0 1 9223372036854775808"), "4: the cost '9223372036854775808' is too large"},
      {dimacs("a 1 3 0 9223372036854775807 1"), "4: the capacities up to here sum to more than"},
      {dimacs("a 1 5 0 1 5"), "4: there is no node 5"},
      {"p min 3 2\nn 1 0\nn 3 0\na 1 3 5\na 1 3 0 1 5\n", "5: 'a TAIL HEAD COST' and"},
      {"p min 3 2\na 1 3 0 1 5\nc\na 1 3 5\n", "4: 'a TAIL HEAD COST' and"},
  };
}

std::vector<Malformed> malformed_wholes() {
  return {
      {"p min 3 2\nn 1 0\nn 3 0\na 1 3 5\n", "4: line 1 promises 2 arcs, but the file has 1"},
      {"p min 3 1\na 1 3 0 1 5\nc\na 1 3 0 1 5\na 1 2 0 1 5\n",
       "4: line 1 promises 1 arcs, but the file has 3"},
      {"p min 3 1\na 1 3 5\n", "2: there must be two 'n' lines"},
      {"p min 3 1\nn 1 0\na 1 3 5\n", "3: there must be two 'n' lines"},
      {"p min 3 1\nn 1 0\nn 3 0\nn 2 0\na 1 3 5\n", "4: the source and the sink have"},
      {"p min 3 1\nn 1 0\nn 1 0\na 1 3 5\n", "3: node 1 cannot be both source and sink"},
      {"p min 3 1\nn 1 0\nn 3 x\na 1 3 5\n", "3: the supply 'x' is not a number"},
      {"p min 3 1\nn 1 0\nn 4 0\na 1 3 5\n", "3: there is no node 4"},
      {"p min 3 1\nn 1\nn 3 0\na 1 3 5\n", "2: an 'n' line must be"},
      {"p min 3 1\nn 1 0 0\nn 3 0\na 1 3 5\n", "2: an 'n' line must be"},
      {"p min 3 1\nn 1 1\na 1 3 0 1 5\n", "2: the supplies do not balance: 1 units are supplied"},
      {"p min 3 1\nn 1 1\nc\nn 3 -2\na 1 3 0 1 5\n", "4: the supplies do not balance"},
      {"p min 3 1\nn 1 1\nn 1 -1\na 1 3 0 1 5\n", "3: node 1 has an 'n' line already, line 2"},
      {"p min 3 1\nn 1 0.5\nn 3 -0.5\na 1 3 0 1 5\n", "2: the supply '0.5' is not a whole number"},
      {"p min 3 1\nn 1 0\nn 3 -9223372036854775808\na 1 3 0 1 5\n",
       "3: the supplies up to here sum to more than"},
      {"p min 5 6\nn 1 0\nn 5 0\na 1 2 1\nc\na 2 3 1\na 4 2 1\nc\na 3 4 1\na 4 5 1\na 1 5 1\n",
       "9: this arc closes a cycle"},
  };
}

TEST(FlowFileTest, MalformedGraphsAreRefusedWithFileAndLine) {
  for (const auto& list : {malformed_heads(), malformed_arcs(), malformed_wholes()}) {
    for (const Malformed& malformed : list) {
      try {
        static_cast<void>(parse_flow_file(malformed.text, "folder/g.min"));
        ADD_FAILURE() << "taken: " << malformed.text;
      } catch (const InputError& error) {
        const std::string message = error.what();
        EXPECT_TRUE(message.starts_with("folder/g.min:" + malformed.message))
            << message << "\n for " << malformed.text;
        EXPECT_EQ(message.find('\n'), std::string::npos) << message;
      }
    }
  }
}

TEST(FlowFileTest, CyclesAreFoundWhereverTheyAre) {
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    FlowLines lines = random_tracking_lines(seed);
    EXPECT_NO_THROW(static_cast<void>(parsed(text_of(lines)))) << text_of(lines);
    const FlowLines::Arc forward = lines.arcs[lines.arcs.size() / 2];
    lines.arcs.push_back({forward.head, forward.tail, "1"});
    lines.arcs.push_back(forward);
    EXPECT_THROW(static_cast<void>(parsed(text_of(reordered(lines, seed)))), InputError)
        << text_of(lines);
  }
}

/// Parsed, or refused with the file's name; anything else that is thrown fails the test.
void expect_parsed_or_refused(const std::string& text) {
  try {
    const FlowFile file = parsed(text);
    EXPECT_EQ(file.graph.supply.size(), static_cast<std::size_t>(file.graph.nodes));
    EXPECT_EQ(file.cost.size(), file.graph.arcs.size());
    EXPECT_EQ(file.lower.size(), file.graph.arcs.size());
    for (const FlowArc& arc : file.graph.arcs) {
      EXPECT_TRUE(arc.tail >= 0 && arc.tail < file.graph.nodes);
      EXPECT_TRUE(arc.head >= 0 && arc.head < file.graph.nodes);
      EXPECT_GE(arc.capacity, 0);
    }
  } catch (const InputError& error) {
    const std::string message = error.what();
    EXPECT_TRUE(message.starts_with("g.min:")) << message;
    EXPECT_TRUE(message.size() > 7 && message[6] >= '1' && message[6] <= '9') << message;
  }
}

/// One change that an editor, a broken disk or a broken writer might make.
void damage(std::string& text, Draw& draw) {
  static const std::vector<std::string> kPieces = {
      " ",     "\n",  "\r",  "-",  "+",  ".",           "e9", "0",  "9999999999999999999",
      "1e308", "nan", "inf", "a ", "n ", "p min 3 1\n", "c",  "\t", std::string(1, '\0')};
  const std::size_t at = draw.bits() % (text.size() + 1);
  const std::size_t length = draw.bits() % 6;
  switch (draw.below(4)) {
    case 0:
      text.insert(at, kPieces[draw.bits() % kPieces.size()]);
      break;
    case 1:
      text.erase(at, length);
      break;
    case 2:
      text.insert(at, text.substr(draw.bits() % (text.size() + 1), 4 * length));
      break;
    default:
      text.replace(at, 1, 1, static_cast<char>(draw.below(256)));
  }
}

TEST(FlowFileTest, RandomDamageIsSurvived) {
  Draw draw(1);
  for (std::uint64_t seed = 1; seed <= 10000; ++seed) {
    std::string text =
        text_of(seed % 2 == 0 ? random_tracking_lines(seed) : random_dimacs_lines(seed));
    for (int changes = 1 + draw.below(4); changes > 0; --changes) damage(text, draw);
    expect_parsed_or_refused(text);
  }
}

TEST(FlowFileTest, TruncatedFilesAreRefusedOrLackOnlyTheEndOfTheLastNumber) {
  for (const FlowLines& lines : {random_tracking_lines(7), random_dimacs_lines(7)}) {
    const std::string text = text_of(lines);
    const std::size_t last_number = text.rfind(' ') + 1;
    for (std::size_t length = 0; length <= last_number; ++length) {
      EXPECT_THROW(static_cast<void>(parsed(text.substr(0, length))), InputError) << length;
    }
  }
}

TEST(FlowFileTest, RandomBytesAreSurvived) {
  Draw draw(2);
  for (int trial = 0; trial < 2000; ++trial) {
    std::string bytes(draw.bits() % 80, ' ');
    for (char& byte : bytes) byte = static_cast<char>(draw.below(256));
    expect_parsed_or_refused(bytes);
  }
}

}  // namespace
}  // namespace mda::testing
