// Parts in hand: the gizmo, the motions it makes, and the commands about places.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <tuple>

#include "engine/document/update.h"
#include "tests/support/random_documents.h"
#include "tests/unit/web/rig.h"
#include "web/edit/gizmo.h"
#include "web/edit/picker.h"
#include "web/edit/placing.h"

using namespace spineloft;
using namespace spineloft::app;
using spineloft::test::Rig;

namespace {

UiState uiWith(double yaw, double pitch) {
  UiState ui;
  ui.layout.solid = {600, 50, 500, 460};
  ui.camera.yaw = yaw;
  ui.camera.pitch = pitch;
  ui.camera.distance = 2;
  return ui;
}

std::optional<ClientPoint> knobOf(const Gizmo& gizmo, GizmoHandle handle) {
  for (const Gizmo::Knob& knob : gizmo.knobs) {
    if (knob.handle == handle) return knob.at;
  }
  return std::nullopt;
}

/// A page with the bar as one part, in the mode of moving.
struct Placed : Rig {
  Placed() {
    openBar();
    drawBar();
    run("move");
    settle();
  }
  Json part(std::size_t i = 0) { return (*state().find("parts")->array())[i]; }
  std::vector<double> move(std::size_t i = 0) {
    std::vector<double> out;
    const Json one = part(i);
    for (const Json& n : *one.find("placement")->find("move")->array()) out.push_back(*n.number());
    return out;
  }
  ClientPoint knob(std::string_view name) {
    const Json all = state();
    for (const Json& one : *all.find("gizmo")->find("knobs")->array()) {
      if (*one.text("handle") != name) continue;
      const auto& at = *one.find("at")->array();
      return {*at[0].number(), *at[1].number()};
    }
    FAIL("no knob " << name);
    return {};
  }
  void drag(ClientPoint from, ClientPoint by, bool lifts = true) {
    using platform::PointerKind;
    pointer(PointerKind::Move, from.x, from.y);
    pointer(PointerKind::Down, from.x, from.y);
    for (int i = 1; i <= 10; ++i) {
      pointer(PointerKind::Move, from.x + by.x * i / 10, from.y + by.y * i / 10);
    }
    if (lifts) pointer(PointerKind::Up, from.x + by.x, from.y + by.y);
    settle();
  }
};

}  // namespace

TEST_CASE("the handles of the gizmo are far enough apart for fingers, from wherever one looks") {
  for (double yaw = -3; yaw <= 3; yaw += 0.37) {
    for (double pitch = -1.2; pitch <= 1.2; pitch += 0.3) {
      UiState ui = uiWith(yaw, pitch);
      ui.touch = true;
      const std::optional<Gizmo> gizmo = gizmoAt(ui, {0, 0, 0});
      REQUIRE(gizmo);
      // Every handle is what is found at its own place.
      for (const Gizmo::Knob& knob : gizmo->knobs) {
        CHECK(handleAt(*gizmo, knob.at, true) == knob.handle);
        CHECK(handleAt(*gizmo, knob.at, false) == knob.handle);
      }
      CHECK(handleAt(*gizmo, gizmo->at + ClientPoint{gizmo->radius * 2.2, 0}, true) == GizmoHandle::None);
      // At most one arrow points at the eye.
      CHECK(gizmo->knobs.size() >= 8);
    }
  }
}

