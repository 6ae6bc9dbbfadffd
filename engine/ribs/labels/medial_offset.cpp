#include "engine/ribs/labels/medial_offset.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <utility>

#include "engine/base/lanes.h"
#include "engine/base/shared_loop.h"

namespace spineloft::ribs {
namespace {

constexpr int kWidths = 64;
constexpr int kOffsets = 3;      // tried to either side of 0
constexpr int kRefinements = 2;  // halvings of the step around the best
// What a place costs that lies beyond the last label of a rib (the picture's frame): more than no
// evidence at all, less than a contradiction.
constexpr float kBeyondCost = 0.4f;

std::size_t index(int i) { return static_cast<std::size_t>(i); }

using Line = WidthTables::Line;
using Lines = std::vector<Line>;

void drawLines(const LengthProblem& p, const SideCosts& side, Lines& lines) {
  lines.resize(side.unary.size());
  for (std::size_t row = 0; row < side.unary.size(); row += index(p.levels)) {
    const std::size_t last = row + index(p.levels) - 1;
    for (std::size_t k = row; k < last; ++k) {
      const bool low = side.unary[k] < kUnreachable, high = side.unary[k + 1] < kUnreachable;
      Line line{side.place[k], side.place[k + 1], kBeyondCost, 0};
      if (low || high) line.base = side.unary[low ? k : k + 1];
      if (low && high) line.slope = (side.unary[k + 1] - side.unary[k]) / (line.next - line.place);
      lines[k] = line;
    }
    lines[last] = {side.place[last], side.place[last], kBeyondCost, 0};
  }
}

// The line on which a place lies, looked for from label `k` on, which moves there.
const Line& lineAt(std::span<const Line> row, float at, std::int32_t& k) {
  const std::int32_t most = std::max(0, static_cast<std::int32_t>(row.size()) - 2);
  while (k < most && row[index(k)].next <= at) ++k;
  while (k > 0 && row[index(k)].place > at) --k;
  return row[index(k)];
}

// Adds one side's costs at the places factor · width[j], interpolated between labels. `labels` is where to
// begin to look: where the rib before, of those of one share, had that place. All have an entry for every width.
void addSide(std::span<const Line> row, float factor, const std::vector<float>& widths, float* costs,
             std::int32_t* labels) {
  for (std::size_t j = 0; j < widths.size(); ++j) {
    const float at = factor * widths[j];
    const Line& line = lineAt(row, at, labels[j]);
    const float held = at < line.next ? at : line.next;
    costs[j] += line.base + line.slope * (held - line.place);
  }
}

// The same with four factors at once: `costs` and `labels` have `stride` entries for every width, of
// which the first four are meant.
struct FourColumns {
  float* costs;
  std::int32_t* labels;
  std::size_t stride;
};
void addSide(std::span<const Line> row, Float4 factors, const std::vector<float>& widths, const FourColumns& columns) {
  float* costs = columns.costs;
  std::int32_t* labels = columns.labels;
  for (const float width : widths) {
    const Float4 at = factors * width;
    const auto lineOf = [&](std::size_t q) { return load4(&lineAt(row, at[q], labels[q]).place); };
    const Float4 a = lineOf(0), b = lineOf(1), c = lineOf(2), d = lineOf(3);
    // Place, next place, base and slope of the four, each together.
    const Float4 ab = __builtin_shufflevector(a, b, 0, 4, 1, 5), cd = __builtin_shufflevector(c, d, 0, 4, 1, 5),
                 abLast = __builtin_shufflevector(a, b, 2, 6, 3, 7), cdLast = __builtin_shufflevector(c, d, 2, 6, 3, 7);
    const Float4 place = __builtin_shufflevector(ab, cd, 0, 1, 4, 5),
                 next = __builtin_shufflevector(ab, cd, 2, 3, 6, 7),
                 base = __builtin_shufflevector(abLast, cdLast, 0, 1, 4, 5),
                 slope = __builtin_shufflevector(abLast, cdLast, 2, 3, 6, 7);
    store4(load4(costs) + (base + slope * (least4(at, next) - place)), costs);
    costs += columns.stride;
    labels += columns.stride;
  }
}

void widthGrid(const LengthProblem& p, double narrowest, std::vector<float>& widths) {
  float widest = static_cast<float>(2 * narrowest);
  for (const SideCosts* side : {&p.left, &p.right}) {
    for (std::size_t i = 0; i < side->unary.size(); ++i) {
      if (side->unary[i] < kUnreachable) widest = std::max(widest, 2 * side->place[i]);
    }
  }
  widths.resize(kWidths);
  const double ratio = static_cast<double>(widest) / narrowest;
  for (int j = 0; j < kWidths; ++j) {
    widths[index(j)] = static_cast<float>(narrowest * std::pow(ratio, static_cast<double>(j) / (kWidths - 1)));
  }
}

// A few offsets with their energies; as many columns of the tables as SIMD likes.
constexpr std::size_t kMostOffsets = 12;
struct Offsets {
  std::array<double, kMostOffsets> offset{};
  std::array<double, kMostOffsets> energy{};
  std::size_t count = 0;
  void add(double one) { offset[count++] = one; }
  std::size_t columns() const { return count == 1 ? 1 : (count + 3) / 4 * 4; }
};

// Chains over widths of the problem's two sides under several offsets at once.
class WidthChains {
 public:
  WidthChains(const LengthProblem& p, double narrowest, double medialOffsetCost, LengthWorkspace& workspace)
      : problem_(p), medialOffsetCost_(medialOffsetCost), workspace_(workspace), t_(workspace.widths) {
    widthGrid(p, narrowest, t_.widths);
    drawLines(p, p.left, t_.left);
    drawLines(p, p.right, t_.right);
    // Both sides step by half a width, so costs between neighbours are doubled.
    LengthProblem& chain = t_.chain;
    chain.ribs = p.ribs;
    chain.levels = kWidths;
    chain.neighbourWeight = 2 * p.neighbourWeight;
    chain.neighbourFreedom = p.neighbourFreedom;
    chain.neighbourCap = 2 * p.neighbourCap;
    chain.left.spacing = p.left.spacing;
    chain.left.place.clear();
    for (int i = 0; i < p.ribs; ++i) {
      for (const float width : t_.widths) chain.left.place.push_back(0.5f * width);
    }
  }

