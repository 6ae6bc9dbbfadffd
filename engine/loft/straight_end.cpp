#include "engine/loft/straight_end.h"

#include <algorithm>
#include <optional>
#include <ranges>

#include "engine/loft/caps.h"

namespace spineloft::loft {
namespace {

/// Where the spine ends, and its unit direction there, outwards.
struct SpineEnd {
  PicturePoint at, along;
  double beyond(PicturePoint p) const { return dot(p - at, along); }
};

/// The direction is taken over a quarter of the part's `width`: the last few points alone are too noisy.
template <class Ribs>
std::optional<SpineEnd> endOf(const Ribs& inwards, double width) {
  const ribs::Rib* last = nullptr;
  for (const ribs::Rib& rib : inwards) {
    if (!isFinite(rib.center)) continue;
    if (last == nullptr) last = &rib;
    const PicturePoint way = last->center - rib.center;
    if (norm(way) >= width / 4) return SpineEnd{last->center, normalized(way)};
  }
  return std::nullopt;
}

/// The last end of a side that is not beyond, and where the side is cut between it and the next one.
struct SideCut {
  std::size_t before = 0;
  PicturePoint at;
};
std::optional<SideCut> cutOf(const std::vector<Chord>& chords, PicturePoint Chord::* side, const SpineEnd& end) {
  for (std::size_t i = chords.size(); i-- > 0;) {
    const double here = end.beyond(chords[i].*side);
    if (here > 0) continue;
    if (i + 1 == chords.size()) return SideCut{i, chords[i].*side};
    const double next = end.beyond(chords[i + 1].*side);
    return SideCut{i, lerp(chords[i].*side, chords[i + 1].*side, -here / (next - here))};
  }
  return std::nullopt;
}

/// Cuts the end of `chords`.
void cutEnd(std::vector<Chord>& chords, const SpineEnd& end) {
  const auto left = cutOf(chords, &Chord::left, end);
  const auto right = cutOf(chords, &Chord::right, end);
  if (!left || !right) return;
  const std::size_t keep = std::min(left->before, right->before) + 1;
  const std::size_t until = std::max(left->before, right->before) + 1;
  if (keep < 2) return;
  const Chord cut{left->at, right->at, chords.back().at};
  // Both sides: slanted ribs reach beyond the end on one.
  double leftMost = 0, rightMost = 0;
  for (std::size_t i = keep; i < chords.size(); ++i) {
    leftMost = std::max(leftMost, end.beyond(chords[i].left));
    rightMost = std::max(rightMost, end.beyond(chords[i].right));
  }
  if (std::min(leftMost, rightMost) <= kFlatSlack * cut.width() / 2) return;
  // Where one side goes on, the other one waits: their ends go to the cut in even steps.
  const Chord base = chords[keep - 1];
  for (std::size_t i = keep; i < until; ++i) {
    const double t = static_cast<double>(i - keep + 1) / static_cast<double>(until - keep + 1);
    if (i > left->before) chords[i].left = lerp(base.left, cut.left, t);
    if (i > right->before) chords[i].right = lerp(base.right, cut.right, t);
  }
  chords.resize(until);
  if (chords.back().left == cut.left && chords.back().right == cut.right) return;
  chords.push_back(cut);
}

void turnAbout(std::vector<Chord>& chords) {
  std::reverse(chords.begin(), chords.end());
  for (Chord& chord : chords) chord = flipped(chord);
}

bool isStraight(sections::CapStyle style) {
  return style == sections::CapStyle::Flat || style == sections::CapStyle::Open;
}

double widest(const std::vector<Chord>& chords) {
  double width = 0;
  for (const Chord& chord : chords) width = std::max(width, chord.width());
  return width;
}

}  // namespace

void cutStraightEnds(std::vector<Chord>& chords, const ribs::RibSet& set, const LoftParams& params) {
  if (chords.size() < 3) return;
  const double width = widest(chords);
  if (isStraight(params.endCap)) {
    if (const auto end = endOf(set.ribs | std::views::reverse, width)) cutEnd(chords, *end);
  }
  if (isStraight(params.startCap)) {
    turnAbout(chords);
    if (const auto end = endOf(set.ribs, width)) cutEnd(chords, *end);
    turnAbout(chords);
  }
}

}  // namespace spineloft::loft