TEST_CASE("an arrow moves along its axis under the pointer, a body with the pointer, depth to the eye") {
  const UiState ui = uiWith(0.5, 0.2);
  const Gizmo gizmo = *gizmoAt(ui, {0.1, 0.05, 0});
  GizmoDrag drag{gizmo, ui.camera, ui.layout.solid, GizmoHandle::MoveX, {}};
  drag.from = *knobOf(gizmo, GizmoHandle::MoveX);
  const ClientPoint way = (drag.from - gizmo.at) * 0.5;
  document::Motion motion = motionOf(drag, drag.from + way, false);
  CHECK(motion.move.x > 0);
  CHECK(motion.move.y == 0);
  CHECK(motion.move.z == 0);
  drag.handle = GizmoHandle::Plane;
  motion = motionOf(drag, drag.from + ClientPoint{40, -25}, false);
  const auto to = pointOnCanvas(ui.camera, ui.layout.solid, gizmo.centre + motion.move);
  REQUIRE(to);
  CHECK(distance(*to, gizmo.at + ClientPoint{40, -25}) < 1e-6);
  drag.handle = GizmoHandle::Depth;
  motion = motionOf(drag, drag.from + ClientPoint{0, 30}, false);
  CHECK(distance(normalized(motion.move), ui.camera.back()) < 1e-9);
  drag.handle = GizmoHandle::Scale;
  drag.from = *knobOf(gizmo, GizmoHandle::Scale);
  motion = motionOf(drag, gizmo.at + (drag.from - gizmo.at) * 2, false);
  CHECK(motion.scale == doctest::Approx(2));
}

TEST_CASE("a ring turns about its axis as far as the pointer goes round it, in steps of 15 degrees if asked") {
  const UiState ui = uiWith(0, 0);
  const Gizmo gizmo = *gizmoAt(ui, {0, 0, 0});
  const GizmoDrag drag{gizmo, ui.camera, ui.layout.solid, GizmoHandle::TurnZ, gizmo.at + ClientPoint{gizmo.radius, 0}};
  // A quarter round, against the clock: from the right to the top.
  const document::Motion quarter = motionOf(drag, gizmo.at + ClientPoint{0, -gizmo.radius}, false);
  CHECK(distance(geometry::turned(quarter.turn, WorldPoint{1, 0, 0}), WorldPoint{0, 1, 0}) < 1e-6);
  const double angle = 0.33;  // 19 degrees
  const ClientPoint at = gizmo.at + ClientPoint{std::cos(angle), -std::sin(angle)} * gizmo.radius;
  const document::Motion steps = motionOf(drag, at, true);
  CHECK(geometry::anglesOf(steps.turn).roll == doctest::Approx(15 * 3.14159265358979 / 180));
  // Two fingers that turn with the clock on the screen turn the part with the clock.
  const document::Motion pair = pairMotion(drag, {0, 0}, 0.5, 1.25);
  CHECK(geometry::anglesOf(pair.turn).roll == doctest::Approx(-0.5));
  CHECK(pair.scale == 1.25);
}

TEST_CASE("dragging an arrow moves the part in one step, with the solid following, and Esc takes it back") {
  Placed page;
  const double undo = *page.state().number("undo");
  const ClientPoint from = page.knob("x");
  page.drag(from, {30, 0}, false);
  CHECK(*page.state().number("undo") == undo);
  CHECK(page.app->ui().placing.size() == 1);
  page.key("Escape", "Escape");
  CHECK(page.app->ui().placing.empty());
  page.pointer(platform::PointerKind::Up, from.x + 30, from.y);
  page.settle();
  CHECK(page.move() == std::vector<double>{0, 0, 0});
  page.drag(page.knob("x"), {30, 0});
  CHECK(page.move()[0] > 0);
  CHECK(page.move()[1] == 0);
  CHECK(*page.state().number("undo") == undo + 1);
  page.run("undo");
  CHECK(page.move() == std::vector<double>{0, 0, 0});
}

TEST_CASE("the ring turns, the lower right knob scales, the middle moves in the plane of the view: one step each") {
  Placed page;
  page.run("home-view");
  page.settle();
  const auto placement = [&](const char* key, std::size_t i) {
    return *page.part().find("placement")->find(key)->array()->at(i).number();
  };
  const double undo = *page.state().number("undo");
  page.drag(page.knob("turn-y"), {90, 24});
  CHECK(std::abs(placement("degrees", 1)) > 5);
  page.drag(page.knob("scale"), {60, 60});
  CHECK(*page.part().find("placement")->number("scale") > 1.2);
  const std::vector<double> before = page.move();
  page.drag(page.knob("plane"), {-50, 20});
  CHECK(page.move()[0] < before[0] - 0.02);
  CHECK(*page.state().number("undo") == undo + 3);
  for (int i = 0; i < 3; ++i) page.run("undo");
  CHECK(placement("turn", 0) == 1);
  CHECK(page.move() == std::vector<double>{0, 0, 0});
}

