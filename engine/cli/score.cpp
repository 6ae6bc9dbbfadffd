#include "engine/cli/score.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <utility>

namespace spineloft::cli {
namespace {

std::size_t countOf(const image::Mask& mask) {
  return static_cast<std::size_t>(mask.width) * static_cast<std::size_t>(mask.height);
}

/// A binary mask enlarged three times, threshold at one half; at() takes enlarged pixels of the
/// mask with two empty pixels around it.
class Enlarged {
 public:
  explicit Enlarged(const image::Mask& mask)
      : mask_(mask), width_(3 * (mask.width + 4)), height_(3 * (mask.height + 4)) {
    bits_.resize(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_));
    for (int y = 0; y < height_; ++y) {
      for (int x = 0; x < width_; ++x) bits_[index(x, y)] = sample(x, y);
    }
  }
  int width() const { return width_; }
  int height() const { return height_; }
  bool at(int x, int y) const { return x >= 0 && y >= 0 && x < width_ && y < height_ && bits_[index(x, y)]; }

 private:
  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x);
  }
  int pixel(int x, int y) const {
    x -= 2, y -= 2;
    if (x < 0 || y < 0 || x >= mask_.width || y >= mask_.height) return 0;
    return mask_.pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(mask_.width) +
                        static_cast<std::size_t>(x)] > 0;
  }
  /// Bilinear value at ((x − 1)/3, (y − 1)/3) in ninths, so that it is exact.
  bool sample(int x, int y) const {
    const int left = (x + 2) / 3 - 1, top = (y + 2) / 3 - 1;
    const int u = x - 1 - 3 * left, v = y - 1 - 3 * top;  // thirds beyond left and top
    const int ninths = (3 - v) * ((3 - u) * pixel(left, top) + u * pixel(left + 1, top)) +
                       v * ((3 - u) * pixel(left, top + 1) + u * pixel(left + 1, top + 1));
    return 2 * ninths >= 9;
  }
  const image::Mask& mask_;
  int width_, height_;
  std::vector<bool> bits_;
};

double squared(PicturePoint v) { return dot(v, v); }

/// Square grid of points for nearest-point questions.
class PointGrid {
 public:
  explicit PointGrid(std::span<const PicturePoint> points) : points_(points) {
    if (points.empty()) return;
    low_ = high_ = points[0];
    for (const PicturePoint& p : points) {
      low_ = {std::min(low_.x, p.x), std::min(low_.y, p.y)};
      high_ = {std::max(high_.x, p.x), std::max(high_.y, p.y)};
    }
    columns_ = 1 + static_cast<int>((high_.x - low_.x) / kCell);
    rows_ = 1 + static_cast<int>((high_.y - low_.y) / kCell);
    cells_.resize(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_));
    for (const PicturePoint& p : points) {
      const int column = static_cast<int>((p.x - low_.x) / kCell);
      const int row = static_cast<int>((p.y - low_.y) / kCell);
      cells_[static_cast<std::size_t>(row * columns_ + column)].push_back(p);
    }
  }
  /// Distance to the nearest point; infinite without points.
  double distanceTo(PicturePoint p) const {
    double best = std::numeric_limits<double>::infinity();
    if (points_.empty()) return best;
    const int column = std::clamp(static_cast<int>((p.x - low_.x) / kCell), 0, columns_ - 1);
    const int row = std::clamp(static_cast<int>((p.y - low_.y) / kCell), 0, rows_ - 1);
    const PicturePoint inside{std::clamp(p.x, low_.x, high_.x), std::clamp(p.y, low_.y, high_.y)};
    const double away = distance(p, inside);
    for (int ring = 0; ring <= std::max(columns_, rows_); ++ring) {
      // Cells of this ring are at least so far from `inside`, hence from p.
      const double least = std::max(away, (ring - 1) * kCell);
      if (least * least > best) break;
      searchRing(p, column, row, ring, best);
    }
    return std::sqrt(best);
  }

 private:
  static constexpr double kCell = 16;
  void searchRing(PicturePoint p, int column, int row, int ring, double& best) const {
    for (int y = std::max(0, row - ring); y <= std::min(rows_ - 1, row + ring); ++y) {
      const bool full = y == row - ring || y == row + ring;
      for (int x = column - ring; x <= column + ring; x += full || ring == 0 ? 1 : 2 * ring) {
        if (x < 0 || x >= columns_) continue;
        for (const PicturePoint& q : cells_[static_cast<std::size_t>(y * columns_ + x)]) {
          best = std::min(best, squared(p - q));
        }
      }
    }
  }
  std::span<const PicturePoint> points_;
  PicturePoint low_, high_;
  int columns_ = 0, rows_ = 0;
  std::vector<std::vector<PicturePoint>> cells_;
};

/// One step of the 5 × 5 chamfer mask (Borgefors 1986) with its weights for the Euclidean distance,
/// in 1/65536 px.
struct ChamferStep {
  int dx, dy;
  std::int64_t cost;
};
constexpr std::int64_t kSide = 65536, kDiagonal = 91750, kKnight = 143976;
constexpr std::array<ChamferStep, 8> kForward{{{-1, -2, kKnight},
                                               {1, -2, kKnight},
                                               {-2, -1, kKnight},
                                               {-1, -1, kDiagonal},
                                               {0, -1, kSide},
                                               {1, -1, kDiagonal},
                                               {2, -1, kKnight},
                                               {-1, 0, kSide}}};

