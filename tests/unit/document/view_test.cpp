// Pictures that are sides of others, and shapes with outlines in them.
#include <doctest/doctest.h>

#include <cmath>

#include "engine/document/checks.h"
#include "engine/document/renumber.h"
#include "engine/document/update.h"
#include "tests/support/after.h"
#include "tests/support/random_documents.h"

using namespace spineloft;
using namespace spineloft::document;
using namespace spineloft::testing;

namespace {

constexpr PictureId kFront{1}, kSide{2}, kOther{3};
const PictureView kRight{kFront, {geometry::ViewFrom::Right, 60, 1, 0}};

Document threeSheets() {
  const AddSketch sheet{"sheet", {120, 80}};
  return after({}, {sheet, sheet, sheet});
}
Outline triangle(PictureId picture) { return {picture, {{{60, 10}, {90, 70}, {30, 70}}}}; }

}  // namespace

TEST_CASE("a picture is the side of one that is no side, and of no other") {
  const Document document = after(threeSheets(), {SetView{kSide, kRight}});
  CHECK(document.pictures[1]->view == kRight);
  CHECK(viewOn(document, kSide, kFront).value() == kRight.view);
  CHECK_FALSE(viewOn(document, kFront, kFront).value().has_value());
  CHECK(viewOn(document, kOther, kFront).error() == Error::ViewInvalid);
  CHECK(errorOf(document, SetView{kSide, PictureView{kSide, {}}}) == Error::ViewInvalid);    // of itself
  CHECK(errorOf(document, SetView{kOther, PictureView{kSide, {}}}) == Error::ViewInvalid);   // of a side
  CHECK(errorOf(document, SetView{kFront, PictureView{kOther, {}}}) == Error::ViewInvalid);  // which has sides
  CHECK(errorOf(document, SetView{kOther, PictureView{PictureId{9}, {}}}) == Error::NoSuchPicture);
  CHECK(errorOf(document, SetView{PictureId{9}, kRight}) == Error::NoSuchPicture);
  PictureView wrong = kRight;
  wrong.view.scale = std::nan("");
  CHECK(errorOf(document, SetView{kOther, wrong}) == Error::ValueOutOfRange);
  CHECK_FALSE(after(document, {SetView{kSide, std::nullopt}}).pictures[1]->view);
}

TEST_CASE("a shape keeps what was drawn, and refuses what is none") {
  const Document document = after(threeSheets(), {SetView{kSide, kRight}, DrawShape{kFront, {}, {triangle(kFront)}}});
  const PartId id = document.parts.back()->id;
  REQUIRE(shapeOf(*document.parts.back()) != nullptr);
  CHECK(*shapeOf(*document.parts.back()) == ShapeRecipe{kFront, {}, {triangle(kFront)}});
  const Document both = after(document, {SetOutlines{id, {triangle(kFront), triangle(kSide)}}});
  CHECK(shapeOf(*both.parts.back())->outlines.size() == 2);
  shape::ShapeParams cone;
  cone.primitive = shape::Primitive::Cone;
  CHECK(shapeOf(*after(both, {SetShape{id, cone}}).parts.back())->shape == cone);
  cone.width = -1;
  CHECK(errorOf(both, SetShape{id, cone}) == Error::ValueOutOfRange);
  const auto drawn = [&](std::vector<Outline> outlines) { return errorOf(both, SetOutlines{id, std::move(outlines)}); };
  CHECK(drawn({triangle(kOther)}) == Error::ViewInvalid);
  CHECK(drawn({triangle(kFront), triangle(kFront)}) == Error::ShapeInvalid);
  CHECK(drawn({Outline{kFront, {}}}) == Error::ShapeInvalid);
  CHECK(drawn({Outline{kFront, {{{1, 1}}}}}) == Error::RegionEmpty);
  CHECK(drawn({Outline{kFront, {{{1, 1}, {std::nan(""), 5}, {9, 9}}}}}) == Error::StrokeNotFinite);
  CHECK(drawn({Outline{kFront, {{{1e9, 1}, {3, 5}, {9, 9}}}}}) == Error::StrokeNotFinite);
  CHECK(drawn({Outline{kFront, {{{500, 500}, {600, 500}, {600, 600}}}}}) == Error::RegionOutside);
  CHECK(errorOf(both, DrawShape{PictureId{9}}) == Error::NoSuchPicture);
  CHECK(errorOf(both, SetPlanes{id, {}}) == Error::NotAStack);
  const Document loft = after(both, {DrawSpine{kFront, {{20, 40}, {100, 40}}}});
  CHECK(errorOf(loft, SetOutlines{loft.parts.back()->id, {}}) == Error::NotAShape);
}

