#include "engine/vision/contours.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "engine/base/rng.h"
#include "tests/support/rounds.h"

using namespace spineloft;

namespace {

// Waves of several directions and some noise, with equal neighbours here and there, as plain pictures have them.
image::EdgeMap wavyMap(int width, int height, double strength, Rng& rng) {
  image::EdgeMap map;
  map.width = width;
  map.height = height;
  const double turn = rng.uniform(0, 6.28), pace = rng.uniform(0.05, 0.9);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const double wave = std::sin(pace * (x * std::cos(turn) + y * std::sin(turn))), noise = rng.uniform(-0.3, 0.3);
      const double size = strength * std::abs(wave + noise), angle = turn + 2 * wave + 3 * std::sin(0.2 * y);
      map.gradientX.push_back(static_cast<float>(std::round(size * std::cos(angle) * 4) / 4));
      map.gradientY.push_back(static_cast<float>(std::round(size * std::sin(angle) * 4) / 4));
    }
  }
  return map;
}

// Canny as it is written down, one pixel at a time and with angles; contours are told apart by spreading marks until
// nothing changes.
class PlainCanny {
 public:
  PlainCanny(const image::EdgeMap& map, const vision::Thresholds& thresholds) : map_(map) {
    std::vector<int> marks(map.gradientX.size(), 0);
    for (int y = 0; y < map.height; ++y) {
      for (int x = 0; x < map.width; ++x) {
        if (size(x, y) > thresholds.low && isTop(x, y)) marks[at(x, y)] = size(x, y) > thresholds.high ? 2 : 1;
      }
    }
    for (bool again = true; again;) {
      again = false;
      for (int y = 0; y < map.height; ++y) {
        for (int x = 0; x < map.width; ++x) {
          if (marks[at(x, y)] != 1 || !touches(marks, x, y)) continue;
          marks[at(x, y)] = 2;
          again = true;
        }
      }
    }
    for (const int mark : marks) edges_.push_back(mark == 2 ? 255 : 0);
  }
  const std::vector<std::uint8_t>& edges() const { return edges_; }

 private:
  std::size_t at(int x, int y) const { return static_cast<std::size_t>(y * map_.width + x); }
  bool inside(int x, int y) const { return x >= 0 && y >= 0 && x < map_.width && y < map_.height; }
  double size(int x, int y) const {
    return inside(x, y) ? std::hypot(static_cast<double>(map_.gradientX[at(x, y)]),
                                     static_cast<double>(map_.gradientY[at(x, y)]))
                        : 0;
  }
  bool isTop(int x, int y) const {
    const double dx = static_cast<double>(map_.gradientX[at(x, y)]), dy = static_cast<double>(map_.gradientY[at(x, y)]);
    const double angle = std::atan2(std::abs(dy), std::abs(dx)) * 180 / 3.14159265358979, here = size(x, y);
    if (angle < 22.5) return here > size(x - 1, y) && here >= size(x + 1, y);
    if (angle > 67.5) return here > size(x, y - 1) && here >= size(x, y + 1);
    const int side = dx * dy < 0 ? -1 : 1;
    return here > size(x - side, y - 1) && here > size(x + side, y + 1);
  }
  bool touches(const std::vector<int>& marks, int x, int y) const {
    for (int v = y - 1; v <= y + 1; ++v) {
      for (int u = x - 1; u <= x + 1; ++u) {
        if (inside(u, v) && marks[at(u, v)] == 2) return true;
      }
    }
    return false;
  }

  const image::EdgeMap& map_;
  std::vector<std::uint8_t> edges_;
};

// Contours of fewer pixels are specks, whatever Canny says.
std::vector<std::uint8_t> withoutSpecks(std::vector<std::uint8_t> edges, int width) {
  std::vector<bool> seen(edges.size(), false);
  for (std::size_t start = 0; start < edges.size(); ++start) {
    if (edges[start] == 0 || seen[start]) continue;
    std::vector<std::size_t> contour{start};
    seen[start] = true;
    for (std::size_t i = 0; i < contour.size(); ++i) {
      const int x = static_cast<int>(contour[i]) % width, y = static_cast<int>(contour[i]) / width;
      for (std::size_t next = 0; next < edges.size(); ++next) {
        const int u = static_cast<int>(next) % width, v = static_cast<int>(next) / width;
        if (edges[next] == 0 || seen[next] || std::abs(u - x) > 1 || std::abs(v - y) > 1) continue;
        seen[next] = true;
        contour.push_back(next);
      }
    }
    if (contour.size() >= static_cast<std::size_t>(vision::kShortestContour)) continue;
    for (const std::size_t pixel : contour) edges[pixel] = 0;
  }
  return edges;
}

}  // namespace

TEST_CASE("edges are Canny's: thin maxima, and what is weak only where it is joined to what is strong") {
  Rng rng(20261121);
  int found = 0;
  for (int round = 0; round < testing::rounds(60); ++round) {
    const int width = 1 + static_cast<int>(rng.below(60)), height = 1 + static_cast<int>(rng.below(40));
    image::EdgeMap map = wavyMap(width, height, rng.uniform(1, 9), rng);
    const vision::Thresholds thresholds{rng.uniform(0.5, 2), rng.uniform(2, 5), 0};
    vision::fillEdges(thresholds, map);
    const auto wanted = withoutSpecks(PlainCanny(map, thresholds).edges(), width);
    CHECK(map.edges == wanted);
    found += static_cast<int>(std::count(wanted.begin(), wanted.end(), 255));
  }
  CHECK(found > 1000);
}

TEST_CASE("gradients of any size are compared without overflow") {
  for (const float most : {150.f, 1e4f, 1e30f}) {
    image::EdgeMap map;
    map.width = 20;
    map.height = 12;
    for (int i = 0; i < 240; ++i) {
      const bool ridge = i / 20 == 6;
      map.gradientX.push_back(0);
      map.gradientY.push_back(ridge ? -most : 1);
    }
    vision::fillEdges({2, 4, 0}, map);
    for (int i = 0; i < 240; ++i) CHECK((map.edges[static_cast<std::size_t>(i)] != 0) == (i / 20 == 6));
  }
}
