#include "engine/loft/chords.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace spineloft::loft {
namespace {

/// How far back a chord looks for one that it may follow.
constexpr std::size_t kLookBack = 64;
/// How many chords on either side a chord must not cross: with a short one between them, two that
/// are not neighbours can cross beyond its end.
constexpr std::size_t kNear = 8;

bool cross(const Chord& a, const Chord& b) {
  const PicturePoint da = a.across(), db = b.across();
  const double left = spineloft::cross(da, b.left - a.left);
  const double right = spineloft::cross(da, b.right - a.left);
  if ((left > 0) == (right > 0) && left != 0 && right != 0) return false;
  const double otherLeft = spineloft::cross(db, a.left - b.left);
  const double otherRight = spineloft::cross(db, a.right - b.left);
  return left * right < 0 && otherLeft * otherRight < 0;
}

/// Unit direction of travel between two chords.
PicturePoint travel(const Chord& a, const Chord& b) {
  return normalized(forwardOf(normalized(a.across()) + normalized(b.across())));
}

/// Whether the chord crosses none of the others.
bool isClear(const Chord& chord, std::span<const Chord> others) {
  return std::none_of(others.begin(), others.end(), [&](const Chord& other) { return cross(chord, other); });
}

/// The first or last `kNear` chords of a row.
std::span<const Chord> firstFew(std::span<const Chord> row) { return row.first(std::min(kNear, row.size())); }
std::span<const Chord> lastFew(std::span<const Chord> row) { return row.last(std::min(kNear, row.size())); }

bool inOrder(std::span<const Chord> row, const ChordLimits& limits) {
  for (std::size_t i = 1; i < row.size(); ++i) {
    if (!follows(row[i - 1], row[i], limits) || !isClear(row[i], lastFew(row.first(i - 1)))) {
      return false;
    }
  }
  return true;
}

/// Into `memory.run`: the indices of a long sequence in which each chord follows the one before and crosses none of
/// the few before that: the longest, if the best ways to the earlier chords are part of it.
void findLongestRun(std::span<const Chord> chords, const ChordLimits& limits, ChordMemory& memory) {
  const std::size_t n = chords.size();
  std::vector<std::size_t>&length = memory.length, &previous = memory.previous, &run = memory.run;
  length.assign(n, 1);
  previous.assign(n, n);
  std::size_t best = 0;
  const auto chainIsClear = [&](std::size_t i, std::size_t j) {
    for (std::size_t step = 1; step < kNear && previous[j] != n; ++step) {
      j = previous[j];
      if (cross(chords[i], chords[j])) return false;
    }
    return true;
  };
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t back = 1; back <= std::min(i, kLookBack); ++back) {
      const std::size_t j = i - back;
      if (length[j] + 1 > length[i] && follows(chords[j], chords[i], limits) && chainIsClear(i, j)) {
        length[i] = length[j] + 1;
        previous[i] = j;
      }
    }
    if (length[i] > length[best]) best = i;
  }
  run.clear();
  for (std::size_t i = best; i < n; i = previous[i]) run.push_back(i);
  std::reverse(run.begin(), run.end());
}

/// Chords between a and b that were left out come back where they fit, with the end that is in the
/// way moved onto the line between the ends of a and b. Appends to `out`, whose last chord is a;
/// `ahead` begins with b.
void fillGap(std::span<const Chord> left, std::span<const Chord> ahead, const ChordLimits& limits,
             std::vector<Chord>& out) {
  const Chord a = out.back(), b = ahead.front();
  for (std::size_t k = 0; k < left.size(); ++k) {
    const double t = static_cast<double>(k + 1) / static_cast<double>(left.size() + 1);
    const double at = left[k].at;
    const Chord even{lerp(a.left, b.left, t), lerp(a.right, b.right, t), at};
    std::array<Chord, 3> ways = {Chord{even.left, left[k].right, at}, Chord{left[k].left, even.right, at}, even};
    if (distance(left[k].right, even.right) < distance(left[k].left, even.left)) {
      std::swap(ways[0], ways[1]);  // move the nearer end
    }
    for (const Chord& way : {left[k], ways[0], ways[1], ways[2]}) {
      if (way.width() < limits.width || !follows(out.back(), way, limits) || !follows(way, b, limits) ||
          !isClear(way, lastFew(out)) || !isClear(way, firstFew(ahead))) {
        continue;
      }
      out.push_back(way);
      break;
    }
  }
}

/// On one side, runs of ends that go backwards while their chords cross gather in their mean (pool
/// adjacent violators; Ayer et al. 1955, in the plane). Linear.
void gatherEnds(std::vector<Chord>& chords, PicturePoint Chord::* side, std::vector<ChordMemory::Block>& blocks) {
  using Block = ChordMemory::Block;
  blocks.clear();
  const auto chordOf = [&](const Block& block, std::size_t at) {
    Chord chord = chords[at];
    chord.*side = block.mean();
    return chord;
  };
  for (std::size_t i = 0; i < chords.size(); ++i) {
    blocks.push_back({chords[i].*side, i, 1});
    while (blocks.size() >= 2) {
      Block& before = blocks[blocks.size() - 2];
      const Block& block = blocks.back();
      const Chord a = chordOf(before, before.first + before.count - 1);
      const Chord b = chordOf(block, block.first);
      if (!cross(a, b) || dot(travel(a, b), block.mean() - before.mean()) >= 0) break;
      before.sum += block.sum;
      before.count += block.count;
      blocks.pop_back();
    }
  }
  for (const Block& block : blocks) {
    for (std::size_t i = block.first; i < block.first + block.count; ++i) {
      chords[i].*side = block.mean();
    }
  }
}

