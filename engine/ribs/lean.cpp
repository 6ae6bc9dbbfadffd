#include "engine/ribs/lean.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>

namespace spineloft::ribs {
namespace {

constexpr int kWidths = 64;
constexpr int kLeans = 3;        // tried to either side of 0
constexpr int kRefinements = 2;  // halvings of the step around the best
// What a place costs that lies beyond the last label of a rib (the picture's frame): more than no
// evidence at all, less than a contradiction.
constexpr float kBeyondCost = 0.4f;

std::size_t index(int i) { return static_cast<std::size_t>(i); }

// One side's costs between its labels, as lines: from place k on, base + slope · (at − place), as far as
// the next place.
struct Line {
  float place, next, base, slope;
};
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

// Adds one side's costs at the places factor · width[j], interpolated between labels, to every
// `stride`-th of `costs`. `labels[j]` is where to begin to look: where the rib before had that place.
void addSide(std::span<const Line> row, float factor, const std::vector<float>& widths,
             float* costs, std::size_t stride, std::int32_t* labels) {
  const std::int32_t most = std::max(0, static_cast<std::int32_t>(row.size()) - 2);
  for (std::size_t j = 0; j < widths.size(); ++j) {
    const float at = factor * widths[j];
    std::int32_t k = labels[j];
    while (k < most && row[index(k)].next <= at) ++k;
    while (k > 0 && row[index(k)].place > at) --k;
    labels[j] = k;
    const Line& line = row[index(k)];
    const float held = at < line.next ? at : line.next;
    costs[j * stride] += line.base + line.slope * (held - line.place);
  }
}

std::vector<float> widthGrid(const LengthProblem& p, double narrowest) {
  float widest = static_cast<float>(2 * narrowest);
  for (const SideCosts* side : {&p.left, &p.right}) {
    for (std::size_t i = 0; i < side->unary.size(); ++i) {
      if (side->unary[i] < kUnreachable) widest = std::max(widest, 2 * side->place[i]);
    }
  }
  std::vector<float> widths(kWidths);
  const double ratio = static_cast<double>(widest) / narrowest;
  for (int j = 0; j < kWidths; ++j) {
    widths[index(j)] =
        static_cast<float>(narrowest * std::pow(ratio, static_cast<double>(j) / (kWidths - 1)));
  }
  return widths;
}

// Chains over widths of the problem's two sides under several leans at once.
class WidthChains {
 public:
  WidthChains(const LengthProblem& p, double narrowest, double leanCost)
      : problem_(p), leanCost_(leanCost), widths_(widthGrid(p, narrowest)) {
    drawLines(p, p.left, left_);
    drawLines(p, p.right, right_);
    // Both sides step by half a width, so costs between neighbours are doubled.
    chain_.ribs = p.ribs;
    chain_.levels = kWidths;
    chain_.neighbourWeight = 2 * p.neighbourWeight;
    chain_.neighbourFreedom = p.neighbourFreedom;
    chain_.neighbourCap = 2 * p.neighbourCap;
    chain_.left.spacing = p.left.spacing;
    chain_.left.place.reserve(index(p.ribs) * kWidths);
    for (int i = 0; i < p.ribs; ++i) {
      for (float width : widths_) chain_.left.place.push_back(0.5f * width);
    }
  }

  // Unary costs: ribs × widths × leans.
  std::vector<float> costs(const std::vector<double>& leans) const {
    std::vector<float> own;
    for (const double lean : leans) own.push_back(static_cast<float>(leanCost_ * std::abs(lean)));
    std::vector<std::int32_t> begin(2 * kWidths * leans.size(), 0);
    std::vector<float> out;
    out.reserve(index(problem_.ribs) * kWidths * leans.size());
    for (int i = 0; i < problem_.ribs * kWidths; ++i) out.insert(out.end(), own.begin(), own.end());
    for (int i = 0; i < problem_.ribs; ++i) {
      for (std::size_t q = 0; q < leans.size(); ++q) {
        float* first = &out[index(i) * kWidths * leans.size() + q];
        const auto left = static_cast<float>((1 + leans[q]) / 2);
        std::int32_t* labels = &begin[2 * q * kWidths];
        addSide(rowOf(left_, i), left, widths_, first, leans.size(), labels);
        addSide(rowOf(right_, i), 1 - left, widths_, first, leans.size(),
                labels + kWidths);
      }
    }
    return out;
  }

  std::vector<float> energies(const std::vector<double>& leans, LengthWorkspace& workspace) const {
    return leastEnergies(chain_, chain_.left, costs(leans), static_cast<int>(leans.size()),
                         workspace);
  }

  void readWidths(EvenPart& best, LengthWorkspace& workspace) {
    chain_.left.unary = costs({best.lean});
    best.width.clear();
    for (int label : optimalSide(chain_, chain_.left, workspace)) {
      best.width.push_back(widths_[index(label)]);
    }
  }

 private:
  std::span<const Line> rowOf(const Lines& lines, int rib) const {
    return std::span(lines).subspan(index(rib) * index(problem_.levels), index(problem_.levels));
  }

  const LengthProblem& problem_;
  double leanCost_;
  Lines left_, right_;
  std::vector<float> widths_;
  LengthProblem chain_;
};

// Moves each part's lean to the better of its neighbours, in ever smaller steps.
void refine(const WidthChains& chains, double step, std::vector<EvenPart>& parts,
            LengthWorkspace& workspace) {
  for (int round = 0; round < kRefinements; ++round) {
    step /= 2;
    std::vector<double> leans;
    std::vector<std::size_t> owner;
    for (std::size_t i = 0; i < parts.size(); ++i) {
      for (const double lean : {parts[i].lean + step, parts[i].lean - step}) {
        if (std::abs(lean) > kMostLean) continue;
        leans.push_back(lean);
        owner.push_back(i);
      }
    }
    const std::vector<float> energies = chains.energies(leans, workspace);
    for (std::size_t q = 0; q < leans.size(); ++q) {
      EvenPart& part = parts[owner[q]];
      if (static_cast<double>(energies[q]) >= part.energy) continue;
      part.energy = static_cast<double>(energies[q]);
      part.lean = leans[q];
    }
  }
}

}  // namespace

std::vector<EvenPart> findEvenParts(const LengthProblem& p, double narrowest, double leanCost,
                                    LengthWorkspace& workspace) {
  WidthChains chains(p, narrowest, leanCost);
  const double step = kMostLean / kLeans;
  std::vector<double> leans;
  for (int i = -kLeans; i <= kLeans; ++i) leans.push_back(i * step);
  const std::vector<float> energies = chains.energies(leans, workspace);
  const auto energy = [&](std::size_t i) { return static_cast<double>(energies[i]); };
  std::vector<EvenPart> parts;
  for (std::size_t i = 0; i < leans.size(); ++i) {
    const bool outermost = i == 0 || i + 1 == leans.size();
    const bool lowest = outermost || (energy(i) < energy(i - 1) && energy(i) <= energy(i + 1));
    if (lowest) parts.push_back({leans[i], {}, energy(i)});
  }
  refine(chains, step, parts, workspace);
  std::ranges::sort(
      parts, {}, [](const EvenPart& part) { return std::pair(part.energy, std::abs(part.lean)); });
  const double most = parts.front().energy + kRivalEnergy * p.ribs;
  while (parts.size() > 1 && (parts.size() > kMostRivals || parts.back().energy > most)) {
    parts.pop_back();
  }
  for (EvenPart& part : parts) chains.readWidths(part, workspace);
  return parts;
}

}  // namespace spineloft::ribs
