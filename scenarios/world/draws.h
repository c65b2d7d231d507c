// Random draws, keyed by what they are for: the same key gives the same numbers on every machine
// and in every order of work.
#pragma once

#include <boost/random/mersenne_twister.hpp>
#include <cstdint>
#include <string_view>

namespace mda {

enum class Purpose : std::uint64_t {
  kBirths = 1,
  kMotion,
  kDetections,
  kFalseAlarms,
  kPlayingOrder,
  kInitialStates,
  kPositions,
  kReportOrder
};

struct DrawKey {
  std::uint64_t seed = 1;
  std::string_view scenario;
  int replicate = 1;
  int scan = 1;
  Purpose purpose = Purpose::kBirths;
};

/// A generator of its own for every key; use it with Boost's distributions only (those of the
/// standard library differ between implementations).
[[nodiscard]] boost::random::mt19937_64 draws(const DrawKey& key);

[[nodiscard]] double draw_uniform(boost::random::mt19937_64& engine, double low, double high);

/// Of mean 0.
[[nodiscard]] double draw_normal(boost::random::mt19937_64& engine, double sigma);

/// `mean` >= 0.
[[nodiscard]] int draw_poisson(boost::random::mt19937_64& engine, double mean);

}  // namespace mda
