#include "engine/document/document.h"

#include <algorithm>

#include "engine/base/hash.h"

namespace spineloft::document {
namespace {

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

std::size_t bytesOf(const Part& part) {
  const LoftRecipe& recipe = part.recipe;
  std::size_t bytes = sizeof(Part) + part.name.size() + part.extra.size() +
                      bytesOf(recipe.stroke) + bytesOf(recipe.edits.ends) +
                      bytesOf(recipe.edits.added) + bytesOf(recipe.edits.removed) +
                      bytesOf(recipe.ignored) + bytesOf(recipe.pose.stroke) +
                      bytesOf(recipe.pose.depth.points);
  const loft::LoftParams& loft = recipe.loft;
  for (const auto* curve : {&loft.twist, &loft.squash, &loft.tilt, &loft.bulge}) {
    bytes += bytesOf(curve->points);
  }
  for (const loft::SectionStop& stop : loft.sections) {
    bytes += sizeof(stop) + bytesOf(stop.blend.custom.points);
    for (const auto& contour : stop.shape.contours) bytes += sizeof(contour) + bytesOf(contour);
  }
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
    const bool shared = before != nullptr && i < before->sketch.size() &&
                        before->sketch[i].shares(entry.sketch[i]);
    if (!shared) bytes += bytesOf(entry.sketch[i].get());
  }
  return bytes;
}

}  // namespace

const PictureEntry* findPicture(const Document& document, PictureId id) {
  const auto at = std::ranges::find_if(
      document.pictures, [&](const PictureEntry& entry) { return entry.id == id; });
  return at == document.pictures.end() ? nullptr : &at->get();
}

const Part* findPart(const Document& document, PartId id) {
  const auto at = std::ranges::find_if(document.parts,
                                       [&](const Part& part) { return part.id == id; });
  return at == document.parts.end() ? nullptr : &at->get();
}

std::size_t bytesBeyond(const Document& base, const Document& next) {
  std::size_t bytes = sizeof(Document) + next.name.size() + next.extra.size() +
                      (next.pictures.size() + next.parts.size() + next.steps.size()) * sizeof(Box<Part>);
  for (const Box<Part>& part : next.parts) {
    const Box<Part>* before = boxOf(base.parts, part->id);
    if (before == nullptr || !before->shares(part)) bytes += bytesOf(*part);
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
