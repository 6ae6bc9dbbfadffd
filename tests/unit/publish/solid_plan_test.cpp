// What the solver of solids is asked: every part where it stands, and keys that change when the solid does.
#include <doctest/doctest.h>

#include <cmath>
#include <cstdlib>
#include <functional>
#include <string>
#include <vector>

#include "engine/base/rng.h"
#include "engine/document/update.h"
#include "engine/pipeline/world.h"
#include "engine/publish/solid_plan.h"
#include "tests/support/mesh_laws.h"
#include "tests/support/random_documents.h"
#include "tests/support/rounds.h"
#include "tests/support/step_documents.h"

using namespace spineloft;
using namespace spineloft::document;
using namespace spineloft::testing;
using publish::SolidPlan;

namespace {

constexpr image::Size kSize{96, 72};

Document withParts(std::uint32_t count) {
  Document document = update({}, AddPicture{"cat", ellipsePicture(96, 72)}).value();
  for (std::uint32_t i = 0; i < count; ++i) {
    const double y = 30 + 6.0 * i;
    document = update(document, DrawSpine{PictureId{1}, {{20, y}, {48, y}, {76, y}}}).value();
  }
  return document;
}

/// Derives with one cache for all, as the page does: what did not change is the same shape.
class Deriving {
 public:
  const pipeline::Derived& operator()(const Document& document) {
    last_ = pipeline::deriveWithEdges(document, cache_, {}).value();
    return last_;
  }

 private:
  pipeline::Cache cache_;
  pipeline::Derived last_;
};

WorldPoint applied(const std::array<double, 16>& m, const std::array<float, 3>& p) {
  const auto row = [&](std::size_t k) { return m[k] * p[0] + m[4 + k] * p[1] + m[8 + k] * p[2] + m[12 + k]; };
  return {row(0), row(1), row(2)};
}

const SolidPlan::Node& rootNode(const SolidPlan& plan, std::size_t i = 0) {
  REQUIRE(i < plan.roots.size());
  return plan.nodes[plan.roots[i]];
}

/// As the document says it, by no way that the plan takes.
WorldPoint standing(const Part& part, bool twin, const std::array<float, 3>& p) {
  const WorldPoint at = part.placement(pipeline::worldFrame(kSize).toWorld({p[0], p[1], p[2]}));
  return twin ? (*part.mirror)(at) : at;
}

}  // namespace

TEST_CASE("a solid is asked for with every part where it stands, also when it is turned, mirrored or doubled") {
  Rng rng(41);
  Deriving derive;
  const Document base = after(withParts(3), combine(StepKind::Join, {part(1), part(2), part(3)}));
  for (int round = 0; round < testing::rounds(20); ++round) {
    PlaceParts places;
    std::size_t expected = 3;
    for (std::uint32_t i = 1; i <= 3; ++i) {
      PlaceParts::One one{PartId{i}, randomPlacement(rng), {}};
      if (rng.uniform(0, 1) < 0.5) {
        const WorldPoint way{rng.uniform(-1, 1), rng.uniform(-1, 1), rng.uniform(0.1, 1)};
        one.mirror = MirrorPlane{{rng.uniform(-1, 1), 0.2, -0.1}, normalized(way)};
        ++expected;
      }
      places.parts.push_back(one);
    }
    const Document document = after(base, places);
    const pipeline::Derived& derived = derive(document);
    const SolidPlan plan = publish::planSolids(document, derived);
    const SolidPlan::Node& node = rootNode(plan);
    REQUIRE(node.operands.size() == expected);
    PartId last;
    for (const SolidPlan::Operand& operand : node.operands) {
      REQUIRE_FALSE(operand.node.has_value());
      const Part* placed = findPart(document, operand.part);
      const bool twin = operand.part == last;
      last = operand.part;
      const mesh::TriMesh& mesh = *plan.meshes[operand.mesh].mesh;
      requireLawful(mesh);
      double worst = 0;
      for (const auto& p : mesh.positions) {
        worst = std::max(worst, distance(applied(operand.toWorld, p), standing(*placed, twin, p)));
      }
      CHECK(worst < 1e-9);
    }
  }
}

