// The tool Lines: pieces from lines, seen and hidden, bridges and rings by every pointer, keys and words.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "engine/document/update.h"
#include "engine/io/journal.h"
#include "engine/pipeline/derive.h"
#include "engine/pipeline/world.h"
#include "tests/support/line_creature.h"
#include "tests/unit/web/rig.h"
#include "web/edit/depth_dots.h"
#include "web/edit/line_drawing.h"

using namespace spineloft;
using namespace spineloft::testing;
using test::Rig;

namespace {

constexpr std::array kDevices = {platform::Device::Mouse, platform::Device::Touch, platform::Device::Pen};

struct Lines : Rig {
  explicit Lines(platform::CanvasSize size = {1200, 700, 1}) : Rig(size) {
    CHECK(works("new-sketch", R"({"width": 1000, "height": 800})"));
    CHECK(works("lines"));
  }
  /// Along picture points, as a hand draws. `button` 2: that of a pen.
  void draw(std::vector<PicturePoint> line, bool close = false, platform::Device device = {}, int button = 0) {
    if (close) line.push_back(line.front());
    const auto first = at(line.front().x, line.front().y);
    auto p = first;
    pointer(platform::PointerKind::Down, p.x, p.y, device, 1, button);
    for (std::size_t i = 1; i < line.size(); ++i) {
      p = at(line[i].x, line[i].y);
      pointer(platform::PointerKind::Move, p.x, p.y, device, 1, button);
    }
    settle(2);
    hiddenInHand = app->state().find(R"("hiddenPen":true)") != std::string::npos;
    pointer(platform::PointerKind::Up, p.x, p.y, device, 1, button);
    settle();
  }
  void tap(double x, double y, platform::Device device = {}) {
    pointer(platform::PointerKind::Down, x, y, device);
    pointer(platform::PointerKind::Up, x, y, device);
    settle();
  }
  /// Body, two half hidden legs and a tail; six gestures and the pen four times.
  void drawCreature(platform::Device device = {}) {
    draw(bodyLine(), true, device);
    for (const double x : {360.0, 560.0}) {
      CHECK(works("seen-pen"));
      draw(legLine(x), false, device);
      CHECK(works("hidden-pen", R"({"on": true})"));
      draw(hipLine(x), false, device);
    }
    CHECK(works("seen-pen"));
    draw(tailLine(), true, device);
  }
  app::Json drawing() {
    const app::Json now = state();
    REQUIRE(now.find("drawings")->array()->size() == 1);
    return now.find("drawings")->array()->front();
  }
  /// (over, under) of every bridge.
  std::vector<std::pair<double, double>> bridges() {
    std::vector<std::pair<double, double>> out;
    const app::Json now = state();
    for (const app::Json& bridge : *now.find("bridges")->array()) {
      out.emplace_back(*bridge.number("over"), *bridge.number("under"));
    }
    return out;
  }
  Vec2<platform::CanvasSpace> bridgeAt(std::size_t i) {
    const app::Json now = state();
    const auto& at = *(*now.find("bridges")->array())[i].find("at")->array();
    return {*at[0].number(), *at[1].number()};
  }
  bool hiddenInHand = false;
};

/// The document within a history: the keys are in the order of the alphabet, and it is the last one.
std::string presentOf(const std::string& history) {
  const std::size_t at = history.find(R"("present":)");
  REQUIRE(at != std::string::npos);
  return history.substr(at);
}

}  // namespace

