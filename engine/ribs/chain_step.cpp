#include "engine/ribs/chain_step.h"

#include <algorithm>
#include <cmath>

namespace spineloft::ribs {
namespace {

std::size_t index(int i) { return static_cast<std::size_t>(i); }

// out = min(a, b + offset) over a row of columns.
void keepLess(float* row, const float* other, float offset, std::size_t width) {
  for (std::size_t j = 0; j < width; ++j) row[j] = std::min(row[j], other[j] + offset);
}

// The labels [low, high) of the rib before that are free of charge for a label standing at `to`;
// low and high only ever move up as `to` does.
void moveWindow(const ChainStep& t, int count, float to, int& low, int& high) {
  while (low < count && t.from[low] < to - t.free) ++low;
  while (high < count && t.from[high] <= to + t.free) ++high;
}

}  // namespace

ChainStep stepTo(const LengthProblem& p, const SideCosts& side, int rib) {
  const float s = side.spacing[index(rib - 1)];
  const std::size_t row = index(rib) * index(p.levels);
  return {&side.place[row], &side.place[row - index(p.levels)], p.neighbourWeight / s,
          p.neighbourFreedom * s, p.neighbourCap};
}

ChainStep stepFrom(const LengthProblem& p, const SideCosts& side, int rib) {
  ChainStep step = stepTo(p, side, rib);
  std::swap(step.to, step.from);
  return step;
}

void convolveRows(const ChainStep& t, const ChainRows& rows, const float* in, float* out,
                  std::vector<float>& scratch) {
  const std::size_t w = index(rows.width);
  scratch.assign(2 * w, kUnreachable);
  float* best = scratch.data();
  float* running = best + w;
  for (std::size_t k = 0; k < index(rows.fromCount); ++k) keepLess(best, in + k * w, 0, w);
  for (std::size_t j = 0; j < w; ++j) best[j] += t.cap;
  int low = 0, high = 0, taken = 0;
  for (int k = 0; k < rows.toCount; ++k) {
    moveWindow(t, rows.fromCount, t.to[k], low, high);
    for (; taken < low; ++taken)
      keepLess(running, in + index(taken) * w, -t.slope * t.from[taken], w);
    float* row = out + index(k) * w;
    const float offset = t.slope * (t.to[k] - t.free);
    if (high == low + 1) {
      const float* source = in + index(low) * w;
      for (std::size_t j = 0; j < w; ++j) {
        row[j] = std::min(std::min(best[j], running[j] + offset), source[j]);
      }
      continue;
    }
    for (std::size_t j = 0; j < w; ++j) row[j] = std::min(best[j], running[j] + offset);
    for (int q = low; q < high; ++q) keepLess(row, in + index(q) * w, 0, w);
  }
  std::fill(running, running + w, kUnreachable);
  taken = rows.fromCount;
  for (int k = rows.toCount; k-- > 0;) {
    while (taken > 0 && t.from[taken - 1] > t.to[k] + t.free) {
      --taken;
      keepLess(running, in + index(taken) * w, t.slope * t.from[taken], w);
    }
    keepLess(out + index(k) * w, running, -t.slope * (t.to[k] + t.free), w);
  }
}

void convolveLine(const ChainStep& t, int count, const float* in, float* out) {
  const float best = *std::min_element(in, in + count) + t.cap;
  float running = kUnreachable;
  int low = 0, high = 0, taken = 0;
  for (int k = 0; k < count; ++k) {
    moveWindow(t, count, t.to[k], low, high);
    for (; taken < low; ++taken) running = std::min(running, in[taken] - t.slope * t.from[taken]);
    float least = std::min(best, running + t.slope * (t.to[k] - t.free));
    for (int q = low; q < high; ++q) least = std::min(least, in[q]);
    out[k] = least;
  }
  running = kUnreachable;
  taken = count;
  for (int k = count; k-- > 0;) {
    while (taken > 0 && t.from[taken - 1] > t.to[k] + t.free) {
      --taken;
      running = std::min(running, in[taken] + t.slope * t.from[taken]);
    }
    out[k] = std::min(out[k], running - t.slope * (t.to[k] + t.free));
  }
}

float oppositeCost(const LengthProblem& p, int rib, std::size_t l, std::size_t r) {
  const std::size_t n = index(p.levels), row = index(rib) * n;
  float cost = p.opposite.empty() ? 0.f : p.opposite[l * n + r];
  if (!p.leanScale.empty()) {
    cost += p.leanScale[index(rib)] *
            std::abs((1 - p.lean) * p.left.place[row + l] - (1 + p.lean) * p.right.place[row + r]);
  }
  return cost;
}

void leastOpposite(const LengthProblem& p, int rib, bool ofLeft, const float* other, float* least) {
  const std::size_t n = index(p.levels);
  if (!p.opposite.empty()) {
    for (std::size_t k = 0; k < n; ++k) {
      least[k] = kUnreachable;
      for (std::size_t q = 0; q < n; ++q) {
        const float cost = ofLeft ? oppositeCost(p, rib, k, q) : oppositeCost(p, rib, q, k);
        least[k] = std::min(least[k], other[q] + cost);
      }
    }
    return;
  }
  // scale · |own − far|: a running minimum from either side.
  const float scale = p.leanScale[index(rib)];
  const float* own = &(ofLeft ? p.left : p.right).place[index(rib) * n];
  const float* far = &(ofLeft ? p.right : p.left).place[index(rib) * n];
  const float ownScale = scale * (ofLeft ? 1 - p.lean : 1 + p.lean);
  const float farScale = scale * (ofLeft ? 1 + p.lean : 1 - p.lean);
  float running = kUnreachable;
  std::size_t q = 0;
  for (std::size_t k = 0; k < n; ++k) {
    const float at = ownScale * own[k];
    for (; q < n && farScale * far[q] <= at; ++q)
      running = std::min(running, other[q] - farScale * far[q]);
    least[k] = running + at;
  }
  running = kUnreachable;
  q = n;
  for (std::size_t k = n; k-- > 0;) {
    const float at = ownScale * own[k];
    for (; q > 0 && farScale * far[q - 1] > at; --q)
      running = std::min(running, other[q - 1] + farScale * far[q - 1]);
    least[k] = std::min(least[k], running - at);
  }
}

}  // namespace spineloft::ribs
