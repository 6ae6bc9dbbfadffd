// What of a part hides the sheet of the tool Layers: it is drawn faint.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "tests/unit/web/rig.h"

using namespace spineloft;
using test::Rig;

namespace {

using Plane = std::optional<std::array<float, 4>>;

/// A page with a cylinder of layers, and the tool in hand.
struct Cylinder : Rig {
  Cylinder() : Rig({1200, 700, 1}) {
    REQUIRE(works("new-sketch", R"({"width": 400, "height": 300})"));
    REQUIRE(works("layers"));
    REQUIRE(works("layer-circle"));
  }

  Plane cutAt(double at) {
    REQUIRE(works("layer-sheet", R"({"at": )" + std::to_string(at) + "}"));
    return cut();
  }
  /// Of the only mesh that is drawn.
  Plane cut() {
    app->frame();
    REQUIRE(gl->last.meshes.size() == 1);
    return gl->last.meshes[0].fadeBefore;
  }
  /// How far the eye is before the plane.
  double eyeBefore(const std::array<float, 4>& plane) const {
    const auto& m = gl->last.view.m;
    double far = -plane[3];
    for (std::size_t i = 0; i < 3; ++i)
      far -= plane[i] * (m[4 * i] * m[12] + m[4 * i + 1] * m[13] + m[4 * i + 2] * m[14]);
    return far;
  }
};

/// The share of the mesh's height that is before the plane.
double shareBefore(const gl::SceneMesh& mesh, const std::array<float, 4>& n) {
  double low = 1e30, high = -1e30;
  const auto& m = mesh.toWorld.m;
  for (const auto& p : mesh.mesh->positions) {
    double far = -n[3];
    for (std::size_t i = 0; i < 3; ++i) far += n[i] * (m[i] * p[0] + m[4 + i] * p[1] + m[8 + i] * p[2] + m[12 + i]);
    low = std::min(low, far);
    high = std::max(high, far);
  }
  return high / (high - low);
}

}  // namespace

TEST_CASE("what of a part lies before its sheet, on the side of the eye, is faint") {
  Cylinder rig;
  for (const double at : {0.25, 0.5, 0.75}) {
    CAPTURE(at);
    const Plane above = rig.cutAt(at);
    REQUIRE(above);
    CHECK(std::hypot((*above)[0], (*above)[1], (*above)[2]) == doctest::Approx(1));
    CHECK(rig.eyeBefore(*above) > 0);
    CHECK(shareBefore(rig.gl->last.meshes[0], *above) == doctest::Approx(1 - at).epsilon(1e-3));
  }
  const std::array<float, 4> above = *rig.cutAt(0.5);
  for (int i = 0; i < 12; ++i) REQUIRE(rig.works("turn-up"));
  const Plane below = rig.cut();
  REQUIRE(below);
  CHECK(rig.eyeBefore(*below) > 0);
  for (std::size_t i = 0; i < 4; ++i) CHECK((*below)[i] == -above[i]);
}

TEST_CASE("a sheet at an end of its part or beyond it hides nothing, and neither does one that is not there") {
  Cylinder rig;
  for (const double at : {0.0, 1.0, 1.5}) CHECK_FALSE(rig.cutAt(at));
  REQUIRE(rig.cutAt(0.5));
  REQUIRE(rig.works("draw"));
  CHECK_FALSE(rig.cut());
}

TEST_CASE("while a hand lifts the sheet nothing is faint, so that the solid is not drawn anew; then it is again") {
  Cylinder rig;
  REQUIRE(rig.cutAt(0.5));
  const app::Json sheet = *rig.state().find("sheet");
  const app::Json::Array& knob = *sheet.find("knob")->array();
  const double x = *knob[0].number(), y = *knob[1].number();
  rig.pointer(platform::PointerKind::Down, x, y);
  for (int i = 1; i <= 4; ++i) rig.pointer(platform::PointerKind::Move, x, y - 5 * i);
  rig.settle();
  CHECK_FALSE(rig.cut());
  rig.pointer(platform::PointerKind::Up, x, y - 20);
  rig.settle();
  CHECK(rig.cut());
}

TEST_CASE("small pictures of a model show all of it while its sheet is in its middle") {
  Cylinder rig;
  REQUIRE(rig.cutAt(0.5));
  REQUIRE(rig.app->thumbnail(192, 144).width == 192);
  REQUIRE(rig.gl->last.meshes.size() == 1);
  CHECK_FALSE(rig.gl->last.meshes[0].fadeBefore);
}

TEST_CASE("other parts and the twin of a part stay as they are beside the sheet") {
  Cylinder rig;
  REQUIRE(rig.works("duplicate"));
  REQUIRE(rig.works("symmetry", R"({"axis": "x"})"));
  REQUIRE(rig.works("layer-sheet", R"({"at": 0.5})"));
  rig.app->frame();
  const auto& meshes = rig.gl->last.meshes;
  REQUIRE(meshes.size() == 3);
  CHECK(std::ranges::count_if(meshes, [](const gl::SceneMesh& mesh) { return mesh.fadeBefore.has_value(); }) == 1);
}

TEST_CASE("the part stays faint before the sheet while a line is drawn on it") {
  Cylinder rig;
  REQUIRE_FALSE(rig.cutAt(1));
  REQUIRE(rig.works("layer-circle"));
  const Plane before = rig.cutAt(0.5);
  REQUIRE(before);
  const app::Json state = rig.state();
  const auto corner = [&](std::size_t i) {
    const app::Json::Array& p = *(*state.find("sheet")->find("corners")->array())[i].array();
    return app::ClientPoint{*p[0].number(), *p[1].number()};
  };
  // From corner to corner, a fifth of the way in.
  const app::ClientPoint middle = (corner(0) + corner(1) + corner(2) + corner(3)) / 4;
  const auto inner = [&](std::size_t i) { return middle + (corner(i) - middle) * 0.8; };
  rig.pointer(platform::PointerKind::Down, inner(0).x, inner(0).y);
  for (std::size_t i = 1; i < 4; ++i) {
    for (int step = 1; step <= 20; ++step) {
      const app::ClientPoint at = inner(i - 1) + (inner(i) - inner(i - 1)) * (step / 20.0);
      rig.pointer(platform::PointerKind::Move, at.x, at.y);
    }
    rig.settle();
  }
  const gl::MeshKey key = rig.gl->last.meshes[0].key;
  CHECK(rig.cut() == before);
  rig.pointer(platform::PointerKind::Up, inner(3).x, inner(3).y);
  rig.settle();
  CHECK(rig.cut() == before);
  CHECK(rig.gl->last.meshes[0].key != key);  // another shape was drawn meanwhile
}