TEST_CASE(
    "body, two half hidden legs and a tail by each pointer: four solids, every gesture one step, undone to the "
    "start") {
  for (const platform::Device device : kDevices) {
    Lines page;
    const double before = page.undoSteps();
    const std::string start = page.app->history();
    page.drawCreature(device);
    CHECK(page.undoSteps() == before + 6);
    const app::Json now = page.state();
    REQUIRE(now.find("parts")->array()->size() == 4);
    for (const app::Json& part : *now.find("parts")->array()) {
      CHECK(*part.text("kind") == "element");
      CHECK(part.find("failure")->isNull());
      CHECK(*part.number("triangles") > 500);
    }
    CHECK(page.drawing().find("contradictions")->array()->size() <= 1);  // the tail is drawn over the body, all seen
    const auto bridges = page.bridges();
    REQUIRE(bridges.size() == 3);
    for (const auto& [over, under] : bridges) {
      if (over == 2 || under == 2 || over == 3 || under == 3) CHECK(over == 1);  // legs are behind the body
    }
    for (int i = 0; i < 6; ++i) CHECK(page.works("undo"));
    CHECK(page.parts() == 0);
    CHECK(page.state().find("drawings")->array()->empty());
    const std::string back = page.app->history();
    CHECK(presentOf(back) == presentOf(start));
    for (int i = 0; i < 6; ++i) CHECK(page.works("redo"));
    CHECK(page.parts() == 4);
  }
}

TEST_CASE("dashes by each pointer become the hidden line of a leg with the last one, which is undone to strokes") {
  for (int way = 0; way < 6; ++way) {
    const platform::Device device = kDevices[static_cast<std::size_t>(way / 2)];
    const bool toAndFro = way % 2 == 1;
    CAPTURE(static_cast<int>(device));
    CAPTURE(toAndFro);
    Lines page;
    page.draw(bodyLine(), true, device);
    page.draw(legLine(360, 200), false, device);
    std::vector<std::vector<PicturePoint>> dashes = dashesOf(hipLine(360, 200), 6, 0.75);
    for (std::size_t k = 1; toAndFro && k < dashes.size(); k += 2) std::ranges::reverse(dashes[k]);
    const double before = page.undoSteps();
    for (const auto& dash : dashes) page.draw(dash, false, device);
    CHECK(page.undoSteps() == before + static_cast<double>(dashes.size()));
    const auto lines = [&] { return *page.drawing().find("lines")->array(); };
    REQUIRE(lines().size() == 3);
    CHECK(lines()[2].find("hidden")->array()->size() == 1);
    CHECK(page.drawing().find("openEnds")->array()->empty());
    CHECK(page.parts() == 2);
    REQUIRE(page.bridges().size() == 1);
    CHECK(page.bridges()[0] == std::pair{1.0, 2.0});
    CHECK(page.works("undo"));
    CHECK(lines().size() == 1 + dashes.size());
    CHECK(page.works("redo"));
    CHECK(lines().size() == 3);
  }
}

TEST_CASE("a tap on a bridge swaps there only, and one more swaps back; keys do the same") {
  Lines page;
  page.drawCreature();
  const auto before = page.bridges();
  REQUIRE(before.size() == 3);
  for (const platform::Device device : kDevices) {
    const auto at = page.bridgeAt(1);
    page.tap(at.x, at.y, device);
    const auto swapped = page.bridges();
    for (std::size_t i = 0; i < 3; ++i) {
      CHECK((swapped[i] == before[i]) == (i != 1));
      CHECK(((swapped[i].first == before[i].second) == (i == 1)));
    }
    CHECK(page.host.said("is in front of"));
    page.tap(at.x, at.y, device);
    CHECK(page.bridges() == before);
  }
  CHECK(page.key("Period", "."));
  CHECK(*page.state().find("chosen")->number("bridge") == 0);
  CHECK(page.key("Comma", ","));
  CHECK(*page.state().find("chosen")->number("bridge") == 2);
  CHECK(page.key("Enter", "Enter"));
  CHECK(page.bridges()[2] == std::pair(before[2].second, before[2].first));
  CHECK(page.bridges()[0] == before[0]);
  // Escape lets go of the bridge, then of the tool.
  CHECK(page.key("Escape", "Escape"));
  CHECK(*page.state().find("chosen")->number("bridge") == -1);
  CHECK(*page.state().text("tool") == "lines");
}

