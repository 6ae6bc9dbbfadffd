// What comes from the solver of solids: arrays of any quality → a solid, and what of it is shown.
#include <doctest/doctest.h>

#include <limits>
#include <vector>

#include "engine/document/update.h"
#include "engine/mesh/laws.h"
#include "engine/pipeline/derive.h"
#include "engine/pipeline/solid.h"
#include "tests/support/generators.h"
#include "tests/support/mesh_laws.h"
#include "tests/support/random_documents.h"

using namespace spineloft;
using namespace spineloft::document;
using namespace spineloft::pipeline;
using namespace spineloft::testing;

namespace {

/// A box as a solver hands it over: the half from part 2 has vertices of its own, merged with those of part 1.
struct Boxed {
  std::vector<float> positions, uv;
  std::vector<std::uint32_t> corners, from, to;
  std::vector<SolidArrays::Run> runs;

  Boxed() {
    const mesh::TriMesh plain = box(1, 1, 1);
    const auto vertices = static_cast<std::uint32_t>(plain.positions.size());
    for (int copy = 0; copy < 2; ++copy) {
      for (const auto& p : plain.positions) {
        positions.insert(positions.end(), {p[0], p[1], p[2]});
        uv.insert(uv.end(), {0.5f, copy ? 0.25f : 0.75f});
      }
    }
    const std::size_t half = plain.triangles.size() / 2;
    for (std::size_t t = 0; t < plain.triangles.size(); ++t) {
      for (const std::uint32_t v : plain.triangles[t]) corners.push_back(t < half ? v : v + vertices);
    }
    for (std::uint32_t v = 0; v < vertices; ++v) {
      from.push_back(v + vertices);
      to.push_back(v);
    }
    runs = {{PartId{1}, 0, half}, {PartId{2}, half, plain.triangles.size() - half}};
  }
  SolidArrays arrays() const { return {positions, uv, corners, from, to, runs}; }
};

Document twoJoined() {
  Document document = update({}, AddPicture{"cat", ellipsePicture(96, 72)}).value();
  for (int i = 0; i < 3; ++i) {
    document = update(document, DrawSpine{PictureId{1}, {{20, 36}, {48, 36}, {76, 36}}}).value();
  }
  CombineParts join;
  join.operands = {{PartId{1}, {}}, {PartId{2}, {}}};
  return update(document, join).value();
}

}  // namespace

TEST_CASE("vertices that stand at one place close the solid; its pieces keep their own places in the picture") {
  const Result<Solid> made = solidFrom(Boxed().arrays());
  REQUIRE(made.ok());
  const Solid& solid = made.value();
  requireLawful(solid.mesh);
  CHECK(solid.mesh.positions.size() == 8);
  CHECK(solid.mesh.triangles.size() == 12);
  REQUIRE(solid.pieces.size() == 2);
  CHECK(solid.pieces[0].part == PartId{1});
  CHECK(solid.pieces[1].part == PartId{2});
  std::size_t triangles = 0;
  for (const SolidPiece& piece : solid.pieces) {
    triangles += piece.mesh.triangles.size();
    REQUIRE(piece.mesh.uv.size() == piece.mesh.positions.size());
    for (const auto& uv : piece.mesh.uv) CHECK(uv[1] == (piece.part == PartId{1} ? 0.75f : 0.25f));
  }
  CHECK(triangles == 12);
  CHECK(bytesOf(solid) > 8 * 12);
}

TEST_CASE("runs of one part that lie apart are one piece, chains of merged vertices end where they end") {
  Boxed boxed;
  boxed.runs = {{PartId{1}, 0, 3}, {PartId{2}, 3, 6}, {PartId{1}, 9, 3}, {PartId{3}, 12, 0}};
  boxed.from.push_back(0);
  boxed.to.push_back(0);
  const Result<Solid> made = solidFrom(boxed.arrays());
  REQUIRE(made.ok());
  REQUIRE(made.value().pieces.size() == 2);
  CHECK(made.value().pieces[0].mesh.triangles.size() == 6);
}

TEST_CASE("arrays that do not fit together are refused") {
  const auto refused = [](auto&& damage) {
    Boxed boxed;
    damage(boxed);
    const Result<Solid> made = solidFrom(boxed.arrays());
    CHECK_FALSE(made.ok());
    if (!made.ok()) CHECK(made.error() == Error::MeshInvalid);
  };
  refused([](Boxed& b) { b.positions.pop_back(); });
  refused([](Boxed& b) { b.uv.pop_back(); });
  refused([](Boxed& b) { b.corners.pop_back(); });
  refused([](Boxed& b) {
    b.corners.clear();
    b.runs.clear();
  });
  refused([](Boxed& b) { b.corners[4] = 16; });
  refused([](Boxed& b) { b.from.pop_back(); });
  refused([](Boxed& b) { b.from[0] = 99; });
  refused([](Boxed& b) { b.to[0] = 99; });
  refused([](Boxed& b) { b.positions[3] = std::numeric_limits<float>::quiet_NaN(); });
  refused([](Boxed& b) { b.uv[3] = std::numeric_limits<float>::infinity(); });
  refused([](Boxed& b) { b.runs[1].count += 1; });
  refused([](Boxed& b) { b.runs[1].first = std::numeric_limits<std::size_t>::max(); });
}

TEST_CASE("parts stand for their solid until it is there, and hide and show with it") {
  Document document = twoJoined();
  Cache cache;
  Derived derived = deriveWithEdges(document, cache, {}).value();
  const auto shown = [&](std::size_t i) { return showsItself(document, derived, document.parts[i]); };
  CHECK((shown(0) && shown(1) && shown(2)));
  CHECK(shownSolid(document, derived, document.steps[0]) == nullptr);

  const auto solid = std::make_shared<const Solid>(solidFrom(Boxed().arrays()).value());
  DerivedStep step;
  step.id = StepId{1};
  step.solid = solid;
  derived.steps = {step};
  CHECK_FALSE(shown(0));
  CHECK_FALSE(shown(1));
  CHECK(shown(2));
  CHECK(solidOf(document, derived, PartId{2}) == &derived.steps[0]);
  CHECK(solidOf(document, derived, PartId{3}) == nullptr);
  CHECK(shownSolid(document, derived, document.steps[0]) == &derived.steps[0]);

  document = update(document, ShowStep{StepId{1}, false}).value();
  CHECK(shownSolid(document, derived, document.steps[0]) == nullptr);
  CHECK_FALSE(shown(0));
  derived.steps.clear();
  CHECK_FALSE(shown(0));  // hidden is hidden, solved or not
  CHECK(shown(2));
}
