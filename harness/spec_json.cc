#include "harness/spec_json.h"

#include <fmt/format.h>

#include "harness/errors.h"
#include "harness/words.h"

namespace mda {
namespace {

using Json = nlohmann::ordered_json;

// Written where there is something to write.
constexpr const char* kDrawsAs = "draws_as";
constexpr const char* kInitialTargets = "initial_targets";
constexpr const char* kKnownTargets = "known_targets";
constexpr const char* kPositionTargets = "position_targets";
constexpr const char* kThreeSensors = "three_sensors";

/// Calls visit(name, value) for every plain field and visit(name, words, choice) for every typed
/// choice.
template <typename Spec, typename Visitor>
void visit_fields(Spec& spec, Visitor visit) {
  auto& world = spec.world;
  visit("scans", world.scans);
  visit("scan_period_s", world.scan_period_s);
  visit("detection_probability", world.detection_probability);
  visit("range_km", world.range_km);
  visit("range_sigma_km", world.range_sigma_km);
  visit("bearing_sigma_rad", world.bearing_sigma_rad);
  visit("speed_min_km_s", world.speed_min_km_s);
  visit("speed_max_km_s", world.speed_max_km_s);
  visit("acceleration_sigma_km_s2", world.acceleration_sigma_km_s2);
  visit("birth_centre_x_km", world.birth_centre_x_km);
  visit("birth_centre_y_km", world.birth_centre_y_km);
  visit("birth_side_km", world.birth_side_km);
  visit("births_per_scan", world.births_per_scan);
  visit("clutter_per_scan", world.clutter_per_scan);
  visit("target_life_scans", world.target_life_scans);
  auto& model = spec.model;
  visit("density", kDensityWords, model.density);
  visit("second_plot", kSecondPlotWords, model.second_plot);
  visit("trailing_misses", kTrailingMissesWords, model.trailing_misses);
  visit("newborn", kNewbornWords, model.newborn);
  visit("rows", kRowRuleWords, model.rows);
  visit("gate", model.gate);
  visit("max_misses", model.max_misses);
  visit("velocity_prior", model.velocity_prior);
}

template <typename Targets, typename Visitor>
void visit_known_targets(Targets& targets, Visitor visit) {
  visit("trajectories", kTrajectoriesWords, targets.trajectories);
  visit("lateral_spacing_km", targets.lateral_spacing_km);
  visit("axis_heading_rad", targets.axis_heading_rad);
  visit("duration_s", targets.duration_s);
  visit("range_rate_sigma_km_s", targets.range_rate_sigma_km_s);
  visit("resolution_range_km", targets.resolution_range_km);
  visit("resolution_bearing_rad", targets.resolution_bearing_rad);
  visit("initial_position_sigma_km", targets.initial_position_sigma_km);
  visit("initial_velocity_sigma_km_s", targets.initial_velocity_sigma_km_s);
  visit("normalisation", kCostNormalisationWords, targets.normalisation);
}

/// And the part of the model that only they have.
template <typename Targets, typename Model, typename Visitor>
void visit_position_targets(Targets& targets, Model& model, Visitor visit) {
  visit("scene", kPositionSceneWords, targets.scene);
  visit("duration_s", targets.duration_s);
  visit("plot_sigma_km", targets.plot_sigma_km);
  visit("area_side_km", targets.area_side_km);
  visit("clutter", kClutterLawWords, targets.clutter);
  visit("clutter_per_km2", targets.clutter_per_km2);
  visit("clutter_spread_km", targets.clutter_spread_km);
  visit("quiet_scans", targets.quiet_scans);
  visit("manoeuvres", kManoeuvreModelWords, targets.manoeuvres);
  visit("singer_acceleration_sigma_km_s2", targets.singer_acceleration_sigma_km_s2);
  visit("singer_time_s", targets.singer_time_s);
  visit("update", kTrackUpdateWords, model.update);
}

template <typename Sensors, typename Visitor>
void visit_three_sensors(Sensors& sensors, Visitor visit) {
  visit("targets", sensors.targets);
  visit("layout", kSensorLayoutWords, sensors.layout);
  visit("sigma_per_spacing", sensors.sigma_per_spacing);
  visit("false_alarms_per_target", sensors.false_alarms_per_target);
}

/// What cannot be drawn from is refused here, before it is drawn from.
void check_position_targets(const PositionTargets& targets, const std::string& where) {
  constexpr double kMostPlotsPerKm2 = 100.0;
  const auto above_zero = [&](const char* name, double value) {
    if (!(value > 0.0)) throw InputError(fmt::format("{}: '{}' must be above 0", where, name));
  };
  above_zero("plot_sigma_km", targets.plot_sigma_km);
  above_zero("area_side_km", targets.area_side_km);
  above_zero("clutter_spread_km", targets.clutter_spread_km);
  above_zero("singer_time_s", targets.singer_time_s);
  if (!(targets.clutter_per_km2 >= 0.0 && targets.clutter_per_km2 <= kMostPlotsPerKm2)) {
    throw InputError(fmt::format("{}: 'clutter_per_km2' must be 0 to {}", where, kMostPlotsPerKm2));
  }
  if (targets.quiet_scans < 0) {
    throw InputError(fmt::format("{}: 'quiet_scans' must be 0 or more", where));
  }
}

struct Writer {
  Json& json;