TEST_CASE("arrow keys move by a millimetre, with shift by ten, and keys pressed in a row are one step") {
  Placed page;
  page.run("home-view");
  page.settle();
  const double undo = *page.state().number("undo");
  CHECK(page.key("ArrowUp", "ArrowUp"));
  CHECK(page.key("ArrowUp", "ArrowUp", platform::kShift));
  const double mm = *page.part().find("placement")->find("mm")->array()->at(1).number();
  CHECK(mm == doctest::Approx(11).epsilon(0.001));
  CHECK(*page.state().number("undo") == undo + 1);
  page.run("undo");
  CHECK(page.move()[1] == 0);
}

TEST_CASE("typed millimetres, degrees and percents read back as typed, whatever moved before") {
  Placed page;
  page.run("set-place", R"({"turn": 30, "tip": -20, "lean": 10})");
  page.run("set-place", R"({"size": 150})");
  page.run("set-place", R"({"x": 12.5, "y": -3, "z": 40})");
  const Json placement = *page.part().find("placement");
  const auto& mm = *placement.find("mm")->array();
  CHECK(*mm[0].number() == doctest::Approx(12.5).epsilon(0.001));
  CHECK(*mm[1].number() == doctest::Approx(-3).epsilon(0.001));
  CHECK(*mm[2].number() == doctest::Approx(40).epsilon(0.001));
  const auto& degrees = *placement.find("degrees")->array();
  CHECK(*degrees[0].number() == doctest::Approx(-20));
  CHECK(*degrees[1].number() == doctest::Approx(30));
  CHECK(*degrees[2].number() == doctest::Approx(10));
  CHECK(*placement.number("scale") == doctest::Approx(1.5));
  page.run("face-front");
  CHECK(*page.part().find("placement")->find("degrees")->array()->at(1).number() == doctest::Approx(0));
}

TEST_CASE("a part that moves up keeps its size in millimetres: the model grows") {
  Placed page;
  page.run("duplicate");
  page.settle();
  const double before = *page.state().number("heightMm");
  page.run("set-place", R"({"y": 25})");
  CHECK(*page.state().number("heightMm") == doctest::Approx(before + 25).epsilon(0.001));
  page.run("drop-on-floor");
  CHECK(*page.state().number("heightMm") == doctest::Approx(before).epsilon(0.001));
}

TEST_CASE(
    "a copy is in sight: to the right as it is seen, to the left where only there is room, else the view follows") {
  for (double yaw = -3; yaw <= 3; yaw += 1.5) {
    for (const double aside : {-1., 0., 1.}) {
      for (const bool near : {false, true}) {
        Placed page;
        UiState& ui = const_cast<UiState&>(page.app->ui());
        Camera& camera = ui.camera;
        ui.cameraTouched = true;
        camera.yaw = yaw;
        camera.pitch = 0;
        const std::vector<double> from = page.move(0);
        // The bar at one edge of the view, or so near that it fills the view.
        camera.distance = near ? 0.6 : 4;
        camera.target = {};
        const pipeline::WorldBounds box{{-0.12, -0.38, -0.12}, {0.12, 0.38, 0.12}};
        Camera next = camera;
        while (aside != 0 && isInSight(next, ui.layout.solid, box)) {
          camera = next;
          next.target = next.target - camera.right() * (0.005 * aside);
        }
        const Camera before = camera;
        page.run("duplicate");
        page.settle();
        const std::vector<double> to = page.move(1);
        const WorldPoint by{to[0] - from[0], to[1] - from[1], to[2] - from[2]};
        const double right = dot(by, before.right());
        CAPTURE(yaw);
        CAPTURE(aside);
        CHECK(std::abs(right) > 0.02);
        if (!near) CHECK((right > 0) == (aside < 1));
        if (!near) CHECK(camera == before);
        const Json state = page.state();
        for (const double side : {-0.5, 0.5}) {
          const auto at = pointOnCanvas(camera, ui.layout.solid, by + WorldPoint{0, side * 0.6, 0});
          REQUIRE(at);
          CHECK(ui.layout.solid.contains(*at));
        }
      }
    }
  }
}

