#include "harness/verify.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "harness/answer.h"
#include "harness/messages.h"
#include "harness/plan.h"
#include "harness/run_cell.h"
#include "harness/window_rows.h"

namespace mda {
namespace {

using Json = nlohmann::json;

/// Scan and algorithm.
using LineName = std::pair<int, std::string>;
using Lines = std::map<LineName, Json>;

/// What a second look cannot repeat.
constexpr std::array<std::string_view, 11> kNotCompared = {
    "wall_ms", "cpu_ms",     "translate_ms", "views_ms", "lp_ms",  "round_ms",
    "grow_ms", "iterations", "nodes",        "note",     "workers"};

bool same(const Json& recorded, const Json& recomputed) {
  if (recorded.is_array() && recomputed.is_array()) {
    return std::equal(recorded.begin(), recorded.end(), recomputed.begin(), recomputed.end(), same);
  }
  if (recorded.is_object() && recomputed.is_object()) {
    return recorded.size() == recomputed.size() &&
           std::all_of(recorded.items().begin(), recorded.items().end(), [&](const auto& item) {
             return recomputed.contains(item.key()) && same(item.value(), recomputed[item.key()]);
           });
  }
  if (!recorded.is_number() || !recomputed.is_number()) return recorded == recomputed;
  const double a = recorded.get<double>();
  const double b = recomputed.get<double>();
  return std::abs(a - b) <= 1e-6 * (1.0 + std::abs(b));
}

/// One cell, replayed.
class CellCheck {
 public:
  /// `scene`: it must be as recorded, if the cell is one that records it.
  CellCheck(const Cell& cell, const Sweep& sweep, Worker& worker, bool scene)
      : cell_(cell),
        sweep_(sweep),
        worker_(worker),
        book_(scene && records_scene(cell) ? &worker.scene_book() : nullptr) {}

  Verification run(const CellLines& lines) {
    const Lines rows = by_name(lines.rows, "rows.jsonl");
    answers_ = by_name(lines.answers, "answers.jsonl");
    may_be_cut_ = lines.may_be_cut;
    const ScenarioSpec spec = scenario_of(cell_);
    WindowLoop& windows = worker_.windows(spec);
    windows.start(spec, sweep_.seed, cell_.replicate, cell_.window_k,
                  need_views(worker_.players(sweep_, *cell_.plan)));
    while (windows.next() && check_window(rows, windows)) {
    }
    if (result_.disagreements == 0 && !was_cut_ && expected_ != rows.size()) {
      disagree(0, "", "there are rows of other scans or algorithms");
    }
    if (book_ != nullptr && result_.disagreements == 0 && !was_cut_) check_scene(lines.scenes);
    return std::move(result_);
  }

 private:
  void disagree(int scan, std::string_view algorithm, std::string_view what) {
    result_.disagree(fmt::format("{} replicate {}, T = {} s, K = {}{}{}: {}", cell_.plan->spec.name,
                                 cell_.replicate, cell_.scan_period_s, cell_.window_k,
                                 scan > 0 ? fmt::format(", scan {}", scan) : "",
                                 algorithm.empty() ? "" : fmt::format(", {}", algorithm), what));
  }

  Lines by_name(const std::vector<FileLine>& lines, std::string_view file) {
    Lines result;
    for (const FileLine& line : lines) {
      Json json = Json::parse(line.text);
      const Json& scan = json["scan"];
      const Json& algorithm = json["algorithm"];
      if (!scan.is_number_integer() || !algorithm.is_string()) {
        disagree(0, "", fmt::format("line {} of {} names no scan or algorithm", line.number, file));
        continue;
      }
      LineName name{scan.get<int>(), algorithm.get<std::string>()};
      if (!result.emplace(name, std::move(json)).second) {
        disagree(name.first, name.second,
                 fmt::format("line {} of {} is there twice", line.number, file));
      }
    }
    return result;
  }

  /// False if the cell cannot go on.
  bool check_window(const Lines& rows, WindowLoop& windows) {
    const AssociationProblem& problem = windows.window().problem;
    const std::string fingerprint = problem.fingerprint();
    std::vector<Attempt> attempts;
    ++result_.windows;
    const bool is_for_all = is_asked(cell_, windows.scan());
    for (const Player& player :
         is_for_all ? worker_.players(sweep_, *cell_.plan) : worker_.driver(sweep_)) {
      const LineName name{windows.scan(), std::string(player.entry->name)};
      const auto row = rows.find(name);
      if (player.asked && row == rows.end()) {
        if (may_be_cut_) was_cut_ = true;
        if (!was_cut_) disagree(name.first, name.second, "its row is missing");
        return false;
      }
      if (row != rows.end() && row->second.value("fingerprint", "") != fingerprint) {
        disagree(name.first, name.second, "its fingerprint is not that of the window");
        return false;
      }
      attempts.push_back(recorded_attempt(player, name, problem));
    }
    const Verdicts verdicts = judge(problem, std::move(attempts));
    compare(rows, verdicts, windows);
    if (book_ != nullptr) book_->note(worker_.forest(), verdicts);
    windows.advance(advancing_choice(problem, verdicts, sweep_.driver));
    return true;
  }

  /// Without a recorded answer a player whose row was asked for declined.
  Attempt recorded_attempt(const Player& player, const LineName& name,
                           const AssociationProblem& problem) {
    Attempt attempt;
    attempt.player = &player;
    const auto answer = answers_.find(name);
    attempt.skipped = answer == answers_.end() || row_within(answer->second)["status"] == "skipped";
    if (attempt.skipped) return attempt;
    try {
      attempt.solution = solution_of(answer->second, problem.columns());
    } catch (const std::invalid_argument& error) {
      disagree(name.first, name.second, fmt::format("its answer: {}", error.what()));
    }
    return attempt;
  }