  template <typename T>
  void operator()(const char* name, const T& value) const {
    json[name] = value;
  }
  template <typename Words, typename Choice>
  void operator()(const char* name, const Words& words, Choice choice) const {
    json[name] = word_of(words, choice);
  }
};

struct Reader {
  const Json& json;
  const std::string& where;

  [[nodiscard]] const Json& at(const char* name) const {
    const auto found = json.find(name);
    if (found == json.end()) throw InputError(fmt::format("{}: '{}' is missing", where, name));
    return *found;
  }
  template <typename T>
  void operator()(const char* name, T& value) const {
    const Json& field = at(name);
    const bool fits = std::is_integral_v<T> ? field.is_number_integer() : field.is_number();
    if (!fits) throw InputError(fmt::format("{}: '{}' must be a number", where, name));
    value = field.get<T>();
  }
  template <typename Words, typename Choice>
  void operator()(const char* name, const Words& words, Choice& choice) const {
    const Json& field = at(name);
    for (const auto& word : words) {
      if (field == word.text) {
        choice = word.choice;
        return;
      }
    }
    throw InputError(fmt::format("{}: '{}' is {}, which is no choice", where, name, field.dump()));
  }
};

/// The object of that name; nullptr if there is none.
const Json* object_in(const Json& json, const char* name, const std::string& where) {
  const auto found = json.find(name);
  if (found == json.end()) return nullptr;
  if (!found->is_object()) throw InputError(fmt::format("{}: '{}' must be an object", where, name));
  return &*found;
}

}  // namespace

Json json_of(const ScenarioSpec& spec) {
  Json json = Json::object();
  visit_fields(spec, Writer{json});
  if (!spec.draws_as.empty()) json[kDrawsAs] = spec.draws_as;
  if (spec.world.initial_targets > 0) json[kInitialTargets] = spec.world.initial_targets;
  if (spec.known_targets) visit_known_targets(*spec.known_targets, Writer{json[kKnownTargets]});
  if (spec.position_targets) {
    visit_position_targets(*spec.position_targets, spec.model, Writer{json[kPositionTargets]});
  }
  if (spec.three_sensors) visit_three_sensors(*spec.three_sensors, Writer{json[kThreeSensors]});
  return json;
}

ScenarioSpec spec_of(const std::string& name, const Json& json, const std::string& where) {
  if (!json.is_object()) throw InputError(where + ": it must be an object");
  ScenarioSpec spec;
  spec.name = name;
  visit_fields(spec, Reader{json, where});
  if (const auto draws_as = json.find(kDrawsAs); draws_as != json.end()) {
    if (!draws_as->is_string()) throw InputError(where + ": 'draws_as' must be a name");
    spec.draws_as = draws_as->get<std::string>();
  }
  if (json.contains(kInitialTargets)) {
    Reader{json, where}(kInitialTargets, spec.world.initial_targets);
  }
  if (const Json* targets = object_in(json, kKnownTargets, where)) {
    const std::string inside = where + ": known_targets";
    visit_known_targets(spec.known_targets.emplace(), Reader{*targets, inside});
  }
  if (const Json* targets = object_in(json, kPositionTargets, where)) {
    const std::string inside = where + ": position_targets";
    visit_position_targets(spec.position_targets.emplace(), spec.model, Reader{*targets, inside});
    check_position_targets(*spec.position_targets, inside);
  }
  if (const Json* sensors = object_in(json, kThreeSensors, where)) {
    const std::string inside = where + ": three_sensors";
    visit_three_sensors(spec.three_sensors.emplace(), Reader{*sensors, inside});
  }
  return spec;
}

}  // namespace mda
