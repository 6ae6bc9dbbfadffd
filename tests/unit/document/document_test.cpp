#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <set>
#include <string>

#include "engine/document/checks.h"
#include "engine/document/history.h"
#include "engine/document/params.h"
#include "engine/document/update.h"
#include "tests/support/random_documents.h"
#include "tests/support/rounds.h"

using namespace spineloft;
using namespace spineloft::document;
using spineloft::testing::ellipsePicture;

namespace {

const std::vector<PicturePoint> kStroke = {{20, 36}, {48, 36}, {76, 36}};

/// The document after actions that must all succeed.
Document after(Document document, std::initializer_list<Action> actions) {
  for (const Action& action : actions) {
    Result<Document> next = update(document, action);
    REQUIRE(next.ok());
    document = std::move(next).value();
  }
  return document;
}

Document onePart() {
  return after({}, {AddPicture{"cat.png", ellipsePicture(96, 72)}, DrawSpine{PictureId{1},
                                                                             kStroke,
                                                                             sections::SectionPreset::Star,
                                                                             sections::CapStyle::Flat,
                                                                             sections::CapStyle::Pointed,
                                                                             {}}});
}

/// A loft, a puff and a flat piece, in this order.
Document everyKind() {
  const Region region{PictureId{1}, {{{20, 20}, {60, 20}, {60, 60}, {20, 60}}}, 0};
  return after(onePart(),
               {DrawRegion{region, inflate::InflateParams{}, {}}, DrawRegion{region, extrude::ExtrudeParams{}, {}}});
}

/// The document with its first part changed behind the back of `update`.
template <class Change>
Document with(Document document, const Change& change) {
  Part part = document.parts.front();
  change(part);
  document.parts.front() = std::move(part);
  return document;
}

Error errorOf(const Document& document, const Action& action) {
  const Result<Document> next = update(document, action);
  REQUIRE_FALSE(next.ok());
  return next.error();
}

}  // namespace

TEST_CASE("drawing a spine makes a part with the stroke, section and caps that were asked for") {
  const Document document = onePart();
  REQUIRE(document.parts.size() == 1);
  const Part& part = document.parts[0];
  CHECK(loftOf(part)->stroke == kStroke);
  CHECK(loftOf(part)->loft.sections.front().shape == sections::SectionPreset::Star);
  CHECK(loftOf(part)->loft.startCap == sections::CapStyle::Flat);
  CHECK(loftOf(part)->loft.endCap == sections::CapStyle::Pointed);
  CHECK(part.name == "Part 1");
  CHECK(findPart(document, part.id) == &part);
  CHECK(findPicture(document, PictureId{1})->name == "cat.png");
  CHECK(findPicture(document, PictureId{9}) == nullptr);
}

TEST_CASE("each setter changes exactly what it names") {
  const Document before = onePart();
  const PartId id = before.parts[0]->id;
  Document expected =
      with(before, [](Part& part) { loftOf(part)->loft.sections.front().shape = sections::SectionPreset::Gear; });
  CHECK(after(before, {SetSection{id, sections::SectionPreset::Gear}}) == expected);
  expected = with(before, [](Part& part) { loftOf(part)->loft.startCap = sections::CapStyle::Open; });
  CHECK(after(before, {SetCaps{id, sections::CapStyle::Open, sections::CapStyle::Pointed}}) == expected);
  expected = with(before, [](Part& part) { part.look = {false, {1, 2, 3}}; });
  CHECK(after(before, {SetLook{id, {false, {1, 2, 3}}}}) == expected);
  expected = with(before, [](Part& part) { part.name = "Tail"; });
  CHECK(after(before, {RenamePart{id, "Tail"}}) == expected);
  expected = with(before, [](Part& part) { part.visible = false; });
  CHECK(after(before, {ShowPart{id, false}}) == expected);
  expected = before;
  expected.height = {40};
  CHECK(after(before, {SetHeight{{40}}}) == expected);
  expected = before;
  expected.name = "Dragon";
  CHECK(after(before, {RenameDocument{"Dragon"}}) == expected);
  expected = with(before, [](Part& part) { loftOf(part)->stroke = {{10, 30}, {80, 40}}; });
  CHECK(after(before, {RedrawSpine{id, {{10, 30}, {80, 40}}}}) == expected);
}