TEST_CASE("a dot of the turned solid view is dragged nearer by every pointer: one step, live, and a tap frees it") {
  for (const platform::Device device : kDevices) {
    CAPTURE(static_cast<int>(device));
    Lines page;
    page.draw(bodyLine(), true, device);
    page.draw(legLine(360), false, device);
    const auto dots = [&] { return *page.state().find("depthDots")->array(); };
    const auto pins = [&] { return page.drawing().find("pins")->array()->size(); };
    const auto send = [&](platform::PointerKind kind, app::ClientPoint p) { page.pointer(kind, p.x, p.y, device); };
    const auto placeOf = [](const app::Json& dot) {
      const auto& at = *dot.find("at")->array();
      return app::ClientPoint{*at[0].number(), *at[1].number()};
    };
    CHECK(page.works("home-view"));
    REQUIRE(dots().size() >= 6);
    const app::Json dot = dots()[2];
    const app::ClientPoint from = placeOf(dot);
    CHECK(dot.flag("pinned") == false);
    const double steps = page.undoSteps();
    const auto drag = [&](double by) {
      send(platform::PointerKind::Down, from);
      for (int i = 1; i <= 10; ++i) send(platform::PointerKind::Move, from + app::ClientPoint{by * i / 10, 0});
      page.settle(2);
    };
    drag(60);
    // It follows before the pointer is lifted.
    CHECK(std::abs(*dots()[2].number("z") - *dot.number("z")) > 10);
    CHECK(pins() == 0);
    CHECK(page.key("Escape", "Escape"));
    send(platform::PointerKind::Up, from);
    page.settle();
    CHECK(page.undoSteps() == steps);
    CHECK(*dots()[2].number("z") == doctest::Approx(*dot.number("z")));
    drag(60);
    send(platform::PointerKind::Up, from + app::ClientPoint{60, 0});
    page.settle();
    CHECK(page.undoSteps() == steps + 1);
    REQUIRE(pins() == 1);
    const app::Json pinned = dots()[0];
    CHECK(pinned.flag("pinned") == true);
    CHECK(*page.drawing().find("pins")->array()->front().number("z") == doctest::Approx(*pinned.number("z")));
    CHECK(distance(placeOf(pinned), from) > 10);
    const app::ClientPoint there = placeOf(pinned);
    page.tap(there.x, there.y, device);
    CHECK(pins() == 0);
    CHECK(page.works("undo"));
    CHECK(page.works("undo"));
    CHECK(pins() == 0);
  }
}

TEST_CASE("an open line waits with rings; a tap on one closes it, and so does a line between them") {
  const std::vector<PicturePoint> open{{300, 300}, {250, 340}, {230, 400}, {250, 460}, {300, 500}};
  for (const platform::Device device : kDevices) {
    Lines page;
    page.draw(open, false, device);
    CHECK(page.parts() == 0);
    CHECK(page.host.said("A line is not closed"));
    app::Json now = page.state();
    REQUIRE(now.find("lineEnds")->array()->size() == 2);
    const auto& ring = *now.find("lineEnds")->array()->front().array();
    page.tap(*ring[0].number(), *ring[1].number(), device);
    CHECK(page.parts() == 1);
    CHECK(page.state().find("lineEnds")->array()->empty());
    CHECK(page.works("undo"));
    CHECK(page.parts() == 0);
    page.draw({{302, 499}, {400, 480}, {450, 400}, {400, 320}, {299, 303}}, false, device);
    CHECK(page.parts() == 1);
    CHECK(page.state().find("lineEnds")->array()->empty());
  }
}

TEST_CASE("the hidden pen by its button, its key, Shift and the button of a pen") {
  Lines page;
  const auto hidden = [&] { return !page.drawing().find("lines")->array()->back().find("hidden")->array()->empty(); };
  page.draw(bodyLine(), true);
  CHECK_FALSE(hidden());
  CHECK(page.key("KeyD", "d"));
  page.draw(tailLine(), true);
  CHECK(hidden());
  CHECK(page.key("KeyD", "d"));
  CHECK(*page.state().text("tool") == "lines");
  page.draw({{100, 100}, {200, 100}, {200, 200}, {100, 200}}, true);
  CHECK_FALSE(hidden());
  page.draw({{100, 600}, {200, 600}, {200, 700}, {100, 700}}, true, platform::Device::Pen, 2);
  CHECK(hidden());
  CHECK(page.drawing().find("lines")->array()->size() == 4);
}