  void findEnergies(Offsets& offsets) {
    fillCosts(offsets, t_.unary);
    leastEnergies(t_.chain, t_.chain.left, {t_.unary, static_cast<int>(offsets.columns())}, workspace_, t_.energies);
    for (std::size_t q = 0; q < offsets.count; ++q) offsets.energy[q] = static_cast<double>(t_.energies[q]);
  }

  void readWidths(WidthHypothesis& best) {
    Offsets one;
    one.add(best.medialOffset);
    fillCosts(one, t_.chain.left.unary);
    optimalChain(t_.chain, t_.chain.left, t_.chain.left.unary, workspace_, t_.labels);
    best.width.clear();
    for (const int label : t_.labels) best.width.push_back(t_.widths[index(label)]);
  }

 private:
  // Unary costs: ribs × widths × columns.
  void fillCosts(const Offsets& offsets, std::vector<float>& out) {
    const std::size_t columns = offsets.columns();
    out.resize(index(problem_.ribs) * kWidths * columns);
    const std::size_t places = 2 * kWidths * columns;
    t_.begin.assign(2 * places, 0);
    std::array<float, kMostOffsets> own{};
    for (std::size_t q = 0; q < offsets.count; ++q)
      own[q] = static_cast<float>(medialOffsetCost_ * std::abs(offsets.offset[q]));
    for (std::size_t at = 0; at < out.size(); at += columns)
      std::copy(own.begin(), own.begin() + static_cast<std::ptrdiff_t>(columns), &out[at]);
    // Columns that no offset has are like an even one.
    std::array<float, kMostOffsets> left{};
    for (std::size_t q = 0; q < columns; ++q) left[q] = static_cast<float>((1 + offsets.offset[q]) / 2);
    sharedLoop(problem_.ribs, [&](LoopShare of) {
      std::int32_t* labels = t_.begin.data() + index(of.who) * places;
      for (int i = of.first; i < of.end; ++i) {
        float* first = &out[index(i) * kWidths * columns];
        if (columns == 1) {
          addSide(rowOf(t_.left, i), left[0], t_.widths, first, labels);
          addSide(rowOf(t_.right, i), 1 - left[0], t_.widths, first, labels + kWidths);
          continue;
        }
        for (std::size_t q = 0; q < columns; q += 4) {
          const Float4 share = load4(&left[q]);
          addSide(rowOf(t_.left, i), share, t_.widths, {first + q, labels + q, columns});
          addSide(rowOf(t_.right, i), 1 - share, t_.widths, {first + q, labels + kWidths * columns + q, columns});
        }
      }
    });
  }

