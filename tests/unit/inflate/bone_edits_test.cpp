#include "engine/inflate/bone_edits.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/base/rng.h"
#include "engine/inflate/inflate.h"
#include "engine/mesh/self_crossing.h"
#include "tests/support/mesh_laws.h"
#include "tests/support/named_shapes.h"
#include "tests/support/rounds.h"

using namespace spineloft;
using namespace spineloft::inflate;
using namespace spineloft::testing;

namespace {

EditedSkeleton edited(const std::string& shape, const BoneEdits& edits) {
  Result<EditedSkeleton> made = editedSkeleton(namedShape(shape).contours, edits);
  REQUIRE(made.ok());
  return std::move(made).value();
}

PicturePoint picture(SectionPoint p) { return {p.x, -p.y}; }
SectionPoint up(PicturePoint p) { return {p.x, -p.y}; }

/// A point with one neighbour.
std::vector<std::uint32_t> endsOf(const Skeleton& skeleton) {
  std::vector<int> degree(skeleton.points.size(), 0);
  for (const auto& branch : skeleton.branches) {
    for (std::size_t i = 1; i < branch.size(); ++i) ++degree[branch[i]], ++degree[branch[i - 1]];
  }
  std::vector<std::uint32_t> ends;
  for (std::uint32_t i = 0; i < degree.size(); ++i) {
    if (degree[i] == 1) ends.push_back(i);
  }
  return ends;
}

double farthestFrom(const Skeleton& skeleton, SectionPoint p) {
  double least = 1e9;
  for (const SkeletonPoint& point : skeleton.points) least = std::min(least, distance(point.at, p));
  return least;
}

InflateParams roundPuff(BoneEdits bones) {
  InflateParams params;
  params.points = 1500;
  params.profile.slices = {{sections::SectionShape{sections::SectionPreset::Circle}}};
  params.bones = std::move(bones);
  return params;
}

constexpr image::Size kPicture{400, 400};

}  // namespace

TEST_CASE("no edits leave the skeleton as it is found") {
  for (const NamedShape& shape : namedShapes()) {
    CAPTURE(shape.name);
    const EditedSkeleton same = edited(shape.name, {});
    CHECK(same.skeleton == skeletonOf(shape.contours).value());
    CHECK(same.awake == AwakeEdits{});
  }
}

TEST_CASE("detail goes from few branches to many, the middle being the usual scale") {
  CHECK(scaleFor(0) == doctest::Approx(3));
  CHECK(scaleFor(0.5) == doctest::Approx(kScale));
  CHECK(scaleFor(1) == doctest::Approx(1.1));
  for (const NamedShape& shape : namedShapes()) {
    CAPTURE(shape.name);
    const auto ends = [&](double detail) {
      BoneEdits edits;
      edits.detail = detail;
      return edited(shape.name, edits).skeleton.ends;
    };
    CHECK(ends(0) <= ends(0.5));
    CHECK(ends(0.5) <= ends(1));
  }
}

TEST_CASE("a branch with an end is dropped at its end, and its fork with it when two are left") {
  for (const char* name : {"T", "E", "X", "H", "star", "hand", "triangle"}) {
    CAPTURE(name);
    const Skeleton whole = edited(name, {}).skeleton;
    for (const std::uint32_t end : endsOf(whole)) {
      BoneEdits edits;
      edits.drop = {picture(whole.points[end].at)};
      const EditedSkeleton left = edited(name, edits);
      CHECK(left.awake.drop == std::vector<char>{1});
      CHECK(left.skeleton.ends == whole.ends - 1);
      CHECK(left.skeleton.forks <= whole.forks);
      CHECK(left.skeleton.rings == 0);
      CHECK(farthestFrom(left.skeleton, whole.points[end].at) > whole.points[end].radius / 2);
    }
  }
}

