#include "engine/geometry/region.h"

#include <algorithm>
#include <cmath>

#include "engine/base/limits.h"
#include "engine/geometry/corners.h"
#include "engine/geometry/polygon.h"
#include "engine/geometry/polyline.h"
#include "engine/geometry/region_grid.h"

namespace spineloft::geometry {
namespace {

constexpr std::size_t kLeastSamples = 8;

double yUpArea(std::span<const PicturePoint> contour) { return -signedArea(contour); }

/// Without points on top of the one before; what is `closed` not back at its beginning.
std::vector<PicturePoint> tidy(const std::vector<PicturePoint>& contour, bool closed) {
  if (contour.empty()) return {};
  std::vector<PicturePoint> out = dropRepeats(std::span<const PicturePoint>(contour), kSamePoint);
  while (closed && out.size() > 1 && distance(out.front(), out.back()) <= kSamePoint) out.pop_back();
  return out;
}

bool isWithin(const Contours& contours, PictureFrame frame) {
  for (const auto& contour : contours) {
    for (const PicturePoint p : contour) {
      if (!(p.x >= -0.5 && p.y >= -0.5 && p.x <= frame.width - 0.5 && p.y <= frame.height - 0.5)) {
        return false;
      }
    }
  }
  return true;
}

bool isSimpleRegion(const Contours& contours) {
  const PlaneRegion region = planeRegion(contours);
  return areSimple(region.points, region.sizes);
}

/// Outer outlines counter-clockwise with y up, holes clockwise, by how many others lie round them.
void orient(Contours& contours) {
  for (std::size_t i = 0; i < contours.size(); ++i) {
    std::size_t round = 0;
    for (std::size_t k = 0; k < contours.size(); ++k) {
      if (k == i) continue;
      round += holds(std::span<const PicturePoint>(contours[k]), contours[i].front());
    }
    const bool isHole = round % 2 != 0;
    if ((yUpArea(contours[i]) > 0) == isHole) std::ranges::reverse(contours[i]);
  }
}

void dropSmall(Contours& contours) {
  std::erase_if(contours, [](const auto& contour) {
    return contour.size() < 3 || std::abs(yUpArea(contour)) < kLeastRegionArea;
  });
}

std::size_t countPoints(const Contours& contours) {
  std::size_t points = 0;
  for (const auto& contour : contours) points += contour.size();
  return points;
}

Result<Contours> finished(Contours contours) {
  dropSmall(contours);
  if (contours.empty()) return Error::RegionEmpty;
  if (countPoints(contours) > kMostCleanPoints) return Error::RegionTooFine;
  orient(contours);
  // A hole without anything round it may be left when a piece went.
  std::erase_if(contours, [](const auto& contour) { return contour.size() < 3; });
  return areaOf(contours) >= kLeastRegionArea ? Result<Contours>(std::move(contours))
                                              : Result<Contours>(Error::RegionEmpty);
}

std::vector<PicturePoint> sampleContour(const std::vector<PicturePoint>& contour, double spacing) {
  std::vector<PicturePoint> closed = contour;
  closed.push_back(contour.front());
  const std::span<const PicturePoint> line(closed);
  const std::vector<double> s = arcLengths(line);
  const double length = s.back();
  spacing = std::min(spacing, length / static_cast<double>(kLeastSamples));
  std::vector<double> corners = cornersOf(line, std::span<const double>(s), spacing);
  if (corners.empty()) corners.push_back(0);
  std::vector<PicturePoint> out;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const double from = corners[i];
    const double to = i + 1 < corners.size() ? corners[i + 1] : corners[0] + length;
    const auto pieces = static_cast<int>(std::max(1.0, std::round((to - from) / spacing)));
    for (int k = 0; k < pieces; ++k) {
      out.push_back(onContour(line, std::span<const double>(s), from + (to - from) * k / pieces));
    }
  }
  return out;
}

}  // namespace

double areaOf(const Contours& contours) {
  double area = 0;
  for (const auto& contour : contours) area += yUpArea(contour);
  return area;
}

double perimeterOf(const Contours& contours) {
  double length = 0;
  for (const auto& contour : contours) {
    for (std::size_t i = 0, j = contour.size() - 1; i < contour.size(); j = i++) {
      length += distance(contour[i], contour[j]);
    }
  }
  return length;
}

PlaneRegion planeRegion(const Contours& contours) {
  PlaneRegion region;
  for (const auto& contour : contours) {
    region.sizes.push_back(contour.size());
    for (const PicturePoint p : contour) region.points.push_back({p.x, -p.y});
  }
  return region;
}

Result<Contours> cleanRegion(const Contours& drawn, double ribbon, PictureFrame frame) {
  Contours contours;
  for (const auto& contour : drawn) {
    std::vector<PicturePoint> clean = tidy(contour, !(ribbon > 0));
    if (clean.size() >= (ribbon > 0 ? 1u : 3u)) contours.push_back(std::move(clean));
  }
  if (contours.empty()) return Error::RegionEmpty;
  if (ribbon > 0) return finished(ribbonOutlines(contours, ribbon, frame));
  if (isWithin(contours, frame) && countPoints(contours) <= kMostCleanPoints) {
    Contours large = contours;
    dropSmall(large);
    if (!large.empty() && isSimpleRegion(large)) return finished(std::move(large));
  }
  return finished(evenOddOutlines(contours, frame));
}

Contours sampleRegion(const Contours& contours, double spacing) {
  constexpr int kTries = 4;
  for (int attempt = 0; attempt < kTries; ++attempt, spacing /= 2) {
    Contours sampled;
    for (const auto& contour : contours) sampled.push_back(sampleContour(contour, spacing));
    if (isSimpleRegion(sampled)) return sampled;
  }
  return contours;
}

}  // namespace spineloft::geometry