  std::span<const Line> rowOf(const Lines& lines, int rib) const {
    return std::span(lines).subspan(index(rib) * index(problem_.levels), index(problem_.levels));
  }

  const LengthProblem& problem_;
  double medialOffsetCost_;
  LengthWorkspace& workspace_;
  WidthTables& t_;
};

// Moves each offset to the better of its neighbours, in ever smaller steps.
void refine(WidthChains& chains, double step, Offsets& parts) {
  for (int round = 0; round < kRefinements; ++round) {
    step /= 2;
    Offsets tried;
    std::array<std::size_t, kMostOffsets> owner{};
    for (std::size_t i = 0; i < parts.count; ++i) {
      for (const double offset : {parts.offset[i] + step, parts.offset[i] - step}) {
        if (std::abs(offset) > kMostMedialOffset) continue;
        owner[tried.count] = i;
        tried.add(offset);
      }
    }
    chains.findEnergies(tried);
    for (std::size_t q = 0; q < tried.count; ++q) {
      double& energy = parts.energy[owner[q]];
      if (tried.energy[q] >= energy) continue;
      energy = tried.energy[q];
      parts.offset[owner[q]] = tried.offset[q];
    }
  }
}

}  // namespace

void fitWidthHypotheses(const LengthProblem& p, double narrowest, double medialOffsetCost, LengthWorkspace& workspace,
                        WidthHypotheses& parts) {
  WidthChains chains(p, narrowest, medialOffsetCost, workspace);
  const double step = kMostMedialOffset / kOffsets;
  Offsets tried, lowest;
  for (int i = -kOffsets; i <= kOffsets; ++i) tried.add(i * step);
  chains.findEnergies(tried);
  const auto& energy = tried.energy;
  // Local minima and the outermost: at most five, whose neighbours are at most ten.
  for (std::size_t i = 0; i < tried.count; ++i) {
    const bool outermost = i == 0 || i + 1 == tried.count;
    if (!outermost && !(energy[i] < energy[i - 1] && energy[i] <= energy[i + 1])) continue;
    lowest.energy[lowest.count] = energy[i];
    lowest.add(tried.offset[i]);
  }
  refine(chains, step, lowest);
  std::array<std::size_t, kMostOffsets> order{};
  const auto better = [&](std::size_t a, std::size_t b) {
    return std::pair(lowest.energy[a], std::abs(lowest.offset[a])) <
           std::pair(lowest.energy[b], std::abs(lowest.offset[b]));
  };
  for (std::size_t i = 0; i < lowest.count; ++i) {
    std::size_t place = i;
    for (; place > 0 && better(i, order[place - 1]); --place) order[place] = order[place - 1];
    order[place] = i;
  }
  const double most = lowest.energy[order[0]] + kRunnerUpEnergy * p.ribs;
  parts.count = 0;
  for (std::size_t i = 0; i < lowest.count && parts.count < kMostRunnersUp; ++i) {
    const std::size_t at = order[i];
    if (parts.count > 0 && lowest.energy[at] > most) break;
    WidthHypothesis& part = parts.all[parts.count++];
    part.medialOffset = lowest.offset[at];
    part.energy = lowest.energy[at];
    chains.readWidths(part);
  }
}

}  // namespace spineloft::ribs
