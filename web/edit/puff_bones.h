// The bones of a puff, which has a slice: what of them a hand can hold, and what a gesture makes of them.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/inflate/bone_edits.h"
#include "engine/pipeline/derive.h"
#include "web/ui/ui_state.h"

namespace spineloft::app {

/// A puff with its bones. All three stay alive while document and derived, or the preview, do.
struct BonedPuff {
  const document::Part* part = nullptr;
  const inflate::InflateParams* params = nullptr;
  const pipeline::PartShape* shape = nullptr;
  image::Size picture = {};
  explicit operator bool() const { return shape != nullptr; }
};
/// Empty for a part that there is not, that is no puff with a slice, or that has no shape.
BonedPuff bonedPuff(const document::Document& document, const pipeline::Derived& derived, PartId part);
BonedPuff bonedPuff(const document::Document& document, const document::Part& part, const pipeline::PartShape* shape);
/// The selected one, where the tool for bones shows it in the picture in view.
BonedPuff bonesInHand(const document::Document& document, const pipeline::Derived& derived, const UiState& ui);
/// The same as the gesture in hand would make it.
BonedPuff bonesShown(const BonedPuff& puff, const UiState& ui);

enum class BoneHold : std::uint8_t {
  Node,   ///< an end or a fork
  Knob,   ///< the thickness over a place
  Slice,  ///< the place of a slice
  Bone,
  Gone,  ///< a bone that was left out
};
std::string_view holdKey(BoneHold hold);  ///< "node", "knob", "slice", "bone", "gone"

struct BoneHandle {
  BoneHold hold = BoneHold::Node;
  PicturePoint at;                     ///< on the skeleton; of a line its middle
  PicturePoint named;                  ///< the place by which edits know it
  double half = 0;                     ///< the half width there, picture pixels
  double factor = 1;                   ///< of the thickness there
  PicturePoint across;                 ///< square to the bone, of length 1; of a slice
  std::size_t edit = 0;                ///< of a slice and of what is gone: which one
  std::optional<std::size_t> added{};  ///< of a bone: the edit that drew it
  std::vector<PicturePoint> line{};    ///< of what is a bone or gone
};
/// Nodes, knobs, slices, bones, and what is gone, in this order.
std::vector<BoneHandle> boneHandles(const BonedPuff& puff);
/// Where it is held on the canvas: a knob stands over its place, the higher the thicker; a slice is held beside it.
ClientPoint holdOnCanvas(const BoneHandle& handle, const UiState& ui);
/// The thickness of a knob that is pulled up by so many CSS pixels.
double pulledFactor(double before, double up);
/// The one under a point of the canvas; −1 elsewhere. Points come before lines.
int boneAt(const std::vector<BoneHandle>& handles, const UiState& ui, ClientPoint at, double reach, double lineReach);
/// What it is and what is done with it, in the visitor's language.
std::string boneSentence(const std::vector<BoneHandle>& handles, int handle);

/// The outline of a slice where it stands across the puff: closed lines, or open ones where a side is cut off.
std::vector<std::vector<ModelPoint>> sliceLines(const BonedPuff& puff, const BoneHandle& slice);
/// Where a slice is held in the solid view: over its bone; none behind the eye.
std::optional<ClientPoint> holdInSolid(const BonedPuff& puff, const BoneHandle& slice, const UiState& ui);
/// The slice that is held there within `reach` CSS pixels, of boneHandles; −1: none.
int sliceInSolid(const BonedPuff& puff, const UiState& ui, ClientPoint at, double reach);
/// The point of the bones that is seen nearest to a point of the solid view.
std::optional<PicturePoint> onBonesInSolid(const BonedPuff& puff, const UiState& ui, ClientPoint at);

/// A puff with one more edit, and which one that is.
struct BoneEdit {
  inflate::InflateParams params;
  std::vector<char> inflate::AwakeEdits::* kind = nullptr;
  std::size_t number = 0;
};
BoneEdit dropBone(const inflate::InflateParams& puff, PicturePoint at);
BoneEdit addBone(const inflate::InflateParams& puff, const std::vector<PicturePoint>& line);
/// The node that an earlier move brought to `from` goes on with that move.
BoneEdit moveBone(const inflate::InflateParams& puff, PicturePoint from, PicturePoint to);
/// In place of the factor at the same place.
BoneEdit raiseBone(const inflate::InflateParams& puff, PicturePoint at, double factor);
/// A slice, one of those there are, to another place.
BoneEdit moveSlice(const inflate::InflateParams& puff, std::size_t slice, PicturePoint to);
/// What `puff` has at places it keeps; elsewhere it becomes `next`. Soft is soft everywhere.
inflate::ProfileParams withBase(const inflate::ProfileParams& puff, const inflate::ProfileParams& next);
/// The slice whose place is chosen, else the one that is everywhere.
std::size_t pickedSlice(const BonedPuff& puff, const UiState& ui);
/// What a drag of a handle from one place of the picture to another makes; none of lines.
std::optional<BoneEdit> dragged(const BonedPuff& puff, const BoneHandle& handle, PicturePoint from, PicturePoint to,
                                double zoom);
/// Whether the edit finds its place in the outlines of the shape.
bool findsPlace(const pipeline::PartShape& shape, const BoneEdit& edit);

/// The point of the skeleton nearest to `p`; none without bones.
std::optional<PicturePoint> onBones(const pipeline::PartShape& shape, PicturePoint p);

}  // namespace spineloft::app
