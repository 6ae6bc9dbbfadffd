// Reliefs: heights from ink and from brightness, and meshes that are raised by them.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <set>
#include <utility>

#include "engine/base/rng.h"
#include "engine/mesh/self_crossing.h"
#include "engine/relief/heights.h"
#include "engine/relief/raise.h"
#include "tests/support/mesh_laws.h"
#include "tests/support/pull_hosts.h"
#include "tests/support/rounds.h"

using namespace spineloft;
using namespace spineloft::relief;
using testing::at;

namespace {

constexpr mesh::PictureSize kPaper{200, 200};
/// As bright as `grey` says of a pixel, 0 … 1.
using Grey = std::function<double(double x, double y)>;

std::shared_ptr<const image::Picture> painted(const Grey& grey, int scale = 1) {
  const int side = 200 * scale;
  image::Image image{side, side, std::vector<std::uint8_t>(std::size_t{4} * side * side, 255)};
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) {
      const double value = grey((x + 0.5) / scale - 0.5, (y + 0.5) / scale - 0.5);
      for (int c = 0; c < 3; ++c) {
        image.pixels[std::size_t{4} * (y * side + x) + c] = static_cast<std::uint8_t>(std::lround(255 * value));
      }
    }
  }
  return std::make_shared<const image::Picture>(image::makePicture(std::move(image)));
}

/// With the UV that it has from the front.
mesh::TriMesh seen(mesh::TriMesh mesh, mesh::PictureSize picture = kPaper) {
  mesh.uv.clear();
  for (const auto& p : mesh.positions) mesh.uv.push_back(mesh::frontUv(p[0], p[1], picture));
  return mesh;
}
/// A plate of 160 × 160 in the middle of the paper, 20 thick.
mesh::TriMesh plate() {
  mesh::TriMesh box = testing::box(160, 160, 20);
  for (auto& p : box.positions) p = {p[0] + 20, p[1] - 180, p[2]};
  return seen(std::move(box));
}
mesh::TriMesh ball() { return seen(testing::ball({100, -100, 0}, 80)); }

Raised raised(const mesh::TriMesh& mesh, const Relief& relief, const std::shared_ptr<const image::Picture>& picture,
              mesh::PictureSize size = kPaper) {
  const Heights heights = heightsOf({mesh, size}, relief, picture);
  REQUIRE(heights.found());
  return raisedBy({mesh, size}, heights.front, finished(heights, relief.smooth));
}
mesh::TriMesh made(const mesh::TriMesh& mesh, const Relief& relief,
                   const std::shared_ptr<const image::Picture>& picture, mesh::PictureSize size = kPaper) {
  mesh::TriMesh out;
  CHECK(raiseMesh(raised(mesh, relief, picture, size), relief.height, out) == 1);
  return out;
}

/// How high the front of a mesh is at a place of the picture.
double heightAt(const mesh::TriMesh& mesh, double x, double y) {
  const auto front = frontOf({mesh, kPaper});
  REQUIRE(front.has_value());
  const PicturePoint cell = (PicturePoint{x, y} - front->grid.corner) / front->grid.cell;
  return front->grid.cell * sample(front->grid, front->z, cell.x, cell.y);
}

/// A line of 5 pixels down the middle, and noise of paper.
double drawn(double x, double y) {
  const double paper = 0.95 + 0.01 * std::sin(12.9 * x + 78.2 * y);
  return std::abs(x - 100) < 2.5 && y > 40 && y < 160 ? 0.1 : paper;
}
Relief reliefOf(Mode mode, double height = 0.02, double smooth = 0) { return {mode, height, smooth, {}, {}}; }

}  // namespace

TEST_CASE("a stroke becomes a groove of the height, and paper stays where it was") {
  const mesh::TriMesh out = made(plate(), reliefOf(Mode::Ink), painted(drawn));
  testing::requireLawful(out);
  CHECK(heightAt(out, 100, 100) == doctest::Approx(20 - 0.02 * 160).epsilon(0.02));
  for (const double x : {60.0, 85.0, 130.0}) CHECK(std::abs(heightAt(out, x, 100) - 20) < 0.02);
  const mesh::TriMesh ridge = made(plate(), reliefOf(Mode::Ink, -0.02), painted(drawn));
  CHECK(heightAt(ridge, 100, 100) == doctest::Approx(20 + 0.02 * 160).epsilon(0.02));
}

