#include "engine/publish/share_model.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "engine/publish/share_copies.h"
#include "engine/publish/short_stroke.h"
#include "engine/ribs/edit/places.h"
#include "engine/ribs/edit/rib_frame.h"

namespace spineloft::publish {
namespace {

/// What outlines of ends are shortened for, characters, and the numbers of points that are tried: the first that fits.
constexpr std::size_t kMostPartText = 150;
constexpr std::array<std::size_t, 4> kFanPoints{ribs::kMostFanPoints, 5, 3, 1};

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

/// The nearest channel of 8 bits that one of 5 bits gives: a text tells it in half as many.
std::uint8_t coarse(std::uint64_t channel) {
  const std::uint64_t five = (channel * 31 + 127) / 255;
  return static_cast<std::uint8_t>(five * 8 + five / 4);
}

/// Of the places of the photo at the part's vertices, each channel at most 4 of 255 off; the look's own colour where
/// there are none.
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
  for (std::size_t c = 0; c < 3; ++c) mean[c] = coarse((sum[c] + count / 2) / count);
  return mean;
}

/// Characters of the text of a model of this name that is only this part of this photo.
std::size_t lengthAlone(const std::string& name, const document::PictureEntry& photo, document::Part part) {
  document::Document model;
  model.name = name;
  model.pictures.emplace_back(photo);
  model.parts.emplace_back(std::move(part));
  const Result<std::string> text = io::writeShareText(model);
  return text.ok() ? text.value().size() : std::numeric_limits<std::size_t>::max();
}

/// The outline of an end on its rib: none on a rib that is as good as a point, which is where the part ends; the middle
/// alone where that is not beyond the rib, at which a cap ends then (loft/caps.h).
std::vector<ribs::RibPoint> fixedFan(const ribs::EndFan& fan, const ribs::Rib& rib, bool atStart) {
  const ribs::RibFrame frame(rib.left, rib.right, atStart);
  if (fan.points.empty() || !(frame.unit() >= 1)) return {};
  ribs::RibEdits edits{.startFan = frame.fromPicture(fan.points)};
  if (!ribs::isValid(edits)) return {};
  const ribs::RibPoint middle = edits.startFan[edits.startFan.size() / 2];
  return middle.x > 0 ? std::move(edits.startFan) : std::vector{middle};
}

/// So many of the points, evenly; of an odd number with the middle one, at which a cap ends (loft/caps.h).
std::vector<ribs::RibPoint> someOf(const std::vector<ribs::RibPoint>& fan, std::size_t count) {
  if (fan.size() <= count) return fan;
  std::vector<ribs::RibPoint> some;
  for (std::size_t i = 1; i <= count; ++i) some.push_back(fan[(2 * i * (fan.size() + 1) / (count + 1) + 1) / 2 - 1]);
  return some;
}

/// Fixes what was found of a loft: its ends where they are, its outlines of both ends as they are if that makes at most
/// kMostPartText characters, else with a few of their points.
void fixLoft(const pipeline::PartShape& shape, image::Size photo, document::LoftRecipe& loft,
             const std::function<std::size_t(const document::LoftRecipe&)>& lengthOf) {
  const auto with = [&](const StrokeAndSpine& line) {
    document::LoftRecipe on = loft;
    on.stroke = line.stroke;
    on.edits = fixedEnds(shape, line.spine, loft.edits);
    return on;
  };
  loft = with(shortStroke({loft.stroke, shape.spine}, photo, loft.spine,
                          [&](const StrokeAndSpine& line) { return lengthOf(with(line)); }));
  const std::vector<ribs::RibPoint> start = fixedFan(shape.ribs.startFan, shape.ribs.ribs.front(), true),
                                    end = fixedFan(shape.ribs.endFan, shape.ribs.ribs.back(), false);
  for (const std::size_t points : kFanPoints) {
    loft.edits.startFan = someOf(start, points);
    loft.edits.endFan = someOf(end, points);
    if (lengthOf(loft) <= kMostPartText) return;
  }
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
    if (part.look.textured) {
      part.look.textured = copies.contains(entry->id);
      part.look.paint = surface::Paint::Plain;
      part.look.colour = meanColour(*shape, entry->picture->working, part.look.colour);
    }
    if (document::LoftRecipe* loft = document::loftOf(part)) {
      fixLoft(*shape, entry->size, *loft, [&](const document::LoftRecipe& recipe) {
        document::Part alone = part;
        alone.recipe = recipe;
        return lengthAlone(document.name, *entry, std::move(alone));
      });
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
