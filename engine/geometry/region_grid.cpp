#include "engine/geometry/region_grid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "engine/geometry/polyline.h"

namespace spineloft::geometry {
namespace {

/// Cells are not finer than this, pixels: a hand is not.
constexpr double kFinestCell = 0.5;
/// Crossings stay this share of a cell's side away from its corners, so that no edge has no length.
constexpr double kFromCorner = 0.02;
/// Nodes lie off the whole pixels, where hands and masks put their points.
constexpr double kOffGrid = 0.2137;

/// Signed distances at the nodes of a grid, positive inside; exact near outlines, large elsewhere.
class Field {
 public:
  Field(const Contours& contours, double margin, PictureFrame frame) : frame_(frame) {
    constexpr double kFar = std::numeric_limits<double>::infinity();
    PicturePoint low{kFar, kFar}, high{-kFar, -kFar};
    for (const auto& contour : contours) {
      for (const PicturePoint p : contour) {
        low = {std::min(low.x, p.x), std::min(low.y, p.y)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y)};
      }
    }
    low = {std::max(low.x - margin, -0.5), std::max(low.y - margin, -0.5)};
    high = {std::min(high.x + margin, frame.width - 0.5), std::min(high.y + margin, frame.height - 0.5)};
    const double width = high.x - low.x, height = high.y - low.y;
    if (!(width > 0 && height > 0)) return;
    cell_ = std::max({kFinestCell, std::sqrt(width * height / static_cast<double>(kRegionCells)),
                      std::max(width, height) / static_cast<double>(kRegionCells / 4)});
    // One node more on every side, so that all outlines close within the grid.
    low_ = {low.x - (1 + kOffGrid) * cell_, low.y - (1 + kOffGrid) * cell_};
    nx_ = static_cast<int>(width / cell_) + 4;
    ny_ = static_cast<int>(height / cell_) + 4;
    value_.assign(static_cast<std::size_t>(nx_) * static_cast<std::size_t>(ny_), kFar);
  }

  bool empty() const { return value_.empty(); }
  double cell() const { return cell_; }

  /// The nearest distance so far, to a segment, within `reach` of it.
  void touch(PicturePoint a, PicturePoint b, double reach) {
    const auto column = [&](double x) { return std::clamp((x - low_.x) / cell_, -1.0, nx_ + 1.0); };
    const auto row = [&](double y) { return std::clamp((y - low_.y) / cell_, -1.0, ny_ + 1.0); };
    const int x0 = std::max(0, static_cast<int>(column(std::min(a.x, b.x) - reach)));
    const int x1 = std::min(nx_ - 1, static_cast<int>(column(std::max(a.x, b.x) + reach)) + 1);
    const int y0 = std::max(0, static_cast<int>(row(std::min(a.y, b.y) - reach)));
    const int y1 = std::min(ny_ - 1, static_cast<int>(row(std::max(a.y, b.y) + reach)) + 1);
    for (int y = y0; y <= y1; ++y) {
      for (int x = x0; x <= x1; ++x) {
        double& value = at(x, y);
        value = std::min(value, distanceToSegment(node(x, y), a, b));
      }
    }
  }

  /// Distances become negative outside, by even-odd along each row.
  void sign(const Contours& contours) {
    std::vector<std::vector<double>> occludedStretches(static_cast<std::size_t>(ny_));
    for (const auto& contour : contours) {
      for (std::size_t i = 0, j = contour.size() - 1; i < contour.size(); j = i++) {
        cross(contour[j], contour[i], occludedStretches);
      }
    }
    for (int y = 0; y < ny_; ++y) {
      auto& row = occludedStretches[static_cast<std::size_t>(y)];
      std::ranges::sort(row);
      std::size_t passed = 0;
      for (int x = 0; x < nx_; ++x) {
        while (passed < row.size() && row[passed] < node(x, y).x) ++passed;
        if (passed % 2 == 0) at(x, y) = -at(x, y);
      }
    }
  }

  /// Distances become how far inside a band of half the width.
  void band(double half) {
    for (double& value : value_) value = half - value;
  }

  /// Nothing beyond the picture.
  void clip() {
    for (int y = 0; y < ny_; ++y) {
      for (int x = 0; x < nx_; ++x) {
        const PicturePoint p = node(x, y);
        const double in = std::min({p.x + 0.5, p.y + 0.5, frame_.width - 0.5 - p.x, frame_.height - 0.5 - p.y});
        at(x, y) = std::clamp(std::min(at(x, y), in), -4 * cell_, 4 * cell_);
        if (x == 0 || y == 0 || x == nx_ - 1 || y == ny_ - 1) at(x, y) = -cell_;
      }
    }
  }