TEST_CASE(
    "brightness: a pale disc stands out, a dark one sinks in, and the slow change of light over it does not show") {
  const auto picture = painted([](double x, double y) {
    const double light = 0.4 + 0.001 * x;
    if (std::hypot(x - 70, y - 100) < 12) return light + 0.2;
    return std::hypot(x - 130, y - 100) < 12 ? light - 0.2 : light;
  });
  const mesh::TriMesh out = made(plate(), reliefOf(Mode::Bright), picture);
  testing::requireLawful(out);
  CHECK(heightAt(out, 70, 100) > 20 + 1.5);
  CHECK(heightAt(out, 130, 100) < 20 - 1.5);
  CHECK(std::abs(heightAt(out, 50, 40) - 20) < 0.7);
  CHECK(std::abs(heightAt(out, 150, 40) - 20) < 0.7);
}

TEST_CASE("a picture of one colour makes no relief, and leaves the mesh as it was") {
  for (const Mode mode : {Mode::Ink, Mode::Bright, Mode::Shade}) {
    CAPTURE(static_cast<int>(mode));
    for (const double grey : {0.0, 0.4, 1.0}) {
      mesh::TriMesh out;
      raiseMesh(raised(ball(), reliefOf(mode), painted([&](double, double) { return grey; })), 0.1, out);
      CHECK(out == ball());
    }
  }
}

TEST_CASE("the back and the outline stay, whatever the picture shows") {
  const auto picture = painted([](double x, double y) { return 0.5 + 0.4 * std::sin(x / 3) * std::cos(y / 5); });
  for (const bool round : {false, true}) {
    const mesh::TriMesh host = round ? ball() : plate();
    for (const Mode mode : {Mode::Ink, Mode::Bright}) {
      const Raised reach = raised(host, reliefOf(mode), picture);
      CHECK(reach.moved.size() > 500);
      CHECK(reach.mesh.triangles.size() <= kMostTriangles);
      mesh::TriMesh out;
      raiseMesh(reach, 0.02, out);
      testing::requireLawful(out);
      for (const auto& moved : reach.moved) {
        CHECK(moved.normal.z > 0.1);
        CHECK(std::abs(moved.rise) <= 1);
      }
      for (std::size_t i = 0; i < out.positions.size(); ++i) {
        if (reach.mesh.positions[i][2] < 0) CHECK(out.positions[i] == reach.mesh.positions[i]);
        if (round) CHECK(std::hypot(out.positions[i][0] - 100, out.positions[i][1] + 100) < 80.02);
      }
    }
  }
}

TEST_CASE("a mirrored picture gives the mirrored relief, a larger one the same in its size") {
  const Grey grey = [](double x, double y) {
    return std::hypot(x - 80, y - 90) < 15 || std::abs(x + y - 230) < 3 ? 0.2 : 0.9;
  };
  const auto front = [](const Heights& heights) { return finished(heights, 0.2); };
  for (const Mode mode : {Mode::Ink, Mode::Bright}) {
    const Heights here = heightsOf({ball(), kPaper}, reliefOf(mode), painted(grey));
    const Heights mirrored =
        heightsOf({ball(), kPaper}, reliefOf(mode), painted([&](double x, double y) { return grey(199 - x, y); }));
    mesh::TriMesh large = testing::ball({200.5, -200.5, 0}, 160);
    const Heights twice = heightsOf({seen(large, {400, 400}), {400, 400}}, reliefOf(mode), painted(grey, 2));
    const Values values = front(here), other = front(mirrored), larger = front(twice);
    const auto valueAt = [](const Heights& of, const Values& from, double x, double y) {
      const PicturePoint cell = (PicturePoint{x, y} - of.front.grid.corner) / of.front.grid.cell;
      return sample(of.front.grid, from, cell.x, cell.y);
    };
    double mirroredOff = 0, largerOff = 0, all = 0;  // walls are steep: they are not told point by point
    for (double y = 40; y < 160; y += 3) {
      for (double x = 40; x < 160; x += 3) {
        const double value = valueAt(here, values, x, y);
        mirroredOff += std::abs(value - valueAt(mirrored, other, 199 - x, y));
        largerOff += std::abs(value - valueAt(twice, larger, 2 * x + 0.5, 2 * y + 0.5));
        all += std::abs(value);
      }
    }
    CAPTURE(static_cast<int>(mode));
    CHECK(mirroredOff < 0.1 * all);
    CHECK(largerOff < 0.2 * all);
  }
}

