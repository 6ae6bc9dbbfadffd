#include "engine/descriptive/stretches.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "engine/geometry/polygon.h"
#include "engine/geometry/polyline.h"

namespace spineloft::descriptive {
namespace {

using Points = std::vector<PicturePoint>;

struct Bounds {
  PicturePoint low{INFINITY, INFINITY}, high{-INFINITY, -INFINITY};
  void add(PicturePoint p) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  bool meets(const Bounds& other) const {
    return low.x <= other.high.x && other.low.x <= high.x && low.y <= other.high.y && other.low.y <= high.y;
  }
};
Bounds boundsOf(const geometry::Contours& contours) {
  Bounds bounds;
  for (const auto& contour : contours) {
    for (const PicturePoint p : contour) bounds.add(p);
  }
  return bounds;
}

/// An outline with arc lengths; the last point is the first.
struct Measured {
  Points points;
  std::vector<double> s;
  explicit Measured(const OutlinePath& outline) : points(outline.points) {
    points.push_back(points.front());
    geometry::arcLengths(std::span<const PicturePoint>(points), s);
  }
  PicturePoint at(double along) const {
    const double length = s.back();
    along = std::fmod(along, length);
    return geometry::pointAt(std::span<const PicturePoint>(points), std::span<const double>(s), along);
  }
};

void addCuts(const Measured& outline, const geometry::Contours& other, std::vector<double>& cuts) {
  for (std::size_t i = 0; i + 1 < outline.points.size(); ++i) {
    const PicturePoint a = outline.points[i], b = outline.points[i + 1], r = b - a;
    for (const auto& contour : other) {
      for (std::size_t k = 0, j = contour.size() - 1; k < contour.size(); j = k++) {
        const PicturePoint c = contour[j], d = contour[k];
        constexpr double kNear = 1e-6;  // pixels
        if (std::max(c.x, d.x) < std::min(a.x, b.x) - kNear || std::min(c.x, d.x) > std::max(a.x, b.x) + kNear)
          continue;
        if (std::max(c.y, d.y) < std::min(a.y, b.y) - kNear || std::min(c.y, d.y) > std::max(a.y, b.y) + kNear)
          continue;
        const PicturePoint q = d - c;
        const double whole = cross(r, q);
        if (whole == 0) continue;
        const double t = cross(c - a, q) / whole, u = cross(c - a, r) / whole;
        // A corner that lies on the other outline cuts there, on whichever side rounding puts it.
        constexpr double kRounding = 1e-9;
        const auto isWithin = [](double share) { return share >= -kRounding && share <= 1 + kRounding; };
        if (isWithin(t) && isWithin(u)) cuts.push_back(outline.s[i] + t * norm(r));
      }
    }
  }
}

bool isIn(const geometry::Contours& region, PicturePoint p) {
  bool inside = false;
  for (const auto& contour : region) {
    if (geometry::holds(std::span<const PicturePoint>(contour), p)) inside = !inside;
  }
  return inside;
}
bool isAtEdge(const geometry::Contours& region, PicturePoint p, double near) {
  for (const auto& contour : region) {
    for (std::size_t i = 0, j = contour.size() - 1; i < contour.size(); j = i++) {
      if (geometry::distanceToSegment(p, contour[j], contour[i]) < near) return true;
    }
  }
  return false;
}

/// Cuts one outline.
class Cutter {
 public:
  Cutter(std::span<const Sheet> sheets, const std::vector<Bounds>& bounds, const Overlaps& overlaps, double size)
      : sheets_(sheets), bounds_(bounds), overlaps_(overlaps), size_(size) {}

  void cut(std::uint32_t piece, std::uint32_t index, std::vector<OrderedStretch>& out) const {
    const OutlinePath& outline = sheets_[piece].outlines[index];
    const Measured line(outline);
    Bounds own;
    for (const PicturePoint p : outline.points) own.add(p);
    std::vector<double> cuts;
    for (std::size_t k = 0; k < sheets_.size(); ++k) {
      if (k != piece && bounds_[k].meets(own)) addCuts(line, sheets_[k].region, cuts);
    }
    std::ranges::sort(cuts);
    if (cuts.empty()) cuts.push_back(0);
    const double least = kLeastStretch * size_;
    for (std::size_t i = 0; i < cuts.size(); ++i) {
      const double to = i + 1 < cuts.size() ? cuts[i + 1] : cuts[0] + line.s.back();
      if (to - cuts[i] < least) continue;
      OrderedStretch stretch;
      stretch.piece = piece;
      stretch.outline = index;
      stretch.from = cuts[i];
      stretch.to = to;
      cover(line, own, stretch);
      addTypes(outline, line, stretch, cuts.size() == 1 && cuts[0] == 0, out);
    }
  }

