// Random regions with random slices at random places, their bones changed at random.
#include <doctest/doctest.h>

#include <algorithm>
#include <string>
#include <utility>

#include "engine/base/rng.h"
#include "engine/geometry/pieces.h"
#include "engine/inflate/inflate.h"
#include "engine/inflate/profile.h"
#include "engine/inflate/ready_profiles.h"
#include "engine/inflate/skeleton.h"
#include "engine/mesh/self_crossing.h"
#include "tests/support/mesh_laws.h"
#include "tests/support/named_shapes.h"
#include "tests/support/outlines.h"
#include "tests/support/rounds.h"

using namespace spineloft;
using namespace spineloft::inflate;
using namespace spineloft::testing;

namespace {

geometry::Contours anyRegion(Rng& rng) {
  geometry::Contours outlines;
  if (rng.below(2) == 0) {
    const auto& shapes = namedShapes();
    const auto& calm = shapes[rng.below(static_cast<std::uint32_t>(shapes.size()))].contours;
    const double tremor = rng.uniform(0, 3), wave = rng.uniform(15, 60);
    outlines = trembling(calm, tremor, wave, rng.below(1000));
  } else {
    outlines = {blob(rng, {200, 200}, rng.uniform(40, 120), 220)};
    if (rng.below(3) == 0) {
      const double width = rng.uniform(5, 14), height = rng.uniform(5, 14);
      outlines.push_back(ellipse({200, 200}, width, height, 50));
    }
    if (rng.below(3) == 0) outlines.push_back(ellipse({380, 20}, 15, 15, 50));
  }
  Result<geometry::Contours> clean = geometry::cleanRegion(outlines, 0, {400, 400});
  REQUIRE(clean.ok());
  return std::move(clean).value();
}

/// Edits round the skeleton that a hand finds there.
BoneEdits anyEdits(Rng& rng, const geometry::Contours& region) {
  std::vector<SkeletonPoint> bones;
  for (const geometry::Contours& piece : geometry::piecesOf(region)) {
    const auto made = skeletonOf(piece);
    REQUIRE(made.ok());
    bones.insert(bones.end(), made.value().points.begin(), made.value().points.end());
  }
  const auto place = [&] {
    const SkeletonPoint& p = bones[rng.below(static_cast<std::uint32_t>(bones.size()))];
    const SectionPoint at = p.at + SectionPoint{rng.uniform(-1, 1), rng.uniform(-1, 1)} * p.radius;
    return PicturePoint{at.x, -at.y};
  };
  BoneEdits edits;
  edits.detail = rng.uniform(0, 1);
  for (std::uint32_t i = rng.below(3); i > 0; --i) edits.drop.push_back(place());
  for (std::uint32_t i = rng.below(3); i > 0; --i) edits.add.push_back({place(), place(), place()});
  for (std::uint32_t i = rng.below(3); i > 0; --i) edits.move.push_back({place(), place()});
  for (std::uint32_t i = rng.below(3); i > 0; --i) edits.heights.push_back({place(), rng.uniform(0.1, 4)});
  return edits;
}

struct Puff {
  geometry::Contours region;
  InflateParams params;
};
Result<mesh::TriMesh> solidOf(const Puff& puff) { return inflateRegion(puff.region, {400, 400}, puff.params); }

/// A random region, slice and edits of bones.
Puff anyPuff(std::uint64_t seed) {
  const auto ready = readyProfiles();
  Rng rng(seed);
  const geometry::Contours region = anyRegion(rng);
  InflateParams params;
  params.points = static_cast<int>(rng.uniform(300, 2500));
  params.height = rng.uniform(0.3, 2);
  params.sides = static_cast<InflateSides>(rng.below(3));
  params.profile = *readyProfile(ready[1 + rng.below(static_cast<std::uint32_t>(ready.size() - 1))].key);
  params.profile.follow = rng.uniform(0, 1);
  while (rng.below(3) == 0 && params.profile.slices.size() < kMostSlices) {
    ProfileSlice other = params.profile.slices.front();
    for (auto& contour : other.shape.contours) {
      for (SectionPoint& p : contour) p.y *= 0.6;
    }
    other.at = PicturePoint{rng.uniform(80, 320), rng.uniform(80, 320)};
    params.profile.slices.push_back(other);
  }
  params.bones = anyEdits(rng, region);
  REQUIRE(isValid(params));
  return {region, params};
}

/// The solid of a puff is lawful, has the shells and handles of the formula, and does not go through itself.
void checkSolid(const Puff& puff, const mesh::TriMesh& solid) {
  const auto curves = matchedCurves(puff.params.profile.slices, puff.params.sides);
  REQUIRE(curves.ok());
  const mesh::MeshReport report = requireLawful(solid);
  std::vector<ProfileCurve> first;
  for (const auto& curve : curves.value()) first.push_back(curve.front());
  Topology expected;
  for (const geometry::Contours& piece : geometry::piecesOf(puff.region)) {
    const Topology own = topologyOf(first, static_cast<int>(piece.size()) - 1);
    expected.shells += own.shells;
    expected.genus += own.genus;
  }
  CHECK(report.shells == expected.shells);
  CHECK(report.genus == expected.genus);
  CHECK(!mesh::selfCrossing(solid));
}

}  // namespace

TEST_CASE("random regions, slices and edits of bones leave lawful solids with the shells and handles of the formula") {
  int refused = 0, tried = 0;
  for (const std::uint64_t seed : testing::seeds(1, 40)) {
    ++tried;
    CAPTURE(seed);
    const Puff puff = anyPuff(seed);
    const Result<mesh::TriMesh> solid = solidOf(puff);
    if (solid.ok()) {
      checkSolid(puff, solid.value());
    } else {
      CHECK(solid.error() == Error::SectionInvalid);
      ++refused;
    }
  }
  CHECK(1000 * refused <= tried);
}

TEST_CASE("rings in narrow places, and rows next to outlines that bend, do not go through each other") {
  for (const std::uint64_t seed : {343, 498, 1432, 1740, 2173, 2497, 2624, 3278, 3338, 3575, 3701}) {
    CAPTURE(seed);
    const Puff puff = anyPuff(seed);
    const Result<mesh::TriMesh> solid = solidOf(puff);
    REQUIRE(solid.ok());
    checkSolid(puff, solid.value());
  }
}

TEST_CASE("a puff whose rows go through each other however fine they are is refused, and not made all the same") {
  const Result<mesh::TriMesh> mesh = solidOf(anyPuff(2491));
  REQUIRE(!mesh.ok());
  CHECK(mesh.error() == Error::SectionInvalid);
}
