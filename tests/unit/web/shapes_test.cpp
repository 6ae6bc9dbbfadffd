// Shapes and side pictures by commands.
#include <doctest/doctest.h>

#include <string>

#include "tests/unit/web/rig.h"

using namespace spineloft;
using test::Rig;

namespace {

/// The document, from the text of a link.
const std::vector<document::Outline>& outlinesIn(const document::Document& document) {
  REQUIRE(document::shapeOf(*document.parts.back()) != nullptr);
  return document::shapeOf(*document.parts.back())->outlines;
}
std::size_t outlines(Rig& rig) { return outlinesIn(rig.shared()).size(); }
std::string errorOf(const app::Json& answer) {
  const std::string* error = answer.text("error");
  return error ? *error : "";
}

/// A page with a sheet of paper, and one half as large.
struct TwoSheets : Rig {
  TwoSheets() {
    REQUIRE(works("new-sketch", R"({"width": 200, "height": 200})"));
    REQUIRE(works("new-sketch", R"({"width": 100, "height": 100})"));
    const document::Document document = [&] {
      REQUIRE(works("draw-shape", R"({"kind": "egg", "picture": 1, "axis": [[100, 160], [100, 40]],
                                            "width": 80, "depth": "kept", "ratio": 0.5})"));
      return shared();
    }();
    REQUIRE(document.pictures.size() == 2);
    CHECK(document::shapeOf(*document.parts.back())->shape.depth == shape::Depth{shape::DepthMode::Kept, 0.5});
  }
};

const std::string kDiamond = "[[100, 40], [140, 100], [100, 160], [60, 100]]";
const std::string kSideLines =
    R"({"picture": 2, "lines": [[[45, 20], [30, 50], [45, 80]], [[55, 20], [70, 50], [55, 80]]]})";

}  // namespace

TEST_CASE("a shape is drawn and given an outline, undone and done again, also on a page that was loaded anew") {
  const auto undoneAndDone = [](Rig& page) {
    REQUIRE(page.works("undo"));
    CHECK(outlines(page) == 0);
    REQUIRE(page.works("redo"));
    CHECK(outlines(page) == 1);
  };
  std::string kept;
  {
    TwoSheets rig;
    CHECK(*rig.state().find("parts")->array()->back().text("kind") == "shape");
    REQUIRE(rig.works("shape-outline", R"({"line": )" + kDiamond + "}"));
    undoneAndDone(rig);
    kept = rig.app->history();
  }
  Rig again;
  REQUIRE(app::Json::parse(again.app->restore(kept, "[]"))->flag("ok") == true);
  again.settle();
  CHECK(outlines(again) == 1);
  undoneAndDone(again);
  CHECK(again.app->history() == kept);
  // Without a line the outline goes.
  REQUIRE(again.works("shape-outline", R"({"part": 1, "picture": 1})"));
  CHECK(outlines(again) == 0);
}

TEST_CASE("a box says where a shape stands") {
  TwoSheets rig;
  REQUIRE(rig.works("draw-shape", R"({"kind": "ball", "picture": 1, "box": [[60, 150], [140, 50]]})"));
  const document::Document document = rig.shared();
  const shape::ShapeParams& params = document::shapeOf(*document.parts.back())->shape;
  CHECK(params.axis == shape::Axis{{100, 150}, {100, 50}});
  CHECK(params.width == 80);
}

TEST_CASE("a picture becomes the side of another one, whose outlines then count") {
  TwoSheets rig;
  CHECK(errorOf(rig.run("shape-outline", kSideLines)) == "ViewInvalid");
  REQUIRE(rig.works("set-view", R"({"picture": 2, "of": 1, "from": "left"})"));
  // Both show the same rows: half as many pixels, each twice as large.
  const geometry::View view = rig.shared().pictures[1]->view.value().view;
  CHECK(view.scale == 2);
  CHECK(geometry::inModel(view, {49.5, -0.5}) == ModelPoint{0, 0.5, 0});
  CHECK(geometry::inModel(view, {49.5, 99.5}).y == -199.5);
  REQUIRE(rig.works("shape-outline", kSideLines));
  CHECK(outlines(rig) == 1);
  REQUIRE(rig.works("set-view", R"({"picture": 2})"));
  CHECK(outlines(rig) == 0);
  CHECK_FALSE(rig.shared().pictures[1]->view);
  REQUIRE(rig.works("undo"));
  CHECK(outlines(rig) == 1);
  for (const char* from : {"top", "back"}) {
    CAPTURE(from);
    REQUIRE(rig.works("set-view", std::string(R"({"picture": 2, "of": 1, "from": ")") + from + "\"}"));
    const geometry::View other = rig.shared().pictures[1]->view.value().view;
    const ModelPoint corner = geometry::inModel(other, {-0.5, -0.5});
    CHECK(corner.x == doctest::Approx(from == std::string("top") ? -0.5 : 199.5));
  }
}

