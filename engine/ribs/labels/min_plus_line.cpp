#include "engine/ribs/labels/min_plus_line.h"

#include <algorithm>
#include <bit>
#include <utility>

#include "engine/base/lanes.h"
#include "engine/ribs/labels/min_plus_step.h"

namespace spineloft::ribs {
namespace {

constexpr std::size_t kLanes = 4;

std::size_t index(int i) { return static_cast<std::size_t>(i); }

MinPlusStep stepOf(const LengthProblem& p, const SideCosts& side, StepWay way, int rib) {
  return way == StepWay::Forwards ? stepTo(p, side, rib) : stepFrom(p, side, rib);
}

// The first entry from `at` on for which `holds`, a comparison of lanes, does not. Most often it is one of the
// next few: without a branch for each of them.
template <class Holds>
int firstWithout(const float* entries, int count, int at, const Holds& holds) {
  constexpr int kStep = static_cast<int>(kLanes);
  while (at + kStep <= count) {
    const int held = std::countr_one(lanes4(holds(load4(entries + at))));
    at += held;
    if (held < kStep) return at;
  }
  while (at < count && lanes4(holds(all4(entries[at]))) != 0) ++at;
  return at;
}

// The windows of one step; returns how often the widest of them doubles.
std::uint8_t planStep(const MinPlusStep& t, int count, StepPlan::Window* windows) {
  int low = 0, high = 0, most = 0;
  for (int k = 0; k < count; ++k) {
    const float first = t.to[k] - t.free, last = t.to[k] + t.free;
    low = firstWithout(t.from, count, low, [first](Float4 from) { return from < all4(first); });
    high = firstWithout(t.from, count, high, [last](Float4 from) { return from <= all4(last); });
    const int size = std::max(0, high - low);
    const int doubled = size < 2 ? 0 : std::bit_width(static_cast<unsigned>(size)) - 1;
    most = std::max(most, doubled);
    const auto entry = [](int at) { return static_cast<std::uint16_t>(at); };
    const int table = 1 + doubled * count;  // the entry before all tables is that of an empty window
    windows[k] = {entry(low), entry(high), entry(size == 0 ? 0 : table + low),
                  entry(size == 0 ? 0 : table + high - (1 << doubled))};
  }
  return static_cast<std::uint8_t>(most);
}

// Without a way out on the first difference, which would keep it from being SIMD.
bool same(const std::vector<float>& a, const std::vector<float>& b) {
  if (a.size() != b.size()) return false;
  std::uint32_t different = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    different |= std::bit_cast<std::uint32_t>(a[i]) ^ std::bit_cast<std::uint32_t>(b[i]);
  return different == 0;
}

void makePlan(const LengthProblem& p, const SideCosts& side, StepWay way, StepPlan& plan) {
  const bool known =
      plan.freedom == p.neighbourFreedom && same(plan.spacing, side.spacing) && same(plan.place, side.place);
  if (known) return;
  plan.place = side.place;
  plan.spacing = side.spacing;
  plan.freedom = p.neighbourFreedom;
  plan.windows.resize(side.place.size());
  plan.doublings.resize(index(p.ribs));
  for (int i = 1; i < p.ribs; ++i)
    plan.doublings[index(i)] = planStep(stepOf(p, side, way, i), p.levels, &plan.windows[index(i) * index(p.levels)]);
}

// Lane 0 stays where it is, the others take from `before`, which is beyond all values, and so on.
Float4 movedUp(Float4 v, Float4 before) { return __builtin_shufflevector(before, v, 0, 4, 5, 6); }
Float4 movedUpTwice(Float4 v, Float4 before) { return __builtin_shufflevector(before, v, 0, 1, 4, 5); }
Float4 movedDown(Float4 v, Float4 after) { return __builtin_shufflevector(after, v, 5, 6, 7, 0); }
Float4 movedDownTwice(Float4 v, Float4 after) { return __builtin_shufflevector(after, v, 6, 7, 0, 1); }

// After an entry that is beyond all values: the costs themselves, the lesser of two neighbours each,
// of four, …; entries that would need labels beyond the last are not set.
void fillTables(const float* in, std::size_t n, int doublings, float* tables) {
  tables[0] = kUnreachable;
  std::copy(in, in + n, tables + 1);
  for (int p = 1; p <= doublings; ++p) {
    const float* from = tables + 1 + index(p - 1) * n;
    float* to = tables + 1 + index(p) * n;
    const std::size_t half = std::size_t{1} << (p - 1), count = n + 1 - 2 * half;
    std::size_t i = 0;
    for (; i + kLanes <= count; i += kLanes) store4(least4(load4(from + i), load4(from + i + half)), to + i);
    for (; i < count; ++i) to[i] = lesser(from[i], from[i + half]);
  }
}

}  // namespace

void runningMinima(const SlopedLine& line, std::size_t n, float* below, float* above) {
  const float *in = line.in, *place = line.place;
  const Float4 none = all4(kUnreachable), slope = all4(line.slope);
  const std::size_t whole = n / kLanes * kLanes;
  below[0] = above[n] = kUnreachable;
  for (std::size_t i = n; i-- > whole;) above[i] = lesser(in[i] + line.slope * place[i], above[i + 1]);
  Float4 under = none, over = all4(above[whole]);
  for (std::size_t i = 0; i < whole; i += kLanes) {
    Float4 up = load4(in + i) - slope * load4(place + i);
    up = least4(movedUp(up, none), up);
    up = least4(movedUpTwice(up, none), up);
    under = least4(up, under);
    store4(under, below + 1 + i);
    under = __builtin_shufflevector(under, under, 3, 3, 3, 3);
    const std::size_t j = whole - kLanes - i;
    Float4 down = load4(in + j) + slope * load4(place + j);
    down = least4(movedDown(down, none), down);
    down = least4(movedDownTwice(down, none), down);
    over = least4(down, over);
    store4(over, above + j);
    over = __builtin_shufflevector(over, over, 0, 0, 0, 0);
  }
  for (std::size_t i = whole; i < n; ++i) below[i + 1] = lesser(in[i] - line.slope * place[i], below[i]);
}

MinPlusLine::MinPlusLine(const LengthProblem& problem, const SideCosts& side, StepWay way, LengthWorkspace& workspace)
    : problem_(problem), side_(side), way_(way), scratch_(workspace.step) {
  auto& plans = way == StepWay::Forwards ? workspace.forwards : workspace.backwards;
  StepPlan& plan = plans[&side == &problem.right ? 1 : 0];
  makePlan(problem, side, way, plan);
  plan_ = &plan;
}

void MinPlusLine::step(int rib, CostLine line) const {
  const std::size_t n = index(problem_.levels);
  const MinPlusStep t = stepOf(problem_, side_, way_, rib);
  const int doublings = plan_->doublings[index(rib)];
  scratch_.running.resize(2 * (n + 1));
  scratch_.tables.resize(std::max(scratch_.tables.size(), 1 + n * index(doublings + 1)));
  float *below = scratch_.running.data(), *above = below + n + 1, *tables = scratch_.tables.data();
  runningMinima({line.in, t.from, t.slope}, n, below, above);
  const float most = leastOf(line.in, n) + t.cap;
  fillTables(line.in, n, doublings, tables);
  const StepPlan::Window* w = &plan_->windows[index(rib) * n];
  std::size_t k = 0;
  for (; k + kLanes <= n; k += kLanes, w += kLanes) {
    const Float4 to = load4(t.to + k);
    const Float4 under{below[w[0].low], below[w[1].low], below[w[2].low], below[w[3].low]};
    const Float4 over{above[w[0].high], above[w[1].high], above[w[2].high], above[w[3].high]};
    const Float4 first{tables[w[0].first], tables[w[1].first], tables[w[2].first], tables[w[3].first]};
    const Float4 second{tables[w[0].second], tables[w[1].second], tables[w[2].second], tables[w[3].second]};
    const Float4 sloped =
        least4(under + all4(t.slope) * (to - all4(t.free)), over - all4(t.slope) * (to + all4(t.free)));
    store4(least4(least4(sloped, all4(most)), least4(first, second)), line.out + k);
  }
  for (; k < n; ++k, ++w) {
    const float under = below[w->low] + t.slope * (t.to[k] - t.free);
    const float over = above[w->high] - t.slope * (t.to[k] + t.free);
    line.out[k] = lesser(lesser(lesser(under, over), most), lesser(tables[w->first], tables[w->second]));
  }
}

}  // namespace spineloft::ribs
