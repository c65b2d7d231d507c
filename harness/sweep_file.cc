// Sweeps from TOML files.

#include <fmt/format.h>
#include <toml++/toml.h>

#include <limits>
#include <set>

#include "algorithms/catalog.h"
#include "harness/errors.h"
#include "harness/sweep.h"
#include "harness/words.h"
#include "scenarios/duration.h"

namespace mda {
namespace {

/// Reads the keys of one table, each by its name and type, and refuses the others.
class TableReader {
 public:
  TableReader(const toml::table& table, std::string file, std::string path)
      : table_(table), file_(std::move(file)), path_(std::move(path)) {}

  template <typename T>
  void read(std::string_view key, T& value, std::string_view type) {
    if (const toml::node* node = find(key)) value = as<T>(*node, key, type);
  }

  template <typename T>
  void read_list(std::string_view key, std::vector<T>& values, std::string_view type) {
    const toml::node* node = find(key);
    if (node == nullptr) return;
    const toml::array* array = node->as_array();
    if (array == nullptr) fail(*node, key, fmt::format("a list of {}", type));
    values.clear();
    for (const toml::node& item : *array) values.push_back(as<T>(item, key, type));
  }

  template <typename Words, typename Choice>
  void read_word(std::string_view key, const Words& words, Choice& choice) {
    const toml::node* node = find(key);
    if (node == nullptr) return;
    std::string choices;
    for (const auto& word : words) {
      if (node->value<std::string>() == word.text) {
        choice = word.choice;
        return;
      }
      choices += fmt::format("{}\"{}\"", choices.empty() ? "" : ", ", word.text);
    }
    fail(*node, key, "one of " + choices);
  }

  [[nodiscard]] const toml::table* table(std::string_view key) {
    const toml::node* node = find(key);
    if (node == nullptr) return nullptr;
    if (node->as_table() == nullptr) fail(*node, key, "a table");
    return node->as_table();
  }

  /// Throws for the first key that nothing has asked for.
  void refuse_others() const {
    for (const auto& [key, node] : table_) {
      if (known_.contains(std::string(key.str()))) continue;
      throw InputError(
          fmt::format("{}:{}: unknown key '{}{}'", file_, line(node), path_, key.str()));
    }
  }

 private:
  const toml::node* find(std::string_view key) {
    known_.emplace(key);
    return table_.get(key);
  }

  template <typename T>
  T as(const toml::node& node, std::string_view key, std::string_view type) const {
    if constexpr (std::is_same_v<T, double>) {
      if (const auto value = node.value<double>(); value && node.is_number()) return *value;
    } else if constexpr (std::is_integral_v<T>) {
      const auto value = node.value_exact<std::int64_t>();
      if (value && std::in_range<T>(*value)) return static_cast<T>(*value);
      if (value) fail(node, key, fmt::format("{} in range, but it is {}", type, *value));
    } else {
      if (const auto value = node.value_exact<T>()) return *value;
    }
    fail(node, key, type);
  }

  [[noreturn]] void fail(const toml::node& node, std::string_view key,
                         std::string_view wanted) const {
    throw InputError(
        fmt::format("{}:{}: '{}{}' must be {}", file_, line(node), path_, key, wanted));
  }

  static unsigned line(const toml::node& node) { return node.source().begin.line; }