TEST_CASE("puffs and lofts are fitted to the side, undone and done again, and get their own depth back") {
  std::string kept;
  {
    TwoSheets rig;
    REQUIRE(rig.works("select-picture", R"({"picture": 1})"));
    REQUIRE(
        rig.works("draw-puff", R"({"picture": 1, "line": [[60, 40], [140, 40], [140, 160], [60, 160], [60, 40]]})"));
    const auto part = [&] { return document::Part(rig.shared().parts.back()); };
    const PartId puff = part().id;
    const auto side = [&] { return *document::sideOf(part().recipe); };
    REQUIRE(document::inflateOf(part()) != nullptr);
    CHECK(errorOf(rig.run("fit-side")) == "NotNow");  // no side picture
    REQUIRE(rig.works("set-view", R"({"picture": 2, "of": 1, "from": "left"})"));
    CHECK(errorOf(rig.run("fit-side")) == "NotNow");  // nothing is drawn there
    CHECK(errorOf(rig.run("fit-side", R"({"line": [[40, 20], [60, 80], [40, 80], [60, 20]]})")) == "ShapeInvalid");
    CHECK(errorOf(rig.run("fit-side", R"({"picture": 1, "line": [[40, 20], [60, 20], [60, 80]]})")) == "ViewInvalid");
    REQUIRE(rig.works("fit-side", R"({"line": [[40, 20], [60, 20], [60, 80], [40, 80]]})"));
    REQUIRE(side());
    kept = rig.app->history();
    REQUIRE(rig.works("undo"));
    CHECK_FALSE(side());
    REQUIRE(rig.works("redo"));
    CHECK(side());
    REQUIRE(rig.works("plain-side"));
    CHECK_FALSE(side());
    // The outline of a shape in the side picture is taken where none is given, for several parts at once.
    REQUIRE(rig.works("draw-spine", R"({"picture": 1, "stroke": [[100, 45], [100, 155]]})"));
    CHECK(document::loftOf(part()) != nullptr);
    REQUIRE(rig.works("set-view", R"({"picture": 2, "of": 1, "from": "left"})"));
    REQUIRE(
        rig.works("shape-outline", R"({"part": 1, "picture": 2, "line": [[50, 20], [65, 50], [50, 80], [35, 50]]})"));
    const double undo = *rig.state().number("undo");
    REQUIRE(rig.works("fit-side",
                      "{\"parts\": [" + std::to_string(puff.value) + ", " + std::to_string(part().id.value) + "]}"));
    CHECK(*rig.state().number("undo") == undo + 1);
    CHECK(side());
    CHECK(document::sideOf(document::findPart(rig.shared(), puff)->recipe)->has_value());
    CHECK(errorOf(rig.run("fit-side", R"({"part": 1})")) == "TakesNoSide");
  }
  Rig again;
  REQUIRE(app::Json::parse(again.app->restore(kept, "[]"))->flag("ok") == true);
  again.settle();
  CHECK(document::sideOf(again.shared().parts.back()->recipe)->has_value());
}

TEST_CASE("what makes no shape is refused by name and changes nothing") {
  TwoSheets rig;
  const std::string before = rig.app->history();
  CHECK(errorOf(rig.run("draw-shape", R"({"kind": "sphere"})")) == "ArgumentMissing");
  CHECK(errorOf(rig.run("draw-shape", R"({"kind": "ball"})")) == "ArgumentMissing");
  CHECK(errorOf(rig.run("draw-shape", R"({"kind": "ball", "axis": [[1, 1], [1, 1]]})")) == "ValueOutOfRange");
  CHECK(errorOf(rig.run("draw-shape", R"({"kind": "ball", "picture": 1, "box": [[60, 40], [140, 160]],
                                          "line": [[60, 40], [140, 160], [60, 160], [140, 40]]})")) == "ShapeInvalid");
  CHECK(errorOf(rig.run("shape-outline", R"({"line": 5})")) == "ArgumentMissing");
  CHECK(errorOf(rig.run("set-view", R"({"picture": 1, "of": 1, "from": "right"})")) == "ViewInvalid");
  CHECK(errorOf(rig.run("set-view", R"({"picture": 2, "of": 7, "from": "right"})")) == "NoSuchPicture");
  CHECK(errorOf(rig.run("set-view", R"({"picture": 2, "of": 1})")) == "ArgumentMissing");
  rig.settle();
  CHECK(rig.app->history() == before);
  REQUIRE(rig.works("draw-spine", R"({"picture": 1, "stroke": [[20, 40], [180, 40]]})"));
  CHECK(errorOf(rig.run("shape-outline", R"({"line": )" + kDiamond + "}")) == "NotAShape");
}
