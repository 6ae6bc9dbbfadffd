// One careless stroke on painted pictures, from pixels to ribs: what must not mislead it. The truth is the
// scene's own formula.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include "engine/base/rng.h"
#include "engine/ribs/base/spine.h"
#include "engine/ribs/search/ribs.h"
#include "engine/vision/edges.h"

using namespace spineloft;
using namespace spineloft::ribs;

namespace {

constexpr image::Size kSize{480, 360};
constexpr double kHalf = 34;

struct Colour {
  double r = 0, g = 0, b = 0;
};
constexpr Colour kWood{168, 112, 64}, kDark{92, 56, 30}, kWall{196, 206, 214}, kPaper{250, 250, 248},
    kPost{60, 84, 150}, kInk{30, 30, 34};

/// The middle of a thing that winds once across the picture.
double middleAt(double x) { return 180 + 46 * std::sin((x - 60) / 360 * 2 * 3.14159265); }

/// Signed distance to the thing, negative inside: to its middle, sampled finely, and its round ends.
double distanceTo(PicturePoint p) {
  static const std::vector<PicturePoint> kMiddle = [] {
    std::vector<PicturePoint> middle;
    for (double x = 70; x <= 410; x += 1) middle.push_back({x, middleAt(x)});
    return middle;
  }();
  double best = 1e18;
  for (const PicturePoint& m : kMiddle) best = std::min(best, (p.x - m.x) * (p.x - m.x) + (p.y - m.y) * (p.y - m.y));
  return std::sqrt(best) - kHalf;
}

/// Sample i of four of a pixel.
PicturePoint sampleAt(int x, int y, int i) { return {x + (i % 2) * 0.5 - 0.25, y + (i / 2) * 0.5 - 0.25}; }

/// distanceTo of all samples, row by row: the thing is the same in every scene.
const std::vector<double>& sampledDistances() {
  static const std::vector<double> kDistances = [] {
    std::vector<double> distances;
    distances.reserve(std::size_t{4} * kSize.width * kSize.height);
    for (int y = 0; y < kSize.height; ++y) {
      for (int x = 0; x < kSize.width; ++x) {
        for (int i = 0; i < 4; ++i) distances.push_back(distanceTo(sampleAt(x, y, i)));
      }
    }
    return distances;
  }();
  return kDistances;
}

using Paint = std::function<Colour(PicturePoint, double away)>;

/// Pixels from 2 × 2 samples, with noise of a few grey levels.
image::EdgeMap mapOf(const Paint& paint) {
  Rng rng(11);
  image::Image image{kSize.width, kSize.height, {}};
  const double* away = sampledDistances().data();
  for (int y = 0; y < kSize.height; ++y) {
    for (int x = 0; x < kSize.width; ++x) {
      Colour sum;
      for (int i = 0; i < 4; ++i) {
        const Colour c = paint(sampleAt(x, y, i), *away++);
        sum = {sum.r + c.r / 4, sum.g + c.g / 4, sum.b + c.b / 4};
      }
      const double noise = rng.uniform(-4, 4);
      for (const double v : {sum.r, sum.g, sum.b}) {
        image.pixels.push_back(static_cast<std::uint8_t>(std::clamp(v + noise, 0.0, 255.0)));
      }
      image.pixels.push_back(255);
    }
  }
  auto map = vision::detectEdges({std::move(image), kSize.width, kSize.height}, {}, Progress{});
  REQUIRE(map.ok());
  return std::move(map.value());
}

std::vector<PicturePoint> stroke(int samples, double off = 0, double wobble = 0) {
  std::vector<PicturePoint> points;
  for (int i = 0; i < samples; ++i) {
    const double x = 80 + 320.0 * i / (samples - 1);
    points.push_back({x, middleAt(x) + off + wobble * std::sin(x / 17)});
  }
  return points;
}

RibSet trace(const std::vector<PicturePoint>& points, const image::EdgeMap& map) {
  const auto spine = cleanSpine(points, kSize, {.ribs = 60});
  REQUIRE(spine.ok());
  auto ribs = traceRibs(spine.value(), map, kSize, {}, Progress{});
  REQUIRE(ribs.ok());
  return std::move(ribs.value());
}

/// Share of the rib ends, without those round the ends of the thing, that are off by more than 15 % of its
/// width.
double missed(const RibSet& set) {
  int misses = 0, all = 0;
  for (std::size_t i = 5; i + 5 < set.ribs.size(); ++i) {
    for (const PicturePoint p : {set.ribs[i].left, set.ribs[i].right}) {
      misses += std::abs(distanceTo(p)) > 0.15 * 2 * kHalf ? 1 : 0;
      ++all;
    }
  }
  return static_cast<double>(misses) / all;
}

Colour plain(PicturePoint, double away) { return away < 0 ? kWood : kWall; }

}  // namespace

