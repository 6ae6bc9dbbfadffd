#include "engine/document/checks.h"

#include <algorithm>
#include <cmath>

#include "engine/base/text.h"
#include "engine/descriptive/lines.h"
#include "engine/document/params.h"
#include "engine/document/pieces.h"
#include "engine/inflate/profile.h"
#include "engine/ribs/base/spine.h"

namespace spineloft::document {
namespace {

constexpr double kFarthest = 1e6;  // picture pixels: beyond it is no place that a hand means

}  // namespace

std::string fallbackName(const Part& part) {
  return (bridgeOf(part) ? "Bridge " : "Part ") + std::to_string(part.id.value);
}

std::string fallbackName(const Step& step) { return "Solid " + std::to_string(step.id.value); }
std::string fallbackName(const Group& group) { return "Group " + std::to_string(group.id.value); }

std::string fallbackName(const PictureEntry& entry) {
  return (entry.isSketch() ? "Sketch " : "Picture ") + std::to_string(entry.id.value);
}

std::string tidyName(std::string name, std::string_view fallback) {
  if (name.empty()) return std::string(fallback);
  name = validUtf8(std::move(name));
  if (name.size() <= kMaxNameBytes) return name;
  std::size_t end = kMaxNameBytes;
  while (end > 0 && (static_cast<unsigned char>(name[end]) & 0xc0) == 0x80) --end;
  name.resize(end);
  return name;
}

bool isValid(const ribs::IgnoreMark& mark) {
  constexpr double kLeastRadius = 0.5, kMostRadius = 500;  // picture pixels
  return !mark.stroke.empty() && mark.stroke.size() <= loft::kMostStrokePoints && mark.radius >= kLeastRadius &&
         mark.radius <= kMostRadius && std::ranges::all_of(mark.stroke, [](PicturePoint p) { return isFinite(p); });
}

bool isValid(std::span<const ribs::IgnoreMark> marks) {
  return marks.size() <= ribs::kMostIgnoreMarks &&
         std::ranges::all_of(marks, [](const ribs::IgnoreMark& mark) { return isValid(mark); });
}

Status checkStroke(const Document& document, const LoftRecipe& recipe) {
  const PictureEntry* entry = findPicture(document, recipe.picture);
  if (entry == nullptr) return Error::NoSuchPicture;
  const Result<ribs::Spine> spine = ribs::cleanSpine(recipe.stroke, entry->size, recipe.spine);
  if (!spine) return spine.failure();
  return Done{};
}

Status checkRegion(const Document& document, const Region& region) {
  const PictureEntry* entry = findPicture(document, region.picture);
  if (entry == nullptr) return Error::NoSuchPicture;
  const bool isRibbon = region.ribbon != 0;
  if (isRibbon && !(region.ribbon >= kLeastRibbon && region.ribbon <= kMostRibbon)) {
    return {Error::ValueOutOfRange, "the width of a line must be 0.5 … 2000 pixels"};
  }
  if (region.contours.size() > kMostContours)
    return {Error::ValueOutOfRange, "a part has at most " + std::to_string(kMostContours) + " outlines"};
  std::size_t points = 0;
  const std::size_t least = region.isOfLines() ? 2 : 3;
  bool any = false;
  PicturePoint low{kFarthest, kFarthest}, high{-kFarthest, -kFarthest};
  for (const auto& contour : region.contours) {
    points += contour.size();
    any = any || contour.size() >= least;
    for (const PicturePoint p : contour) {
      if (!isFinite(p) || std::abs(p.x) > kFarthest || std::abs(p.y) > kFarthest) {
        return Error::StrokeNotFinite;
      }
      low = {std::min(low.x, p.x), std::min(low.y, p.y)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
  }
  if (points > kMostRegionPoints)
    return {Error::ValueOutOfRange,
            "the outlines of a part have at most " + std::to_string(kMostRegionPoints) + " points"};
  if (!any) return Error::RegionEmpty;
  const bool onPicture =
      high.x >= -0.5 && high.y >= -0.5 && low.x <= entry->size.width - 0.5 && low.y <= entry->size.height - 0.5;
  if (!onPicture) return Error::RegionOutside;
  return Done{};
}

Status checkStack(const Document& document, const StackRecipe& recipe) {
  if (findPicture(document, recipe.picture) == nullptr) return Error::NoSuchPicture;
  return stack::checkPlanes(recipe.planes, recipe.rail, recipe.stack.patterns);
}

bool showsSide(const Document& document, PictureId picture, PictureId front) {
  using geometry::ViewFrom;
  const auto view = viewOn(document, picture, front);
  return view.ok() && view.value() && (view.value()->from == ViewFrom::Right || view.value()->from == ViewFrom::Left);
}

namespace {

Status checkOutline(const Document& document, PictureId front, const Outline& outline) {
  if (const auto view = viewOn(document, outline.picture, front); !view.ok()) return view.failure();
  if (outline.lines.empty() || outline.lines.size() > 2) {
    return {Error::ShapeInvalid, "an outline is one closed line or two open ones"};
  }
  const PictureEntry* entry = findPicture(document, outline.picture);
  std::size_t points = 0;
  bool onPicture = false;
  for (const auto& line : outline.lines) {
    if (line.size() < 2) return Error::RegionEmpty;
    points += line.size();
    for (const PicturePoint p : line) {
      if (!isFinite(p) || std::abs(p.x) > kFarthest || std::abs(p.y) > kFarthest) return Error::StrokeNotFinite;
      onPicture = onPicture ||
                  (p.x >= -0.5 && p.y >= -0.5 && p.x <= entry->size.width - 0.5 && p.y <= entry->size.height - 0.5);
    }
  }
  if (points > kMostOutlinePoints) return {Error::ValueOutOfRange, "too many points"};
  return onPicture ? Status(Done{}) : Status(Error::RegionOutside);
}

}  // namespace

Status checkView(const Document& document, PictureId picture, const PictureView& view) {
  const PictureEntry* front = findPicture(document, view.of);
  if (front == nullptr || findPicture(document, picture) == nullptr) return Error::NoSuchPicture;
  const bool ofSide = front->view || std::ranges::any_of(document.pictures, [&](const PictureEntry& entry) {
                        return entry.view && entry.view->of == picture;
                      });
  if (view.of == picture || ofSide) return Error::ViewInvalid;
  return geometry::isValid(view.view) ? Status(Done{}) : Status(Error::ValueOutOfRange, "view");
}

Status checkShape(const Document& document, const ShapeRecipe& recipe) {
  if (findPicture(document, recipe.picture) == nullptr) return Error::NoSuchPicture;
  if (!shape::isValid(recipe.shape)) return {Error::ValueOutOfRange, "shape"};
  if (recipe.outlines.size() > kMostOutlines) return {Error::ValueOutOfRange, "too many outlines"};
  for (const Outline& outline : recipe.outlines) {
    if (Status drawn = checkOutline(document, recipe.picture, outline); !drawn) return drawn;
    if (std::ranges::count(recipe.outlines, outline.picture, &Outline::picture) > 1) {
      return {Error::ShapeInvalid, "two outlines in one picture"};
    }
  }
  return Done{};
}

Status checkSide(const Document& document, const Recipe& recipe) {
  const std::optional<Outline>* side = sideOf(recipe);
  if (side == nullptr || !*side) return Done{};
  const PictureId front = pictureOf(recipe);
  if (!showsSide(document, (*side)->picture, front)) return Error::ViewInvalid;
  return checkOutline(document, front, **side);
}

Status checkBridge(const Document& document, const BridgeRecipe& recipe) {
  if (findPicture(document, recipe.picture) == nullptr) return Error::NoSuchPicture;
  if (!bridge::isValid(recipe.bridge)) return {Error::ValueOutOfRange, "bridge"};
  for (const BridgeEnd* end : {&recipe.from, &recipe.to}) {
    const bool many = end->rim.size() >= bridge::kLeastRimPoints && end->rim.size() <= bridge::kMostRimPoints;
    const auto isNear = [](ModelPoint p) {
      return isFinite(p) && std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}) <= kFarthest;
    };
    if (!many || !std::ranges::all_of(end->rim, isNear)) return {Error::ValueOutOfRange, "rim"};
  }
  return Done{};
}

Status checkRelief(const Document& document, const relief::Relief& relief) {
  if (relief.laid && findPicture(document, relief.laid->picture) == nullptr) return Error::NoSuchPicture;
  return relief::checkRelief(relief);
}

std::size_t dropUnseen(const Document& document, Part& part) {
  const bool gone = part.relief && part.relief->laid && !findPicture(document, part.relief->laid->picture);
  if (gone) part.relief.reset();
  return (gone ? 1 : 0) + dropUnseen(document, part.recipe);
}

std::size_t dropUnseen(const Document& document, Recipe& recipe) {
  std::optional<Outline>* side = sideOf(recipe);
  if (side != nullptr && *side && !showsSide(document, (*side)->picture, pictureOf(recipe))) {
    side->reset();
    return 1;
  }
  auto* shape = std::get_if<ShapeRecipe>(&recipe);
  if (shape == nullptr) return 0;
  return std::erase_if(shape->outlines,
                       [&](const Outline& outline) { return !viewOn(document, outline.picture, shape->picture).ok(); });
}

namespace {

// Extent of a line: a share of its picture's longer side, and picture pixels.
constexpr double kLeastLine = 0.001, kLeastLinePixels = 1;

Status checkLine(const DrawnLine& line, image::Size picture) {
  PicturePoint low{kFarthest, kFarthest}, high{-kFarthest, -kFarthest};
  for (const PicturePoint p : line.points) {
    if (!isFinite(p) || std::abs(p.x) > kFarthest || std::abs(p.y) > kFarthest) return Error::StrokeNotFinite;
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  const double least = std::max(kLeastLine * std::max(picture.width, picture.height), kLeastLinePixels);
  if (!(std::max(high.x - low.x, high.y - low.y) >= least)) return Error::StrokeTooShort;
  const bool onPicture =
      high.x >= -0.5 && high.y >= -0.5 && low.x <= picture.width - 0.5 && low.y <= picture.height - 0.5;
  if (!onPicture) return Error::StrokeOutsidePicture;
  const descriptive::Line plain{line.points, line.hidden, line.closed};
  const auto measured = descriptive::meetingLines({&plain, 1});
  return measured ? Status(Done{}) : Status(measured.failure());
}

}  // namespace

bool isDepth(double z) { return std::abs(z) <= kFarthest; }

bool isValid(const DrawnLine& line, image::Size picture) { return checkLine(line, picture).ok(); }

Status checkLines(const Document& document, const Drawing& drawing) {
  const PictureEntry* entry = findPicture(document, drawing.picture);
  if (entry == nullptr) return Error::NoSuchPicture;
  if (drawing.lines.size() > descriptive::kMostLines) return {Error::ValueOutOfRange, "too many lines"};
  std::size_t points = 0;
  for (const DrawnLine& line : drawing.lines) {
    if (Status drawn = checkLine(line, entry->size); !drawn) return drawn;
    points += line.points.size();
  }
  if (points > descriptive::kMostLinePoints) return {Error::ValueOutOfRange, "too many points"};
  return Done{};
}

Status checkDrawing(const Document& document, const Drawing& drawing) {
  if (Status lines = checkLines(document, drawing); !lines) return lines;
  if (std::max({drawing.pins.size(), drawing.folds.size(), drawing.orders.size()}) > kMostMarks) {
    return {Error::ValueOutOfRange, "too many pins, folds or orders"};
  }
  if (drawing.seenFrom >= descriptive::SeenFrom::kCount) return {Error::ValueOutOfRange, "seenFrom"};
  const auto isShare = [](double at) { return at >= 0 && at <= 1; };
  for (const auto& [line, at, z] : drawing.pins) {
    if (findLine(drawing, line) == nullptr) return Error::NoSuchLine;
    if (!isShare(at) || !isDepth(z)) return {Error::ValueOutOfRange, "pin"};
  }
  for (const auto& [line, at] : drawing.folds) {
    if (findLine(drawing, line) == nullptr) return Error::NoSuchLine;
    if (!isShare(at)) return {Error::ValueOutOfRange, "fold"};
  }
  for (const auto& [over, under, at] : drawing.orders) {
    if (over == under || !isFinite(at)) return {Error::ValueOutOfRange, "order"};
    for (const PartId id : {over, under}) {
      const Part* part = findPart(document, id);
      const ElementRecipe* element = part ? elementOf(*part) : nullptr;
      if (element == nullptr || element->drawing != drawing.id) return Error::NotAPiece;
    }
  }
  return Done{};
}

Status checkElement(const Document& document, const ElementRecipe& recipe) {
  const Drawing* drawing = findDrawing(document, recipe.drawing);
  if (drawing == nullptr) return Error::NoSuchLine;
  if (drawing->picture != recipe.picture) return Error::NoSuchPicture;
  if (recipe.outlines.empty()) return Error::RegionEmpty;
  if (recipe.kind >= descriptive::PieceKind::kCount) return {Error::ValueOutOfRange, "kind"};
  if (recipe.outlines.size() > kMostContours) return {Error::ValueOutOfRange, "too many outlines"};
  const Recipe whole = recipe;
  for (const ParamInfo& info : paramTable(PartKind::Element)) {
    const double value = info.get(whole);
    if (!(value >= info.low && value <= info.high)) return {Error::ValueOutOfRange, std::string(info.key)};
  }
  for (const LineOutline& outline : recipe.outlines) {
    if (outline.runs.empty()) return Error::RegionEmpty;
    if (outline.runs.size() > descriptive::kMostLines) return {Error::ValueOutOfRange, "too many lines"};
    for (const auto& [line, from, to] : outline.runs) {
      if (findLine(*drawing, line) == nullptr) return Error::NoSuchLine;
      if (!(from >= 0 && from <= 1 && to >= 0 && to <= 1 && from != to)) return {Error::ValueOutOfRange, "run"};
    }
  }
  return Done{};
}

Status checkSolid(const RegionSolid& solid) {
  if (!std::visit([](const auto& params) { return isValid(params); }, solid)) return Error::ValueOutOfRange;
  const auto* puff = std::get_if<inflate::InflateParams>(&solid);
  if (puff == nullptr || puff->profile.isSoft()) return Done{};
  const auto curves = inflate::matchedCurves(puff->profile.slices, puff->sides);
  return curves ? Status(Done{}) : Status(curves.failure());
}

Status checkDrawn(const Document& document, const Recipe& recipe) {
  if (Status side = checkSide(document, recipe); !side) return side;
  if (const auto* stack = std::get_if<StackRecipe>(&recipe)) return checkStack(document, *stack);
  if (const auto* shape = std::get_if<ShapeRecipe>(&recipe)) return checkShape(document, *shape);
  if (const auto* element = std::get_if<ElementRecipe>(&recipe)) return checkElement(document, *element);
  if (const auto* bridge = std::get_if<BridgeRecipe>(&recipe)) return checkBridge(document, *bridge);
  if (const Region* region = regionOf(recipe)) return checkRegion(document, *region);
  const auto* loft = std::get_if<LoftRecipe>(&recipe);
  return loft ? checkStroke(document, *loft) : Status(Error::NoSuchPart);
}

bool holdsWork(const Document& document) {
  return !document.parts.empty() || !document.drawings.empty() ||
         std::ranges::any_of(document.pictures,
                             [](const PictureEntry& entry) { return !entry.sketch.empty() || !entry.ignored.empty(); });
}

}  // namespace spineloft::document