TEST_CASE("the key of a solid changes when what it is made from changes, and not otherwise") {
  Deriving derive;
  const Document base = after(withParts(3), combine(StepKind::Join, {part(1), part(2)}));
  const auto keyOf = [&](const Document& document) {
    return rootNode(publish::planSolids(document, derive(document))).key;
  };
  const SolidKey key = keyOf(base);
  Placement moved;
  moved.move = {0.1, 0, 0};
  Look red;
  red.textured = false;
  red.colour = {200, 10, 10};
  const std::vector<std::pair<const char*, Action>> nothing = {
      {"a name of a part", RenamePart{PartId{1}, "Ear"}},
      {"a name of the solid", RenameStep{StepId{1}, "Head"}},
      {"a hidden part", ShowPart{PartId{1}, false}},
      {"the hidden solid", ShowStep{StepId{1}, false}},
      {"a colour of a part", SetLook{PartId{2}, red}},
      {"a colour of the solid", SetStepLook{StepId{1}, true, red}},
      {"another size", SetHeight{Millimetres{77}}},
      {"a part that is not in it, moved", PlaceParts{{{PartId{3}, moved, {}}}}},
      {"a part that is not in it, gone", DeletePart{PartId{3}}},
      {"one part more", DrawSpine{PictureId{1}, {{30, 20}, {48, 22}, {66, 20}}}},
      {"a group", GroupParts{{PartId{1}, PartId{2}}, "Pair"}},
      {"the wall, which only hollows have", SetStep{StepId{1}, StepKind::Join, 0, 0.1, {}}}};
  for (const auto& [what, action] : nothing) CHECK_MESSAGE(keyOf(after(base, action)) == key, what);
  const std::vector<std::pair<const char*, Action>> something = {
      {"a part of it, moved", PlaceParts{{{PartId{1}, moved, {}}}}},
      {"a part of it, doubled", PlaceParts{{{PartId{1}, {}, MirrorPlane{}}}}},
      {"a part of it with another slice", SetSection{PartId{1}, sections::SectionPreset::Square}},
      {"a part of it drawn again", RedrawSpine{PartId{2}, {{24, 40}, {48, 36}, {70, 40}}}},
      {"round seams", SetStep{StepId{1}, StepKind::Join, 0.02, 0.02, {}}},
      {"another kind", SetStep{StepId{1}, StepKind::Cut, 0, 0.02, {}}},
      {"a hollow instead", combine(StepKind::Hollow, {step(1)})}};
  for (const auto& [what, action] : something) CHECK_MESSAGE(keyOf(after(base, action)) != key, what);
  // And back again is the same solid.
  const Document there = after(base, PlaceParts{{{PartId{1}, moved, {}}}});
  CHECK(keyOf(after(there, PlaceParts{{{PartId{1}, {}, {}}}})) == key);
}

TEST_CASE("solids within solids come first, keep their keys while they stay as they are, and are no roots") {
  Deriving derive;
  Document document = after(withParts(3), combine(StepKind::Join, {part(1), part(2)}));
  document = after(document, combine(StepKind::Cut, {step(1), part(3)}));
  document = after(document, combine(StepKind::Hollow, {step(2)}));
  const SolidPlan plan = publish::planSolids(document, derive(document));
  REQUIRE(plan.nodes.size() == 3);
  REQUIRE(plan.roots == std::vector<std::size_t>{2});
  for (std::size_t i = 0; i < plan.nodes.size(); ++i) {
    CHECK(plan.nodes[i].step == StepId{static_cast<std::uint32_t>(i + 1)});
    for (const SolidPlan::Operand& operand : plan.nodes[i].operands) {
      if (operand.node) CHECK(*operand.node < i);
    }
  }
  Placement moved;
  moved.move = {0, 0, 0.2};
  const Document later = after(document, PlaceParts{{{PartId{3}, moved, {}}}});
  const SolidPlan next = publish::planSolids(later, derive(later));
  CHECK(next.nodes[0].key == plan.nodes[0].key);
  CHECK(next.nodes[1].key != plan.nodes[1].key);
  CHECK(next.nodes[2].key != plan.nodes[2].key);
}