TEST_CASE("a piece is round or flat, from the panel's words and by its command") {
  Lines page;
  page.draw(bodyLine(), true);
  const auto kind = [&] { return *page.drawing().find("pieces")->array()->front().text("kind"); };
  CHECK(kind() == "round");
  CHECK(page.works("shape-piece", R"({"kind": "flat"})"));
  CHECK(kind() == "flat");
  CHECK(page.works("shape-piece", R"({"kind": "round", "part": 1})"));
  CHECK(kind() == "round");
  CHECK(page.fault("shape-piece", R"({"kind": "wet"})") == "ArgumentMissing");
  CHECK(page.works("set-parameter", R"({"key": "front", "value": 2})"));
  CHECK(page.works("more-tools", R"({"on": true})"));
  CHECK(page.fault("shape-piece", R"({"kind": "flat", "part": 9})") == "NoSuchPart");
}

/// A box seen from above: nine seen lines.
std::vector<std::vector<PicturePoint>> seenBox() {
  const std::vector<PicturePoint> p{{300, 200}, {600, 260}, {780, 180}, {480, 130}, {300, 520}, {600, 600}, {780, 500}};
  return {{p[0], p[1]}, {p[1], p[2]}, {p[2], p[3]}, {p[3], p[0]}, {p[0], p[4]},
          {p[1], p[5]}, {p[2], p[6]}, {p[4], p[5]}, {p[5], p[6]}};
}

TEST_CASE("after the turn upright a box stands on four corners, and no turn is left") {
  document::Document document = document::update({}, document::AddSketch{"paper", {1000, 800}}).value();
  for (const auto& line : seenBox()) {
    document = document::update(document, document::DrawLine{document.pictures[0]->id, line}).value();
  }
  REQUIRE(document.parts.size() == 1);
  const PartId box = document.parts[0]->id;
  pipeline::Cache cache;
  const pipeline::Derived derived = pipeline::derive(document, cache);
  const auto turn = app::turnUpright(document, derived, box);
  REQUIRE(turn.has_value());
  const mesh::TriMesh& mesh = derived.parts[0].shape->mesh;
  std::vector<double> heights;
  for (const auto& p : mesh.positions) heights.push_back(geometry::turned(*turn, WorldPoint{p[0], p[1], p[2]}).y);
  std::ranges::sort(heights);
  const double tall = heights.back() - heights.front();
  CHECK(tall > 300);
  const auto atFloor = [&](double h) { return h < heights.front() + 1e-4 * tall; };
  CHECK(std::ranges::count_if(heights, atFloor) >= 4);
  document::Motion motion;
  motion.turn = *turn;
  document =
      document::update(document, document::PlaceParts{{{box, document::moved(document::Placement{}, motion), {}}}})
          .value();
  CHECK_FALSE(app::turnUpright(document, pipeline::derive(document, cache), box).has_value());
}

TEST_CASE("the dots of a solid with edges are at its corners, also where these are beside what was drawn") {
  document::Document document = document::update({}, document::AddSketch{"paper", {1000, 800}}).value();
  // Its front square: an oblique projection, which no view from afar looks like.
  const std::vector<std::vector<PicturePoint>> lines{{{200, 300}, {500, 300}, {500, 600}, {200, 600}, {200, 300}},
                                                     {{200, 300}, {310, 190}},
                                                     {{500, 300}, {610, 190}},
                                                     {{500, 600}, {610, 490}},
                                                     {{310, 190}, {610, 190}, {610, 490}}};
  for (const auto& line : lines) {
    document = document::update(document, document::DrawLine{document.pictures[0]->id, line}).value();
  }
  REQUIRE(document.parts.size() == 1);
  pipeline::Cache cache;
  const pipeline::Derived derived = pipeline::derive(document, cache);
  app::UiState ui;
  ui.selection = document.parts[0]->id;
  ui.layout.solid = {0, 0, 600, 600};
  ui.camera.yaw = 0.6;
  const auto dots = app::dotsOfPiece(document, derived, ui);
  CHECK(dots.size() >= 7);
  double most = 0;
  for (const app::DepthDot& dot : dots) {
    double away = INFINITY;
    for (const auto& [x, y, z] : derived.parts[0].shape->mesh.positions) {
      away = std::min(away, norm(dot.where - ModelPoint{x, y, z}));
    }
    CHECK(away < 1);
  }
  for (const PicturePoint drawn : {PicturePoint{200, 300}, {500, 600}, {610, 190}}) {
    double away = INFINITY;
    for (const app::DepthDot& dot : dots) away = std::min(away, distance(drawn, {dot.where.x, -dot.where.y}));
    most = std::max(most, away);
  }
  CHECK(most > 5);
}