/// Spreads labels from the pixels at distance 0; forward over rows, then back.
void spreadLabels(int width, int height, std::vector<std::int64_t>& distances, std::vector<float>& labels) {
  const auto visit = [&](int x, int y, int sign) {
    const std::size_t here =
        static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
    for (const ChamferStep& step : kForward) {
      const int u = x + sign * step.dx, v = y + sign * step.dy;
      if (u < 0 || v < 0 || u >= width || v >= height) continue;
      const std::size_t there =
          static_cast<std::size_t>(v) * static_cast<std::size_t>(width) + static_cast<std::size_t>(u);
      if (distances[there] + step.cost < distances[here]) {
        distances[here] = distances[there] + step.cost;
        labels[here] = labels[there];
      }
    }
  };
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) visit(x, y, 1);
  }
  for (int y = height - 1; y >= 0; --y) {
    for (int x = width - 1; x >= 0; --x) visit(x, y, -1);
  }
}

/// Intersection and union of part and truth, counted over chosen pixels.
struct Overlap {
  std::size_t both = 0, either = 0;
  void add(bool part, bool truth) {
    both += part && truth;
    either += part || truth;
  }
  double iou() const { return either ? static_cast<double>(both) / static_cast<double>(either) : 1.0; }
};

RibScore scoreRibs(const Truth& truth, std::span<const PicturePoint> ends) {
  const PointGrid boundary(truth.boundary());
  std::vector<double> pct;
  double pctSum = 0, pxSum = 0;
  int within = 0;
  for (const PicturePoint& end : ends) {
    if (truth.nearCut(end)) continue;
    const double px = boundary.distanceTo(end);
    pct.push_back(100 * px / truth.widthAt(truth.arcAt(end)));
    pctSum += pct.back();
    pxSum += px;
    within += px <= truth.tolerance();
  }
  if (pct.empty()) return {};
  const double count = static_cast<double>(pct.size());
  return {static_cast<int>(pct.size()), pctSum / count, percentile(pct, 0.95), pxSum / count, within / count};
}

}  // namespace

std::vector<PicturePoint> outline(const image::Mask& mask) {
  std::vector<PicturePoint> points;
  if (mask.width <= 0 || mask.height <= 0 || mask.pixels.size() != countOf(mask)) return points;
  const Enlarged large(mask);
  for (int y = 0; y < large.height(); ++y) {
    for (int x = 0; x < large.width(); ++x) {
      const bool border =
          large.at(x, y) && !(large.at(x - 1, y) && large.at(x + 1, y) && large.at(x, y - 1) && large.at(x, y + 1));
      if (border) points.push_back({(x - 1) / 3.0 - 2, (y - 1) / 3.0 - 2});
    }
  }
  return points;
}

double percentile(std::vector<double> values, double share) {
  std::sort(values.begin(), values.end());
  const double at = share * static_cast<double>(values.size() - 1);
  const std::size_t low = static_cast<std::size_t>(at);
  const std::size_t high = std::min(low + 1, values.size() - 1);
  return values[low] + (at - static_cast<double>(low)) * (values[high] - values[low]);
}

Truth::Truth(TruthInput input) : mask_(std::move(input.mask)), tolerance_(input.tolerance) {
  resampleAxis(input.axis);
  labelPixels();
  markCuts();
  findBoundary();
}

void Truth::resampleAxis(std::span<const std::array<double, 3>> axis) {
  std::vector<double> arc(axis.size(), 0.0);
  for (std::size_t i = 1; i < axis.size(); ++i) {
    arc[i] = arc[i - 1] + std::hypot(axis[i][0] - axis[i - 1][0], axis[i][1] - axis[i - 1][1]);
  }
  const std::size_t count = std::max<std::size_t>(2, static_cast<std::size_t>(std::ceil(arc.back())) + 1);
  std::size_t segment = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const double at = arc.back() * static_cast<double>(i) / static_cast<double>(count - 1);
    while (segment + 2 < axis.size() && arc[segment + 1] <= at) ++segment;
    const double length = arc[segment + 1] - arc[segment];
    const double t = length > 0 ? std::min(1.0, (at - arc[segment]) / length) : 0;
    std::array<double, 3> p{};
    for (std::size_t k = 0; k < 3; ++k) {
      p[k] = axis[segment][k] + t * (axis[segment + 1][k] - axis[segment][k]);
    }
    axis_.push_back({p[0], p[1]});
    arc_.push_back(at);
    width_.push_back(p[2]);
  }
}

std::size_t Truth::pixelAt(PicturePoint p) const {
  const int x = std::clamp(static_cast<int>(std::nearbyint(std::clamp(p.x, -1e9, 1e9))), 0, mask_.width - 1);
  const int y = std::clamp(static_cast<int>(std::nearbyint(std::clamp(p.y, -1e9, 1e9))), 0, mask_.height - 1);
  return static_cast<std::size_t>(y) * static_cast<std::size_t>(mask_.width) + static_cast<std::size_t>(x);
}

