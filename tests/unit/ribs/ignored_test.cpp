#include "engine/ribs/evidence/ignored.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "engine/ribs/evidence/evidence.h"
#include "engine/ribs/search/ribs.h"
#include "tests/unit/ribs/fixtures.h"

using namespace spineloft;
using namespace spineloft::ribs;

namespace {

constexpr image::Size kSize{400, 300};

// A bar of half height 60 with light stripes, as light as the ground, 22 to 53 px off the middle: so broad
// that what comes back beyond them does not speak against them.
const image::EdgeMap& stripedMap() {
  static const image::EdgeMap map = fixtures::mapOf(kSize, [](PicturePoint p) {
    const double away = std::abs(p.y - 150);
    return p.x > 30 && p.x < 370 && away < 60 && !(away > 22 && away < 53);
  });
  return map;
}

// Scribbles along both stripes, one of them in the other direction and twice as dense.
std::vector<IgnoreMark> stripeMarks() {
  IgnoreMark upper{{}, 19}, lower{{}, 19};
  for (double x = 20; x <= 380; x += 10) upper.stroke.push_back({x, 112});
  for (double x = 380; x >= 20; x -= 5) lower.stroke.push_back({x, 188});
  return {upper, lower};
}

double meanHalfHeight(const IgnoredEdges* ignored, const RibParams& params = {}) {
  const Spine spine = cleanSpine(fixtures::Points{{70, 150}, {330, 150}}, kSize, {.ribs = 60}).value();
  const auto set = traceRibs(spine, {stripedMap(), kSize, ignored}, params, Progress{});
  REQUIRE(set.ok());
  double sum = 0;
  for (std::size_t i = 5; i < 55; ++i)
    sum += std::abs(set.value().ribs[i].left.y - 150) + std::abs(set.value().ribs[i].right.y - 150);
  return sum / 100;
}

}  // namespace

TEST_CASE("a stripe that stops the ribs stops them no more when it is scribbled away") {
  // Nearness to an edge alone, which takes the first one.
  RibParams edges;
  edges.evidence.learnedWeight = 0;
  CHECK(meanHalfHeight(nullptr, edges) < 58);
  const IgnoredEdges ofPart = ignoreEdges(stripedMap(), {}, stripeMarks());
  CHECK(std::abs(meanHalfHeight(&ofPart, edges) - 60) < 2);
  CHECK(std::abs(meanHalfHeight(&ofPart) - 60) < 4);
  const IgnoredEdges ofPicture = ignoreEdges(stripedMap(), stripeMarks(), {});
  CHECK(ofPicture == ofPart);
}

TEST_CASE("without marks, or with marks elsewhere, nothing changes bit for bit") {
  const Spine spine = cleanSpine(fixtures::Points{{70, 150}, {330, 150}}, kSize, {.ribs = 60}).value();
  const auto plain = traceRibs(spine, stripedMap(), kSize, {}, Progress{});
  const IgnoredEdges none = ignoreEdges(stripedMap(), {}, {});
  CHECK(none.empty());
  CHECK(traceRibs(spine, {stripedMap(), kSize, &none}, {}, Progress{}).value() == plain.value());
  const std::vector<IgnoreMark> far{{{{-500, -500}, {-400, -500}}, 20}};
  const IgnoredEdges elsewhere = ignoreEdges(stripedMap(), far, {});
  CHECK(traceRibs(spine, {stripedMap(), kSize, &elsewhere}, {}, Progress{}).value() == plain.value());
}

TEST_CASE("under a mark are the pixels within its radius, and only edges outside it are near") {
  Rng rng(4);
  image::EdgeMap map =
      fixtures::mapOf({90, 70}, [](PicturePoint p) { return std::sin(p.x * 0.3) + std::cos(p.y * 0.4) > 0; });
  map.scaleX = map.scaleY = 2;
  for (int round = 0; round < 12; ++round) {
    IgnoreMark mark{{}, rng.uniform(3, 40)};
    for (std::uint32_t i = 1 + rng.below(20); i-- > 0;)
      mark.stroke.push_back({rng.uniform(-20, 200), rng.uniform(-20, 160)});
    const IgnoredEdges ignored = ignoreEdges(map, std::vector{mark}, {});
    REQUIRE(ignored.mask.size() == map.edges.size());
    for (int y = 0; y < map.height; ++y) {
      for (int x = 0; x < map.width; ++x) {
        const PicturePoint p{(x + 0.5) * 2 - 0.5, (y + 0.5) * 2 - 0.5};
        double away = distance(p, mark.stroke[0]);
        for (std::size_t i = 0; i + 1 < mark.stroke.size(); ++i) {
          const PicturePoint u = mark.stroke[i + 1] - mark.stroke[i];
          const double t = std::clamp(dot(p - mark.stroke[i], u) / dot(u, u), 0.0, 1.0);
          away = std::min(away, distance(p, mark.stroke[i] + u * t));
        }
        const auto i = static_cast<std::size_t>(y * map.width + x);
        if (away < 0.9 * mark.radius) CHECK(ignored.mask[i] == 255);
        if (away > 1.1 * mark.radius) CHECK(ignored.mask[i] == 0);
        float nearest = 0;
        for (int v = std::max(0, y - 5); v <= std::min(map.height - 1, y + 5); ++v) {
          for (int u = std::max(0, x - 5); u <= std::min(map.width - 1, x + 5); ++u) {
            const auto j = static_cast<std::size_t>(v * map.width + u);
            if (!map.edges[j] || ignored.mask[j]) continue;
            nearest = std::max(nearest, static_cast<float>(1 - std::hypot(u - x, v - y) / map.reach));
          }
        }
        CHECK(ignored.proximity[i] == doctest::Approx(nearest).epsilon(0.5 / image::PixelFeature::kNear + 1e-5));
      }
    }
  }
}

TEST_CASE("with everything scribbled away the ribs are finite and none stands on an edge") {
  const std::vector<IgnoreMark> all{{{{0, 150}, {400, 150}}, 300}};
  const IgnoredEdges ignored = ignoreEdges(stripedMap(), all, {});
  const Spine spine = cleanSpine(fixtures::Points{{70, 150}, {330, 150}}, kSize, {.ribs = 60}).value();
  const auto set = traceRibs(spine, {stripedMap(), kSize, &ignored}, {}, Progress{});
  REQUIRE(set.ok());
  for (const Rib& rib : set.value().ribs) {
    CHECK(isFinite(rib.left));
    CHECK(isFinite(rib.right));
    CHECK(rib.leftState == RibState::Guessed);
    CHECK(rib.leftOthers.count == 0);
  }
}

TEST_CASE("marks that make no sense count for nothing") {
  const std::vector<IgnoreMark> marks{{{}, 8}, {{{std::nan(""), 3}}, 8}, {{{3, 3}}, 0}, {{{3, 3}}, std::nan("")}};
  CHECK(ignoreEdges(stripedMap(), marks, marks).empty());
  CHECK(ignoreEdges({}, std::vector<IgnoreMark>{{{{3, 3}}, 8}}, {}).empty());
}
