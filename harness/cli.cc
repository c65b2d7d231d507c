#include "harness/cli.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <charconv>
#include <map>
#include <set>

#include "algorithms/catalog.h"
#include "harness/build_info.h"
#include "harness/errors.h"
#include "harness/messages.h"

namespace mda {
namespace {

constexpr double kMostSeconds = 1e6;

/// CLI::Range takes NaN for a number within it.
CLI::Validator seconds(double least, double most) {
  const auto check = [least, most](const std::string& text) {
    double value = 0.0;
    const bool fits = CLI::detail::lexical_cast(text, value) && value >= least && value <= most;
    return fits ? "" : fmt::format("'{}' is not from {} to {} seconds", text, least, most);
  };
  return {check, fmt::format("FLOAT in [{} - {}]", least, most)};
}

/// CLI11 takes -1 and 2^64 for the largest seed there is.
CLI::Validator seed() {
  const auto check = [](const std::string& text) {
    std::uint64_t value = 0;
    const char* const end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, value);
    const bool fits = error == std::errc{} && stop == end && text[0] != '0';
    return fits ? "" : fmt::format("'{}' is not a whole number from 1 to 2^64 - 1", text);
  };
  return {check, "UINT in [1 - 2^64-1]"};
}

/// Of a file to write.
CLI::Validator name() {
  return {[](const std::string& text) { return text.empty() ? "it needs a name" : ""; }, "TEXT"};
}

/// An option or argument that is one of the words of `choices`.
template <typename Choice>
CLI::Option* add_choice(CLI::App& app, const std::string& name, Choice& choice,
                        const std::string& help, const std::map<std::string, Choice>& choices) {
  return app
      .add_option_function<std::string>(
          name, [&choice, &choices](const std::string& word) { choice = choices.at(word); }, help)
      ->check(CLI::IsMember(choices));
}

CLI::App* add_list(CLI::App& app, ListCommand& command) {
  static const std::map<std::string, ListKind> kKinds = {{"algorithms", ListKind::kAlgorithms},
                                                         {"scenarios", ListKind::kScenarios},
                                                         {"sweeps", ListKind::kSweeps}};
  CLI::App* list = app.add_subcommand("list", "Show the algorithms, scenarios or sweeps there are");
  add_choice(*list, "what", command.kind, "What to list", kKinds)->required();
  list->add_flag("--json", command.json, "Print a JSON list");
  return list;
}

CLI::App* add_run(CLI::App& app, RunCommand& command) {
  CLI::App* run =
      app.add_subcommand("run", "Run a sweep and record a row per window and algorithm");
  SweepChanges& changes = command.changes;
  run->add_option("sweep", command.sweep, "A named sweep ('list sweeps') or a .toml file")
      ->required();
  run->add_option("--out", command.out, "New directory for the run [results/runs/<sweep>-<time>]")
      ->check(name());
  run->add_option("--workers", command.workers, "Worker threads [one per processor]")
      ->check(CLI::Range(1, 1024));
  run->add_option("--algorithms", changes.algorithms, "Only these: a,b,...")->delimiter(',');
  run->add_option("--scenarios", changes.scenarios, "Only these: A,B,...")->delimiter(',');
  run->add_option("--windows", changes.windows, "Window widths K in scans: 3,5,...")
      ->delimiter(',')
      ->check(CLI::Range(1, 1000000));
  run->add_option("--scan-periods", changes.scan_periods_s, "Scan periods in seconds: 4,8,...")
      ->delimiter(',')
      ->check(seconds(1e-3, 3600.0));
  run->add_option("--replicates", changes.replicates, "Scenarios drawn per group")
      ->check(CLI::Range(1, 1000000));
  run->add_option("--seed", changes.seed, "Seed of all draws")->check(seed());
  run->add_option("--time-limit", changes.time_limit_s, "Seconds of wall clock per solve [10]")
      ->check(seconds(1e-9, kMostSeconds));
  run->add_option("--repeats", changes.repeats,
                  "Solve so often where that takes less than 30 ms, the least times count [1]")
      ->check(CLI::Range(1, kMostRepeats));
  run->add_flag("--closed-loop", changes.closed_loop,
                "Let every algorithm drive its own windows, and measure the tracking");
  run->add_flag("--json", command.json, "Print the summary as JSON");
  run->footer(
      "Writes manifest.json, rows.jsonl and answers.jsonl, for groups A-D scenes.jsonl; with\n"
      "--closed-loop tracking.jsonl instead of rows and answers. Finished cells survive Ctrl-C,\n"
      "which waits for the solves under way; a second one stops at once.\n"
      "Example: mda-bench run storms2003 --scenarios A --windows 3 --out results/runs/first");
  return run;
}

CLI::App* add_export(CLI::App& app, ExportCommand& command) {
  static const std::map<std::string, WindowFormat> kFormats = {
      {"mps", WindowFormat::kMps}, {"lp", WindowFormat::kLp}, {"json", WindowFormat::kJson}};
  static const std::map<std::string, RowRule> kRows = {{"packing", RowRule::kPacking},
                                                       {"equality", RowRule::kEquality}};
  CLI::App* window = app.add_subcommand("export", "Write one window as a file for other solvers");
  window->add_option("scenario", command.scenario, "A scenario ('list scenarios')")->required();
  window->add_option("--scan", command.scan, "Newest scan N of the window, from 1")->required();
  window->add_option("--window", command.window_k, "Window width K in scans")->required();
  window->add_option("--replicate", command.replicate, "Which draw of the scenario, from 1 [1]")
      ->check(CLI::Range(1, 1000000));
  window
      ->add_option("--scan-period", command.scan_period_s,
                   "Seconds between scans [the scenario's own]")
      ->check(seconds(1e-3, 3600.0));
  window->add_option("--seed", command.seed, "Seed of all draws [1]")->check(seed());
  add_choice(*window, "--format", command.format, "Format of the file", kFormats)->required();
  add_choice(*window, "--rows", command.rows,
             "At-most-once rows, or exactly-once rows with columns for false alarms [packing]",
             kRows);
  window->add_option("--out", command.out, "File to write [standard output]")->check(name());
  window->footer(
      "The file holds rows and columns only: algorithms that need the hypothesis tree of a window\n"
      "(scf, sd-exact, mht and others) decline to 'solve' it.\n"
      "Example: mda-bench export D --scan 20 --window 3 --format mps --out d20.mps");
  return window;
}

CLI::App* add_solve(CLI::App& app, SolveCommand& command) {
  static const std::map<std::string, ProblemFormat> kFormats = {{"json", ProblemFormat::kWindow},
                                                                {"axial3", ProblemFormat::kAxial3}};
  CLI::App* solve = app.add_subcommand("solve", "Solve one problem file with one algorithm");
  solve->add_option("file", command.file, "A window in JSON (see 'export'), or what --format says")
      ->required();
  add_choice(*solve, "--format", command.format,
             "json, or axial3: n, then n * n lines of n costs c[i][j][k], each index once [json]",
             kFormats);
  solve->add_option("--algorithm", command.algorithm, "An algorithm ('list algorithms')")
      ->required();
  solve->add_option("--time-limit", command.time_limit_s, "Seconds of wall clock [60]")
      ->check(seconds(1e-9, kMostSeconds));
  solve
      ->add_option("--certificate", command.certificate,
                   "File for the proof that the answer is optimal, for 'certify'; of algorithms\n"
                   "that write one (tree-exact); exit code 3 if time was over first")
      ->check(name());
  solve->add_flag("--json", command.json, "Print one JSON object");
  solve->footer(
      "A window file has no hypothesis tree: algorithms that need one decline, with exit code 2.\n"
      "Example: mda-bench solve window.json --algorithm exact");
  return solve;
}

CLI::App* add_certify(CLI::App& app, CertifyCommand& command) {
  CLI::App* certify =
      app.add_subcommand("certify", "Check the proof that an answer is optimal, without a solver");
  certify->add_option("window", command.window, "A window in JSON (see 'export')")->required();
  certify->add_option("certificate", command.certificate, "What 'solve --certificate' wrote")
      ->required();
  certify->add_flag("--json", command.json, "Print one JSON object");
  certify->footer(
      "Costs are rounded to 2^-bits nats, as the certificate says, and all sums are of whole\n"
      "numbers. Exit code 1 if the certificate proves nothing, or is about another window.\n"
      "Example: mda-bench solve window.json --algorithm tree-exact --certificate proof.json\n"
      "         mda-bench certify window.json proof.json");
  return certify;
}

CLI::App* add_flow(CLI::App& app, FlowCommand& command) {
  CLI::App* flow = app.add_subcommand("flow", "Find the cheapest flow in a graph file");
  std::string names;
  for (const FlowCode& code : flow_codes()) {
    names += fmt::format("\n  {:<20} {}", code.name, code.summary);
  }
  flow->add_option("file", command.file, "A graph in one of the formats below")->required();
  flow->add_option("--algorithm", command.algorithm, "One of the flow codes below")->required();
  flow->add_flag(
      "--paths", command.paths,
      "Print the nodes of each path, too (tracking graphs; 'tracks' of the JSON object)");
  flow->add_flag("--json", command.json, "Print one JSON object");
  flow->footer(
      "Flow codes:" + names +
      "\n\n"
      "A graph of N nodes, numbered from 1, and M arcs is a text file of these lines:\n"
      "  c anything                  a comment\n"
      "  p min N M                   first of all\n"
      "  n NODE SUPPLY               negative for demand\n"
      "  a TAIL HEAD LOW CAP COST    DIMACS: whole numbers, all supply must flow; or\n"
      "  a TAIL HEAD COST            tracking: any cost, capacity 1, no cycles; the first 'n'\n"
      "                              line names the source and the second one the sink, and as\n"
      "                              many units flow as are cheapest: each is a track\n"
      "Costs may be as large as 2^59 / (N + 1) in size, tracking costs 2^39 / (N + 1): these are\n"
      "rounded to 2^-20 at the coarsest, 2^-30 where there is room. A code may take less, and "
      "then\n"
      "declines; the cost of the whole flow must stay within 64 bits.\n"
      "Prints the cost, the paths (units that flow), and the bound on the cost that the code's\n"
      "node potentials certify; with --json also 'used_arcs', a list of [tail, head, units] of "
      "the\n"
      "arcs that carry flow. Exit code 1 if its answer is refuted; a DIMACS graph whose supplies\n"
      "cannot flow has status 'infeasible', no cost, and exit code 0.\n"
      "Example, two ways to track one target (cost -3.5, 1 path):\n"
      "  printf 'p min 4 4\\nn 1 0\\nn 4 0\\na 1 2 5\\na 2 3 -9.5\\na 3 4 1\\na 2 4 -6\\n' > "
      "g.min\n"
      "  mda-bench flow g.min --algorithm scf-networksimplex --paths");
  return flow;
}

CLI::App* add_verify(CLI::App& app, VerifyCommand& command) {
  CLI::App* verify =
      app.add_subcommand("verify", "Check a recorded run without running any solver");
  verify->add_option("directory", command.directory, "Directory of the run")->required();
  verify->add_option("--workers", command.workers, "Worker threads [one per processor]")
      ->check(CLI::Range(1, 1024));
  verify->add_flag("--json", command.json, "Print one JSON object");
  verify->footer(
      "Makes the windows anew from manifest.json, judges answers.jsonl again, and compares with\n"
      "rows.jsonl, and with scenes.jsonl where it is there. Exit code 1 if anything differs.\n"
      "Example: mda-bench verify results/runs/first");
  return verify;
}

CLI::App* add_doctor(CLI::App& app, DoctorCommand& command) {
  CLI::App* doctor = app.add_subcommand(
      "doctor", "Say whether this machine is fit for timing, and what to change");
  doctor->add_flag("--json", command.json, "Print one JSON object");
  doctor->footer(
      "Looks at cores, frequency governor, SMT, load, pressure, clock source and valgrind. Exit\n"
      "code 4 if something is amiss. Changes nothing.");
  return doctor;
}

/// CLI11 leaves out the empty items of a list.
void refuse_empty_items(int argc, const char* const* argv) {
  const std::set<std::string_view> lists = {"--algorithms", "--scenarios", "--windows",
                                            "--scan-periods"};
  for (int i = 1; i < argc; ++i) {
    const std::string_view word = argv[i];
    const auto equals = word.find('=');
    const std::string_view name = word.substr(0, equals);
    if (!lists.contains(name)) continue;
    std::string_view list = i + 1 < argc ? argv[i + 1] : "";
    if (equals != std::string_view::npos) list = word.substr(equals + 1);
    if (fmt::format(",{},", list).find(",,") == std::string::npos) continue;
    throw InputError(
        fmt::format("{}: the list '{}' has an item with nothing in it (see --help)", name, list));
  }
}

/// CLI11's message as one sentence on one line.
std::string sentence(const CLI::ParseError& error) {
  return one_line(error.what()) + " (see --help)";
}

}  // namespace