void Truth::labelPixels() {
  const std::size_t count = countOf(mask_);
  std::vector<std::int64_t> distances(count, std::numeric_limits<std::int64_t>::max() / 4);
  arcOfPixels_.assign(count, 0.0f);
  for (std::size_t i = 0; i < axis_.size(); ++i) {
    const std::size_t pixel = pixelAt(axis_[i]);
    distances[pixel] = 0;
    arcOfPixels_[pixel] = static_cast<float>(arc_[i]);
  }
  spreadLabels(mask_.width, mask_.height, distances, arcOfPixels_);
}

void Truth::markCuts() {
  constexpr int kReach = 3;
  nearCut_.assign(countOf(mask_), 0);
  const auto index = [this](int x, int y) {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(mask_.width) + static_cast<std::size_t>(x);
  };
  for (int y = 0; y < mask_.height; ++y) {
    for (int x = 0; x < mask_.width; ++x) {
      if (isCare(index(x, y))) continue;
      for (int v = std::max(0, y - kReach); v <= std::min(mask_.height - 1, y + kReach); ++v) {
        for (int u = std::max(0, x - kReach); u <= std::min(mask_.width - 1, x + kReach); ++u) {
          const bool inner = std::max(std::abs(u - x), std::abs(v - y)) < kReach;
          std::uint8_t& mark = nearCut_[index(u, v)];
          mark = std::max(mark, static_cast<std::uint8_t>(inner ? 2 : 1));
        }
      }
    }
  }
}

void Truth::findBoundary() {
  image::Mask part = mask_;
  for (std::size_t i = 0; i < part.pixels.size(); ++i) part.pixels[i] = isPart(i) ? 255 : 0;
  for (const PicturePoint& p : outline(part)) {
    const bool inFrame = p.x > 0.6 && p.y > 0.6 && p.x < mask_.width - 1.6 && p.y < mask_.height - 1.6;
    if (inFrame && nearCut_[pixelAt(p)] < 2) boundary_.push_back(p);
  }
}

bool Truth::nearCut(PicturePoint p) const { return nearCut_[pixelAt(p)] != 0; }

std::size_t Truth::nearestOnAxis(PicturePoint p) const {
  std::size_t best = 0;
  for (std::size_t i = 1; i < axis_.size(); ++i) {
    if (squared(p - axis_[i]) < squared(p - axis_[best])) best = i;
  }
  return best;
}

double Truth::arcAt(PicturePoint p) const { return arc_[nearestOnAxis(p)]; }

bool Truth::isLeft(PicturePoint p) const {
  const std::size_t i = nearestOnAxis(p);
  const PicturePoint on = axis_[std::min(i + 1, axis_.size() - 1)] - axis_[i > 0 ? i - 1 : 0];
  const PicturePoint to = p - axis_[i];
  return on.x * to.y - on.y * to.x < 0;
}

double Truth::meanWidth() const {
  return std::accumulate(width_.begin(), width_.end(), 0.0) / static_cast<double>(width_.size());
}

double Truth::widthAt(double arc) const {
  const auto above = std::upper_bound(arc_.begin(), arc_.end(), arc);
  if (above == arc_.begin()) return std::max(2.0, width_.front());
  if (above == arc_.end()) return std::max(2.0, width_.back());
  const std::size_t i = static_cast<std::size_t>(above - arc_.begin());
  const double t = (arc - arc_[i - 1]) / (arc_[i] - arc_[i - 1]);
  return std::max(2.0, width_[i - 1] + t * (width_[i] - width_[i - 1]));
}

Score scorePart(const Truth& truth, const image::Mask& part, std::span<const PicturePoint> stroke,
                std::span<const PicturePoint> ribEnds) {
  const double a = truth.arcAt(stroke.front()), b = truth.arcAt(stroke.back());
  const double low = std::min(a, b), high = std::max(a, b);
  Overlap all, body;
  std::size_t partPixels = 0, truthPixels = 0;
  for (std::size_t i = 0; i < truth.arcOfPixels().size(); ++i) {
    if (!truth.isCare(i)) continue;
    const bool inPart = i < part.pixels.size() && part.pixels[i] > 0, inTruth = truth.isPart(i);
    all.add(inPart, inTruth);
    partPixels += inPart;
    truthPixels += inTruth;
    const double arc = truth.arcOfPixels()[i];
    // Arc lengths of pixels are floats: both ends are compared as such.
    if (arc >= static_cast<float>(low) && arc <= static_cast<float>(high)) body.add(inPart, inTruth);
  }
  Score score;
  score.iou = all.iou();
  score.iouBody = body.iou();
  const auto share = [&](std::size_t of) {
    return static_cast<double>(all.both) / static_cast<double>(std::max<std::size_t>(1, of));
  };
  score.precision = share(partPixels);
  score.recall = share(truthPixels);
  const RibScore ribs = scoreRibs(truth, ribEnds);
  if (ribs.count > 0) score.ribs = ribs;
  return score;
}

}  // namespace spineloft::cli
