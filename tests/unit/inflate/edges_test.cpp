// Slices across a length: an edge of the same width all round.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>

#include "engine/geometry/spread.h"
#include "engine/inflate/inflate.h"
#include "engine/inflate/profile.h"
#include "engine/inflate/ready_profiles.h"
#include "engine/mesh/self_crossing.h"
#include "tests/support/mesh_laws.h"
#include "tests/support/named_shapes.h"
#include "tests/support/rounds.h"

using namespace spineloft;
using namespace spineloft::inflate;
using namespace spineloft::testing;

namespace {

constexpr image::Size kSize{400, 400};

InflateParams edged(const sections::SectionShape& shape, double pixels, double follow = 0) {
  InflateParams params;
  params.points = 3000;
  params.profile.slices = {{shape}};
  params.profile.follow = follow;
  params.profile.across = Across::Length;
  params.profile.reach = pixels / 400;
  return params;
}
/// Flat below, from 0 at the outline up to 1 at the inner end of the edge.
sections::SectionShape bevel() {
  sections::SectionShape shape;
  shape.contours = {{{-1, -0.5}, {1, -0.5}, {1, 0}, {0, 1}, {-1, 0}}};
  return shape;
}
mesh::TriMesh puffed(const std::string& name, const InflateParams& params) {
  Result<mesh::TriMesh> made = inflateRegion(namedShape(name).contours, kSize, params);
  REQUIRE_MESSAGE(made.ok(), (made.ok() ? std::string() : failureSentence(made.failure())));
  return std::move(made).value();
}

}  // namespace

TEST_CASE("a bevel across a length is as wide everywhere as it is told, and flat within") {
  double worst = 0, mean = 0;
  for (const char* name : {"disc", "square", "stadium", "rectangle", "triangle", "star", "T", "hand", "ring", "A"}) {
    CAPTURE(std::string(name));
    constexpr double kReach = 12;
    const mesh::TriMesh mesh = puffed(name, edged(bevel(), kReach));
    requireLawful(mesh);
    CHECK(!mesh::selfCrossing(mesh));
    const geometry::PlaneRegion outlines = geometry::planeRegion(namedShape(name).contours);
    const geometry::RimDistance rim(outlines.points, outlines.sizes);
    double sum = 0, most = 0;
    int count = 0;
    for (const auto& p : mesh.positions) {
      if (p[2] < 0) continue;
      const double d = rim.to({p[0], p[1]});
      const double off = std::abs(static_cast<double>(p[2]) - std::min(d, kReach)) / kReach;
      sum += off * off;
      most = std::max(most, off);
      ++count;
    }
    REQUIRE(count > 100);
    const double rms = std::sqrt(sum / count);
    CHECK(rms < 0.06);  // with the tips, which are narrower than the edge
    worst = std::max(worst, most);
    mean = std::max(mean, rms);
  }
  MESSAGE("off in % of the width: " << 100 * mean << " RMS, " << 100 * worst << " most");
}

TEST_CASE("a bevel across a length makes the frustum of a cone of a disc") {
  const mesh::MeshReport report = requireLawful(puffed("disc", edged(bevel(), 30)));
  const double pi = std::numbers::pi, outer = 120, inner = 90;
  const double frustum = pi * 30 / 3 * (outer * outer + outer * inner + inner * inner);
  const double below = pi * outer * outer * 15;
  CHECK(report.volume == doctest::Approx(frustum + below).epsilon(0.01));
}

TEST_CASE("edges of all shapes, slices and widths are lawful, have the handles of the formula and do not cross") {
  std::uint64_t count = 0;
  for (const NamedShape& shape : namedShapes()) {
    for (const ReadyProfile& ready : readyProfiles()) {
      const ProfileParams profile = *readyProfile(ready.key);
      if (profile.isSoft()) continue;
      for (const double pixels : {4.0, 10.0, 25.0, 60.0, 400.0}) {
        if (!testing::takes(++count)) continue;
        CAPTURE(shape.name);
        CAPTURE(std::string(ready.key));
        CAPTURE(pixels);
        const InflateParams params = edged(profile.slices.front().shape, pixels, profile.follow);
        const mesh::TriMesh mesh = puffed(shape.name, params);
        const mesh::MeshReport report = requireLawful(mesh);
        const auto curves = profileCurves(profile.slices.front().shape, params.sides);
        const Topology expected = topologyOf(curves.value(), shape.rings);
        CHECK(report.shells == expected.shells);
        CHECK(report.genus == expected.genus);
        CHECK(!mesh::selfCrossing(mesh));
      }
    }
  }
}

TEST_CASE("an edge wider than the shape is the slice across the whole width") {
  InflateParams wide = edged(readyProfile("round")->slices.front().shape, 400, 1), whole = wide;
  whole.profile.across = Across::Share;
  const double one = requireLawful(puffed("T", wide)).volume, other = requireLawful(puffed("T", whole)).volume;
  CHECK(one == doctest::Approx(other).epsilon(0.03));
  wide.profile.reach = 0.001;
  CHECK_FALSE(isValid(wide));
}