TEST_CASE("a part and its twin are one thing to cut with") {
  Deriving derive;
  Document document = after(withParts(2), combine(StepKind::Cut, {part(1), part(2)}));
  document = after(document, PlaceParts{{{PartId{2}, {}, MirrorPlane{}}}});
  const SolidPlan plan = publish::planSolids(document, derive(document));
  const SolidPlan::Node& cut = rootNode(plan);
  REQUIRE(cut.operands.size() == 2);
  REQUIRE(cut.operands[1].node.has_value());
  const SolidPlan::Node& twins = plan.nodes[*cut.operands[1].node];
  CHECK(twins.kind == StepKind::Join);
  CHECK(twins.operands.size() == 2);
  CHECK(twins.operands[0].part == twins.operands[1].part);
}

TEST_CASE("what was tapped opens the side that faces there most, an end of the bone before a side no better") {
  Rng rng(43);
  Deriving derive;
  const Document base = after(withParts(1), combine(StepKind::Hollow, {part(1)}));
  int ends = 0;
  for (int round = 0; round < testing::rounds(60); ++round) {
    const Document document = after(base, PlaceParts{{{PartId{1}, randomPlacement(rng), {}}}});
    const WorldPoint towards{rng.uniform(-1, 1), rng.uniform(-1, 1), rng.uniform(-1, 1)};
    const Step& hollow = *findStep(document, StepId{1});
    const OpeningSide chosen = publish::sideFacing(document, derive(document), hollow, towards);
    const auto faces = [&](OpeningSide side) {
      const Document open = after(document, SetStep{StepId{1}, StepKind::Hollow, 0, 0.02, {side, 0}});
      const std::array<double, 3> way = rootNode(publish::planSolids(open, derive(open))).opening.value();
      return way[0] * towards.x + way[1] * towards.y + way[2] * towards.z;
    };
    const bool end = chosen == OpeningSide::Start || chosen == OpeningSide::End;
    const double most = faces(chosen), slack = 0.05 * norm(towards) + 1e-9;
    for (int i = static_cast<int>(OpeningSide::Start); i < static_cast<int>(OpeningSide::kCount); ++i) {
      const auto side = static_cast<OpeningSide>(i);
      CHECK(faces(side) <= most + (end ? slack : 1e-9));
    }
    CHECK((end || std::max(faces(OpeningSide::Start), faces(OpeningSide::End)) < most));
    ends += end;
  }
  CHECK(ends > 5);
  CHECK(ends < testing::rounds(55));
  const Step& hollow = *findStep(base, StepId{1});
  CHECK(publish::sideFacing(base, derive(base), hollow, {}) == OpeningSide::Up);
}

TEST_CASE("a solid with a part that has no shape is not asked for, the others are") {
  Deriving derive;
  Document document = after(withParts(4), combine(StepKind::Join, {part(1), part(2)}));
  document = after(document, combine(StepKind::Join, {part(3), part(4)}));
  pipeline::Derived derived = derive(document);
  derived.parts[1].shape = nullptr;
  const SolidPlan plan = publish::planSolids(document, derived);
  REQUIRE(plan.roots.size() == 1);
  CHECK(rootNode(plan).step == StepId{2});
  CHECK(plan.meshes.size() == 2);
  // A part that is deleted leaves a solid of one, which is none.
  const Document fewer = after(document, DeletePart{PartId{2}});
  CHECK(publish::planSolids(fewer, derive(fewer)).roots.size() == 1);
}

TEST_CASE("a part in hand stands in for its own mesh, and nothing else changes") {
  Deriving derive;
  const Document document = after(withParts(2), combine(StepKind::Join, {part(1), part(2)}));
  const pipeline::Derived& derived = derive(document);
  const SolidPlan plain = publish::planSolids(document, derived);
  mesh::TriMesh other = *plain.meshes[0].mesh;
  const publish::Substitute instead{PartId{1}, ShapeKey{77}, &other};
  const SolidPlan plan = publish::planSolids(document, derived, &instead);
  CHECK(rootNode(plan).key != rootNode(plain).key);
  REQUIRE(plan.meshes.size() == 2);
  CHECK(plan.meshes[0].mesh == &other);
  CHECK(plan.meshes[0].key == ShapeKey{77});
  CHECK(plan.meshes[1].key == plain.meshes[1].key);
  CHECK(rootNode(plan).operands[0].toWorld == rootNode(plain).operands[0].toWorld);
}
