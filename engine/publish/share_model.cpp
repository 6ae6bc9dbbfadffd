#include "engine/publish/share_model.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "engine/publish/share_copies.h"
#include "engine/publish/short_stroke.h"
#include "engine/ribs/edit/places.h"

namespace spineloft::publish {
namespace {

/// Both ends of every rib where they are, all left ones first: each line of ends is told from one to the next. `spine`
/// is close to that of the shape, and a rib on a point of the one is on the same point of the other.
ribs::RibEdits fixedEnds(const pipeline::PartShape& shape, const ribs::Spine& spine, const ribs::RibEdits& edits) {
  std::vector<double> places = ribs::ribPlaces(ribs::Ruler(shape.spine.points), shape.spine, shape.ribs);
  const ribs::Ruler ruler(spine.points);
  for (std::size_t i = 0; i < std::min({places.size(), spine.points.size(), shape.spine.points.size()}); ++i) {
    if (shape.spine.points[i] == shape.ribs.ribs[i].center) places[i] = ruler.placeOfPoint(i);
  }
  ribs::RibEdits fixed = edits;
  fixed.ends.clear();
  for (const ribs::Side side : {ribs::Side::Left, ribs::Side::Right}) {
    for (std::size_t i = 0; i < places.size(); ++i) {
      const ribs::Rib& rib = shape.ribs.ribs[i];
      const bool left = side == ribs::Side::Left;
      ribs::EndEdit end{.at = places[i], .side = side};
      end.locked = (left ? rib.leftState : rib.rightState) == ribs::RibState::Locked;
      ruler.toFrame(left ? rib.left : rib.right, end);
      fixed.ends.push_back(end);
    }
  }
  return fixed;
}

/// Of the places of the photo at the part's vertices; the look's own colour where there are none.
std::array<std::uint8_t, 3> meanColour(const pipeline::PartShape& shape, const image::Image& photo,
                                       std::array<std::uint8_t, 3> otherwise) {
  std::array<std::uint64_t, 3> sum{};
  std::uint64_t count = 0;
  for (const auto& uv : shape.mesh.uv) {
    const int x = std::clamp(static_cast<int>(uv[0] * static_cast<float>(photo.width)), 0, photo.width - 1);
    const int y = std::clamp(static_cast<int>(uv[1] * static_cast<float>(photo.height)), 0, photo.height - 1);
    const auto at =
        4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(photo.width) + static_cast<std::size_t>(x));
    for (std::size_t c = 0; c < 3; ++c) sum[c] += photo.pixels[at + c];
    ++count;
  }
  if (count == 0) return otherwise;
  std::array<std::uint8_t, 3> mean{};
  for (std::size_t c = 0; c < 3; ++c) mean[c] = static_cast<std::uint8_t>((sum[c] + count / 2) / count);
  return mean;
}

/// Characters of the text of a model with only this part, on paper instead of its photo.
std::size_t lengthAlone(const document::PictureEntry& photo, document::LoftRecipe recipe) {
  document::PictureEntry paper;
  paper.id = photo.id;
  paper.size = photo.size;
  document::Part part;
  part.recipe = std::move(recipe);
  document::Document model;
  model.pictures.emplace_back(std::move(paper));
  model.parts.emplace_back(std::move(part));
  const Result<std::string> text = io::writeShareText(model);
  return text.ok() ? text.value().size() : std::numeric_limits<std::size_t>::max();
}

/// withoutPhotos, but that parts go on to show photos of which there are copies.
document::Document fixed(const document::Document& document, const pipeline::Derived& derived,
                         const io::PhotoCopies& copies) {
  document::Document out = document;
  for (std::size_t i = 0; i < out.parts.size() && i < derived.parts.size(); ++i) {
    document::Part part = out.parts[i].get();
    const document::PictureEntry* entry = document::findPicture(document, document::pictureOf(part));
    const auto& shape = derived.parts[i].shape;
    if (entry == nullptr || entry->isSketch() || !shape) continue;
    if (document::LoftRecipe* loft = document::loftOf(part)) {
      const auto lengthOf = [&](const StrokeAndSpine& line) {
        document::LoftRecipe on = *loft;
        on.stroke = line.stroke;
        on.edits = fixedEnds(*shape, line.spine, loft->edits);
        return lengthAlone(*entry, std::move(on));
      };
      StrokeAndSpine shorter = shortStroke({loft->stroke, shape->spine}, entry->size, loft->spine, lengthOf);
      loft->edits = fixedEnds(*shape, shorter.spine, loft->edits);
      loft->stroke = std::move(shorter.stroke);
    }
    if (part.look.textured) {
      part.look.textured = copies.contains(entry->id);
      part.look.paint = surface::Paint::Plain;
      part.look.colour = meanColour(*shape, entry->picture->working, part.look.colour);
    }
    out.parts[i] = std::move(part);
  }
  return out;
}

}  // namespace

document::Document withoutPhotos(const document::Document& document, const pipeline::Derived& derived) {
  return fixed(document, derived, {});
}

Result<SharedModel> shareModel(const document::Document& document, const pipeline::Derived& derived) {
  return shareModel(document, derived, {});
}

Result<SharedModel> shareModel(const document::Document& document, const pipeline::Derived& derived,
                               const io::PhotoCopies& copies) {
  Result<std::string> text = io::writeShareText(fixed(document, derived, copies), copies);
  if (!text.ok()) return text.failure();
  SharedModel shared{std::move(text).value()};
  for (const document::PictureEntry& entry : document.pictures)
    shared.photosLeft += !entry.isSketch() && !copies.contains(entry.id);
  return shared;
}

}  // namespace spineloft::publish
