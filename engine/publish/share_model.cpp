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

#include "engine/publish/end_outline.h"
#include "engine/publish/share_copies.h"
#include "engine/publish/short_stroke.h"
#include "engine/ribs/edit/places.h"
#include "engine/ribs/edit/rib_frame.h"

namespace spineloft::publish {
namespace {

/// Where the text of a part would be longer, the outlines of its ends are told by less.
constexpr std::size_t kMostPartText = 150;

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

/// A part of a photo as the only one of its model, in a text.
struct Alone {
  std::string name;
  document::PictureEntry photo;
  document::Part part;

  document::Document model(const document::LoftRecipe& recipe) const {
    document::Part with = part;
    with.recipe = recipe;
    document::Document alone;
    alone.name = name;
    alone.pictures.emplace_back(photo);
    alone.parts.emplace_back(std::move(with));
    return alone;
  }
  /// Characters.
  std::size_t lengthOf(const document::LoftRecipe& recipe) const {
    const Result<std::string> text = io::writeShareText(model(recipe));
    return text.ok() ? text.value().size() : std::numeric_limits<std::size_t>::max();
  }
  /// The recipe as it comes back.
  document::LoftRecipe kept(const document::LoftRecipe& recipe) const {
    document::Document back = io::shareable(model(recipe));
    if (back.parts.size() != 1) return recipe;
    document::Part read = back.parts[0].get();
    const document::LoftRecipe* loft = document::loftOf(read);
    return loft != nullptr ? *loft : recipe;
  }
};

/// The outermost ribs of an end where the ends of ribs are told as fixedEnds has them, and as they were found.
EndRibs toldRibs(const ribs::Ruler& ruler, const std::vector<ribs::EndEdit>& ends, bool atStart) {
  const std::size_t count = ends.size() / 2, last = atStart ? 0 : count - 1, before = atStart ? 1 : count - 2;
  const auto chord = [&](std::size_t rib) {
    return RibEnds{ruler.fromFrame(ends[rib]), ruler.fromFrame(ends[count + rib])};
  };
  return {chord(last), chord(before), atStart};
}
EndRibs foundRibs(const std::vector<ribs::Rib>& ribs, bool atStart) {
  const auto chord = [](const ribs::Rib& rib) { return RibEnds{rib.left, rib.right}; };
  return atStart ? EndRibs{chord(ribs.front()), chord(ribs[1]), true}
                 : EndRibs{chord(ribs.back()), chord(ribs[ribs.size() - 2]), false};
}

/// The outlines of both ends that are nearest to those found and make at most kMostPartText characters; the nearest
/// ones where none do.
void fixOutlines(const std::vector<EndOutline>& start, const std::vector<EndOutline>& end, const Alone& part,
                 document::LoftRecipe& loft) {
  struct Choice {
    const EndOutline *start, *end;
    double off() const { return std::max(start->off, end->off); }
  };
  std::vector<Choice> choices;
  for (const EndOutline& one : start) {
    for (const EndOutline& other : end) choices.push_back({&one, &other});
  }
  std::ranges::stable_sort(choices, {}, &Choice::off);
  const auto put = [&](const EndOutline& one, const EndOutline& other) {
    loft.edits.startFan = one.points;
    loft.edits.endFan = other.points;
    return part.lengthOf(loft) <= kMostPartText;
  };
  if (put(start.front(), end.front())) return;
  const bool fits = put(start.back(), end.back());
  for (auto choice = choices.begin(); fits && choice != choices.end(); ++choice) {
    if (put(*choice->start, *choice->end)) return;
  }
  put(start.front(), end.front());
}

/// Fixes what was found of a loft: its ends where they are, and the outlines beyond them.
void fixLoft(const pipeline::PartShape& shape, const Alone& part, bool shorten, document::LoftRecipe& loft) {
  const std::vector<ribs::Rib>& ribs = shape.ribs.ribs;
  // What came out of a link goes into the next one as it is.
  if (loft.edits.ends.size() == 2 * ribs.size() && part.kept(loft) == loft) return;
  const image::Size photo = part.photo.size;
  const auto with = [&](const StrokeAndSpine& line) {
    document::LoftRecipe on = loft;
    on.stroke = line.stroke;
    on.edits = fixedEnds(shape, line.spine, loft.edits);
    on.edits.startFan = on.edits.endFan = {};
    return on;
  };
  loft = part.kept(with(shortStroke({loft.stroke, shape.spine}, photo, loft.spine,
                                    [&](const StrokeAndSpine& line) { return part.lengthOf(with(line)); })));
  const Result<ribs::Spine> spine = ribs::cleanSpine(loft.stroke, photo, loft.spine);
  if (!spine || ribs.size() < 2 || loft.edits.ends.size() != 2 * ribs.size()) return;
  const ribs::Ruler ruler(spine.value().points);
  const auto outlines = [&](const ribs::EndFan& fan, bool atStart) {
    return endOutlines(fan.points, foundRibs(ribs, atStart), toldRibs(ruler, loft.edits.ends, atStart),
                       2 * io::shareStep(photo));
  };
  const std::vector<EndOutline> start = outlines(shape.ribs.startFan, true), end = outlines(shape.ribs.endFan, false);
  if (shorten) return fixOutlines(start, end, part, loft);
  loft.edits.startFan = start.front().points;
  loft.edits.endFan = end.front().points;
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
      fixLoft(*shape, {document.name, *entry, part}, copies.empty(), *loft);
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