TEST_CASE("a box that was drawn from above is stood upright in one step") {
  Lines page;
  for (const auto& line : seenBox()) page.draw(line);
  REQUIRE(page.parts() == 1);
  const double steps = page.undoSteps();
  CHECK(page.works("stand-upright"));
  CHECK(page.undoSteps() == steps + 1);
  CHECK(page.fault("stand-upright", "{}") == "NotNow");
  CHECK(page.works("undo"));
  CHECK(page.works("stand-upright", R"({"part": 1})"));
  CHECK(page.fault("stand-upright", R"({"part": 9})") == "NoSuchPart");
}

TEST_CASE("what stands upright stands on the floor of the others, and what is grouped with it goes along") {
  for (const bool isGrouped : {false, true}) {
    CAPTURE(isGrouped);
    Lines page;
    for (const auto& line : seenBox()) page.draw(line);
    CHECK(page.works("new-sketch", R"({"width": 400, "height": 400})"));
    for (const char* stroke : {R"({"stroke": [[200, 60], [200, 340]]})", R"({"stroke": [[300, 60], [300, 340]]})"}) {
      REQUIRE(page.works("draw-spine", stroke));
    }
    REQUIRE(page.parts() == 3);
    CHECK(page.works("move-parts", R"({"parts": [2], "move": [0, -37, 0]})"));
    if (isGrouped) CHECK(page.works("group", R"({"parts": [1, 3]})"));
    const auto now = [&] {
      auto read = io::readHistory(page.app->history(), {}, {});
      REQUIRE(read.ok());
      return read.value().history.present();
    };
    const std::vector<PartId> box{PartId{1}}, other{PartId{2}}, companion{PartId{3}};
    const document::Document before = now();
    CHECK(page.works("stand-upright", R"({"part": 1})"));
    const document::Document after = now();
    pipeline::Cache cache;
    const auto low = [&](const document::Document& document, const std::vector<PartId>& parts) {
      return pipeline::boundsOf(document, pipeline::deriveWithEdges(document, cache, {}).value(), parts).value().low.y;
    };
    const auto placed = [](const document::Document& document, PartId part) {
      return document::findPart(document, part)->placement;
    };
    CHECK(placed(after, PartId{2}) == placed(before, PartId{2}));
    CHECK((placed(after, PartId{3}) == placed(before, PartId{3})) == !isGrouped);
    const double stood = isGrouped ? std::min(low(after, box), low(after, companion)) : low(after, box);
    const double floor = isGrouped ? low(after, other) : std::min(low(after, other), low(after, companion));
    CHECK(stood == doctest::Approx(floor).epsilon(1e-6));
    // They are turned as one thing.
    const WorldPoint axis{0, 1, 0};
    const auto turnedBy = [&](PartId part) {
      return geometry::turned(placed(after, part).turn,
                              geometry::turned(geometry::inverse(placed(before, part).turn), axis));
    };
    if (isGrouped) CHECK(norm(turnedBy(PartId{1}) - turnedBy(PartId{3})) < 1e-9);
  }
}