TEST_CASE("removing a picture takes the parts drawn on it away, and ids are never used again") {
  Document document = onePart();
  document = after(document, {AddPicture{"dog.png", ellipsePicture(96, 72, 1)}, DrawSpine{PictureId{2}, kStroke}});
  document = after(document, {RemovePicture{PictureId{1}}});
  REQUIRE(document.parts.size() == 1);
  CHECK(pictureOf(*document.parts[0]) == PictureId{2});
  document = after(document, {DeletePart{document.parts[0]->id}, DrawSpine{PictureId{2}, kStroke},
                              AddPicture{"", ellipsePicture(96, 72)}});
  CHECK(document.parts[0]->id == PartId{3});
  CHECK(document.pictures.back()->id == PictureId{3});
  CHECK(document.pictures.back()->name == "Picture 3");
}

TEST_CASE("a refused action names its reason") {
  const Document document = onePart();
  const PartId id = document.parts[0]->id, none{77};
  const double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK(errorOf(document, AddPicture{"x", nullptr}) == Error::PictureEmpty);
  CHECK(errorOf(document, RemovePicture{PictureId{5}}) == Error::NoSuchPicture);
  CHECK(errorOf(document, DrawSpine{PictureId{5}, kStroke}) == Error::NoSuchPicture);
  CHECK(errorOf(document, DrawSpine{PictureId{1}, {{4, 4}}}) == Error::StrokeTooShort);
  CHECK(errorOf(document, DrawSpine{PictureId{1}, {{4, nan}, {9, 9}}}) == Error::StrokeNotFinite);
  CHECK(errorOf(document, DrawSpine{PictureId{1}, {{400, 40}, {500, 40}}}) == Error::StrokeOutsidePicture);
  CHECK(errorOf(document, RedrawSpine{none, kStroke}) == Error::NoSuchPart);
  CHECK(errorOf(document, RedrawSpine{id, {}}) == Error::StrokeTooShort);
  CHECK(errorOf(document, SetSection{none}) == Error::NoSuchPart);
  CHECK(errorOf(document, SetSection{id, sections::SectionPreset::kCount}) == Error::ValueOutOfRange);
  CHECK(errorOf(document, SetCaps{id, sections::CapStyle::kCount}) == Error::ValueOutOfRange);
  CHECK(errorOf(document, SetLook{none, {}}) == Error::NoSuchPart);
  CHECK(errorOf(document, RenamePart{none, "x"}) == Error::NoSuchPart);
  CHECK(errorOf(document, ShowPart{none}) == Error::NoSuchPart);
  CHECK(errorOf(document, DeletePart{none}) == Error::NoSuchPart);
  CHECK(errorOf(document, SetHeight{{0}}) == Error::ValueOutOfRange);
  CHECK(errorOf(document, SetHeight{{nan}}) == Error::ValueOutOfRange);
  CHECK(errorOf(document, SetParameter{id, "no such key", 1}) == Error::ValueOutOfRange);
  CHECK(errorOf(document, SetParameter{id, "ribs", nan}) == Error::ValueOutOfRange);
}

TEST_CASE("every parameter of every kind can be set to each end of its range and no further") {
  const Document document = everyKind();
  for (const Part& part : document.parts) {
    const PartKind kind = kindOf(part);
    const PartId id = part.id;
    std::set<std::string_view> keys;
    for (const ParamInfo& info : paramTable(kind)) {
      CHECK(keys.insert(info.key).second);
      CHECK(findParam(kind, info.key) == &info);
      const std::string key(info.key);
      for (const double value : {info.low, info.high}) {
        const Document set = after(document, {SetParameter{id, key, value}});
        CHECK(info.get(findPart(set, id)->recipe) == doctest::Approx(value));
      }
      const double initial = info.get(emptyRecipe(kind));
      CHECK(initial >= info.low);
      CHECK(initial <= info.high);
      CHECK(errorOf(document, SetParameter{id, key, info.low - info.step}) == Error::ValueOutOfRange);
      CHECK(errorOf(document, SetParameter{id, key, info.high + info.step}) == Error::ValueOutOfRange);
    }
  }
}

