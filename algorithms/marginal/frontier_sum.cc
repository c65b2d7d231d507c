#include "algorithms/marginal/frontier_sum.h"

#include <algorithm>
#include <cmath>
#include <new>
#include <utility>

namespace mda {
namespace {

constexpr std::size_t index(int i) noexcept { return static_cast<std::size_t>(i); }
constexpr std::align_val_t kAlignment{64};

constexpr std::size_t sets(int width) { return std::size_t{1} << width; }

/// Values that an array over the sets of `width` bits holds.
std::size_t length(int width) { return std::max(kChunk, sets(width)); }

/// Layers between two that are kept.
int segment_of(int layers) {
  return std::max(1, static_cast<int>(std::ceil(std::sqrt(static_cast<double>(layers)))));
}

/// Segments, the layers of one, and two for the way back.
int slabs(int layers) {
  const int segment = segment_of(layers);
  return (layers + segment - 1) / segment + segment + 2;
}

/// Sets of more bits than `width` are those of fewer, and none.
void widen(double* values, int width, int opened) {
  std::fill(values + sets(width), values + length(width + opened), 0.0);
}

/// Sums the bit out of F.
void close(double* values, int width, const Closing& closing) {
  const std::size_t run = sets(closing.slot);
  for (std::size_t out = 0; out < sets(width - 1); out += run) {
    const double* without = values + 2 * out;
    for (std::size_t i = 0; i < run; ++i) {
      values[out + i] = closing.free * without[i] + without[run + i];
    }
  }
}

/// The way back: B does not ask whether a bit that has left is taken, but for its weight if not.
void reopen(double* values, int width, const Closing& closing) {
  const std::size_t run = sets(closing.slot);
  for (std::size_t out = sets(width); out > 0;) {
    out -= run;
    double* without = values + 2 * out;
    for (std::size_t i = 0; i < run; ++i) {
      const double value = values[out + i];
      without[run + i] = value;
      without[i] = closing.free * value;
    }
  }
}

/// By a power of 2, so that the largest value is near 1: no sum overflows or vanishes.
void rescale(double* values, int width) {
  const double largest = *std::max_element(values, values + sets(width));
  const double factor = std::ldexp(1.0, -std::ilogb(largest));
  for (std::size_t s = 0; s < sets(width); ++s) values[s] *= factor;
}

}  // namespace

void FrontierSum::FreeAligned::operator()(double* values) const noexcept {
  ::operator delete[](values, kAlignment);
}

double FrontierSum::bytes(int layers, int width) {
  return std::ldexp(static_cast<double>(sizeof(double)) * slabs(layers),
                    std::max(width, kChunkBits));
}

void FrontierSum::make_room(const std::vector<FrontierStep>& steps) {
  int width = 0;
  for (const FrontierStep& step : steps) width = std::max(width, step.width);
  slab_size_ = length(width);
  const int count = slabs(static_cast<int>(steps.size()));
  const std::size_t needed = slab_size_ * index(count);
  if (needed > room_) {
    values_.reset();
    values_.reset(new (kAlignment) double[needed]);
    room_ = needed;
  }
  ahead_ = slab(count - 2);
  spare_ = slab(count - 1);
}

bool FrontierSum::solve(const std::vector<FrontierStep>& steps, const Budget& budget,
                        std::span<double> probability) {
  make_room(steps);
  const int layers = static_cast<int>(steps.size());
  const int segment = segment_of(layers);
  const int segments = (layers + segment - 1) / segment;
  const auto kept = [&](int number) { return slab(number); };
  const auto recent = [&](int step) { return slab(segments + step % segment); };
  kept(0)[0] = 1.0;
  widen(kept(0), 0, steps.front().opened);
  for (int l = 0; l < (segments - 1) * segment; ++l) {
    if (budget.expired()) return false;
    const double* from = l % segment == 0 ? kept(l / segment) : recent(l);
    const bool keep = (l + 1) % segment == 0;
    double* to = keep ? kept((l + 1) / segment) : recent(l + 1);
    advance(steps, l, from, to);
    if (keep) rescale(to, steps[index(l + 1)].width);
  }
  ahead_[0] = 1.0;
  widen(ahead_, 0, 0);
  for (int s = segments - 1; s >= 0; --s) {
    const int begin = s * segment;
    const int end = std::min(layers, begin + segment);
    for (int l = begin; l + 1 < end; ++l) {
      if (budget.expired()) return false;
      advance(steps, l, l == begin ? kept(s) : recent(l), recent(l + 1));
    }
    for (int l = end - 1; l >= begin; --l) {
      if (budget.expired()) return false;
      retreat(steps[index(l)], l, l == begin ? kept(s) : recent(l), probability);
    }
    rescale(ahead_, steps[index(begin)].width - steps[index(begin)].opened);
  }
  return true;
}

void FrontierSum::advance(const std::vector<FrontierStep>& steps, int step, const double* from,
                          double* to) const {
  const FrontierStep& now = steps[index(step)];
  kernel_.forward(now.weights, length(now.width) / kChunk, step + 1, from, to);
  int width = now.width;
  for (const Closing& closing : now.closings) close(to, width--, closing);
  widen(to, width, steps[index(step) + 1].opened);
}

void FrontierSum::retreat(const FrontierStep& step, int step_number, const double* before,
                          std::span<double> probability) {
  int width = step.width - static_cast<int>(step.closings.size());
  for (auto closing = step.closings.rbegin(); closing != step.closings.rend(); ++closing) {
    reopen(ahead_, width++, *closing);
  }
  if (width < kChunkBits) widen(ahead_, width, 0);
  kernel_.backward(step.weights, length(width) / kChunk, step_number, before, ahead_, spare_,
                   sums_);
  std::swap(ahead_, spare_);
  if (width - step.opened < kChunkBits) widen(ahead_, width - step.opened, 0);
  double total = step.weights.none * sums_.none;
  for (const MaskedPair& pair : step.pairs) {
    total += step.weights.bit[index(pair.slot)] * sums_.bit[index(pair.slot)];
  }
  for (const MaskedPair& pair : step.pairs) {
    const double weight = step.weights.bit[index(pair.slot)] * sums_.bit[index(pair.slot)];
    probability[index(pair.pair)] = weight / total;
  }
  for (const PrivatePair& pair : step.privates) {
    probability[index(pair.pair)] = pair.weight * sums_.none / total;
  }
}

}  // namespace mda