TEST_CASE("right angles are seen from above, from below or not at all, and the panel says which") {
  Lines page;
  CHECK(page.works("draw-line", R"({"points": [[300, 300], [600, 360], [760, 280], [460, 220]], "closed": true})"));
  CHECK(page.works("shape-piece", R"({"kind": "flat"})"));
  CHECK(page.works("draw-line", R"({"points": [[440, 300], [470, 300], [470, 600], [440, 600]], "closed": true})"));
  const auto seen = [&] { return *page.drawing().text("seenFrom"); };
  const auto isShown = [&](const char* words) {
    const app::Json now = page.state();
    return std::ranges::any_of(*now.find("controls")->array(),
                               [&](const app::Json& one) { return *one.text("words") == words; });
  };
  CHECK(seen() == "above");
  CHECK(isShown("From below"));
  CHECK(isShown("Stand upright"));
  CHECK(page.works("seen-from", R"({"from": "unknown"})"));
  CHECK(seen() == "unknown");
  CHECK(isShown("From below"));
  CHECK_FALSE(isShown("Stand upright"));
  CHECK(page.works("seen-from", R"({"from": "below", "part": 1})"));
  CHECK(seen() == "below");
  CHECK(page.works("undo"));
  CHECK(seen() == "unknown");
  CHECK(page.fault("seen-from", R"({"from": "behind"})") == "ArgumentMissing");
  CHECK(page.fault("seen-from", R"({"from": "above", "part": 9})") == "NoSuchPart");
}

TEST_CASE("programs draw, hide, order, pin and delete, and are told why not") {
  Lines page;
  CHECK(page.works("draw-line", R"({"points": [[300, 300], [500, 300], [500, 500], [300, 500]], "closed": true})"));
  CHECK(page.works("draw-line", R"({"points": [[450, 350], [650, 350], [650, 450], [450, 450]], "closed": true})"));
  CHECK(page.parts() == 2);
  CHECK(page.works("hide-line", R"({"line": 2, "hidden": [[0, 0.1], [0.85, 1]]})"));
  CHECK(page.drawing().find("lines")->array()->back().find("hidden")->array()->size() == 2);
  CHECK(page.works("order-pieces", R"({"over": 2, "under": 1, "at": [475, 400]})"));
  CHECK(*page.drawing().find("orders")->array()->front().text("from") == "user");
  CHECK(*page.drawing().find("orders")->array()->front().number("over") == 2);
  CHECK(page.works("pin-depth", R"({"line": 2, "at": 0.25, "z": 40})"));
  CHECK(page.drawing().find("pins")->array()->size() == 1);
  CHECK(page.works("pin-depth", R"({"line": 2, "at": 0.25})"));
  CHECK(page.drawing().find("pins")->array()->empty());
  CHECK(page.fault("draw-line", R"({"points": [[1, 1]]})") == "StrokeTooShort");
  CHECK(page.fault("draw-line", R"({"points": 3})") == "ArgumentMissing");
  CHECK(page.fault("draw-line", R"({"points": [[1, 1], [90, 90]], "hidden": "some"})") == "ArgumentMissing");
  CHECK(page.fault("draw-line", R"({"points": [[1, 1], [90, 90]], "hidden": [[0.5, 0.2]]})") == "ValueOutOfRange");
  CHECK(page.fault("draw-line", R"({"points": [[-9, -9], [-90, -90]]})") == "StrokeOutsidePicture");
  CHECK(page.fault("hide-line", R"({"line": 9, "hidden": true})") == "NoSuchLine");
  CHECK(page.fault("hide-line", R"({"line": 1})") == "ArgumentMissing");
  CHECK(page.fault("delete-line", R"({"line": 9})") == "NoSuchLine");
  CHECK(page.fault("close-line", R"({"line": 9})") == "NoSuchLine");
  CHECK(page.fault("order-pieces", R"({"over": 1, "under": 1, "at": [1, 1]})") == "ValueOutOfRange");
  CHECK(page.fault("order-pieces", R"({"over": 1, "under": 2})") == "ArgumentMissing");
  CHECK(page.fault("pin-depth", R"({"line": 1, "at": 2, "z": 1})") == "ValueOutOfRange");
  CHECK(page.works("delete-line", R"({"line": 1})"));
  CHECK(page.parts() == 1);
}

