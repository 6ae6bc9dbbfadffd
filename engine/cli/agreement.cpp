#include "engine/cli/agreement.h"

#include <algorithm>
#include <cstddef>
#include <limits>

namespace spineloft::cli {
namespace {

struct Stretch {
  double from = 0, to = std::numeric_limits<double>::infinity();  ///< arc lengths on the truth's axis
};

Stretch sharedBy(const Truth& truth, std::span<const std::pair<std::string, std::vector<PicturePoint>>> strokes) {
  Stretch shared;
  for (const auto& [name, points] : strokes) {
    if (points.empty()) continue;
    const double a = truth.arcAt(points.front()), b = truth.arcAt(points.back());
    shared.from = std::max(shared.from, std::min(a, b));
    shared.to = std::min(shared.to, std::max(a, b));
  }
  return shared;
}

struct Overlap {
  std::size_t both = 0, either = 0;

  void add(bool a, bool b) {
    both += a && b;
    either += a || b;
  }
  double iou() const { return either > 0 ? static_cast<double>(both) / static_cast<double>(either) : 0; }
};

}  // namespace

Agreement agreementOf(const Truth& truth, std::span<const image::Mask> parts,
                      std::span<const std::pair<std::string, std::vector<PicturePoint>>> strokes) {
  const Stretch shared = sharedBy(truth, strokes);
  const std::vector<float>& arc = truth.arcOfPixels();
  Agreement sum{0, 0};
  int pairs = 0;
  for (std::size_t a = 0; a < parts.size(); ++a) {
    for (std::size_t b = a + 1; b < parts.size(); ++b, ++pairs) {
      Overlap whole, body;
      const std::size_t count = std::min(parts[a].pixels.size(), parts[b].pixels.size());
      for (std::size_t i = 0; i < count; ++i) {
        const bool inA = parts[a].pixels[i] > 0, inB = parts[b].pixels[i] > 0;
        whole.add(inA, inB);
        if (truth.isCare(i) && arc[i] >= shared.from && arc[i] <= shared.to) body.add(inA, inB);
      }
      sum.whole += whole.iou();
      sum.body += body.iou();
    }
  }
  if (pairs == 0) return {};
  return {sum.whole / pairs, sum.body / pairs};
}

}  // namespace spineloft::cli