 private:
  void cover(const Measured& line, const Bounds& own, OrderedStretch& stretch) const {
    for (std::uint32_t k = 0; k < sheets_.size(); ++k) {
      if (k == stretch.piece || !bounds_[k].meets(own)) continue;
      int inside = 0, atEdge = 0;
      std::optional<std::uint32_t> overlap;
      for (const double share : {0.5, 0.25, 0.75}) {
        const PicturePoint p = line.at(stretch.from + share * (stretch.to - stretch.from));
        if (isAtEdge(sheets_[k].region, p, kAtEdge * size_)) {
          ++atEdge;
        } else if (isIn(sheets_[k].region, p)) {
          ++inside;
          if (!overlap) overlap = overlaps_.at(stretch.piece, k, p, 3);
        }
      }
      stretch.isVague = stretch.isVague || atEdge >= 2 || (inside > 0 && !overlap);
      if (inside < 2 || !overlap) continue;
      stretch.cover.push_back(k);
      stretch.at.push_back(*overlap);
    }
  }
  /// Parts of one type: [from, to] where it changes far from the ends of the stretch.
  void addTypes(const OutlinePath& outline, const Measured& line, const OrderedStretch& whole, bool isRing,
                std::vector<OrderedStretch>& out) const {
    struct Part {
      double from, to;
      bool hidden;
    };
    std::vector<Part> parts;
    const std::size_t n = outline.points.size();
    const double length = line.s.back();
    for (std::size_t i = 0; i < 2 * n; ++i) {
      const double lap = i < n ? 0 : length;
      const double from = std::max(whole.from, line.s[i % n] + lap), to = std::min(whole.to, line.s[i % n + 1] + lap);
      if (!(to > from)) continue;
      const bool hidden = outline.hidden[i % n];
      if (!parts.empty() && parts.back().hidden == hidden) {
        parts.back().to = to;
      } else {
        parts.push_back({from, to, hidden});
      }
    }
    // What is shorter than a slip of the hand takes the type beside it.
    const double slip = std::min(kSnapping * size_, 0.25 * (whole.to - whole.from));
    for (bool again = true; again && parts.size() > 1;) {
      again = false;
      for (std::size_t i = 0; i < parts.size(); ++i) {
        const bool atEnd = !isRing && (i == 0 || i + 1 == parts.size());
        const double least = atEnd ? slip : kLeastStretch * size_;
        if (parts[i].to - parts[i].from >= least) continue;
        const std::size_t beside = i > 0 ? i - 1 : 1;
        parts[beside] = {std::min(parts[i].from, parts[beside].from), std::max(parts[i].to, parts[beside].to),
                         parts[beside].hidden};
        parts.erase(parts.begin() + static_cast<std::ptrdiff_t>(i));
        again = true;
        break;
      }
    }
    std::vector<Part> joined;
    for (const Part& part : parts) {
      if (!joined.empty() && joined.back().hidden == part.hidden) {
        joined.back().to = part.to;
      } else {
        joined.push_back(part);
      }
    }
    for (const Part& part : joined) {
      OrderedStretch stretch = whole;
      stretch.from = part.from;
      stretch.to = part.to;
      stretch.hidden = part.hidden;
      stretch.dips = part.hidden && joined.size() > 1 && !stretch.cover.empty();
      out.push_back(std::move(stretch));
    }
  }

  std::span<const Sheet> sheets_;
  const std::vector<Bounds>& bounds_;
  const Overlaps& overlaps_;
  double size_;
};

}  // namespace

std::vector<OrderedStretch> stretchesOf(std::span<const Sheet> sheets, const Overlaps& overlaps, double size) {
  std::vector<Bounds> bounds;
  for (const Sheet& sheet : sheets) bounds.push_back(boundsOf(sheet.region));
  const Cutter cutter(sheets, bounds, overlaps, size);
  std::vector<OrderedStretch> out;
  for (std::uint32_t piece = 0; piece < sheets.size(); ++piece) {
    for (std::uint32_t k = 0; k < sheets[piece].outlines.size(); ++k) cutter.cut(piece, k, out);
  }
  return out;
}

PicturePoint alongOutline(const OutlinePath& outline, double s) { return Measured(outline).at(s); }

}  // namespace spineloft::descriptive
