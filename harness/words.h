// The words for typed choices, as sweep files and manifests spell them.
#pragma once

#include <array>
#include <string_view>

#include "scenarios/spec.h"

namespace mda {

template <typename Choice>
struct Word {
  std::string_view text;
  Choice choice;
};

inline constexpr std::array<Word<Density>, 3> kDensityWords = {{
    {"literal", Density::kLiteral},
    {"jacobian", Density::kJacobian},
    {"polar-uniform", Density::kPolarUniform},
}};

inline constexpr std::array<Word<SecondPlot>, 4> kSecondPlotWords = {{
    {"two-point", SecondPlot::kTwoPoint},
    {"plain-ekf", SecondPlot::kPlainEkf},
    {"iterated-ekf", SecondPlot::kIteratedEkf},
    {"converted", SecondPlot::kConverted},
}};

inline constexpr std::array<Word<TrailingMisses>, 4> kTrailingMissesWords = {{
    {"all", TrailingMisses::kAll},
    {"allowed", TrailingMisses::kAllowed},
    {"live-only", TrailingMisses::kLiveOnly},
    {"none", TrailingMisses::kNone},
}};

inline constexpr std::array<Word<Newborn>, 2> kNewbornWords = {{
    {"two-plots", Newborn::kTwoPlots},
    {"single-plot", Newborn::kSinglePlot},
}};

inline constexpr std::array<Word<RowRule>, 2> kRowRuleWords = {{
    {"packing", RowRule::kPacking},
    {"equality", RowRule::kEquality},
}};

inline constexpr std::array<Word<Trajectories>, 2> kTrajectoriesWords = {{
    {"platoons", Trajectories::kPlatoons},
    {"crossing", Trajectories::kCrossing},
}};

inline constexpr std::array<Word<CostNormalisation>, 2> kCostNormalisationWords = {{
    {"clutter-density", CostNormalisation::kClutterDensity},
    {"literal", CostNormalisation::kLiteral},
}};

inline constexpr std::array<Word<TrackUpdate>, 2> kTrackUpdateWords = {{
    {"soft", TrackUpdate::kSoft},
    {"hard", TrackUpdate::kHard},
}};

inline constexpr std::array<Word<PositionScene>, 3> kPositionSceneWords = {{
    {"crossing", PositionScene::kCrossing},
    {"parallel", PositionScene::kParallel},
    {"ten", PositionScene::kTen},
}};

inline constexpr std::array<Word<ClutterLaw>, 2> kClutterLawWords = {{
    {"around-targets", ClutterLaw::kAroundTargets},
    {"uniform", ClutterLaw::kUniform},
}};

inline constexpr std::array<Word<ManoeuvreModel>, 2> kManoeuvreModelWords = {{
    {"constant-velocity", ManoeuvreModel::kConstantVelocity},
    {"singer", ManoeuvreModel::kSinger},
}};

inline constexpr std::array<Word<SensorLayout>, 2> kSensorLayoutWords = {{
    {"grid", SensorLayout::kGrid},
    {"random", SensorLayout::kRandom},
}};

/// The word for a choice; every choice has one.
template <typename Words, typename Choice>
[[nodiscard]] constexpr std::string_view word_of(const Words& words, Choice choice) {
  for (const auto& word : words) {
    if (word.choice == choice) return word.text;
  }
  return {};
}

}  // namespace mda
