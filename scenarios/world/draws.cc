#include "scenarios/world/draws.h"

#include <boost/random/normal_distribution.hpp>
#include <boost/random/poisson_distribution.hpp>
#include <boost/random/uniform_01.hpp>

namespace mda {
namespace {

/// Adds a value to a running hash: xor, then two multiply-shift rounds.
std::uint64_t absorb(std::uint64_t hash, std::uint64_t value) noexcept {
  hash ^= value + 0x9E3779B97F4A7C15ULL;
  hash = (hash ^ (hash >> 30)) * 0xBF58476D1CE4E5B9ULL;
  hash = (hash ^ (hash >> 27)) * 0x94D049BB133111EBULL;
  return hash ^ (hash >> 31);
}

}  // namespace

boost::random::mt19937_64 draws(const DrawKey& key) {
  std::uint64_t hash = absorb(0, key.seed);
  for (const char c : key.scenario) hash = absorb(hash, static_cast<unsigned char>(c));
  hash = absorb(hash, static_cast<std::uint64_t>(key.replicate));
  hash = absorb(hash, static_cast<std::uint64_t>(key.scan));
  hash = absorb(hash, static_cast<std::uint64_t>(key.purpose));
  return boost::random::mt19937_64(hash);
}

double draw_uniform(boost::random::mt19937_64& engine, double low, double high) {
  return low + (high - low) * boost::random::uniform_01<double>()(engine);
}

double draw_normal(boost::random::mt19937_64& engine, double sigma) {
  return boost::random::normal_distribution<double>(0.0, sigma)(engine);
}

int draw_poisson(boost::random::mt19937_64& engine, double mean) {
  return mean > 0.0 ? boost::random::poisson_distribution<int, double>(mean)(engine) : 0;
}

}  // namespace mda
