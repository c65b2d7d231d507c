#include "algorithms/certified/recombination.h"

#include <algorithm>
#include <unordered_map>

#include "algorithms/certified/enumeration.h"

namespace mda {
namespace {

constexpr std::size_t index(int i) noexcept { return static_cast<std::size_t>(i); }
constexpr int kMostNodes = 3000;  // of a part

/// What a choice has in a part, in numbers of the window.
struct Piece {
  std::vector<int> origins;
  Steps cost = 0;
};

/// Of every choice in every part: pieces[part][choice].
std::vector<std::vector<Piece>> cut_up(const Packing& packing, const std::vector<Part>& parts,
                                       std::span<const std::vector<int>> choices) {
  std::unordered_map<int, std::size_t> part_of_origin;
  for (std::size_t p = 0; p < parts.size(); ++p) {
    for (const int origin : parts[p].packing.origin) part_of_origin[origin] = p;
  }
  std::vector<std::vector<Piece>> pieces(parts.size(), std::vector<Piece>(choices.size()));
  for (std::size_t c = 0; c < choices.size(); ++c) {
    for (const int j : choices[c]) {
      const int origin = packing.origin[index(j)];
      Piece& piece = pieces[part_of_origin.at(origin)][c];
      piece.origins.push_back(origin);
      piece.cost += packing.cost[index(j)];
    }
  }
  return pieces;
}

std::vector<int> best_of(const Part& part, std::vector<Piece> pieces, const Budget& budget) {
  Piece& best = *std::ranges::min_element(pieces, {}, &Piece::cost);
  Pricing pricing;
  price(part.packing, part.prices, pricing);
  const Enumeration found =
      enumerate(part.packing, part.prices, pricing, best.cost, kMostNodes, budget);
  return found.choice ? origins_of(part.packing, *found.choice) : std::move(best.origins);
}

}  // namespace

std::vector<int> recombined(const Packing& packing, std::span<const Steps> prices,
                            std::span<const char> alive, std::span<const std::vector<int>> choices,
                            const Budget& budget) {
  std::vector<Part> parts = parts_of(packing, prices, alive);
  std::vector<std::vector<Piece>> pieces = cut_up(packing, parts, choices);
  std::unordered_map<int, int> column_of_origin;
  for (int j = 0; j < packing.columns(); ++j) {
    if (alive[index(j)] != 0) column_of_origin[packing.origin[index(j)]] = j;
  }
  std::vector<int> columns;
  for (std::size_t p = 0; p < parts.size(); ++p) {
    for (const int origin : best_of(parts[p], std::move(pieces[p]), budget)) {
      columns.push_back(column_of_origin.at(origin));
    }
  }
  return columns;
}

}  // namespace mda