  /// Takes the smaller values of both, of grids of the same contours. Whether any inside is left out.
  bool meet(const Field& other) {
    bool less = false;
    for (std::size_t i = 0; i < value_.size(); ++i) {
      less = less || (value_[i] > 0 && !(other.value_[i] > 0));
      value_[i] = std::min(value_[i], other.value_[i]);
    }
    return less;
  }

  /// Beyond the centre of a disc, in a direction, nothing near it but the disc.
  void round(PicturePoint centre, PicturePoint direction, double radius) {
    const double reach = 4 * radius;
    for (int y = 0; y < ny_; ++y) {
      for (int x = 0; x < nx_; ++x) {
        const PicturePoint from = node(x, y) - centre;
        const double away = std::hypot(from.x, from.y);
        if (away < reach && dot(from, direction) > 0) at(x, y) = std::min(at(x, y), radius - away);
      }
    }
  }

  bool inside(PicturePoint p) const {
    const int x = static_cast<int>(std::lround((p.x - low_.x) / cell_));
    const int y = static_cast<int>(std::lround((p.y - low_.y) / cell_));
    return x >= 0 && y >= 0 && x < nx_ && y < ny_ && in(x, y);
  }

  Contours outlines() const;

 private:
  PicturePoint node(int x, int y) const { return {low_.x + x * cell_, low_.y + y * cell_}; }
  double& at(int x, int y) {
    return value_[static_cast<std::size_t>(y) * static_cast<std::size_t>(nx_) + static_cast<std::size_t>(x)];
  }
  double at(int x, int y) const { return const_cast<Field*>(this)->at(x, y); }
  bool in(int x, int y) const { return at(x, y) > 0; }

  void cross(PicturePoint a, PicturePoint b, std::vector<std::vector<double>>& occludedStretches) const {
    if (a.y > b.y) std::swap(a, b);
    if (!(b.y > a.y)) return;
    const double first = std::ceil((a.y - low_.y) / cell_);
    const int y0 = static_cast<int>(std::clamp(first, 0.0, static_cast<double>(ny_)));
    for (int y = y0; y < ny_; ++y) {
      const double level = node(0, y).y;
      if (level < a.y) continue;
      if (level >= b.y) break;
      occludedStretches[static_cast<std::size_t>(y)].push_back(a.x + (b.x - a.x) * (level - a.y) / (b.y - a.y));
    }
  }

  /// Where the outline crosses the side from a node to the one right of it or below it.
  PicturePoint crossing(int x, int y, bool down) const {
    const double from = at(x, y), to = down ? at(x, y + 1) : at(x + 1, y);
    const double t = std::clamp(from / (from - to), kFromCorner, 1 - kFromCorner);
    const PicturePoint p = node(x, y);
    const PicturePoint clipped = down ? PicturePoint{p.x, p.y + t * cell_} : PicturePoint{p.x + t * cell_, p.y};
    return {std::clamp(clipped.x, -0.5, frame_.width - 0.5), std::clamp(clipped.y, -0.5, frame_.height - 0.5)};
  }