TEST_CASE("only what lies within its region is changed, by even-odd") {
  Relief within = reliefOf(Mode::Ink);
  within.region = {{{60, 60}, {140, 60}, {140, 140}, {60, 140}}, {{80, 90}, {120, 90}, {120, 110}, {80, 110}}};
  const mesh::TriMesh out = made(plate(), within, painted(drawn));
  CHECK(heightAt(out, 100, 75) < 20 - 2);
  CHECK(heightAt(out, 100, 125) < 20 - 2);
  CHECK(std::abs(heightAt(out, 100, 50) - 20) < 0.01);
  const Raised reach = raised(plate(), within, painted(drawn));
  for (const auto& moved : reach.moved) {
    const ModelPoint p = at(reach.mesh, moved.vertex);
    CHECK((p.x > 58 && p.x < 142 && -p.y > 58 && -p.y < 142));
    CHECK_FALSE((p.x > 82 && p.x < 118 && -p.y > 92 && -p.y < 108));
  }
}

TEST_CASE("a picture that is laid on a part lies where it was laid, as wide and as turned") {
  Relief laid = reliefOf(Mode::Ink);
  // A stroke to the right of its middle, which a quarter turn clockwise brings below it.
  const auto emblem = painted([](double x, double y) { return std::hypot(x - 150, y - 100) < 12 ? 0.0 : 1.0; });
  laid.laid = Laid{PictureId{2}, {90, 90}, 100, 0};
  CHECK(heightAt(made(plate(), laid, emblem), 115, 90) < 20 - 2);
  laid.laid->turn = 1.5707963267948966;
  const mesh::TriMesh turned = made(plate(), laid, emblem);
  CHECK(heightAt(turned, 90, 115) < 20 - 2);
  CHECK(std::abs(heightAt(turned, 115, 90) - 20) < 0.05);
}

TEST_CASE("a thin wall keeps six tenths of its thickness, however deep a groove is asked for") {
  mesh::TriMesh thin = testing::box(160, 160, 4);
  for (auto& p : thin.positions) p = {p[0] + 20, p[1] - 180, p[2]};
  const mesh::TriMesh out = made(seen(thin), reliefOf(Mode::Ink, 0.1), painted(drawn));
  testing::requireLawful(out);
  CHECK(heightAt(out, 100, 100) == doctest::Approx(0.6 * 4).epsilon(0.02));
}

TEST_CASE("a grid has at most 256 cells on a side, of a part of any size") {
  for (double size = 250; size < 3000; size += 0.7 + size / 400) {
    CAPTURE(size);
    mesh::TriMesh box = testing::box(size, size / 3, 20);
    for (auto& p : box.positions) p = {p[0] + 20, p[1] - 1200, p[2]};
    const mesh::TriMesh mesh = seen(std::move(box), {4000, 4000});
    const auto front = frontOf({mesh, {4000, 4000}});
    REQUIRE(front.has_value());
    CHECK(front->grid.side() <= kMostCells);
    CHECK(front->grid.side() > 240);
    CHECK(std::ranges::count(front->seen, 1) > 0.95 * size / front->grid.cell * size / 3 / front->grid.cell);
  }
}