TEST_CASE("cycles cannot be dropped; what hangs on them can") {
  const Skeleton ring = edited("ring", {}).skeleton;
  BoneEdits edits;
  edits.drop = {picture(ring.points[0].at)};
  const EditedSkeleton same = edited("ring", edits);
  CHECK(same.awake.drop == std::vector<char>{0});
  CHECK(same.skeleton == ring);
  const Skeleton a = edited("A", {}).skeleton;
  for (const std::uint32_t end : endsOf(a)) {
    edits.drop = {picture(a.points[end].at)};
    const EditedSkeleton left = edited("A", edits);
    CHECK(left.skeleton.rings == a.rings);
    CHECK(left.skeleton.ends == a.ends - left.awake.drop[0]);
  }
}

TEST_CASE("the only branch of a shape is dropped to its largest disc") {
  BoneEdits edits;
  edits.drop = {{200, 200}};
  const EditedSkeleton point = edited("stadium", edits);
  REQUIRE(point.skeleton.points.size() == 1);
  CHECK(point.awake.drop == std::vector<char>{1});
}

TEST_CASE("a line from the skeleton becomes a branch up to where it leaves the region") {
  BoneEdits edits;
  edits.add = {{{200, 200}, {200, 20}}};  // out of the disc of radius 120
  const EditedSkeleton disc = edited("disc", edits);
  CHECK(disc.awake.add == std::vector<char>{1});
  CHECK(disc.skeleton.ends == 2);
  CHECK(farthestFrom(disc.skeleton, {200, -90}) < 10);
  for (const SkeletonPoint& p : disc.skeleton.points) CHECK(p.at.y < -80);
  // Across the only branch: it begins at the crossing.
  edits.add = {{{200, 190}, {200, 230}}};
  const EditedSkeleton stadium = edited("stadium", edits);
  CHECK(stadium.skeleton.forks == 1);
  CHECK(stadium.skeleton.ends == 3);
}

TEST_CASE("an end that is moved takes its branch along, and stays inside") {
  const Skeleton whole = edited("T", {}).skeleton;
  for (const std::uint32_t end : endsOf(whole)) {
    const SkeletonPoint at = whole.points[end];
    const SectionPoint to = at.at + SectionPoint{0.4, 0.3} * at.radius;
    BoneEdits edits;
    edits.move = {{picture(at.at), picture(to)}};
    const EditedSkeleton moved = edited("T", edits);
    REQUIRE(moved.awake.move == std::vector<char>{1});
    CHECK(farthestFrom(moved.skeleton, to) < 1e-9);
    CHECK(moved.skeleton.ends == whole.ends);
    edits.move[0].to = {-500, -500};
    const EditedSkeleton same = edited("T", edits);
    CHECK(same.awake.move == std::vector<char>{0});
    CHECK(same.skeleton == whole);
  }
}

TEST_CASE("a fork is not moved over a hole, nor a bone out of the region between two of its points") {
  const Skeleton a = edited("A", {}).skeleton;
  std::vector<int> degree(a.points.size(), 0);
  for (const auto& branch : a.branches) {
    for (std::size_t i = 1; i < branch.size(); ++i) ++degree[branch[i]], ++degree[branch[i - 1]];
  }
  const SectionPoint hole = up(namedShape("A").contours[1][0]);
  int slept = 0, moved = 0;
  for (std::uint32_t i = 0; i < degree.size(); ++i) {
    if (degree[i] < 3) continue;
    for (double way = 0.5; way < 3; way += 0.25) {
      BoneEdits edits;
      edits.move = {{picture(a.points[i].at), picture(lerp(a.points[i].at, hole, way))}};
      const EditedSkeleton made = edited("A", edits);
      (made.awake.move[0] ? moved : slept) += 1;
      InflateParams params = roundPuff(edits);
      const Result<mesh::TriMesh> mesh = inflateRegion(namedShape("A").contours, kPicture, params);
      REQUIRE(mesh.ok());
      CHECK(requireLawful(mesh.value()).genus == 1);
    }
  }
  CHECK(slept > 3);
  CHECK(moved > 0);
}

