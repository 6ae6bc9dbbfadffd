#include "engine/document/document.h"

#include <algorithm>
#include <array>
#include <utility>

#include "engine/base/hash.h"
#include "engine/base/one_of_members.h"

namespace spineloft::document {
namespace {

template <class Recipe>
concept OfRegion = requires(Recipe recipe) { recipe.region; };

template <class T, class Id>
const Box<T>* boxOf(const std::vector<Box<T>>& boxes, Id id) {
  const auto at = std::ranges::find_if(boxes, [&](const T& value) { return value.id == id; });
  return at == boxes.end() ? nullptr : &*at;
}

template <class T>
std::size_t bytesOf(const std::vector<T>& values) {
  return values.size() * sizeof(T);
}
std::size_t bytesOf(const std::vector<ribs::IgnoreMark>& marks) {
  std::size_t bytes = marks.size() * sizeof(ribs::IgnoreMark);
  for (const ribs::IgnoreMark& mark : marks) bytes += bytesOf(mark.stroke);
  return bytes;
}
std::size_t bytesOf(const image::SketchStroke& stroke) {
  return sizeof(stroke) + bytesOf(stroke.points) + bytesOf(stroke.pressure);
}

std::size_t bytesOf(const Region& region) {
  std::size_t bytes = bytesOf<std::vector<PicturePoint>>(region.contours);
  for (const auto& contour : region.contours) bytes += bytesOf(contour);
  return bytes;
}

// What a recipe holds beyond its own size.
std::size_t heldBy(const std::optional<Outline>& side) {
  std::size_t bytes = 0;
  if (!side) return bytes;
  for (const auto& line : side->lines) bytes += sizeof(line) + bytesOf(line);
  return bytes;
}
std::size_t heldBy(const LoftRecipe& recipe) {
  std::size_t bytes = heldBy(recipe.side) + bytesOf(recipe.stroke) + bytesOf(recipe.edits.ends) +
                      bytesOf(recipe.edits.added) + bytesOf(recipe.edits.removed) + bytesOf(recipe.edits.startFan) +
                      bytesOf(recipe.edits.endFan) + bytesOf(recipe.ignored) + bytesOf(recipe.pose.stroke) +
                      bytesOf(recipe.pose.depth.points);
  const loft::LoftParams& loft = recipe.loft;
  for (const auto* curve : {&loft.twist, &loft.squash, &loft.tilt, &loft.bulge}) {
    bytes += bytesOf(curve->points);
  }
  for (const loft::SectionKey& key : loft.sections) {
    bytes += sizeof(key) + bytesOf(key.blend.custom.points);
    for (const auto& contour : key.shape.contours) bytes += sizeof(contour) + bytesOf(contour);
  }
  return bytes;
}
std::size_t heldBy(const StackRecipe& recipe) {
  std::size_t bytes = bytesOf(recipe.planes) + bytesOf(recipe.rail.points) + bytesOf(recipe.stack.patterns);
  for (const stack::Plane& plane : recipe.planes) {
    bytes += bytesOf(plane.curves) + bytesOf(plane.blend.custom.points) + bytesOf(plane.links);
    for (const stack::Curve& curve : plane.curves) bytes += bytesOf(curve.through) + bytesOf(curve.corners.at);
  }
  return bytes;
}
std::size_t heldBy(const InflateRecipe& recipe) {
  const inflate::ProfileParams& profile = recipe.inflate.profile;
  const inflate::BoneEdits& bones = recipe.inflate.bones;
  std::size_t bytes = heldBy(recipe.side) + bytesOf(recipe.region) + bytesOf(profile.slices) + bytesOf(bones.drop) +
                      bytesOf(bones.add) + bytesOf(bones.move) + bytesOf(bones.heights);
  for (const auto& slice : profile.slices) {
    for (const auto& contour : slice.shape.contours) bytes += sizeof(contour) + bytesOf(contour);
  }
  for (const auto& line : bones.add) bytes += bytesOf(line);
  return bytes;
}
std::size_t heldBy(const ShapeRecipe& recipe) {
  std::size_t bytes = bytesOf(recipe.outlines);
  for (const Outline& outline : recipe.outlines) {
    for (const auto& line : outline.lines) bytes += sizeof(line) + bytesOf(line);
  }
  if (!recipe.shape.section) return bytes;
  for (const auto& contour : recipe.shape.section->contours) bytes += sizeof(contour) + bytesOf(contour);
  return bytes;
}
std::size_t heldBy(const ElementRecipe& recipe) {
  std::size_t bytes = bytesOf(recipe.outlines);
  for (const LineOutline& outline : recipe.outlines) bytes += bytesOf(outline.runs);
  return bytes;
}
std::size_t heldBy(const BridgeRecipe& recipe) { return bytesOf(recipe.from.rim) + bytesOf(recipe.to.rim); }
template <OfRegion Recipe>
std::size_t heldBy(const Recipe& recipe) {
  return bytesOf(recipe.region);
}

std::size_t bytesOf(const Part& part) {
  std::size_t pulls = bytesOf(part.pulls);
  for (const pull::Pull& pull : part.pulls) {
    for (const auto* line : {&pull.line, &pull.to, &pull.ring, &pull.across, &pull.acrossTo}) pulls += bytesOf(*line);
  }
  const std::size_t relief = part.relief ? bytesOf(part.relief->region) : 0;
  return sizeof(Part) + part.name.size() + part.extra.size() + pulls + relief +
         std::visit([](const auto& recipe) { return heldBy(recipe); }, part.recipe);
}

std::size_t bytesOf(const Drawing& drawing) {
  std::size_t bytes = sizeof(Drawing) + drawing.extra.size() + bytesOf(drawing.lines) + bytesOf(drawing.pins) +
                      bytesOf(drawing.folds) + bytesOf(drawing.orders);
  for (const DrawnLine& line : drawing.lines) bytes += bytesOf(line.points) + bytesOf(line.hidden);
  return bytes;
}

/// `before` is the same entry in the other document, or null.
std::size_t bytesBeyond(const PictureEntry* before, const PictureEntry& entry) {
  std::size_t bytes = sizeof(PictureEntry) + entry.name.size() + entry.extra.size() +
                      entry.sketch.size() * sizeof(entry.sketch[0]) + bytesOf(entry.ignored);
  if (entry.picture && (before == nullptr || before->picture != entry.picture)) {
    bytes += entry.picture->working.pixels.size();
  }
  // Strokes are only ever appended, so that an old one stands where it stood.
  for (std::size_t i = 0; i < entry.sketch.size(); ++i) {
    const bool shared = before != nullptr && i < before->sketch.size() && before->sketch[i].shares(entry.sketch[i]);
    if (!shared) bytes += bytesOf(entry.sketch[i].get());
  }
  return bytes;
}

constexpr std::array<std::string_view, static_cast<std::size_t>(PartKind::kCount)> kKindKeys = {
    "loft", "puff", "sheet", "lathe", "stack", "shape", "element", "bridge"};

}  // namespace

bool operator==(const Recipe& a, const Recipe& b) {
  return static_cast<const AnyRecipe&>(a) == static_cast<const AnyRecipe&>(b);
}

std::string_view kindKey(PartKind kind) {
  const auto at = static_cast<std::size_t>(kind);
  return at < kKindKeys.size() ? kKindKeys[at] : std::string_view();
}

PartKind kindFromKey(std::string_view key) {
  return static_cast<PartKind>(std::ranges::find(kKindKeys, key) - kKindKeys.begin());
}

Recipe emptyRecipe(PartKind kind) {
  switch (kind) {
    case PartKind::Inflate:
      return InflateRecipe{};
    case PartKind::Extrude:
      return ExtrudeRecipe{};
    case PartKind::Lathe:
      return LatheRecipe{};
    case PartKind::Stack:
      return StackRecipe{};
    case PartKind::Shape:
      return ShapeRecipe{};
    case PartKind::Element:
      return ElementRecipe{};
    case PartKind::Bridge:
      return BridgeRecipe{};
    case PartKind::Loft:
    case PartKind::kCount:
      break;
  }
  return LoftRecipe{};
}

const LoftRecipe& loftIn(const Part& part) {
  static const LoftRecipe kNone;
  const LoftRecipe* loft = loftOf(part);
  return loft ? *loft : kNone;
}

const Region* regionOf(const Recipe& recipe) {
  return std::visit(
      []<class One>(const One& one) -> const Region* {
        if constexpr (OfRegion<One>) return &one.region;
        return nullptr;
      },
      recipe);
}
Region* regionOf(Recipe& recipe) {
  return const_cast<Region*>(regionOf(std::as_const(recipe)));  // what it is given is not const
}

const std::optional<Outline>* sideOf(const Recipe& recipe) {
  if (const auto* loft = std::get_if<LoftRecipe>(&recipe)) return &loft->side;
  const auto* puff = std::get_if<InflateRecipe>(&recipe);
  return puff ? &puff->side : nullptr;
}
std::optional<Outline>* sideOf(Recipe& recipe) {
  return const_cast<std::optional<Outline>*>(sideOf(std::as_const(recipe)));
}

std::vector<const Outline*> outlinesOf(const Recipe& recipe) {
  std::vector<const Outline*> outlines;
  if (const auto* shape = std::get_if<ShapeRecipe>(&recipe)) {
    for (const Outline& outline : shape->outlines) outlines.push_back(&outline);
  }
  const std::optional<Outline>* side = sideOf(recipe);
  if (side != nullptr && *side) outlines.push_back(&**side);
  return outlines;
}
std::vector<Outline*> outlinesOf(Recipe& recipe) {
  std::vector<Outline*> outlines;
  for (const Outline* outline : outlinesOf(std::as_const(recipe))) outlines.push_back(const_cast<Outline*>(outline));
  return outlines;
}

PictureId pictureOf(const Recipe& recipe) {
  if (const Region* region = regionOf(recipe)) return region->picture;
  if (const auto* stack = std::get_if<StackRecipe>(&recipe)) return stack->picture;
  if (const auto* shape = std::get_if<ShapeRecipe>(&recipe)) return shape->picture;
  if (const auto* element = std::get_if<ElementRecipe>(&recipe)) return element->picture;
  if (const auto* bridge = std::get_if<BridgeRecipe>(&recipe)) return bridge->picture;
  const auto* loft = std::get_if<LoftRecipe>(&recipe);
  return loft ? loft->picture : PictureId{};
}
void setPicture(Recipe& recipe, PictureId picture) {
  if (Region* region = regionOf(recipe)) region->picture = picture;
  if (auto* loft = std::get_if<LoftRecipe>(&recipe)) loft->picture = picture;
  if (auto* stack = std::get_if<StackRecipe>(&recipe)) stack->picture = picture;
  if (auto* shape = std::get_if<ShapeRecipe>(&recipe)) shape->picture = picture;
  if (auto* element = std::get_if<ElementRecipe>(&recipe)) element->picture = picture;
  if (auto* bridge = std::get_if<BridgeRecipe>(&recipe)) bridge->picture = picture;
}

const PictureEntry* findPicture(const Document& document, PictureId id) {
  const auto at = std::ranges::find_if(document.pictures, [&](const PictureEntry& entry) { return entry.id == id; });
  return at == document.pictures.end() ? nullptr : &at->get();
}

const Part* findPart(const Document& document, PartId id) {
  const auto at = std::ranges::find_if(document.parts, [&](const Part& part) { return part.id == id; });
  return at == document.parts.end() ? nullptr : &at->get();
}

const Drawing* findDrawing(const Document& document, DrawingId id) {
  const auto at = std::ranges::find_if(document.drawings, [&](const Drawing& drawing) { return drawing.id == id; });
  return at == document.drawings.end() ? nullptr : &at->get();
}

const Group* findGroup(const Document& document, GroupId id) {
  const auto at = std::ranges::find(document.groups, id, &Group::id);
  return at == document.groups.end() ? nullptr : &*at;
}

std::vector<PartId> bridgesOn(const Document& document, PartId id) {
  std::vector<PartId> bridges;
  for (const Part& part : document.parts) {
    const BridgeRecipe* bridge = bridgeOf(part);
    if (bridge != nullptr && (bridge->from.part == id || bridge->to.part == id)) bridges.push_back(part.id);
  }
  return bridges;
}
std::vector<PartId> partsOfGroup(const Document& document, GroupId id) {
  std::vector<PartId> parts;
  for (const Part& part : document.parts) {
    if (id && part.group == id) parts.push_back(part.id);
  }
  return parts;
}

std::size_t bytesBeyond(const Document& base, const Document& next) {
  std::size_t bytes =
      sizeof(Document) + next.name.size() + next.extra.size() +
      (next.pictures.size() + next.drawings.size() + next.parts.size() + next.steps.size()) * sizeof(Box<Part>);
  for (const Group& group : next.groups) bytes += sizeof(Group) + group.name.size();
  for (const Box<Part>& part : next.parts) {
    const Box<Part>* before = boxOf(base.parts, part->id);
    if (before == nullptr || !before->shares(part)) bytes += bytesOf(*part);
  }
  for (const Box<Drawing>& drawing : next.drawings) {
    const Box<Drawing>* before = boxOf(base.drawings, drawing->id);
    if (before == nullptr || !before->shares(drawing)) bytes += bytesOf(*drawing);
  }
  for (const Box<Step>& step : next.steps) {
    const Box<Step>* before = boxOf(base.steps, step->id);
    if (before == nullptr || !before->shares(step)) {
      bytes += sizeof(Step) + step->name.size() + step->extra.size() + bytesOf(step->operands);
    }
  }
  for (const Box<PictureEntry>& entry : next.pictures) {
    const Box<PictureEntry>* before = boxOf(base.pictures, entry->id);
    if (before != nullptr && before->shares(entry)) continue;
    bytes += bytesBeyond(before == nullptr ? nullptr : &before->get(), *entry);
  }
  return bytes;
}

Result<std::optional<geometry::View>> viewOn(const Document& document, PictureId picture, PictureId front) {
  if (picture == front) return std::optional<geometry::View>();
  const PictureEntry* entry = findPicture(document, picture);
  if (entry == nullptr || !entry->view || entry->view->of != front) return Error::ViewInvalid;
  return std::optional(entry->view->view);
}

std::uint64_t contentHash(const image::Picture& picture) {
  return Hasher()
      .number(picture.width)
      .number(picture.height)
      .number(picture.working.width)
      .number(picture.working.height)
      .bytes(std::as_bytes(std::span(picture.working.pixels)))
      .value();
}

std::uint64_t contentHash(image::Size size, std::span<const Box<image::SketchStroke>> sketch) {
  Hasher hasher;
  hasher.text("sketch").number(size.width).number(size.height).number(sketch.size());
  for (const image::SketchStroke& stroke : sketch) {
    const auto& [points, pressure, radius, erase, colour] = stroke;
    hasher.number(points.size()).number(pressure.size()).number(radius).number(erase);
    for (const PicturePoint& p : points) hasher.number(p.x).number(p.y);
    for (const float value : pressure) hasher.number(value);
    for (const std::uint8_t value : colour) hasher.number(value);
  }
  return hasher.value();
}

}  // namespace spineloft::document

template struct spineloft::OneOf<spineloft::document::AnyRecipe>;
template struct spineloft::Movers<spineloft::document::AnyRecipe>;
