#include "engine/shape/side_fit.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numbers>
#include <ranges>
#include <utility>

#include "engine/shape/side_lines.h"

namespace spineloft::shape {
namespace {

constexpr std::size_t kRows = 512;
/// The factor is at most so many times its median.
constexpr double kMostTimes = 4;
/// Shares of the size: least depth of a row by the outline; of the part what is none.
constexpr double kLeastDepth = 4e-4, kNoDepth = 1e-6;
/// Shares of the height: by how much the spine must step back to count as crossing a row again, and over how far the
/// change fades in beside rows that keep their depth.
constexpr double kStepBack = 0.01, kFade = 0.05;

constexpr double kNone = std::numeric_limits<double>::infinity();

/// The least and the most depth of each row; least > most where nothing is there.
struct Span {
  double least = kNone, most = -kNone;
  void add(double z) {
    least = std::min(least, z);
    most = std::max(most, z);
  }
  bool empty() const { return !(least <= most); }
};

/// Rows from end to end, as near to each other at the ends as round ends turn.
std::vector<double> rowsBetween(double low, double high) {
  std::vector<double> rows(kRows + 1);
  for (std::size_t i = 0; i <= kRows; ++i) {
    rows[i] = low + (high - low) * (1 - std::cos(std::numbers::pi * static_cast<double>(i) / kRows)) / 2;
  }
  rows.front() = low;
  rows.back() = high;
  return rows;
}

/// Gives `add` every row from a to b and the depth of the straight line between them there. x is z, y the row.
template <class Add>
void alongRows(const std::vector<double>& rows, SectionPoint a, SectionPoint b, const Add& add) {
  if (a.y > b.y) std::swap(a, b);
  const auto first = std::ranges::lower_bound(rows, a.y);
  for (auto row = first; row != rows.end() && *row <= b.y; ++row) {
    const auto i = static_cast<std::size_t>(row - rows.begin());
    const double t = b.y > a.y ? (*row - a.y) / (b.y - a.y) : 0;
    add(i, std::lerp(a.x, b.x, t));
    if (!(b.y > a.y)) add(i, b.x);
  }
}

std::vector<Span> spansOf(const mesh::TriMesh& mesh, const std::vector<double>& rows) {
  std::vector<Span> spans(rows.size());
  const auto at = [&](std::uint32_t i) { return SectionPoint{mesh.positions[i][2], mesh.positions[i][1]}; };
  for (const auto& triangle : mesh.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t a = triangle[k], b = triangle[(k + 1) % 3];
      if (a < b) alongRows(rows, at(a), at(b), [&](std::size_t i, double z) { spans[i].add(z); });
    }
  }
  return spans;
}

/// Of the outline: from the line that is farther back to the one farther in front.
std::vector<Span> spansOf(const SideLines& lines, const std::vector<double>& rows) {
  std::vector<Span> spans(rows.size()), front(rows.size());
  const auto along = [&](const SideLine& line, std::vector<Span>& out) {
    const Line& points = line.points();
    for (std::size_t i = 1; i < points.size(); ++i) {
      alongRows(rows, points[i - 1], points[i], [&](std::size_t row, double z) { out[row].add(z); });
    }
    for (std::size_t i = 0; i < rows.size(); ++i) {
      if (out[i].empty()) out[i].add(rows[i] < points.front().y ? points.front().x : points.back().x);
    }
  };
  along(lines.low, spans);
  along(lines.high, front);
  for (std::size_t i = 0; i < rows.size(); ++i) spans[i].most = front[i].most;
  return spans;
}

/// How often a line crosses a row; what steps back by no more than `slack` does not count. A line whose ends meet is a
/// ring.
int crossings(std::span<const ModelPoint> line, double row, double slack) {
  const auto sideOf = [&](const ModelPoint& p) { return p.y > row + slack ? 1 : p.y < row - slack ? -1 : 0; };
  int count = 0, side = 0;
  if (distance(line.front(), line.back()) <= 2 * slack) {
    const auto last = std::ranges::find_if(line | std::views::reverse, sideOf);
    if (last != line.rend()) side = sideOf(*last);
  }
  for (const ModelPoint& p : line) {
    const int now = sideOf(p);
    if (now == 0 || now == side) continue;
    count += side != 0;
    side = now;
  }
  return count;
}

/// How much the outline counts in each row, 0…1. Beyond an end of the spine it counts as at that end.
std::vector<double> sharesOf(std::span<const ModelPoint> spine, const std::vector<double>& rows) {
  std::vector<double> shares(rows.size(), 1.0);
  if (spine.size() < 2) return shares;
  const double height = rows.back() - rows.front(), slack = kStepBack * height;
  const auto [lowest, highest] = std::ranges::minmax(spine, {}, &ModelPoint::y);
  const double low = lowest.y + 2 * slack, high = highest.y - 2 * slack;
  if (low >= high) return shares;  // level: the line says nothing of rows
  std::vector<double> kept;
  for (const double row : rows) {
    if (crossings(spine, std::clamp(row, low, high), slack) > 1) kept.push_back(row);
  }
  for (std::size_t i = 0; i < rows.size() && !kept.empty(); ++i) {
    const auto above = std::ranges::lower_bound(kept, rows[i]);
    double away = kNone;
    if (above != kept.end()) away = *above - rows[i];
    if (above != kept.begin()) away = std::min(away, rows[i] - *(above - 1));
    const double t = std::min(1.0, away / (kFade * height));
    shares[i] = t * t * (3 - 2 * t);
  }
  return shares;
}

Result<SideLines> linesOf(const SeenOutline& side, double low, double high) {
  using geometry::ViewFrom;
  if (!side.view || (side.view->from != ViewFrom::Right && side.view->from != ViewFrom::Left)) {
    return Failure{Error::ViewInvalid, "a side outline is drawn in a picture of the right or the left side"};
  }
  if (side.lines.empty() || side.lines.size() > 2) {
    return Failure{Error::ShapeInvalid, "an outline is one closed line or two open ones"};
  }
  std::vector<Line> lines;
  for (const auto& drawn : side.lines) {
    Line& line = lines.emplace_back();
    for (const PicturePoint p : drawn) {
      if (!isFinite(p)) return Error::StrokeNotFinite;
      const ModelPoint at = geometry::inModel(*side.view, p);
      line.push_back({at.z, at.y});
    }
  }
  Result<SideLines> sides = sideLinesOf(std::move(lines), "the side outline");
  if (!sides.ok()) return sides;
  if (Status fits = sides.value().stretchTo(low, high); !fits.ok()) return fits.failure();
  return sides;
}

/// Of a part that ends at z = 0 only one of its depths moves.
struct Ways {
  FitSides sides;
  double depthOf(const Span& span) const {
    if (sides == FitSides::Front) return span.most;
    return sides == FitSides::Back ? -span.least : span.most - span.least;
  }
  /// What stays where it is when a row is stretched.
  double middleOf(const Span& span) const { return sides == FitSides::Both ? (span.least + span.most) / 2 : 0; }
};

/// Factors that are not known are those of the nearest row; none is more than kMostTimes the median.
void settle(std::vector<double>& factors) {
  std::vector<double> known;
  std::ranges::copy_if(factors, std::back_inserter(known), [](double factor) { return factor > 0; });
  const auto middle = known.begin() + static_cast<std::ptrdiff_t>(known.size() / 2);
  std::ranges::nth_element(known, middle);
  const double most = kMostTimes * *middle;
  for (std::size_t i = 1; i < factors.size(); ++i) {
    if (factors[i] == 0) factors[i] = factors[i - 1];
  }
  for (std::size_t i = factors.size() - 1; i > 0; --i) {
    if (factors[i - 1] == 0) factors[i - 1] = factors[i];
  }
  for (double& factor : factors) factor = std::min(factor, most);
}

}  // namespace