  const toml::table& table_;
  std::string file_;
  std::string path_;
  std::set<std::string> known_;
};

void read_model(const toml::table& table, const std::string& file, TrackerModel& model) {
  TableReader reader(table, file, "model.");
  reader.read_word("density", kDensityWords, model.density);
  reader.read_word("second_plot", kSecondPlotWords, model.second_plot);
  reader.read_word("trailing_misses", kTrailingMissesWords, model.trailing_misses);
  reader.read_word("newborn", kNewbornWords, model.newborn);
  reader.read_word("rows", kRowRuleWords, model.rows);
  reader.read("gate", model.gate, "a number");
  reader.read("max_misses", model.max_misses, "an integer");
  reader.read("velocity_prior", model.velocity_prior, "a number");
  reader.read_word("update", kTrackUpdateWords, model.update);
  reader.refuse_others();
  if (!(model.gate > 0.0) || model.gate > 1e6) {
    throw InputError(file + ": 'model.gate' must be above 0 and at most 1000000");
  }
  if (model.max_misses < 0 || model.max_misses > 20) {
    throw InputError(file + ": 'model.max_misses' must be 0 to 20");
  }
  if (!(model.velocity_prior > 0.0) || model.velocity_prior > 100.0) {
    throw InputError(file + ": 'model.velocity_prior' must be above 0 and at most 100");
  }
}

/// The values are checked with the sweep.
void read_sensors(TableReader& reader, const std::string& file, ScenarioSpec& spec) {
  ThreeSensors& sensors = *spec.three_sensors;
  int count = 3;
  reader.read("sensors", count, "an integer");
  reader.read("targets", sensors.targets, "an integer");
  reader.read_word("layout", kSensorLayoutWords, sensors.layout);
  reader.read("sigma_per_spacing", sensors.sigma_per_spacing, "a number");
  reader.read("false_alarms_per_target", sensors.false_alarms_per_target, "a number");
  reader.read("detection_probability", spec.world.detection_probability, "a number");
  if (count != 3) {
    throw InputError(fmt::format("{}: 'world.sensors' is {}: it must be 3", file, count));
  }
}

void read_world(const toml::table& table, const std::string& file, ScenarioSpec& spec) {
  World& world = spec.world;
  TableReader reader(table, file, "world.");
  if (spec.three_sensors) read_sensors(reader, file, spec);
  reader.read("birth_centre_x_km", world.birth_centre_x_km, "a number");
  reader.read("birth_centre_y_km", world.birth_centre_y_km, "a number");
  reader.read("birth_side_km", world.birth_side_km, "a number");
  reader.read("initial_targets", world.initial_targets, "an integer");
  reader.read("target_life_scans", world.target_life_scans, "an integer");
  reader.refuse_others();
  const auto far = [](double km) { return !(std::abs(km) <= 1e4); };
  if (far(world.birth_centre_x_km) || far(world.birth_centre_y_km)) {
    throw InputError(file + ": 'world.birth_centre_x_km' and '..._y_km' must be within 10000 km");
  }
  if (!(world.birth_side_km > 0.0 && world.birth_side_km <= 1e4)) {
    throw InputError(file + ": 'world.birth_side_km' must be above 0 and at most 10000 km");
  }
  if (world.initial_targets < 0 || world.initial_targets > 100000) {
    throw InputError(file + ": 'world.initial_targets' must be 0 to 100000");
  }
  if (world.target_life_scans < 0) {
    throw InputError(file + ": 'world.target_life_scans' must be 0 (for ever) or more");
  }
}

/// By default a run's directory is named after the sweep.
bool names_a_directory(std::string_view name) {
  constexpr std::string_view kAllowed =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789._-";
  return !name.empty() && name.size() <= 100 && name[0] != '.' &&
         name.find_first_not_of(kAllowed) == std::string_view::npos;
}

toml::table parse(std::string_view text, const std::string& file) {
  try {
    return toml::parse(text, file);
  } catch (const toml::parse_error& error) {
    throw InputError(
        fmt::format("{}:{}: {}", file, error.source().begin.line, error.description()));
  }
}

}  // namespace

Sweep parse_sweep(std::string_view text, const std::string& file) {
  const toml::table root = parse(text, file);
  TableReader reader(root, file, "");
  Sweep sweep;
  sweep.driver = reference_algorithm().name;
  std::vector<std::string> scenarios;
  std::vector<int> windows;
  int replicates = 1;
  reader.read("name", sweep.name, "a string");
  reader.read("summary", sweep.summary, "a string");
  reader.read_list("scenarios", scenarios, "strings");
  reader.read_list("scan_periods_s", sweep.scan_periods_s, "numbers");
  reader.read_list("windows", windows, "integers");
  reader.read("replicates", replicates, "an integer");
  reader.read("seed", sweep.seed, "a positive integer");
  reader.read("driver", sweep.driver, "a string");
  reader.read_list("algorithms", sweep.algorithms, "strings");
  reader.read("time_limit_s", sweep.time_limit_s, "a number");
  reader.read("repeats", sweep.repeats, "an integer");
  const toml::table* model = reader.table("model");
  const toml::table* world = reader.table("world");
  reader.refuse_others();
  for (const std::string& name : scenarios) {
    ScenarioPlan plan{
        .spec = scenario_named(name, file + ": "), .windows = windows, .replicates = replicates};
    if (model != nullptr) read_model(*model, file, plan.spec.model);
    if (world != nullptr) read_world(*world, file, plan.spec);
    // The 8 s of the groups are no scan period for scenes that have a duration, or one instant.
    const bool has_own_period = duration_s(plan.spec) || plan.spec.three_sensors;
    if (!root.contains("scan_periods_s") && has_own_period) {
      plan.scan_periods_s = {plan.spec.world.scan_period_s};
    }
    sweep.scenarios.push_back(std::move(plan));
  }
  if (!names_a_directory(sweep.name)) {
    throw InputError(file + ": 'name' must be there, of letters, digits, '.', '_' and '-'");
  }
  check(sweep, file + ": ");
  return sweep;
}

}  // namespace mda