TEST_CASE("what faces the front again is turned by nothing at all, and so is what was turned along with it") {
  Placed page;
  page.run("duplicate");
  page.run("select-all");
  page.run("group");
  for (int round = 0; round < 3; ++round) {
    for (const char* angles :
         {R"({"degrees": [-35, 120, 0]})", R"({"degrees": [20, -75, 160]})", R"({"degrees": [7, 11, 13]})"}) {
      page.run("move-parts", angles);
    }
    page.run(round % 2 == 0 ? "turn-left" : "turn-up");  // from wherever it is seen
    page.settle();
    CHECK(*page.part().find("placement")->find("turn")->array()->at(0).number() < 0.999);
    page.run("face-front");
    page.settle();
    for (const std::size_t i : {0u, 1u}) {
      const Json turn = *page.part(i).find("placement")->find("turn");
      CHECK(turn == Json(Json::Array{1, 0, 0, 0}));
    }
    const Json again = page.run("face-front");
    REQUIRE(again.text("error") != nullptr);
    CHECK(*again.text("error") == "NotNow");
  }
}

TEST_CASE("copies, mirrored copies, symmetry and groups are commands of one step each") {
  Placed page;
  page.run("duplicate");
  page.settle();
  CHECK(page.parts() == 2);
  CHECK(*page.state().number("selection") == 2);
  page.run("mirror-copy", R"({"axis": "z"})");
  CHECK(page.parts() == 3);
  CHECK(*page.part(2).find("placement")->flag("mirrored"));
  page.run("symmetry", R"({"axis": "x"})");
  CHECK(page.part(2).find("mirror")->array() != nullptr);
  CHECK(*page.run("group").text("error") == "NotNow");
  page.run("select-all");
  page.run("group", R"({"name": "All"})");
  CHECK(page.state().find("groups")->array()->size() == 1);
  // Whoever takes one takes all.
  page.run("select-part", R"({"id": 1})");
  CHECK(page.state().find("selected")->array()->size() == 3);
  page.run("move-parts", R"({"mm": [5, 0, 0]})");
  CHECK(page.move(0)[0] != 0);
  page.run("ungroup");
  CHECK(page.state().find("groups")->array()->empty());
  page.run("select-part", R"({"id": 1})");
  page.run("select-part", R"({"id": 3, "add": true})");
  CHECK(page.state().find("selected")->array()->size() == 2);
  page.run("delete-part");
  CHECK(page.parts() == 1);
  page.run("undo");
  CHECK(page.parts() == 3);
}

