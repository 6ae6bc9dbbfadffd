#include "engine/inflate/row_lines.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>

#include "engine/geometry/corners.h"
#include "engine/geometry/polygon.h"
#include "engine/geometry/polyline.h"
#include "engine/geometry/spread.h"
#include "engine/inflate/crossing.h"

namespace spineloft::inflate {
namespace {

constexpr double kOutline = 1 - 1e-9;  ///< s of the outline itself
constexpr double kLevels = 1 << 24;    ///< levels from 0 to 1: those of both sides of a slice are the same
constexpr double kOfWidth = 0.25;      ///< of the half width, between points of a row
constexpr double kOfAway = 1.2;        ///< of the distance to the skeleton
constexpr double kTurn = 0.25;         ///< radians that a row within turns by from point to point
constexpr double kNearest = 0.3;       ///< of what the place allows: what bends within less is a corner
constexpr double kLeastInRow = 6;

/// How far a line turns along each of its stretches, radians: each half of what it turns by at its ends, by lengths.
std::vector<double> turnsAlong(const Row& line) {
  const std::size_t n = line.size();
  std::vector<double> turns(n, 0.0);
  SectionPoint in = line[0].at - line[n - 1].at;
  double before = norm(in);
  for (std::size_t i = 0; i < n; ++i) {
    const SectionPoint out = line[(i + 1) % n].at - line[i].at;
    const double after = norm(out), lengths = before + after;
    // 2 tan(turn/2); a reversal is a corner anyway.
    const double turn = 2 * std::abs(cross(in, out)) / std::max(1e-3 * before * after, before * after + dot(in, out));
    if (lengths > 0) {
      turns[(i + n - 1) % n] += turn * before / lengths;
      turns[i] += turn * after / lengths;
    }
    in = out;
    before = after;
  }
  return turns;
}

/// The closed line with points so far apart as the place, times `wider`, and the line's turning allow, `turn` radians
/// from point to point, even between corners, which stay.
Row resampled(const Row& line, double spacing, double wider, double turn) {
  const std::size_t n = line.size();
  std::vector<SectionPoint> closed;
  std::vector<double> steps(n + 1, 0.0);
  const std::vector<double> turns = turnsAlong(line);
  double finest = spacing;
  for (std::size_t i = 0; i < n; ++i) {
    const LevelPoint &a = line[i], &b = line[(i + 1) % n];
    const double place = std::min(kOfWidth * (a.half + b.half) / 2, kOfAway * (a.away + b.away) / 2);
    const double most = std::max(1e-9, std::min(spacing, wider * place));
    const double even = distance(a.at, b.at) / most;
    steps[i + 1] = steps[i] + std::clamp(turns[i] / turn, even, even / kNearest);
    finest = std::min(finest, most);
    closed.push_back(a.at);
  }
  closed.push_back(closed.front());
  // Corners by the way along the line, then by steps.
  const std::vector<double> s = geometry::arcLengths(std::span<const SectionPoint>(closed));
  std::vector<double> corners =
      geometry::cornersOf(std::span<const SectionPoint>(closed), std::span<const double>(s), finest);
  for (double& corner : corners) {
    corner = steps[static_cast<std::size_t>(std::ranges::lower_bound(s, corner) - s.begin())];
  }
  if (corners.empty()) corners.push_back(0);
  const auto pieces = static_cast<double>(corners.size());
  Row out;
  for (std::size_t c = 0; c < corners.size(); ++c) {
    const double from = corners[c], to = c + 1 < corners.size() ? corners[c + 1] : corners[0] + steps[n];
    const auto count = static_cast<int>(std::ceil(std::max(to - from, kLeastInRow / pieces) - 1e-9));
    for (int k = 0; k < count; ++k) {
      const double at = std::fmod(from + (to - from) * k / count, steps[n]);
      const auto after = std::ranges::upper_bound(steps, at);
      const std::size_t i = std::min(static_cast<std::size_t>(after - steps.begin()), n) - 1;
      const LevelPoint &a = line[i], &b = line[(i + 1) % n];
      const double span = steps[i + 1] - steps[i], way = span > 0 ? std::clamp((at - steps[i]) / span, 0.0, 1.0) : 0;
      out.push_back(lerp(a, b, way));
    }
  }
  return out;
}

/// Short stretches of lines, and whether any two cross: only those in one cell of a grid are compared.
class Stretches {
 public:
  void add(SectionPoint from, SectionPoint to) {
    all_.push_back({from, to});
    low_ = {std::min(low_.x, from.x), std::min(low_.y, from.y)};
    high_ = {std::max(high_.x, from.x), std::max(high_.y, from.y)};
    length_ += distance(from, to);
  }
  bool cross() {
    if (all_.empty()) return false;
    constexpr double kMostCells = 512, kOfLength = 0.5;  // a side; rows lie nearer to each other than their points
    cell_ = std::max({kOfLength * length_ / static_cast<double>(all_.size()), (high_.x - low_.x) / kMostCells,
                      (high_.y - low_.y) / kMostCells, 1e-9});
    wide_ = placeOf(high_.x - low_.x) + 1;
    std::vector<std::uint32_t> first(wide_ * (placeOf(high_.y - low_.y) + 1) + 1, 0);
    for (const auto& stretch : all_) eachCell(stretch, [&](std::size_t cell) { ++first[cell + 1]; });
    for (std::size_t i = 1; i < first.size(); ++i) first[i] += first[i - 1];
    std::vector<std::uint32_t> within(first.back()), next(first);
    bool crossed = false;
    for (std::uint32_t i = 0; i < all_.size() && !crossed; ++i) {
      const auto& [a, b] = all_[i];
      eachCell(all_[i], [&](std::size_t cell) {
        for (std::uint32_t k = first[cell]; k < next[cell]; ++k) {
          const auto& [c, d] = all_[within[k]];
          crossed = crossed || crossing(a, b, c, d);
        }
        within[next[cell]++] = i;
      });
    }
    return crossed;
  }