TEST_CASE("a mesh has no more triangles than it may have") {
  const auto picture = painted([](double x, double y) { return 0.5 + 0.5 * std::sin(x / 2) * std::sin(y / 2); });
  const mesh::TriMesh host = ball();
  const Heights heights = heightsOf({host, kPaper}, reliefOf(Mode::Bright), picture);
  const Values values = finished(heights, 0);
  const Raised whole = raisedBy({host, kPaper}, heights.front, values);
  const Raised coarse = raisedBy({host, kPaper}, heights.front, values, kLiveTriangles);
  CHECK(whole.mesh.triangles.size() > 25000);
  CHECK(whole.mesh.triangles.size() <= kMostTriangles);
  CHECK(coarse.mesh.triangles.size() <= kLiveTriangles);
  CHECK(coarse.mesh.triangles.size() > 0.9 * kLiveTriangles);
  mesh::TriMesh out;
  raiseMesh(coarse, 0.02, out);
  testing::requireLawful(out);
}

TEST_CASE("a part that is smaller than 24 pixels, or of which nothing is seen, has no relief") {
  const auto picture = painted(drawn);
  CHECK_FALSE(heightsOf({seen(testing::ball({100, -100, 0}, 11)), kPaper}, reliefOf(Mode::Ink), picture).found());
  CHECK(heightsOf({seen(testing::ball({100, -100, 0}, 13)), kPaper}, reliefOf(Mode::Ink), picture).found());
  CHECK_FALSE(heightsOf({seen(testing::ball({400, -100, 0}, 50)), kPaper}, reliefOf(Mode::Ink), picture).found());
  CHECK_FALSE(heightsOf({ball(), kPaper}, reliefOf(Mode::Ink), nullptr).found());
}

TEST_CASE("numbers out of range are refused by name") {
  const auto says = [](Relief one) {
    return checkRelief(one).ok() ? std::string() : checkRelief(one).failure().detail;
  };
  CHECK(checkRelief({}).ok());
  CHECK(says(reliefOf(Mode::Ink, std::nan(""))).starts_with("height"));
  CHECK(says(reliefOf(Mode::Ink, 0.2)).starts_with("height"));
  CHECK(says(reliefOf(Mode::Ink, 0, 1.5)).starts_with("smoothness"));
  CHECK(says(reliefOf(static_cast<Mode>(7))).starts_with("what becomes"));
  Relief bad;
  bad.region = {{{0, 0}, {1, 1}}};
  CHECK(says(bad).starts_with("the region"));
  bad = {};
  bad.laid = Laid{PictureId{}, {}};
  CHECK(says(bad).starts_with("the picture"));
  bad.laid = Laid{PictureId{1}, {1e9, 0}};
  CHECK(says(bad).starts_with("the picture"));
  bad.laid = Laid{PictureId{1}, {}, 0};
  CHECK(says(bad).starts_with("width"));
  bad.laid = Laid{PictureId{1}, {}, 50, 9};
  CHECK(says(bad).starts_with("turn"));
}

TEST_CASE(
    "random pictures on balls, plates and rings: lawful meshes of the same genus that do not go through themselves") {
  std::size_t whole = 0, all = 0;
  for (const std::uint64_t seed : testing::seeds(1, 12)) {
    CAPTURE(seed);
    Rng rng(seed);
    const double a = rng.uniform(2, 20), b = rng.uniform(2, 20), turn = rng.uniform(0, 3);
    const auto picture = painted([&](double x, double y) {
      const double u = std::cos(turn) * x + std::sin(turn) * y, v = std::cos(turn) * y - std::sin(turn) * x;
      return std::clamp(0.5 + 0.5 * std::sin(u / a) * std::sin(v / b), 0.0, 1.0);
    });
    mesh::TriMesh ring = testing::torus(55, 20);
    for (auto& p : ring.positions) p = {p[0] + 100, p[1] - 100, p[2]};
    for (const mesh::TriMesh& host : {ball(), plate(), seen(ring)}) {
      Relief random = reliefOf(seed % 2 ? Mode::Ink : Mode::Bright, rng.uniform(-0.05, 0.05), rng.uniform(0, 1));
      mesh::TriMesh out;
      const double share = raiseMesh(raised(host, random, picture), random.height, out);
      testing::requireLawful(out);
      CHECK(mesh::inspect(out).genus == mesh::inspect(host).genus);
      CHECK_FALSE(mesh::selfCrossing(out));
      whole += share == 1;
      ++all;
    }
  }
  CHECK(all > 0);
  CHECK(whole * 10 >= all * 9);
}