TEST_CASE("what is for one kind of part is refused by the others, and nothing changes") {
  const Document document = everyKind();
  const PartId loft = document.parts[0]->id, inflate = document.parts[1]->id;
  const Region region = *regionOf(document.parts[1]->recipe);
  for (const Action& action : std::vector<Action>{RedrawSpine{inflate, kStroke}, PoseSpine{inflate, {}},
                                                  EditRibs{inflate, {}}, IgnoreForPart{inflate, {}},
                                                  SetSection{inflate, {}}, SetSections{inflate, {loft::SectionKey{}}},
                                                  SetAlong{inflate, AlongKind::Twist, {}}, SetCaps{inflate}}) {
    CHECK(errorOf(document, action) == Error::NotABone);
  }
  CHECK(errorOf(document, RedrawRegion{loft, region}) == Error::NotARegion);
  CHECK(errorOf(document, ShapeRegion{loft, inflate::InflateParams{}}) == Error::NotARegion);
  for (const Action& action : std::vector<Action>{SetPlanes{loft, {}}, SetRail{inflate, {}}, ShapeStack{inflate, {}}}) {
    CHECK(errorOf(document, action) == Error::NotAStack);
  }
  CHECK(errorOf(document, SetParameter{inflate, "ribs", 20}) == Error::ValueOutOfRange);
  CHECK(errorOf(document, SetParameter{loft, "height", 1}) == Error::ValueOutOfRange);
}

TEST_CASE("a stack keeps what was drawn, and refuses what is none") {
  const Document document = everyKind();
  stack::Plane plane;
  plane.curves = {{{{10, 0}, {0, 10}, {-10, 0}, {0, -10}}, {}}};
  stack::Plane top = plane;
  top.at = 1;
  const stack::Rail rail{{{20, -60, 0}, {20, -10, 0}}, false};
  const Document drawn = after(document, {DrawStack{PictureId{1}, {plane, top}, rail, {}, {}}});
  const PartId id = drawn.parts.back()->id;
  REQUIRE(stackOf(*drawn.parts.back()) != nullptr);
  CHECK(*stackOf(*drawn.parts.back()) == StackRecipe{PictureId{1}, {plane, top}, rail, {}});
  CHECK(pictureOf(*drawn.parts.back()) == PictureId{1});
  const stack::StackParams open{sections::CapStyle::Open, sections::CapStyle::Round, 64, 3, {}, {}};
  const Document shaped = after(drawn, {SetPlanes{id, {plane}}, SetRail{id, {}}, ShapeStack{id, open}});
  CHECK(*stackOf(*shaped.parts.back()) == StackRecipe{PictureId{1}, {plane}, {}, open});
  const auto with = [&](auto change) {
    stack::Plane changed = plane;
    change(changed);
    return errorOf(drawn, SetPlanes{id, {changed, top}});
  };
  CHECK(errorOf(drawn, SetPlanes{id, {}}) == Error::StackInvalid);
  CHECK(errorOf(drawn, DrawStack{PictureId{99}, {plane}, rail, {}, {}}) == Error::NoSuchPicture);
  CHECK(errorOf(drawn, SetPlanes{id, std::vector<stack::Plane>(stack::kMostPlanes + 1, plane)}) ==
        Error::ValueOutOfRange);
  CHECK(with([](stack::Plane& p) { p.at = 1.5; }) == Error::ValueOutOfRange);
  CHECK(with([](stack::Plane& p) { p.turn.w = 2; }) == Error::ValueOutOfRange);
  CHECK(with([](stack::Plane& p) { p.curves[0].through[1].x = std::nan(""); }) == Error::ValueOutOfRange);
  CHECK(with([](stack::Plane& p) { p.curves[0].through.resize(2); }) == Error::ValueOutOfRange);
  CHECK(with([](stack::Plane& p) { p.curves[0].as = stack::CurveUse::kCount; }) == Error::ValueOutOfRange);
  CHECK(with([](stack::Plane& p) { p.curves[0].width = -1; }) == Error::ValueOutOfRange);
  CHECK(with([](stack::Plane& p) { p.curves[0].base = std::nan(""); }) == Error::ValueOutOfRange);
  stack::StackParams twice;
  twice.patterns = {{0, 1, 2, 0.5}};
  CHECK(errorOf(drawn, ShapeStack{id, twice}) == Error::StackInvalid);  // it goes beyond the rail
  twice.patterns = {{0, 0, 2, 0.5}};
  const Document repeated = after(drawn, {ShapeStack{id, twice}});
  CHECK(stackOf(*repeated.parts.back())->stack == twice);
  CHECK(errorOf(repeated, SetPlanes{id, {}}) == Error::StackInvalid);
  CHECK(with([](stack::Plane& p) { p.curves[0].corners.at = {4}; }) == Error::ValueOutOfRange);
  CHECK(with([](stack::Plane& p) { p.curves.resize(stack::kMostCurves + 1, p.curves[0]); }) == Error::ValueOutOfRange);
  CHECK(errorOf(drawn, SetRail{id, {{{0, std::nan(""), 0}}, false}}) == Error::ValueOutOfRange);
  CHECK(errorOf(drawn, ShapeStack{id, {sections::CapStyle::Flat, sections::CapStyle::Flat, 4, 6, {}, {}}}) ==
        Error::ValueOutOfRange);
}

