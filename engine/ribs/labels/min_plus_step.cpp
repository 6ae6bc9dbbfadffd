#include "engine/ribs/labels/min_plus_step.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

#include "engine/base/lanes.h"
#include "engine/ribs/labels/min_plus_line.h"

namespace spineloft::ribs {
namespace {

std::size_t index(int i) { return static_cast<std::size_t>(i); }

// out = min(a, b + offset) over a row of columns.
void keepLess(float* row, const float* other, float offset, std::size_t width) {
  for (std::size_t j = 0; j < width; ++j) row[j] = std::min(row[j], other[j] + offset);
}

// The labels [low, high) of the rib before that are free of charge for every label; both only ever
// move up. Returns the size of the largest window.
int findWindows(const MinPlusStep& t, int fromCount, int toCount, StepScratch& scratch) {
  scratch.low.resize(index(toCount));
  scratch.high.resize(index(toCount));
  int low = 0, high = 0, widest = 0;
  for (int k = 0; k < toCount; ++k) {
    const float first = t.to[k] - t.free, last = t.to[k] + t.free;
    while (low < fromCount && t.from[low] < first) ++low;
    while (high < fromCount && t.from[high] <= last) ++high;
    scratch.low[index(k)] = low;
    scratch.high[index(k)] = high;
    widest = std::max(widest, high - low);
  }
  return widest;
}

// The least of 2, 4, 8 … neighbouring rows of `width` entries from each row on, as far as windows of
// `widest` rows need them: two overlapping ones make any window. tables[j] is that of 2^j rows.
struct WindowTables {
  std::array<const float*, 32> tables{};
  static std::size_t power(int count) {
    return static_cast<std::size_t>(std::bit_width(static_cast<unsigned>(count)) - 1);
  }
};
// Narrower windows are looked through as they are.
constexpr int kWideWindow = 5;
WindowTables makeTables(const float* in, std::size_t entries, std::size_t width, int widest,
                        std::vector<float>& memory) {
  WindowTables made;
  made.tables[0] = in;
  if (widest < 2) return made;
  const std::size_t most = WindowTables::power(widest);
  if (memory.size() < most * entries) memory.resize(most * entries);
  const float* from = in;
  for (std::size_t p = 1; p <= most; ++p) {
    float* __restrict to = memory.data() + (p - 1) * entries;
    const std::size_t half = (std::size_t{1} << (p - 1)) * width;
    const std::size_t count = entries + width - 2 * half;
    for (std::size_t i = 0; i < count; ++i) {
      const float a = from[i], b = from[i + half];
      to[i] = b < a ? b : a;
    }
    made.tables[p] = from = to;
  }
  return made;
}

}  // namespace

MinPlusStep stepTo(const LengthProblem& p, const SideCosts& side, int rib) {
  const float s = side.spacing[index(rib - 1)];
  const std::size_t row = index(rib) * index(p.levels);
  return {&side.place[row], &side.place[row - index(p.levels)], p.neighbourWeight / s, p.neighbourFreedom * s,
          p.neighbourCap};
}

MinPlusStep stepFrom(const LengthProblem& p, const SideCosts& side, int rib) {
  MinPlusStep step = stepTo(p, side, rib);
  std::swap(step.to, step.from);
  return step;
}

namespace {

// The same for so few columns that a row stays in registers; windows are looked through as they are.
template <std::size_t kVectors>
struct FewColumns {
  std::array<Float4, kVectors> lanes;
  static FewColumns load(const float* from) {
    FewColumns row;
    for (std::size_t v = 0; v < kVectors; ++v) row.lanes[v] = load4(from + 4 * v);
    return row;
  }
  static FewColumns none() {
    FewColumns row;
    row.lanes.fill(all4(kUnreachable));
    return row;
  }
  void store(float* to) const {
    for (std::size_t v = 0; v < kVectors; ++v) store4(lanes[v], to + 4 * v);
  }
  FewColumns plus(float offset) const {
    FewColumns row;
    for (std::size_t v = 0; v < kVectors; ++v) row.lanes[v] = lanes[v] + all4(offset);
    return row;
  }
  void keepLess(const FewColumns& other) {
    for (std::size_t v = 0; v < kVectors; ++v) lanes[v] = least4(other.lanes[v], lanes[v]);
  }
};

template <std::size_t kVectors>
void convolveFew(const MinPlusStep& t, const MinPlusRows& rows, const float* in, float* out, StepScratch& scratch) {
  using Row = FewColumns<kVectors>;
  constexpr std::size_t kWidth = 4 * kVectors;
  findWindows(t, rows.fromCount, rows.toCount, scratch);
  Row best = Row::none(), running = Row::none();
  for (int k = 0; k < rows.fromCount; ++k) best.keepLess(Row::load(in + index(k) * kWidth));
  best = best.plus(t.cap);
  int taken = 0;
  for (int k = 0; k < rows.toCount; ++k) {
    const int low = scratch.low[index(k)], high = scratch.high[index(k)];
    for (; taken < low; ++taken) running.keepLess(Row::load(in + index(taken) * kWidth).plus(-t.slope * t.from[taken]));
    Row row = running.plus(t.slope * (t.to[k] - t.free));
    row.keepLess(best);
    for (int q = low; q < high; ++q) row.keepLess(Row::load(in + index(q) * kWidth));
    row.store(out + index(k) * kWidth);
  }
  running = Row::none();
  taken = rows.fromCount;
  for (int k = rows.toCount; k-- > 0;) {
    for (; taken > scratch.high[index(k)]; --taken)
      running.keepLess(Row::load(in + index(taken - 1) * kWidth).plus(t.slope * t.from[taken - 1]));
    Row row = Row::load(out + index(k) * kWidth);
    row.keepLess(running.plus(-t.slope * (t.to[k] + t.free)));
    row.store(out + index(k) * kWidth);
  }
}

}  // namespace

void convolveRows(const MinPlusStep& t, const MinPlusRows& rows, const float* in, float* out, StepScratch& scratch) {
  if (rows.width == 4) return convolveFew<1>(t, rows, in, out, scratch);
  if (rows.width == 8) return convolveFew<2>(t, rows, in, out, scratch);
  if (rows.width == 12) return convolveFew<3>(t, rows, in, out, scratch);
  const std::size_t w = index(rows.width);
  const int widest = findWindows(t, rows.fromCount, rows.toCount, scratch);
  // Tables pay where windows are wide.
  const bool tabled = widest >= kWideWindow;
  const WindowTables windows = makeTables(in, index(rows.fromCount) * w, w, tabled ? widest : 1, scratch.tables);
  scratch.running.assign(2 * w, kUnreachable);
  float* best = scratch.running.data();
  float* running = best + w;
  for (std::size_t k = 0; k < index(rows.fromCount); ++k) keepLess(best, in + k * w, 0, w);
  for (std::size_t j = 0; j < w; ++j) best[j] += t.cap;
  int taken = 0;
  for (int k = 0; k < rows.toCount; ++k) {
    const int low = scratch.low[index(k)], high = scratch.high[index(k)];
    for (; taken < low; ++taken) keepLess(running, in + index(taken) * w, -t.slope * t.from[taken], w);
    float* row = out + index(k) * w;
    const float offset = t.slope * (t.to[k] - t.free);
    if (high <= low) {
      for (std::size_t j = 0; j < w; ++j) row[j] = std::min(best[j], running[j] + offset);
      continue;
    }
    const float* source = in + index(low) * w;
    if (high == low + 1 || !tabled) {
      for (std::size_t j = 0; j < w; ++j) row[j] = std::min(std::min(best[j], running[j] + offset), source[j]);
      for (int q = low + 1; q < high; ++q) keepLess(row, in + index(q) * w, 0, w);
      continue;
    }
    const std::size_t p = WindowTables::power(high - low);
    const float* first = windows.tables[p] + index(low) * w;
    const float* last = windows.tables[p] + index(high - (1 << p)) * w;
    for (std::size_t j = 0; j < w; ++j) {
      row[j] = std::min(std::min(best[j], running[j] + offset), std::min(first[j], last[j]));
    }
  }
  std::fill(running, running + w, kUnreachable);
  taken = rows.fromCount;
  for (int k = rows.toCount; k-- > 0;) {
    for (; taken > scratch.high[index(k)]; --taken)
      keepLess(running, in + index(taken - 1) * w, t.slope * t.from[taken - 1], w);
    keepLess(out + index(k) * w, running, -t.slope * (t.to[k] + t.free), w);
  }
}

float oppositeCost(const LengthProblem& p, int rib, std::size_t l, std::size_t r) {
  const std::size_t n = index(p.levels), row = index(rib) * n;
  float cost = p.opposite.empty() ? 0.f : p.opposite[l * n + r];
  if (!p.medialOffsetScale.empty()) {
    const float apart = (1 - p.medialOffset) * p.left.place[row + l] - (1 + p.medialOffset) * p.right.place[row + r];
    cost += lesser(p.medialOffsetScale[index(rib)] * std::abs(apart), p.medialOffsetCap);
  }
  return cost;
}

void addOpposite(const LengthProblem& p, int rib, bool ofLeft, std::size_t other, float* costs) {
  const std::size_t n = index(p.levels), row = index(rib) * n;
  if (!p.opposite.empty()) {
    for (std::size_t k = 0; k < n; ++k)
      costs[k] += ofLeft ? oppositeCost(p, rib, k, other) : oppositeCost(p, rib, other, k);
    return;
  }
  if (p.medialOffsetScale.empty()) return;
  const float scale = p.medialOffsetScale[index(rib)];
  const float ownShare = ofLeft ? 1 - p.medialOffset : 1 + p.medialOffset;
  const float* own = &(ofLeft ? p.left : p.right).place[row];
  const float far =
      ofLeft ? (1 + p.medialOffset) * p.right.place[row + other] : (1 - p.medialOffset) * p.left.place[row + other];
  for (std::size_t k = 0; k < n; ++k) costs[k] += lesser(scale * std::abs(ownShare * own[k] - far), p.medialOffsetCap);
}

void leastOpposite(const LengthProblem& p, int rib, bool ofLeft, CostLine line, StepScratch& scratch) {
  const std::size_t n = index(p.levels);
  if (!p.opposite.empty()) {
    for (std::size_t k = 0; k < n; ++k) {
      line.out[k] = kUnreachable;
      for (std::size_t q = 0; q < n; ++q) {
        const float cost = ofLeft ? oppositeCost(p, rib, k, q) : oppositeCost(p, rib, q, k);
        line.out[k] = std::min(line.out[k], line.in[q] + cost);
      }
    }
    return;
  }
  // scale · |own − far|: a running minimum from either side, and from all where it costs its most.
  const float scale = p.medialOffsetScale[index(rib)];
  const float* own = &(ofLeft ? p.left : p.right).place[index(rib) * n];
  const float* far = &(ofLeft ? p.right : p.left).place[index(rib) * n];
  const float ownScale = scale * (ofLeft ? 1 - p.medialOffset : 1 + p.medialOffset);
  const float farScale = scale * (ofLeft ? 1 + p.medialOffset : 1 - p.medialOffset);
  scratch.running.resize(2 * (n + 1));
  float *below = scratch.running.data(), *above = below + n + 1;
  runningMinima({line.in, far, farScale}, n, below, above);
  const float capped = leastOf(line.in, n) + p.medialOffsetCap;
  std::size_t q = 0;
  for (std::size_t k = 0; k < n; ++k) {
    const float at = ownScale * own[k];
    while (q < n && farScale * far[q] <= at) ++q;
    line.out[k] = lesser(lesser(below[q] + at, above[q] - at), capped);
  }
}

}  // namespace spineloft::ribs