  /// Of a line of answers.jsonl: the row of a player whose row was not asked for.
  static Json row_within(const Json& answer) {
    const auto found = answer.find("row");
    return found != answer.end() && found->is_object() ? *found : Json::object();
  }

  /// What the run recorded of a player's turn.
  Json recorded_row(const Lines& rows, const LineName& name, bool asked) {
    if (asked) return rows.at(name);
    const auto answer = answers_.find(name);
    return answer == answers_.end() ? Json() : row_within(answer->second);
  }

  void compare(const Lines& rows, const Verdicts& verdicts, const WindowLoop& windows) {
    const Row common = window_row({cell_, sweep_, 1}, windows);
    for (const Attempt& attempt : verdicts.attempts) {
      const bool asked = attempt.player->asked;
      const LineName name{windows.scan(), std::string(attempt.player->entry->name)};
      if (asked) {
        ++expected_;
        ++result_.rows;
      }
      const Json recorded = recorded_row(rows, name, asked);
      if (recorded.empty()) {
        disagree(name.first, name.second, "its answer, or the row in it, is missing");
        continue;
      }
      if (recorded.value("status", "") == word(Status::kFailed)) continue;
      std::string line;
      append_row_line(attempt_row(common, windows, attempt, verdicts), line);
      compare_row(recorded, Json::parse(line));
    }
  }

  void compare_row(const Json& recorded, const Json& recomputed) {
    for (const auto& [field, value] : recomputed.items()) {
      const auto ignored = std::find(kNotCompared.begin(), kNotCompared.end(), field);
      if (ignored != kNotCompared.end()) continue;
      const auto found = recorded.find(field);
      if (found == recorded.end() ? value.is_null() : same(*found, value)) continue;
      disagree(recomputed["scan"].get<int>(), recomputed["algorithm"].get<std::string>(),
               fmt::format("'{}' is recorded as {}, but comes out as {}", field,
                           found == recorded.end() ? "nothing" : found->dump(), value.dump()));
    }
  }

  void check_scene(const std::vector<FileLine>& lines) {
    ++result_.scenes;
    if (lines.empty() && may_be_cut_) return;
    if (lines.size() != 1) {
      return disagree(0, "", fmt::format("scenes.jsonl has {} lines of it", lines.size()));
    }
    const std::string line = book_->line(cell_, sweep_, worker_.forest().scene());
    if (!same(Json::parse(lines.front().text), Json::parse(line))) {
      disagree(0, "",
               fmt::format("line {} of scenes.jsonl comes out differently", lines.front().number));
    }
  }

  const Cell& cell_;
  const Sweep& sweep_;
  Worker& worker_;
  SceneBook* book_;  ///< none: no scene is checked
  Lines answers_;
  std::size_t expected_ = 0;
  bool may_be_cut_ = false;
  bool was_cut_ = false;
  Verification result_;
};

CellName name_of(const Cell& cell) {
  return {cell.plan->spec.name, cell.scan_period_s, cell.replicate, cell.window_k};
}

/// Cells that should be there and are not, or the other way round.
Verification check_completeness(const RunFiles& files, const std::vector<Cell>& cells) {
  Verification result;
  std::size_t known = 0;
  std::int64_t missing = 0;
  for (const Cell& cell : cells) {
    if (files.cells().contains(name_of(cell))) {
      ++known;
    } else {
      ++missing;
    }
  }
  if (known != files.cells().size())
    result.disagree("there are rows of cells that were not asked for");
  if (files.outcome() == "finished" && missing != files.cells_failed()) {
    result.disagree(fmt::format("{} cells have no rows, but the manifest tells of {} that failed",
                                missing, files.cells_failed()));
  }
  return result;
}

}  // namespace

void Verification::disagree(std::string what) {
  constexpr std::size_t kExamples = 10;
  ++disagreements;
  if (examples.size() < kExamples) examples.push_back(std::move(what));
}

void Verification::add(const Verification& other) {
  windows += other.windows;
  rows += other.rows;
  scenes += other.scenes;
  const auto told = static_cast<std::int64_t>(other.examples.size());
  for (const std::string& example : other.examples) disagree(example);
  disagreements += other.disagreements - told;
}

Verification verify_run(const RunFiles& files, int workers, const std::atomic<bool>& interrupted) {
  const std::vector<Cell> cells = plan(files.sweep());
  std::vector<Verification> results(cells.size());
#pragma omp parallel num_threads(workers)
  {
    Worker worker;
#pragma omp for schedule(dynamic, 1)
    for (std::size_t i = 0; i < cells.size(); ++i) {
      const auto lines = files.cells().find(name_of(cells[i]));
      if (interrupted || lines == files.cells().end()) continue;
      try {
        results[i] =
            CellCheck(cells[i], files.sweep(), worker, files.has_scenes()).run(lines->second);
      } catch (const std::exception& error) {
        results[i].disagree(fmt::format("{} replicate {}, K = {}: {}", cells[i].plan->spec.name,
                                        cells[i].replicate, cells[i].window_k, plain_words(error)));
      }
    }
  }
  Verification all = check_completeness(files, cells);
  for (const Verification& result : results) all.add(result);
  return all;
}

}  // namespace mda