SideFit::SideFit(std::vector<double> rows, std::vector<double> stretch, std::vector<double> shift)
    : rows_(std::move(rows)), stretch_(std::move(stretch)), shift_(std::move(shift)) {}

double SideFit::depthOf(double y, double z) const {
  const auto above = std::ranges::upper_bound(rows_, y);
  const std::size_t i =
      above == rows_.begin() ? 1 : std::min(static_cast<std::size_t>(above - rows_.begin()), rows_.size() - 1);
  const double t = std::clamp((y - rows_[i - 1]) / (rows_[i] - rows_[i - 1]), 0.0, 1.0);
  return std::lerp(stretch_[i - 1], stretch_[i], t) * z + std::lerp(shift_[i - 1], shift_[i], t);
}

void SideFit::apply(mesh::TriMesh& mesh) const {
  for (auto& p : mesh.positions) p[2] = static_cast<float>(depthOf(p[1], p[2]));
}

Result<SideFit> fitToSide(const SideTask& task) {
  const auto& positions = task.mesh.positions;
  if (positions.empty()) return Error::RegionEmpty;
  const auto [lowest, highest] = std::ranges::minmax(positions, {}, [](const auto& p) { return p[1]; });
  const auto [back, front] = std::ranges::minmax(positions, {}, [](const auto& p) { return p[2]; });
  const double low = lowest[1], high = highest[1], size = std::max(high - low, double{front[2]} - back[2]);
  if (!(high > low)) return Error::RegionEmpty;
  const Result<SideLines> lines = linesOf(task.side, low, high);
  if (!lines.ok()) return lines.failure();
  const std::vector<double> rows = rowsBetween(low, high), shares = sharesOf(task.spine, rows);
  if (std::ranges::max(shares) <= 0) {
    return Failure{Error::ShapeInvalid, "the part goes past every height more than once: its side says no depth"};
  }
  const std::vector<Span> seen = spansOf(task.mesh, rows), drawn = spansOf(lines.value(), rows);
  const Ways ways{task.sides};
  const double least = kLeastDepth * size;
  std::vector<double> stretch(rows.size(), 0.0), shift(rows.size(), 0.0);
  bool any = false;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const double depth = seen[i].empty() ? 0 : ways.depthOf(seen[i]);
    any = any || ways.depthOf(drawn[i]) > least;
    if (depth > kNoDepth * size) stretch[i] = std::max(least, ways.depthOf(drawn[i])) / depth;
  }
  if (!any) return Failure{Error::ShapeInvalid, "the side outline lies behind the flat side of the part"};
  settle(stretch);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const double middle = seen[i].empty() ? 0 : ways.middleOf(seen[i]);
    shift[i] = shares[i] * (ways.middleOf(drawn[i]) - stretch[i] * middle);
    stretch[i] = std::lerp(1.0, stretch[i], shares[i]);
  }
  return SideFit(rows, std::move(stretch), std::move(shift));
}

}  // namespace spineloft::shape