 private:
  using Stretch = std::array<SectionPoint, 2>;
  std::size_t placeOf(double way) const { return static_cast<std::size_t>(way / cell_); }
  template <class Visit>
  void eachCell(const Stretch& stretch, const Visit& visit) const {
    const auto [left, right] = std::minmax({stretch[0].x - low_.x, stretch[1].x - low_.x});
    const auto [below, above] = std::minmax({stretch[0].y - low_.y, stretch[1].y - low_.y});
    for (std::size_t y = placeOf(below); y <= placeOf(above); ++y) {
      for (std::size_t x = placeOf(left); x <= placeOf(right); ++x) visit(y * wide_ + x);
    }
  }

  std::vector<Stretch> all_;
  SectionPoint low_{INFINITY, INFINITY}, high_{-INFINITY, -INFINITY};
  double length_ = 0, cell_ = 1;
  std::size_t wide_ = 1;
};

std::vector<SectionPoint> placesOf(std::span<const LevelPoint> line) {
  std::vector<SectionPoint> out;
  for (const LevelPoint& p : line) out.push_back(p.at);
  return out;
}

}  // namespace

const std::vector<Row>& RowTable::at(const ProfileRow& row) {
  std::vector<double> levels;
  for (const SectionPoint p : row) levels.push_back(std::round(p.x * kLevels) / kLevels);
  const auto found = rows_.find(levels);
  if (found != rows_.end()) return found->second;
  const bool outline = std::ranges::all_of(levels, [](double level) { return level >= kOutline; });
  std::vector<Row> made = !outline ? traced(levels) : way_.chords ? chords() : outlines();
  return rows_[std::move(levels)] = std::move(made);
}

std::vector<Row> RowTable::traced(std::span<const double> levels) const {
  std::vector<Row> rows(fields_.sizes.size());
  for (LevelLine& line : levelLines(fields_, levels)) {
    if (!rows[line.side].empty()) return {};
    rows[line.side] = resampled(line.points, way_.spacing, 1 / way_.fineness, kTurn / way_.fineness);
  }
  const bool whole = std::ranges::none_of(rows, [](const Row& row) { return row.empty(); });
  return whole ? rows : std::vector<Row>{};
}

std::vector<Row> RowTable::outlines() const {
  const auto& points = fields_.mesh.points();
  const geometry::RimDistance rim(std::span<const SectionPoint>(points).first(fields_.mesh.rim()), fields_.sizes);
  std::vector<std::uint32_t> next(fields_.mesh.rim());
  std::uint32_t first = 0;
  for (const std::size_t size : fields_.sizes) {
    for (std::uint32_t i = 0; i < size; ++i) next[first + i] = first + (i + 1) % static_cast<std::uint32_t>(size);
    first += static_cast<std::uint32_t>(size);
  }
  std::vector<Row> rows;
  constexpr double kFiner = 4;  // than points of rows: those lie on the outline
  for (const auto& outline : geometry::sampleRegion(piece_, std::min(way_.spacing, fields_.spacing) / kFiner)) {
    Row row;
    for (const PicturePoint p : outline) {
      const SectionPoint at{p.x, -p.y};
      const std::uint32_t a = rim.nearest(at).edge, b = next[a];
      const SectionPoint along = points[b] - points[a];
      const double share = std::clamp(dot(at - points[a], along) / std::max(1e-12, dot(along, along)), 0.0, 1.0);
      LevelPoint there = lerp(levelPointOf(fields_, a), levelPointOf(fields_, b), share);
      there.at = at;
      row.push_back(there);
    }
    std::ranges::reverse(row);  // the region on the right
    rows.push_back(resampled(row, way_.spacing, 1 / way_.fineness, INFINITY));
  }
  return rows;
}

std::vector<Row> RowTable::chords() const {
  std::vector<Row> rows;
  std::uint32_t last = 0;
  for (const std::size_t size : fields_.sizes) {
    const std::uint32_t first = last;
    last += static_cast<std::uint32_t>(size);
    Row& row = rows.emplace_back();
    for (std::uint32_t i = last; i-- > first;) row.push_back(levelPointOf(fields_, i));  // the region on the right
  }
  return rows;
}

bool RowTable::cross() const {
  Stretches all;
  for (const auto& [levels, lines] : rows_) {
    for (const Row& line : lines) {
      for (std::size_t i = 0; i < line.size(); ++i) all.add(line[i].at, line[(i + 1) % line.size()].at);
    }
  }
  return all.cross();
}

bool runsInside(std::span<const LevelPoint> a, std::span<const LevelPoint> b) {
  // With the outline on their left the higher one holds more where they run clockwise, else less.
  return geometry::signedArea(std::span<const SectionPoint>(placesOf(b))) <
         geometry::signedArea(std::span<const SectionPoint>(placesOf(a)));
}

std::optional<Band> bandBetween(std::span<const LevelPoint> low, std::span<const LevelPoint> high) {
  // The band lies to the left of the lower one, to the right of the higher one.
  std::vector<SectionPoint> lower = placesOf(low), higher = placesOf(high);
  std::ranges::reverse(higher);
  const bool lowFirst = geometry::signedArea(std::span<const SectionPoint>(lower)) > 0;  // a mesh wants holes last
  std::vector<SectionPoint> rim = lowFirst ? lower : higher;
  const std::array sizes{rim.size(), lower.size() + higher.size() - rim.size()};
  rim.insert(rim.end(), (lowFirst ? higher : lower).begin(), (lowFirst ? higher : lower).end());
  Band band{geometry::PlaneMesh(rim, sizes), lowFirst};
  std::size_t borders = 0;
  for (std::uint32_t h = 0; h < 3 * band.mesh.triangles().size(); ++h)
    borders += band.mesh.twin(h) == geometry::PlaneMesh::kNone;
  if (band.mesh.empty() || borders != rim.size()) return std::nullopt;
  return band;
}

}  // namespace spineloft::inflate
