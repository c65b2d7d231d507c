// What a scenario is made of. Where the papers are silent or contradict themselves, the choice is a
// typed field here, and its alternatives are the other values of its type.
#pragma once

#include <numbers>
#include <optional>
#include <string>

namespace mda {

/// What happens, and what the radar sees of it (Storms & Spieksma 2003, section 4 and Table 1).
/// The radar stands at the origin; lengths in km, times in s, angles in rad.
struct World {
  int scans = 30;
  double scan_period_s = 8.0;
  double detection_probability = 0.9;
  double range_km = 50.0;
  double range_sigma_km = 0.015;
  double bearing_sigma_rad = 0.0052;
  double speed_min_km_s = 0.1;
  double speed_max_km_s = 1.0;
  /// Standard deviation of each axis' acceleration, drawn anew for every scan period.
  double acceleration_sigma_km_s2 = 5e-5;
  /// Targets appear uniformly in a square.
  double birth_centre_x_km = 0.0;
  double birth_centre_y_km = 0.0;
  double birth_side_km = 100.0;
  int initial_targets = 0;        ///< born in the first scan, beside the Poisson ones
  double births_per_scan = 1.0;   ///< Poisson mean, lambda_nu
  double clutter_per_scan = 1.0;  ///< Poisson mean, lambda_phi; uniform in the area of coverage
  int target_life_scans = 0;      ///< scans after which a target vanishes; 0: never
};

/// Units of the false-alarm density f_phi in equation (6), where f_delta is per km rad.
enum class Density {
  kLiteral,      ///< 1 / (pi R^2), as printed: per km^2
  kJacobian,     ///< r / (pi R^2), the same density per km rad
  kPolarUniform  ///< 1 / (2 pi R), uniform in range and bearing
};

/// How the state is made from the first two plots of a track. The gate and f_delta of the second
/// plot are those of the one-plot prior in any case.
enum class SecondPlot {
  kTwoPoint,     ///< position of the second plot, velocity by differencing
  kPlainEkf,     ///< one EKF update; linearised at the first plot, it loses many true links
  kIteratedEkf,  ///< the update relinearised at its own result
  kConverted     ///< a Kalman update with the plot converted to Cartesian coordinates
};

/// Which misses after the last plot are charged -ln(1 - P_d) each.
enum class TrailingMisses {
  kAll,       ///< all, also the one that ends the track
  kAllowed,   ///< not the one that ends the track
  kLiveOnly,  ///< those of tracks that have not ended
  kNone       ///< none
};

/// Which hypotheses become columns.
enum class Newborn {
  kTwoPlots,   ///< a track has two plots at least
  kSinglePlot  ///< a single plot may be a new target
};

enum class RowRule {
  kPacking,  ///< at-most-once rows, no columns for false alarms
  kEquality  ///< exactly-once rows, and a column of cost 0 for every plot and track as false alarm
};

/// How a track of PositionTargets takes marginals; choices of plots always move it as they say.
enum class TrackUpdate {
  kSoft,  ///< by all plots at once, each as probable as its marginal
  kHard   ///< by the assignment that is cheapest when a column costs -ln of its marginal
};

/// What the tracker assumes; the default is the set that comes nearest to the published tables.
struct TrackerModel {
  Density density = Density::kLiteral;
  SecondPlot second_plot = SecondPlot::kTwoPoint;
  TrailingMisses trailing_misses = TrailingMisses::kAll;
  Newborn newborn = Newborn::kTwoPlots;
  RowRule rows = RowRule::kPacking;
  double gate = 9.21;  ///< eta^2 of equation (14): chi-square, 2 degrees of freedom
  int max_misses = 2;  ///< p: subsequent missed detections that a track survives
  /// Standard deviation of a newborn's velocity on each axis, as a share of the top speed.
  double velocity_prior = 0.57735026918962576;
  TrackUpdate update = TrackUpdate::kSoft;
};

/// The two scenes of Battistelli et al. 2008, section IV. Their figures give no coordinates, so the
/// shapes are ours; scenarios/known/trajectories.h states them.
enum class Trajectories {
  kPlatoons,  ///< scenario 1: two platoons of ten that pass through each other
  kCrossing   ///< scenario 2: three manoeuvring targets that meet twice
};

/// What the likelihood of a plot is divided by before its logarithm is a cost.
enum class CostNormalisation {
  kClutterDensity,  ///< by the density of clutter: a cost without units
  kLiteral          ///< by 1 per m rad m/s, as equation (II.1) is printed; only for the test that
                    ///< shows why not: nearly every plot then costs more than a miss
};

/// Targets that are all known from the start and never end, on fixed trajectories, seen in range,
/// bearing and range rate by a radar of finite resolution (Battistelli et al. 2008, section IV).
struct KnownTargets {
  Trajectories trajectories = Trajectories::kPlatoons;
  double lateral_spacing_km = 0.25;                   ///< of platoons: between neighbours
  double axis_heading_rad = -std::numbers::pi / 6.0;  ///< of crossing: from the x axis
  double duration_s = 300.0;                          ///< a last, broken scan period is left out
  double range_rate_sigma_km_s = 0.001;
  /// Plots that are nearer to each other than both become one. 0: perfect resolution.
  double resolution_range_km = 0.05;
  double resolution_bearing_rad = std::numbers::pi / 180.0;
  /// Of the initial estimates, one scan period before the first scan, on each axis.
  double initial_position_sigma_km = 0.03;
  double initial_velocity_sigma_km_s = 0.003;
  CostNormalisation normalisation = CostNormalisation::kClutterDensity;
};

/// Which of the ten targets of Lee & Jeong 1998, Table 1, there are.
enum class PositionScene {
  kCrossing,  ///< 1 and 2
  kParallel,  ///< 3 and 4
  kTen        ///< all
};

/// Where clutter falls. The paper has it normal around the targets; of which spread, and what its
/// density is a density of, it does not say.
enum class ClutterLaw {
  kAroundTargets,  ///< a normal cloud around the true position of every target
  kUniform         ///< alike everywhere in the area
};

/// What the filter takes the targets for that manoeuvre, 8 and 9.
enum class ManoeuvreModel {
  kConstantVelocity,  ///< like the others
  kSinger             ///< Singer 1970: an acceleration that fades away and is renewed
};

/// Targets on fixed trajectories that are all known from the start and never end, seen as positions
/// in the plane, one scan at a time (Lee & Jeong 1998, section IV).
struct PositionTargets {
  PositionScene scene = PositionScene::kCrossing;
  double duration_s = 40.0;     ///< a last, broken scan period is left out
  double plot_sigma_km = 0.15;  ///< on each axis
  double area_side_km = 20.0;   ///< of the square, centred on the origin, of uniform clutter
  ClutterLaw clutter = ClutterLaw::kAroundTargets;
  double clutter_per_km2 = 0.2;  ///< in the centre of each cloud, or everywhere
  /// Standard deviation of a cloud on each axis. Fitted: the track maintenance of Table 3.
  double clutter_spread_km = 0.5;
  /// First scans, without clutter, as the tracker knows; every target is detected in them, as it
  /// does not.
  int quiet_scans = 5;
  ManoeuvreModel manoeuvres = ManoeuvreModel::kConstantVelocity;
  double singer_acceleration_sigma_km_s2 = 0.02;
  double singer_time_s = 10.0;  ///< in which an acceleration fades to 1/e
};

/// Where the targets of three sensors stand: in a square of one target per unit of area.
enum class SensorLayout {
  kGrid,   ///< in the middles of the cells of a square grid; their number is a square
  kRandom  ///< uniformly, drawn anew for every replicate
};

/// Three sensors that see the same targets in the plane at one instant (Bojilov 1995, section 5).
/// The unit of length is the mean distance of the targets, the root of area per target.
struct ThreeSensors {
  int targets = 36;
  SensorLayout layout = SensorLayout::kGrid;
  /// Standard deviation of a report on each axis.
  double sigma_per_spacing = 0.2;
  /// Poisson mean of a sensor's false alarms, as a share of the number of targets; uniform in the
  /// square. The paper does not say how many there were.
  double false_alarms_per_target = 0.1;
};

struct ScenarioSpec {
  std::string name;
  std::string summary;  ///< one line for people
  World world;
  TrackerModel model;
  /// If there, targets are these, and the births, speeds, lives and coverage of the world, the
  /// model but for its gate (chi-square, 3 degrees of freedom), and World::scans do not count.
  /// The number of clutter plots is then clutter_per_scan in every scan.
  std::optional<KnownTargets> known_targets = std::nullopt;
  /// If there, targets are these, and of the world only the scan period, the detection probability
  /// and the acceleration (the filter's, of constant velocity) count, of the model only its gate
  /// (chi-square, 2 degrees of freedom) and the update.
  std::optional<PositionTargets> position_targets = std::nullopt;
  /// If there, the scene is one instant of three sensors, and of the world only the detection
  /// probability counts, of the model the rows and the gate (chi-square, 2 degrees of freedom):
  /// reports farther apart are in no column. At most one of the three kinds is there.
  std::optional<ThreeSensors> three_sensors = std::nullopt;
  /// Name of the scenario whose random draws this one uses, so that they differ in nothing else;
  /// empty: its own. Of scenarios with known or position targets only.
  std::string draws_as = {};
};

}  // namespace mda
