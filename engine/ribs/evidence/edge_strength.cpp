#include "engine/ribs/evidence/edge_strength.h"

#include <algorithm>
#include <cmath>

#include "engine/base/sorted_window.h"

namespace spineloft::ribs {
namespace {

// Labels to either side of an end among which its edge is looked for.
constexpr int kReach = 2;
// How far "near by" is, as a share of the ribs, which of the ends there counts as a strong one, and the share of
// its strength that is enough.
constexpr double kNearby = 0.2, kStrong = 0.75;
constexpr float kEnough = 0.6f;
// Lab difference below which there is no edge to compare with.
constexpr float kNothing = 1e-3f;

std::size_t index(int i) { return static_cast<std::size_t>(i); }

}  // namespace

const std::vector<float>& edgeStrengths(const SideEnds& ends, std::span<const std::array<float, 4>> differences,
                                        EdgeStrengths& memory) {
  const GradientCurves& curves = ends.curves;
  const int ribs = curves.layout.ribs;
  const std::size_t stride = index(curves.levels) + 1;
  memory.relative.assign(index(ribs), 1.f);
  if (differences.size() < stride * index(curves.layout.total())) return memory.relative;
  memory.raw.assign(index(ribs), 0.f);
  for (int i = 0; i < ribs; ++i) {
    const int curve = ends.left ? curves.layout.left(i) : curves.layout.right(i);
    const int label = ends.labels[index(i)];
    const int last = std::min(curves.reached[index(curve)] - 1, label + kReach);
    float most = 0;
    for (int k = std::max(1, label - kReach); k <= last; ++k) {
      const auto& d = differences[index(curve) * stride + index(k)];
      most = std::max(most, d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
    }
    memory.raw[index(i)] = std::sqrt(most);
  }
  const int window = std::max(1, static_cast<int>(kNearby * ribs));
  SortedWindow nearby(memory.nearby);
  for (int i = 0; i < std::min(ribs, window); ++i) nearby.add(memory.raw[index(i)]);
  for (int i = 0; i < ribs; ++i) {
    if (i + window < ribs) nearby.add(memory.raw[index(i + window)]);
    if (i > window) nearby.remove(memory.raw[index(i - window - 1)]);
    const float strong = nearby.at(static_cast<std::size_t>(kStrong * static_cast<double>(nearby.size() - 1)));
    memory.relative[index(i)] = std::min(1.f, memory.raw[index(i)] / std::max(kNothing, kEnough * strong));
  }
  return memory.relative;
}

}  // namespace spineloft::ribs
