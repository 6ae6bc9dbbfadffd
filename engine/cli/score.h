// How well a part fits the truth of a case: the measures of the data folder's scorer, recomputed.
// Coordinates are picture pixels, pixel centres at integers.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "engine/base/vec.h"
#include "engine/image/image.h"

namespace spineloft::cli {

/// Points about every third of a pixel on the half-coverage contour of a mask (every value > 0 is
/// inside), each once, in rows: the border pixels of the mask after threefold bilinear enlargement.
std::vector<PicturePoint> outline(const image::Mask& mask);

/// What is known of a case. `mask`: above 200 the part, 61…200 do not care, else not the part.
struct TruthInput {
  image::Mask mask;
  std::vector<std::array<double, 3>> axis;  ///< ≥ 2: true middle line, x, y and local width
  double tolerance = 1;                     ///< how well the boundary is known, px
};

/// A case prepared for scoring any number of strokes and parts.
class Truth {
 public:
  explicit Truth(TruthInput input);

  int width() const { return mask_.width; }
  int height() const { return mask_.height; }
  double tolerance() const { return tolerance_; }
  /// The true side boundary: the outline without what lies within 2 px of do-not-care or at the
  /// picture's frame.
  const std::vector<PicturePoint>& boundary() const { return boundary_; }

  bool isPart(std::size_t pixel) const { return mask_.pixels[pixel] > 200; }
  bool isCare(std::size_t pixel) const { return mask_.pixels[pixel] <= 60 || mask_.pixels[pixel] > 200; }
  /// Arc length along the axis of the axis point nearest to the pixel (5 × 5 chamfer distance).
  const std::vector<float>& arcOfPixels() const { return arcOfPixels_; }
  /// Whether the point lies in or within 3 px of do-not-care.
  bool nearCut(PicturePoint p) const;
  /// Arc length on the axis of the nearest axis point.
  double arcAt(PicturePoint p) const;
  /// True width at an arc length, ≥ 2 px.
  double widthAt(double arc) const;
  /// Mean of it over the axis.
  double meanWidth() const;
  /// Whether the point lies on the left of the axis, seen on the screen in its direction.
  bool isLeft(PicturePoint p) const;

 private:
  std::size_t pixelAt(PicturePoint p) const;
  std::size_t nearestOnAxis(PicturePoint p) const;
  void resampleAxis(std::span<const std::array<double, 3>> axis);
  void labelPixels();
  void markCuts();
  void findBoundary();

  image::Mask mask_;
  double tolerance_ = 1;
  std::vector<PicturePoint> axis_;  ///< about every pixel
  std::vector<double> arc_, width_;
  std::vector<std::uint8_t> nearCut_;  ///< of every pixel, 2 within 2 px of do-not-care, 1 within 3 px, else 0
  std::vector<PicturePoint> boundary_;
  std::vector<float> arcOfPixels_;
};

/// Distance of rib ends to the true side boundary.
struct RibScore {
  int count = 0;                   ///< rib ends that were judged
  double meanPct = 0, p95Pct = 0;  ///< in % of the local width
  double meanPx = 0;
  double withinTolerance = 0;  ///< share closer than the case's tolerance
};

struct Score {
  double iou = 0;      ///< over all pixels that are not do-not-care
  double iouBody = 0;  ///< the same between the two ends of the stroke
  double precision = 0, recall = 0;
  std::optional<RibScore> ribs;  ///< none when no rib end can be judged
};

/// `part` has the case's size (every value > 0 is the part); `stroke` is what was drawn, ≥ 2
/// points; `ribEnds` both ends of every rib.
Score scorePart(const Truth& truth, const image::Mask& part, std::span<const PicturePoint> stroke,
                std::span<const PicturePoint> ribEnds);

/// The value below which `share` (0…1) of the values lie, interpolated; ≥ 1 value.
double percentile(std::vector<double> values, double share);

}  // namespace spineloft::cli