TEST_CASE("a height is its factor at its place and fades along the skeleton") {
  BoneEdits edits;
  edits.heights = {{{200, 200}, 2}};
  const Skeleton stadium = edited("stadium", edits).skeleton;
  double most = 0, atEnds = 0;
  for (const SkeletonPoint& p : stadium.points) most = std::max(most, p.over.factor);
  for (const std::uint32_t end : endsOf(stadium)) atEnds = std::max(atEnds, stadium.points[end].over.factor);
  CHECK(most == doctest::Approx(2).epsilon(0.01));
  CHECK(atEnds > 1);
  CHECK(atEnds < 1.7);
  const auto height = [&](BoneEdits bones) {
    const Result<mesh::TriMesh> mesh =
        inflateRegion(namedShape("disc").contours, kPicture, roundPuff(std::move(bones)));
    REQUIRE(mesh.ok());
    float top = 0;
    for (const auto& p : mesh.value().positions) top = std::max(top, p[2]);
    return top;
  };
  CHECK(height(edits) == doctest::Approx(2 * height({})).epsilon(0.01));
}

TEST_CASE("edits that find no place sleep and change nothing") {
  BoneEdits edits;
  edits.drop = {{5, 5}};
  edits.add = {{{5, 5}, {200, 200}}, {{200, 200}}, {}};
  edits.move = {{{395, 5}, {200, 200}}};
  edits.heights = {{{5, 395}, 3}};
  for (const NamedShape& shape : namedShapes()) {
    CAPTURE(shape.name);
    std::vector<EditedSkeleton> pieces{edited(shape.name, edits)};
    CHECK(pieces[0].skeleton == skeletonOf(shape.contours).value());
    CHECK(asleep(pieces) == 6);
  }
}

TEST_CASE("random edits of bones leave lawful solids with the handles of their region") {
  int awake = 0, crossing = 0, tried = 0;
  for (const std::uint64_t seed : testing::seeds(1, 40)) {
    CAPTURE(seed);
    Rng rng(seed);
    const NamedShape& shape = namedShapes()[rng.below(namedShapes().size())];
    CAPTURE(shape.name);
    const Skeleton bones = edited(shape.name, {}).skeleton;
    const auto place = [&] {
      const SkeletonPoint& p = bones.points[rng.below(bones.points.size())];
      return picture(p.at + SectionPoint{rng.uniform(-1.5, 1.5), rng.uniform(-1.5, 1.5)} * p.radius);
    };
    BoneEdits edits;
    edits.detail = rng.uniform(0, 1);
    for (std::uint64_t i = rng.below(3); i > 0; --i) edits.drop.push_back(place());
    for (std::uint64_t i = rng.below(3); i > 0; --i) edits.add.push_back({place(), place(), place()});
    for (std::uint64_t i = rng.below(3); i > 0; --i) edits.move.push_back({place(), place()});
    for (std::uint64_t i = rng.below(3); i > 0; --i) edits.heights.push_back({place(), rng.uniform(0.1, 4)});
    REQUIRE(checkEdits(edits).ok());
    const EditedSkeleton made = edited(shape.name, edits);
    CHECK(made.skeleton.rings == bones.rings);
    for (const auto& kind : {made.awake.drop, made.awake.add, made.awake.move, made.awake.heights})
      awake += static_cast<int>(std::ranges::count(kind, 1));
    InflateParams params = roundPuff(edits);
    const Result<mesh::TriMesh> mesh = inflateRegion(shape.contours, kPicture, params);
    REQUIRE(mesh.ok());
    CHECK(requireLawful(mesh.value()).genus == bones.rings);
    crossing += mesh::selfCrossing(mesh.value()) ? 1 : 0;
    ++tried;
  }
  CHECK(10 * awake > 11 * tried);
  // Where all bones of a long arm are gone, its rows are far apart.
  CHECK(10 * crossing <= tried);
}