/// Ends that coincide with their predecessor's move ahead.
void partEnds(std::vector<Chord>& chords, const ChordLimits& limits) {
  for (std::size_t i = 1; i < chords.size(); ++i) {
    const Chord& before = chords[i - 1];
    Chord& chord = chords[i];
    const bool left = distance(before.left, chord.left) < limits.spacing;
    const bool right = distance(before.right, chord.right) < limits.spacing;
    if (!left && !right) continue;
    const PicturePoint step = travel(before, chord) * limits.spacing;
    if (left) chord.left = before.left + step;
    if (right) chord.right = before.right + step;
  }
}

}  // namespace

double sweptArea(const Chord& a, const Chord& b) { return spineloft::cross(b.right - a.left, a.right - b.left); }

bool follows(const Chord& a, const Chord& b, const ChordLimits& limits) {
  const PicturePoint da = a.across(), db = b.across();
  const double wa = norm(da), wb = norm(db);
  constexpr double kTurnedAbout = -0.5;  // cosine: more than 120° from one chord to the next
  if (dot(da, db) < kTurnedAbout * wa * wb) return false;
  if (sweptArea(a, b) < limits.spacing * (wa + wb) / 2) return false;
  return !cross(a, b);
}

void widenChords(std::vector<Chord>& chords, const ChordLimits& limits) {
  const std::size_t n = chords.size();
  for (std::size_t i = 0; i < n; ++i) {
    const double width = chords[i].width();
    if (width >= limits.width) continue;
    const PicturePoint middle = chords[i].middle();
    PicturePoint across = normalized(chords[i].across());
    // A direction that is only rounding says nothing: take the one square to the line of middles.
    if (width < limits.width * 1e-3) {
      const PicturePoint ahead = chords[std::min(i + 1, n - 1)].middle() - chords[i > 0 ? i - 1 : 0].middle();
      const PicturePoint square = normalized(PicturePoint{-ahead.y, ahead.x});
      if (square != PicturePoint{}) across = square;
    }
    if (across == PicturePoint{}) across = {0, 1};
    chords[i].left = middle - across * (limits.width / 2);
    chords[i].right = middle + across * (limits.width / 2);
  }
}

void orderChords(std::vector<Chord>& row, const ChordLimits& limits, ChordMemory& memory) {
  if (!inOrder(row, limits)) {
    const std::vector<std::size_t>& run = memory.run;
    findLongestRun(row, limits, memory);
    if (run.size() * 5 < row.size() * 3) {
      // Not a few that stray but a bend tighter than the part is wide: no majority to follow.
      gatherEnds(row, &Chord::left, memory.blocks);
      gatherEnds(row, &Chord::right, memory.blocks);
      partEnds(row, limits);
      findLongestRun(row, limits, memory);
    }
    std::vector<Chord>&kept = memory.kept, &out = memory.out;
    kept.clear();
    out.clear();
    out.reserve(row.size());
    for (const std::size_t at : run) kept.push_back(row[at]);
    for (std::size_t k = 0; k < run.size(); ++k) {
      if (k > 0 && run[k] - run[k - 1] > 1) {
        const auto gap = std::span(row).subspan(run[k - 1] + 1, run[k] - run[k - 1] - 1);
        fillGap(gap, std::span(kept).subspan(k), limits, out);
      }
      out.push_back(kept[k]);
    }
    row.assign(out.begin(), out.end());
  }
  partEnds(row, limits);
}

std::vector<Chord> orderChords(std::vector<Chord> chords, const ChordLimits& limits) {
  ChordMemory memory;
  orderChords(chords, limits, memory);
  return chords;
}

void spreadChords(std::vector<Chord>& chords, const ChordLimits& limits) {
  std::size_t kept = std::min<std::size_t>(1, chords.size());
  for (std::size_t i = kept; i < chords.size(); ++i) {
    const Chord &before = chords[kept - 1], &chord = chords[i];
    Chord moved = chord;
    constexpr int kRounds = 4;  // moving an end turns the chord a little, so look again
    bool ahead = false;
    for (int round = 0; round < kRounds && !ahead; ++round) {
      ahead = true;
      for (const PicturePoint across : {before.across(), moved.across()}) {
        const PicturePoint forward = normalized(forwardOf(across));
        for (auto end : {&Chord::left, &Chord::right}) {
          const double lead = dot(moved.*end - before.*end, forward);
          if (lead >= limits.spacing) continue;
          ahead = false;
          moved.*end += forward * (1.5 * limits.spacing - lead);
        }
      }
    }
    const double shift = std::max(distance(moved.left, chord.left), distance(moved.right, chord.right));
    if (ahead && shift <= 0.25 * chord.width() + 8 * limits.spacing && moved.width() >= limits.width / 2 &&
        dot(moved.across(), before.across()) > 0) {
      chords[kept++] = moved;
    }
  }
  chords.resize(kept);
}

}  // namespace spineloft::loft