TEST_CASE("thirty samples of a stroke and three thousand give nearly the same part" * doctest::test_suite("slow")) {
  const image::EdgeMap map = mapOf(plain);
  const RibSet few = trace(stroke(30, 8, 3), map), many = trace(stroke(3000, 8, 3), map);
  REQUIRE(few.ribs.size() == many.ribs.size());
  CHECK(missed(few) <= 0.02);
  CHECK(missed(many) <= 0.02);
  double apart = 0;
  for (std::size_t i = 5; i + 5 < few.ribs.size(); ++i) {
    apart = std::max({apart, std::abs(distanceTo(few.ribs[i].left) - distanceTo(many.ribs[i].left)),
                      std::abs(distanceTo(few.ribs[i].right) - distanceTo(many.ribs[i].right))});
  }
  CHECK(apart < 0.1 * kHalf);
}

TEST_CASE("off the middle by a quarter of the width, or wobbling by a tenth, the part is the same" *
          doctest::test_suite("slow")) {
  const image::EdgeMap map = mapOf(plain);
  for (const double off : {-kHalf / 2, 0.0, kHalf / 2}) CHECK(missed(trace(stroke(120, off), map)) <= 0.02);
  CHECK(missed(trace(stroke(120, 0, 0.2 * kHalf), map)) <= 0.02);
}

TEST_CASE("stripes across, a label and a highlight along the thing do not stop ribs" * doctest::test_suite("slow")) {
  const auto striped = [](PicturePoint p, double away) {
    if (away >= 0) return kWall;
    return std::fmod(p.x, 44) < 22 ? kWood : kDark;
  };
  const auto labelled = [](PicturePoint p, double away) {
    return away < -10 && p.x > 200 && p.x < 290 ? kPaper : plain(p, away);
  };
  const auto shiny = [](PicturePoint p, double away) {
    const double from = std::abs(p.y - (middleAt(p.x) - 12));
    if (away >= 0 || from > 7) return plain(p, away);
    return Colour{244, 226, 200};
  };
  CHECK(missed(trace(stroke(120), mapOf(striped))) <= 0.05);
  CHECK(missed(trace(stroke(120), mapOf(labelled))) <= 0.05);
  CHECK(missed(trace(stroke(120, 3), mapOf(shiny))) <= 0.05);
}

TEST_CASE("the edge of something in front is not taken for the thing's own" * doctest::test_suite("slow")) {
  const auto behindPost = [](PicturePoint p, double away) {
    return std::abs(p.x - 240 - 0.2 * (p.y - 180)) < 20 ? kPost : plain(p, away);
  };
  CHECK(missed(trace(stroke(120), mapOf(behindPost))) <= 0.06);
}

TEST_CASE("with half of the outline gone at most a few more ends are off than with all of it" *
          doctest::test_suite("slow")) {
  // Every other 30 px of the outline runs out into a soft fog of the thing's own colour.
  const auto half = [](PicturePoint p, double away) {
    if (std::fmod(p.x + (p.y > middleAt(p.x) ? 15 : 0), 60) < 30) return plain(p, away);
    const double t = std::clamp((away + 30) / 60, 0.0, 1.0);
    return Colour{kWood.r + t * (kWall.r - kWood.r), kWood.g + t * (kWall.g - kWood.g),
                  kWood.b + t * (kWall.b - kWood.b)};
  };
  const double complete = missed(trace(stroke(120), mapOf(plain)));
  CHECK(missed(trace(stroke(120), mapOf(half))) <= complete + 0.05);
}

// A known gap: the network takes the stripes (assets/docs/accuracy.md, "Failures").
TEST_CASE("stripes beside the stroke do not make a narrow part of a thing half of whose outline is gone" *
          doctest::test_suite("slow") * doctest::should_fail()) {
  for (const Colour stripe : {kInk, kPaper}) {
    const auto striped = [&](PicturePoint p, double away) {
      const double off = std::abs(p.y - middleAt(p.x));
      if (off > 10 && off < 15) return stripe;
      const double soft = std::clamp(0.5 + away / 48, 0.0, 1.0), sharp = away < 0 ? 0 : 1;
      const double t = std::fmod(p.x, 50) < 25 ? soft : sharp;
      return Colour{kWood.r + t * (kWall.r - kWood.r), kWood.g + t * (kWall.g - kWood.g),
                    kWood.b + t * (kWall.b - kWood.b)};
    };
    const image::EdgeMap map = mapOf(striped);
    CHECK(missed(trace(stroke(120), map)) <= 0.05);
    CHECK(missed(trace(stroke(120, 8), map)) <= 0.05);
  }
}

TEST_CASE("an open sketch of several strokes is one outline" * doctest::test_suite("slow")) {
  const auto inked = [](PicturePoint p, double away) {
    // Strokes of 90 px with gaps of 12 px; each is a little off its neighbour.
    const double along = std::fmod(p.x + (p.y > middleAt(p.x) ? 40 : 0), 102);
    const double off = std::fmod(p.x, 204) < 102 ? 1.5 : -1.5;
    return along < 90 && std::abs(away - off) < 1.6 ? kInk : kPaper;
  };
  CHECK(missed(trace(stroke(120), mapOf(inked))) <= 0.03);
}