std::optional<Command> parse_command_line(int argc, const char* const* argv) {
  CLI::App app("mda-bench: a benchmark harness for multi-scan data association", "mda-bench");
  app.require_subcommand(0, 1);  // CLI11 would not name an unknown word if one were required
  app.set_version_flag("--version", std::string(build_info().version));
  app.footer(
      "Exit codes: 0 well; 1 a wrong answer was found; 2 bad usage or input; 3 some cells failed;\n"
      "4 a machine unfit for timing; 5 the disk failed while running; 130 interrupted (finished "
      "rows are kept).");
  ListCommand list_command;
  RunCommand run_command;
  ExportCommand export_command;
  SolveCommand solve_command;
  CertifyCommand certify_command;
  FlowCommand flow_command;
  VerifyCommand verify_command;
  DoctorCommand doctor_command;
  const CLI::App* list = add_list(app, list_command);
  const CLI::App* run = add_run(app, run_command);
  const CLI::App* window = add_export(app, export_command);
  const CLI::App* solve = add_solve(app, solve_command);
  const CLI::App* certify = add_certify(app, certify_command);
  const CLI::App* flow = add_flow(app, flow_command);
  const CLI::App* verify = add_verify(app, verify_command);
  add_doctor(app, doctor_command);
  refuse_empty_items(argc, argv);
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& asked) {
    app.exit(asked);
    return std::nullopt;
  } catch (const CLI::ParseError& error) {
    throw InputError(sentence(error));
  }
  if (app.get_subcommands().empty()) {
    throw InputError(
        "a command is missing: list, run, export, solve, certify, flow, verify or doctor (see "
        "--help)");
  }
  run_command.arguments.assign(argv + 1, argv + argc);
  if (list->parsed()) return list_command;
  if (run->parsed()) return run_command;
  if (window->parsed()) return export_command;
  if (solve->parsed()) return solve_command;
  if (certify->parsed()) return certify_command;
  if (flow->parsed()) return flow_command;
  if (verify->parsed()) return verify_command;
  return doctor_command;
}

}  // namespace mda
