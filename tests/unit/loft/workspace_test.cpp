#include "engine/loft/workspace.h"

#include <doctest/doctest.h>

#include <cmath>
#include <vector>

#include "engine/loft/loft.h"
#include "tests/support/generators.h"
#include "tests/support/mesh_laws.h"
#include "tests/support/rounds.h"
#include "tests/support/scarce_memory.h"

using namespace spineloft;
using namespace spineloft::loft;
using namespace spineloft::sections;
using namespace spineloft::testing;

namespace {

constexpr image::Size kPicture{1000, 800};

// A stroke as long as `to` says, with a fan round either end.
ribs::RibSet growing(double to) {
  ribs::RibSet set = straightRibs({100, 400}, {to, 400}, 100, [](double t) { return 80 + 30 * std::sin(5 * t); });
  for (int i = 1; i < 12; ++i) {
    const double a = 3.14159265358979 * i / 12;
    const ribs::Rib &first = set.ribs.front(), &last = set.ribs.back();
    const double start = distance(first.left, first.right) / 2, end = distance(last.left, last.right) / 2;
    const double side = first.left.y < first.right.y ? -1 : 1;
    set.startFan.points.push_back({100 - start * std::sin(a), 400 + side * start * std::cos(a)});
    set.endFan.points.push_back({to + end * std::sin(a), 400 + side * end * std::cos(a)});
  }
  return set;
}

PosedSpine spineOf(double to) {
  ribs::Spine spine;
  for (int i = 0; i <= 100; ++i) spine.points.push_back({100 + (to - 100) * i / 100, 400});
  return poseSpine(spine, {}).value();
}

}  // namespace

TEST_CASE("a live frame's loft asks for no memory after the first frames") {
  LoftWorkspace memory;
  mesh::TriMesh mesh;
  for (const CapStyle cap : {CapStyle::Round, CapStyle::Flat, CapStyle::Pointed}) {
    LoftParams params;
    params.startCap = params.endCap = cap;
    params.sectionPoints = 64;
    for (int pass = 0; pass < 2; ++pass) {
      for (double to = 300; to <= 900; to += 20) {
        const ribs::RibSet set = growing(to);
        const PosedSpine spine = spineOf(to);
        const std::size_t before = allocatedBytes();
        const Status status = loftRibs({set, kPicture, params}, spine, memory, mesh);
        const std::size_t taken = allocatedBytes() - before;
        REQUIRE(status.ok());
        CAPTURE(to);
        if (pass > 0) CHECK(taken == 0);
      }
    }
    requireLawful(mesh);
  }
}

TEST_CASE("a loft in memory that was used for others is the loft from scratch") {
  Rng rng(91);
  LoftWorkspace memory;
  mesh::TriMesh mesh;
  for (int round = 0; round < testing::rounds(120); ++round) {
    const double to = rng.uniform(200, 900);
    const ribs::RibSet set = growing(to);
    const PosedSpine spine = spineOf(to);
    LoftParams params;
    params.sections[0].shape.preset =
        static_cast<SectionPreset>(rng.below(static_cast<std::uint32_t>(SectionPreset::kCount)));
    params.sectionPoints = 12 + static_cast<int>(rng.below(60));
    params.startCap = static_cast<CapStyle>(rng.below(4));
    params.endCap = static_cast<CapStyle>(rng.below(4));
    if (round % 5 == 0) params.twist.points = {{0, 0}, {1, 3}};
    const auto fresh = loftRibs(set, kPicture, params, spine);
    const Status status = loftRibs({set, kPicture, params}, spine, memory, mesh);
    REQUIRE(status.ok() == fresh.ok());
    if (status.ok()) CHECK(mesh == fresh.value());
    // A failure in between leaves nothing behind.
    if (round % 7 == 0) CHECK_FALSE(loftRibs({ribs::RibSet{}, kPicture, params}, spine, memory, mesh).ok());
  }
}
