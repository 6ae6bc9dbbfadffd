#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/base/rng.h"
#include "engine/ribs/evidence/evidence.h"
#include "tests/unit/ribs/fixtures.h"

using namespace spineloft;
using namespace spineloft::ribs;

namespace {

using Look = std::array<double, 4>;

// A map of anything, smaller than its picture by different factors.
image::EdgeMap randomMap(Rng& rng) {
  image::EdgeMap map;
  map.width = 90;
  map.height = 70;
  map.scaleX = 2;
  map.scaleY = 1.5;
  map.edges.assign(90 * 70, 0);
  for (int i = 0; i < 90 * 70; ++i) {
    image::PixelFeature look;
    for (std::size_t c = 0; c < 4; ++c) look.set(c, static_cast<float>(rng.uniform(0, 1)));
    map.look.push_back(look);
  }
  return map;
}

struct Plain {
  const GradientCurves& curves;
  const image::EdgeMap& map;
  const IgnoredEdges& ignored;

  // Bilinear, as the definition has it.
  Look between(double x, double y, bool& isIgnored) const {
    const double mx = std::clamp((x + 0.5) / map.scaleX - 0.5, 0.0, map.width - 1.0);
    const double my = std::clamp((y + 0.5) / map.scaleY - 0.5, 0.0, map.height - 1.0);
    const int x0 = std::min(static_cast<int>(mx), map.width - 2);
    const int y0 = std::min(static_cast<int>(my), map.height - 2);
    const double u = mx - x0, v = my - y0;
    const auto pixel = [&](int i, int j) { return static_cast<std::size_t>((y0 + j) * map.width + x0 + i); };
    isIgnored = !ignored.empty() && ignored.mask[pixel(u < 0.5 ? 0 : 1, v < 0.5 ? 0 : 1)] != 0;
    Look sum{};
    for (const int j : {0, 1}) {
      for (const int i : {0, 1}) {
        const double weight = (i ? u : 1 - u) * (j ? v : 1 - v);
        for (std::size_t c = 0; c < 4; ++c) {
          const bool other = c == 3 && !ignored.empty();
          const float value = other ? ignored.proximity[pixel(i, j)] : map.look[pixel(i, j)][c];
          sum[c] += weight * static_cast<double>(value);
        }
      }
    }
    return sum;
  }

  // The mean over a curve's share of the level set; false where the curve itself is ignored.
  bool mean(int c, int k, Look& out) const {
    out = {};
    double count = 0;
    bool none = false;
    const auto add = [&](double x, double y) {
      const Look look = between(x, y, none);
      if (none) return;
      for (std::size_t i = 0; i < 4; ++i) out[i] += look[i];
      ++count;
    };
    const PicturePoint here = curves.point(c, k);
    add(here.x, here.y);
    if (none) {
      out = between(here.x, here.y, none);
      out[3] = 0;
      return false;
    }
    const int total = curves.layout.total();
    for (const int other : {(c + total - 1) % total, (c + 1) % total}) {
      if (k >= curves.reached[static_cast<std::size_t>(other)]) continue;
      const PicturePoint way = curves.point(other, k) - here;
      const int steps = std::min(8, static_cast<int>(0.25 * norm(way) / map.scaleX));
      for (int q = 1; q <= steps; ++q) {
        const PicturePoint p = here + way * (static_cast<double>(q) / (2 * steps + 1));
        add(p.x, p.y);
      }
    }
    for (double& value : out) value /= count;
    return true;
  }
};

GradientCurves someCurves(image::Size size, int ribs) {
  const Spine spine = cleanSpine(fixtures::Points{{30, 40}, {90, 30}, {150, 60}}, size, {.ribs = ribs}).value();
  const D2Field field(spine.points);
  GradientCurves curves;
  traceCurves(spine, field, makeLevels(48, 2, 90, field.length()), 5, size, curves);
  return curves;
}

}  // namespace

TEST_CASE("the strip is the mean along the level set by its definition, up to rounding") {
  Rng rng(20);
  const image::Size size{180, 105};
  UnwrappedImage strip;  // reused: what was in it before never shows
  for (const int ribs : {40, 12, 25}) {
    const GradientCurves curves = someCurves(size, ribs);
    for (const bool marked : {false, true}) {
      const image::EdgeMap map = randomMap(rng);
      IgnoredEdges ignored;
      if (marked) ignored = ignoreEdges(map, std::vector<IgnoreMark>{{{{60, 20}, {120, 50}}, 9}}, {});
      const Plain plain{curves, map, ignored};
      unwrapImage(curves, map, &ignored, strip);
      int different = 0, entries = 0, hidden = 0;
      for (int c = 0; c < strip.curves; ++c) {
        for (int k = 0; k < strip.levels; ++k) {
          const std::size_t at = curves.at(c, k);
          Look wanted{};
          const bool reached = k < curves.reached[static_cast<std::size_t>(c)];
          const bool seen = !reached || plain.mean(c, k, wanted);
          REQUIRE(strip.isIgnored(at) == !seen);
          hidden += seen ? 0 : 1;
          double off = std::abs(static_cast<double>(strip.proximity[at]) - wanted[3]);
          for (std::size_t i = 0; i < 3; ++i)
            off = std::max(off, std::abs(static_cast<double>(strip.lab[at][i]) - wanted[i]));
          ++entries;
          different += off > 2e-4;
        }
      }
      // Rounding may add or drop a sample where the neighbour is a whole number of steps away.
      CHECK(different <= entries / 1000);
      CHECK((hidden > 0) == marked);
    }
  }
}