  PictureFrame frame_;
  PicturePoint low_{};
  double cell_ = 1;
  int nx_ = 0, ny_ = 0;
  std::vector<double> value_;
};

/// Sides of a cell: 0 top, 1 right, 2 bottom, 3 left. A walk keeps the inside on its left hand seen with
/// y down, which is the right one with y up; callers orient outlines anyway.
Contours Field::outlines() const {
  Contours contours;
  std::vector<std::uint8_t> done(value_.size(), 0);  // horizontal sides that a walk went through
  constexpr std::array<std::array<int, 2>, 4> kStep = {{{0, -1}, {1, 0}, {0, 1}, {-1, 0}}};
  const auto sideSplits = [&](int x, int y, int side) {
    switch (side) {
      case 0:
        return in(x, y) != in(x + 1, y);
      case 1:
        return in(x + 1, y) != in(x + 1, y + 1);
      case 2:
        return in(x, y + 1) != in(x + 1, y + 1);
      default:
        return in(x, y) != in(x, y + 1);
    }
  };
  const auto sidePoint = [&](int x, int y, int side) {
    switch (side) {
      case 0:
        return crossing(x, y, false);
      case 1:
        return crossing(x + 1, y, true);
      case 2:
        return crossing(x, y + 1, false);
      default:
        return crossing(x, y, true);
    }
  };
  const auto mark = [&](int x, int y) -> std::uint8_t& {
    return done[static_cast<std::size_t>(y) * static_cast<std::size_t>(nx_) + static_cast<std::size_t>(x)];
  };
  for (int y0 = 1; y0 + 1 < ny_; ++y0) {
    for (int x0 = 0; x0 + 1 < nx_; ++x0) {
      // Every outline goes downwards through some top side with the inside to its right.
      if (!(in(x0, y0) != in(x0 + 1, y0)) || in(x0, y0) || mark(x0, y0)) continue;
      auto& contour = contours.emplace_back();
      int x = x0, y = y0, side = 0;
      do {
        if (side == 0 && !in(x, y)) mark(x, y) = 1;
        contour.push_back(sidePoint(x, y, side));
        const bool saddle = sideSplits(x, y, 0) && sideSplits(x, y, 1) && sideSplits(x, y, 2) && sideSplits(x, y, 3);
        int out = side;
        if (saddle) {
          // Inside corners are kept apart: the walk turns round the inside corner that it passes.
          const bool corner = in(x, y);  // upper left and lower right are inside, or the other two
          const std::array<int, 4> pair = corner ? std::array{3, 2, 1, 0} : std::array{1, 0, 3, 2};
          out = pair[static_cast<std::size_t>(side)];
        } else {
          for (int k = 1; k < 4; ++k) {
            const int candidate = (side + k) % 4;
            if (sideSplits(x, y, candidate)) out = candidate;
          }
        }
        x += kStep[static_cast<std::size_t>(out)][0];
        y += kStep[static_cast<std::size_t>(out)][1];
        side = (out + 2) % 4;
      } while (!(x == x0 && y == y0 && side == 0) && contour.size() <= 2 * value_.size());
    }
  }
  return contours;
}

}  // namespace

Contours evenOddOutlines(const Contours& contours, PictureFrame frame) {
  Field field(contours, 0, frame);
  if (field.empty()) return {};
  for (const auto& contour : contours) {
    for (std::size_t i = 0, j = contour.size() - 1; i < contour.size(); j = i++) {
      field.touch(contour[j], contour[i], 1.5 * field.cell());
    }
  }
  field.sign(contours);
  field.clip();
  return field.outlines();
}

Contours wallOutlines(const Wall& wall, PictureFrame frame) {
  Field field(wall.outlines, 0, frame), band(wall.outlines, 0, frame);
  if (field.empty()) return {};
  constexpr double kLeastCells = 3;
  const double thickness = std::max(wall.thickness, kLeastCells * field.cell());
  for (const auto& contour : wall.outlines) {
    for (std::size_t i = 0, j = contour.size() - 1; i < contour.size(); j = i++) {
      field.touch(contour[j], contour[i], 1.5 * field.cell());
    }
  }
  field.sign(wall.outlines);
  for (const auto& line : wall.lines) {
    for (std::size_t i = 1; i < line.size(); ++i) band.touch(line[i - 1], line[i], thickness + 1.5 * field.cell());
  }
  band.band(thickness);
  const Field whole = field;
  if (!field.meet(band)) return {};
  for (const auto& [at, outwards] : wall.ends) {
    const PicturePoint aside{-outwards.y, outwards.x};
    const PicturePoint back = at - outwards * (thickness / 2);
    const double sign = whole.inside(back + aside * (thickness / 2)) ? 1 : -1;
    field.round(back + aside * (sign * thickness / 2), outwards, thickness / 2);
  }
  field.clip();
  return field.outlines();
}

Contours ribbonOutlines(const Contours& lines, double width, PictureFrame frame) {
  const double half = width / 2;
  Field field(lines, half, frame);
  if (field.empty()) return {};
  for (const auto& line : lines) {
    if (line.size() == 1) field.touch(line[0], line[0], half + 1.5 * field.cell());
    for (std::size_t i = 1; i < line.size(); ++i) {
      field.touch(line[i - 1], line[i], half + 1.5 * field.cell());
    }
  }
  field.band(half);
  field.clip();
  return field.outlines();
}

}  // namespace spineloft::geometry
