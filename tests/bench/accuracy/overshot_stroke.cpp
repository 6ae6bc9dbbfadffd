#include "tests/bench/accuracy/overshot_stroke.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace spineloft::accuracy {
namespace {

std::optional<std::size_t> pixelAt(const cli::Truth& truth, PicturePoint p) {
  const long x = std::lround(p.x), y = std::lround(p.y);
  if (x < 0 || y < 0 || x >= truth.width() || y >= truth.height()) return std::nullopt;
  return static_cast<std::size_t>(y) * static_cast<std::size_t>(truth.width()) + static_cast<std::size_t>(x);
}

// Where a line goes on from its last point; `line` may run either way.
std::vector<PicturePoint> goneOn(const cli::Truth& truth, std::vector<PicturePoint> line, double share) {
  constexpr double kMostWidths = 3;  // of part that may still lie before the end
  const PicturePoint last = line.back();
  const double width = truth.widthAt(truth.arcAt(last));
  // The way a hand goes: over a quarter of the width, the last few points tremble.
  PicturePoint from = line.front();
  for (const PicturePoint& p : line) {
    if (distance(p, last) >= width / 4) from = p;
  }
  const PicturePoint way = normalized(last - from);
  double inside = 0;
  for (;; ++inside) {
    const auto pixel = pixelAt(truth, last + way * inside);
    if (!pixel || !truth.isCare(*pixel) || inside > kMostWidths * width) return line;
    if (!truth.isPart(*pixel)) break;
  }
  const double far = inside + share * width / 2;
  for (double along = 1; along <= far && pixelAt(truth, last + way * along); ++along)
    line.push_back(last + way * along);
  return line;
}

}  // namespace

std::vector<PicturePoint> overshot(const cli::Truth& truth, std::span<const PicturePoint> stroke, double share) {
  std::vector<PicturePoint> out(stroke.begin(), stroke.end());
  if (!(share > 0)) return out;
  for (int end = 0; end < 2; ++end) {
    out = goneOn(truth, std::move(out), share);
    std::reverse(out.begin(), out.end());
  }
  return out;
}

}  // namespace spineloft::accuracy
