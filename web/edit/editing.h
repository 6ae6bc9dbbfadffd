// What tools preview and commands do about the ribs and the spine of a part: the same functions, so
// that what is seen before the pen goes up is what comes of it.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "engine/document/action.h"
#include "engine/document/document.h"
#include "engine/pipeline/derive.h"
#include "engine/ribs/edit/edit_gestures.h"

namespace spineloft::app {

/// A lofted part with its shape. Both stay alive while document and derived do.
struct Subject {
  const document::Part* part = nullptr;
  const pipeline::PartShape* shape = nullptr;  ///< null only with `part`
  explicit operator bool() const { return shape != nullptr; }
};
/// Empty for a part that there is not, that has no shape (yet), or that is no loft.
Subject subjectOf(const document::Document& document, const pipeline::Derived& derived, PartId id);

/// Its ribs as seen, for the gestures of engine/ribs. The subject must not be empty.
ribs::EditScene sceneOf(const Subject& subject);
PicturePoint endPoint(const ribs::Rib& rib, ribs::Side side);
ribs::RibState endState(const ribs::Rib& rib, ribs::Side side);
const ribs::OtherPlaces& otherPlaces(const ribs::Rib& rib, ribs::Side side);
/// "Rib 12 of 60, left end, on an edge, 34 pixels from the spine".
std::string ribSentence(const ribs::RibSet& set, ribs::EndRef end);

/// The line that gestures on the spine change, picture pixels: where the part stands.
std::vector<PicturePoint> spineLine(const Subject& subject);
/// The recipe with another spine: with `keepRibs` the part is posed on it, else its ribs are looked
/// for along it.
void putSpine(document::LoftRecipe& recipe, std::vector<PicturePoint> line, bool keepRibs);
/// The same as actions on the document.
std::vector<document::Action> spineActions(const document::Part& part, std::vector<PicturePoint> line, bool keepRibs);

/// Places of the handles along the spine, shares of its length: first and last are the ends.
inline constexpr int kSpineHandles = 7;
double handlePlace(int handle);
/// Where the handles are in the picture.
std::vector<PicturePoint> spineHandles(const Subject& subject);
/// A spine with the handle moved: bent, or at an end drawn out or cut back.
std::vector<PicturePoint> moveHandle(std::span<const PicturePoint> line, int handle, PicturePoint to, double reach);

/// The depth with `by` more at `at`, fading out within `reach` (share of the length).
geometry::AlongCurve raiseDepth(const geometry::AlongCurve& depth, double at, double by, double reach);
/// Where the handles of the depth stand: places as those of the spine, on the posed spine.
std::vector<ModelPoint> depthHandles(const Subject& subject);
/// A depth from the pressure of a pen at the points of its stroke, in place of what `depth` held: half
/// pressure is the picture's plane, more comes nearer. Empty when the pressure never changed.
void depthOfPressure(std::span<const PicturePoint> stroke, std::span<const double> pressure,
                     geometry::AlongCurve& depth);

/// Scribbles that count for a part: its own first, then those of its picture.
struct Marks {
  std::span<const ribs::IgnoreMark> part, picture;
  int count() const { return static_cast<int>(part.size() + picture.size()); }
  const ribs::IgnoreMark& at(int index) const {
    const auto i = static_cast<std::size_t>(index);
    return i < part.size() ? part[i] : picture[i - part.size()];
  }
};
Marks marksOf(const document::Document& document, PictureId picture, PartId part);
/// The scribble under a point, the last one first; −1 elsewhere.
int markAt(const Marks& marks, PicturePoint p, double reach);

/// How the ends of a part are finished, where it has ends: a loft, or layers on a rail that is open or on none.
struct EndCaps {
  sections::CapStyle start = sections::CapStyle::Flat, end = sections::CapStyle::Flat;
};
std::optional<EndCaps> capsOf(const document::Part& part);

}  // namespace spineloft::app
