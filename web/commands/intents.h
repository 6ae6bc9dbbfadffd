// What tools, panels and answered questions ask for: a typed function for each command that they call with arguments.
// The rows of the command table read the same arguments from JSON and end here.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "engine/document/action.h"
#include "engine/sections/drawing.h"
#include "engine/vision/cut_out.h"
#include "web/commands/commands.h"
#include "web/edit/placing.h"
#include "web/edit/puff_bones.h"
#include "web/edit/shaping.h"

namespace spineloft::app {

using Colour = std::array<std::uint8_t, 3>;

// ---- Parts. Where a part is asked for, none means what the next part is made with. -------------------------------

/// A new part along a line in the picture in view. What is none is as the panels show it.
struct DrawSpineIntent {
  std::vector<PicturePoint> stroke;
  geometry::AlongCurve depth = {};
  bool cut = false;  ///< the first part of all ends where the thing ends
  bool lie = false;  ///< what other parts would hide comes to lie on them
  std::optional<sections::SectionShape> section = {};
  std::optional<sections::CapStyle> startCap = {}, endCap = {};
};
Outcome drawSpine(const CommandEnv& env, const DrawSpineIntent& intent);
Outcome redrawSpine(const CommandEnv& env, PartId part, const std::vector<PicturePoint>& stroke);
/// None: lets go of all. `add`: besides what is in hand.
Outcome selectPart(const CommandEnv& env, PartId part, bool add);
Outcome deletePart(const CommandEnv& env, PartId part);
Outcome askPartName(const CommandEnv& env, PartId part);
/// The part, or the solid that it is in.
Outcome showPart(const CommandEnv& env, PartId part, bool visible);
// Settings are for all of `parts` that they fit, in one step; for none of them: the next part is made so.
using Parts = std::vector<PartId>;
/// A cap that is none stays as it is.
Outcome setCaps(const CommandEnv& env, const Parts& parts, std::optional<sections::CapStyle> start,
                std::optional<sections::CapStyle> end);
Outcome setTextured(const CommandEnv& env, const Parts& parts, bool textured);
Outcome setColour(const CommandEnv& env, const Parts& parts, const Colour& colour);
Outcome setSecondColour(const CommandEnv& env, const Parts& parts, const Colour& colour);
Outcome setPaint(const CommandEnv& env, const Parts& parts, surface::Paint paint);
Outcome setFaceted(const CommandEnv& env, const Parts& parts, bool faceted);
Outcome setInked(const CommandEnv& env, const Parts& parts, bool inked);
Outcome setParameter(const CommandEnv& env, const Parts& parts, const std::string& key, double value);

// ---- Spines. `keep`: the ribs go along; else edges are found again. ----------------------------------------------

struct BendSpineIntent {
  PartId part;
  int handle = 0;
  PicturePoint to;
  double reach = 0;  ///< share of the spine whose points follow, 0…1
  bool keep = false;
};
Outcome bendSpine(const CommandEnv& env, const BendSpineIntent& intent);
Outcome moveSpine(const CommandEnv& env, PartId part, PicturePoint by, bool keep);
/// The same ribs along another line.
Outcome poseAlong(const CommandEnv& env, PartId part, const std::vector<PicturePoint>& stroke);
Outcome setDepth(const CommandEnv& env, PartId part, const geometry::AlongCurve& depth);
Outcome setCoil(const CommandEnv& env, PartId part, double turns, double radius);
Outcome chooseHandle(const CommandEnv& env, int handle);

// ---- Ribs --------------------------------------------------------------------------------------------------------

Outcome chooseRib(const CommandEnv& env, PartId part, ribs::EndRef end);
Outcome moveRibEnd(const CommandEnv& env, PartId part, ribs::EndRef end, PicturePoint to, double reach);
/// Another place of an end; ends near by take the like one.
Outcome takePlace(const CommandEnv& env, PartId part, ribs::EndRef end, int place);
struct ShapeRibsIntent {
  PartId part;
  std::vector<PicturePoint> stroke;
  double within = 0;  ///< picture pixels that an end may go to meet the line
  bool both = false;  ///< the other side changes as well
};
Outcome shapeRibs(const CommandEnv& env, const ShapeRibsIntent& intent);
Outcome ignoreForPart(const CommandEnv& env, PartId part, const ribs::IgnoreMark& mark);
Outcome ignoreForPicture(const CommandEnv& env, PictureId picture, const ribs::IgnoreMark& mark);
/// A scribble by its number in marksOf.
Outcome removeIgnored(const CommandEnv& env, std::size_t mark);

// ---- Parts made of regions ---------------------------------------------------------------------------------------

/// `lie` as of DrawSpineIntent.
Outcome drawRegion(const CommandEnv& env, const document::Region& region, const document::RegionSolid& solid, bool lie);
Outcome redrawRegion(const CommandEnv& env, PartId part, const document::Region& region);
/// What stands over the puffs among the parts; for none of them: over the next one.
Outcome setProfile(const CommandEnv& env, const Parts& parts, const inflate::ProfileParams& profile);
/// Of a puff with a slice: the one that it has at a place, new or in place of that there.
Outcome setSliceAt(const CommandEnv& env, PartId part, PicturePoint at, const sections::SectionShape& shape);
/// Another shape for one of its slices.
Outcome setPuffSlice(const CommandEnv& env, PartId part, std::size_t slice, const sections::SectionShape& shape);
/// Its bones and the places of its slices; only edits that find their place come here.
Outcome setBones(const CommandEnv& env, PartId part, const inflate::InflateParams& params);
/// By its number in boneHandles: a bone is left out or taken back, a knob or a slice taken away.
Outcome toggleBone(const CommandEnv& env, PartId part, int handle);
/// A handle to a place of the picture, a knob to a thickness.
Outcome dragBone(const CommandEnv& env, PartId part, const BoneHandle& handle, PicturePoint to);
Outcome setThickness(const CommandEnv& env, PartId part, const BoneHandle& handle, double factor);
Outcome chooseBone(const CommandEnv& env, int handle);
/// Says why a drag came to nothing: of a point, or of a new bone.
Outcome refuseBone(const CommandEnv& env, bool point);
Outcome moveOutlinePoint(const CommandEnv& env, PartId part, OutlinePoint at, PicturePoint to);
/// The axis of a spun part, or of the next one. Picture pixels.
Outcome setAxis(const CommandEnv& env, PartId part, PicturePoint from, PicturePoint to);
/// Cuts a thing out of the picture in view, shown before it is used. `part` receives its outline; none: a new part.
Outcome startCutOut(const CommandEnv& env, const vision::CutHints& hints, PartId part);
/// Corrects what is being cut out.
Outcome markCutOut(const CommandEnv& env, const std::vector<PicturePoint>& line, double radius);

// ---- Pulls -------------------------------------------------------------------------------------------------------

/// A pull along a line on the surface of a part, ModelSpace, as the tool is set; it is chosen.
Outcome drawPull(const CommandEnv& env, PartId part, const std::vector<ModelPoint>& line);
/// A bump within a ring on the surface of a part, ModelSpace, with its top where the ring is widest; it is chosen.
Outcome drawBump(const CommandEnv& env, PartId part, const std::vector<ModelPoint>& ring);
/// The stretch of its visible outline beside a stroke, CSS pixels of the canvas, goes to the stroke; its ends are
/// within `reach` of the outline.
Outcome redrawSeenOutline(const CommandEnv& env, PartId part, const std::vector<ClientPoint>& stroke, double reach);
/// Another value for one of its pulls; says where it cannot go all the way.
Outcome setPull(const CommandEnv& env, PartId part, std::size_t number, const pull::Pull& pull);

// ---- Reliefs ----------------------------------------------------------------------------------------------------

/// What becomes a relief, in words.
std::string_view labelOf(relief::Mode mode);
/// A part and the relief that it is to have; none: without.
struct ReliefOf {
  PartId part;
  std::optional<relief::Relief> relief;
};
/// In one step.
Outcome setReliefs(const CommandEnv& env, const std::vector<ReliefOf>& reliefs);
/// A picture that is laid on a part in its middle, half as wide as it.
relief::Laid usualLaid(const CommandEnv& env, const document::Part& part, PictureId picture);

// ---- Bridges ----------------------------------------------------------------------------------------------------

/// A new bridge, in one solid with the parts that it joins.
Outcome drawBridge(const CommandEnv& env, const document::BridgeRecipe& recipe);
/// A drag that makes no bridge, because it begins on another one or ends beside the parts: says what to do. `from`: the
/// part that it begins on.
Outcome refuseBridge(const CommandEnv& env, PartId from);
/// An end of a bridge at another place, 0 or 1.
Outcome moveBridgeEnd(const CommandEnv& env, PartId part, int end, const document::BridgeEnd& to);

// ---- Shapes ------------------------------------------------------------------------------------------------------

/// A new one. `lie` as of DrawSpineIntent.
Outcome drawShape(const CommandEnv& env, const document::ShapeRecipe& recipe, bool lie);
/// Other measures, and outlines that go with them.
Outcome reshape(const CommandEnv& env, PartId part, const document::ShapeRecipe& recipe);
/// A line drawn at its outline in the picture in view (see web/edit/shaping.h); of a loft or a puff its side outline.
Outcome drawShapeLine(const CommandEnv& env, PartId part, const std::vector<PicturePoint>& line);
/// A handle to a place of the picture in view.
Outcome dragShape(const CommandEnv& env, PartId part, ShapeHold hold, PicturePoint to);
Outcome chooseShapeHandle(const CommandEnv& env, int handle);
/// What the thing at a place becomes: the outline of `part` in the picture in view; none: a new shape.
Outcome fitShape(const CommandEnv& env, PicturePoint at, PartId part);
/// The primitive of the next shape; a shape in hand is let go of.
Outcome choosePrimitive(const CommandEnv& env, shape::Primitive primitive);
/// The primitive of these shapes.
Outcome setPrimitive(const CommandEnv& env, const Parts& parts, shape::Primitive primitive);
/// The picture shows from there what the picture of the selected shape, or the first other one, shows from the front.
/// None: it is no side of another one any more.
Outcome setSidePicture(const CommandEnv& env, PictureId picture, std::optional<geometry::ViewFrom> from);

// ---- Line drawings -----------------------------------------------------------------------------------------------

/// One more line on a picture; what it closes becomes a piece, which is taken in hand.
struct DrawLineIntent {
  PictureId picture;
  std::vector<PicturePoint> points;
  std::vector<descriptive::Stretch> hidden = {};
  bool closed = false;
  std::vector<LineId> replaces = {};  ///< lines of its drawing that go
};
Outcome drawLine(const CommandEnv& env, const DrawLineIntent& intent);
/// From a loose end of the line, the one at `end` where that is stated, to the nearest end: its own other one, which
/// closes the line, or that of another line.
Outcome closeLine(const CommandEnv& env, DrawingId drawing, LineId line, std::optional<PicturePoint> end);
/// Of crossingsOn the picture in view: who is behind comes to the front there.
Outcome swapCrossing(const CommandEnv& env, int crossing);
Outcome chooseCrossing(const CommandEnv& env, int crossing);
/// From where right angles of the drawings of these pieces are seen.
Outcome seeFrom(const CommandEnv& env, const Parts& parts, descriptive::SeenFrom from);
/// The depth of a place of a line; without one it is free again.
Outcome pinDepth(const CommandEnv& env, const document::PinDepth& pin);
/// What the pieces among the parts are made of their outlines.
Outcome shapePieces(const CommandEnv& env, const Parts& parts, descriptive::PieceKind kind);

// ---- Layers ------------------------------------------------------------------------------------------------------

/// Closed curves on the sheet at a place of a part made of layers, or, without one, of a new part on the picture in
/// view: see web/edit/layers.h.
struct DrawLayerIntent {
  PartId part;
  double at = 0;
  std::vector<stack::Curve> curves;
};
Outcome drawLayer(const CommandEnv& env, const DrawLayerIntent& intent);
/// The same of a freehand line.
Outcome drawOnSheet(const CommandEnv& env, PartId part, double at, const std::vector<SectionPoint>& line);
/// The camera moves where the sheet is seen too flat to draw on, or is out of sight or behind bars.
Outcome seeSheet(const CommandEnv& env);
/// The sheet that is seen to a place.
Outcome moveSheet(const CommandEnv& env, double at);
/// The sheet, with the layer on it, with this turn from how it would stand on the rail.
Outcome leanSheet(const CommandEnv& env, const geometry::Turn& turn);
/// The next line in the solid view is the rail of the part; pressed once more: no longer.
Outcome drawRail(const CommandEnv& env, PartId part);
/// The rail goes through the middles of the part's layers.
Outcome followMiddles(const CommandEnv& env, PartId part);
/// The rail that was drawn for the part.
Outcome followRail(const CommandEnv& env, PartId part, const Result<stack::Rail>& rail);
/// The part has this recipe now, of the same layers.
Outcome remakeLayers(const CommandEnv& env, PartId part, const document::StackRecipe& recipe);
/// The layer on the sheet that is seen to another place of the rail.
Outcome moveLayer(const CommandEnv& env, double at);

// ---- Paper and pictures ------------------------------------------------------------------------------------------

Outcome drawOnSketch(const CommandEnv& env, const image::SketchStroke& stroke);
Outcome setPenSize(const CommandEnv& env, std::size_t size);  ///< of kPenSizes
Outcome setPenColour(const CommandEnv& env, const Colour& colour);
Outcome selectPicture(const CommandEnv& env, PictureId picture);
Outcome askPictureName(const CommandEnv& env, PictureId picture);
Outcome removePicture(const CommandEnv& env, PictureId picture);

// ---- Sections along a spine; `key` counts those of the part ------------------------------------------------------

/// All sections of the parts become `shape`, or the one of `key` of the only part; of the next part without one.
Outcome setSection(const CommandEnv& env, const Parts& parts, std::optional<std::size_t> key,
                   const sections::SectionShape& shape);
/// At a share of the spine; without a shape the one that is picked.
Outcome addSection(const CommandEnv& env, PartId part, double at, const std::optional<sections::SectionShape>& shape);
Outcome moveSection(const CommandEnv& env, PartId part, std::size_t key, double to);
Outcome removeSection(const CommandEnv& env, PartId part, std::size_t key);
Outcome selectSection(const CommandEnv& env, PartId part, std::size_t key);
Outcome setBlend(const CommandEnv& env, PartId part, std::size_t key, const sections::Blend& blend);
/// Values in the unit that is shown (AlongInfo::unit).
Outcome setAlong(const CommandEnv& env, const Parts& parts, document::AlongKind kind,
                 const geometry::AlongCurve& shown);
Outcome showAlong(const CommandEnv& env, document::AlongKind kind);
Outcome askSectionName(const CommandEnv& env, std::uint32_t shelfId);
Outcome deleteSection(const CommandEnv& env, std::uint32_t shelfId);

// ---- The board on which a section is drawn: refused while it is closed -------------------------------------------

Outcome useBoardTool(const CommandEnv& env, BoardTool tool);
struct BoardStroke {
  enum class Kind : std::uint8_t { Freehand, Outline, Corners, Box, Ellipse } kind = Kind::Freehand;
  std::vector<SectionPoint> points;  ///< of a box and an ellipse: two corners
};
Outcome drawOnBoard(const CommandEnv& env, const BoardStroke& stroke);
Outcome startBoardFrom(const CommandEnv& env, const sections::SectionShape& shape);
Outcome startBoardFromTrace(const CommandEnv& env, std::size_t trace);
Outcome moveBoardPoint(const CommandEnv& env, sections::PointRef point, SectionPoint to);
/// A point after another one at `at`, and from there pulled to `to`.
Outcome addBoardPoint(const CommandEnv& env, sections::PointRef after, SectionPoint at, std::optional<SectionPoint> to);
Outcome removeBoardPoint(const CommandEnv& env, sections::PointRef point);

// ---- Where parts stand -------------------------------------------------------------------------------------------

Outcome moveParts(const CommandEnv& env, const std::vector<PartId>& parts, const document::Motion& motion);
/// Asks for one of the selected part's numbers: "x" … as of placeNumber.
Outcome askPlace(const CommandEnv& env, const std::string& field);
/// Of the parts in hand.
Outcome setSymmetry(const CommandEnv& env, const MirrorAxis* axis);
Outcome askGroupName(const CommandEnv& env, GroupId group);
Outcome ungroup(const CommandEnv& env, GroupId group);
/// None: to the end.
Outcome moveInList(const CommandEnv& env, const std::vector<PartId>& parts, PartId before);

// ---- Solids made of parts ----------------------------------------------------------------------------------------

/// Ticks or unticks for the next solid.
Outcome pick(const CommandEnv& env, const document::Operand& operand, bool on);
Outcome selectStep(const CommandEnv& env, StepId step);
Outcome setStep(const CommandEnv& env, const document::SetStep& action);
/// The side of a hollow solid that looks this way opens.
Outcome openTowards(const CommandEnv& env, StepId step, WorldPoint way);
/// A tap on this part while *Scoop out* shows what it would do: it opens at the side that looks this way, or, of
/// something else, that becomes hollow instead.
Outcome tapHollow(const CommandEnv& env, PartId part, WorldPoint way);
/// Where what is shown would open.
Outcome openHollow(const CommandEnv& env, document::OpeningSide side);
Outcome showStep(const CommandEnv& env, StepId step, bool visible);
Outcome foldStep(const CommandEnv& env, StepId step);
Outcome askStepName(const CommandEnv& env, StepId step);
/// Takes the part at fault in hand and looks at the place.
Outcome showFailure(const CommandEnv& env, StepId step);

// ---- Size --------------------------------------------------------------------------------------------------------

Outcome setHeight(const CommandEnv& env, double mm);
Outcome sizeLike(const CommandEnv& env, std::size_t thing);                          ///< of things()
Outcome showBeside(const CommandEnv& env, const std::optional<std::size_t>& thing);  ///< of things()

}  // namespace spineloft::app
