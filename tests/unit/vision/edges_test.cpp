#include "engine/vision/edges.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "engine/base/limits.h"
#include "engine/base/rng.h"
#include "engine/base/worker_pool.h"
#include "engine/vision/thresholds.h"

using namespace spineloft;
using namespace spineloft::image;

namespace {

struct Disc {
  double x = 0, y = 0, radius = 0;
};
struct Look {
  double ground = 200, disc = 60, noise = 0;
  std::uint64_t seed = 1;
};

/// A soft-edged grey disc on plain ground with Gaussian noise.
Picture discPicture(int width, int height, const Disc& disc, const Look& look) {
  Rng rng(look.seed);
  Image image{width, height, {}};
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const double inside = std::clamp(disc.radius - std::hypot(x - disc.x, y - disc.y) + 0.5, 0.0, 1.0);
      const double gauss = std::sqrt(-2 * std::log(1 - rng.uniform())) * std::cos(6.283185307179586 * rng.uniform());
      const double value = look.ground + inside * (look.disc - look.ground) + look.noise * gauss;
      const std::uint8_t v = static_cast<std::uint8_t>(std::clamp(value + 0.5, 0.0, 255.0));
      image.pixels.insert(image.pixels.end(), {v, v, v, 255});
    }
  }
  return makePicture(image);
}

EdgeMap edgesOf(const Picture& picture, const vision::EdgeParams& params = {}) {
  const auto edges = vision::detectEdges(picture, params, Progress());
  REQUIRE(edges.ok());
  return edges.value();
}

/// Share of the disc's outline with an edge within 1.5 px, and share of edges off the outline.
struct Quality {
  double found = 0, spurious = 0;
};
Quality qualityOf(const EdgeMap& map, const Disc& disc) {
  int found = 0, edges = 0, off = 0;
  std::vector<PicturePoint> points;
  for (int y = 0; y < map.height; ++y) {
    for (int x = 0; x < map.width; ++x) {
      if (map.edges[static_cast<std::size_t>(y * map.width + x)] == 0) continue;
      const PicturePoint p{(x + 0.5) * map.scaleX - 0.5, (y + 0.5) * map.scaleY - 0.5};
      points.push_back(p);
      ++edges;
      if (std::abs(std::hypot(p.x - disc.x, p.y - disc.y) - disc.radius) > 2 * map.scaleX) ++off;
    }
  }
  for (int i = 0; i < 360; ++i) {
    const double a = i * 3.14159265358979 / 180;
    const PicturePoint q{disc.x + disc.radius * std::cos(a), disc.y + disc.radius * std::sin(a)};
    found += std::any_of(points.begin(), points.end(),
                         [&](PicturePoint p) { return distance(p, q) <= 1.5 * std::max(map.scaleX, map.scaleY); });
  }
  return {found / 360.0, edges ? 1.0 * off / edges : 0};
}

constexpr Disc kDisc{150.3, 120.7, 70};

}  // namespace

TEST_CASE("the outline of a disc is found whole, in strong and faint contrast, clean and noisy") {
  for (const Look& look : {Look{200, 60, 0}, Look{250, 244, 0}, Look{128, 118, 1.5}, Look{200, 60, 20}, Look{255, 0, 0},
                           Look{90, 110, 3}}) {
    CAPTURE(look.ground);
    CAPTURE(look.noise);
    const Quality quality = qualityOf(edgesOf(discPicture(300, 240, kDisc, look)), kDisc);
    CHECK(quality.found >= 0.97);
    CHECK(quality.spurious <= 0.2);
  }
}

TEST_CASE("edges of equal lightness but different colour are found") {
  Image image{80, 60, {}};
  for (int i = 0; i < 80 * 60; ++i) {
    const bool left = i % 80 < 40;  // both about L = 54
    image.pixels.insert(image.pixels.end(), {std::uint8_t(left ? 200 : 0), std::uint8_t(left ? 85 : 142),
                                             std::uint8_t(left ? 85 : 105), 255});
  }
  const EdgeMap map = edgesOf(makePicture(image));
  for (int y = 2; y < 58; ++y) {
    bool found = false;
    for (int x = 38; x <= 41; ++x) found |= map.edges[static_cast<std::size_t>(y * 80 + x)] != 0;
    REQUIRE(found);
  }
}

TEST_CASE("plain, empty-looking and pure-noise pictures have next to no edges") {
  const auto share = [](const EdgeMap& map) {
    return static_cast<double>(std::count(map.edges.begin(), map.edges.end(), 255)) /
           static_cast<double>(map.edges.size());
  };
  const EdgeMap flat = edgesOf(discPicture(200, 200, {0, 0, 0}, {128, 128, 0}));
  CHECK(share(flat) == 0);
  CHECK(std::ranges::all_of(flat.look, [](const auto& look) { return look[3] == 0; }));
  CHECK(share(edgesOf(discPicture(300, 300, {0, 0, 0}, {128, 128, 10}))) < 0.002);
}