TEST_CASE("lofts and puffs keep an outline from the right or the left, and no other") {
  const Region square{kFront, {{{30, 10}, {90, 10}, {90, 70}, {30, 70}}}};
  const Document document = after(threeSheets(), {SetView{kSide, kRight}, DrawSpine{kFront, {{60, 10}, {60, 70}}},
                                                  DrawRegion{square, inflate::InflateParams{}}});
  for (const Part& part : document.parts) {
    const Document sided = after(document, {SetSide{part.id, triangle(kSide)}});
    const auto side = [&](const Document& d) { return *sideOf(findPart(d, part.id)->recipe); };
    CHECK(side(sided) == triangle(kSide));
    CHECK(after(sided, {SetSide{part.id, std::nullopt}}).parts == document.parts);
    CHECK(errorOf(document, SetSide{part.id, triangle(kFront)}) == Error::ViewInvalid);
    CHECK(errorOf(document, SetSide{part.id, triangle(kOther)}) == Error::ViewInvalid);
    CHECK(errorOf(document, SetSide{part.id, Outline{kSide, {}}}) == Error::ShapeInvalid);
    CHECK(errorOf(document, SetSide{part.id, Outline{kSide, {{{std::nan(""), 1}, {2, 2}}}}}) == Error::StrokeNotFinite);
    CHECK_FALSE(side(after(sided, {SetView{kSide, std::nullopt}})));
    CHECK_FALSE(side(after(sided, {SetView{kSide, PictureView{kFront, {geometry::ViewFrom::Top, 60, 1, 0}}}})));
    CHECK_FALSE(side(after(sided, {RemovePicture{kSide}})));
    CHECK(side(after(sided, {SetView{kSide, PictureView{kFront, {geometry::ViewFrom::Left, 50, 1, 0}}}})));
    Document renumbered = after(sided, {RemovePicture{kOther}});
    renumber(renumbered);
    CHECK(side(renumbered) == triangle(kSide));
  }
  const PartId puff = document.parts.back()->id;
  const Document sided = after(document, {SetSide{puff, triangle(kSide)}});
  inflate::InflateParams thick;
  thick.height = 2;
  // A puff that stays one keeps it; what is something else has none.
  CHECK(inflateOf(*after(sided, {ShapeRegion{puff, thick}}).parts.back())->side == triangle(kSide));
  CHECK(inflateOf(*after(sided, {RedrawRegion{puff, square}}).parts.back())->side == triangle(kSide));
  const Document flat = after(sided, {ShapeRegion{puff, extrude::ExtrudeParams{}}});
  CHECK(sideOf(flat.parts.back()->recipe) == nullptr);
  CHECK(errorOf(flat, SetSide{puff, triangle(kSide)}) == Error::TakesNoSide);
}

TEST_CASE("outlines go with the view that they are drawn in") {
  const Document document = after(threeSheets(), {SetView{kSide, kRight}, SetView{kOther, kRight},
                                                  DrawShape{kFront, {}, {triangle(kFront), triangle(kSide)}}});
  const auto outlines = [](const Document& d) { return shapeOf(*d.parts.back())->outlines; };
  CHECK(outlines(after(document, {SetView{kSide, std::nullopt}})) == std::vector{triangle(kFront)});
  CHECK(outlines(after(document, {RemovePicture{kSide}})) == std::vector{triangle(kFront)});
  const Document alone = after(document, {RemovePicture{kFront}});
  CHECK(alone.parts.empty());
  for (const PictureEntry& entry : alone.pictures) CHECK_FALSE(entry.view);
  // Renumbered, all of it means the same.
  Document renumbered = after(document, {RemovePicture{kOther}});
  Document moved = after(threeSheets(), {RemovePicture{kFront}, SetView{kOther, PictureView{kSide, kRight.view}},
                                         DrawShape{kSide, {}, {triangle(kSide), triangle(kOther)}}});
  renumber(renumbered);
  renumber(moved);
  CHECK(outlines(moved) == outlines(renumbered));
  CHECK(moved.pictures[1]->view == renumbered.pictures[1]->view);
}