TEST_CASE("a part that settles touches the surface under the pointer, and nothing of it is below its tangent plane") {
  document::Document document =
      document::update({}, document::AddPicture{"bar", std::make_shared<image::Picture>(test::barPicture())}).value();
  for (int i = 0; i < 2; ++i) {
    document = document::update(document, document::DrawSpine{PictureId{1}, {{100, 40}, {100, 160}}}).value();
  }
  pipeline::Cache cache;
  const pipeline::Derived derived = pipeline::deriveWithEdges(document, cache, {}).value();
  const mesh::TriMesh& shape = derived.parts[0].shape->mesh;
  UiState ui = uiWith(0.4, 0.3);
  Picker picker;
  Rng rng(5);
  const PartId moving[] = {PartId{2}};
  int settled = 0;
  for (int i = 0; i < 60; ++i) {
    // The first part stands still, the second anywhere, turned anyhow.
    document::Placement placement = testing::randomPlacement(rng);
    document = document::update(document, document::PlaceParts{{{PartId{2}, placement, {}}}}).value();
    const auto still = *pipeline::copiesInWorld(*document.parts[0], {200, 200}).begin();
    const auto count = static_cast<std::uint32_t>(shape.positions.size());
    const auto seen = pointOnCanvas(ui.camera, ui.layout.solid, still(shape.positions[rng.below(count)]));
    REQUIRE(seen);
    const ClientPoint at = *seen + ClientPoint{rng.uniform(-3, 3), rng.uniform(-3, 3)};
    const Ray ray{ui.camera.eye(), rayThrough(ui.camera, ui.layout.solid, at)};
    const RayHit hit = picker.firstHit(document, derived, ui, ray, moving);
    if (!hit) continue;
    ++settled;
    CHECK(hit.part == PartId{1});
    const auto motion = settleOn(document, derived, moving, hit.at, hit.normal);
    REQUIRE(motion);
    const auto moved = movedParts(document, derived, moving, *motion);
    const auto toWorld = *pipeline::copiesInWorld(moved[0].placement, {}, {200, 200}).begin();
    double lowest = std::numeric_limits<double>::infinity(), nearest = lowest;
    for (const auto& p : derived.parts[1].shape->mesh.positions) {
      const WorldPoint w = toWorld(p);
      lowest = std::min(lowest, dot(w - hit.at, hit.normal));
      nearest = std::min(nearest, distance(w, hit.at));
    }
    CHECK(std::abs(lowest) < 1e-9);
    CHECK(nearest < 1e-9);
    // The place is on the surface: in the plane of a triangle and within it.
    const auto own = *pipeline::copiesInWorld(*document.parts[0], {200, 200}).begin();
    bool within = false;
    for (const auto& [a, b, c] : shape.triangles) {
      const WorldPoint pa = own(shape.positions[a]), pb = own(shape.positions[b]), pc = own(shape.positions[c]);
      const WorldPoint n = cross(pb - pa, pc - pa);
      const double area = norm(n);
      if (area < 1e-12 || std::abs(dot(hit.at - pa, n)) / area > 1e-6) continue;
      const auto side = [&](WorldPoint p, WorldPoint q) {
        return dot(cross(q - p, hit.at - p), n) / (area * area) > -1e-6;
      };
      within = within || (side(pa, pb) && side(pb, pc) && side(pc, pa));
    }
    CHECK(within);
  }
  CHECK(settled > 10);
}

TEST_CASE("an ear of a head drawn by hand has its twin left or right, a wing of a bird seen from the side behind it") {
  // What the thing is like, a part of it as drawn, and where the twin is to be.
  using Line = std::vector<PicturePoint>;
  Line head, ear;
  for (int i = 0; i < 80; ++i) {
    const double t = 2 * std::numbers::pi * i / 80;
    head.push_back({512 + 250 * std::cos(t) + 12 * std::sin(5 * t), 384 + 230 * std::sin(t) + 11 * std::cos(3 * t)});
    ear.push_back({330 + 60 * std::cos(t), 260 + 60 * std::sin(t)});
  }
  const Line bird{{205, 346}, {358, 230}, {614, 269}, {870, 230}, {768, 422}, {461, 499}};
  const Line wing{{461, 323}, {696, 338}, {614, 430}, {471, 399}};
  for (const auto& [thing, part, key] : {std::tuple{head, ear, "x"}, std::tuple{bird, wing, "z"}}) {
    CAPTURE(key);
    document::Document document = document::update({}, document::AddSketch{"", {1024, 768}}).value();
    for (const Line& outline : {thing, part}) {
      const document::Region region{PictureId{1}, {outline}, 0};
      document = document::update(document, document::DrawRegion{region, inflate::InflateParams{}, {}}).value();
    }
    document::Placement before;
    before.move.z = 0.2;
    document = document::update(document, document::PlaceParts{{{PartId{2}, before, {}}}}).value();
    pipeline::Cache cache;
    const pipeline::Derived derived = pipeline::deriveWithEdges(document, cache, {}).value();
    CHECK(likelyAxis(document, derived, std::array{PartId{2}}).key == std::string(key));
  }
}