TEST_CASE("proximity is 1 on an edge, falls linearly with the distance and is 0 beyond its reach") {
  const EdgeMap map = edgesOf(discPicture(300, 240, kDisc, {}));
  CHECK(map.reach == doctest::Approx(3.0));
  for (int y = 0; y < map.height; y += 3) {
    for (int x = 0; x < map.width; ++x) {
      double nearest = 1e9;
      for (int v = std::max(0, y - 5); v <= std::min(map.height - 1, y + 5); ++v) {
        for (int u = std::max(0, x - 5); u <= std::min(map.width - 1, x + 5); ++u) {
          if (map.edges[static_cast<std::size_t>(v * map.width + u)]) {
            nearest = std::min(nearest, std::hypot(u - x, v - y));
          }
        }
      }
      const double wanted = std::max(0.0, 1 - nearest / map.reach);
      // Up to half a step of a map's nearness.
      REQUIRE(map.nearness(static_cast<std::size_t>(y * map.width + x)) ==
              doctest::Approx(wanted).epsilon(0.5 / PixelFeature::kNear + 1e-5));
    }
  }
}

TEST_CASE("the gradient points across the outline towards the lighter side, in Lab units") {
  const EdgeMap map = edgesOf(discPicture(300, 240, kDisc, {}));
  for (int i = 0; i < 360; i += 5) {
    const double a = i * 3.14159265358979 / 180;
    const int x = static_cast<int>(std::lround(kDisc.x + kDisc.radius * std::cos(a)));
    const int y = static_cast<int>(std::lround(kDisc.y + kDisc.radius * std::sin(a)));
    const std::size_t at = static_cast<std::size_t>(y * map.width + x);
    const double size = std::hypot(map.gradientX[at], map.gradientY[at]);
    REQUIRE(size > 5);
    REQUIRE((map.gradientX[at] * std::cos(a) + map.gradientY[at] * std::sin(a)) / size > 0.97);
  }
}

TEST_CASE("a large picture is searched on a copy of the asked size, and its points keep their place") {
  const Disc disc{1203, 966, 560};
  const Picture picture = discPicture(2400, 1920, disc, {});
  const EdgeMap map = edgesOf(picture);
  CHECK(std::max(map.width, map.height) == 1024);
  CHECK(map.scaleX == doctest::Approx(2400.0 / map.width));
  CHECK(map.scaleY == doctest::Approx(1920.0 / map.height));
  const std::size_t count = static_cast<std::size_t>(map.width) * static_cast<std::size_t>(map.height);
  CHECK(map.edges.size() == count);
  CHECK(map.gradientX.size() == count);
  CHECK(map.gradientY.size() == count);
  CHECK(map.look.size() == count);
  const Quality quality = qualityOf(map, disc);
  CHECK(quality.found >= 0.99);
  CHECK(quality.spurious <= 0.01);
}

TEST_CASE("turning the picture by 180 degrees turns the edges") {
  const Picture picture = discPicture(120, 90, {50.5, 47.25, 30}, {180, 90, 4});
  Picture turned = picture;
  turned.working = orient(picture.working, 3);
  const EdgeMap a = edgesOf(picture), b = edgesOf(turned);
  int different = 0, edges = 0;
  for (std::size_t i = 0; i < a.edges.size(); ++i) {
    edges += a.edges[i] != 0;
    const bool near = b.nearness(a.edges.size() - 1 - i) > 0.1f;  // ties may thin to the other side
    different += a.edges[i] != 0 && !near;
  }
  REQUIRE(edges > 100);
  CHECK(different <= edges / 50);
}

TEST_CASE("the same picture gives the same edges on several threads at once" * doctest::test_suite("threads")) {
  const Picture picture = discPicture(300, 240, kDisc, {150, 100, 8});
  const EdgeMap wanted = edgesOf(picture);
  std::array<EdgeMap, 3> got;
  WorkerPool pool(static_cast<int>(got.size()));
  for (EdgeMap& map : got) {
    pool.submit(
        "edges", [&picture](const Progress& progress) { return vision::detectEdges(picture, {}, progress); },
        [&map](Result<EdgeMap> edges) {
          if (edges.ok()) map = std::move(edges).value();
        });
  }
  while (!pool.idle()) pool.pump();
  for (const EdgeMap& map : got) CHECK(map == wanted);
}