TEST_CASE("a puff becomes a flat piece of the same region and back") {
  const Document document = everyKind();
  const PartId id = document.parts[1]->id;
  const Document flat = after(document, {ShapeRegion{id, extrude::ExtrudeParams{0.1}}});
  REQUIRE(extrudeOf(*findPart(flat, id)) != nullptr);
  CHECK(extrudeOf(*findPart(flat, id))->region == *regionOf(document.parts[1]->recipe));
  const Document back = after(flat, {ShapeRegion{id, inflateOf(document.parts[1])->inflate}});
  CHECK(back == document);
}

TEST_CASE("a region that is no region is refused with a sentence of its own") {
  const Document document = everyKind();
  const Region good = *regionOf(document.parts[1]->recipe);
  const auto errorFor = [&](auto change) {
    Region region = good;
    change(region);
    return errorOf(document, DrawRegion{region, inflate::InflateParams{}});
  };
  CHECK(errorFor([](Region& r) { r.contours.clear(); }) == Error::RegionEmpty);
  CHECK(errorFor([](Region& r) { r.contours = {{{1, 1}, {2, 2}}}; }) == Error::RegionEmpty);
  CHECK(errorFor([](Region& r) {
          for (PicturePoint& p : r.contours[0]) p.x += 1000;
        }) == Error::RegionOutside);
  CHECK(errorFor([](Region& r) { r.contours[0][0].x = std::nan(""); }) == Error::StrokeNotFinite);
  CHECK(errorFor([](Region& r) { r.contours[0][0].y = 1e9; }) == Error::StrokeNotFinite);
  CHECK(errorFor([](Region& r) { r.picture = PictureId{99}; }) == Error::NoSuchPicture);
  CHECK(errorFor([](Region& r) { r.ribbon = -1; }) == Error::ValueOutOfRange);
  CHECK(errorFor([](Region& r) { r.contours.resize(kMostContours + 1); }) == Error::ValueOutOfRange);
  CHECK(errorOf(document, DrawRegion{good, inflate::InflateParams{0}}) == Error::ValueOutOfRange);
  CHECK(errorOf(document, DrawRegion{good, extrude::ExtrudeParams{-1}}) == Error::ValueOutOfRange);
}

