#include "harness/spec_json.h"

#include <fmt/format.h>

#include "harness/errors.h"
#include "harness/words.h"

namespace mda {
namespace {

using Json = nlohmann::ordered_json;

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

}  // namespace

Json json_of(const ScenarioSpec& spec) {
  Json json = Json::object();
  visit_fields(spec, Writer{json});
  return json;
}

ScenarioSpec spec_of(const std::string& name, const Json& json, const std::string& where) {
  if (!json.is_object()) throw InputError(where + ": it must be an object");
  ScenarioSpec spec;
  spec.name = name;
  visit_fields(spec, Reader{json, where});
  return spec;
}

}  // namespace mda