TEST_CASE("what is moved together stays together, twins of live symmetry too; an ear alone moves against its twin") {
  document::Document document =
      document::update({}, document::AddPicture{"bar", std::make_shared<image::Picture>(test::barPicture())}).value();
  for (int i = 0; i < 3; ++i) {
    document = document::update(document, document::DrawSpine{PictureId{1}, {{100, 40}, {100, 160}}}).value();
  }
  pipeline::Cache cache;
  const pipeline::Derived derived = pipeline::deriveWithEdges(document, cache, {}).value();
  const mesh::TriMesh& shape = derived.parts[0].shape->mesh;
  constexpr image::Size kSize{200, 200};
  const document::MirrorPlane plane{{0.1, 0, 0}, {1, 0, 0}};
  Rng rng(12);
  const auto point = [&] { return WorldPoint{rng.uniform(-1, 1), rng.uniform(-1, 1), rng.uniform(-1, 1)}; };
  for (int i = 0; i < 40; ++i) {
    // The first part stands where it was traced, without a pivot of its own.
    document = document::update(document, document::PlaceParts{{{PartId{2}, testing::randomPlacement(rng), plane},
                                                                {PartId{3}, testing::randomPlacement(rng), {}}}})
                   .value();
    const document::Motion motion{point(), point(), geometry::turnAbout(point(), rng.uniform(-3, 3)),
                                  rng.uniform(0.5, 2)};
    const PartId all[] = {PartId{1}, PartId{2}, PartId{3}}, ear[] = {PartId{2}};
    const auto moved = movedParts(document, derived, all, motion);
    REQUIRE(moved.size() == 3);
    for (std::size_t k = 0; k < 3; ++k) {
      const auto before = pipeline::copiesInWorld(*document.parts[k], kSize);
      const auto after = pipeline::copiesInWorld(moved[k].placement, moved[k].mirror, kSize);
      REQUIRE(before.count == after.count);
      for (std::size_t copy = 0; copy < before.count; ++copy) {
        for (std::size_t v = 0; v < shape.positions.size(); v += 37) {
          const auto& p = shape.positions[v];
          CHECK(distance(after.all[copy](p), motion(before.all[copy](p))) < 1e-9);
        }
      }
    }
    CHECK(movedParts(document, derived, ear, motion)[0].mirror == plane);
  }
}

TEST_CASE("where a processor draws, floor and shadow wait for a hand that moves a part, and follow when it rests") {
  for (const bool slow : {false, true}) {
    CAPTURE(slow);
    Placed page;
    page.host.slow = slow;
    const gl::Scene& shown = page.gl->last;
    const gl::Floor before = shown.floor;
    REQUIRE(before.radius > 0);
    const ClientPoint knob = page.knob("y");
    page.pointer(platform::PointerKind::Move, knob.x, knob.y);
    page.pointer(platform::PointerKind::Down, knob.x, knob.y);
    for (int i = 1; i <= 4; ++i) {
      page.host.clockMs += 16;
      page.pointer(platform::PointerKind::Move, knob.x, knob.y + 20 * i);
      page.app->frame();
    }
    CHECK(shown.hurried == slow);
    CHECK((shown.floor == before) == slow);
    page.settle();
    CHECK_FALSE(shown.hurried);
    CHECK(shown.floor.centre.y < before.centre.y);
  }
}