TEST_CASE("long names are cut between characters and empty ones replaced") {
  const Document document = onePart();
  const PartId id = document.parts[0]->id;
  std::string umlauts;
  for (int i = 0; i < 150; ++i) umlauts += "\xc3\xa4";
  const std::string cut = after(document, {RenamePart{id, "a" + umlauts}}).parts[0]->name;
  CHECK(cut.size() == 199);
  CHECK(cut.back() == '\xa4');
  CHECK(after(document, {RenamePart{id, ""}}).parts[0]->name == "Part 1");
}

TEST_CASE("undo all and redo all give back every document of random sessions") {
  int applied = 0, refused = 0, sessions = 0;
  for (const std::uint64_t seed : testing::seeds(0, 60)) {
    ++sessions;
    Rng rng(seed);
    History<Document> history;
    std::vector<Document> states = {history.present()};
    for (int step = 0; step < 40; ++step) {
      const Document before = history.present();
      const Result<Document> next = update(before, testing::randomAction(rng, before));
      REQUIRE(history.present() == before);
      if (!next) {
        ++refused;
        continue;
      }
      ++applied;
      history.commit(next.value());
      if (history.present() != before) states.push_back(history.present());
    }
    REQUIRE(history.undoSteps() == states.size() - 1);
    for (std::size_t i = states.size() - 1; i > 0; --i) {
      REQUIRE(history.present() == states[i]);
      REQUIRE(history.undo().ok());
    }
    REQUIRE(history.present() == states[0]);
    REQUIRE(history.undo().error() == Error::NothingToUndo);
    for (std::size_t i = 1; i < states.size(); ++i) {
      REQUIRE(history.redo().ok());
      REQUIRE(history.present() == states[i]);
    }
    REQUIRE(history.redo().error() == Error::NothingToRedo);
  }
  CHECK(applied > 15 * sessions);
  CHECK(2 * refused > 3 * sessions);
}

TEST_CASE("a commit after an undo forgets the future, and an equal commit is no step") {
  History<int> history(1);
  history.commit(2);
  history.commit(2);
  CHECK(history.undoSteps() == 1);
  CHECK(history.undo().ok());
  history.commit(3);
  CHECK(history.redoSteps() == 0);
  CHECK(history.redo().error() == Error::NothingToRedo);
  CHECK(history.undo().ok());
  CHECK(history.present() == 1);
}

TEST_CASE(
    "work is what somebody drew: a part, a stroke on paper, a scribble over edges; a picture or paper alone is none") {
  const PictureId first{1};
  const Document photo = after({}, {AddPicture{"cat.png", ellipsePicture(96, 72)}});
  const Document paper = after({}, {AddSketch{"", {200, 100}}});
  CHECK_FALSE(holdsWork({}));
  CHECK_FALSE(holdsWork(photo));
  CHECK_FALSE(holdsWork(paper));
  CHECK(holdsWork(onePart()));
  image::SketchStroke stroke;
  stroke.points = {{10, 10}, {90, 40}};
  CHECK(holdsWork(after(paper, {DrawOnSketch{first, stroke}})));
  const Document scribbled = after(photo, {IgnoreForPicture{first, {{kStroke, 3, false}}}});
  CHECK(holdsWork(scribbled));
  CHECK_FALSE(holdsWork(after(scribbled, {IgnoreForPicture{first, {}}})));
}

TEST_CASE("pictures with other pixels or sizes have other hashes") {
  const auto a = ellipsePicture(40, 30), b = ellipsePicture(40, 30, 1), c = ellipsePicture(30, 40);
  CHECK(contentHash(*a) == contentHash(*ellipsePicture(40, 30)));
  CHECK(contentHash(*a) != contentHash(*b));
  CHECK(contentHash(*a) != contentHash(*c));
}
