#include "harness/machine.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <functional>
#include <string>
#include <vector>

#include "harness/testing/temporary_directory.h"

namespace mda {
namespace {

/// A directory that stands for "/".
class MachineTest : public ::testing::Test {
 protected:
  void write(const std::string& name, const std::string& text) const {
    const auto path = root_.path() / name;
    std::filesystem::create_directories(path.parent_path());
    std::ofstream(path) << text;
  }

  [[nodiscard]] MachineState read() const {
    return read_machine(root_.path(), "/nowhere:" + (root_.path() / "bin").string());
  }

  void write_quiet_server() const {
    write(
        "proc/cpuinfo",
        "processor\t: 0\nmodel name\t: Old Faithful\nprocessor\t: 1\nmodel name\t: Old Faithful\n");
    write("proc/sys/kernel/osrelease", "6.1.0\n");
    write("proc/loadavg", "0.10 0.20 0.30 1/100 4242\n");
    write("proc/pressure/cpu",
          "some avg10=0.50 avg60=0.10 avg300=0.00 total=2500000\n"
          "full avg10=9.00 avg60=9.00 avg300=9.00 total=9\n");
    write("sys/devices/system/cpu/smt/active", "0\n");
    write("sys/devices/system/cpu/cpu0/cpufreq/scaling_governor", "performance\n");
    write("sys/devices/system/cpu/cpu1/cpufreq/scaling_governor", "performance\n");
    write("sys/devices/system/clocksource/clocksource0/current_clocksource", "tsc\n");
    write("bin/valgrind", "");
  }

 private:
  testing::TemporaryDirectory root_;
};

std::vector<std::string> faults(const MachineState& machine) {
  std::vector<std::string> names;
  for (const Finding& finding : findings(machine)) {
    EXPECT_EQ(finding.is_good, finding.change.empty()) << finding.what;
    EXPECT_FALSE(finding.state.empty()) << finding.what;
    if (!finding.is_good) names.push_back(finding.what);
  }
  return names;
}

TEST_F(MachineTest, AQuietServerIsReadAndHasNoFault) {
  write_quiet_server();
  const MachineState machine = read();
  EXPECT_EQ(machine.cpu, "Old Faithful");
  EXPECT_EQ(machine.cores, 2);
  EXPECT_EQ(machine.kernel, "6.1.0");
  EXPECT_EQ(machine.governors, std::vector<std::string>{"performance"});
  EXPECT_EQ(machine.smt, false);
  EXPECT_DOUBLE_EQ(machine.load_1min.value(), 0.1);
  EXPECT_DOUBLE_EQ(machine.stalled_10s.value(), 0.5);
  EXPECT_DOUBLE_EQ(machine.stalled_total.value(), 2.5);
  EXPECT_TRUE(machine.valgrind.ends_with("bin/valgrind"));
  EXPECT_TRUE(faults(machine).empty());
}

TEST_F(MachineTest, EachFaultIsFoundAlone) {
  write_quiet_server();
  const MachineState quiet = read();
  const std::vector<std::pair<std::string, std::function<void(MachineState&)>>> spoilt = {
      {"cores", [](MachineState& m) { m.cores = 1; }},
      {"governor",
       [](MachineState& m) {
         m.governors = {"performance", "powersave"};
       }},
      {"SMT", [](MachineState& m) { m.smt = true; }},
      {"load", [](MachineState& m) { m.load_1min = 1.5; }},
      {"pressure", [](MachineState& m) { m.stalled_10s = 40.0; }},
      {"pressure", [](MachineState& m) { m.stalled_10s.reset(); }},
      {"clock source", [](MachineState& m) { m.clock_source = "hpet"; }},
      {"valgrind", [](MachineState& m) { m.valgrind.clear(); }}};
  for (const auto& [name, spoil] : spoilt) {
    MachineState machine = quiet;
    spoil(machine);
    EXPECT_EQ(faults(machine), std::vector<std::string>{name});
  }
}

TEST_F(MachineTest, ASystemThatTellsNothingIsNoError) {
  const MachineState machine = read();
  EXPECT_EQ(machine.cpu, "unknown");
  EXPECT_EQ(machine.cores, 0);
  EXPECT_FALSE(machine.load_1min);
  EXPECT_EQ(faults(machine), (std::vector<std::string>{"cores", "pressure", "valgrind"}));
}

TEST_F(MachineTest, BrokenNumbersAreNotTold) {
  write_quiet_server();
  write("proc/loadavg", "much\n");
  write("proc/pressure/cpu", "some avg10=\n");
  const MachineState machine = read();
  EXPECT_FALSE(machine.load_1min);
  EXPECT_FALSE(machine.stalled_10s);
}

}  // namespace
}  // namespace mda