TEST_CASE("edges refuse what they cannot search") {
  const auto errorOf = [](const Picture& picture, const vision::EdgeParams& params) {
    return vision::detectEdges(picture, params, Progress()).error();
  };
  CHECK(errorOf({}, {}) == Error::PictureEmpty);
  CHECK(errorOf(discPicture(15, 200, {}, {}), {}) == Error::PictureTooSmall);
  const Picture good = discPicture(64, 48, {30, 20, 12}, {});
  for (const int side : {0, 15, 4097}) CHECK(errorOf(good, {side, 1, 0.01}) == Error::ValueOutOfRange);
  for (const double sigma : {-0.1, 5.1, std::nan("")}) {
    CHECK(errorOf(good, {1024, sigma, 0.01}) == Error::ValueOutOfRange);
  }
  for (const double reach : {0.0, 0.2, std::nan("")}) {
    CHECK(errorOf(good, {1024, 1, reach}) == Error::ValueOutOfRange);
  }
}

TEST_CASE("extreme shapes and parameters still work") {
  const EdgeMap strip = edgesOf(discPicture(4000, 16, {2000, 8, 6}, {}));
  CHECK(strip.width == 1024);
  CHECK(strip.height == 4);
  CHECK(edgesOf(discPicture(64, 48, {30, 20, 12}, {}), {16, 0, 0.1}).width == 16);
  CHECK(edgesOf(discPicture(64, 48, {30, 20, 12}, {}), {4096, 5, 0.001}).width == 64);
}

TEST_CASE("cancelled edge work says so and gives nothing") {
  const Picture picture = discPicture(300, 240, kDisc, {});
  const Progress progress;
  progress.cancel();
  const auto edges = vision::detectEdges(picture, {}, progress);
  REQUIRE_FALSE(edges.ok());
  CHECK(edges.error() == Error::Cancelled);
  const Progress watched;
  REQUIRE(vision::detectEdges(picture, {}, watched).ok());
  CHECK(watched.done() == 1);
}

TEST_CASE("thresholds follow the noise, stay between their limits and do not depend on order") {
  Rng rng(9);
  const auto rayleigh = [&](double scale, std::size_t count) {
    std::vector<float> x(count), y(count);
    for (std::size_t i = 0; i < count; ++i) {
      const double r = scale * std::sqrt(-2 * std::log(1 - rng.uniform()));
      const double a = 6.283185307179586 * rng.uniform();
      x[i] = static_cast<float>(r * std::cos(a));
      y[i] = static_cast<float>(r * std::sin(a));
    }
    return std::pair(x, y);
  };
  for (const double scale : {0.3, 1.0, 2.5, 6.0}) {
    auto [x, y] = rayleigh(scale, 20000);
    const vision::Thresholds t = vision::chooseThresholds(x, y);
    CHECK(t.high == doctest::Approx(vision::kNoiseFactor * scale).epsilon(0.05));
    CHECK(t.low == doctest::Approx(vision::kLowShare * t.high));
    std::reverse(x.begin(), x.end());
    std::reverse(y.begin(), y.end());
    CHECK(vision::chooseThresholds(x, y) == t);
  }
  const std::vector<float> none(1000, 0.0f), strong(1000, 30.0f);
  CHECK(vision::chooseThresholds(none, none).high == vision::kFaintest);
  CHECK(vision::chooseThresholds({}, {}).high == vision::kFaintest);
  std::vector<float> art(1000, 0.0f);
  std::fill(art.begin(), art.begin() + 200, 30.0f);
  CHECK(vision::chooseThresholds(art, none).high == vision::kStrongest);
}

TEST_CASE(
    "a contour counts the more, the longer and the stronger it is, and without noise by length "
    "alone") {
  using vision::isContour;
  CHECK_FALSE(isContour(100.0 * (vision::kShortestContour - 1), vision::kShortestContour - 1, 0));
  CHECK(isContour(0.01 * vision::kShortestContour, vision::kShortestContour, 0));
  for (int count = vision::kShortestContour; count < 400; ++count) {
    for (double mean = 0.5; mean < 8; mean += 0.25) {
      const bool kept = isContour(mean * count, count, 1);
      REQUIRE(isContour(2 * mean * count, count, 2) == kept);
      if (!kept) continue;
      REQUIRE(mean > vision::kNoiseLevel);
      REQUIRE(isContour(mean * (count + 1), count + 1, 1));
      REQUIRE(isContour((mean + 0.25) * count, count, 1));
    }
  }
  CHECK_FALSE(isContour(2.2 * 1000, 1000, 1));
  CHECK(isContour(2.6 * 150, 150, 1));
}
