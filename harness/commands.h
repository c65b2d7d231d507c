// The commands of mda-bench, after the command line has become types. Each returns an exit code,
// writes results for people (or machines) to stdout, and throws InputError or DiskError.
#pragma once

#include <atomic>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "harness/sweep.h"

namespace mda {

enum class ListKind { kAlgorithms, kScenarios, kSweeps };

struct ListCommand {
  ListKind kind = ListKind::kAlgorithms;
  bool json = false;
};

struct RunCommand {
  std::string sweep;
  std::string out;  ///< empty: results/runs/<sweep>-<time> below the present directory
  int workers = 0;  ///< 0: one per processor
  bool json = false;
  SweepChanges changes;
  std::vector<std::string> arguments;  ///< as typed, for the manifest
};

enum class WindowFormat { kMps, kLp, kJson };

struct ExportCommand {
  std::string scenario;
  int scan = 0;
  int window_k = 0;
  int replicate = 1;
  std::optional<double> scan_period_s;  ///< without it, the scenario's own
  std::uint64_t seed = 1;
  RowRule rows = RowRule::kPacking;
  WindowFormat format = WindowFormat::kJson;
  std::string out;  ///< empty: stdout
};

enum class ProblemFormat { kWindow, kAxial3 };

struct SolveCommand {
  std::string file;
  ProblemFormat format = ProblemFormat::kWindow;
  std::string algorithm;
  double time_limit_s = 60.0;
  std::string certificate;  ///< file to write; empty: none
  bool json = false;
};

struct CertifyCommand {
  std::string window;
  std::string certificate;
  bool json = false;
};

struct FlowCommand {
  std::string file;
  std::string algorithm;
  bool paths = false;
  bool json = false;
};

struct VerifyCommand {
  std::string directory;
  int workers = 0;  ///< 0: one per processor
  bool json = false;
};

struct DoctorCommand {
  bool json = false;
};

int list(const ListCommand& command);
int run(const RunCommand& command, const std::atomic<bool>& interrupted);
int export_window(const ExportCommand& command);
int solve(const SolveCommand& command);
int certify(const CertifyCommand& command);
int flow(const FlowCommand& command);
int verify(const VerifyCommand& command, const std::atomic<bool>& interrupted);
int doctor(const DoctorCommand& command);

}  // namespace mda
