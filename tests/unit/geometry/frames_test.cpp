#include "engine/geometry/frames.h"

#include <doctest/doctest.h>

#include <cmath>
#include <functional>
#include <numbers>

#include "engine/base/rng.h"
#include "tests/support/rounds.h"

using namespace spineloft;
using namespace spineloft::geometry;

namespace {

constexpr double kPi = std::numbers::pi;
using Line = std::vector<ModelPoint>;

Line sampled(std::size_t count, const std::function<ModelPoint(double)>& at) {
  Line line;
  for (std::size_t i = 0; i < count; ++i) {
    line.push_back(at(static_cast<double>(i) / static_cast<double>(count - 1)));
  }
  return line;
}

ModelPoint helix(double t) {
  const double angle = 6 * kPi * t;
  return {300 * t, 40 * std::cos(angle), 40 * std::sin(angle)};
}

/// A closed line that is not plane.
ModelPoint saddleRing(double t) {
  const double angle = 2 * kPi * t;
  return {100 * std::cos(angle) + 15 * std::sin(3 * angle), 80 * std::sin(angle),
          30 * std::sin(2 * angle) + 20 * std::cos(3 * angle)};
}

void requireOrthonormal(const Frame& frame) {
  CHECK(std::abs(norm(frame.tangent) - 1) < 1e-12);
  CHECK(std::abs(norm(frame.across) - 1) < 1e-12);
  CHECK(std::abs(dot(frame.tangent, frame.across)) < 1e-12);
  CHECK(norm(cross(frame.depth, frame.across) - frame.tangent) < 1e-12);
}

/// Angle from the one `across` to the other about a tangent they (nearly) share.
double turnBetween(const Frame& a, const Frame& b) {
  return std::atan2(dot(cross(a.across, b.across), a.tangent), dot(a.across, b.across));
}

}  // namespace

TEST_CASE("frames are orthonormal on any line, also one that turns back") {
  Rng rng(5);
  for (int round = 0; round < testing::rounds(60); ++round) {
    Line line;
    ModelPoint at;
    for (std::uint32_t i = 2 + rng.below(60); i > 0; --i) {
      at += ModelPoint{rng.uniform(-1, 1), rng.uniform(-1, 1), rng.uniform(-1, 1)};
      line.push_back(at);
    }
    if (round % 3 == 0) line.push_back(line[line.size() - 2]);
    for (const Frame& frame : minimalFrames(line, {0, -1, 0}, false)) requireOrthonormal(frame);
    const Frame a = minimalFrames(line, line[1] - line[0], false).front();  // along the tangent
    requireOrthonormal(a);
  }
}

TEST_CASE("frames turn as the fine numeric integration of minimal rotation does") {
  // dU/ds = −(U·dT/ds) T, integrated in a hundred thousand projections.
  const auto exact = [](const std::function<ModelPoint(double)>& at, ModelPoint across) {
    constexpr int kSteps = 100000;
    const auto tangent = [&](double t) { return normalized(at(t + 1e-5) - at(t - 1e-5)); };
    ModelPoint u = normalized(across - tangent(0) * dot(across, tangent(0)));
    for (int i = 1; i <= kSteps; ++i) {
      const ModelPoint t = tangent(static_cast<double>(i) / kSteps);
      u = normalized(u - t * dot(u, t));
    }
    return u;
  };
  const ModelPoint truth = exact(helix, {0, -1, 0});
  double last = 0;
  for (const std::size_t count : {61u, 121u, 241u}) {
    const Line line = sampled(count, helix);
    const double error = distance(minimalFrames(line, {0, -1, 0}, false).back().across, truth);
    CHECK(error < 0.2);
    if (last > 0) CHECK(error < last / 2.5);
    last = error;
  }
  CHECK(last < 2e-3);
}

TEST_CASE("on a plane line the depth direction stays square to the plane") {
  const Line line = sampled(80, [](double t) { return ModelPoint{200 * t, 30 * std::sin(9 * t), 0}; });
  for (const Frame& frame : minimalFrames(line, {0, -1, 0}, false)) {
    CHECK(distance(frame.depth, ModelPoint{0, 0, 1}) < 1e-12);
    CHECK(frame.across.z == 0);
  }
}

TEST_CASE("a closed line's last frame is its first, and it turns evenly on the way") {
  const Line line = sampled(401, saddleRing);
  const auto open = minimalFrames(line, {-1, 0, 0}, false), ring = minimalFrames(line, {-1, 0, 0}, true);
  CHECK(ring.front() == ring.back());
  CHECK(distance(open.front().across, open.back().across) > 0.02);  // there is something to take back
  double length = 0;
  for (std::size_t i = 1; i < line.size(); ++i) length += distance(line[i - 1], line[i]);
  const double total = turnBetween(open[200], ring[200]);
  double along = 0;
  for (std::size_t i = 1; i + 1 < line.size(); ++i) {
    requireOrthonormal(ring[i]);
    along += distance(line[i - 1], line[i]);
    if (i >= 200) continue;
    const double half = 0.5;
    CHECK(turnBetween(open[i], ring[i]) == doctest::Approx(total * along / (half * length)).epsilon(0.08));
  }
}

TEST_CASE("a frame between two is orthonormal and between them") {
  const auto frames = minimalFrames(sampled(60, helix), {0, 0, 1}, false);
  for (std::size_t i = 1; i < frames.size(); ++i) {
    const Frame middle = between(frames[i - 1], frames[i], 0.5);
    requireOrthonormal(middle);
    CHECK(distance(middle.at, frames[i].at) == doctest::Approx(distance(middle.at, frames[i - 1].at)));
    CHECK(dot(middle.tangent, frames[i].tangent) > dot(frames[i - 1].tangent, frames[i].tangent));
  }
  CHECK(between(frames[3], frames[4], 0).at == frames[3].at);
}