TEST_CASE("bridges stand a fingertip apart, also where pieces overlap near each other, and say who is in front") {
  Lines page;
  CHECK(page.works("draw-line", R"({"points": [[300, 300], [700, 300], [700, 500], [300, 500]], "closed": true})"));
  for (const char* box :
       {"[[320, 480], [340, 480], [340, 600], [320, 600]]", "[[350, 480], [370, 480], [370, 600], [350, 600]]",
        "[[380, 480], [400, 480], [400, 600], [380, 600]]"}) {
    CHECK(page.works("draw-line", R"({"points": )" + std::string(box) + R"(, "closed": true})"));
  }
  REQUIRE(page.bridges().size() == 3);
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = i + 1; k < 3; ++k) CHECK(distance(page.bridgeAt(i), page.bridgeAt(k)) >= 43);
  }
  const app::Json now = page.state();
  int told = 0;
  for (const app::Json& control : *now.find("controls")->array()) {
    if (control.text("words")->find("Swap them here.") != std::string::npos) ++told;
  }
  CHECK(told == 3);
}

TEST_CASE("a new model is begun with the pen for what is seen") {
  Rig rig;
  rig.run("new-sketch");
  rig.run("hidden-pen", R"({"on": true})");
  REQUIRE(rig.app->ui().edit.hiddenPen);
  rig.run("clear");
  rig.settle();
  rig.run("new-sketch");
  rig.run("lines");
  CHECK_FALSE(rig.app->ui().edit.hiddenPen);
}

namespace {

/// The seen edges of a box; the last one ends `gap` short of its corner.
std::vector<std::vector<PicturePoint>> boxEdges(double gap) {
  return {{{300, 450}, {600, 450}}, {{600, 450}, {600, 700}}, {{600, 700}, {300, 700}},
          {{300, 700}, {300, 450}}, {{300, 450}, {420, 340}}, {{600, 450}, {720, 340}},
          {{600, 700}, {720, 590}}, {{420, 340}, {720, 340}}, {{720, 340}, {720, 590 - gap}}};
}

struct Edges : Lines {
  explicit Edges(double gap) {
    for (const std::vector<PicturePoint>& edge : boxEdges(gap)) draw(edge);
  }
  app::Json::Array rings() { return *state().find("lineEnds")->array(); }
  std::string kind() { return *drawing().find("pieces")->array()->front().text("kind"); }
};

}  // namespace

TEST_CASE("a tap on the ring of an edge that is too short joins it to the end of another: the box is whole") {
  for (const std::size_t ring : {0U, 1U}) {
    CAPTURE(ring);
    Edges page(45);
    REQUIRE(page.rings().size() == 2);
    const double undo = *page.state().number("undo");
    const app::Json::Array at = *page.rings()[ring].array();
    page.tap(*at[0].number(), *at[1].number());
    CHECK(page.rings().empty());
    CHECK(page.kind() == "solid");
    CHECK(page.state().number("undo") == undo + 1);
  }
}

TEST_CASE("a line over one that was too short takes its place, in one step; one that is apart does not") {
  Edges page(45);
  REQUIRE(page.rings().size() == 2);
  const std::size_t lines = page.drawing().find("lines")->array()->size();
  page.draw({{722, 342}, {722, 470}, {720, 592}});
  CHECK(page.rings().empty());
  CHECK(page.kind() == "solid");
  page.run("undo");
  page.settle();
  CHECK(page.drawing().find("lines")->array()->size() == lines);
  CHECK(page.rings().size() == 2);
  page.draw({{760, 342}, {760, 592}});
  CHECK(page.drawing().find("lines")->array()->size() == lines + 1);
}

TEST_CASE("a closed line is closed by the ring at its own end, where no other line is nearer") {
  Lines page;
  page.draw({{200, 200}, {500, 200}, {500, 500}, {200, 500}, {200, 260}});
  page.draw({{700, 200}, {900, 200}});
  const app::Json::Array rings = *page.state().find("lineEnds")->array();
  REQUIRE(rings.size() == 4);
  const app::Json::Array at = *rings[0].array();
  page.tap(*at[0].number(), *at[1].number());
  CHECK(page.parts() == 1);
  CHECK(page.drawing().find("lines")->array()->size() == 2);
  CHECK(page.state().find("lineEnds")->array()->size() == 2);
}

TEST_CASE("a line whose ends alone lie on the new one stays") {
  Lines page;
  page.draw({{200, 200}, {500, 200}});
  page.draw({{500, 200}, {500, 500}, {200, 500}, {200, 200}});
  CHECK(page.parts() == 1);
  CHECK(page.drawing().find("lines")->array()->size() == 2);
}
